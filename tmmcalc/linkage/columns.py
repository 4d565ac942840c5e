"""The columns of the kinematics table: one name and one unit for each quantity, everywhere.

Dimensionless values are in units of the crank length l_1 and its speed omega_1; they do not depend on the
speed. A column is computed when it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.columns import Column, column, degrees
from tmmcalc.core.errors import UsageError
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.results import Kinematics

PHI = Quantity("phi[{unit}]", "input coordinate counted from position 0")
OMEGA_1 = Quantity("omega_1[rad/s]", "speed of the crank, the unit of dimensionless speeds")
# value, velocity, acceleration, first and second transfer function of each
OUTPUT = (
    Quantity("S_{output}[{own}]", "displacement of output {output} from position 0"),
    Quantity("vS_{output}[{velocity}]", "velocity of output {output}"),
    Quantity("aS_{output}[{acceleration}]", "acceleration of output {output}"),
    Quantity("dS_{output}[{value}/{per}]", "first transfer function of output {output}"),
    Quantity("ddS_{output}[{value}/{per}^2]", "second transfer function of output {output}"),
)
LINK = (
    Quantity("angle_{link}[deg]", "angle of link {link}"),
    Quantity("omega_{link}[{omega}]", "angular velocity of link {link}"),
    Quantity("eps_{link}[{eps}]", "angular acceleration of link {link}"),
    Quantity("dangle_{link}[rad/{per}]", "first transfer function of the angle of link {link}"),
    Quantity("ddangle_{link}[rad/{per}^2]", "second transfer function of the angle of link {link}"),
)
POINT = (
    Quantity("{axis}_{point}[{length}]", "{axis} of point {point}"),
    Quantity("v{axis}_{point}[{velocity}]", "velocity of point {point} along {axis}"),
    Quantity("a{axis}_{point}[{acceleration}]", "acceleration of point {point} along {axis}"),
    Quantity("d{axis}_{point}[{length}/{per}]", "first transfer function of {axis} of point {point}"),
    Quantity("dd{axis}_{point}[{length}/{per}^2]", "second transfer function of {axis} of point {point}"),
)
SLIDE = (
    Quantity("s_{slide}[{length}]", "coordinate of prismatic joint {slide}"),
    Quantity("v_{slide}[{velocity}]", "velocity in prismatic joint {slide}"),
    Quantity("a_{slide}[{acceleration}]", "acceleration in prismatic joint {slide}"),
    Quantity("ds_{slide}[{length}/{per}]", "first transfer function of prismatic joint {slide}"),
    Quantity("dds_{slide}[{length}/{per}^2]", "second transfer function of prismatic joint {slide}"),
)


class Units(NamedTuple):
    """Names of the units and the factors that bring SI values into them."""

    length: tuple[str, float]
    velocity: tuple[str, float]
    acceleration: tuple[str, float]
    omega: tuple[str, float]
    eps: tuple[str, float]
    per: str  # the unit of the input coordinate

    @property
    def names(self) -> dict[str, str]:
        """The units by their places in the keys."""
        pairs = self._asdict()
        return {name: unit if name == "per" else unit[0] for name, unit in pairs.items()}

    @property
    def linear(self) -> tuple[float, ...]:
        """Factors of a length, its velocity and acceleration, its transfer functions."""
        length = self.length[1]
        return length, self.velocity[1], self.acceleration[1], length, length


DEGREES = ("deg", float(np.rad2deg(1.0)))


def units_of(result: Kinematics, dimensionless: bool) -> Units:
    """SI units, or those of the crank's length and speed; raises `UsageError` where the input link is a slider."""
    per = "rad" if result.turns else "m"
    if not dimensionless:
        return Units(("m", 1.0), ("m/s", 1.0), ("m/s^2", 1.0), ("rad/s", 1.0), ("rad/s^2", 1.0), per)
    if result.crank_length is None:
        raise UsageError(
            "dimensionless results are in units of the crank length, and the input link is a slider",
            where="kinematics",
            remedy="leave --dimensionless out",
        )
    length, speed = result.crank_length, result.speed
    return Units(
        ("l_1", 1 / length),
        ("l_1*omega_1", 1 / (length * speed)),
        ("l_1*omega_1^2", 1 / (length * speed**2)),
        ("omega_1", 1 / speed),
        ("omega_1^2", 1 / speed**2),
        per,
    )


