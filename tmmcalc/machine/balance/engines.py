"""Shaking forces and couples of engines with several cranks, by order of the shaft speed, and what weights leave.

Force F(phi) and couple C(phi) in the plane across the shaft are complex functions of the shaft angle. Their
harmonics of order k come in two parts, F_k exp(i k phi) that turns with the shaft and F_-k exp(-i k phi) that turns
against it; together they run through an ellipse with the half axes |F_k| + |F_-k| and the difference. Order 1 is called
primary, order 2 secondary. Weights on a shaft geared 1, -1, 2 or -2 to 1, in two planes, take any of the parts away.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TypedDict

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.fourier import Complex, Magnitude, Series, magnitude, resolved
from tmmcalc.core.numerics.roots import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.balance.cylinders import Cylinder, cylinder_force, middle
from tmmcalc.machine.balance.weights import in_planes

WHERE = "engine"
ORDERS = (1, 2, 4, 6)
FREE = 1e-9  # part of the cylinders' own forces of an order below which it counts as balanced
ROUNDED = 4 * sys.float_info.epsilon  # rounding of a force, relative
ROUNDING = 1e-13  # part of their forces of all orders that is rounding


@record
class Order:
    """One order of the shaft speed: complex amplitudes of the parts that turn with and against the shaft."""

    order: int = quantity("order", "order: turns of the force over those of the shaft")
    force: tuple[complex, complex]  # F_k, F_-k [N]
    couple: tuple[complex, complex]  # C_k, C_-k [N*m]
    force_alone: float = quantity("F_alone[N]", "largest forces of the order of the cylinders singly, added up")
    couple_alone: float = quantity("C_alone[N*m]", "largest couples of the order of the cylinders singly, added up")
    forces_balanced: bool  # the cylinders' forces of this order cancel, or there are none
    couples_balanced: bool

    @derived("F[N]", "largest force of the order")
    def largest_force(self) -> float:
        """Largest force of this order over the turn [N]."""
        return abs(self.force[0]) + abs(self.force[1])

    @derived("C[N*m]", "largest couple of the order")
    def largest_couple(self) -> float:
        """Largest couple of this order over the turn [N*m]."""
        return abs(self.couple[0]) + abs(self.couple[1])


@record
class EngineBalance:
    """Shaking force and couple of an engine at constant speed, as they are or with weights on its shafts."""

    speed: float = quantity("speed[rad/s]", "speed of the crankshaft")
    reference: float = quantity("reference_z[m]", "plane of the couples", symbol="z_0")
    orders: tuple[Order, ...]
    force: Series  # [N], in the shaft angle
    couple: Series  # [N*m]
    force_size: Magnitude  # rms and largest over a turn [N]
    couple_size: Magnitude  # [N*m]
    alone: tuple[Series, Series]  # sums over the cylinders of the moduli |F_k| [N] and |C_k| [N*m], by order
    scales: tuple[float, float]  # moduli of all forces [N] and couples [N*m] added up: rounding is proportional to them
    weights: tuple[ShaftWeights, ...]
    error: float  # what the series and rounding leave out, relative to the cylinders' own forces [-]


@record
class ShaftWeights:
    """Weights in two planes of a shaft that turns ``order`` times as fast as the crankshaft."""

    order: int = quantity("order", "1: on the crankshaft itself; negative: turning against it")
    planes: tuple[float, float]  # z [m]
    moments: tuple[complex, complex]  # static moments where the crankshaft's angle is 0 [kg*m]


def engine_balance(
    cylinders: Sequence[Cylinder], speed: float, *, orders: Iterable[int] = ORDERS, reference: float | None = None
) -> EngineBalance:
    """Forces and couples of an engine at the shaft speed [rad/s], all harmonics, and those of ``orders`` apart.

    ``reference`` [m] is the plane of the couples, by default the middle between the outermost cylinders; where a force
    is left its couple depends on it. Raises `UsageError` without cylinders, `AccuracyError` for a rod hardly longer
    than its crank.
    """
    z0 = middle(cylinders) if reference is None else reference
    arms = np.array([c.position_along_shaft - z0 for c in cylinders])

    def forces(phi: Values) -> Complex:
        return np.array([cylinder_force(c, phi, speed) for c in cylinders])

    scale = np.array([_own_scale(c) * speed * speed for c in cylinders])
    rows, tail = resolved(forces, scale, where=WHERE)
    each = np.array([row.coefficients for row in rows])
    sizes = np.abs(each)
    alone = Series(sizes.sum(axis=0) + 0j), Series(np.abs(arms) @ sizes + 0j)
    scales = float(scale.sum()), float(np.abs(arms) @ scale)
    return EngineBalance(
        speed=speed,
        reference=z0,
        alone=alone,
        scales=scales,
        weights=(),
        error=tail + ROUNDED * max(map(_magnified, cylinders)),
        **_parts(tuple(orders), Series(each.sum(axis=0)), Series(arms @ each), alone, scales),
    )


def _magnified(c: Cylinder) -> float:
    """How many times rounding is magnified where the rod stands most aslant."""
    return 1 / (1 - ((c.crank_radius + abs(c.offset)) / c.rod_length) ** 2)


def _own_scale(c: Cylinder) -> float:
    """A force per squared speed [kg*m] that the cylinder comes near to, for the measure of rounding."""
    ratio = c.crank_radius / (c.rod_length - abs(c.offset))
    return (c.reciprocating_mass * (1 + ratio) + c.rotating_mass) * c.crank_radius


class _Parts(TypedDict):
    """The fields of an `EngineBalance` that weights change."""

    orders: tuple[Order, ...]
    force: Series
    couple: Series
    force_size: Magnitude
    couple_size: Magnitude


def _parts(
    orders: tuple[int, ...], force: Series, couple: Series, alone: tuple[Series, Series], scales: tuple[float, float]
) -> _Parts:
    split = []
    for k in orders:
        if k < 1:
            remedy = "orders are 1, 2, ...: primary, secondary, ..."
            raise UsageError(f"there is no order {k}", where=WHERE, remedy=remedy)
        forces, own_force, no_force = _order(k, force, alone[0], scales[0])
        couples, own_couple, no_couple = _order(k, couple, alone[1], scales[1])
        split.append(Order(k, forces, couples, own_force, own_couple, no_force, no_couple))
    sizes = magnitude(force), magnitude(couple)
    return _Parts(orders=tuple(split), force=force, couple=couple, force_size=sizes[0], couple_size=sizes[1])


def _order(k: int, total: Series, alone: Series, scale: float) -> tuple[tuple[complex, complex], float, bool]:
    """The two amplitudes of order k, the sum of the cylinders' own, and whether the first is nothing beside it."""
    pair = total.coefficient(k), total.coefficient(-k)
    own = (alone.coefficient(k) + alone.coefficient(-k)).real
    return pair, own, abs(pair[0]) + abs(pair[1]) <= max(FREE * own, ROUNDING * scale)


