"""Pairs for the tests of the blocking contour, and the worked cases."""

from __future__ import annotations

import json
from math import radians
from pathlib import Path
from typing import Any

import numpy as np

from tmmcalc.gears.involute.contour.task import Task
from tmmcalc.gears.involute.rack import RACKS, Rack
from tmmcalc.gears.involute.wheel import Wheel

CASES = Path(__file__).parents[3] / "cases" / "involute-geometry.json"


def case(name: str) -> dict[str, Any]:
    return next(c for c in json.loads(CASES.read_text()) if c["id"] == name)


def task(z1: int, z2: int, ratio: float = 1.0, tip: float = 0.0, helix: float = 0.0, rack: Rack = RACKS["GOST 13755"]):
    beta = radians(helix)
    return Task(Wheel(z1, 0.0, beta, rack), Wheel(z2, 0.0, beta, rack), ratio, (tip, tip))


def random_tasks(count: int, seed: int = 7):
    rng = np.random.default_rng(seed)
    racks = list(RACKS)
    for _ in range(count):
        z1, z2 = (int(z) for z in np.exp(rng.uniform(np.log(5), np.log(300), 2)))
        ratio, tip = float(rng.choice([1.0, 1.2])), float(rng.choice([0.0, 0.25, 0.4]))
        yield task(z1, z2, ratio, tip, float(rng.choice([0, 10, 25, 40])), RACKS[str(rng.choice(racks))])


PAIRS = [task(14, 17), task(14, 17, 1.1, 0.4, 15), task(20, 60, 1.2, 0.25, 25), task(100, 150), task(9, 80, 1.0, 0.2)]
