"""Slider-cranks, slotted links and crank-rockers: every input set leads back to the linkage that it was taken from."""

from __future__ import annotations

import math
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples
from scipy.optimize import brentq, minimize_scalar
from sparing import sparing

import tmmcalc
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.linkage.synthesis.kinds import solve_synthesis
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import CrankRockerTask, RotatingTask, SliderCrankTask, SlottedTask, SynthesisTask

RAD = math.radians


def solved(kind: str, asked: Any, **more: Any) -> Synthesis:
    return solve_synthesis(SynthesisTask(kind, asked, solutions=50, **more))


def measured(r: float, l: float, e: float) -> dict[str, float]:
    """All sizes of a slider-crank, from elementary geometry."""
    stroke = math.sqrt((l + r) ** 2 - e**2) - math.sqrt((l - r) ** 2 - e**2)
    psi = math.asin(e / (l - r)) - math.asin(e / (l + r))
    return {
        "stroke": stroke,
        "crank": r,
        "rod": l,
        "offset": e,
        "time_ratio": (math.pi + psi) / (math.pi - psi),
        "crank_ratio": r / l,
        "offset_ratio": e / r,
        "offset_part": e / stroke,
        "pressure_working": math.asin((r - e) / l),
        "pressure_idle": math.asin((r + e) / l),
    }


SETS = [
    keys
    for keys in combinations(measured(0.1, 0.4, 0.05), 3)
    if {"stroke", "crank", "rod", "offset"} & set(keys)
    # two of the three settle the third
    and not any(
        same <= set(keys)
        for same in (
            {"crank", "rod", "crank_ratio"},
            {"crank", "offset", "offset_ratio"},
            {"stroke", "offset", "offset_part"},
        )
    )
]


@sparing("keys", SETS, ids="-".join, every=6)
def test_every_input_set_of_a_slider_crank_finds_it_again(keys: tuple[str, ...]) -> None:
    r, l, e = 0.1, 0.31, 0.06
    sizes = measured(r, l, e)
    found = solved("slider_crank", SliderCrankTask(**{key: sizes[key] for key in keys}))
    places = [[design.size(symbol) for symbol in "rle"] for design in found.designs]
    assert min(np.max(np.abs(np.array(place) - (r, l, e))) for place in places) < 1e-10
    for place in places:  # other roots have the sizes asked for as well
        assert [measured(*place)[key] for key in keys] == pytest.approx([sizes[key] for key in keys], rel=1e-9)
    assert found.residual < 1e-9


@examples(40)
@given(st.floats(0.05, 0.8), st.floats(0.01, 0.9), st.floats(1.001, 1.6))
def test_a_slider_crank_of_stroke_ratio_and_lambda(lam: float, stroke: float, ratio: float) -> None:
    psi = math.pi * (ratio - 1) / (ratio + 1)
    if lam <= math.tan(psi / 2) ** 2 * (1 + 1e-6):
        with pytest.raises(NoSolutionError):
            solved("slider_crank", SliderCrankTask(stroke=stroke, time_ratio=ratio, crank_ratio=lam))
        return
    best = solved("slider_crank", SliderCrankTask(stroke=stroke, time_ratio=ratio, crank_ratio=lam)).best
    sizes = measured(*(best.size(symbol) for symbol in "rle"))
    assert (sizes["stroke"], sizes["time_ratio"]) == pytest.approx((stroke, ratio), rel=1e-9)


def test_exchanged_pressure_angles_exchange_the_strokes() -> None:
    found = solved("slider_crank", SliderCrankTask(stroke=0.2, pressure_working=RAD(20), pressure_idle=RAD(10)))
    assert found.best.size("e") < 0
    assert found.best.check("K").achieved == pytest.approx(1 / 1.0301775284026742, rel=1e-12)
    assert any("exchange" in note for note in found.notes)


def test_too_few_sizes_and_impossible_ones() -> None:
    with pytest.raises(UsageError, match="2 independent"):
        solved("slider_crank", SliderCrankTask(stroke=0.2, time_ratio=1.1))
    with pytest.raises(NoSolutionError):
        solved("slider_crank", SliderCrankTask(stroke=0.2, time_ratio=3.0, crank_ratio=0.1))
    with pytest.raises(NoSolutionError):
        solved("slotted_link", SlottedTask(0.2, 1.0, RAD(10), guide=0.4))
    with pytest.raises(NoSolutionError, match="not longer"):
        solved("slotted_link", SlottedTask(0.3, 1.5, rod=0.01, guide=0.42))
    with pytest.raises(NoSolutionError):
        solved("rotating_slotted_link", RotatingTask(0.2, 1.8, RAD(15), crank=0.075, guide=5.0, rod=0.3))
    with pytest.raises(NoSolutionError, match="second size"):
        solved("crank_rocker", CrankRockerTask(RAD(40), 1.2, rocker=0.3, frame=0.01))
    with pytest.raises(NoSolutionError, match="there is no crank-rocker of swing 40 deg"):
        solved("crank_rocker", CrankRockerTask(RAD(40), 5.0, rocker=0.3))


