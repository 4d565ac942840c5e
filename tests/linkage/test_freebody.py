"""Free bodies: each is in equilibrium by itself, whatever the method that found its reactions; names; worked cases."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from loaded import DEG, anything, press, ready, statics
from ready import LINKAGES
from sparing import sparing

from tmmcalc.linkage.forces.kinetostatics import compile_statics
from tmmcalc.linkage.freebody import Acting, FreeBody, cleared, free_bodies
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.loading import Body, GearDrive, Load, Loading
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loads.scene import compile_scene

CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[1] / "cases" / "dynamics.json").read_text())}


def named(body: FreeBody) -> dict[str, Acting]:
    return {f"{force.letter}{force.index}": force for force in body.forces}


def test_a_force_polygon_that_does_not_close_is_seen() -> None:
    body = free_bodies(statics(*press()[:2]), 1.0, 1.0)[1]
    broken = replace(body, forces=body.forces[1:])
    assert abs(broken.vertices[-1]) > 100


@pytest.mark.parametrize("side", [1.0, -1.0])
@sparing("name", LINKAGES, every=8)
def test_every_body_is_in_equilibrium(name: str, side: float) -> None:
    mechanism = ready(name)
    scene = statics(mechanism, anything(mechanism))
    for theta in np.array([0.0, 0.31, 0.77]) * scene.scene.travel.period:
        bodies = free_bodies(scene, float(theta), side)
        assert sorted(k for body in bodies for k in body.links) == sorted(link.id for link in mechanism.links)
        for body in bodies:
            size = max(abs(force.value) for force in body.forces)
            arm = max(abs(force.at) for force in body.forces)
            moments = [(np.conj(f.at) * f.value).imag for f in body.forces] + [c.value for c in body.couples]
            assert abs(body.vertices[-1]) < 1e-12 * size
            assert abs(sum(moments)) < 1e-11 * size * (1 + arm)


@sparing("name", LINKAGES, every=4)
def test_the_inner_reaction_is_a_chord(name: str) -> None:
    """The forces of link a and the reaction of b on it balance, and so do those of link b."""
    mechanism = ready(name)
    for body in free_bodies(statics(mechanism, anything(mechanism)), 0.5, 1.0)[1:]:
        if body.inner is None:  # a link of a higher group is a body of its own
            assert len(body.links) == 1
            continue
        chord = body.vertices[body.parting] - body.vertices[body.closing]
        assert abs(chord - body.inner.value) < 1e-11 * np.max(np.abs(body.vertices))
        a, b = body.links
        assert body.inner.link == b
        own = sum(force.value for force in body.forces if force.link == b)
        assert abs(own + body.inner.value) < 1e-11 * np.max(np.abs(body.vertices))
        assert {force.link for force in body.forces} <= {a, b}


@pytest.mark.parametrize("i", range(1, 12))
def test_names_and_values_of_the_press(i: int) -> None:
    """Textbook appendix 3: R21 along and across the rod, R32, R30; weights, arms."""
    expected = CASES["dyn-press-ideal"]["expected"]
    mechanism, loading, _ = press(friction=False)
    crank, group = free_bodies(statics(mechanism, loading), i * 30 * DEG, 1.0)
    forces = named(group)
    assert group.name == "RRP(2,3)"
    assert {"R21", "N30", "G2", "G3", "P2"} <= set(forces)
    assert forces["N30"].value == pytest.approx(1j * expected["R30"][i], abs=1e-3)
    assert group.inner is not None
    assert group.inner.value == pytest.approx(complex(expected["R32x"][i], expected["R32y"][i]), abs=1e-3)
    assert forces["G2"].value == pytest.approx(-9.81j * 12)
    (moment,) = [couple for couple in crank.couples if couple.kind == "drive"]
    assert moment.value == pytest.approx(expected["M_bal"][i], abs=1e-3)
    assert named(crank)["R12"].value == pytest.approx(-forces["R21"].value)


def test_both_limits_where_friction_jumps() -> None:
    """dyn-press-friction: at 270 degrees the case gives the left limit, and the right one beside it."""
    case = CASES["dyn-press-friction"]["expected"]
    scene = statics(*press()[:2])
    before, after = (named(free_bodies(scene, 270 * DEG, side)[1]) for side in (-1.0, 1.0))
    assert before["N30"].value.imag == pytest.approx(case["R30"][9], rel=1e-5)
    assert after["N30"].value.imag == pytest.approx(case["alternative_side_at_i9"]["R30"], rel=1e-4)
    assert before["F30"].value.real == pytest.approx(case["F30"][9], rel=1e-5)


def test_a_normal_force_has_its_arm_unless_that_is_far_off() -> None:
    """Row 6 of dyn-press-friction has a small arm; in row 11 it would leave the slider's reach: a couple."""
    case = CASES["dyn-press-friction"]["expected"]
    scene = statics(*press()[:2])
    small, far = (free_bodies(scene, i * 30 * DEG, 1.0)[1] for i in (6, 11))
    force = named(small)["N30"]
    assert force.arm == pytest.approx(case["h_mm"][6] / 1e3, rel=1e-4)
    slider = 0.168 - 0.0375  # B at 180 degrees
    assert force.at == pytest.approx(slider + force.arm, abs=1e-12)
    assert named(far)["N30"].arm is None
    (couple,) = [c for c in far.couples if c.joint == "B0"]
    assert couple.value / named(far)["N30"].value.imag == pytest.approx(case["h_mm"][11] / 1e3, rel=1e-4)


