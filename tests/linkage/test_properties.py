"""Random dyads and chains of one to four dyads: against the independent solver, and under changes that keep the motion.

The reference knows nothing of groups: it solves the closure equations of all links at once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from random_mechanisms import KINDS, RandomMechanism, build, scenes
from reference import Motion, NoPositionError, Reference, solve
from transforms import moved, renumbered, scaled, swapped, with_axes

import tmmcalc
from tmmcalc import Kinematics, Method, solve_kinematics
from tmmcalc.linkage.model import Assembly, Mechanism
from tmmcalc.linkage.placing import assembled
from tmmcalc.linkage.structure import solve_structure
from tmmcalc.linkage.variants import given_variants

pytestmark = pytest.mark.slow

EXAMPLES = settings(derandomize=True, deadline=None, max_examples=100, database=None)
FEWER = settings(EXAMPLES, max_examples=60)
WORST = 25.0  # largest amplification of a scene whose numbers are compared to rounding


def regular(scene: RandomMechanism) -> tuple[Mechanism, Kinematics] | None:
    """The scene solved, unless it leaves the positions that assemble or comes near a dead point."""
    mechanism = unambiguous(scene)
    try:
        result = solve_kinematics(mechanism)
    except (tmmcalc.AssemblyError, tmmcalc.SingularityError):
        return None
    product = np.prod([quality.amplification for quality in result.qualities])
    return (mechanism, result) if product < WORST else None


def regular_scenes(kinds: Sequence[str], seeds: range) -> Iterator[tuple[int, Mechanism, Kinematics]]:
    """Those of the random scenes of these seeds that are regular, each with its seed."""
    for seed in seeds:
        found = regular(build(np.random.default_rng(seed), list(kinds)))
        if found is not None:
            yield seed, *found


def unambiguous(scene: RandomMechanism) -> Mechanism:
    """The scene with the signs of its variants in place of the sketch."""
    sketched = scene.mechanism
    chosen = signs(sketched)
    return replace(sketched, assembly=Assembly(variants=chosen)) if chosen is not None else sketched


def signs(mechanism: Mechanism) -> dict[tuple[int, int], int] | None:
    """What the sketch chooses, before anything is solved."""
    structure = solve_structure(mechanism)
    try:
        chain = assembled(mechanism, structure, given_variants(mechanism, structure))
    except tmmcalc.TmmError:
        return None
    return {
        (group.links[0], group.links[1]): step.variant
        for group, step in zip(structure.groups, chain.steps, strict=True)
        if group.kind not in ("PRP", "RPP")
    }


def by_reference(scene: RandomMechanism, x: NDArray[np.float64]) -> Reference:
    return solve(scene.mechanism, scene.start, x)


def close(found: NDArray[np.inexact], expected: NDArray[np.inexact], tolerance: float, what: str) -> None:
    scale = 1 + float(np.max(np.abs(expected), initial=0.0))
    assert np.max(np.abs(found - expected), initial=0.0) <= tolerance * scale, what


@given(scenes())
@EXAMPLES
def test_motion_agrees_with_the_closure_equations(scene: RandomMechanism) -> None:
    solved = regular(scene)
    if solved is None:
        return
    mechanism, result = solved
    reference, t = by_reference(scene, result.x), result.trace
    for k, name in enumerate(t.point_names):
        compare(reference.point(name), (t.r[k], t.dr[k], t.ddr[k]), name)
    for k, link in enumerate(t.link_ids):
        expected = reference.angles[link]
        close(np.exp(1j * t.angle[k]), np.exp(1j * expected.value), 1e-11, f"angle {link}")
        turned = t.angle[k] - t.angle[k][0]
        compare(replace(expected, value=expected.value - expected.value[0]), (turned, t.dangle[k], t.ddangle[k]), name)
    for k, name in enumerate(t.joint_names):
        compare(reference.slides[name], (t.s[k], t.ds[k], t.dds[k]), name)
    check_lengths(mechanism, result)


def compare(expected: Motion, found: tuple[NDArray[np.inexact], ...], what: str) -> None:
    close(found[0], expected.value, 1e-11, what)
    close(found[1], expected.first, 1e-9, f"first derivative of {what}")
    close(found[2], expected.second, 1e-8, f"second derivative of {what}")


def check_lengths(mechanism: Mechanism, result: Kinematics) -> None:
    """Points of one link keep their distances to 1e-12 of the size."""
    t = result.trace
    place = dict(zip(t.point_names, t.r, strict=True))
    for link in mechanism.links:
        for a, b in permutations((name for name in link.points if name in place), 2):
            length = abs(link.points[a] - link.points[b])
            np.testing.assert_allclose(np.abs(place[a] - place[b]), length, rtol=0, atol=1e-12 * (1 + length) * WORST)


@given(scenes())
@FEWER
def test_joints_stay_closed(scene: RandomMechanism) -> None:
    """Pins of both links coincide; lines of a prismatic joint coincide and the slider stands at its coordinate."""
    solved = regular(scene)
    if solved is None:
        return
    mechanism, result = solved
    t = result.trace
    angle = {link: t.angle[k] for k, link in enumerate(t.link_ids)} | {0: np.zeros(len(result.x))}
    base = {link.id: base_of(mechanism, result, link.id) for link in (mechanism.frame, *mechanism.links)}
    slides = dict(zip(t.joint_names, t.s, strict=True))

    def place(link: int, p: complex) -> NDArray[np.complex128]:
        origin, at = base[link]
        return origin + (p - at) * np.exp(1j * angle[link])

    for joint in mechanism.joints:
        first, second = (place(*pair) for pair in zip(joint.links, joint.points, strict=True))
        if joint.kind == "revolute":
            close(first, second, 1e-11, joint.name)
            continue
        slider, guide = (d * np.exp(1j * angle[k]) for d, k in zip(joint.directions, joint.links, strict=True))
        close(slider, guide, 1e-12, f"direction of {joint.name}")
        close(first, second + slides[joint.name] * guide, 1e-11, joint.name)


def base_of(mechanism: Mechanism, result: Kinematics, link: int) -> tuple[NDArray[np.complex128], complex]:
    """Where one named point of the link is."""
    if link == 0:
        return np.zeros(len(result.x), complex), 0j
    points = mechanism.link(link).points
    fixed = mechanism.frame.points
    name = next(iter(points))
    if name in fixed:
        return np.full(len(result.x), fixed[name]), points[name]
    return result.trace.r[result.trace.point_names.index(name)], points[name]


@given(scenes())
@FEWER
def test_derivatives_are_the_slopes_of_the_positions(scene: RandomMechanism) -> None:
    """Central differences of order 8 over nine positions, of positions alone."""
    solved = regular(scene)
    if solved is None:
        return
    mechanism, _ = solved
    step = 2e-3
    fine = replace(mechanism, grid=replace(mechanism.grid, positions=8, span=8 * step))
    try:
        t = solve_kinematics(fine).trace
    except tmmcalc.TmmError:
        return
    first = np.array([3, -32, 168, -672, 0, 672, -168, 32, -3]) / 840 / step
    second = np.array([-9, 128, -1008, 8064, -14350, 8064, -1008, 128, -9]) / 5040 / step**2
    sense = np.sign(mechanism.input.speed)
    for values, rates, rates2 in ((t.r, t.dr, t.ddr), (t.angle, t.dangle, t.ddangle), (t.s, t.ds, t.dds)):
        for value, rate, rate2 in zip(values, rates, rates2, strict=True):
            scale = 1 + np.max(np.abs(value)) + np.max(np.abs(rate)) + np.max(np.abs(rate2))
            assert abs(sense * value @ first - rate[4]) < 1e-9 * scale
            assert abs(value @ second - rate2[4]) < 1e-6 * scale


@given(scenes(), st.floats(-3, 3), st.complex_numbers(max_magnitude=5))
@FEWER
def test_turning_and_shifting_the_whole(scene: RandomMechanism, turn: float, shift: complex) -> None:
    solved = regular(scene)
    if solved is None:
        return
    mechanism, one = solved
    two = solve_kinematics(moved(mechanism, turn, shift))
    e = np.exp(1j * turn)
    close(two.trace.r, one.trace.r * e + shift, 1e-11, "places")
    close(two.trace.dr, one.trace.dr * e, 1e-9, "first")
    close(two.trace.ddr, one.trace.ddr * e, 1e-8, "second")
    close(two.s, one.s, 1e-11, "output")
    close(two.trace.s, one.trace.s, 1e-11, "slides")


@given(scenes(), st.floats(-6, 5))
@FEWER
def test_another_unit_of_length(scene: RandomMechanism, exponent: float) -> None:
    solved = regular(scene)
    if solved is None:
        return
    mechanism, one = solved
    factor = 10**exponent
    two = solve_kinematics(scaled(mechanism, factor))
    close(two.trace.r / factor, one.trace.r, 1e-11, "places")
    unit = factor if mechanism.joint(mechanism.input.joint).kind == "prismatic" else 1.0
    close(two.trace.dr / factor * unit, one.trace.dr, 1e-9, "first")
    close(two.trace.ddr / factor * unit**2, one.trace.ddr, 1e-8, "second")
    close(np.exp(1j * two.trace.angle), np.exp(1j * one.trace.angle), 1e-11, "angles")
    assert [grade.severity for grade in two.grades] == [grade.severity for grade in one.grades]
    assert len(two.summaries[0].dead_centres) == len(one.summaries[0].dead_centres)


@given(scenes(), st.integers(0, 2**32 - 1))
@FEWER
def test_names_numbers_axes_and_sides_of_joints(scene: RandomMechanism, seed: int) -> None:
    """Numbers, order, own axes and the roles of guide and slider change nothing that is seen from outside."""
    solved = regular(scene)
    if solved is None:
        return
    _, one = solved
    mechanism, rng = scene.mechanism, np.random.default_rng(seed)
    other = mechanism
    for link in mechanism.links:
        other = with_axes(other, link.id, complex(*rng.uniform(-1, 1, 2)), float(rng.uniform(-3, 3)))
    driver = mechanism.joint(mechanism.input.joint)
    for joint in mechanism.joints:
        if joint is not driver:
            other = swapped(other, joint.name)
    numbers = dict(zip((k.id for k in mechanism.links), rng.permutation(len(mechanism.links)) + 1, strict=True))
    other = renumbered(other, {a: int(b) for a, b in numbers.items()}, rng=rng)
    two = solve_kinematics(other)
    assert set(two.trace.point_names) == set(one.trace.point_names)
    rows = [two.trace.point_names.index(name) for name in one.trace.point_names]
    close(two.trace.r[rows], one.trace.r, 1e-11, "places")
    close(two.trace.dr[rows], one.trace.dr, 1e-9, "first")
    close(two.trace.ddr[rows], one.trace.ddr, 1e-8, "second")
    rows = [two.trace.joint_names.index(name) for name in one.trace.joint_names]
    close(two.trace.s[rows], one.trace.s, 1e-11, "slides")
    close(two.trace.ds[rows], one.trace.ds, 1e-9, "sliding")
    links = [two.trace.link_ids.index(int(numbers[link])) for link in one.trace.link_ids]
    close(two.trace.dangle[links], one.trace.dangle, 1e-9, "turning")


@given(scenes())
@FEWER
def test_time_reversal(scene: RandomMechanism) -> None:
    """The same range passed backwards: the same positions, velocities reversed, accelerations kept."""
    solved = regular(scene)
    if solved is None:
        return
    mechanism, one = solved
    back = replace(mechanism, input=replace(mechanism.input, speed=-mechanism.input.speed, start=float(one.x[-1])))
    try:
        two = solve_kinematics(back)
    except tmmcalc.NoSolutionError:
        return
    close(two.x[::-1], one.x, 1e-14, "input")
    close(two.trace.r[:, ::-1], one.trace.r, 1e-11, "places")
    v, a = one.in_time(one.trace.dr, one.trace.ddr)
    v2, a2 = two.in_time(two.trace.dr[:, ::-1], two.trace.ddr[:, ::-1])
    close(v2, -v, 1e-9, "velocities")
    close(a2, a, 1e-8, "accelerations")


@given(scenes(), st.floats(-20, 20))
@FEWER
def test_acceleration_of_the_input(scene: RandomMechanism, eps: float) -> None:
    """a = S'' w^2 + S' eps, by differences of the velocity along the motion in time."""
    solved = regular(scene)
    if solved is None:
        return
    mechanism, _ = solved
    w, h = mechanism.input.speed, 1e-4
    times = h * np.arange(-2, 3)
    x = (mechanism.input.start or 0.0) + w * times + eps * times**2 / 2
    try:
        reference = by_reference(scene, x[np.argsort(x)])
    except NoPositionError:
        return
    order = np.argsort(np.argsort(x))
    result = solve_kinematics(replace(mechanism, input=replace(mechanism.input, acceleration=eps)))
    name = mechanism.outputs[0].point or ""
    r = reference.point(name).value[order]
    k = result.trace.point_names.index(name)
    v, a = result.in_time(result.trace.dr[k], result.trace.ddr[k])
    assert abs((r[0] - 8 * r[1] + 8 * r[3] - r[4]) / (12 * h) - v[0]) < 1e-8 * (1 + abs(v[0]) + abs(a[0]))
    second = (-r[0] + 16 * r[1] - 30 * r[2] + 16 * r[3] - r[4]) / (12 * h**2)
    assert abs(second - a[0]) < 1e-5 * (1 + abs(v[0]) + abs(a[0]))


