"""Columns by choice of the reduction table: what every link, load and pair adds, and the ordinates of Simpson's rule.

    J = sum of m |S'|^2 + J_S w'^2 by link (3.39)        M of a load = P S', of a moment M w' (3.34)

Of a mechanism they are evaluated once more at the rows of the result, and nothing before a column is made. Friction is
taken at the mean speed with the loads of inertia in the reactions, as in the moment of all friction (3.3.1.6).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.forces.further import FRICTION_REDUCED
from tmmcalc.linkage.forces.verification import friction_power
from tmmcalc.linkage.loading import Body, Load, Loading
from tmmcalc.linkage.loads.scene import Scene, compile_scene
from tmmcalc.linkage.loads.sources import Action, Place, same_place
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.machine.attached import Attached
from tmmcalc.machine.reduction.causes import Causes, causes_of
from tmmcalc.machine.reduction.inertia import lumped, reduced_inertia
from tmmcalc.machine.reduction.ordinates import ordinate_columns
from tmmcalc.machine.reduction.results import Reduction

OF_LINK = (
    Quantity("{inertia}_red_{link}[{unit}]", "what link {link} adds to the {mass}", source="(3.39)"),
    Quantity("{inertia}_red_{link}_mass[{unit}]", "what the mass of link {link} adds to it: m |S'|^2", source="(3.39)"),
    Quantity(
        "{inertia}_red_{link}_turning[{unit}]", "what the turning of link {link} adds to it: J_S w'^2", source="(3.39)"
    ),
    Quantity("d{inertia}_red_{link}[{unit}/{per}]", "what link {link} adds to the slope of the {mass}"),
)
OF_ATTACHED = (
    Quantity("J_red_{name}[kg*m^2]", "what the {name} adds to the reduced inertia"),
    Quantity("dJ_red_{name}[kg*m^2/rad]", "what the {name} adds to the slope of the reduced inertia"),
)
OF_WEIGHT = Quantity("{letter}_red_weight_{link}[{unit}]", "{force} of the weight of link {link}", source="(3.34)")
VALUE = Quantity("load_{load}[{unit}]", "value of load {load} along its direction", source="(3.34)")
TRANSFER = Quantity(
    "dS_of_{load}[{value}/{per}]",
    "transfer function of the point of load {load} along its direction, or of the angle that its moment turns",
    source="(3.34)",
)
NOISE = 1e-12  # of what a weight could do: a moment that is rounding, where it moves sideways


class Input(NamedTuple):
    """What stands for moment and inertia of an input that turns, or that slides."""

    force: tuple[str, str, str]  # word, letter, unit
    mass: tuple[str, str, str]
    per: str  # unit of the input coordinate

    @classmethod
    def of(cls, turns: bool) -> Input:
        """By the kind of the input."""
        if turns:
            return cls(("reduced moment", "M", "N*m"), ("reduced inertia", "J", "kg*m^2"), "rad")
        return cls(("reduced force", "F", "N"), ("reduced mass", "m", "kg"), "m")


class Linkage(NamedTuple):
    """The mechanism that is reduced, with its kinematics; ``turns`` of the crank are those of what is beside it."""

    mechanism: Mechanism
    loading: Loading
    kinematics: Kinematics
    turns: int = 1


def further_columns(
    result: Reduction, linkage: Linkage | None = None, attached: Sequence[Attached] = ()
) -> list[Column]:
    """All columns by choice of a result: inertias, weights, loads, friction, then the ordinates of all works."""
    own = [] if linkage is None else _of_linkage(_Parts(result, linkage))
    return [*own, *(each for one in attached for each in _of_attached(result, one)), *ordinate_columns(result)]


def _of_linkage(parts: _Parts) -> list[Column]:
    kind = Input.of(parts.result.turns)
    (word, letter, unit), found = kind.mass, list[Column]()
    for link in dict.fromkeys(body.link for body in parts.loading.heavy):
        places = {"inertia": letter, "unit": unit, "link": link, "per": kind.per, "mass": word}
        for told, make in zip(OF_LINK, parts.inertias(link), strict=True):
            found.append(column(told.of(**places), make))
    word, letter, unit = kind.force
    for link in parts.weighing:
        told = OF_WEIGHT.of(letter=letter, unit=unit, link=link, force=word)
        found.append(column(told, partial(parts.weight, link)))
    for load in parts.loading.loads:
        if load.factor:
            force, value = ("N", "m") if load.kind == "force" else ("N*m", "rad")
            found.append(column(VALUE.of(load=load.name, unit=force), partial(parts.value, load)))
            transfer = TRANSFER.of(load=load.name, value=value, per=kind.per)
            found.append(column(transfer, partial(parts.transfer, load)))
    for pair in parts.rubbing:
        told = FRICTION_REDUCED.of(joint=pair, letter=letter, unit=unit)
        found.append(column(told, partial(parts.friction, pair)))
    return found


def _of_attached(result: Reduction, attached: Attached) -> Iterator[Column]:
    theta, sense = np.abs(result.phi - result.phi[0]), 1.0 if result.speed > 0 else -1.0
    inertia, slope = (told.of(name=attached.name) for told in OF_ATTACHED)
    yield column(inertia, lambda: attached.along(attached.inertia, theta))
    yield column(slope, lambda: sense * attached.along(attached.slope, theta))


class _Parts:
    """The rows of a result with what it was computed from, each part found when it is first asked for."""

    def __init__(self, result: Reduction, linkage: Linkage) -> None:
        mechanism, loading = linkage.mechanism, linkage.loading
        if result.rods == "lumped":
            loading = replace(loading, bodies=lumped(mechanism, loading, result.rod_links))
        self.result, self.linkage, self.loading = result, linkage, loading
        massive = [body.link for body in loading.bodies if body.mass > 0]
        self.weighing = tuple(dict.fromkeys(massive)) if loading.gravity else ()
        rubs = {pair.joint for pair in loading.pairs if pair.friction}
        radii = {pair.joint for pair in loading.pairs if pair.radius}
        joints = [joint for joint in mechanism.joints if joint.name in rubs]
        self.rubbing = tuple(joint.name for joint in joints if joint.kind == "prismatic" or joint.name in radii)

    @cached_property
    def scene(self) -> Scene:
        """The scene of the result."""
        return compile_scene(self.linkage.mechanism, self.loading, self.linkage.kinematics, self.linkage.turns)

    @cached_property
    def theta(self) -> Real:
        """The angles (n,) of the rows along the motion."""
        return self.scene.travel.rows(self.linkage.kinematics)[0]

    @cached_property
    def place(self) -> Place:
        """The configuration of the rows."""
        return self.scene.place(self.theta, self.scene.travel.sides(self.theta))

    def inertias(self, link: int) -> tuple[Callable[[], Real], ...]:
        """What a link adds to J, by its mass and by its turning alone, and to dJ, in the order of `OF_LINK`."""
        own = [body for body in self.loading.heavy if body.link == link]
        still, light = ([replace(b, inertia=0.0) for b in own], [replace(b, mass=0.0) for b in own])

        def made(bodies: list[Body], part: int) -> Real:
            return reduced_inertia(bodies, self.place.configuration, len(self.theta))[part]

        return partial(made, own, 0), partial(made, still, 0), partial(made, light, 0), partial(made, own, 1)

    def weight(self, link: int) -> Real:
        """Reduced moment (n,) of the weight of a link."""
        source = next(source for source in self.scene.sources if source.kind == "weight")
        own = [each for each in source.actions(self.place) if each.link == link]
        power = self._over(sum((each.power(self.place.configuration) for each in own), np.zeros(())))
        most = sum(float(np.max(np.abs(each.force) * np.abs(each.at.v))) for each in own)
        return np.where(np.abs(power) > NOISE * most, power, 0.0)

    def value(self, load: Load) -> Real:
        """The load (n,) along its direction, at the mean speed."""
        source = next(s for s in self.scene.sources if (s.name, s.kind) == (load.name, "load"))
        action, factor = self._acting(load), source.factor(self.scene.travel.speed)
        if load.kind == "moment":
            return self._over(action.moment * factor)
        return self._over((np.conj(self._direction(load)) * action.force).real * factor)

    def transfer(self, load: Load) -> Real:
        """The transfer function (n,) of its point along its direction, or of the angle between its links."""
        motions, action = self.place.configuration.motions, self._acting(load)
        if load.kind == "moment":
            return self._over(motions[load.link].omega - motions[load.against].omega)
        other = same_place(motions[load.against], action.at)
        return self._over((np.conj(self._direction(load)) * (action.at.v - other.v)).real)

    def _acting(self, load: Load) -> Action:
        source = next(s for s in self.scene.sources if (s.name, s.kind) == (load.name, "load"))
        return next(action for action in source.actions(self.place) if action.link == load.link)

    def _direction(self, load: Load) -> Plane:
        return load.direction * self.place.configuration.motions[load.follows].u

    @cached_property
    def _lost(self) -> dict[str, Real]:
        """Friction (n,) of every pair, reduced to the input, with the technological loads."""
        causes: Causes = causes_of(self.scene)
        statics = causes.statics
        state, shape = statics.solve(self.place, self.place.side), statics.shape(self.place)
        found = friction_power(statics, state, self.place)
        return {joint: np.broadcast_to(each, shape).reshape(-1, len(self.theta))[0] for joint, each in found.items()}

    def friction(self, joint: str) -> Real:
        """Friction (n,) in a pair reduced to the input."""
        return self._lost[joint]

    def _over(self, values: Real) -> Real:
        return np.broadcast_to(values, self.theta.shape)
