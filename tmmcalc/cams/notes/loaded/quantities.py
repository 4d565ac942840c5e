"""The quantities of the loaded follower by their names in formulas: those of all the turn, and those of a place in it.

Forces are in N, lengths in mm, torques in N·m. A rocker has moments where a stem has forces, so their names have places
in angle brackets beside those of `tmmcalc.cams.notes.lexicon`: ``<P>_c`` is the resultant along the lift, ``<Q>_s`` the
spring, ``<O>`` the technological force, ``<m>`` the mass, ``<k>`` what brings mm to m.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from math import atan2
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.forces.state import Carried, State, carried, pivot_force, state
from tmmcalc.cams.forces.turn import Points, at_rows, loads_of, smooth_panels, weight
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.notes.lexicon import (
    NEAR,
    Told,
    angle,
    degrees_of,
    dwell_of,
    mean_speed,
    mm,
    of_follower,
    of_task,
    of_values,
    told_of,
    where,
)
from tmmcalc.cams.program import TURN, Positions
from tmmcalc.cams.rounding import sides
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Lexicon, Place
from tmmcalc.report.telling import filled, lines, named

KEPT = 1e-9  # relative: values that differ less are one
STEM = {"P": "P", "Q": "Q", "O": "Q", "m": "m_T", "k": "/10**3"}
ROCKER = {"P": "M", "Q": "M", "O": "M_Q", "m": "J_T", "k": ""}


class Found(NamedTuple):
    """What acts at a place of the turn, or on both sides of it."""

    points: Points
    now: State


Pick = Callable[[Found], Values]


class Loaded(NamedTuple):
    """A cam with its forces, as all parts of the chapter that judge them have it."""

    told: Told
    loads: Loads
    result: CamForces
    carried: Carried

    @property
    def task(self) -> CamTask:
        """The cam at the speed that the machine has."""
        return self.told.task

    @property
    def kind(self) -> str:
        """Of the follower."""
        return self.result.follower.kind

    @property
    def turns(self) -> bool:
        """The follower is a rocker."""
        return self.kind == "oscillating"

    @property
    def words(self) -> Mapping[str, str]:
        """For the places in angle brackets."""
        return {**self.told.words, **(ROCKER if self.turns else STEM)}

    def named(self, quantities: Lexicon) -> Lexicon:
        """Quantities by their names in the formulas of this follower."""
        return named({filled(name, self.words): given for name, given in quantities.items()})

    def lines(self, texts: Sequence[str], places: Sequence[Place]) -> Iterator[Block]:
        """Formulas worked out at places, of which there may be none."""
        yield from lines(texts, places, self.words) if places else ()

    def at_row(self, row: int) -> Place:
        """A row of the tables."""
        result = self.result
        found = {
            name: float(values[row])
            for name in (*FORCES, "protrusion", "lower", "upper")
            if (values := getattr(result, name)) is not None
        }
        if result.pivot is not None:
            found |= {"pivot_x": float(result.pivot[0, row]), "pivot_y": float(result.pivot[1, row])}
        return Place(self.told.labelled(row), self._named(self.points(row), found))

    def points(self, row: int) -> Points:
        """What acts in a row."""
        rows, one = self.result.positions, slice(row, row + 1)
        return at_rows(self.task, self.loads, Positions(rows.phi[one], rows.piece[one], rows.labels[one]))

    def row(self, row: int) -> Found:
        """What acts in a row, with the forces there."""
        points = self.points(row)
        return Found(points, state(self.carried, points))

    def found(self, phi: float, value: float | None = None, pick: Pick | None = None) -> Found:
        """What acts at an angle [rad]; of both sides of a jump that on which ``pick`` gives nearly ``value``."""
        points = at_rows(self.task, self.loads, sides(self.task.program, np.array([phi])))
        now = state(self.carried, points)
        k = 1 if pick is None or value is None else int(np.argmin(np.abs(pick(Found(points, now)) - value)))
        one = slice(k, k + 1)
        there = Points(
            points.phi[one], points.motion[:, one], points.sense[one], points.force[one], points.acceleration[one]
        )
        return Found(there, State._make(each[one] for each in now))

    def dwell(self, phi: float, value: float, pick: Pick) -> tuple[float, float] | None:
        """The dwell all over which a quantity has this value, that of the angle phi; None where it does not keep it."""
        on = smooth_panels(self.task, self.loads)

        def keeps(first: float, last: float) -> bool:
            at, near = np.concatenate((on.x.ravel(), on.edges)), NEAR * TURN
            inside = at[(first + near < at) & (at < last - near)]
            points = at_rows(self.task, self.loads, sides(self.task.program, inside))
            return np.allclose(pick(Found(points, state(self.carried, points))), value, rtol=KEPT, atol=0.0)

        return dwell_of(self.task.program, phi, keeps)

    def where(self, phi: float, value: float, pick: Pick) -> str:
        """The angle at which a quantity has a value, in a sentence, or the dwell over which it keeps it."""
        return where(phi, self.dwell(phi, value, pick))

    def at(self, found: Found) -> Lexicon:
        """The quantities of a place."""
        points, now = found
        side, follower = float(self.result.follower.sense), self.result.follower
        lift, acceleration = float(points.motion[0, 0]), float(points.acceleration[0])
        values = {
            "inertia": -self.carried.inertia * acceleration,
            "elastic": -(float(self.carried.preload) + float(self.carried.stiffness) * lift),
            "load": float(now.load[0]),
            "theta": atan2(now.sine[0], now.cosine[0]),
            "ratio": float(now.ratio[0]),
            "contact": float(now.contact[0]),
            "torque": -float(now.torque[0]),
            "driving": float(now.driving[0]),
        }
        if self.carried.guide is not None:
            values |= {"lower": side * float(now.lower[0]), "upper": side * float(now.upper[0])}
            values["protrusion"] = float(now.protrusion[0])
        if self.turns:
            pressed = pivot_force(follower, points.motion, now.contact, now.sine, now.cosine)
            values |= {"pivot_x": float(pressed[0, 0]), "pivot_y": float(pressed[1, 0])}
        return self._named(points, values)

    def _named(self, points: Points, found: Mapping[str, float]) -> Lexicon:
        """Everything at a point with the forces that were found there."""
        own = _moved(self, points) | _forces(self, found, float(points.force[0]))
        return self.named(of_scene(self) | own)


FORCES = ("inertia", "elastic", "load", "theta", "ratio", "contact", "torque", "driving")


def loaded_of(order: Order) -> Loaded:
    """The cam of a run with its forces."""
    told, result = told_of(order), order.results["cam_forces"]
    loads = loads_of(told.task)
    spring = result.spring
    return Loaded(told, loads, result, carried(told.task, result.follower, loads, spring.stiffness, spring.preload))


def of_scene(of: Loaded) -> Lexicon:
    """What is the same all over the turn."""
    loads, result = of.loads, of.result
    found = of_task(of.told) | mean_speed(of.told) | of_follower(result.follower)
    found["<m>"] = (
        Given(loads.mass, "kg*m^2", tr("moment of inertia of the rocker about its pivot"))
        if of.turns
        else Given(loads.mass, "kg", tr("mass of the follower and of what moves with it"))
    )
    found["G"] = Given(weight(of.task, loads), "N", tr("weight of the follower along the lift"))
    found |= of_spring(of)
    guide = result.guide
    if guide is not None:
        found["H_1"] = mm(guide.lower, tr("height of the lower edge of the guide above the axis of the cam"))
        found["H_2"] = mm(guide.top, tr("height of the upper edge of the guide above the axis of the cam"))
        found["l"] = mm(guide.length, tr("length of the guide"))
        found["Delta_g"] = mm(of.task.guide.gap, tr("gap between the roller at its highest and the guide"))
    if of.turns:
        found["f_A"] = Given(loads.pivot_friction, "", tr("coefficient of friction in the pivot"))
        found["r_A"] = mm(loads.pivot_radius, tr("radius of the pivot"))
    else:
        found["f_T"] = Given(loads.friction, "", tr("coefficient of friction of the stem in its guide"))
    return found


def of_spring(of: Loaded) -> Lexicon:
    """Stiffness and preload."""
    spring, highest = of.result.spring, of.task.program.highest
    force, rate = ("N*m", "N*m/rad") if of.turns else ("N", "N/mm")
    top = tr("force of the spring in the highest position")
    if of.turns:
        top = tr("moment of the spring in the highest position")
    found = {
        "c": Given(of_rate(of, spring.stiffness), rate, tr("stiffness of the return spring")),
        "<Q>_0": Given(spring.preload, force, tr("preload of the spring in the lowest position")),
        "<Q>_max": Given(spring.highest, force, top),
    }
    meaning = tr("largest displacement")
    found["<dy>_max"] = Given(highest, "rad", meaning) if of.turns else mm(highest, meaning)
    if spring.asked is not None:
        found["K_1"] = Given(spring.asked, "", tr("safety factor of the closure of the pair"))
    return found


def of_rate(of: Loaded, stiffness: float) -> float:
    """A stiffness [SI] in the unit of the formulas."""
    return stiffness if of.turns else 1e-3 * stiffness


def _moved(of: Loaded, points: Points) -> Lexicon:
    """Motion and speed at a point; the angle of a rocker by which the spring turns is in rad."""
    speed, eps = of.loads.speed, 0.0
    if of.task.turning is not None:
        speed, eps = (float(each[0]) for each in of.task.turning.at(points.phi))
    found = of_values(of.told, points.motion[:, 0]) | {
        "phi": angle(float(points.phi[0]), tr("angle of the cam from the beginning of the rise")),
        "omega": Given(speed, "rad/s", tr("angular velocity of the cam")),
        "eps": Given(eps, "rad/s^2", tr("angular acceleration of the cam")),
    }
    if of.turns:
        found["<dy>"] = Given(float(points.motion[0, 0]), "rad", tr("angle of the rocker from its lowest position"))
    return found


def _forces(of: Loaded, found: Mapping[str, float], given: float) -> Lexicon:
    """Forces along the lift and reactions; of a rocker moments about its pivot."""
    own = given - weight(of.task, of.loads)
    if of.turns:
        unit, said = "N*m", (
            tr("moment of inertia forces"),
            tr("moment of the spring"),
            tr("technological moment"),
            tr("resultant moment about the pivot; it presses on the cam where it is negative"),
        )  # fmt: skip
    else:
        unit, said = "N", (
            tr("inertia force along the lift"),
            tr("force of the spring along the lift"),
            tr("technological force along the lift"),
            tr("resultant along the lift; it presses on the cam where it is negative"),
        )  # fmt: skip
    driving = tr("driving torque of the camshaft")
    if of.carried.rubs:
        driving = tr("driving torque of the camshaft, with friction")
    values = (found["inertia"], found["elastic"], own, found["load"])
    quantities = {
        name: Given(value, unit, meaning)
        for name, value, meaning in zip(("<P>_j", "<Q>_s", "<O>", "<P>_c"), values, said, strict=True)
    }
    quantities |= {
        "theta": angle(found["theta"], tr("pressure angle of the cam")),
        "mu": Given(found["ratio"], "", tr("friction over the force of the cam")),
        "R": Given(found["contact"], "N", tr("force of the cam on the follower")),
        "T": Given(found["torque"], "N*m", tr("torque of the follower on the camshaft, without friction")),
        "M_d": Given(found["driving"], "N*m", driving),
    }
    if "lower" in found:
        quantities["N_1"] = Given(found["lower"], "N", tr("reaction of the lower edge of the guide"))
        quantities["N_2"] = Given(found["upper"], "N", tr("reaction of the upper edge of the guide"))
    if "protrusion" in found:
        quantities["q"] = mm(found["protrusion"], tr("length of the stem from the roller centre to the guide"))
    if "pivot_x" in found:
        x, y, meaning = found["pivot_x"], found["pivot_y"], tr("force of the frame on the rocker in its pivot")
        quantities |= {"R_Ax": Given(x, "N", meaning), "R_Ay": Given(y, "N", meaning)}
        quantities["R_A"] = Given(float(np.hypot(x, y)), "N", tr("size of this force"))
    return quantities


def shown_angle(phi: float) -> str:
    """An angle of the cam [rad] in a sentence.

    >>> shown_angle(np.pi / 8)
    '22.5°'
    """
    return f"{degrees_of(phi)}°"


def listed(spans: Iterable[tuple[float, float]]) -> str:
    """Intervals of angles of the cam [rad] in a sentence."""
    return ", ".join(tr("between {low} and {high}", low=shown_angle(a), high=shown_angle(b)) for a, b in spans)