@given(scenes())
@FEWER
def test_projection_is_the_same_method(scene: RandomMechanism) -> None:
    solved = regular(scene)
    if solved is None:
        return
    mechanism, one = solved
    two = solve_kinematics(mechanism, Method("projection"))
    close(two.trace.dr, one.trace.dr, 1e-11, "first")
    close(two.trace.ddr, one.trace.ddr, 1e-11 * WORST, "second")
    close(two.trace.dangle, one.trace.dangle, 1e-11, "omega")
    close(two.trace.ddangle, one.trace.ddangle, 1e-11 * WORST, "eps")


@given(scenes(most=3), st.integers(0, 2**32 - 1))
@EXAMPLES
def test_a_rough_sketch_chooses_the_variant(scene: RandomMechanism, seed: int) -> None:
    """Points read off with an error of 2 % of the size lead to the configuration that was drawn."""
    rng, mechanism = np.random.default_rng(seed), scene.mechanism
    sketch = {name: p + 0.02 * complex(*rng.uniform(-1, 1, 2)) for name, p in mechanism.assembly.sketch.items()}
    near = replace(mechanism, assembly=Assembly(sketch=sketch), grid=replace(mechanism.grid, span=1e-6))
    try:
        result = solve_kinematics(near)
    except (tmmcalc.AssemblyError, tmmcalc.SingularityError):
        return
    for name in result.trace.point_names:
        place = mechanism.assembly.sketch[name]
        found = result.trace.r[result.trace.point_names.index(name), 0]
        assert abs(found - place) < 1e-9, name


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("prismatic", [False, True])
def test_each_kind_under_each_input(kind: str, prismatic: bool) -> None:
    """Enough scenes of every kind are compared, whatever the random chains above meet."""
    compared = 0
    for seed in range(12):
        scene = build(np.random.default_rng(seed), [kind], prismatic_input=prismatic)
        solved = regular(scene)
        if solved is None:
            continue
        _, result = solved
        assert result.structure.groups[0].kind == kind
        reference = by_reference(scene, result.x)
        for k, name in enumerate(result.trace.point_names):
            rows = result.trace.r[k], result.trace.dr[k], result.trace.ddr[k]
            compare(reference.point(name), rows, name)
        compared += 1
    assert compared >= 6
