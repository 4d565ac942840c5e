"""Mistakes that may be made in any subject, a module each: see `tmmcalc.core.mistake`."""
