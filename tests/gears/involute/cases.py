"""The worked cases of the involute pair."""

from __future__ import annotations

import json
from math import radians
from pathlib import Path
from typing import Any

from tmmcalc.gears.involute.wheel import Wheel

_ALL = json.loads((Path(__file__).parents[2] / "cases" / "involute-geometry.json").read_text())


def case(name: str) -> Any:
    return next(each for each in _ALL if each["id"] == name)


def wheel(z: int, x: Any = 0.0, beta_deg: float = 0.0) -> Wheel:
    return Wheel(z, x, radians(beta_deg))
