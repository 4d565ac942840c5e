"""The stages of the gear room, one module each."""
