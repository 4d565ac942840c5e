"""Checks of the table of sheets that reach beyond one value."""
