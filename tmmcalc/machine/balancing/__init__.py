"""Balancing of engines with several cranks and of rotors, and the sizes of balance weights."""
