"""Values of technological loads along the motion, with the places where they are not smooth."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

from tmmcalc.errors import NoSolutionError
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.loading import Constant, Indicator, Load, Polynomial, Tabulated
from tmmcalc.linkage.loads.laws import interpolant, polynomial, pressure_of
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.loads.strokes import Displacement, displacement_of, piston_of
from tmmcalc.linkage.loads.travel import EDGE, Travel
from tmmcalc.linkage.loads.windows import Inside
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.results import Grade, Kinematics
from tmmcalc.linkage.survey import Survey


class Knot(NamedTuple):
    """A function of the configuration at whose zeros a load is not smooth, and its scale."""

    rate: Callable[[Configuration], Real]
    scale: float


class Value(NamedTuple):
    """A load's value (n,) [N or N*m] at a place, and where it is not smooth: angles theta, zeros of knots."""

    at: Callable[[Place], Real]
    angles: list[float]
    knots: list[Knot]
    grades: tuple[Grade, ...] = ()


def value_of(chain: Chain, kinematics: Kinematics, travel: Travel, dense: Survey, load: Load, window: Inside) -> Value:
    """The value of a load that depends on the position; a polynomial counts from the beginning of its window."""
    law = load.law
    if isinstance(law, Constant):
        return Value(lambda place: np.full(np.shape(place.theta), law.value), [], [])
    if isinstance(law, Polynomial):
        return Value(lambda place: polynomial(law, window.since(place.theta)), [], [])
    if isinstance(law, Tabulated):
        if law.of in ("angle", "position"):
            return _of_angle(travel, law, f"load {load.name}")
        return _of_displacement(chain, kinematics, travel, dense, law, f"load {load.name}")
    assert isinstance(law, Indicator)
    return _indicated(chain, travel, dense, load, law)


def _of_angle(travel: Travel, law: Tabulated, where: str) -> Value:
    x = law.x if law.of == "angle" else _positions(law, travel, where)
    period = (law.period or TURN) if travel.whole else None
    f = interpolant(x, law.values, law.interpolation, period)
    return Value(lambda place: f(place.theta), travel.repeated(x, period or TURN), [])


def _of_displacement(
    chain: Chain, kinematics: Kinematics, travel: Travel, dense: Survey, law: Tabulated, where: str
) -> Value:
    displacement = displacement_of(chain, kinematics, travel, dense, law.output, where)
    unit = displacement.reach if law.of == "stroke" else 1.0
    f = interpolant(law.x, law.values, law.interpolation)

    def from_knot(at: float, configuration: Configuration) -> Real:
        return displacement.at(configuration) - at

    inner = [x * unit for x in law.x if EDGE < x * unit / displacement.reach < 1 - EDGE]
    return Value(
        lambda place: f(displacement.at(place.configuration) / unit),
        travel.repeated(displacement.turning),
        [Knot(partial(from_knot, at), displacement.reach) for at in inner],
        tuple(_beyond(displacement, law, unit, where)),
    )


def _beyond(displacement: Displacement, law: Tabulated, unit: float, where: str) -> Iterator[Grade]:
    """What of a table the output never reaches."""
    low, high, reach = law.x[0] * unit, law.x[-1] * unit, displacement.reach
    if high <= reach * (1 + EDGE):
        return
    said, factor = ("deg", math.degrees(1.0)) if displacement.output.link is not None else ("mm", 1e3)
    text = f"goes to {high * factor:.5g} {said}, but the stroke of {displacement.output.name} is {reach * factor:.5g}"
    only = "; the whole table lies beyond it, and its first value holds throughout" if low >= reach else ""
    yield Grade("warning", where, f"its table {text} {said}{only}")


def _indicated(chain: Chain, travel: Travel, dense: Survey, load: Load, law: Indicator) -> Value:
    piston = piston_of(chain, travel, load, dense)
    pressure = pressure_of(law, piston)
    reach = piston.high - piston.low

    def from_knot(at: float, configuration: Configuration) -> Real:
        return piston.coordinate(configuration) - at

    inner = sorted({x for at, _ in law.strokes for x in at if EDGE < x < 1 - EDGE})
    return Value(
        lambda place: law.area * pressure(place.theta, piston.coordinate(place.configuration)),
        travel.repeated(pressure.edges, pressure.period),
        [Knot(partial(from_knot, piston.low + x * reach), reach) for x in inner],
    )


def _positions(law: Tabulated, travel: Travel, where: str) -> tuple[float, ...]:
    """theta of the numbered positions that a table names."""
    labels = travel.labels
    missing = next((x for x in law.x if f"{x:g}" not in labels), None)
    if missing is not None:
        raise NoSolutionError(
            f"there is no position {missing:g}; the grid has {len(labels)} positions",
            where=where,
            remedy="give one value a position, or a table of the angle",
        )
    return tuple(labels[f"{x:g}"] for x in law.x)
