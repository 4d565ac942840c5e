"""The reference solver against the textbook's tables and against differences of its own positions.

The mechanisms are built by hand here, so that the solver is checked without any part of the package but
the plain records of ``tmmcalc.linkage.model``.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from assemblies import initial_guess_from
from numpy.testing import assert_allclose
from random_mechanisms import build
from reference import Array, Motion, NoPositionError, Reference, solve
from sparing import sparing

from tmmcalc.linkage.model import Input, Joint, Link, Mechanism

CASES = {case["id"]: case for case in json.loads((Path(__file__).parent / "cases" / "kinematics.json").read_text())}


def polar(length: float, degrees: float) -> complex:
    return complex(length * np.exp(1j * np.radians(degrees)))


def pin(name: str, one: int, two: int, at_one: complex = 0, at_two: complex = 0) -> Joint:
    return Joint(name, "revolute", (one, two), (complex(at_one), complex(at_two)))


def guide(name: str, slider: int, guide: int, through: complex = 0, degrees: float = 0, own: float = 0) -> Joint:
    return Joint(name, "prismatic", (slider, guide), (0j, complex(through)), (polar(1, own), polar(1, degrees)))


def bar(number: int, **points: complex) -> Link:
    return Link(number, {name: complex(place) for name, place in points.items()})


@dataclass(frozen=True)
class Textbook:
    """A worked case: its mechanism, a sketch of its variant, and how its columns are read off."""

    case: str
    mechanism: Mechanism
    sketch: dict[str, complex]
    angles: dict[int, str]  # link -> suffix of its columns: phi<s>_deg, om<s>, ep<s>
    start: float  # input angle of the first row [rad]
    scale: float = 1.0  # length of the printed unit


def crank_slider(case: str, l1: float, l2: float, e: float) -> Textbook:
    links = (bar(1, A=l1), bar(2, A=0, B=l2, S2=0.055), bar(3, B=0))
    joints = (pin("O", 0, 1), pin("A", 1, 2, l1), pin("B", 2, 3, l2), guide("B0", 3, 0, 1j * e))
    mechanism = Mechanism(Link(0), links, joints, Input("O", 1.0))
    return Textbook(case, mechanism, {"B": l1 + l2}, {2: "2"}, 0.0)


def shaper() -> Textbook:
    links = (bar(1, A=0.2), bar(2, A=0), bar(3, C=1.02), bar(4, D=0.29), bar(5, D=0))
    joints = (
        pin("O", 0, 1, 0.62j),
        pin("A", 1, 2, 0.2),
        guide("A3", 2, 3),
        pin("B", 0, 3),
        pin("C", 3, 4, 1.02),
        pin("D", 4, 5, 0.29),
        guide("D0", 5, 0, 1j),
    )
    start = -np.arcsin(0.2 / 0.62)
    mechanism = Mechanism(Link(0), links, joints, Input("O", 1.0))
    return Textbook("KIN-S01", mechanism, {"C": 0.3 + 1j, "D": 0.6 + 1j}, {3: "3", 4: "4"}, start, 0.2)


def slotter() -> Textbook:
    d = polar(0.3, 30)
    links = (bar(1, A=0.1), bar(2, A=0), bar(3, D=d), bar(4, E=0.4), bar(5, E=0))
    joints = (
        pin("O", 0, 1, 0.15 + 0.35j),
        pin("A", 1, 2, 0.1),
        guide("A3", 2, 3),
        pin("B", 0, 3),
        pin("D", 3, 4, d),
        pin("E", 4, 5, 0.4),
        guide("E0", 5, 0, 0.2, 90),
    )
    mechanism = Mechanism(Link(0), links, joints, Input("O", 1.0))
    return Textbook("KIN-S21", mechanism, {"D": 0.3j, "E": 0.2 + 0.7j}, {3: "3", 4: "4"}, 0.0)


def slotted_link() -> Textbook:
    links = (bar(1, A=0.25), bar(2, A=0), bar(3, K=0.4))
    joints = (pin("O", 0, 1, 0.1j), pin("A", 1, 2, 0.25), guide("A3", 2, 3), pin("B", 0, 3))
    mechanism = Mechanism(Link(0), links, joints, Input("O", 1.0))
    return Textbook("KIN-S17", mechanism, {"K": 0.36 + 0.15j}, {3: "3"}, 0.0)


def four_bar() -> Textbook:
    links = (bar(1, A=1), bar(2, B=6), bar(3, B=3))
    joints = (pin("O", 0, 1), pin("A", 1, 2, 1), pin("B", 2, 3, 6, 3), pin("C", 0, 3, 7))
    mechanism = Mechanism(Link(0), links, joints, Input("O", 1.0))
    return Textbook("KIN-S06", mechanism, {"B": 6 + 3j}, {2: "2", 3: "3"}, 0.0)


def conveyor() -> Textbook:
    links = (bar(1, A=0.12), bar(2, B=0.45), bar(3, B=0.28), bar(4, D=0.9), bar(5, D=0))
    joints = (
        pin("O", 0, 1),
        pin("A", 1, 2, 0.12),
        pin("B", 2, 3, 0.45, 0.28),
        pin("C", 0, 3, 0.5 + 0.1j),
        pin("B4", 3, 4, 0.28),
        pin("D", 4, 5, 0.9),
        guide("D0", 5, 0, 0.1j),
    )
    mechanism = Mechanism(Link(0), links, joints, Input("O", 1.0))
    sketch = {"B": 0.4 + 0.36j, "D": 1.25 + 0.1j}
    return Textbook("KIN-S24", mechanism, sketch, {2: "2", 3: "3", 4: "4"}, 0.0)


def v_engine() -> Textbook:
    case = CASES["KIN-S23"]
    c = polar(60, case["expected"]["alpha_deg"])
    links = (bar(1, A=70), bar(2, B=250, C=c), bar(3, B=0), bar(4, D=190), bar(5, D=0))
    joints = (
        pin("O", 0, 1),
        pin("A", 1, 2, 70),
        pin("B", 2, 3, 250),
        guide("B0", 3, 0),
        pin("C", 2, 4, c),
        pin("D", 4, 5, 190),
        guide("D0", 5, 0, 0, 45),
    )
    mechanism = Mechanism(Link(0), links, joints, Input("O", 1.0))
    sketch = {"B": 180 + 0j, "C": -40 + 50j, "D": polar(190, 45)}
    return Textbook("KIN-S23", mechanism, sketch, {4: "4"}, np.pi, 70)


TEXTBOOK = {
    book.case: book
    for book in (
        shaper(),
        four_bar(),
        crank_slider("KIN-S07", 0.0375, 0.168, 0.0),
        slotted_link(),
        slotter(),
        crank_slider("KIN-S22", 0.1, 0.32, -0.04),
        v_engine(),
        conveyor(),
    )
}


@cache
def run(case: str) -> tuple[Reference, dict[str, Array]]:
    book = TEXTBOOK[case]
    columns = {name: np.array(values) for name, values in CASES[case]["expected"]["columns"].items()}
    n = len(next(iter(columns.values())))
    coordinate = book.start + 2 * np.pi * np.arange(n) / (n - 1)
    start = initial_guess_from(book.mechanism, coordinate[0], book.sketch)
    return solve(book.mechanism, start, coordinate), columns


def speed(case: str) -> float:
    """The tables are per unit crank speed, except the press of Appendix 3."""
    return float(CASES[case]["inputs"]["omega1"]) if case == "KIN-S07" else 1.0


def tolerance_of(case: str) -> float:
    """Of lengths, velocities and accelerations as printed: six decimals."""
    return float(CASES[case]["tolerance"].get("abs", 2e-6))


def assert_motion(motion: Motion, columns: dict[str, Array], names: tuple[str, str, str], book: Textbook) -> None:
    w, tolerance = speed(book.case), tolerance_of(book.case)
    scaled = (motion.value / book.scale, w * motion.first / book.scale, w**2 * motion.second / book.scale)
    for name, values in zip(names, scaled, strict=True):
        if name in columns:
            assert_allclose(values, columns[name], rtol=0, atol=tolerance, err_msg=f"{book.case} {name}")


@sparing("case", TEXTBOOK, every=3)
def test_link_angles_agree_with_the_textbook(case: str) -> None:
    book = TEXTBOOK[case]
    found, columns = run(book.case)
    degrees = CASES[book.case]["tolerance"].get("abs_deg", 2e-6)
    for link, suffix in book.angles.items():
        motion, w = found.angles[link], speed(book.case)
        printed = columns[f"phi{suffix}_deg"]
        turns = np.round((np.degrees(motion.value[0]) - printed[0]) / 360) * 360
        assert_allclose(np.degrees(motion.value) - turns, printed, rtol=0, atol=degrees)
        for name, values in ((f"om{suffix}", w * motion.first), (f"ep{suffix}", w**2 * motion.second)):
            if name in columns:
                assert_allclose(values, columns[name], rtol=0, atol=tolerance_of(book.case), err_msg=name)
    assert found.residual < 1e-15


def component(motion: Motion, direction: complex) -> Motion:
    value, first, second = ((np.conj(direction) * x).real for x in (motion.value, motion.first, motion.second))
    return Motion(value, first, second)


def test_sliding_in_the_slot_agrees_with_the_textbook() -> None:
    found, columns = run("KIN-S17")
    assert_motion(found.slides["A3"], columns, ("l3", "v23", "a23"), slotted_link())


@pytest.mark.parametrize(
    ("case", "point", "direction", "zero", "names"),
    [
        ("KIN-S01", "D", 0, None, ("S_over_l1", "vD", "aD")),
        ("KIN-S21", "E", 90, 0.0, ("yE", "vE", "aE")),
        ("KIN-S24", "D", 0, 0.0, ("xD", "vD", "aD")),
        ("KIN-S07", "B", 0, 0.0, ("xB", "vB", "aB")),
        ("KIN-S07", "S2", 0, 0.0, ("", "", "aS2x")),
        ("KIN-S07", "S2", 90, 0.0, ("", "", "aS2y")),
        ("KIN-S22", "B", 0, 0.0, ("s", "v", "a")),
        ("KIN-S23", "B", 0, 180.0, ("S3", "v3", "a3")),
        ("KIN-S23", "D", 45, None, ("", "v5", "a5")),
    ],
)
def test_output_points_agree_with_the_textbook(
    case: str, point: str, direction: float, zero: float | None, names: tuple[str, str, str]
) -> None:
    found, columns = run(case)
    motion = component(found.point(point), polar(1, direction))
    first = float(motion.value[0]) if zero is None else zero
    shifted = Motion(motion.value - first, motion.first, motion.second)
    assert_motion(shifted, columns, names, TEXTBOOK[case])


@pytest.mark.slow
def test_a_position_that_does_not_exist_is_reported() -> None:
    book = crank_slider("KIN-S22", 0.1, 0.09, 0.0)
    start = initial_guess_from(book.mechanism, 0.0, book.sketch)
    with pytest.raises(NoPositionError) as stopped:
        solve(book.mechanism, start, np.linspace(0, 2, 9))
    assert stopped.value.coordinate == pytest.approx(np.arcsin(0.9), abs=1e-6)


@pytest.mark.parametrize("seed", range(12))
def test_derivatives_are_the_slopes_of_the_positions(seed: int) -> None:
    scene = build(np.random.default_rng(seed))
    h, middle = 1e-3, scene.mechanism.input.start or 0.0
    found = solve(scene.mechanism, scene.start, middle + h * np.arange(-3, 4))
    motions: list[Motion] = [*found.points.values(), *found.angles.values(), *found.slides.values()]
    for motion in motions:
        scale = 1 + float(np.max(np.abs(motion.second)))
        assert_allclose(motion.first[3], slope(motion.value, h), atol=1e-8 * scale)
        assert_allclose(motion.second[3], slope(motion.first, h), atol=1e-8 * scale)


def slope(f: Array, h: float) -> Any:
    """Central difference of order 6 at the middle of seven values."""
    return (45 * (f[4] - f[2]) - 9 * (f[5] - f[1]) + f[6] - f[0]) / (60 * h)
