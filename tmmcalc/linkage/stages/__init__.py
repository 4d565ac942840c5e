"""The stages of the linkage room, one module each."""
