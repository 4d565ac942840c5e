"""The stages of the machine room, one module each."""
