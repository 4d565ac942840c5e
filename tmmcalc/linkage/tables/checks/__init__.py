"""Checks of the tables of the linkage room that reach beyond one value."""
