"""The balance stage of a linkage: shaking force and moment, what the schemes leave of them, the weights to be made."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Literal

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.machine.balance.redistribution import Place, Redistribution, redistribute
from tmmcalc.machine.balance.schemes import (
    Balance,
    RotatingWeight,
    lanchester,
    least_squares_counterweight,
    minimax_counterweight,
    with_weights,
)
from tmmcalc.machine.balance.shaking import Shaking, shaking
from tmmcalc.machine.balance.weights import Weight, sized

SchemeName = Literal["least squares", "minimax", "lanchester", "lanchester 2"]
SCHEMES: tuple[SchemeName, ...] = ("least squares", "minimax", "lanchester", "lanchester 2")

_SOLVERS: dict[SchemeName, Callable[[Shaking], Balance]] = {
    "least squares": least_squares_counterweight,
    "minimax": minimax_counterweight,
    "lanchester": partial(lanchester, highest=1),
    "lanchester 2": partial(lanchester, highest=2),
}


@record
class BalanceTask:
    """What the spec asks of the balance."""

    mass: float | None = None  # of a counterweight [kg]
    radius: float | None = None  # of its centre [m]; neither: the length of the crank
    point: complex | None = None  # moments are about it [m]; None: the crank's pivot
    schemes: tuple[SchemeName, ...] = SCHEMES
    places: tuple[Place, ...] = ()  # counterweights on links
    weights: tuple[RotatingWeight, ...] = ()  # the user's own, on axes of their own


@record
class Scheme:
    """A scheme with its weights made to the chosen mass or radius."""

    name: str  # as the spec calls it; "given" of the user's own weights
    balance: Balance
    weights: tuple[Weight, ...]  # one for every weight of the balance; empty where nothing is to be added


@record
class Balancing:
    """Result of the balance stage over n positions of one turn."""

    labels: tuple[str, ...]  # (n,)
    phi: Values  # (n,) input coordinate counted from position 0 [rad]
    shaking: Shaking
    schemes: tuple[Scheme, ...]
    redistribution: Redistribution | None
    radius: float | None  # chosen radius of the weights [m]
    mass: float | None  # or their chosen mass [kg]

    @property
    def errors(self) -> dict[str, float]:
        """Estimated errors of forces, moments and weights against the sums that they cancel in; of ratios relative.

        ``linkage``: of what shakes and what the schemes leave, but for ``minimax``; ``counterweights``: of what those
        on links leave.
        """
        found = {"linkage": self.shaking.error}
        if self.redistribution is not None:
            found["counterweights"] = self.redistribution.after.error
        for scheme in self.schemes:
            if scheme.name == "minimax":
                found["minimax"] = scheme.balance.error
        ratios = [scheme.balance.ratio_error for scheme in self.schemes]
        return {**found, "share_left": max(ratios)} if ratios else found


def solve_balance(mechanism: Mechanism, bodies: Sequence[Body], kinematics: Kinematics, task: BalanceTask) -> Balancing:
    """Shaking force and moment of a linkage, and what balancing leaves of them.

    Raises `NoSolutionError` for a mechanism without masses or without a crank that turns fully.
    """
    from tmmcalc.linkage.chain import chain_of  # a stored result is loaded without it

    chain = chain_of(mechanism, kinematics)
    x, speed, acceleration = kinematics.x, kinematics.speed, kinematics.acceleration
    found = shaking(chain, bodies, x, speed, acceleration, about=task.point)
    mass, radius = task.mass, task.radius
    if mass is None and radius is None:
        radius = kinematics.crank_length
    balances: dict[str, Balance] = {name: _SOLVERS[name](found) for name in task.schemes}
    if task.weights:
        balances["given"] = with_weights(found, task.weights)
    redistribution = None
    if task.places:
        redistribution = redistribute(chain, bodies, task.places, x, speed, acceleration, about=task.point)
    return Balancing(
        kinematics.labels,
        kinematics.phi,
        found,
        tuple(Scheme(name, balance, _weights(balance, mass, radius)) for name, balance in balances.items()),
        redistribution,
        radius,
        mass,
    )


def _weights(balance: Balance, mass: float | None, radius: float | None) -> tuple[Weight, ...]:
    """The weights of a balance by the chosen mass or radius."""
    if not np.any([weight.moment for weight in balance.weights]):
        return ()
    return tuple(sized(weight.moment, mass=mass, radius=radius) for weight in balance.weights)
