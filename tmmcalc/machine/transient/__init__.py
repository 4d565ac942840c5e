"""Transient motion: start-up, braking, run-down and load change of one mass or of a chain of masses, in time."""
