"""Checks of the tables of the gear room that reach beyond one value."""
