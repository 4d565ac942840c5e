"""Random groups of class III and IV under changes that keep the motion, or change it in a known way."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from transforms import moved, renumbered, scaled, with_axes

import tmmcalc
from linkage.loops.groups import CLASS_III, CLASS_IV, drawn, scene
from tmmcalc import Grid, Input, Kinematics, Mechanism
from tmmcalc.core.plane import Plane
from tmmcalc.linkage.structure import solve_structure

pytestmark = pytest.mark.slow

EXAMPLES = settings(derandomize=True, deadline=None, max_examples=5, database=None)
SPAN = 0.05


@st.composite
def mechanisms(draw: st.DrawFn) -> Mechanism:
    """One higher group, a few of its pairs prismatic, over a short range from where its metric was read."""
    graph, seed = draw(st.sampled_from([CLASS_III, CLASS_IV])), draw(st.integers(0, 40))
    prismatic = drawn(np.random.default_rng(seed), graph, draw(st.integers(0, 2)))
    mechanism = replace(scene(seed, graph, prismatic)[0], grid=Grid(positions=3, span=SPAN))
    return (
        mechanism
        if len(solve_structure(mechanism).groups) == 1
        else replace(scene(seed, graph)[0], grid=mechanism.grid)
    )


def solved(mechanism: Mechanism) -> Kinematics | None:
    """The mechanism unless it comes to a limit in the range, or near one."""
    try:
        result = tmmcalc.solve_kinematics(mechanism)
    except (tmmcalc.AssemblyError, tmmcalc.SingularityError):
        return None
    return result if max(quality.amplification for quality in result.qualities) < 20 else None


def place(result: Kinematics, name: str) -> Plane:
    return result.trace.r[result.trace.point_names.index(name)]


def same_places(found: Kinematics, expected: Plane, names: tuple[str, ...], tolerance: float) -> None:
    rows = [found.trace.point_names.index(name) for name in names]
    np.testing.assert_allclose(found.trace.r[rows], expected, rtol=0, atol=tolerance)


@given(mechanisms())
@EXAMPLES
def test_links_are_rigid_and_pins_stay_closed(mechanism: Mechanism) -> None:
    """A link's origin Q and its point P keep their distance, and every pin is one place of both its links."""
    result = solved(mechanism)
    if result is None:
        return
    angles = dict(zip(result.trace.link_ids, result.trace.angle, strict=True))

    def at(k: int, p: complex) -> Plane:
        return place(result, f"Q{k}") + p * np.exp(1j * angles[k]) if k else np.full(len(result.x), p)

    for link in mechanism.links:
        for one, other in combinations(link.points, 2):
            length = abs(link.points[one] - link.points[other])
            assert np.abs(place(result, one) - place(result, other)) == pytest.approx(length, abs=1e-12)
    for joint in mechanism.joints:
        (a, b), (p, q) = joint.links, joint.points
        if joint.kind == "revolute":
            assert at(a, p) == pytest.approx(at(b, q), abs=1e-11)
        else:
            line = joint.directions[1] * np.exp(1j * angles.get(b, 0.0))
            s = result.trace.s[result.trace.joint_names.index(joint.name)]
            assert at(a, p) - at(b, q) == pytest.approx(s * line, abs=1e-11)


@given(mechanisms(), st.permutations(range(2, 6)), st.integers(0, 99))
@EXAMPLES
def test_numbers_names_and_their_order_do_not_matter(mechanism: Mechanism, numbers: list[int], seed: int) -> None:
    result = solved(mechanism)
    if result is None:
        return
    names = {joint.name: f"j{k}" for k, joint in enumerate(reversed(mechanism.joints))}
    other = renumbered(mechanism, dict(zip(range(2, 6), numbers, strict=True)), names, np.random.default_rng(seed))
    same_places(tmmcalc.solve_kinematics(other), result.trace.r, result.trace.point_names, 1e-11)


@given(mechanisms(), st.sampled_from([1e-6, 1e-3, 1e3, 1e6]))
@EXAMPLES
def test_the_unit_of_length_does_not_matter(mechanism: Mechanism, factor: float) -> None:
    result = solved(mechanism)
    if result is None:
        return
    other = tmmcalc.solve_kinematics(scaled(mechanism, factor))
    same_places(other, result.trace.r * factor, result.trace.point_names, 1e-11 * factor)
    np.testing.assert_allclose(other.trace.ddangle, result.trace.ddangle, rtol=1e-8, atol=1e-8)


@given(mechanisms(), st.floats(-3, 3), st.integers(2, 5))
@EXAMPLES
def test_axes_do_not_matter(mechanism: Mechanism, turn: float, link: int) -> None:
    """The whole turned and shifted in the plane; the axes of one link laid otherwise."""
    result = solved(mechanism)
    if result is None:
        return
    names = result.trace.point_names
    laid = with_axes(mechanism, link, 0.2 - 0.7j, turn)
    same_places(tmmcalc.solve_kinematics(laid), result.trace.r, names, 1e-11)
    shifted = moved(mechanism, turn, 2 - 1j)
    expected = result.trace.r * np.exp(1j * turn) + (2 - 1j)
    same_places(tmmcalc.solve_kinematics(shifted), expected, names, 1e-10)


@given(mechanisms())
@EXAMPLES
def test_a_crank_that_turns_the_other_way_passes_the_same_positions(mechanism: Mechanism) -> None:
    """Backwards from the end of the range to its start, on the branch that was chosen there."""
    result = solved(mechanism)
    if result is None:
        return
    start = mechanism.input.start
    assert start is not None
    back = replace(
        mechanism,
        input=Input("01", -mechanism.input.speed, start=start + SPAN),
        assembly=replace(mechanism.assembly, at=start),
    )
    other = tmmcalc.solve_kinematics(back)
    same_places(other, result.trace.r[:, ::-1], result.trace.point_names, 1e-11)
    np.testing.assert_allclose(other.trace.dangle[:, ::-1], result.trace.dangle, rtol=1e-9, atol=1e-9)
