"""Formats of paper (ISO 216, GOST 2.301), landscape, and what frames are known, by their names in specs and flags."""

from __future__ import annotations

FORMATS = {"a1": (841.0, 594.0), "a2": (594.0, 420.0), "a3": (420.0, 297.0)}  # [mm]
FRAMES = ("gost", "iso", "none")
