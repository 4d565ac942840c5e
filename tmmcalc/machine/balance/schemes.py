"""Rotating weights against the shaking force: on the crank, and on shafts that turn against it or twice as fast.

A weight on a shaft geared to the crank as ``order`` to 1 (negative: against it) with the static moment u stands at
u exp(i order phi) from its axis; its inertia force is u (order^2 omega^2 - i order eps_1) exp(i order phi). It meets
the harmonic c_order of the shaking force and no other, so that the least mean square of what remains is reached,
weight by weight, by u = -c_order / (order^2 omega^2 - i order eps_1), whatever the speed; what remains is
sqrt(sum of |c_k|^2) over the other orders. Order 1 is the counterweight on the crank, textbook (3.72)-(3.74): the
mean of the hodograph in the crank frame. Orders 1 and -1 are the pair of counter-rotating weights (Lanchester),
orders 2 and -2 the same for the second harmonic.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.fourier import Magnitude, Series, magnitude
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.balance.circle import enclosing_circle
from tmmcalc.machine.balance.shaking import MARGIN, WHERE, Shaking

NOTHING = 1e-12  # a force below this part of the whole needs no weight


@record
class RotatingWeight:
    """A weight on a shaft that turns ``order`` times as fast as the crank; order 1 is the crank itself."""

    order: int = quantity("order", "speed of the weight's shaft over that of the crank; negative: against it")
    moment: complex  # static moment where O->A points along the fixed x axis [kg*m]; of order 1 in the crank frame
    axis: complex  # place of the shaft in the frame [m]

    @derived("moment[kg*m]", "static moment of the weight")
    def size(self) -> float:
        """Its modulus."""
        return abs(self.moment)

    @derived("axis_x[m]", "x of the weight's shaft")
    def axis_x(self) -> float:
        """In the frame."""
        return self.axis.real

    @derived("axis_y[m]", "y of the weight's shaft")
    def axis_y(self) -> float:
        """In the frame."""
        return self.axis.imag

    def amplitude(self, speed: float, acceleration: float = 0.0) -> complex:
        """Inertia force f [N] of the weight, which is f exp(i order phi)."""
        return self.moment * per_moment(self.order, speed, acceleration)


@record
class Balance:
    """What rotating weights leave of the shaking force and moment, at the positions of a `Shaking` and over the turn.

    The moment is about the point of the `Shaking`. That of the weights' own inertia, which arises if the crank
    accelerates, depends on their sizes and is left out.
    """

    scheme: str
    weights: tuple[RotatingWeight, ...]
    force: Plane  # left, in fixed axes [N], (n,)
    turned: Plane  # left, in the crank frame [N], (n,)
    moment: Real  # left [N*m], (n,)
    series: Series  # of the force left
    moment_series: Series  # of the moment left
    before: Magnitude  # of the force [N]
    after: Magnitude  # of the force left [N]
    moment_before: Magnitude  # [N*m]
    moment_after: Magnitude  # [N*m]
    ratio: float | None  # rms force before to after [-]; None where nothing but rounding is left
    gap: float = 0.0  # minimax: the largest force left is at most this part above the least possible [-]
    error: float = 0.0  # estimated, of the force left and of the force of the weights, relative to the scale [-]
    ratio_error: float = 0.0  # estimated, relative, of the ratio


def per_moment(order: int, speed: float, acceleration: float) -> complex:
    """Inertia force of a unit static moment [1/s^2]."""
    return complex(order * order * speed * speed, -order * acceleration)


def with_weights(
    shaking: Shaking,
    weights: Sequence[RotatingWeight],
    scheme: str = "given weights",
    gap: float = 0.0,
    error: float = 0.0,
) -> Balance:
    """What these weights, of any size, leave of the shaking force and moment; ``error`` of them against the scale."""
    forces: dict[int, complex] = {}
    moments: dict[int, complex] = {}
    for weight in weights:
        f = weight.amplitude(shaking.speed, shaking.acceleration)
        forces[weight.order] = forces.get(weight.order, 0j) + f
        half = np.conj(weight.axis - shaking.about) * f / 2j
        moments[weight.order] = moments.get(weight.order, 0j) + half
        moments[-weight.order] = moments.get(-weight.order, 0j) + np.conj(half)
    series, moment_series = shaking.series.plus(forces), shaking.moment_series.plus(moments)
    added = Series(np.zeros(1, np.complex128)).plus(forces).at(shaking.phi)
    twisted = Series(np.zeros(1, np.complex128)).plus(moments).at(shaking.phi).real
    force, after = shaking.force + added, magnitude(series)
    told, off = after.rms > NOTHING * shaking.scale, (shaking.mean_error + error) * shaking.scale
    return Balance(
        scheme=scheme,
        weights=tuple(weights),
        force=force,
        turned=force * np.exp(-1j * shaking.phi),
        moment=shaking.moment + twisted,
        series=series,
        moment_series=moment_series,
        before=shaking.size,
        after=after,
        moment_before=shaking.moment_size,
        moment_after=magnitude(moment_series),
        ratio=shaking.size.rms / after.rms if told else None,
        gap=gap,
        error=shaking.error + error,
        ratio_error=off * (1 / after.rms + 1 / shaking.size.rms) if told else 0.0,
    )


def minimax_counterweight(shaking: Shaking) -> Balance:
    """One counterweight on the crank, for the least possible maximum of the force left.

    In the crank frame the shaking force runs through a closed hodograph and the counterweight's force stands still, so
    that what remains is the distance of the hodograph from a fixed point. It is least at the worst position where that
    point is the centre of the smallest circle around the hodograph.

    ``gap`` of the result bounds how far its maximum can be above the least. Raises `AccuracyError` if that bound
    does not close.
    """
    scale = shaking.scale or 1.0
    # the contacts are peaks of the force: no margin for angles that were not looked at
    circle = enclosing_circle(shaking.series.turned(-1), shaking.error / MARGIN * scale)
    factor = per_moment(1, shaking.speed, shaking.acceleration)
    weight = RotatingWeight(1, -circle.center / factor, shaking.pivot)
    gap = circle.gap / circle.radius if circle.radius else 0.0
    return with_weights(shaking, [weight], "minimax", gap, circle.error / scale)


def lanchester(shaking: Shaking, highest: int = 1) -> Balance:
    """Pairs of counter-rotating weights: orders 1 and -1, with ``highest`` = 2 also 2 and -2; all at the pivot."""
    orders = tuple(sign * k for k in range(1, highest + 1) for sign in (1, -1))
    names = {1: "counter-rotating pair", 2: "counter-rotating pairs of first and second order"}
    return rotating_weights(shaking, orders, scheme=names.get(highest, f"pairs up to order {highest}"))


def rotating_weights(shaking: Shaking, orders: Iterable[int], scheme: str = "rotating weights") -> Balance:
    """One weight for every order at the crank's pivot, each taking its harmonic of the shaking force away altogether.

    Raises `UsageError` for the order 0, or an order named twice.
    """
    orders = tuple(orders)
    if 0 in orders or len(set(orders)) != len(orders):
        raise UsageError(
            f"the orders {orders} of the rotating weights are not different whole numbers other than 0",
            where=WHERE,
            remedy="order 1 is the crank, -1 a shaft that turns against it at its speed",
        )
    weights = []
    for order in orders:
        per_unit = per_moment(order, shaking.speed, shaking.acceleration)
        weights.append(RotatingWeight(order, -shaking.series.coefficient(order) / per_unit, shaking.pivot))
    return with_weights(shaking, weights, scheme)


# one counterweight on the crank, for the least mean square of the force left: textbook (3.74)
least_squares_counterweight = partial(rotating_weights, orders=(1,), scheme="least squares")
