"""The worked cases of gear trains, and tooth sets to put into them."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from tmmcalc.gears.exact import around
from tmmcalc.gears.model import Limits, ToothSets, TrainTask, Values
from tmmcalc.gears.scheme import layout_of

CASES: dict[str, Any] = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[2] / "cases" / "gear-trains.json").read_text())
    if case["verified"]
}

TEETH = {  # trains that close, one or two of each layout
    "unfolded2": [[17, 60, 17, 39], [19, 67, 18, 44]],
    "unfolded3": [[17, 70, 18, 60, 19, 41], [18, 66, 18, 54, 18, 40]],
    "coaxial": [[26, 73, 17, 49], [17, 64, 17, 37]],
    "AIbar": [[18, 48, 114], [22, 59, 140]],
    "AI": [[22, 118, 17, 97], [25, 136, 20, 112]],
    "AA": [[17, 64, 17, 37], [20, 70, 18, 42]],
    "II": [[90, 30, 40, 100], [100, 31, 41, 110]],
    "AII": [[20, 40, 30, 100, 90], [18, 48, 34, 114, 100]],
    "2A-AA": [[18, 27, 27, 72], [20, 22, 30, 64]],
}


def sets(layout: str, teeth: Sequence[Sequence[int]], planets: int = 1) -> ToothSets:
    scheme, n = layout_of(layout), len(teeth)
    angles = np.full((n, len(scheme.meshes)), math.radians(20))
    numbers = np.array(teeth, np.int64).reshape(n, len(scheme.wheels))
    return ToothSets(layout, numbers, np.ones((n, scheme.stages), np.int64), angles, planets)


def lengths(train: ToothSets, *values: float) -> Values:
    """One length [m] a stage, the same for all trains."""
    return np.tile(np.array(values[: train.scheme.stages], float), (len(train), 1))


def task(
    layout: str,
    ratio: str,
    tolerance: str,
    *proportions: tuple[int, ...],
    planets: int = 1,
    relative: bool = False,
    limits: Limits | None = None,
) -> TrainTask:
    nominal = Fraction(ratio)
    admitted = around(nominal, Fraction(tolerance), relative=relative)
    return TrainTask(layout, nominal, admitted, proportions or ((1, 1),), planets, limits or Limits())
