"""What a page moves of linkages: points where the stages have them, over the cycle, the time, of what was found."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Grid
from tmmcalc.linkage.tables.tasks.loading import to_loading
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


@sparing("name", ["synth-motion", "synth-path", "synth-crank-rocker", "synth-dwell"], every=4, first=2)
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


@pytest.mark.parametrize(
    "name", ["shaper", "geared-press", "hydraulic-lift", "four-stroke-engine", "piston-pump", "elastic-drive"]
)
def test_applied_forces_hold_the_reactions(name: str) -> None:
    """On every link at every place, both limits of jumps too, they sum up to nothing with what the pairs bear."""
    from tmmcalc.linkage.acting import sides
    from tmmcalc.linkage.forces.rows import Rows
    from tmmcalc.linkage.freebody import solved
    from tmmcalc.linkage.views.applied import applied

    spec = loaded(name)
    found = run(spec, target=["forces"]).results
    mechanism, forces = to_linkage(spec.linkage), found["forces"]
    view = Cycle(mechanism, found["kinematics"], forces, spec).view()
    layers = [each for each in view.layers if each.name in ("given", "inertia")]
    rows = Rows(mechanism, to_loading(spec), found["kinematics"], forces)
    every = [*applied(solved(rows.statics, forces.theta, rows.side))]
    bodies = {body.name: body for body in view.bodies}
    assert all(layer.hidden for layer in layers)
    every.sort(key=lambda force: force.kind == "inertia")
    for vector, force in zip((each for layer in layers for each in layer.vectors), every, strict=True):
        np.testing.assert_array_equal(vector.x.values + 1j * vector.y.values, force.value)
        np.testing.assert_allclose(vector.places, forces.phi / (math.pi / 180 if forces.turns else 1.0))
        assert bodies[vector.body].on in {str(force.link), "", *(str(link.id) for link in mechanism.links)}
    for link in (each.id for each in mechanism.links):
        total = sum(
            (force.value for force in every if force.link == link), start=np.zeros(len(forces.theta), np.complex128)
        )
        for joint, reaction in zip(mechanism.joints, forces.reaction, strict=True):
            if link in joint.links:
                total = total + sides(joint, link)[0] * reaction
        assert np.abs(total).max() <= 1e-9 * np.abs(forces.reaction).max()


def test_applied_forces_stand_at_their_points() -> None:
    """Weights and forces of inertia at the centres of mass, whatever the link does."""
    spec = loaded("shaper")
    found = run(spec, target=["forces"]).results
    view = Cycle(to_linkage(spec.linkage), found["kinematics"], found["forces"], spec).view()
    bodies = {body.name: body for body in view.bodies}
    centres = {str(body.link): body.center for body in to_loading(spec).bodies}
    shown = [each for layer in view.layers if layer.name in ("given", "inertia") for each in layer.vectors]
    heavy = [each for each in shown if each.sign[0] in "GP"]
    assert len(heavy) >= 4
    for vector in heavy:
        x, y, angle = bodies[vector.body][1:4]
        assert not angle.values.any()
        assert bodies[vector.body].on == vector.sign[3:-1]
        assert x.values[0] + 1j * y.values[0] == pytest.approx(centres[bodies[vector.body].on])
