"""Checks of the tables of the manipulator room that reach beyond one value."""
