"""Names of results that stand beside one another: another quantity in the same place."""

from __future__ import annotations

from collections.abc import Mapping

from tmmcalc.naming.language import parse


def in_place(name: str, others: Mapping[str, str]) -> str:
    """The name with another quantity for its last word; empty where there is none for it.

    >>> import tmmcalc.rooms
    >>> in_place("pair.1.wheels.0.r_b", {"r_b": "r"}), in_place("cam_law.v@3", {"v": "S1"}), in_place("pair.a", {})
    ('pair.1.wheels.0.r', 'cam_law.S1@3', '')
    """
    asked = parse(name)
    head, dot, word = asked.what.rpartition(".")
    return asked._replace(what=f"{head}{dot}{others[word]}").text if word in others else ""
