"""Indexing drives of the tests, and their mechanism as plain geometry: nothing here comes from the code under test."""

from __future__ import annotations

import json
from dataclasses import replace
from math import pi, radians
from pathlib import Path
from typing import Any

import numpy as np

from tmmcalc.cams.indexing.laws import step_law
from tmmcalc.cams.indexing.task import IndexingTask

CASES = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[1] / "cases" / "collection-2008.json").read_text())
    if "lantern" in case["id"]
}
PAPER = {"sine": "sine", "cosine": "cosine", "3-4-5": "shun"}  # names of the cases: of the catalogue
SCENES = {
    "3-4-5": IndexingTask(step_law("shun"), 6, radians(90), 0.05, 2.6, 0.012),
    "falling": IndexingTask(step_law("0000"), 8, radians(100), 0.08, 1.8, 0.014),
    "ends": IndexingTask(step_law("0010"), 10, radians(95), 0.1, 1.68, 0.011),
    "sharp": IndexingTask(step_law("sine"), 6, radians(90), 0.05, 2.36, 0.005),
    "fat": IndexingTask(step_law("linear"), 6, radians(120), 0.05, 2.5, 0.042),
    "many": IndexingTask(step_law("linear"), 14, radians(170), 0.2, 1.5, 0.02),
    "constant": IndexingTask(step_law("0050"), 6, radians(120), 0.04, 2.2, 0.009),
}


def task(**given: Any) -> IndexingTask:
    return replace(SCENES["3-4-5"], **given)


def law_at(name: str, k: Any) -> Any:
    """s(k) of the scenes, written out by hand."""
    k = np.asarray(k, float)
    if name == "3-4-5":
        return 10 * k**3 - 15 * k**4 + 6 * k**5
    if name in ("falling", "fat", "many"):
        return 3 * k**2 - 2 * k**3
    if name == "sharp":
        return k - np.sin(2 * pi * k) / (2 * pi)
    e = {"ends": 0.1, "constant": 0.5}[name]
    x = np.where(k <= 0.5, k, 1 - k)
    t, rest = np.maximum(x - e, 0.0), max(0.5 - e, 1e-300)
    size = 0.5 / (e**2 / 2 + e * rest + rest**2 / 3)
    late = size * e**2 / 2 + size * e * t + size * (t**2 / 2 - t**3 / (6 * rest))
    s = np.where(x <= e, size * x**2 / 2, late)
    return np.where(k <= 0.5, s, 1 - s)


def roller_at(given: IndexingTask, theta: Any) -> Any:
    """Place of a roller, O1 at 0 and O2 at a, by its angle on the wheel from O2O1 as the wheel turns (clockwise)."""
    assert given.ratio is not None
    arm = np.exp(1j * (pi - np.asarray(theta)))
    return given.ratio * given.wheel + given.wheel * arm
