"""Checks of the tables of the vibration room that reach beyond one value."""