def test_a_small_swing_without_a_second_size_is_refused_for_its_long_links() -> None:
    """Of a central crank-rocker r = R sin(phi), so the longest link is 1/sin(phi) cranks at least."""
    with pytest.raises(NoSolutionError, match=r"largest_ratio = 6 cranks: of 114\.593 cranks") as refused:
        solved("crank_rocker", CrankRockerTask(RAD(1), 1.0, rocker=0.3))
    assert "largest_ratio" in (refused.value.remedy or "")
    least = 1 / math.sin(RAD(0.5))
    found = solved("crank_rocker", CrankRockerTask(RAD(1), 1.0, rocker=0.3, largest_ratio=least + 1))
    assert found.best.size("r") == pytest.approx(0.3 * math.sin(RAD(0.5)), rel=1e-12)


@pytest.mark.parametrize("guide", [0.0, 0.02, -0.02, 0.12])
def test_rotating_slotted_link_with_an_offset_guide(guide: float) -> None:
    """Stroke and strokes' angles of the sizes found, by scipy on the closed geometry."""
    best = solved("rotating_slotted_link", RotatingTask(0.2, 1.8, RAD(15), crank=0.075, guide=guide)).best
    r, centres, arm, rod = (best.size(symbol) for symbol in "rLRl")

    def slider(phi: float) -> float:
        block = 1j * centres + r * complex(math.cos(phi), math.sin(phi))
        end = arm * block / abs(block)
        return end.real + math.sqrt(rod**2 - (guide - end.imag) ** 2)

    grid = np.linspace(0, 2 * math.pi, 400)
    values = [slider(phi) for phi in grid]
    ends = []
    for sign, k in ((-1, int(np.argmax(values))), (1, int(np.argmin(values)))):
        options = {"xatol": 1e-12}
        near = (grid[k] - 0.02, grid[k] + 0.02)
        ends.append(minimize_scalar(lambda x, s=sign: s * slider(x), bounds=near, method="bounded", options=options).x)
    assert slider(ends[0]) - slider(ends[1]) == pytest.approx(0.2, rel=1e-9)
    working = (ends[1] - ends[0]) % (2 * math.pi)
    assert working / (2 * math.pi - working) == pytest.approx(1.8, rel=1e-5)  # an extremum locates to its square root
    assert best.check("nu_max").achieved == pytest.approx(RAD(15), abs=1e-12)


@examples(6)
@given(st.floats(15, 100), st.floats(1.0, 1.5))
def test_crank_rocker_has_the_best_transmission(swing: float, ratio: float) -> None:
    """Brute force over the pivot's place on the circle from which the chord is seen under the overlap angle."""
    asked = CrankRockerTask(RAD(swing), ratio, rocker=1.0, largest_ratio=8)
    brute = brute_force(RAD(swing), math.pi * (ratio - 1) / (ratio + 1), 8.0)
    if brute <= 0:
        return
    found = solved("crank_rocker", asked)
    best = found.best.merits["transmission_min[deg]"]
    assert found.residual < 1e-9
    assert best >= math.degrees(brute) - 1e-9
    assert best <= math.degrees(brute) + 0.5


def brute_force(swing: float, psi: float, ratio: float) -> float:
    """Greatest least transmission angle of crank-rockers with pivots on a grid of the plane that keep psi."""
    ends = [complex(math.cos(a), math.sin(a)) for a in (math.pi / 2 + swing / 2, math.pi / 2 - swing / 2)]
    best = -1.0
    chord = abs(ends[0] - ends[1])
    if psi == 0:
        grid = np.linspace(chord / 2, 12, 1500)
    else:  # by the angle; near to a straight line by the distance, which a small overlap angle stretches
        far = np.linspace(1e-3, min(12 / chord, 1 / math.sin(psi)), 1500)
        grid = np.r_[np.linspace(1e-3, math.pi - psi - 1e-3, 1500), math.pi - psi - np.arcsin(far * math.sin(psi))]
    for long in grid:
        if psi == 0:
            places = [ends[1] + (ends[1] - ends[0]) / chord * long]
        else:  # angle at the near end
            way = math.sin(math.pi - psi - long) / math.sin(psi) * (ends[1] - ends[0])
            places = [ends[0] + way * complex(math.cos(t), math.sin(t)) for t in (long, -long)]
        for pivot in places:
            a, b = sorted((abs(ends[0] - pivot), abs(ends[1] - pivot)))
            r, l, d = (b - a) / 2, (a + b) / 2, abs(pivot)
            sides = [(pivot.conjugate() * end).imag for end in ends]
            longest = max(l, d, 1.0)
            if r <= 0 or sides[0] * sides[1] <= 0 or r > min(l, d, 1.0) or longest > ratio * r:
                continue
            if 2 * (r + longest) >= r + l + d + 1.0:
                continue
            worst = max(abs((l**2 + 1 - (d + s * r) ** 2) / (2 * l)) for s in (1, -1))
            best = max(best, math.acos(min(worst, 1.0)))
    return best


