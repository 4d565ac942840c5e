"""Checks of the tables of the feasibility room that reach beyond one value."""
