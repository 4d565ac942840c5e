"""Estimated errors of the sizes of designs against 60 digits, at the borders of what turns too."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from bounding import assert_bounds
from mpmath import mp, mpf

from tmmcalc.core.errors import TmmError
from tmmcalc.linkage.synthesis.errors import sizes_error
from tmmcalc.linkage.synthesis.kinds import solve_synthesis
from tmmcalc.linkage.synthesis.posesearch import EXACT
from tmmcalc.linkage.synthesis.results import Design
from tmmcalc.linkage.synthesis.task import (
    CrankRockerTask,
    FunctionTask,
    PoseTask,
    RotatingTask,
    SliderCrankTask,
    SlottedTask,
    SynthesisTask,
    TrailingRodTask,
)

from . import exactly
from .test_closed_forms import SETS, measured

Scene = tuple[float, float]  # estimate, true error
Kind = Callable[[np.random.Generator], Iterator[Scene]]


def _designs(task: SynthesisTask) -> Iterator[tuple[Design, float]]:
    """All designs of a task, each with the estimate of it alone."""
    try:
        found = solve_synthesis(task)
    except TmmError:
        return
    if task.kind in ("path", "motion") and found.rule != EXACT:
        return
    assert found.error is not None
    for design in found.designs:
        error = sizes_error(task, replace(found, designs=(design,)))
        assert error is not None
        assert error <= found.error
        yield design, error


def _far(told: Sequence[Any], true: Sequence[Any]) -> float:
    return float(max(abs(mpf(a) - b) for a, b in zip(told, true, strict=True)))


def _closed(kind: str, asked: Any, symbols: str, equations: Callable[[Any, float], Any]) -> Iterator[Scene]:
    for design, error in _designs(SynthesisTask(kind, asked, solutions=20)):
        unit = max(abs(design.size(symbol)) for symbol in symbols)
        told = [mpf(design.size(symbol)) / unit for symbol in symbols]
        yield error, _far(told, exactly.settled(equations(asked, unit), told))


def slider_cranks(rng: np.random.Generator) -> Iterator[Scene]:
    """All sets of given sizes, of mechanisms that hardly turn too, in any unit."""
    unit, lam = 10 ** rng.uniform(-3, 3), 10 ** rng.uniform(-1.5, -0.1)
    kappa = (1 - lam) * float(rng.choice([0.0, rng.uniform(-1, 1), 1 - 10 ** rng.uniform(-4, -1)]))
    sizes = measured(lam * unit, unit, kappa * unit)
    keys = SETS[rng.integers(len(SETS))]
    yield from _closed(
        "slider_crank", SliderCrankTask(**{key: sizes[key] for key in keys}), "rle", exactly.slider_crank
    )


def slotted_links(rng: np.random.Generator) -> Iterator[Scene]:
    unit, ratio = 10 ** rng.uniform(-3, 3), 1 + 10 ** rng.uniform(-2, 0.3)
    one = {"crank": unit * rng.uniform(0.1, 0.5)} if rng.random() < 0.5 else {"centres": unit * rng.uniform(0.2, 1)}
    if rng.random() < 0.3:
        one = {"guide": unit * rng.uniform(0.5, 2)}
    two = {"pressure": rng.uniform(0.05, 0.6)} if rng.random() < 0.5 else {"rod": unit * rng.uniform(0.5, 4)}
    asked = SlottedTask(unit * rng.uniform(0.1, 1), ratio, **one, **two)
    yield from _closed("slotted_link", asked, "rLRle", exactly.slotted)


def rotating_links(rng: np.random.Generator) -> Iterator[Scene]:
    unit, ratio = 10 ** rng.uniform(-3, 3), 1 + 10 ** rng.uniform(-2, 0.5)
    stroke = unit * rng.uniform(0.1, 1)
    size = {"crank" if rng.random() < 0.5 else "centres": unit * rng.uniform(0.1, 0.5)}
    two = {"pressure": rng.uniform(0.05, 0.9)} if rng.random() < 0.5 else {"rod": stroke * rng.uniform(0.6, 4)}
    guide = float(rng.choice([0.0, stroke * rng.uniform(-0.3, 0.3)]))
    asked = RotatingTask(stroke, ratio, **size, **two, guide=guide)
    yield from _closed("rotating_slotted_link", asked, "rLRl", exactly.rotating)


def trailing_rods(rng: np.random.Generator) -> Iterator[Scene]:
    """Of V-engines from flat to opposed, both sizes free."""
    unit = 10 ** rng.uniform(-3, 3)
    asked = TrailingRodTask(
        rng.uniform(0.01, math.pi), unit * rng.uniform(0.05, 0.4), unit, unit * rng.uniform(0.05, 0.4)
    )
    for design, error in _designs(SynthesisTask("trailing_rod", asked)):
        told = [mpf(design.size("l_4")) / asked.rod, mpf(design.size("alpha"))]
        yield error, _far(told, exactly.settled(exactly.trailing(asked, asked.rod), told))


def crank_rockers(rng: np.random.Generator) -> Iterator[Scene]:
    """By a second length or the transmission angle; those with the best one are a test of their own."""
    unit = 10 ** rng.uniform(-3, 3)
    swing, ratio = math.radians(rng.uniform(10, 120)), 1 + 10 ** rng.uniform(-3, -0.4)
    names = rng.permutation(["crank", "coupler", "rocker", "frame"])[:2].tolist()
    lengths = {"crank": 0.2, "coupler": 0.7, "rocker": 0.5, "frame": 0.8}
    given = {name: lengths[name] * unit * rng.uniform(0.5, 1.5) for name in names}
    if rng.random() < 0.4:
        given = {names[0]: given[names[0]], "transmission": math.radians(rng.uniform(15, 50))}
    yield from _closed("crank_rocker", CrankRockerTask(swing, ratio, **given), "rlRL", exactly.crank_rocker)


def best_rockers(rng: np.random.Generator) -> Iterator[Scene]:
    swing, ratio = math.radians(rng.uniform(15, 90)), 1 + 10 ** rng.uniform(-2, -0.6)
    name = str(rng.choice(["crank", "coupler", "rocker", "frame"]))
    asked = CrankRockerTask(
        swing, ratio, largest_ratio=float(rng.choice([3.0, 6.0])), **{name: 10 ** rng.uniform(-3, 3)}
    )
    for design, error in _designs(SynthesisTask("crank_rocker", asked)):
        unit = max(design.size(symbol) for symbol in "rlRL")
        told = [mpf(design.size(symbol)) / unit for symbol in "rlRL"]
        yield error, _far(told, exactly.best_rocker(asked, told, unit))


def generators(rng: np.random.Generator) -> Iterator[Scene]:
    """Powers over a range of the crank, with three to five points, offsets free or given."""
    slides = rng.random() < 0.5
    count = int(rng.integers(3, 6))
    given = {}
    if count < 5:
        given["input_start"] = rng.uniform(0, 6)
    if count < 4:
        given["output_start"] = rng.uniform(0.5, 2) if slides else rng.uniform(0, 6)
    x = np.sort(rng.uniform(1, 2, count))
    span = rng.uniform(0.3, 2), rng.uniform(0.3, 1.5) * float(rng.choice([-1, 1]))
    inputs, outputs = (x - 1) * span[0], (x ** rng.uniform(0.5, 3) - 1) / 3 * span[1]
    asked = FunctionTask(
        "slider_crank" if slides else "four_bar", inputs, outputs, np.empty(0), np.empty(0), (0.0, span[0]), **given,
        frame=float(10 ** rng.uniform(-3, 3)),
    )  # fmt: skip
    for design, error in _designs(SynthesisTask("function", asked, solutions=5)):
        unit = max(abs(design.size(symbol)) for symbol in ("rle" if slides else "abcd"))
        equations, told = exactly.function(asked, design, unit)
        yield error, _far(told, exactly.settled(equations, told))


def _traced(rng: np.random.Generator, slides: bool, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Places, angles of the coupler and of the crank of a random crank-rocker or slider-crank."""
    phi = np.sort(rng.uniform(0, 5.5, count))
    pin = 0.1 * np.exp(1j * phi)
    b, c, d = rng.uniform(0.22, 0.35, 3)
    if slides:
        rise = rng.uniform(-0.05, 0.1) - pin.imag
        joint = pin.real + np.sqrt(b**2 - rise**2) + 1j * (pin.imag + rise)
    else:
        reach = d - pin
        along = (b**2 - c**2 + np.abs(reach) ** 2) / (2 * np.abs(reach))
        joint = pin + reach / np.abs(reach) * (along + 1j * np.sqrt(np.maximum(b**2 - along**2, 0)))
    turn = (joint - pin) / b
    point = complex(*rng.uniform(-0.2, 0.3, 2))
    moved = np.exp(1j * rng.uniform(0, 6)) * 10 ** rng.uniform(-2, 2)
    return (pin + turn * point) * moved, np.unwrap(np.angle(turn)), phi - phi[0]


