"""Checks of the tables of the machine room that reach beyond one value."""
