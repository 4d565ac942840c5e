"""Names on force polygons: each stands nearer to its own arrow than to any other, on what is drawn."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from paper import inside, named_place, of_words
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
from tmmcalc.report.drawing.labels import TOUCHING
from tmmcalc.report.drawing.pens import FORCES
from tmmcalc.report.drawing.shapes import Area, Drawing, Stroke

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


SIZE = Box(0.0, 0.0, 140.0, 80.0)


def drawn(body: FreeBody) -> tuple[Drawing, list[Board]]:
    """The polygon on paper, and its board with those of its details; none of a body without forces."""
    drawing = Drawing(SIZE.width, SIZE.height)
    draw_force_polygon(drawing, SIZE, body, None)
    return drawing, [board for board in drawing.fields if isinstance(board, Board)]


def names_on(drawing: Drawing, board: Board) -> list[tuple[str, complex]]:
    """Names on a board with the places that they belong to [N]."""
    return [
        (words.text, board.data(named_place(drawing, words)))
        for words in of_words(drawing)
        if words.clear and len(words.text) > 1 and inside(np.array([words.at]), board.box)
    ]


def away(at: complex, vector: ForceVector) -> float:
    part = ((at - vector.tail) * np.conj(vector.value)).real / abs(vector.value) ** 2
    return abs(at - vector.tail - min(max(part, 0.0), 1.0) * vector.value)


def check(body: FreeBody) -> int:
    """The names that were looked at; a vector that lies on another one shares its names."""
    drawing, boards = drawn(body)
    vectors = vectors_of(body)
    found = {board: names_on(drawing, board) for board in boards}
    every = sorted(name for names in found.values() for name, _ in names)
    told = [v.name for v in vectors if v.kind is not None or abs(v.value) > NAMED * boards[0].mu]
    assert every == sorted(told)
    for board, names in found.items():
        here = vectors if board is boards[0] else [v for v in vectors if v.name in dict(names)]
        for name, at in names:
            own = min(away(at, vector) for vector in here if vector.name == name)
            for other in here:
                if other.name != name and other.value and not lies_on(name, here, other, TOUCHING * board.mu):
                    assert own <= away(at, other) + 0.05 * board.mu, (name, other.name)
    return len(every)


def lies_on(name: str, here: list[ForceVector], other: ForceVector, near: float) -> bool:
    """Whether a vector of this name lies on another one, so that no place is nearer to it."""
    return any(max(away(end, other) for end in own.ends) <= near for own in here if own.name == name)


def heads_on(drawing: Drawing, board: Board) -> list[complex]:
    """Arrows of forces on a board as vectors [N], from the tail of a stroke to the tip of its head."""
    layers = {pen.layer for pen in FORCES.values()}
    tails = [s.points for s in drawing.shapes if isinstance(s, Stroke) and s.pen.layer in layers]
    heads = [s.points for s in drawing.shapes if isinstance(s, Area) and s.pen is not None and s.pen.layer in layers]
    pairs = [(line[0], head[0]) for line, head in zip(tails, heads, strict=True)]
    here = [pair for pair in pairs if inside(np.array(pair), board.box)]
    return [board.data(complex(tip)) - board.data(complex(tail)) for tail, tip in here]


@pytest.mark.parametrize("config", ["shaper", "press", "class-three", "four-stroke-engine"])
def test_polygons_close_on_paper_and_details_are_their_own_forces_enlarged(config: str) -> None:
    spec = tmmcalc.load_spec(Path(CONFIGS) / f"{config}.toml", ["mechanism.grid.positions=12"])
    details = 0
    for body in bodies_of(spec, "5"):
        drawing, boards = drawn(body)
        largest = max(abs(force.value) for force in body.forces)
        whole = heads_on(drawing, boards[0])
        assert abs(sum(whole)) < 1e-9 * largest
        np.testing.assert_allclose(whole, [force.value for force in body.forces], atol=1e-9 * largest)
        for board in boards[1:]:
            details += 1
            assert board.mu < boards[0].mu / 2
            for value in heads_on(drawing, board):
                assert abs(value) <= NAMED * boards[0].mu
                assert min(abs(value - force.value) for force in body.forces) < 1e-9 * largest
    assert details > (0 if config in ("shaper", "class-three") else -1)


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
