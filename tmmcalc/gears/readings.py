"""Names of results that stand beside one another: what is read off in place of what is asked for."""

from __future__ import annotations

import re

from tmmcalc.core.mistake import Asked
from tmmcalc.naming.language import parse

WHEEL = re.compile(r"(.*\bwheels\.)([01])(\..+)")
NUMBERED = re.compile(r"(.*_)([12])")


def other_wheel(name: str) -> str:
    """The same of the other wheel of a pair; empty for what is of no wheel.

    >>> import tmmcalc.rooms
    >>> other_wheel("pair.1.wheels.0.r_b"), other_wheel("pair.x_2"), other_wheel("pair.a_w")
    ('pair.1.wheels.1.r_b', 'pair.x_1', '')
    """
    asked = parse(name)
    if asked.stage != "pair":
        return ""
    if found := WHEEL.fullmatch(asked.what):
        return asked._replace(what=f"{found[1]}{1 - int(found[2])}{found[3]}").text
    found = NUMBERED.fullmatch(asked.what)
    return asked._replace(what=f"{found[1]}{3 - int(found[2])}").text if found else ""


def wheel_value(asked: Asked, word: str) -> float:
    """A value in SI beside the one that is asked for: of its wheel, or else of its pair."""
    name = parse(asked.name)
    head, dot, _ = name.what.rpartition(".")
    pair = head.partition(".wheels")[0]
    for place in (f"{head}{dot}{word}", f"{pair}{dot}{word}"):
        value = asked.another(name._replace(what=place).text) / asked.scale
        if value == value:
            return value
    return value
