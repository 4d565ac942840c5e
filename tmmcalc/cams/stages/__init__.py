"""The stages of the cam room, one module each."""
