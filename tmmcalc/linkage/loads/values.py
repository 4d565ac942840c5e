"""Values of technological loads along the motion, with the places where they are not smooth."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.loading import Constant, Indicator, Load, Polynomial, Tabulated
from tmmcalc.linkage.loads.coverage import of_displacement, of_range
from tmmcalc.linkage.loads.laws import interpolant, polynomial, pressure_of
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.loads.strokes import displacement_of, piston_of
from tmmcalc.linkage.loads.travel import EDGE, Travel
from tmmcalc.linkage.loads.windows import Inside
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
            return _of_angle(travel, dense, load, law, window)
        return _of_displacement(chain, kinematics, travel, dense, load, law, window)
    assert isinstance(law, Indicator)
    return _indicated(chain, travel, dense, load, law)


def _of_angle(travel: Travel, dense: Survey, load: Load, law: Tabulated, window: Inside) -> Value:
    x = law.x if law.of == "angle" else _positions(law, travel, f"load {load.name}")
    period = (law.period or TURN) if travel.whole else None
    f = interpolant(x, law.values, law.interpolation, period)
    grades = () if period else tuple(of_range(travel, dense, load, law, np.array(x), window))
    return Value(lambda place: f(place.theta), travel.repeated(x, period or TURN), [], grades)


def _of_displacement(
    chain: Chain,
    kinematics: Kinematics,
    travel: Travel,
    dense: Survey,
    load: Load,
    law: Tabulated,
    window: Inside,
) -> Value:
    displacement = displacement_of(chain, kinematics, travel, dense, law.output, f"load {load.name}")
    unit = displacement.reach if law.of == "stroke" else 1.0
    f = interpolant(law.x, law.values, law.interpolation)

    def from_knot(at: float, configuration: Configuration) -> Real:
        return displacement.at(configuration) - at

    inner = [x * unit for x in law.x if EDGE < x * unit / displacement.reach < 1 - EDGE]
    return Value(
        lambda place: f(displacement.at(place.configuration) / unit),
        travel.repeated(displacement.turning),
        [Knot(partial(from_knot, at), displacement.reach) for at in inner],
        tuple(of_displacement(travel, dense, load, law, window, displacement, unit)),
    )


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