def motions(rng: np.random.Generator) -> Iterator[Scene]:
    slides = bool(rng.random() < 0.5)
    points, angles, _ = _traced(rng, slides, int(rng.integers(3, 5 if slides else 6)))
    asked = PoseTask("slider_crank" if slides else "four_bar", points, angles=angles)
    yield from _posed("motion", asked)


def paths(rng: np.random.Generator) -> Iterator[Scene]:
    slides, timed = bool(rng.random() < 0.5), bool(rng.random() < 0.5)
    most = (4 if slides else 5) if timed else (8 if slides else 9)
    points, _, timing = _traced(rng, slides, int(rng.integers(3 if timed else 5, most + 1)))
    asked = PoseTask("slider_crank" if slides else "four_bar", points, timing=timing if timed else None)
    yield from _posed("path", asked)


def _posed(kind: str, asked: PoseTask) -> Iterator[Scene]:
    for design, error in _designs(SynthesisTask(kind, asked, solutions=8)):
        lengths = ("a", "b") if asked.mechanism == "slider_crank" else ("a", "b", "c")
        unit = max(design.size(symbol) for symbol in lengths)
        equations, told, count = exactly.posed(asked, design, unit)
        yield error, _far(told[:count], exactly.settled(equations, told)[:count])


def _held(kind: Kind, scenes: int) -> None:
    rng, pairs = np.random.default_rng(8), []
    with mp.workdps(60):
        while len(pairs) < scenes:
            pairs += kind(rng)
    assert_bounds(pairs, kind.__name__, scenes=scenes)


@pytest.mark.parametrize(("swing", "ratio"), [(40, 1.2), (25, 1.05), (70, 1.15), (60, 1.0)])
def test_the_best_rocker_is_found_to_rounding(swing: float, ratio: float) -> None:
    """Where the transmission is level along the family, and where the links get too long."""
    asked = CrankRockerTask(math.radians(swing), ratio, rocker=0.3)
    with mp.workdps(60):
        for design, error in _designs(SynthesisTask("crank_rocker", asked, solutions=2)):
            unit = max(design.size(symbol) for symbol in "rlRL")
            told = [mpf(design.size(symbol)) / unit for symbol in "rlRL"]
            true = _far(told, exactly.best_rocker(asked, told, unit))
            assert true <= error < 2e-14


@pytest.mark.parametrize("kind", [slotted_links, trailing_rods])
def test_sizes_of_some(kind: Kind) -> None:
    _held(kind, 15)


@pytest.mark.slow
@pytest.mark.parametrize(
    "kind",
    [
        slotted_links,
        trailing_rods,
        slider_cranks,
        rotating_links,
        crank_rockers,
        best_rockers,
        generators,
        motions,
        paths,
    ],
)
def test_sizes(kind: Kind) -> None:
    _held(kind, 200)