def columns(result: Kinematics, *, dimensionless: bool = False) -> list[Column]:
    """All columns of a result in their usual order; raises `UsageError` for dimensionless driven sliders."""
    units = units_of(result, dimensionless)
    return [
        phi_column(result.phi, result.turns),
        *_output_columns(result, units),
        *_link_columns(result, units),
        *_point_columns(result, units),
        *_slide_columns(result, units),
    ]


def phi_column(phi: Real, turns: bool) -> Column:
    """The input coordinate counted from position 0, of a crank in degrees."""
    return column(PHI.of(unit="deg"), partial(degrees, phi)) if turns else column(PHI.of(unit="m"), lambda: phi)


def _scaled(make: Callable[[], Real], factor: float) -> Real:
    return make() if factor == 1.0 else make() * factor


class _Stack(NamedTuple):
    """Values and both transfer functions of several quantities, one a row, and the result they belong to."""

    result: Kinematics
    value: Plane | Real
    rate: Plane | Real
    rate2: Plane | Real

    def columns(
        self, k: int, told: Sequence[Quantity], factors: Sequence[float], part: Callable[[Any], Any] = np.real
    ) -> Iterator[Column]:
        """The five columns of row k: value, velocity, acceleration, first and second transfer function."""
        rates = (self.value, self.rate, self.rate2)
        makes = (
            lambda: part(rates[0][k]),
            lambda: part(self.result.in_time(self.rate[k], self.rate2[k])[0]),
            lambda: part(self.result.in_time(self.rate[k], self.rate2[k])[1]),
            lambda: part(rates[1][k]),
            lambda: part(rates[2][k]),
        )
        for each, make, factor in zip(told, makes, factors, strict=True):
            yield column(each, partial(_scaled, make, factor))


def _output_columns(result: Kinematics, units: Units) -> Iterator[Column]:
    rows = _Stack(result, result.s, result.ds, result.dds)
    for k, (name, angular) in enumerate(zip(result.outputs, result.angular, strict=True)):
        if angular:
            value, own, rates = ("rad", 1.0), DEGREES, (units.omega, units.eps)
        else:
            value, own, rates = units.length, units.length, (units.velocity, units.acceleration)
        (velocity, by_velocity), (acceleration, by_acceleration) = rates
        places = {"own": own[0], "value": value[0], "velocity": velocity, "acceleration": acceleration}
        told = [each.of(output=name, per=units.per, **places) for each in OUTPUT]
        yield from rows.columns(k, told, (own[1], by_velocity, by_acceleration, value[1], value[1]))


def _link_columns(result: Kinematics, units: Units) -> Iterator[Column]:
    t = result.trace
    rows, names = _Stack(result, t.angle, t.dangle, t.ddangle), units.names
    factors = (DEGREES[1], units.omega[1], units.eps[1], 1.0, 1.0)
    for k, link in enumerate(t.link_ids):
        yield from rows.columns(k, [each.of(link=link, **names) for each in LINK], factors)


def _point_columns(result: Kinematics, units: Units) -> Iterator[Column]:
    t = result.trace
    rows, names = _Stack(result, t.r, t.dr, t.ddr), units.names
    for k, point in enumerate(t.point_names):
        for axis, part in (("x", np.real), ("y", np.imag)):
            told = [each.of(axis=axis, point=point, **names) for each in POINT]
            yield from rows.columns(k, told, units.linear, part)


def _slide_columns(result: Kinematics, units: Units) -> Iterator[Column]:
    t = result.trace
    rows, names = _Stack(result, t.s, t.ds, t.dds), units.names
    for k, joint in enumerate(t.joint_names):
        yield from rows.columns(k, [each.of(slide=joint, **names) for each in SLIDE], units.linear)
