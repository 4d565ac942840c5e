"""The links of a machine at the positions that the note works out: their quantities in time by names in formulas."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Point, Real
from tmmcalc.linkage.chain import Configuration
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Lexicon, Place
from tmmcalc.report.telling import STILL, named, vector


class Mass(NamedTuple):
    """A body with its names in formulas."""

    body: Body
    index: str  # type: ignore[assignment]  # ``3`` of m_3; of a rod lumped in its pins ``3A``
    centre: str  # ``S3``

    @property
    def mass(self) -> str:
        """Its mass."""
        return f"m_{{{self.index}}}"

    @property
    def inertia(self) -> str:
        """Its moment of inertia."""
        return f"J_{self.body.link}"


class Moving(NamedTuple):
    """A linkage at n positions of its motion, with the quantities of each that formulas have so far."""

    mechanism: Mechanism
    kinematics: Kinematics
    configuration: Configuration  # by the input coordinate
    rows: Sequence[int]  # of the kinematics
    lexicons: Sequence[Lexicon]

    @property
    def link(self) -> int:
        """The input link."""
        return self.kinematics.structure.input_link

    @property
    def rate(self) -> str:
        """The name of the input's speed: ``omega_1``, of a slider ``v_1``."""
        return f"{'omega' if self.kinematics.turns else 'v'}_{self.link}"

    @property
    def acceleration(self) -> str:
        """The name of its acceleration."""
        return f"{'eps' if self.kinematics.turns else 'a'}_{self.link}"

    @property
    def places(self) -> list[Place]:
        """The positions as places of lines."""
        labels = (self.kinematics.labels[row] for row in self.rows)
        return [Place(tr("pos. {label}", label=label), own) for label, own in zip(labels, self.lexicons, strict=True)]

    def timed(self, at: Point) -> tuple[Plane, Plane, Plane]:
        """A point (n,) in time: place [m], velocity [m/s], acceleration [m/s^2]."""
        speed, acceleration = self.kinematics.speed, self.kinematics.acceleration
        n = len(self.rows)
        every: list[Any] = [at.r, at.v * speed, at.a * speed**2 + at.v * acceleration]
        place, velocity, second = (np.broadcast_to(each, n) for each in every)
        return place, velocity, second

    def point(self, name: str, at: Point) -> None:
        """Put coordinates, velocity and acceleration of a point into the lexicons, by its name."""
        for lexicon, place, velocity, second in zip(self.lexicons, *self.timed(at), strict=True):
            for letter, unit, value, meaning in (
                ("", "m", place, tr("coordinates of point {point}", point=name)),
                ("v", "m/s", velocity, tr("projections of the velocity of {point}", point=name)),
                ("a", "m/s^2", second, tr("projections of the acceleration of {point}", point=name)),
            ):
                key = f"{letter}_{{{name}%}}" if letter else f"%_{{{name}}}"
                parts = complex(cleaned(value.real), cleaned(value.imag))
                lexicon |= named(vector(key, parts, unit, meaning))

    def turning(self, link: int) -> None:
        """Put angular velocity and acceleration of a link into the lexicons."""
        if link == FRAME:
            self.give("omega_0", 0.0, "rad/s")
            return
        motion, result = self.configuration.motions[link], self.kinematics
        omega, eps = result.in_time(motion.omega, motion.eps)
        self.give(f"omega_{link}", omega, "rad/s", tr("angular velocity of link {link}", link=link))
        self.give(f"eps_{link}", eps, "rad/s^2", tr("angular acceleration of link {link}", link=link))

    def give(self, key: str, values: Real | float, unit: str, meaning: str = "") -> None:
        """Put a quantity (n,) into the lexicons."""
        for lexicon, value in zip(self.lexicons, np.broadcast_to(values, len(self.rows)), strict=True):
            lexicon |= named({key: Given(cleaned(value), unit, meaning)})


def cleaned(value: float) -> float:
    """A value, zero where it is nothing."""
    return float(value) if abs(value) > STILL else 0.0


def moving(scene: Scene, kinematics: Kinematics, rows: Sequence[int], configuration: Configuration) -> Moving:
    """The linkage with the speed of its input."""
    found = Moving(scene.chain.mechanism, kinematics, configuration, rows, [{} for _ in rows])
    if kinematics.turns:
        found.turning(found.link)
    else:
        found.give(found.rate, kinematics.speed, "m/s", tr("velocity of the input link"))
        found.give(found.acceleration, kinematics.acceleration, "m/s^2", tr("acceleration of the input link"))
    return found


def masses_of(found: Moving, bodies: Iterable[Body]) -> list[Mass]:
    """The bodies with their names; their quantities are put into the lexicons."""
    bodies = list(bodies)
    alone = [body.link for body in bodies]
    told = []
    for body in bodies:
        link, centre = body.link, point_name(found.mechanism, body.link, body.center)
        lumped = alone.count(link) > 1
        mass = Mass(body, f"{link}{centre}" if lumped else str(link), centre)
        said = tr("mass of link {link} lumped in {point}", link=link, point=centre)
        found.give(mass.mass, body.mass, "kg", said if lumped else tr("mass of link {link}", link=link))
        found.give(
            mass.inertia,
            body.inertia,
            "kg*m^2",
            tr("moment of inertia of link {link} about its centre of mass", link=link),
        )
        found.turning(link)
        found.point(centre, found.configuration.motions[link].point(body.center))
        told.append(mass)
    return told


def point_name(mechanism: Mechanism, link: int, at: complex, other: str = "") -> str:
    """The name of a point of a link; of one without a name the ``other``, or that of a centre of mass."""
    own = (plain_name(pin.name) for pin in find_pins(mechanism) if pin.at.get(link) == at)
    return next(own, other or f"S{link}")
