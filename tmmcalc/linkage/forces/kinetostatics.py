"""Reactions in all pairs and the drive at given angles: groups in reverse order, the input link last (textbook 3.2.3).

Everything is one pass over arrays. Moments of the loads of a link are taken about the input joint's frame point
until its group is solved. Where a rubbing pair stands still, its friction takes the sense of just after
(``side`` +1) or just before (-1) the position.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.memory import keep_pages
from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.crossings import STILL
from tmmcalc.linkage.forces import drive as driving
from tmmcalc.linkage.forces.dyad import DyadEquilibrium, GroupReactions
from tmmcalc.linkage.forces.wrench import (
    NOTHING,
    Plan,
    Post,
    Seat,
    Slideway,
    Wrench,
    plan_of,
    post_of,
    seat_of,
    sliding,
)
from tmmcalc.linkage.loading import Pair
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.linkage.loads.sources import Action, Place, Source, inertia
from tmmcalc.linkage.loads.values import Knot
from tmmcalc.linkage.model import FRAME, Joint

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.friction import Solution
    from tmmcalc.linkage.forces.group import GroupEquilibrium

    Equilibrium = DyadEquilibrium | GroupEquilibrium

REST = 1e-9  # a relative velocity below this part of the largest is rest


class Reaction(NamedTuple):
    """What the lower-numbered link does to the higher-numbered one in a joint, about the joint's point."""

    wrench: Wrench
    friction: Real  # part of it: along the line [N] or about the pin [N*m]
    seat: Seat


class Given(NamedTuple):
    """The given loads: every action with the factor of its order in the speed, their sums by link about the pole."""

    actions: list[tuple[Action, float | Real]]
    loads: dict[int, Wrench]


class ForceState(NamedTuple):
    """All reactions at n positions."""

    reactions: dict[str, Reaction]
    drive: Real
    mesh: Plane | None
    solutions: dict[str, Solution]  # of the friction, by the name of the group or the input joint
    given: Given
    pole: complex


