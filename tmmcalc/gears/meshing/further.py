"""Columns by choice of the table of the pairs: where on both flanks points of the line of action lie, how they slide.

    r_i^2 = r_bi^2 + rho_i^2        tan alpha_i = rho_i/r_bi        v_s = (omega_1 + omega_2) s

with - in the last for an internal pair. A rack has no radius: columns of wheel 2 are there if no pair has one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.quantity import Quantity
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.model import Values

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables

CURVATURE = Quantity("rho2[m]", "N2K, radius of curvature of wheel 2")
RADIUS = Quantity("r_{wheel}[m]", "radius of the point of the flank of wheel {wheel}")
ANGLE = Quantity("alpha_{wheel}[rad]", "transverse pressure angle of the flank of wheel {wheel} there")
ROLL = Quantity("phi[rad]", "turn of wheel 1 from the contact in the pitch point, with its sense")
SLIDING = Quantity("v_s[m]", "sliding velocity over the speed of wheel 1", source="(omega_1 + omega_2) s/omega_1")


def further_columns(spec: GearTables, results: Mapping[str, Any]) -> Sequence[Column]:
    """Columns of the rows of all pairs, made when they are asked for."""
    found: Pairs = results["pair"]
    wheels = (1, 2) if all(pair.task.kind != "rack" for pair in found.pairs) else (1,)

    def made(told: Quantity, of: Callable[[MeshPair], Values]) -> Column:
        return column(told, lambda: np.concatenate([of(pair) for pair in found.pairs]))

    columns = [made(CURVATURE, partial(_curvature, wheel=2))] if 2 in wheels else []
    for wheel in wheels:
        columns.append(made(RADIUS.of(wheel=wheel), partial(_radius, wheel=wheel)))
        columns.append(made(ANGLE.of(wheel=wheel), partial(_angle, wheel=wheel)))
    return [*columns, made(ROLL, _turn), made(SLIDING, _sliding)]


def _curvature(pair: MeshPair, wheel: int) -> Values:
    """rho of the flank of a wheel (n,) [m]."""
    rho1 = pair.sliding.rho1
    if wheel == 1:
        return rho1
    return pair.line.between + (rho1 if pair.task.kind == "internal" else -rho1)


def _radius(pair: MeshPair, wheel: int) -> Values:
    found: Values = np.hypot(pair.sizes[wheel - 1].base, _curvature(pair, wheel))
    return found


def _angle(pair: MeshPair, wheel: int) -> Values:
    found: Values = np.arctan2(_curvature(pair, wheel), pair.sizes[wheel - 1].base)
    return found


def _turn(pair: MeshPair) -> Values:
    """The point of contact runs along the line of action as the base circle turns."""
    return pair.sliding.along / pair.sizes[0].base


def _sliding(pair: MeshPair) -> Values:
    """Of two external wheels the speeds add up, of a ring they subtract, and a rack turns not at all."""
    z1, z2 = pair.task.teeth
    ratio = 0.0 if pair.task.kind == "rack" else z1 / z2
    return pair.sliding.along * (1 - ratio if pair.task.kind == "internal" else 1 + ratio)
