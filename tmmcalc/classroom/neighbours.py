"""Positions beside the one that a name asks for."""

from __future__ import annotations

from tmmcalc.naming.language import parse


def neighbour(name: str, by: int) -> str:
    """The same result some positions further; empty where the name has no numbered position.

    >>> import tmmcalc.rooms
    >>> neighbour("kinematics.vS_D@3", -1), neighbour("motion.delta", 1)
    ('kinematics.vS_D@2', '')
    """
    asked = parse(name)
    place = asked.place
    if place is None or place.column or place.last or not place.first.isdecimal() or int(place.first) + by < 0:
        return ""
    return asked._replace(place=place._replace(first=str(int(place.first) + by))).text
