"""Names on force polygons: each stands nearer to its own arrow than to any other, on what is drawn."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from paper import of_words
from written import PINS, link, pin

import tmmcalc
from linkage.scenes import CONFIGS
from tmmcalc.linkage.freebody import FreeBody, free_bodies
from tmmcalc.linkage.pictures.course import statics_of
from tmmcalc.linkage.pictures.forcepolygon import NAMED, ForceVector, draw_force_polygon, vectors_of
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.shapes import Drawing

MM = 25.4
LINKS = (
    link(1, 'O = [0, 0], A = ["100 mm", 0]', "mass = 1.5")
    + link(2, 'A = [0, 0], B = ["600 mm", 0]', "mass = 4", "inertia = 0.1", 'center = ["300 mm", 0]')
    + link(
        3,
        'C = [0, 0], B = ["350 mm", 0], E = ["450 mm", "50 mm"]',
        "mass = 3",
        "inertia = 0.05",
        'center = ["200 mm", 0]',
    )
)
PRESS = f"""
[project]
title = "Press with a dyad of three pins"
[mechanism.input]
joint = "O"
speed = "10 rad/s"
start = "0 deg"
[mechanism.grid]
positions = 12
[mechanism.fixed]
O = [0, 0]
C = [0.7, 0.1]
{LINKS}{PINS}{pin("C", 3, 0)}[mechanism.assembly]
sketch = {{ B = [0.6, 0.4] }}
[[loads]]
link = 3
point = "E"
direction = "180 deg"
force = "900 N"
stroke = "working"
"""


def bodies_of(spec: Any, label: str) -> tuple[FreeBody, ...]:
    kinematics = tmmcalc.solve_kinematics(spec)
    forces = tmmcalc.solve_forces(spec)
    statics = statics_of(to_linkage(spec.linkage), to_loading(spec), kinematics)
    return free_bodies(statics, float(forces.theta[forces.labels.index(label)]), 1.0)


def names_of(body: FreeBody) -> tuple[list[tuple[str, complex]], list[ForceVector], float]:
    """Names with their places [N], the vectors, and the scale [N/mm], on a square of paper."""
    drawing = Drawing(78.0, 62.0)
    draw_force_polygon(drawing, Box(0.0, 0.0, 78.0, 62.0), body, None)
    if not drawing.fields:  # a body without forces
        return [], vectors_of(body), 1.0
    (board,) = drawing.fields
    assert isinstance(board, Board)
    names = [(words.text, board.data(words.at)) for words in of_words(drawing) if words.clear]
    return names, vectors_of(body), board.mu


def away(at: complex, vector: ForceVector) -> float:
    part = ((at - vector.tail) * np.conj(vector.value)).real / abs(vector.value) ** 2
    return abs(at - vector.tail - min(max(part, 0.0), 1.0) * vector.value)


def check(body: FreeBody) -> int:
    """The names that were looked at; a vector that lies on another one shares its names."""
    names, vectors, scale = names_of(body)
    long = [vector for vector in vectors if abs(vector.value) > NAMED * scale]
    assert sorted(name for name, _ in names) == sorted(vector.name for vector in long)
    for name, at in names:
        own = min(away(at, vector) for vector in long if vector.name == name)
        for other in vectors:
            if other.name != name and other.value:
                assert own <= away(at, other) + 0.05 * scale, (name, other.name)
    return len(names)


def test_the_press_with_three_pins() -> None:
    spec = tmmcalc.parse_spec(PRESS)
    assert sum(check(body) for body in bodies_of(spec, "9")) >= 6


@pytest.mark.slow
@pytest.mark.parametrize(
    "config", ["press", "shaper", "class-three", "class-four", "class-three-slider", "scotch-yoke", "hydraulic-lift"]
)
def test_every_position(config: str) -> None:
    file = Path(CONFIGS) / f"{config}.toml"
    spec = tmmcalc.load_spec(file, ["mechanism.grid.positions=12"])
    assert sum(check(body) for k in range(12) for body in bodies_of(spec, str(k))) > 30


@pytest.mark.slow
def test_every_position_of_the_press_with_three_pins() -> None:
    spec = tmmcalc.parse_spec(PRESS)
    assert sum(check(body) for k in range(12) for body in bodies_of(spec, str(k))) > 60
