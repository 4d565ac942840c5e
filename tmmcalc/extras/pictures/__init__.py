"""The pictures of the extras stages."""
