"""Pairs of gears of a project: geometry, checks and measures, blocking contours, tooth profiles; lengths in metres."""
