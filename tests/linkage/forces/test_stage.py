"""The forces stage as a whole: rows, maxima between the positions, power, what changes nothing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from properties import examples
from random_mechanisms import RandomMechanism, scenes
from sparing import sparing
from transforms import moved, renumbered, scaled, swapped, with_axes

import tmmcalc
from linkage.forces.loadings import random_loading
from linkage.forces.worked import press, press_loading
from linkage.scenes import CONFIGS, driven_rod, full_turn, shaper, with_grid, with_input
from linkage.test_properties import regular
from tmmcalc import solve_kinematics
from tmmcalc.linkage.forces.columns import columns
from tmmcalc.linkage.forces.kinetostatics import compile_statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.forces.stack import Stack, stacked
from tmmcalc.linkage.loading import Body, GearDrive, Load, Loading, Pair, Spring, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Extreme
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.machine.reduction.solve import solve_reduction

EXAMPLES = examples(15, derandomize=True, database=None)


def shaper_loading(friction: float = 0.1) -> Loading:
    return Loading(
        bodies=(Body(3, 55.0, 4.5, 0.5 + 0j), Body(4, 12.0, 0.1, 0.12 + 0j), Body(5, 190.0, 0.0, 0j)),
        gravity=-9.81j,
        loads=(Load("Q", 5, "force", Constant(-1500.0), direction=-1 + 0j, window=Window(stroke="working")),),
        pairs=(Pair("A3", friction, length=0.2), Pair("B", friction, 0.03), Pair("D0", friction, length=0.8)),
    )


def scenes_of_maxima() -> list[tuple[str, Mechanism, Loading]]:
    four_bar = to_linkage(tmmcalc.load_spec(CONFIGS / "four-bar.toml").mechanism)
    bodies = tuple(Body(k, 2.0, 0.05, 0.04 + 0.01j) for k in (1, 2, 3))
    gear = GearDrive(0.1, 0.35, 2.0)
    return [
        ("press", press()[0], press_loading()),
        ("press without friction", press()[0], press_loading(0.0)),
        ("shaper", with_input(shaper(), speed=5.0), shaper_loading()),
        ("shaper backwards", with_input(shaper(), speed=-5.0), shaper_loading()),
        (
            "four-bar",
            with_input(four_bar, speed=20.0),
            Loading(bodies, -9.81j, pairs=(Pair("O", 0.1, 0.02),), drive=gear),
        ),
    ]


@sparing(("name", "mechanism", "loading"), scenes_of_maxima(), ids=lambda v: v if isinstance(v, str) else "", every=3)
def test_maxima_between_the_positions(name: str, mechanism: Mechanism, loading: Loading) -> None:
    """Against a grid of a fiftieth of a degree and both limits at the place that is named."""
    kinematics = solve_kinematics(mechanism)
    coarse = solve_forces(mechanism, loading, kinematics)
    dense = with_grid(mechanism, positions=18000)
    fine = solve_forces(dense, loading, solve_kinematics(dense))
    statics = compile_statics(compile_scene(mechanism, loading, kinematics))

    def near(extreme: Extreme, values: Callable[[Stack | Forces], Any], sign: float = 1.0) -> None:
        about = np.clip(extreme.x + np.array([-1e-8, 1e-8]), 0, 2 * np.pi)
        there = sign * values(stacked(statics, about, np.ones(2))[0])
        best, size = float(np.max(sign * values(fine))), float(np.max(np.abs(values(fine))))
        assert sign * extreme.value >= best - 1e-9 * size - 1e-9
        assert sign * extreme.value <= np.max(there) + 1e-6 * size + 1e-9

    for j, pair in enumerate(coarse.pairs):
        near(pair.force, lambda at, j=j: np.abs(at.reaction[j]))
        if pair.couple is not None:
            near(pair.couple, lambda at, j=j: np.abs(at.couple[j]))
        if pair.pressure is not None:
            near(pair.pressure, lambda at, j=j, length=pair.length: larger_edge(at.normal[j], at.couple[j], length))
    speed = mechanism.input.speed
    near(coarse.drive_extremes[1], lambda at: at.drive)
    near(coarse.drive_extremes[0], lambda at: at.drive, -1.0)
    near(coarse.power_extremes[1], lambda at: at.drive * speed)
    near(coarse.power_extremes[0], lambda at: at.drive * speed, -1.0)


def larger_edge(normal: Any, couple: Any, length: float) -> Any:
    return np.max(np.abs([normal / 2 + side * couple / length for side in (-1, 1)]), axis=0)


@pytest.mark.parametrize(
    ("name", "mechanism", "loading"), scenes_of_maxima(), ids=lambda v: v if isinstance(v, str) else ""
)
def test_mean_power_between_the_positions(name: str, mechanism: Mechanism, loading: Loading) -> None:
    """Against the work of a reduction, whose panels are cut at every kink: off by no more than is said."""
    kinematics = solve_kinematics(mechanism)
    result = solve_forces(mechanism, loading, kinematics)
    reduced = solve_reduction(mechanism, loading, kinematics)
    work = sum(contribution.work for contribution in reduced.contributions)
    expected = -work * abs(result.speed) / reduced.cycle.period
    largest = max(abs(extreme.value) for extreme in result.power_extremes)
    assert abs(result.power_mean.value - expected) <= result.power_mean.error + 1e-13 * largest
    assert result.power_mean.error <= 1e-3 * largest


def test_power_is_drive_times_speed() -> None:
    for speed in (5.0, -5.0):
        mechanism, kinematics = press(speed=speed)
        result = solve_forces(mechanism, press_loading(), kinematics)
        np.testing.assert_array_equal(result.power, result.drive * speed)
        low, high = result.power_extremes
        assert low.value < high.value
        assert result.speed == speed


def test_a_slider_is_driven_by_a_force() -> None:
    mechanism = driven_rod(0.5, 0.3, 0.2)
    loading = Loading(bodies=(Body(2, 2.0, 0.1, 0.2 + 0j),), gravity=-9.81j)
    result = solve_forces(mechanism, loading, solve_kinematics(mechanism))
    assert result.drive_kind == "slider"
    assert not result.turns
    assert result.mesh is None


def test_forces_over_two_turns_of_a_four_stroke_load() -> None:
    mechanism, kinematics = press()
    table = Tabulated("angle", (0.0, 6.0, 12.5), (0.0, -1000.0, 300.0), period=4 * np.pi)
    load = Load("gas", 3, "force", table)
    result = solve_forces(mechanism, Loading(loads=(load,), pairs=(Pair("B0", 0.1),)), kinematics)
    assert result.labels[:3] == ("0", "1", "2")
    assert result.labels[-1] == "24"
    assert [label for label in result.labels if label.endswith("-")] == ["6-", "12-", "18-"]
    np.testing.assert_allclose(result.theta[-1], 4 * np.pi)
    np.testing.assert_allclose(result.phi, result.theta)
    once = solve_forces(mechanism, Loading(loads=(replace(load, law=Constant(0.0)),)), kinematics)
    assert once.labels[-1] == "12"


class TestOddGrids:
    """A plain mechanism may name positions before position 0, or pass its range against the motion."""

    def mechanism(self, **grid: object) -> Mechanism:
        return with_grid(press()[0], **grid)

    def compare(self, mechanism: Mechanism, at: NDArray[np.float64]) -> None:
        """The same values as those of the whole turn at the same crank angles."""
        loading = replace(press_loading(), loads=())
        result = solve_forces(mechanism, loading, solve_kinematics(mechanism))
        np.testing.assert_allclose(result.phi, at, atol=1e-15)
        steps = 360
        whole = full_turn(press()[0], 0.0, steps)
        table = solve_forces(whole, loading, solve_kinematics(whole))
        for i, phi in enumerate(result.phi):
            label = str(round(phi % (2 * np.pi) / (2 * np.pi) * steps))
            k = table.labels.index(label)
            np.testing.assert_allclose(result.reaction[:, i], table.reaction[:, k], rtol=1e-9, atol=1e-6)
            np.testing.assert_allclose(result.drive[i], table.drive[k], rtol=1e-9, atol=1e-9)

    def test_positions_before_the_first(self) -> None:
        mechanism = self.mechanism(positions=4, span=np.radians(40), extra=(np.radians(-20), np.radians(55)))
        mechanism = with_input(mechanism, start=np.radians(25))
        kinematics = solve_kinematics(mechanism)
        loading = replace(press_loading(), loads=())
        result = solve_forces(mechanism, loading, kinematics)
        np.testing.assert_allclose(np.degrees(result.phi), [-20.0, 0.0, 10.0, 20.0, 30.0, 40.0, 55.0], atol=1e-12)
        whole = full_turn(press()[0], 0.0, 360)
        table = solve_forces(whole, loading, solve_kinematics(whole))
        rows = [table.labels.index(str(k)) for k in (5, 25, 35, 45, 55, 65, 80)]
        np.testing.assert_allclose(result.reaction, table.reaction[:, rows], rtol=1e-12, atol=1e-9)
        np.testing.assert_allclose(result.theta, result.phi - result.phi[0], atol=1e-15)

    def test_against_the_motion(self) -> None:
        """The range is passed with the motion all the same: friction resists."""
        mechanism = with_input(self.mechanism(positions=4, span=np.radians(-40)), start=np.radians(80))
        loading = replace(press_loading(), loads=())
        back = solve_forces(mechanism, loading, solve_kinematics(mechanism))
        forth = with_input(self.mechanism(positions=4, span=np.radians(40)), start=np.radians(40))
        same = solve_forces(forth, loading, solve_kinematics(forth))
        np.testing.assert_allclose(back.reaction[:, ::-1], same.reaction, rtol=1e-12, atol=1e-9)
        np.testing.assert_allclose(back.theta[::-1], same.theta, atol=1e-15)
        np.testing.assert_allclose(np.degrees(back.phi), [0, -10, -20, -30, -40], atol=1e-12)


def close(found: NDArray[np.inexact], expected: NDArray[np.inexact], what: str, tolerance: float = 1e-9) -> None:
    scale = float(np.max(np.abs(expected), initial=0.0)) + 1e-9
    assert np.max(np.abs(found - expected), initial=0.0) <= tolerance * scale, what


def by_joint(result: Forces) -> dict[str, int]:
    return {pair.joint: j for j, pair in enumerate(result.pairs)}


def locked(mechanism: Mechanism, loading: Loading) -> Forces | None:
    try:
        return solve_forces(mechanism, loading, solve_kinematics(mechanism))
    except tmmcalc.NoSolutionError as error:
        if "self-locking" not in str(error):
            raise
        return None


def base(scene: RandomMechanism, seed: int) -> tuple[Mechanism, Loading, Forces] | None:
    found = regular(scene)
    if found is None:
        return None
    mechanism, _ = found
    loading = random_loading(np.random.default_rng(seed), mechanism, 0.2 * (seed % 2))
    result = locked(mechanism, loading)
    return None if result is None else (mechanism, loading, result)


def turned(load: Load, e: complex) -> Load:
    return load if load.follows else replace(load, direction=load.direction * e)


def carried(spring: Spring, turn: float, shift: complex) -> Spring:
    """The spring with its ends on the frame moved; a free angle against the frame counts from the moved axes."""
    ends = [p if k else p * np.exp(1j * turn) + shift for k, p in zip(spring.links, spring.points, strict=True)]
    against = {1: turn, 0: -turn}.get(spring.links.index(0), 0.0) if 0 in spring.links else 0.0
    return replace(spring, points=(complex(ends[0]), complex(ends[1])), free=spring.free - against * is_torsion(spring))


def is_torsion(spring: Spring) -> bool:
    return spring.kind == "torsion"


@given(scenes(most=3), st.integers(0, 2**32 - 1), st.floats(-3, 3))
@EXAMPLES
def test_the_whole_plane_moved(scene: RandomMechanism, seed: int, turn: float) -> None:
    """Mechanism, gravity and fixed directions turned together: all forces turn, nothing else changes."""
    found = base(scene, seed)
    if found is None:
        return
    mechanism, loading, one = found
    e, shift = complex(np.exp(1j * turn)), 0.3 - 2j
    drive = loading.drive
    if isinstance(drive, GearDrive):
        drive = replace(drive, pinion=drive.pinion + turn)
    other = moved(mechanism, turn, shift)
    laid = replace(
        loading,
        gravity=loading.gravity * e,
        loads=tuple(turned(load, e) for load in loading.loads),
        springs=tuple(carried(spring, turn, shift) for spring in loading.springs),
        drive=drive,
    )
    two = solve_forces(other, laid, solve_kinematics(other))
    close(two.reaction, one.reaction * e, "reactions")
    close(two.drive, one.drive, "drive")
    close(two.couple, one.couple, "couples")
    close(two.friction, one.friction, "friction")


@given(scenes(most=3), st.integers(0, 2**32 - 1), st.floats(-3, 3))
@EXAMPLES
def test_another_unit_of_length(scene: RandomMechanism, seed: int, exponent: float) -> None:
    """Lengths times k, the same masses: forces times k, moments times k^2, if the loads are scaled alike."""
    found = base(scene, seed)
    if found is None:
        return
    mechanism, loading, one = found
    k = 10**exponent
    other, sized = scaled(mechanism, k), scaled_loading(loading, mechanism, k)
    two = solve_forces(other, sized, solve_kinematics(other))
    close(two.reaction, one.reaction * k, "reactions")
    close(two.couple, one.couple * k**2, "couples")
    close(two.drive, one.drive * (k**2 if one.turns else k), "drive")
    unit = np.array([k**2 if pair.kind == "revolute" else k for pair in one.pairs])
    close(two.friction, one.friction * unit[:, None], "friction")
    assert [pair.tips for pair in two.pairs] == [pair.tips for pair in one.pairs]


def scaled_loading(loading: Loading, mechanism: Mechanism, k: float) -> Loading:
    """The loading in a unit of length 1/k times the old one: lengths get k times as many."""
    turns = mechanism.joint(mechanism.input.joint).kind == "revolute"

    def law(load: Load) -> Load:
        force = load.kind == "force"
        unit = k if force else k * k
        given = load.law
        if isinstance(given, Constant):
            given = Constant(given.value * unit)
        elif isinstance(given, Polynomial):
            per = 1.0 if turns else k
            given = Polynomial(tuple(c * unit / per**i for i, c in enumerate(given.coefficients)))
        elif isinstance(given, Viscous):
            given = Viscous(given.coefficient * (1.0 if force else k * k))
        elif isinstance(given, Quadratic):
            given = Quadratic(given.coefficient * (1.0 / k if force else k * k))
        return replace(load, law=given, point=load.point * k)

    def spring(s: Spring) -> Spring:
        if is_torsion(s):
            return replace(s, stiffness=s.stiffness * k * k, damping=s.damping * k * k)
        return replace(s, points=(s.points[0] * k, s.points[1] * k), free=s.free * k)

    drive = loading.drive
    if isinstance(drive, GearDrive):
        drive = replace(drive, radius=drive.radius * k)
    return Loading(
        tuple(Body(b.link, b.mass, b.inertia * k * k, b.center * k) for b in loading.bodies),
        loading.gravity * k,
        tuple(law(load) for load in loading.loads),
        tuple(spring(s) for s in loading.springs),
        tuple(replace(p, radius=p.radius * k, length=p.length * k if p.length else None) for p in loading.pairs),
        drive,
    )


@given(scenes(most=3), st.integers(0, 2**32 - 1))
@EXAMPLES
def test_numbers_axes_and_sides_of_joints(scene: RandomMechanism, seed: int) -> None:
    """Other link numbers, other own axes, guide and slider exchanged: the same forces on the same links."""
    found = base(scene, seed)
    if found is None:
        return
    mechanism, loading, one = found
    rng = np.random.default_rng(seed)
    loading = replace(loading, springs=tuple(s for s in loading.springs if not is_torsion(s)))
    first = locked(mechanism, loading)
    if first is None:
        return
    one, other = first, mechanism
    axes = {0: (0j, 0.0)}
    for link in mechanism.links:
        axes[link.id] = complex(*rng.uniform(-1, 1, 2)), float(rng.uniform(-3, 3))
        other = with_axes(other, link.id, *axes[link.id])
    revolute = [joint.name for joint in mechanism.joints if joint.kind == "revolute"]
    for name in revolute:
        if name != mechanism.input.joint:
            other = swapped(other, name)
    numbers = dict(
        zip((k.id for k in mechanism.links), (rng.permutation(len(mechanism.links)) + 1).tolist(), strict=True)
    )
    other = renumbered(other, numbers, rng=rng)
    two = locked(other, relaid(loading, axes, {0: 0, **numbers}))
    assert two is not None
    at = by_joint(two)
    for j, pair in enumerate(one.pairs):
        low, high = pair.links
        sign = 1.0 if {0: 0, **numbers}[high] > {0: 0, **numbers}[low] else -1.0
        close(two.reaction[at[pair.joint]], sign * one.reaction[j], pair.joint)
        close(two.couple[at[pair.joint]], sign * one.couple[j], f"couple in {pair.joint}", 1e-8)
    close(two.drive, one.drive, "drive")


def relaid(loading: Loading, axes: dict[int, tuple[complex, float]], numbers: dict[int, int]) -> Loading:
    """The loading in the new axes and numbers of the links."""

    def place(link: int, p: complex) -> complex:
        origin, turn = axes[link]
        return complex((p - origin) * np.exp(-1j * turn))

    def direction(load: Load) -> complex:
        return complex(load.direction * np.exp(-1j * axes[load.follows][1]))

    return replace(
        loading,
        bodies=tuple(Body(numbers[b.link], b.mass, b.inertia, place(b.link, b.center)) for b in loading.bodies),
        loads=tuple(
            replace(
                load,
                link=numbers[load.link],
                point=place(load.link, load.point),
                direction=direction(load),
                follows=numbers[load.follows],
                against=numbers[load.against],
            )
            for load in loading.loads
        ),
        springs=tuple(
            replace(
                s,
                links=(numbers[s.links[0]], numbers[s.links[1]]),
                points=(place(s.links[0], s.points[0]), place(s.links[1], s.points[1])),
            )
            for s in loading.springs
        ),
    )


def test_a_rigid_link_may_have_its_mass_in_parts() -> None:
    """Two bodies on one link are the same as their sum about the common centre of mass."""
    mechanism, kinematics = press()
    a, b = 0.02 + 0.01j, 0.15 - 0.02j
    centre = (3 * a + 5 * b) / 8
    inertia = 0.01 + 0.02 + 3 * abs(a - centre) ** 2 + 5 * abs(b - centre) ** 2
    parts = Loading((Body(2, 3.0, 0.01, a), Body(2, 5.0, 0.02, b)), -9.81j)
    whole = Loading((Body(2, 8.0, inertia, centre),), -9.81j)
    one, two = (solve_forces(mechanism, loading, kinematics) for loading in (parts, whole))
    close(one.reaction, two.reaction, "reactions", 1e-12)
    close(one.drive, two.drive, "drive", 1e-12)


def test_senses_of_the_normal_force_and_the_couple_of_a_guide() -> None:
    """Both act on the link with the higher number: the ram, in the frame, and the slotted link, on its block.

    The cut of 7500 N is 0.2 m above the pin D of the ram, so that the frame turns it back with 0.2 m times the cut.
    """
    spec = tmmcalc.load_spec(CONFIGS / "shaper.toml", ["loads[name=Q5].point=[0, 0.2]", "mechanism.grid.positions=8"])
    kinematics, forces = tmmcalc.solve_kinematics(spec), tmmcalc.solve_forces(spec)
    told = {column.name: column.make() for column in columns(forces)}
    rows = [forces.labels.index(label) for label in kinematics.labels]
    assert told["N_D0"] == pytest.approx(told["R_D0_y"], rel=1e-12)
    slot = np.exp(1j * kinematics.trace.angle[kinematics.trace.link_ids.index(3)])
    reaction = (told["R_A3_x"] + 1j * told["R_A3_y"])[rows]
    assert told["N_A3"][rows] == pytest.approx((np.conj(1j * slot) * reaction).real, abs=1e-9)
    cut = np.zeros(len(forces.labels))
    cut[(forces.theta > np.radians(30) + 1e-9) & (forces.theta < np.radians(180) - 1e-9)] = 7500
    inside = np.abs(forces.theta[:, None] - np.radians([30.0, 180.0])).min(axis=1) > 1e-6
    assert told["M_D0"][inside] == pytest.approx(0.2 * cut[inside], abs=1e-9)