def shaft_weights(balance: EngineBalance, order: int, planes: tuple[float, float]) -> ShaftWeights:
    """Weights in two ``planes`` [m] of the shaft of this order that cancel its part of force and couple.

    Order 1: counterweights on the crankshaft; -1 and 2, -2: balance shafts. Raises `UsageError` for the order 0 or
    planes that coincide.
    """
    if order == 0 or balance.speed == 0:
        raise UsageError("a shaft that stands still balances nothing", where=WHERE, remedy="order and speed are not 0")
    rate2 = (order * balance.speed) ** 2
    force, couple = balance.force.coefficient(order), balance.couple.coefficient(order)
    moments = in_planes(-force / rate2, (-couple - balance.reference * force) / rate2, planes)
    return ShaftWeights(order, planes, moments)


def corrected(balance: EngineBalance, weights: Sequence[ShaftWeights]) -> EngineBalance:
    """What is left with these weights, of any size, on the shafts."""
    forces: dict[int, complex] = {}
    couples: dict[int, complex] = {}
    added = list(balance.scales)
    for shaft in weights:
        for z, moment in zip(shaft.planes, shaft.moments, strict=True):
            force, arm = (shaft.order * balance.speed) ** 2 * moment, z - balance.reference
            forces[shaft.order] = forces.get(shaft.order, 0j) + force
            couples[shaft.order] = couples.get(shaft.order, 0j) + arm * force
            added[0] += abs(force)
            added[1] += abs(arm * force)
    orders = tuple(order.order for order in balance.orders)
    scales = added[0], added[1]
    parts = _parts(orders, balance.force.plus(forces), balance.couple.plus(couples), balance.alone, scales)
    return replace(balance, weights=(*balance.weights, *weights), scales=scales, **parts)
