"""The columns of the kinematics table: one name and one unit for each quantity, everywhere.

    phi                    input coordinate counted from position 0
    angle_3 omega_3 eps_3  link 3; dangle_3 ddangle_3 its transfer functions
    x_C y_C vx_C vy_C ax_C ay_C   point C; dx_C dy_C ddx_C ddy_C
    s_D0 v_D0 a_D0         prismatic joint D0; ds_D0 dds_D0
    S_D vS_D aS_D          output D, displacement from position 0; dS_D ddS_D

Dimensionless values are in units of the crank length l_1 and its speed omega_1; they do not depend on the
speed. A column is computed when it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.columns import Column, degrees
from tmmcalc.core.errors import UsageError
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.results import Kinematics


class _Units(NamedTuple):
    """Names of the units and the factors that bring SI values into them."""

    length: tuple[str, float]
    velocity: tuple[str, float]
    acceleration: tuple[str, float]
    omega: tuple[str, float]
    eps: tuple[str, float]
    per: str  # the unit of the input coordinate


def _units(result: Kinematics, dimensionless: bool) -> _Units:
    per = "rad" if result.turns else "m"
    if not dimensionless:
        return _Units(("m", 1.0), ("m/s", 1.0), ("m/s^2", 1.0), ("rad/s", 1.0), ("rad/s^2", 1.0), per)
    if result.crank_length is None:
        raise UsageError(
            "dimensionless results are in units of the crank length, and the input link is a slider",
            where="kinematics",
            remedy="leave --dimensionless out",
        )
    length, speed = result.crank_length, result.speed
    return _Units(
        ("l_1", 1 / length),
        ("l_1*omega_1", 1 / (length * speed)),
        ("l_1*omega_1^2", 1 / (length * speed**2)),
        ("omega_1", 1 / speed),
        ("omega_1^2", 1 / speed**2),
        per,
    )


Quantity = tuple[str, tuple[str, float], Callable[[], Real]]
DEGREES = ("deg", float(np.rad2deg(1.0)))


def columns(result: Kinematics, *, dimensionless: bool = False) -> list[Column]:
    """All columns of a result in their usual order; raises `UsageError` for dimensionless driven sliders."""
    units = _units(result, dimensionless)
    everything = (
        ("phi", ("deg", 1.0), lambda: degrees(result.phi))
        if result.turns
        else ("phi", units.length, lambda: result.phi),
        *_output_columns(result, units),
        *_link_columns(result, units),
        *_point_columns(result, units),
        *_slide_columns(result, units),
    )
    return [Column(name, unit, partial(_scaled, make, factor)) for name, (unit, factor), make in everything]


def phi_column(phi: Real, turns: bool) -> Column:
    """The input coordinate counted from position 0, of a crank in degrees."""
    return Column("phi", "deg", partial(degrees, phi)) if turns else Column("phi", "m", lambda: phi)


def _scaled(make: Callable[[], Real], factor: float) -> Real:
    return make() if factor == 1.0 else make() * factor


def _per(unit: tuple[str, float], per: str, order: int) -> tuple[str, float]:
    return f"{unit[0]}/{per}{'^2' if order == 2 else ''}", unit[1]


class _Stack(NamedTuple):
    """Values and both transfer functions of several quantities, one a row, and the result they belong to."""

    result: Kinematics
    value: Plane | Real
    rate: Plane | Real
    rate2: Plane | Real

    def row(self, k: int, order: int, part: Callable[[Any], Any] = np.real) -> Callable[[], Real]:
        """Row k of the value (0), of the first (1) or second (2) transfer function."""
        return lambda: part((self.value, self.rate, self.rate2)[order][k])

    def in_time(self, k: int, order: int, part: Callable[[Any], Any] = np.real) -> Callable[[], Real]:
        """Row k of the velocity (1) or acceleration (2)."""
        return lambda: part(self.result.in_time(self.rate[k], self.rate2[k])[order - 1])


def _output_columns(result: Kinematics, units: _Units) -> Iterator[Quantity]:
    rows = _Stack(result, result.s, result.ds, result.dds)
    for k, (name, angular) in enumerate(zip(result.outputs, result.angular, strict=True)):
        own = ("rad", 1.0) if angular else units.length
        velocity, acceleration = (units.omega, units.eps) if angular else (units.velocity, units.acceleration)
        yield f"S_{name}", DEGREES if angular else own, rows.row(k, 0)
        yield f"vS_{name}", velocity, rows.in_time(k, 1)
        yield f"aS_{name}", acceleration, rows.in_time(k, 2)
        yield f"dS_{name}", _per(own, units.per, 1), rows.row(k, 1)
        yield f"ddS_{name}", _per(own, units.per, 2), rows.row(k, 2)


def _link_columns(result: Kinematics, units: _Units) -> Iterator[Quantity]:
    t = result.trace
    rows = _Stack(result, t.angle, t.dangle, t.ddangle)
    for k, link in enumerate(t.link_ids):
        yield f"angle_{link}", DEGREES, rows.row(k, 0)
        yield f"omega_{link}", units.omega, rows.in_time(k, 1)
        yield f"eps_{link}", units.eps, rows.in_time(k, 2)
        yield f"dangle_{link}", _per(("rad", 1.0), units.per, 1), rows.row(k, 1)
        yield f"ddangle_{link}", _per(("rad", 1.0), units.per, 2), rows.row(k, 2)


def _point_columns(result: Kinematics, units: _Units) -> Iterator[Quantity]:
    t = result.trace
    rows = _Stack(result, t.r, t.dr, t.ddr)
    for k, name in enumerate(t.point_names):
        for axis, part in (("x", np.real), ("y", np.imag)):
            yield f"{axis}_{name}", units.length, rows.row(k, 0, part)
            yield f"v{axis}_{name}", units.velocity, rows.in_time(k, 1, part)
            yield f"a{axis}_{name}", units.acceleration, rows.in_time(k, 2, part)
            yield f"d{axis}_{name}", _per(units.length, units.per, 1), rows.row(k, 1, part)
            yield f"dd{axis}_{name}", _per(units.length, units.per, 2), rows.row(k, 2, part)


def _slide_columns(result: Kinematics, units: _Units) -> Iterator[Quantity]:
    t = result.trace
    rows = _Stack(result, t.s, t.ds, t.dds)
    for k, name in enumerate(t.joint_names):
        yield f"s_{name}", units.length, rows.row(k, 0)
        yield f"v_{name}", units.velocity, rows.in_time(k, 1)
        yield f"a_{name}", units.acceleration, rows.in_time(k, 2)
        yield f"ds_{name}", _per(units.length, units.per, 1), rows.row(k, 1)
        yield f"dds_{name}", _per(units.length, units.per, 2), rows.row(k, 2)
