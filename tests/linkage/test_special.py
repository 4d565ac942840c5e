"""Special points of groups of class III and IV: the plan of velocities begins with them, as on paper."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from linkage.scenes import CONFIGS, full_turn, shaper, with_input
from tmmcalc import load_spec, solve_kinematics
from tmmcalc.core.plane import cross
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.facts.polygons import polygons_document
from tmmcalc.linkage.further import further_columns
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.polygons import polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.segments import longest
from tmmcalc.linkage.special import Special, SpecialPoints, special_points
from tmmcalc.linkage.structure import solve_structure
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.numbers import round_scale

THREE, SLIDER, FOUR = "class-three", "class-three-slider", "class-four"


def solved(name: str, **changes: float) -> tuple[Mechanism, Kinematics]:
    mechanism = to_linkage(load_spec(CONFIGS / f"{name}.toml").linkage)
    if changes:
        mechanism = with_input(mechanism, **changes)
    return mechanism, solve_kinematics(mechanism)


def dot(a: Any, b: Any) -> Any:
    return (np.conj(a) * b).real


class Motion:
    """Places, velocities and accelerations of points of links over the positions, in time."""

    def __init__(self, mechanism: Mechanism, result: Kinematics) -> None:
        self.result, self.motions = result, chain_of(mechanism, result).evaluate(result.x).motions

    def point(self, link: int, p: complex) -> tuple[Any, Any, Any]:
        at = self.motions[link].point(p)
        return at.r, *self.result.in_time(at.v, at.a)

    def turning(self, link: int) -> tuple[Any, Any]:
        motion = self.motions[link]
        return self.result.in_time(motion.omega, motion.eps)


def joint_on(special: Special, k: int, *, near: bool) -> tuple[int, complex, str]:
    """Of leg k the pair with the basic link, or the other one: the link beyond the leg, its point there, its kind."""
    leg = special.legs[k]
    joint = leg.near if near else leg.far
    beyond = joint.other(leg.link)
    return beyond, joint.points[joint.links.index(beyond)], joint.kind


@pytest.mark.parametrize("name", [THREE, SLIDER, FOUR])
def test_the_plan_begins_with_the_special_point(name: str) -> None:
    """Of S both components are those of the far pins of its legs, whatever the basic link does."""
    mechanism, result = solved(name)
    motion, found = Motion(mechanism, result), SpecialPoints(mechanism, result)
    assert found.points
    for special in found.points:
        place, velocity, _ = found.state(special)
        for k in (0, 1):
            near, _, _ = motion.point(*joint_on(special, k, near=True)[:2])
            beyond, p, kind = joint_on(special, k, near=False)
            if kind == "prismatic":  # the slider's guide is of the frame: nothing moves across it
                joint = special.legs[k].far
                along = 1j * mechanism.joint(joint.name).directions[1] * np.ones(len(result.x))
                known = np.zeros(len(result.x))
            else:
                far, given, _ = motion.point(beyond, p)
                along = (near - far) / np.abs(near - far)
                known = dot(along, given)
            size = np.max(np.abs(place)) * 1e-9
            np.testing.assert_allclose(cross(along, place - near), 0.0, atol=size)
            np.testing.assert_allclose(dot(along, velocity), known, atol=1e-9 * np.nanmax(np.abs(velocity)))


@pytest.mark.parametrize("name", [THREE, SLIDER])
def test_the_third_leg_gives_the_turning_of_the_plate(name: str) -> None:
    """The whole graphical solution: v_S of two legs from pins outside the group, then omega of the plate of the third.

    Nothing of the group's own velocities is used; those of the program are what comes out.
    """
    mechanism, result = solved(name)
    motion = Motion(mechanism, result)
    special = next(each for each in special_points(mechanism, result.structure) if each.name == "W3_2_4")
    lines = []
    for k in (0, 1):
        near, _, _ = motion.point(*joint_on(special, k, near=True)[:2])
        far, given, _ = motion.point(*joint_on(special, k, near=False)[:2])
        e = (near - far) / np.abs(near - far)
        lines.append((near, e, dot(e, given)))
    (p, e, u), (q, f, w) = lines
    sine = cross(e, f)
    place = p + cross(q - p, f) / sine * e
    velocity = (u * -1j * f - w * -1j * e) / sine  # the vector with these components along e and f
    np.testing.assert_allclose(dot(e, velocity), u, atol=1e-10)
    np.testing.assert_allclose(dot(f, velocity), w, atol=1e-10)
    third = next(each for each in special_points(mechanism, result.structure) if each.name == "W3_2_5")
    near, _, _ = motion.point(*joint_on(third, 1, near=True)[:2])
    beyond, at, kind = joint_on(third, 1, near=False)
    if kind == "prismatic":
        g, known = 1j * third.legs[1].far.directions[1], 0.0
    else:
        far, given, _ = motion.point(beyond, at)
        g = (near - far) / np.abs(near - far)
        known = dot(g, given)
    omega = (known - dot(g, velocity)) / dot(g, 1j * (near - place))
    np.testing.assert_allclose(omega, motion.turning(3)[0], rtol=1e-8, atol=1e-9)
    found = SpecialPoints(mechanism, result).state(special)
    np.testing.assert_allclose(found[0], place, rtol=1e-9)
    np.testing.assert_allclose(found[1], velocity, atol=1e-9 * np.max(np.abs(velocity)))


def test_acceleration_along_the_legs() -> None:
    """a_S . e = a_F . e - omega_k^2 l_k - omega_3^2 (S - P) . e of every leg with two pins; under acceleration, too."""
    mechanism, result = solved(THREE, acceleration=4.0)
    motion, found = Motion(mechanism, result), SpecialPoints(mechanism, result)
    assert len(found.points) == 3
    for special in found.points:
        place, _, acceleration = found.state(special)
        for k in (0, 1):
            near, _, _ = motion.point(*joint_on(special, k, near=True)[:2])
            far, _, given = motion.point(*joint_on(special, k, near=False)[:2])
            e = (near - far) / np.abs(near - far)
            own, basic = motion.turning(special.legs[k].link)[0], motion.turning(special.link)[0]
            known = dot(e, given) - own**2 * np.abs(near - far) - basic**2 * dot(e, place - near)
            np.testing.assert_allclose(dot(e, acceleration), known, atol=1e-9 * np.max(np.abs(acceleration)))


def test_between_two_basic_links_both_points_have_one_velocity() -> None:
    mechanism, result = solved(FOUR)
    found = SpecialPoints(mechanism, result)
    assert [each.name for each in found.points] == ["W2_3_4", "W5_3_4"]
    (here, v, a), (there, w, b) = map(found.state, found.points)
    np.testing.assert_allclose(here, there, rtol=1e-12)
    np.testing.assert_allclose(v, w, rtol=1e-8, atol=1e-9)
    assert np.max(np.abs(a - b)) > 1.0


def test_two_legs_about_the_frame_make_a_pole() -> None:
    """The point of the plate on the lines of both rockers stands still, to the last digit."""
    mechanism, result = solved(THREE)
    pole = next(each for each in special_points(mechanism, result.structure) if each.name == "W3_4_5")
    assert np.all(SpecialPoints(mechanism, result).state(pole)[1] == 0)


def test_parallel_lines_have_no_special_point() -> None:
    """Two lines that are one meet nowhere: no number stands there."""
    mechanism, result = solved(THREE)
    found = SpecialPoints(mechanism, result)
    leg = found.points[2].legs[0]
    assert np.all(np.isnan(found.state(Special(3, (leg, leg)))[0]))


def test_none_in_mechanisms_of_dyads() -> None:
    assert special_points(shaper(), solve_structure(shaper())) == ()
    mechanism = full_turn(shaper())
    assert not [c.name for c in further_columns(mechanism, solve_kinematics(mechanism)) if "_W" in c.name]


def test_columns_and_plans() -> None:
    mechanism, result = solved(THREE)
    found = {c.name: c for c in further_columns(mechanism, result)}
    bare = {c.name: c for c in further_columns(mechanism, result, dimensionless=True)}
    assert found["vx_W3_2_4"].unit == "m/s"
    crank, speed = result.crank_length, result.speed
    assert crank is not None
    np.testing.assert_allclose(bare["vy_W3_2_4"].make() * crank * speed, found["vy_W3_2_4"].make(), rtol=1e-12)
    np.testing.assert_allclose(bare["ax_W3_2_5"].make() * crank * speed**2, found["ax_W3_2_5"].make(), rtol=1e-12)
    plan = polygons(mechanism, result, 4, special=True)
    for name, letter in (("velocity", "v"), ("acceleration", "a")):
        vertex = getattr(plan, name).vertices["w3_2_4"]
        columns = (found[f"{letter}{axis}_W3_2_4"].make()[4] for axis in "xy")
        assert vertex == pytest.approx(complex(*columns), rel=1e-11)
    assert "w3_2_4" not in polygons(mechanism, result, 4).velocity.vertices
    document = polygons_document(mechanism, result, "plans", [4])
    assert document.table is not None
    kinds = list(document.table.columns[list(document.table.headers).index("kind")])
    assert kinds.count("special") == 18  # three points from the pole and from the pins of two legs, in both plans


def test_the_scale_of_the_plans_stays() -> None:
    """A special point may lie far away, here 65 m: it does not make the rest small."""
    mechanism, result = solved(SLIDER)
    plain, whole = polygons(mechanism, result, 4), polygons(mechanism, result, 4, special=True)
    assert longest([plain]) == longest([whole])
    assert abs(whole.acceleration.vertices["w3_4_5"]) > 10 * longest([plain])[1]
    told = polygons_document(mechanism, result, "plans", [4]).facts[0].values
    assert told["mu_a[m/s^2/mm]"] == round_scale(longest([plain])[1] / 100)
