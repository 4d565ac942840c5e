"""What the optimal design tells beside its sizes: offset, pressure angles, torques, the section; far sizes, or none."""

from __future__ import annotations

from dataclasses import replace
from math import degrees, radians

import numpy as np
import pytest
from sparing import sparing

import tmmcalc
from cams.optimum_scene import roller_task, turn
from tmmcalc.cams.facts.cam_optimum import document as optimum_document
from tmmcalc.cams.facts.cam_optimum import summary as optimum_summary
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.margins import judge
from tmmcalc.cams.optimum.options import with_law
from tmmcalc.cams.optimum.scene import Scene, scene_of
from tmmcalc.cams.optimum.solve import solve_optimum
from tmmcalc.cams.optimum.wholesteps import search
from tmmcalc.cams.pressure.angle import reached
from tmmcalc.cams.task import AngleLimits, Asked, CamTask, Optimum, Spring
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.report.plaintext import lines

ROLLER = Follower("translating", 0.06)


def far_task(step: float = 1e-3) -> CamTask:
    """Rise and return of 5 deg, so that y'' is 13 m and no concave part suits the tool below S0 = 0.8 m."""
    given = roller_task(spring=Spring("safety"))
    assert given.loads is not None
    return replace(
        given,
        program=turn(LAWS["cosine"], 0.02, 5, 0),
        loads=replace(given.loads, speed=3.0),
        limits=AngleLimits(radians(30), None, concave=0.075),
        guide=replace(given.guide, stem=0.004),
        requirements=replace(given.requirements, width=0.008, span=None, deflection=None),
        optimum=Optimum(step=step, height_step=step),
    )


@pytest.mark.slow
def test_sizes_far_beyond_the_stroke_are_found() -> None:
    """More than twenty strokes away; the least by steps is the least by sizes, a step above it at most."""
    task = far_task(4e-3)
    scene = scene_of(task, ROLLER)
    found, _ = search(scene, Optimum(step=4e-3, height_step=4e-3))
    assert found is not None
    assert found.start[found.best] > 20 * 0.02
    assert np.min(found.margin) >= -1e-12
    result = solve_optimum(task, ROLLER)
    assert result.least.height == pytest.approx(0.87835, abs=1e-5)
    assert result.least.height <= found.height
    side = np.linspace(0.4, 0.95, 56)
    start, roller = (each.ravel() for each in np.meshgrid(side, np.linspace(2e-3, 0.03, 29)))
    for top in (0.6, 0.7, 0.8, 0.87):
        assert np.all(np.min(judge(scene, start, roller, np.full(len(start), top)).margin, axis=0) < 0)


def test_sizes_too_far_for_the_steps_are_named() -> None:
    """Everything that keeps the constraints is told, with what to change."""
    task = far_task(1e-4)
    with pytest.raises(NoSolutionError) as refused:
        solve_optimum(task, ROLLER)
    assert "with S0 up to 400 mm" in refused.value.message
    assert "all are kept far out, at S0 = " in refused.value.message
    assert "step above 0.1 mm" in (refused.value.remedy or "")


@pytest.mark.slow
def test_a_roller_that_slips_everywhere_is_refused_soon() -> None:
    """Every step point is looked at once, however far the search goes."""
    from tmmcalc.cams.optimum import slipbounds, wholesteps

    seen: list[int] = []
    own = slipbounds.may_roll

    def counted(scene: Scene, start: Values, *rest: Values) -> Mask:
        seen.append(len(start))
        return own(scene, start, *rest)

    given = roller_task(0.0, spring=Spring("safety"))
    assert given.loads is not None
    task = replace(given, loads=replace(given.loads, mass=1e-6))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(wholesteps, "may_roll", counted)
        found, known = search(scene_of(task, ROLLER), Optimum(step=4e-3, height_step=4e-3))
    assert found is None
    assert 0 < sum(seen) <= len(known.start)


