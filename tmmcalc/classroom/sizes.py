"""Which results are radii and which diameters, by what they mean."""

from __future__ import annotations

import re

from tmmcalc.core.stage import STAGES
from tmmcalc.naming.language import ANY, parse
from tmmcalc.naming.meanings import described

RADIUS = re.compile(r"\bradi(?:us|i)\b")
DIAMETER = re.compile(r"\bdiameters?\b")


def is_radius(name: str) -> bool:
    """Whether the result of this name is a radius."""
    return RADIUS.search(_meaning(name)) is not None


def is_diameter(name: str) -> bool:
    """Whether the result of this name is a diameter."""
    return DIAMETER.search(_meaning(name)) is not None


def _meaning(name: str) -> str:
    asked = parse(name)
    if asked.stage not in STAGES:
        return ""
    found = described(asked.stage, column=not asked.fact)(asked.what, ANY)
    return str(found[0])
