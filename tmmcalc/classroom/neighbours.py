"""Positions beside the one that a name asks for."""

from __future__ import annotations

from tmmcalc.naming.language import parse

MACHINES = ("linkage", "machine")  # rooms whose positions are those of the input link, and senses those of the plane
NAMED = ("gearing",)  # stages whose rows are members, called 1 and 2 it may be


def neighbour(name: str, by: int) -> str:
    """The same result some positions further; empty where the name has no numbered position.

    >>> import tmmcalc.rooms
    >>> neighbour("kinematics.vS_D@3", -1), neighbour("motion.delta", 1), neighbour("gearing.omega@2", 1)
    ('kinematics.vS_D@2', '', '')
    """
    asked = parse(name)
    place = asked.place
    if (
        place is None
        or asked.stage in NAMED
        or place.column
        or place.last
        or not place.first.isdecimal()
        or int(place.first) + by < 0
    ):
        return ""
    return asked._replace(place=place._replace(first=str(int(place.first) + by))).text
