"""Gears: trains and their tooth numbers, strength, criteria of choice."""