def test_crank_rocker_with_a_second_size() -> None:
    for second in ({"frame": 0.4}, {"coupler": 0.25}, {"crank": 0.1}, {"transmission": RAD(35)}):
        found = solved("crank_rocker", CrankRockerTask(RAD(40), 1.2, rocker=0.3, **second))
        assert found.residual < 1e-9
        for design in found.designs:
            assert design.check("swing").achieved == pytest.approx(RAD(40), rel=1e-10)
            motion = tmmcalc.solve_kinematics(tmmcalc.parse_spec(design.spec))
            assert motion.summaries[0].time_ratio == pytest.approx(1.2, rel=1e-9)


def test_a_central_crank_rocker_is_told_and_is_one() -> None:
    found = solved("crank_rocker", CrankRockerTask(RAD(40), 1.0, rocker=0.3))
    assert any("central" in note for note in found.notes)
    r, l, rocker, frame = (found.best.size(symbol) for symbol in "rlRL")
    assert r == pytest.approx(rocker * math.sin(RAD(20)), rel=1e-12)
    assert r**2 + frame**2 == pytest.approx(l**2 + rocker**2, rel=1e-12)  # the criterion of a central crank-rocker
    assert not any(
        "central" in note for note in solved("crank_rocker", CrankRockerTask(RAD(40), 1.1, rocker=0.3)).notes
    )


def test_strokes_of_a_rocker_have_angular_speeds() -> None:
    times = solved("crank_rocker", CrankRockerTask(RAD(40), 1.2, rocker=0.3), crank_speed=2.0).best.times
    assert times is not None
    assert times.unit == "rad"
    assert times.mean_speed == pytest.approx(2 * RAD(40) * 2.0 / (2 * math.pi), rel=1e-12)


@pytest.mark.parametrize(
    "sizes",
    [
        {"stroke": 0.2, "crank": 0.1, "time_ratio": 1.0},
        {"stroke": 0.2, "crank": 0.1, "offset": 0.0},
        {"stroke": 0.2, "offset": 0.02, "offset_part": 0.1},
        {"crank": 0.1, "rod": 0.4, "crank_ratio": 0.25},
    ],
)
def test_sizes_that_say_the_same_are_told(sizes: dict[str, float]) -> None:
    with pytest.raises(UsageError, match="say the same"):
        solved("slider_crank", SliderCrankTask(**sizes))


def test_a_slider_that_turns_back_before_its_slotted_link() -> None:
    """A swing of 75 deg to each side and 30 deg of pressure angle: the path of D bends back along the rod."""
    ratio = (180 + 150) / (180 - 150)
    with pytest.raises(NoSolutionError, match="turns back before"):
        solved("slotted_link", SlottedTask(0.2, ratio, RAD(30), guide=0.1))


@pytest.mark.slow
@examples(60)
@given(st.integers(0, 10**6))
def test_random_slotted_links_and_crank_rockers_meet_their_targets(seed: int) -> None:
    """Sizes from micrometres to hundreds of metres; stroke and time ratio of the ready spec, read as any other."""
    rng = np.random.default_rng(seed)
    size, ratio = 10 ** rng.uniform(-6, 2), 1 + 10 ** rng.uniform(-2, 0.3)
    asked: dict[str, Any] = {
        "slotted_link": SlottedTask(size, ratio, RAD(rng.uniform(2, 25)), guide=size * rng.uniform(1, 4)),
        "rotating_slotted_link": RotatingTask(size, ratio, RAD(rng.uniform(2, 40)), crank=size * rng.uniform(0.1, 2)),
        "crank_rocker": CrankRockerTask(RAD(rng.uniform(10, 90)), 1 + rng.uniform(0, 0.3), rocker=size),
    }
    for kind, task in asked.items():
        try:
            found = solved(kind, task)
        except NoSolutionError:
            continue
        target = task.swing if kind == "crank_rocker" else size
        for design in found.designs:
            summary = tmmcalc.solve_kinematics(tmmcalc.parse_spec(design.spec)).summaries[0]
            assert summary.stroke == pytest.approx(target, rel=1e-9)
            assert summary.time_ratio == pytest.approx(task.time_ratio, rel=1e-9)


def test_the_other_input_sets_agree_with_brentq() -> None:
    """(S, K, nu_x) and (S, nu_x, e/S) as one unknown each."""

    def gap(lam: float) -> float:
        kappa = math.sin(RAD(25)) - lam
        return math.asin(kappa / (1 - lam)) - math.asin(kappa / (1 + lam)) - math.pi * 0.05 / 2.05

    root = brentq(gap, 0.2, math.sin(RAD(25)))
    found = solved("slider_crank", SliderCrankTask(stroke=0.2, time_ratio=1.05, pressure_idle=RAD(25)))
    assert found.best.size("lambda") == pytest.approx(root, rel=1e-10)
