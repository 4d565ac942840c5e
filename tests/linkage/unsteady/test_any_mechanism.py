"""Cranks and sliders on the frame: the ends that are sought, the signs, the derivatives in time."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sparing import sparing

import tmmcalc
from tmmcalc.core.errors import AssemblyError, NoSolutionError, UsageError
from tmmcalc.core.timelaw import motion
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.trace import trace
from tmmcalc.linkage.unsteady.solve import solve_unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask
from tmmcalc.project import templates

CONFIGS = templates.folder()
TURN = 2 * math.pi


def solved(name: str, **task: object) -> tmmcalc.Unsteady:
    mechanism = to_linkage(tmmcalc.load_spec(CONFIGS / f"{name}.toml").linkage)
    return solve_unsteady(mechanism, UnsteadyTask(**task))


def derivative(f, t: np.ndarray, h: float) -> np.ndarray:
    """Of the eighth order, centred."""
    weights = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
    return sum(w * (f(t + k * h) - f(t - k * h)) for k, w in enumerate(weights, 1)) / h


@sparing(
    ("name", "task"),
    [
        ("crank-slider", {"speed": 1.0, "acceleration": 2.0, "travel": 7.0}),
        ("shaper", {"speed": 3.0, "acceleration": 4.0, "travel": -5.0}),
        ("hydraulic-lift", {"speed": 0.04, "acceleration": 0.02, "travel": 0.4}),
        ("class-four", {"speed": 1.0, "acceleration": 2.0, "travel": 5.0}),
        ("crane-luffing", {"speed": 0.2, "acceleration": 0.05, "start": 5.2, "travel": 0.9}),
    ],
    every=3,
)
def test_rates_are_the_derivatives_in_time(name: str, task: dict[str, float]) -> None:
    mechanism = to_linkage(tmmcalc.load_spec(CONFIGS / f"{name}.toml").linkage)
    kinematics = tmmcalc.solve_kinematics(mechanism)
    result = solve_unsteady(mechanism, UnsteadyTask(**task), kinematics)
    chain, h = chain_of(mechanism, kinematics), 2e-3 * result.law.duration
    far = np.min(np.abs(result.t - np.array(result.law.instants)[:, None]), axis=0) > 5 * h
    t = result.t[far]
    assert t.size > 8

    def places(at: np.ndarray) -> np.ndarray:
        return trace(chain, result.start + motion(result.law, at)[0]).r

    def speeds(at: np.ndarray) -> np.ndarray:
        s, v, _ = motion(result.law, at)
        return trace(chain, result.start + s).dr * v

    for exact, f in ((result.trace.dr, places), (result.trace.ddr, speeds)):
        found = derivative(f, t, h)
        assert np.max(np.abs(found - exact[:, far])) < 2e-9 * np.max(np.abs(exact))


def test_a_steady_phase_is_that_of_kinematics() -> None:
    """In the uniform phase the accelerations are those of kinematics at that speed."""
    spec = tmmcalc.load_spec(CONFIGS / "shaper.toml")
    mechanism = to_linkage(spec.linkage)
    kinematics = tmmcalc.solve_kinematics(mechanism)
    speed = kinematics.speed
    task = UnsteadyTask(acceleration=abs(speed) * 1e6, speed=abs(speed), travel=math.copysign(TURN, speed), steps=24)
    result = solve_unsteady(mechanism, task, kinematics)
    k, j = (each.point_names.index("C") for each in (result.trace, kinematics.trace))
    phi = np.abs(result.drive[0] - kinematics.x[0])
    middle = np.flatnonzero((result.drive[2] == 0) & (result.side > 0))
    nearest = [int(np.argmin(np.abs(np.abs(kinematics.phi) - phi[row]))) for row in middle]
    same = [
        (row, near)
        for row, near in zip(middle, nearest, strict=True)
        if abs(abs(kinematics.phi[near]) - phi[row]) < 1e-5
    ]
    assert len(same) > 20
    _, a = kinematics.in_time(kinematics.trace.dr[j], kinematics.trace.ddr[j])
    for row, near in same:
        assert result.trace.ddr[k, row] == pytest.approx(a[near], abs=1e-4 * np.max(np.abs(a)))


def test_ends_by_an_output_are_the_nearest() -> None:
    """A slider meets every place twice a turn; the crank takes the nearer one, or the one on the asked side."""
    near = solved("crank-slider", speed=1.0, acceleration=2.0, start=0.25, end=0.38, output="B")
    assert near.coordinate[0, 0, [0, -1]] == pytest.approx([0.25, 0.38], rel=1e-12)
    assert abs(near.law.travel) < math.pi
    other = solved(
        "crank-slider", speed=1.0, acceleration=2.0, start=0.25, end=0.38, output="B", sense=-int(near.law.sense)
    )
    assert other.coordinate[0, 0, [0, -1]] == pytest.approx([0.25, 0.38], rel=1e-12)
    assert other.law.travel * near.law.travel < 0
    assert other.start == near.start


def test_an_extreme_of_an_output_is_reached() -> None:
    """A dead centre is a double root."""
    stroke = tmmcalc.solve_kinematics(tmmcalc.load_spec(CONFIGS / "crank-slider.toml")).summaries[0].dead_centres
    low, high = sorted(centre.value for centre in stroke)
    result = solved("crank-slider", speed=1.0, acceleration=2.0, start=(low + high) / 2, end=high, output="B")
    assert result.coordinate[0, 0, -1] == pytest.approx(high, rel=1e-13)
    assert result.trace.dr[result.trace.point_names.index("B"), -1] == pytest.approx(0, abs=1e-9)


def test_an_angle_of_a_link_counts_modulo_a_turn() -> None:
    lift = solved("four-bar", speed=1.0, acceleration=2.0, travel=9.0)
    driven = lift.trace.link_ids.index(1)
    assert lift.trace.angle[driven, -1] - lift.trace.angle[driven, 0] == pytest.approx(9.0, rel=1e-13)
    assert np.max(np.abs(np.diff(lift.trace.angle, axis=1))) < math.pi


def test_whole_turns_to_the_asked_side() -> None:
    there = solved("crank-slider", speed=1.0, acceleration=2.0, start=6.0, end=0.5, sense=1)
    assert there.law.travel == pytest.approx(TURN - 5.5, rel=1e-13)
    back = solved("crank-slider", speed=1.0, acceleration=2.0, start=6.0, end=0.5)
    assert back.law.travel == pytest.approx(-5.5, rel=1e-13)


def test_no_travel_is_one_row_at_rest() -> None:
    result = solved("crank-slider", speed=1.0, acceleration=2.0, travel=0.0)
    assert result.labels == ("0",)
    assert result.t.tolist() == [0.0]
    assert not np.any(result.trace.dr)
    assert not np.any(result.trace.ddr)


def test_the_error_estimate_holds() -> None:
    """Against extended precision at every row."""
    mechanism = to_linkage(tmmcalc.load_spec(CONFIGS / "shaper.toml").linkage)
    kinematics = tmmcalc.solve_kinematics(mechanism)
    result = solve_unsteady(mechanism, UnsteadyTask(4.0, speed=3.0, travel=5.0, steps=60), kinematics)
    exact = trace(chain_of(mechanism, kinematics), result.drive[0].astype(np.longdouble))
    found = trace(chain_of(mechanism, kinematics), result.drive[0])
    for mine, truth, bound in (
        (found.r, exact.r, result.error.position),
        (found.dr, exact.dr, result.error.velocity),
        (found.ddr, exact.ddr, result.error.acceleration),
    ):
        assert float(np.max(np.abs(mine - truth))) <= bound * float(np.max(np.abs(truth)))


def test_a_motion_beyond_the_assembly_interval_is_refused() -> None:
    with pytest.raises(AssemblyError):
        solved("hydraulic-lift", speed=0.04, acceleration=0.02, travel=5.0)


def test_what_is_missing_is_told() -> None:
    with pytest.raises(UsageError, match="largest speed is needed"):
        solved("crank-slider", acceleration=2.0, travel=1.0)
    with pytest.raises(UsageError, match="neither an end nor a duration"):
        solved("crank-slider", acceleration=2.0, speed=1.0)
    with pytest.raises(UsageError, match="there is no output 'X'"):
        solved("crank-slider", acceleration=2.0, speed=1.0, end=0.3, output="X")
    with pytest.raises(NoSolutionError, match="to the other side"):
        solved("hydraulic-lift", speed=0.04, acceleration=0.02, end=0.1, sense=-1)
