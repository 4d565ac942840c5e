"""The stages of the vibration room, one module each."""
