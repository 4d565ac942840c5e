"""Columns by choice of the forces table: inertia, parts along links, arms, what is without friction, terms.

Nothing of them is computed before a column is made; then the mechanism is solved once more at the rows of the result.

Of an outer pin of a dyad the reaction on the dyad's link has a normal and a tangential part (textbook 3.2.3): with an
inner revolute pair N lies from the pin towards that pair and T a quarter turn counter-clockwise of it; with an inner
prismatic pair T lies along its line, from the pin of the guide towards that of the slider, or along the guide where
there is no second pin, and N a quarter turn counter-clockwise of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cached_property, partial

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.numerics.panels import panels, resolved
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.kinetostatics import compile_statics, reversals
from tmmcalc.linkage.forces.refinement import PARTS
from tmmcalc.linkage.forces.results import LEAST_ARM, Forces
from tmmcalc.linkage.forces.rows import Rows
from tmmcalc.linkage.forces.stack import Stack, stacked
from tmmcalc.linkage.forces.terms import equation_columns, lever_columns
from tmmcalc.linkage.forces.verification import friction_power
from tmmcalc.linkage.forces.wrench import Slideway, seat_of
from tmmcalc.linkage.loading import Body, Loading
from tmmcalc.linkage.loads.sources import InertiaLoad, Place, inertia_load
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.structure import Group

INERTIA = (
    Quantity("Pi_{link}_x[N]", "inertia force of link {link} along x", source="(3.1)"),
    Quantity("Pi_{link}_y[N]", "inertia force of link {link} along y", source="(3.1)"),
    Quantity("Pi_{link}[N]", "magnitude of the inertia force of link {link}", source="(3.1)"),
    Quantity("Mi_{link}[N*m]", "inertia couple of link {link}, counter-clockwise", source="(3.1)"),
)
PARTS_OF_PIN = (
    Quantity("RN_{pin}[N]", "normal part of the reaction in outer pin {pin} on the link of its dyad"),
    Quantity("RT_{pin}[N]", "tangential part of the reaction in outer pin {pin} on the link of its dyad"),
)
IDEAL_PARTS_OF_PIN = (
    Quantity("RN0_{pin}[N]", "normal part of the reaction in outer pin {pin} without friction"),
    Quantity("RT0_{pin}[N]", "tangential part of the reaction in outer pin {pin} without friction"),
)
DIRECTION = Quantity(
    "angle_R_{joint}[deg]",
    "direction of the reaction in {joint}, of the lower-numbered link on the higher-numbered one, from x",
)
ARM = Quantity("h_{slide}[m]", "arm of the normal force in {slide} from the slider's point, along the guide")
IDEAL_DRIVE = Quantity("{letter}0_drive[{unit}]", "drive without friction")
IDEAL = (
    Quantity("R0_{joint}_x[N]", "reaction in {joint} along x without friction"),
    Quantity("R0_{joint}_y[N]", "reaction in {joint} along y without friction"),
    Quantity("R0_{joint}[N]", "magnitude of the reaction in {joint} without friction"),
)
IDEAL_NORMAL = Quantity("N0_{slide}[N]", "normal part of the reaction in prismatic pair {slide} without friction")
IDEAL_COUPLE = Quantity("M0_{slide}[N*m]", "couple in prismatic pair {slide} without friction")
FRICTION_REDUCED = Quantity(
    "{letter}_red_fr_{joint}[{unit}]", "friction in {joint} reduced to the input", source="(3.34)"
)
FRICTION_POWER = Quantity("P_fr_{joint}[W]", "power of friction in {joint}")
FRICTION_WORK = Quantity("A_fr_{joint}[J]", "work of friction in {joint} from the beginning of the motion on")
NOISE = 1e-12  # of the largest force: a component that is rounding
NOTHING = 1e-9  # of the largest of its kind: a force without a direction, a normal force without an arm


def further_columns(mechanism: Mechanism, loading: Loading, kinematics: Kinematics, result: Forces) -> list[Column]:
    """All columns by choice of a result: inertia by link, then by pair in the order of the result."""
    solved = _Solved(mechanism, loading, kinematics, result)
    groups = {name: group for group in kinematics.structure.groups if group.kind for name in group.outer}
    found = [each for body in loading.heavy for each in _inertia(solved, body)]
    found.append(column(IDEAL_DRIVE.of(**_of_drive(result.turns)), lambda: solved.ideal.drive))
    for j, pair in enumerate(result.pairs):
        joint = mechanism.joint(pair.joint)
        if joint.kind == "revolute" and joint.name in groups:
            group = groups[joint.name]
            for parts, ideal in ((PARTS_OF_PIN, False), (IDEAL_PARTS_OF_PIN, True)):
                for k, told in enumerate(parts):
                    make = partial(solved.pin_part, j, joint, group, k, ideal=ideal)
                    found.append(column(told.of(pin=joint.name), make))
        found.append(column(DIRECTION.of(joint=joint.name), partial(solved.direction, j)))
        found += _ideal(solved, j, joint)
        if joint.kind == "prismatic":
            found.append(column(ARM.of(slide=joint.name), partial(solved.arm, j)))
        if joint.name in solved.rubbing:
            reduced = FRICTION_REDUCED.of(joint=joint.name, **_of_drive(result.turns))
            found.append(column(reduced, partial(solved.friction_reduced, joint.name)))
            found.append(column(FRICTION_POWER.of(joint=joint.name), partial(solved.friction_power, joint.name)))
            found.append(column(FRICTION_WORK.of(joint=joint.name), partial(solved.friction_work, joint.name)))
    return [*found, *lever_columns(solved), *equation_columns(solved)]


def _of_drive(turns: bool) -> dict[str, str]:
    """Letter and unit of what acts along the input coordinate."""
    return {"letter": "M", "unit": "N*m"} if turns else {"letter": "F", "unit": "N"}


def _inertia(solved: _Solved, body: Body) -> Iterator[Column]:
    def made(part: Callable[[InertiaLoad], Real]) -> Real:
        return np.broadcast_to(part(solved.inertia(body)), solved.result.theta.shape)

    parts: tuple[Callable[[InertiaLoad], Real], ...] = (
        lambda load: _without_noise(load.force.real, load.force),
        lambda load: _without_noise(load.force.imag, load.force),
        lambda load: np.abs(load.force),
        lambda load: load.couple,
    )
    for told, part in zip(INERTIA, parts, strict=True):
        yield column(told.of(link=body.link), partial(made, part))


def _without_noise(component: Real, force: Plane) -> Real:
    return np.where(np.abs(component) > NOISE * np.max(np.abs(force)), component, 0.0)


def _ideal(solved: _Solved, j: int, joint: Joint) -> Iterator[Column]:
    parts = (
        lambda: solved.ideal.reaction[j].real,
        lambda: solved.ideal.reaction[j].imag,
        lambda: np.abs(solved.ideal.reaction[j]),
    )
    for told, make in zip(IDEAL, parts, strict=True):
        yield column(told.of(joint=joint.name), make)
    if joint.kind == "prismatic":
        yield column(IDEAL_NORMAL.of(slide=joint.name), lambda: solved.ideal.normal[j])
        yield column(IDEAL_COUPLE.of(slide=joint.name), lambda: solved.ideal.couple[j])


class _Solved(Rows):
    """The rows of a result, and what stands in it of their pairs and of inertia."""

    @cached_property
    def rubbing(self) -> set[str]:
        """The joints with friction."""
        pairs = self.result.pairs
        return {pair.joint for pair in pairs if pair.friction and (pair.kind == "prismatic" or pair.radius)}

    @cached_property
    def place(self) -> Place:
        """The rows' configuration."""
        return self.statics.scene.place(self.result.theta, self.side)

    @cached_property
    def ideal(self) -> Stack:
        """Reactions and drive without friction."""
        scene = self.statics.scene
        bare = scene._replace(loading=replace(scene.loading, pairs=()))
        return stacked(compile_statics(bare), self.result.theta, self.side, checked=False)[0]

    def inertia(self, body: Body) -> InertiaLoad:
        """Force and couple of inertia of a body."""
        travel = self.statics.scene.travel
        motion = self.place.configuration.motions[body.link]
        return inertia_load(body, motion, travel.speed, travel.acceleration)

    def pin_part(self, j: int, joint: Joint, group: Group, part: int, *, ideal: bool) -> Real:
        """The normal (0) or tangential (1) part (n,) of the reaction in an outer pin on the dyad's link."""
        link = next(k for k in joint.links if k in group.links)
        force = (self.ideal if ideal else self.result).reaction[j] * (1.0 if link > joint.other(link) else -1.0)
        normal = self._normal(joint, group)
        along = normal if part == 0 else self._tangent(normal, group)
        return np.asarray((np.conj(along) * force).real)

    def _normal(self, joint: Joint, group: Group) -> Plane:
        """The direction (n,) of N in an outer pin."""
        configuration = self.place.configuration
        inner, pin = seat_of(self.mechanism.joint(group.inner[0]), configuration), seat_of(joint, configuration).r
        if not isinstance(inner, Slideway):
            line = inner.r - pin
            return np.asarray(line / np.abs(line))
        return 1j * self._along(group, inner)

    def _tangent(self, normal: Plane, group: Group) -> Plane:
        """The direction (n,) of T: a quarter turn ahead of N, or behind it where T comes first."""
        return normal * (-1j if self.mechanism.joint(group.inner[0]).kind == "prismatic" else 1j)

    def _along(self, group: Group, inner: Slideway) -> Plane:
        """The direction (n,) of an inner prismatic pair, from the pin of the guide to that of the slider."""
        joint = self.mechanism.joint(group.inner[0])
        pins = {}
        for link, outer in zip(group.links, map(self.mechanism.joint, group.outer), strict=True):
            if outer.kind == "revolute":
                pins[link] = seat_of(outer, self.place.configuration).r
        if len(pins) < 2:
            return inner.e
        apart = pins[joint.links[0]] - pins[joint.links[1]]
        return np.asarray(np.where((np.conj(inner.e) * apart).real < 0, -inner.e, inner.e))

    def direction(self, j: int) -> Real:
        """The angle (n,) of a reaction from x [deg]; NaN where there is none."""
        force = self.result.reaction[j]
        there = np.abs(force) > NOTHING * np.max(np.abs(self.result.reaction))
        return np.where(there, np.degrees(np.angle(force)), np.nan)

    def arm(self, j: int) -> Real:
        """The arm (n,) of a normal force; NaN where the pair holds a couple alone, or nothing."""
        normal, couple = self.result.normal[j], self.result.couple[j]
        there = np.abs(normal) > NOTHING * np.max(np.abs(self.result.reaction))
        arm = couple / np.where(there, normal, 1.0)
        return np.where(there, np.where(np.abs(arm) > LEAST_ARM, arm, 0.0), np.nan)

    @cached_property
    def _reduced(self) -> dict[str, Real]:
        """Friction (n,) of every pair at the rows, reduced to the input."""
        return friction_power(self.statics, self.statics.solve(self.place, self.side), self.place)

    def friction_reduced(self, joint: str) -> Real:
        """Friction (n,) in a pair reduced to the input [N*m or N]."""
        return np.broadcast_to(self._reduced[joint], self.result.theta.shape)

    def friction_power(self, joint: str) -> Real:
        """The power (n,) of friction in a pair."""
        return self.friction_reduced(joint) * self.result.speed

    def friction_work(self, joint: str) -> Real:
        """The work (n,) of friction in a pair from the beginning of the motion to the rows."""
        return self._works[joint]

    @cached_property
    def _works(self) -> dict[str, Real]:
        """Works (n,) by joint, integrated between all places where something jumps."""
        scene, joints = self.statics.scene, [joint.name for joint in self.statics.rubbing]

        def powers(theta: Real) -> Real:
            place = scene.place(theta)
            lost = friction_power(self.statics, self.statics.solve(place), place)
            return np.array([np.broadcast_to(lost[joint], theta.shape) for joint in joints])

        widest = (TURN if scene.chain.turns else scene.travel.period) / PARTS
        first = panels(0.0, scene.travel.period, scene.edges(reversals(self.statics)), widest)
        on, values, _ = resolved(powers, first)
        theta = np.clip(self.result.theta, 0.0, scene.travel.period)
        return {
            joint: scene.travel.sense * on.primitive_at(reduced, theta)
            for joint, reduced in zip(joints, values, strict=True)
        }
