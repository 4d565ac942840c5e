"""Checks of the tables beyond single values, by key."""
