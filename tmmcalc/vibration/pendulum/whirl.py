"""Whirl of the spinning pendulum: K - w^2 M + w Omega G = 0, roots w > 0 forward, w < 0 backward.

With y = (z, w z) that is the symmetric pencil B y = (1/w) A y of a positive definite A: all roots are real.

    A = | K  0 |    B = | -Omega G  M |
        | 0  M |        |     M     0 |

The critical speeds w = Omega (forward) and w = -Omega (backward) are those of K - Omega^2 (M -+ G). A `Plane`
is the rotor in one of its planes, in the functions of one basis: it tells how fine the basis is, and all else.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import SingularityError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.vibration.pencil import Pencil, definite_pencil
from tmmcalc.vibration.pendulum.basis import Basis
from tmmcalc.vibration.pendulum.energies import Matrices, matrices
from tmmcalc.vibration.pendulum.task import PendulumTask

WHERE = "stiffness of the pendulum"
RESONANT = 1e-12  # of the static stiffness: less holds no whirl
CAPPED = 1e-9  # the same in the curve over the speeds


def whirl(parts: Matrices, spin: Values) -> Pencil:
    """Roots 1/w and vectors (z, w z) at speeds of spin (...,); raises `NoSolutionError` if nothing holds the rod."""
    n = len(parts.mass)
    a = np.zeros((2 * n, 2 * n))
    a[:n, :n], a[n:, n:] = parts.stiffness, parts.mass
    b = np.zeros((*np.shape(spin), 2 * n, 2 * n))
    b[..., :n, n:] = b[..., n:, :n] = parts.mass
    b[..., :n, :n] = -np.asarray(spin)[..., None, None] * parts.spin
    return definite_pencil(b, a, WHERE)


def lowest(pencil: Pencil, count: int) -> tuple[Values, Values]:
    """The lowest forward and backward frequencies (..., count) [rad/s], both positive."""
    return 1 / pencil.mu[..., : -count - 1 : -1], -1 / pencil.mu[..., :count]


class Critical(NamedTuple):
    """Critical speeds (k,) [rad/s] and their shapes (n, k); ``sign`` is that of G beside M, -1 of forward whirl."""

    sign: int
    speeds: Values
    shapes: Values


def critical_speeds(parts: Matrices, count: int) -> tuple[Critical, Critical]:
    """The first critical speeds of forward and of backward whirl; there may be fewer, or none."""
    found = []
    for sign in (-1, 1):
        pencil = definite_pencil(parts.mass + sign * parts.spin, parts.stiffness, WHERE)
        mu, y = pencil.mu[::-1], pencil.y[:, ::-1]
        many = min(int(np.count_nonzero(mu > 1e-12 * abs(mu[0]))), count)
        found.append(Critical(sign, 1 / np.sqrt(mu[:many]), y[:, :many]))
    return found[0], found[1]


def unbalance_whirl(parts: Matrices, moment: float, spin: float) -> Values:
    """The steady shape (n,) that turns with the rotor, of a static moment m e [kg*m] at the lower end.

    Raises `SingularityError` at a critical speed.
    """
    pencil = definite_pencil(parts.mass - parts.spin, parts.stiffness, WHERE)
    left = 1 - spin**2 * pencil.mu
    worst = float(np.min(np.abs(left)))
    if worst < RESONANT:
        raise SingularityError(
            f"the spin of {spin:.9g} rad/s is a critical speed: the whirl of the unbalance has no bound",
            where="pendulum",
            value=worst,
            limit=RESONANT,
            remedy="write another spin, or eccentricity = 0",
        )
    found: Values = pencil.y @ ((parts.tip @ pencil.y) / left) * moment * spin**2
    return found


def unbalance_curve(parts: Matrices, moment: float, spin: Values) -> Values:
    """Displacement (m,) of the lower end in that whirl over speeds (m,), cut off where a critical speed is hit."""
    pencil = definite_pencil(parts.mass - parts.spin, parts.stiffness, WHERE)
    left = 1 - spin[:, None] ** 2 * pencil.mu
    left = np.where(np.abs(left) < CAPPED, CAPPED, left)
    found: Values = (((parts.tip @ pencil.y) ** 2 / left).sum(axis=1)) * moment * spin**2
    return found


@record
class Plane:
    """A plane with its whirl at speeds of spin, that of the task first, and its critical speeds."""

    number: int  # 0 of xz, 1 of yz
    basis: Basis
    parts: Matrices
    count: int  # modes that are asked for and that there are
    spins: Values  # (s,)
    pencil: Pencil  # of whirl at these
    critical: tuple[Critical, ...]  # forward and backward; empty: it does not spin

    @property
    def frequencies(self) -> Values:
        """Of whirl, and critical speeds, in a row."""
        both = lowest(self.pencil, self.count)
        return np.concatenate([part.ravel() for part in (*both, *(each.speeds for each in self.critical))])

    def at(self, spin: int) -> Pencil:
        """The whirl at one of the speeds of spin."""
        return Pencil(*(each[spin] for each in self.pencil))


def plane_of(task: PendulumTask, number: int, basis: Basis) -> Plane:
    """Plane 0 (v) or 1 (w); speeds of spin are that of the task and the ends of the diagram."""
    parts, count = matrices(task, basis, number), min(task.modes, basis.count)
    spins = np.array([task.spin] if task.speeds is None else [task.spin, task.speeds.low, task.speeds.high])
    critical = critical_speeds(parts, count) if may_spin(task) else ()
    return Plane(number, basis, parts, count, spins, whirl(parts, spins), critical)


def may_spin(task: PendulumTask) -> bool:
    """Whether critical speeds and the whirl of an unbalance are of interest."""
    return task.axisymmetric and (task.spin != 0 or task.speeds is not None)
