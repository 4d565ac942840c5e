"""The pictures of the vibration stages."""
