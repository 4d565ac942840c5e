"""Checks of the tables of the cam room that reach beyond one value."""
