"""Mistakes of the room, a module each: see `tmmcalc.core.mistake`."""
