"""The stages of the manipulator room, one module each."""
