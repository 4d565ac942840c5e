"""The documents of the cam stages."""
