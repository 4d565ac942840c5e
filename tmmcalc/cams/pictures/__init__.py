"""The pictures of the cam stages."""
