"""What a page moves of linkages: points where the stages have them, over the cycle, the time, of what was found."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Grid
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.linkage.views.kinematics import Cycle
from tmmcalc.pipeline.picturing import order_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.moving import View

from .scenes import four_bar

CONFIGS = Path(__file__).parents[2] / "configs"
DRIVEN = ("scissor-lift", "tipper", "crane-luffing", "hydraulic-lift")


def loaded(name: str) -> Any:
    return load_spec(CONFIGS / f"{name}.toml")


def paths(view: View) -> dict[str, Any]:
    """Where all named points go, and how fast."""
    bodies = {body.name: body for body in view.bodies}
    found = {}
    for spot in view.spots:
        if not spot.body:
            continue
        x, y, angle = bodies[spot.body][1:4]
        turned = spot.at * np.exp(1j * angle.values)
        found[spot.name] = (x.values + 1j * y.values + turned, x.rates + 1j * y.rates + 1j * angle.rates * turned)
    return found


@pytest.mark.parametrize("name", DRIVEN)
def test_driven_lengths_move_all_points(name: str) -> None:
    spec = loaded(name)
    mechanism = to_linkage(spec.linkage)
    result = solve_kinematics(mechanism)
    view = Cycle(mechanism, result).view()
    assert view.column == "phi[m]"
    assert not view.whole
    seen = paths(view)
    for point, at, rate in zip(result.trace.point_names, result.trace.r, result.trace.dr, strict=True):
        if point in seen:
            np.testing.assert_allclose(seen[point][0], at, atol=1e-9)
            np.testing.assert_allclose(seen[point][1], rate, atol=1e-9)
    low, high = view.reach[0]
    assert low <= view.values.min()
    assert view.values.max() <= high


@pytest.mark.parametrize("name", ["tipper", "crane-luffing"])
def test_unsteady_motion_over_the_time(name: str) -> None:
    from tmmcalc.linkage.views.unsteady import views

    spec = loaded(name)
    found = run(spec, target=["unsteady"]).results
    (view,) = views(order_of(spec, found))
    result = found["unsteady"]
    seen = paths(view)
    np.testing.assert_array_equal(view.values, result.t)
    for point, at, rate in zip(result.trace.point_names, result.trace.r, result.trace.dr, strict=True):
        if point in seen:
            np.testing.assert_allclose(seen[point][0], at, atol=1e-9)
            np.testing.assert_allclose(seen[point][1], rate, atol=1e-9)


@pytest.mark.parametrize("name", ["synth-motion", "synth-path", "synth-crank-rocker", "synth-dwell"])
def test_a_linkage_that_was_found(name: str) -> None:
    from tmmcalc.linkage.views.synthesis import views

    spec = loaded(name)
    found = run(spec, target=["synthesis"]).results
    (view,) = views(order_of(spec, found))
    precision = found["synthesis"].designs[0].precision
    wanted = [mark.points[0] for mark in view.frame if mark.kind == "cross"]
    if precision is None:
        return
    coupler = paths(view)["P"][0]
    assert set(precision.points.tolist()) <= set(wanted)
    size = max(np.ptp(coupler.real), np.ptp(coupler.imag))
    largest = float(np.max(np.abs(precision.points - precision.reached)))
    for point in precision.points:
        assert np.min(np.abs(coupler - point)) < largest + 0.02 * size


def test_no_second_view_where_the_scene_goes_on_with_it() -> None:
    from tmmcalc.linkage.views.synthesis import views

    assert [*views(order_of(loaded("shaper"), {"kinematics": None, "synthesis": None}))] == []


def test_where_a_rocker_is_driven_it_tells_its_reach() -> None:
    mechanism = four_bar(0.4, 0.3, 0.25, 0.5 + 0j)
    part = replace(mechanism, grid=Grid(positions=8, span=0.2), input=replace(mechanism.input, start=0.3))
    view = Cycle(part, solve_kinematics(part)).view()
    assert view.reach
    assert any(low <= 0 <= high for low, high in view.reach)
    inside, outside = np.degrees([0.2, 2.5])
    assert any(low <= inside <= high for low, high in view.reach)
    zones = [np.array(mark.points) for mark in view.frame if mark.kind == "zone"]
    seen = np.concatenate([np.degrees(np.angle(zone[1:] / np.exp(0.3j))) % 360 for zone in zones])
    for low, high in view.reach:
        assert np.min(np.abs(seen - low % 360)) < 1e-6
        assert np.min(np.abs(seen - high % 360)) < 1e-6
    assert view.note
    assert not any(low <= outside + turn <= high for low, high in view.reach for turn in (-360, 0, 360))
