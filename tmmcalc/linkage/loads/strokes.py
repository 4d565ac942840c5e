"""Strokes of outputs and of pistons: where they begin, which way they go, how far."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.crossings import crossings
from tmmcalc.linkage.loading import Load
from tmmcalc.linkage.loads.sources import Place, same_place
from tmmcalc.linkage.loads.travel import EDGE, Travel
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.outputs import coordinate_of, default_outputs, sampled
from tmmcalc.linkage.results import Kinematics, OutputSummary
from tmmcalc.linkage.survey import Survey

Flags = NDArray[np.bool_]

REST = 1e-9  # a rate of an output below this part of the largest is rest


class Strokes(NamedTuple):
    """The working and the idle strokes of an output."""

    chain: Chain
    travel: Travel
    output: Output
    sense: float  # sign of the rate along the motion on the working stroke
    beginnings: tuple[tuple[float, ...], tuple[float, ...]]  # theta at which working and idle strokes begin
    turning: tuple[float, ...]  # theta of the dead centres
    rate: float  # largest rate, its scale

    def on(self, place: Place, which: int) -> Flags:
        """Which positions (n,) belong to the working (0) or to an idle stroke (1).

        A dead centre belongs to both; at the ends of the motion only to the one after or before it.
        """
        _, rate, rate2 = coordinate_of(self.chain, self.output, place.configuration)
        wanted = self.sense * (1 if which == 0 else -1)
        rate = np.where(np.abs(rate) <= REST * self.rate, 0.0, rate * self.travel.sense * wanted)
        begin, end = place.theta <= EDGE, self.travel.ends(place.theta)
        nearby = np.where(begin, rate2, np.where(end, -rate2, 0.0)) * wanted
        return (rate > 0) | ((rate == 0) & (nearby >= 0))


def strokes_of(chain: Chain, kinematics: Kinematics, travel: Travel, name: str | None, where: str) -> Strokes:
    """The strokes of the output of this name (None: the first); raises `NoSolutionError` if it has none."""
    output, summary = _output(chain, kinematics, name, where)
    centres = summary.dead_centres
    if len(centres) < 2:
        raise NoSolutionError(
            f"output {output.name} has {len(centres)} dead centre{'' if len(centres) == 1 else 's'} in the analysed "
            "range, so it has no working and idle stroke",
            where=where,
            remedy='say where the load acts by angles: between = ["30 deg", "180 deg"]',
        )
    theta = travel.theta(np.array([centre.x for centre in centres]))
    if not travel.whole:
        theta = np.sort(theta)
    middle = theta[:1] + np.mod(theta[1] - theta[0], TURN if travel.whole else travel.period) / 2
    rate = coordinate_of(chain, output, chain.evaluate(travel.x(middle)))[1]
    first = math.copysign(1.0, float(np.ravel(rate)[0]) * travel.sense)
    sense = _working(output, first) if not travel.whole else first
    scale = max(abs(extreme.value) for extreme in summary.velocity) / abs(travel.speed)
    beginnings = _beginnings(theta.tolist(), travel)
    return Strokes(
        chain, travel, output, sense, beginnings if sense == first else beginnings[::-1], tuple(theta.tolist()), scale
    )


def _working(output: Output, first: float) -> float:
    """Sense of the working stroke in an open range: against the useful resistance, or else the first whole stroke's."""
    if output.resistance is None:
        return first
    return -1.0 if output.resistance == "positive" else 1.0


def _beginnings(theta: list[float], travel: Travel) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """theta at which the strokes of the first one's sense and the others begin; the first of an open range is cut."""
    others = theta[1::2] if travel.whole else [0.0, *theta[1::2]]
    return tuple(theta[0::2]), tuple(others)


def _output(chain: Chain, kinematics: Kinematics, name: str | None, where: str) -> tuple[Output, OutputSummary]:
    outputs = default_outputs(chain)
    k = next((i for i, output in enumerate(outputs) if name is None or output.name == name), None)
    if k is None:
        raise NoSolutionError(
            f"there is no output {name!r}" if outputs else "the mechanism has no output",
            where=where,
            remedy="name the output in [[mechanism.outputs]]",
        )
    return outputs[k], kinematics.summaries[k]


