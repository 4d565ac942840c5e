"""The pictures of the machine stages."""
