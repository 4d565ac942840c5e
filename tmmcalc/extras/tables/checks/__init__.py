"""Checks of the tables of the extras room that reach beyond one value."""