class Displacement(NamedTuple):
    """The displacement of an output from its lesser extreme."""

    chain: Chain
    output: Output
    low: float  # the lesser extreme [m or rad]
    reach: float  # the whole stroke
    turning: tuple[float, ...]  # theta of the dead centres

    def at(self, configuration: Configuration) -> Real:
        """Distance from the lesser extreme (n,), from 0 to the stroke [m or rad]."""
        value = coordinate_of(self.chain, self.output, configuration)[0] - self.low
        if self.output.link is not None:
            value = value - TURN * np.floor((value + EDGE) / TURN)
        return np.clip(value, 0.0, self.reach)


def displacement_of(
    chain: Chain, kinematics: Kinematics, travel: Travel, dense: Survey, name: str | None, where: str
) -> Displacement:
    """The displacement of the output of this name (None: the first); the ends of an open range count as extremes.

    Raises `NoSolutionError` for an output that stands still or that goes round.
    """
    output, summary = _output(chain, kinematics, name, where)
    track = sampled(chain, output, dense)[0]
    extremes = [centre.value for centre in summary.dead_centres]
    if not travel.whole:
        extremes += [float(track[0]), float(track[-1])]
    reach = max(extremes) - min(extremes) if extremes else 0.0
    rounds = travel.whole and output.link is not None and abs(track[-1] - track[0]) > 1
    if rounds or reach <= REST * float(np.max(np.abs(track))):
        raise NoSolutionError(
            f"output {output.name} {'goes round' if rounds else 'does not reverse'}, so it has no stroke to measure",
            where=where,
            remedy='give the load as a table of the angle: of = "angle"',
        )
    theta = travel.theta(np.array([centre.x for centre in summary.dead_centres]))
    return Displacement(chain, output, min(extremes), reach, tuple(theta.tolist()))


class Piston(NamedTuple):
    """A piston's motion along its cylinder: extremes of its coordinate, and theta of its dead centres."""

    load: Load
    low: float  # coordinate of the outer dead centre (at the closed end) [m]
    high: float
    outer: float  # theta of the outer dead centre [rad]
    inner: float  # of the inner one, at the crank's side

    def coordinate(self, configuration: Configuration) -> Real:
        """Coordinate (n,) of the load's point along its direction, in the link that the direction turns with [m]."""
        return _along(self.load, configuration)[0]


def _along(load: Load, configuration: Configuration) -> tuple[Real, Real]:
    """Coordinate of the load's point along its direction, and its rate."""
    cylinder = configuration.motions[load.follows]
    at = configuration.motions[load.link].point(load.point)
    back = np.conj(load.direction * cylinder.u)
    return (back * (at.r - cylinder.r)).real, (back * (at.v - same_place(cylinder, at).v)).real


def piston_of(chain: Chain, travel: Travel, load: Load, dense: Survey) -> Piston:
    """The motion of a load's point along its direction; it must go out and in once a turn."""
    if not travel.whole:
        raise NoSolutionError(
            "an indicator diagram needs a crank that turns fully",
            where=f"load {load.name}",
            remedy="give the force as a table of the displacement",
        )
    (at,) = crossings(chain, lambda c: [_along(load, c)[1]], [1.0], dense)
    if at.size != 2:
        raise NoSolutionError(
            f"the point of the load reverses {at.size} times a turn along its direction; a piston reverses twice",
            where=f"load {load.name}",
            remedy="direct the load along the cylinder, from its closed end to the crank",
        )
    value = np.broadcast_to(_along(load, chain.evaluate(at))[0], at.shape)
    theta = travel.theta(at)
    outer = int(np.argmin(value))
    return Piston(load, float(value.min()), float(value.max()), float(theta[outer]), float(theta[1 - outer]))