class Statics(NamedTuple):
    """The constants of the force analysis: the scene, its loads of inertia, friction by joint, scales of sliding."""

    scene: Scene
    sources: tuple[Source, ...]
    pairs: dict[str, Pair]
    scales: dict[str, float]  # largest relative rate in every rubbing joint, over the survey
    plans: tuple[Plan, ...]  # of the groups, in the order in which they are solved
    driver: Post  # the joint of the input link
    # (C, 1) parts of the technological loads that act, in C cases that are solved together: all is (C, n) then
    cases: Real | None = None

    @property
    def joints(self) -> tuple[Joint, ...]:
        """All joints, in the order of the mechanism."""
        return self.scene.chain.mechanism.joints

    @property
    def rubbing(self) -> tuple[Joint, ...]:
        """The joints with friction."""
        return tuple(joint for joint in self.joints if joint.name in self.scales)

    def on(self, chain: Chain) -> Statics:
        """The same forces on a chain whose metric differs from that of the scene in its digits alone."""
        plans = tuple(plan_of(chain.mechanism, plan.group, self.pairs) for plan in self.plans)
        driver = post_of(chain.input_joint, chain.structure.input_link, self.pairs)
        return self._replace(scene=self.scene._replace(chain=chain), plans=plans, driver=driver)

    def solve(self, place: Place, side: Real | float = 1.0) -> ForceState:
        """Reactions at a place; ``side`` (n,) or one number is +1 or -1."""
        pole = self.pole(place)
        given = self.given(place, pole)
        carried = dict(given.loads)
        reactions: dict[str, Reaction] = {}
        solutions: dict[str, Solution] = {}
        drive: Real | None = None
        for plan in self.plans:
            group = self.equilibrium(plan, place, side, pole, carried)
            held = group.solve(self.shape(place))
            _hand_on(group, held, pole, carried, reactions)
            if held.solution is not None:
                solutions[plan.group.name] = held.solution
            drive = held.drive if held.drive is not None else drive
        if drive is not None:
            return ForceState(reactions, drive, None, solutions, given, pole)
        driven = self._drive(place, side, carried, pole, reactions)
        if driven.solution is not None:
            solutions[self.driver.joint.name] = driven.solution
        return ForceState(reactions, driven.drive, driven.mesh, solutions, given, pole)

    def shape(self, place: Place) -> tuple[int, ...]:
        """Shape of what acts at a place: (n,), or (C, n) in cases."""
        n = len(place.theta)
        return (n,) if self.cases is None else (len(self.cases), n)

    def pole(self, place: Place) -> complex:
        """The point that moments are taken about: the input joint's, where it stands first."""
        return complex(seat_of(self.driver.joint, place.configuration).r.flat[0])

    def given(self, place: Place, pole: complex) -> Given:
        """The given loads on every moving link."""
        total = {link.id: NOTHING for link in self.scene.chain.mechanism.links}
        actions = []
        for source in self.sources:
            factor: float | Real = source.factor(self.scene.travel.speed)
            if self.cases is not None and source.kind == "load":
                factor = factor * self.cases
            for action in source.actions(place):
                actions.append((action, factor))
                wrench = _wrench(action, factor, pole)
                total[action.link] = wrench if total[action.link] is NOTHING else total[action.link].plus(wrench)
        return Given(actions, total)

    def sense(self, joint: Joint, configuration: Configuration, side: Real | float) -> Real:
        """Sense (n,) of the sliding of the higher-numbered link in a joint: -1, 0, 1."""
        travel, scale = self.scene.travel, REST * self.scales[joint.name]
        against = 1.0 if self.scene.loading.friction_sense == "against" else -1.0
        rate, rate2 = sliding(joint, configuration)
        rest = np.abs(rate) <= scale
        if not np.any(rest):
            return np.sign(rate) * (travel.sense * against)
        acceleration = rate2 * travel.speed**2 + rate * travel.acceleration
        moves = np.abs(acceleration) > scale * travel.speed**2  # more than rounding, so that it has a sign
        return against * np.sign(np.where(rest, side * np.where(moves, acceleration, 0.0), rate * travel.sense))

    def equilibrium(
        self, plan: Plan, place: Place, side: Real | float, pole: complex, carried: dict[int, Wrench]
    ) -> Equilibrium:
        """A group with the wrenches ``carried`` on its links: its own loads, and what the groups after it hand on."""
        configuration = place.configuration
        seats = tuple(seat_of(post.joint, configuration) for post in plan.posts)
        c = {
            k: (post.coefficient * post.sign) * self.sense(post.joint, configuration, side)
            for k, post in enumerate(plan.posts)
            if post.coefficient > 0
        }
        if not plan.group.kind:
            from tmmcalc.linkage.forces.group import GroupEquilibrium  # only groups of class III and higher need it

            return GroupEquilibrium(plan, seats, {k: carried[k] for k in plan.group.links}, c, pole)
        outer_a, inner, outer_b = seats
        a, b = plan.group.links
        d = inner.r - pole
        return DyadEquilibrium(plan, (outer_a, inner, outer_b), (carried[a].about(d), carried[b].about(d)), c)

    def cut_out(self, name: str, place: Place, side: Real | float = 1.0) -> Equilibrium:
        """The group of this name, with the reactions of the groups after it, their friction solved."""
        pole = self.pole(place)
        carried, reactions = self.given(place, pole).loads, dict[str, Reaction]()
        for plan in self.plans:
            group = self.equilibrium(plan, place, side, pole, carried)
            if plan.group.name == name:
                return group
            _hand_on(group, group.solve(self.shape(place)), pole, carried, reactions)
        raise UsageError(
            f"there is no group {name!r}",
            where="forces",
            remedy=f"groups: {', '.join(plan.group.name for plan in reversed(self.plans))}",
        )

    def _drive(
        self,
        place: Place,
        side: Real | float,
        carried: dict[int, Wrench],
        pole: complex,
        reactions: dict[str, Reaction],
    ) -> driving.Driven:
        """The input link: its reaction with the frame, and the drive."""
        joint, shape = self.driver.joint, self.shape(place)
        seat = seat_of(joint, place.configuration)
        load = carried[self.driver.receiver].about(seat.r - pole)
        if load.force.shape != shape or load.moment.shape != shape:
            load = Wrench(np.broadcast_to(load.force, shape), np.broadcast_to(load.moment, shape))
        rubs = self.driver.coefficient > 0
        c = self.driver.coefficient * self.sense(joint, place.configuration, side) if rubs else np.zeros(())
        if isinstance(seat, Slideway):
            own = joint.links[0] == self.driver.receiver
            driven = driving.slider(load, seat, 1.0 if own else -1.0, c, self.driver.half)
        else:
            driven = driving.crank(load, self.scene.loading.drive, c)
        reactions[joint.name] = Reaction(driven.frame, driven.friction, seat)
        return driven