def test_the_mesh_force_acts_at_the_pitch_point() -> None:
    """dyn-gear-driven-crank: position 10 of the frictionless press."""
    case = CASES["dyn-gear-driven-crank"]["expected"]
    mechanism, loading, _ = press(friction=False)
    gear = GearDrive(0.12, 20 * DEG, -90 * DEG)
    crank = free_bodies(statics(mechanism, replace(loading, drive=gear)), 300 * DEG, 1.0)[0]
    mesh = named(crank)["Fmesh"]
    assert mesh.at == pytest.approx(-0.12j, abs=1e-15)
    assert mesh.value == pytest.approx(complex(case["R_bal_x"], case["R_bal_y"]), rel=1e-4)
    assert not crank.couples


def test_a_driven_slider_is_pushed_along_its_guide() -> None:
    mechanism = ready("hydraulic-lift")
    crank = free_bodies(statics(mechanism, anything(mechanism)), 0.1, 1.0)[0]
    joint = mechanism.joint(mechanism.input.joint)
    push = named(crank)["Fd"]
    assert abs((push.value / joint.directions[1]).imag) < 1e-12 * abs(push.value)


def test_a_moment_stands_in_the_middle_of_its_link() -> None:
    mechanism = ready("four-bar")
    loading = Loading(loads=(Load("T", 3, "moment", Constant(-40.0)),))
    scene = compile_statics(compile_scene(mechanism, loading, solve_kinematics(mechanism)))
    body = free_bodies(scene, 0.0, 1.0)[1]
    (couple,) = body.couples
    pins = [force.at for force in body.forces if force.link == 3] + [body.inner.at]
    assert (couple.letter, couple.value) == ("T", -40.0)
    assert couple.at == pytest.approx(sum(pins) / 2)


def test_two_figures_of_a_link_keep_apart_in_an_index() -> None:
    mechanism = ready("four-bar")
    links = tuple(replace(link, id=10 if link.id == 3 else link.id) for link in mechanism.links)
    joints = tuple(replace(j, links=tuple(10 if k == 3 else k for k in j.links)) for j in mechanism.joints)
    renamed = replace(mechanism, links=links, joints=joints, outputs=())
    renamed = replace(renamed, assembly=replace(mechanism.assembly, variants={(2, 10): 1}))
    loading = Loading((Body(10, 5.0, 0.0, 0.1 + 0j),), -9.81j)
    body = free_bodies(statics(renamed, loading), 0.4, 1.0)[1]
    assert {"R10,0", "R21"} <= set(named(body))


def test_what_is_small_can_be_left_out() -> None:
    bodies = free_bodies(statics(*press()[:2]), 330 * DEG, 1.0)
    fewer = cleared(bodies, 0.05)
    largest = max(abs(force.value) for body in bodies for force in body.forces)
    for whole, left in zip(bodies, fewer, strict=True):
        assert all(abs(force.value) > 0.05 * largest for force in left.forces)
        assert len(left.forces) == sum(abs(force.value) > 0.05 * largest for force in whole.forces)
        assert left.parting <= left.closing <= len(left.forces)
    assert len(fewer[1].forces) < len(bodies[1].forces)
