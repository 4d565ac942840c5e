"""Profiles of disk cams: pitch curve, walls, tool paths, and whether they can be made."""

from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.profile.solve import solve_profile

__all__ = ["Profile", "solve_profile"]
