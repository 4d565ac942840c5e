"""Efficiency of many trains at once from those of their meshes, bearing losses neglected (textbook table 4.6).

A mesh loses a part of the power that rolls through it, that is of the power seen from the carrier. Trains with two
central wheels have closed formulas; of the three of AII the torques are found with the directions of power that agree
with them. A value of zero or below means that the train locks itself.
"""

from __future__ import annotations

from itertools import product
from math import prod
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.speeds import DOUBLE, speeds
from tmmcalc.gears.model import ToothSets, Values
from tmmcalc.gears.network.types import efficiency as planetary_efficiency
from tmmcalc.gears.scheme import CARRIER


@record
class MeshEfficiency:
    """Efficiencies of single meshes: general engineering values, an internal mesh slides less."""

    external: float = 0.975
    internal: float = 0.985


def efficiency(
    sets: ToothSets, meshes: MeshEfficiency | None = None, driver: str = "1", kind: np.dtype[Any] = DOUBLE
) -> Values:
    """Efficiency (n,) of every train, driven by wheel 1 or by its output shaft, in numbers of a kind.

    Zero or negative: the train locks itself in this direction; zero where no power can flow at all. Raises
    `UsageError` for another driver and `NoSolutionError` where wheel 1 or the output stands still.

    >>> train = ToothSets("AIbar", np.array([[18, 48, 114]]), np.ones((1, 1), int), np.full((1, 2), 0.349), planets=3)
    >>> efficiency(train, MeshEfficiency(0.97, 0.97)).round(6).tolist()
    [0.948959]
    """
    meshes = MeshEfficiency() if meshes is None else meshes
    if driver not in ("1", sets.scheme.output):
        raise UsageError(
            f"shaft {driver!r} does not drive", where=f"train {sets.layout}", remedy=f"drivers: 1, {sets.scheme.output}"
        )
    each = [meshes.internal if mesh.internal else meshes.external for mesh in sets.scheme.meshes]
    if not sets.scheme.planetary:
        return np.full(len(sets), prod(each))
    if sets.scheme.three_centrals:
        return _three_central_wheels(sets, each, driver, kind)
    return planetary_efficiency(speeds(sets).of("1", kind), prod(each), "1" if driver == "1" else "H")


def _three_central_wheels(sets: ToothSets, each: list[float], driver: str, kind: np.dtype[Any]) -> Values:
    """Efficiency of AII by the powers T v that the wheels 1, 3, 4 bring to the planets, seen from the carrier.

    Losses turn their balance into sum T v eta^(+-1) = 0, + where power enters; the carrier bears no torque, so that
    T1 + T3 + T4 = 0. The directions of power are those nearest to the lossless ones that the torques confirm.
    """
    turning = speeds(sets, driver)
    wheels = (driver, "3", "4" if driver == "1" else "1")
    speed = {shaft: turning.of(shaft, kind) for shaft in (*wheels, CARRIER)}
    v = np.array([speed[wheel] - speed[CARRIER] for wheel in wheels])
    eta = np.array(each, kind)[["134".index(wheel) for wheel in wheels], None]
    _, directions = _balance(v, v)
    found, known = np.zeros(len(sets), kind), np.zeros(len(sets), bool)
    for flips in sorted(product((1, -1), repeat=3), key=sum, reverse=True):
        assumed = directions * np.array(flips)[:, None]
        torque, actual = _balance(v, v * eta**assumed)
        fits = ~known & np.all(assumed == actual, axis=0)
        found = np.where(fits, -torque * speed[wheels[2]], found)
        known |= fits
    return found


def _balance(v: Values, weighed: Values) -> tuple[Values, Values]:
    """Torque (n,) on the output for unit torque of the driver, and the signs (3, n) of the powers.

    ``v`` (3, n): speeds of driver, fixed wheel and output against the carrier; ``weighed``: the same with losses.
    """
    under = weighed[2] - weighed[1]
    torque = (weighed[1] - weighed[0]) / np.where(under == 0, 1.0, under)
    powers = np.array([v[0], (-1 - torque) * v[1], torque * v[2]])
    return torque, np.where(under == 0, 0, np.where(powers < 0, -1, 1))
