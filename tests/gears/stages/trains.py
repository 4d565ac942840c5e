"""Specs of gear trains for the stages strength and criteria, and the worked cases that they are held against."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

import tmmcalc
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.sizing import Sized, Sizing
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run

CASES: dict[str, Any] = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[2] / "cases" / "gear-trains.json").read_text())
    if case["verified"]
}
STEEL = 'material = { steel = "40Kh", treatment = "improved", hardness = "300 HB", load = "one-sided" }\n'
ABSOLUTE = 'tolerance_kind = "absolute"\n'
AI = f'layout = "AI"\nratio = "31.29"\ntolerance = "0.5"\n{ABSOLUTE}module_ratios = [[4, 7]]\n'
AIBAR = f'layout = "AIbar"\nratio = "7.29"\ntolerance = "0.1"\n{ABSOLUTE}'
UNFOLDED = (
    'layout = "unfolded2"\nratio = "8.15"\nz_min = 16\nz_pinion_max = 22\nconstraints = { diameter_band = 0.2 }\n'
)
COAXIAL = f'layout = "coaxial"\nratio = "8.15"\ntolerance = "0.08"\n{ABSOLUTE}module_ratios = [[2, 3]]\n'
LOADED = f'torque = "75 N*m"\nface_width = 0.6\n{STEEL}'
BETAS = {1: (0.50, 1.08), 3: (0.16, 0.31), 5: (0.07, 0.16)}  # rows of Table D.4.1, soft


def ran(train: str, strength: str, criteria: str = "", target: str = "criteria") -> RunResult:
    text = f"[train]\n{train}\n[strength]\n{strength}\n" + (f"[criteria]\n{criteria}\n" if criteria else "")
    return run(tmmcalc.parse_spec(text), target=target)


def sized(train: str, strength: str) -> Sized:
    result: Sizing = ran(train, strength, target="strength").results["strength"]
    (found,) = result.variants
    return found


def chosen(train: str, strength: str = LOADED, criteria: str = "") -> Selection:
    result: Selection = ran(train, strength, criteria).results["criteria"]
    return result


def at(teeth: np.ndarray, row: list[int]) -> int:
    """The place of a tooth set among all."""
    (place,) = np.flatnonzero((teeth == row).all(axis=1))
    return int(place)


def permissible(stages: list[tuple[float, float, int]], torque: float, planets: int, psi: float) -> str:
    """Stresses that give the stages their coefficients A_H, A_F [mm] of (4.40); the row of D.4.1 is the third."""
    contact, bending = [], []
    for a_h, a_f, row in stages:
        share = torque / (planets * psi)
        contact.append(1e6 * (share * (1 + BETAS[row][0] * psi)) ** 0.5 * (770 / a_h) ** 1.5)
        bending.append(1e6 * share * (1 + BETAS[row][1] * psi) * (14 / a_f) ** 3)
    rows = [row for _, _, row in stages]
    return (
        f"torque = {torque}\nface_width = {psi}\narrangement = {rows}\n"
        f"permissible_contact = {contact}\npermissible_bending = {bending}\n"
    )