def _hand_on(
    group: Equilibrium,
    held: GroupReactions,
    pole: complex,
    carried: dict[int, Wrench],
    reactions: dict[str, Reaction],
) -> None:
    """Enter the reactions of a group that is solved, and load with them the links that carry it."""
    plan = group.plan
    for post, wrench, value, seat in zip(plan.posts, held.reactions, held.friction, group.seats, strict=True):
        on_higher = (wrench, value) if post.sign > 0 else (wrench.reversed(), -value)
        reactions[post.joint.name] = Reaction(*on_higher, seat)
        if post.giver not in (FRAME, *plan.group.links):
            carried[post.giver] = carried[post.giver].plus(wrench.reversed().about(pole - seat.r))


def _wrench(action: Action, factor: float | Real, pole: complex) -> Wrench:
    as_it_is = isinstance(factor, float | int) and factor == 1
    force = action.force if as_it_is else action.force * factor
    moment = action.moment if as_it_is else action.moment * factor
    if not action.pure:
        moment = moment + cross(action.at.r - pole, force)
    return Wrench(force, moment)


def compile_statics(scene: Scene, with_inertia: bool = True, scales: dict[str, Any] | None = None) -> Statics:
    """The force analysis of a scene; loads of inertia are left out of a static one.

    ``scales`` are the largest relative rates in the rubbing joints, one or a row each, where they are known.
    """
    keep_pages()
    chain, travel, loading = scene.chain, scene.travel, scene.loading
    heavy = loading.heavy if with_inertia and loading.inertia == "counted" else ()
    dynamic = [inertia(heavy, travel.speed, travel.acceleration)] if heavy else []
    pairs = {pair.joint: pair for pair in loading.pairs}
    plans = tuple(plan_of(chain.mechanism, group, pairs) for group in reversed(chain.structure.groups))
    driver = post_of(chain.input_joint, chain.structure.input_link, pairs)
    if scales is None:
        posts = (*(() if chain.structure.driven else (driver,)), *(post for plan in plans for post in plan.posts))
        scales = {post.joint.name: largest_rate(post.joint, scene) for post in posts if post.coefficient > 0}
    return Statics(scene, (*scene.sources, *dynamic), pairs, scales, plans, driver)


def largest_rate(joint: Joint, scene: Scene) -> float:
    """Largest relative rate in a joint over the survey; of a pair that never slides what counts as motion at all."""
    configuration = scene.survey.configuration
    own = float(np.max(np.abs(sliding(joint, configuration)[0])))
    around = _size(scene) if joint.kind == "prismatic" else _fastest(joint, scene)
    return own if own > STILL * around else around


def _size(scene: Scene) -> float:
    """Largest coordinate of the metric, per unit of the input coordinate."""
    if not scene.chain.turns:
        return 1.0
    mechanism = scene.chain.mechanism
    points = (p for link in (mechanism.frame, *mechanism.links) for p in link.points.values())
    pins = (p for joint in mechanism.joints for p in joint.points)
    return max(abs(p) for p in (*points, *pins)) or 1.0


def _fastest(joint: Joint, scene: Scene) -> float:
    """Largest rate of turning of the two links; of links that never turn one radian per unit of the input."""
    motions = scene.survey.configuration.motions
    return max(float(np.max(np.abs(motions[k].omega))) for k in joint.links) or 1.0


def reversals(statics: Statics) -> list[Knot]:
    """The functions at whose zeros the friction of a pair changes its sense."""

    def knot(joint: Joint) -> Knot:
        return Knot(lambda configuration: sliding(joint, configuration)[0], statics.scales[joint.name])

    return [knot(joint) for joint in statics.rubbing]
