"""Trains and tasks of the tests."""

from __future__ import annotations

import json
from math import gcd
from pathlib import Path
from typing import Any

import numpy as np

from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.scheme import layout_of
from tmmcalc.gears.strength.material import Material, parse_hardness
from tmmcalc.gears.strength.task import StageTask, StrengthTask

MPA, MM = 1e6, 1e-3
CASES: dict[str, Any] = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[2] / "cases" / "gear-trains.json").read_text(encoding="utf-8"))
}

# One train of each layout that can be assembled with its modules: teeth, m1 : m2.
TRAINS: dict[str, tuple[list[int], list[int]]] = {
    "unfolded2": ([18, 63, 18, 42], [1, 1]),
    "unfolded3": ([17, 60, 18, 55, 19, 40], [1, 1, 1]),
    "coaxial": ([26, 73, 17, 49], [2, 3]),
    "AIbar": ([18, 48, 114], [1]),
    "AI": ([25, 136, 20, 112], [4, 7]),
    "AA": ([20, 40, 22, 38], [1, 1]),
    "II": ([80, 30, 25, 75], [1, 1]),
    "AII": ([20, 30, 28, 80, 78], [1, 1]),
    "2A-AA": ([20, 30, 24, 80], [1]),
}


def sets_of(layout: str, teeth: Any = None, proportion: Any = None, planets: int = 1) -> ToothSets:
    usual, ratio = TRAINS[layout]
    rows = np.atleast_2d(np.array(usual if teeth is None else teeth))
    modules = np.tile(np.array(ratio if proportion is None else proportion), (len(rows), 1))
    scheme = layout_of(layout)
    return ToothSets(layout, rows, modules, np.full((len(rows), len(scheme.meshes)), np.radians(20)), planets)


def steel_40kh(hardness: str = "300 HB", load: str | None = "one-sided", **others: Any) -> Material:
    return Material("improved", parse_hardness(hardness), "40Kh", load=load, **others)


def task_of(
    torque: float = 75.0, psi: float | None = 0.6, load: str | None = "one-sided", **rules: Any
) -> StrengthTask:
    return StrengthTask(torque, (StageTask(steel_40kh(load=load), psi_bd=psi),), **rules)


def stage_with(A_H: float, A_F: float, torque: float, planets: int, psi: float, row: int = 1) -> StageTask:
    """A stage whose permissible stresses give the coefficients A_H and A_F [mm] of (4.40)."""
    beta = {1: (0.50, 1.08), 3: (0.16, 0.31), 5: (0.07, 0.16)}[row]
    share = torque / (planets * psi)
    contact = np.sqrt(share * (1 + beta[0] * psi)) * (770 / A_H) ** 1.5
    bending = share * (1 + beta[1] * psi) * (14 / A_F) ** 3
    return StageTask(psi_bd=psi, row=row, permissible_contact=contact * MPA, permissible_bending=bending * MPA)


def random_sets(layout: str, count: int, seed: int = 0) -> ToothSets:
    """Tooth numbers at random: rings are larger than the wheels in them."""
    scheme = LAYOUTS[layout]
    rng = np.random.default_rng(seed)
    teeth = rng.integers(17, 120, (count, len(scheme.wheels)))
    for ring in scheme.rings:
        teeth[:, scheme.index(ring)] += 130
    modules = rng.integers(1, 8, (count, scheme.stages))
    divisor = np.array([gcd(*map(int, row)) for row in modules])
    return ToothSets(layout, teeth, modules // divisor[:, None], np.zeros((count, len(scheme.meshes))), 3)