@sparing("offset", [0.006, -0.004], every=2)
@sparing("sense", [1, -1], every=2)
def test_the_offset_is_told(offset: float, sense: int) -> None:
    """In the user's sense, and with a note where the synthesis found it."""
    follower = Follower("translating", 0.06, sense * offset, sense=sense)
    for own in (offset, None):
        task = replace(roller_task(), asked=Asked("translating", sense=sense, offset=own))
        result = solve_optimum(task, follower)
        assert result.offset == pytest.approx(offset)
        told = [note for note in result.notes if "that of the synthesis" in note]
        assert len(told) == (own is None)
        assert all(f"e = {1e3 * offset:g} mm" in note for note in told)
        for document in (optimum_document(result, ""), optimum_summary(result, "")):
            fact = next(fact for fact in document.facts if fact.label == "offset")
            assert fact.values["e[m]"] == pytest.approx(offset)


def test_pressure_angles_are_told_beside_their_limits() -> None:
    follower = replace(ROLLER, offset=-0.004)
    for limit in (radians(30), radians(10)):
        task = replace(roller_task(), limits=replace(roller_task().limits, rise=limit, back=limit))
        result = solve_optimum(task, follower)
        sized = replace(follower, start=result.chosen.start, roller=result.chosen.roller)
        rise, back = (abs(on.worst.value) for on in reached(task, sized))
        assert result.theta == pytest.approx((rise, back))
        notes = [note for note in result.notes if "none of the constraints" in note]
        assert len(notes) == (rise > limit) + (back > limit)
        assert all(f"the {degrees(limit):.5g} deg of [cam.limits]" in note for note in notes)


@pytest.mark.slow
@sparing("law", ["cosine", "shun"], every=2)
def test_torques_of_the_design_game_are_those_of_the_forces(law: str) -> None:
    """|T| of both signs without friction, and the largest driving torque with it, between the nodes too."""
    task = with_law(roller_task(spring=Spring("safety", safety=1.5), laws=("sine",)), law)
    result = solve_optimum(task, ROLLER)
    first = result.options[0]
    sized = Follower("translating", first.start, roller=first.roller)
    forces = solve_forces(replace(task, guide=replace(task.guide, top=first.height)), sized)
    assert first.torque == pytest.approx(forces.extreme("T").size, rel=1e-9)
    assert first.driving == pytest.approx(forces.extreme("M_drive").largest, rel=1e-9)
    said = "\n".join(lines(optimum_document(result, "")))
    assert "T_max" in said
    assert "M_drive" in said


def test_the_section_has_its_limits_and_the_chosen_radius_among_its_points() -> None:
    """So that a picture's marks and labels are those of the table."""
    result = solve_optimum(roller_task(), ROLLER)
    section, chosen = result.section, result.chosen
    assert section is not None
    assert section.edge_limit is not None
    assert section.stress_limit is not None
    assert np.all(np.diff(section.roller) >= 0)
    for values, limit in ((section.edge, section.edge_limit), (section.stress, section.stress_limit)):
        assert np.min(np.abs(values / limit - 1)) < 1e-12
    at = int(np.argmin(np.abs(section.roller - chosen.roller)))
    checks = {each.number: each.value for each in chosen.checks}
    assert section.roller[at] == chosen.roller
    assert section.stress[at] == pytest.approx(checks[9], rel=1e-12)
    assert checks[8] is not None
    assert section.edge[at] == pytest.approx(checks[8] * section.edge_limit / 5e6, rel=1e-12)


def test_the_spec_without_an_offset_says_which_one_is_taken() -> None:
    text = """[cam]
follower = "translating"
stroke = "20 mm"
rise = "60 deg"
high_dwell = "30 deg"
return_angle = "60 deg"
law = "cosine"
speed = "100 rad/s"
[cam.loads]
mass = "0.2 kg"
[cam.spring]
stiffness = "9.5 N/mm"
preload = "10 N"
[cam.guide]
stem_radius = "3.5 mm"
land = "4 mm"
[cam.requirements]
width = "7 mm"
contact = "400 MPa"
guide_pressure = "5 MPa"
[cam.optimum]
phases = "rise"
"""
    spec = tmmcalc.parse_spec(text)
    result, found = tmmcalc.solve_cam_optimum(spec), tmmcalc.solve_cam_synthesis(spec).follower
    assert result.offset == pytest.approx(found.sense * found.offset)
    assert any("that of the synthesis" in note for note in result.notes)
    assert any("pressure angle of the return" in note for note in result.notes) == (found.offset == 0)
