"""Pairs of the tests, and what every solved pair has to be."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from math import radians
from typing import Any

import numpy as np

from tmmcalc.core.notes import Note, Phrase
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.task import PairTask

M = 0.005  # m, module of the worked cases
MM = 1e-3
PURE = (
    "name",
    "kind",
    "teeth",
    "shift",
    "least_shift",
    "least_teeth",
    "half_angle",
    "operating_half_angle",
    "strength",
)


def given(z1: int, z2: int, x1: float, x2: float, beta_deg: float = 0.0, **more: Any) -> PairTask:
    """Two external wheels with their shifts."""
    task = {"strategy": "given", "shifts": (x1, x2), "helix": radians(beta_deg)} | more
    return PairTask((z1, z2), **({"module": M} | task))


def book(**more: Any) -> PairTask:
    """The helical pair of the textbook at 85 mm."""
    task = {"strategy": "given_aw", "shifts": (0.6, None), "distance": 0.085, "helix": radians(15), "face_width": 0.04}
    return PairTask((14, 17), M, **(task | more))


def plain_everywhere(value: Any, path: str = "") -> None:
    """Assert that a result holds plain finite values only."""
    if is_dataclass(value):
        for field in fields(value):
            plain_everywhere(getattr(value, field.name), f"{path}.{field.name}")
    elif isinstance(value, tuple):
        for k, part in enumerate(value):
            plain_everywhere(part, f"{path}[{k}]")
    elif isinstance(value, np.ndarray):
        assert value.ndim == 1, path
        assert value.dtype == np.bool_ or np.isfinite(value).all(), path
    else:
        assert value is None or type(value) in (int, float, str, bool, Note, Phrase), path
        assert type(value) is not float or np.isfinite(value), path


def lengths(found: MeshPair) -> dict[str, float]:
    """Every length of a result by its path."""
    line = {f"line.{f.name}": getattr(found.line, f.name) for f in fields(found.line)}
    sizes = {
        f"{k}.{f.name}": getattr(wheel, f.name)
        for k, wheel in enumerate(found.sizes)
        for f in fields(wheel)
        if f.name not in PURE and getattr(wheel, f.name) is not None
    }
    rows = {f"{k}.W{row.teeth}": row.length for k, each in enumerate(found.measures) for row in each.spans}
    balls = {f"{k}.M": each.balls.size for k, each in enumerate(found.measures) if each.balls is not None}
    chords = {f"{k}.{row.name}": row.chord for k, each in enumerate(found.measures) for row in each.chords}
    return {
        "a": found.reference_distance,
        "a_w": found.distance,
        "c1": found.clearances[0],
        "c2": found.clearances[1],
        **line,
        **sizes,
        **rows,
        **balls,
        **chords,
    }
