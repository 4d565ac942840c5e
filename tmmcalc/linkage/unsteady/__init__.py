"""Unsteady motion: a mechanism whose input goes from rest to rest by the time-optimal law (textbook 2.10)."""
