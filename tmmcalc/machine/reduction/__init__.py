"""Reduction of forces and masses to the input link: what the machine room takes for the whole linkage."""
