"""The stages of the extras room, one module each."""
