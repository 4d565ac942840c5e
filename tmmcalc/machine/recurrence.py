"""The textbook's recurrence for steady motion with the parabolic characteristic M_d = A - B omega^2 (3.57, 3.58).

On n + 1 nodes of equal steps dphi, with the reduced moment M_c[i] and the total reduced inertia J[i],

    w_i^2 = ((J_(i-1) - B dphi) w_(i-1)^2 + (M_c(i-1) + M_c(i) + 2 A) dphi) / (J_i + B dphi)            (3.57)

which is the trapezoid rule for the work of motor and load: second order in dphi, and alternating where B dphi > J. The
map of a cycle is affine in w_0^2, so the periodic solution needs no iteration; the textbook's turn-by-turn history is
here for the report. The last node repeats the first.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.nodes import nodal_tables
from tmmcalc.machine.textbook import NodalRegime, Turn

WHERE = "recurrence (3.57)"
BOOK = 1e-4  # largest difference of the speeds at both ends of a cycle, textbook program 2.1 [rad/s]
TURNS = 1000


@record
class Nodes:
    """What the recurrence knows of the machine: nodal tables of one cycle and the parabola of the motor."""

    moment: Values  # M_c, reduced moment of the loads [N*m], negative where it resists (n + 1,)
    inertia: Values  # J, total reduced inertia [kg*m^2], (n + 1,)
    a: float  # A of the motor's parabola, on the input shaft [N*m]
    b: float  # B [N*m*s^2/rad^2]
    step: float  # dphi [rad]

    def __post_init__(self) -> None:
        """Refuse tables that are no cycle."""
        if len(self.moment) != len(self.inertia) or len(self.moment) < 2:
            sizes = f"{len(self.moment)} moments, {len(self.inertia)} inertias"
            raise UsageError(f"{sizes}: both tables have n + 1 nodes", where=WHERE)
        if not (np.min(self.inertia) > 0 and self.step > 0 and self.b >= 0):
            raise UsageError(
                f"least inertia {np.min(self.inertia):g} kg*m^2, step {self.step:g} rad, B = {self.b:g}",
                where=WHERE,
                remedy="inertia and step are positive, B not negative",
            )


def on_nodes(cycle: Cycle, constant_inertia: float, a: float, b: float, n: int) -> Nodes:
    """What the recurrence knows of a cycle with ``n`` equal steps and ``constant_inertia`` [kg*m^2] added.

    Resistances that depend on speed are taken at the mean speed of the cycle.
    """
    if n < 2:
        raise UsageError(f"{n} steps", where=WHERE, value=n, limit=2, remedy="at least 2")
    moment, inertia = nodal_tables(cycle, n, cycle.speed)
    return Nodes(moment, inertia + constant_inertia, a, b, cycle.period / n)


def march(nodes: Nodes, start: float) -> NodalRegime:
    """Speeds (n + 1,) over one cycle from ``start`` [rad/s] at node 0 (3.57).

    Raises `AccuracyError` if the square of a speed comes out negative.

    >>> even = Nodes(np.full(5, -10.0), np.full(5, 2.0), 50.0, 0.4, math.pi / 2)
    >>> march(even, 10.0).omega.round(12).tolist()
    [10.0, 10.0, 10.0, 10.0, 10.0]
    """
    squares = _squares(nodes, start * start)
    _check_squares(nodes, squares)
    omega = np.sqrt(squares)
    low, high = int(np.argmin(omega)), int(np.argmax(omega))
    delta = 2 * float((omega[high] - omega[low]) / (omega[high] + omega[low]))
    return NodalRegime(omega, low, high, delta, multiplier(nodes), warning(nodes))


def periodic(nodes: Nodes) -> NodalRegime:
    """The periodic solution, from the affine map of w_0^2 over the cycle.

    Raises `AccuracyError` as `march` does, `NoSolutionError` if B = 0.
    """
    if nodes.b == 0:
        raise NoSolutionError(
            "B = 0: the motor does not regulate the speed, so any would repeat, or none",
            where=WHERE,
            value=nodes.b,
            limit=0.0,
            remedy="forces of position alone with a constant balancing moment",
        )
    square = float(_squares(nodes, 0.0)[-1]) / (1 - multiplier(nodes))
    if square <= 0:
        raise AccuracyError(
            f"no speed repeats after a cycle: it would need w_0^2 = {square:.4g}",
            where=WHERE,
            value=square,
            limit=0.0,
            remedy="more nodes, a stronger motor, or less load",
        )
    return march(nodes, math.sqrt(square))


def turns(nodes: Nodes, start: float, tolerance: float = BOOK) -> tuple[Turn, ...]:
    """The textbook's iteration: cycle after cycle from ``start`` [rad/s] until |w_n - w_0| < ``tolerance`` (3.58).

    Raises `AccuracyError` as `march` does, or if the speeds do not settle within 1000 cycles.
    """
    rest = _squares(nodes, 0.0)
    gain = np.append(1.0, np.cumprod(factors(nodes)))
    history: list[Turn] = []
    for _ in range(TURNS):
        squares = gain * start**2 + rest
        _check_squares(nodes, squares)
        history.append(Turn(start, math.sqrt(squares[-1])))
        start = history[-1].last
        if abs(start - history[-1].first) < tolerance:
            return tuple(history)
    raise AccuracyError(
        f"both ends still differ by {abs(history[-1].last - history[-1].first):.3g} rad/s after {TURNS} cycles",
        where=WHERE,
        value=abs(history[-1].last - history[-1].first),
        limit=tolerance,
        remedy="the direct periodic solution",
    )


def warning(nodes: Nodes) -> float:
    """Largest B dphi / J: below 1 the recurrence is sound, above it alternates."""
    return float(nodes.b * nodes.step / np.min(nodes.inertia))


def multiplier(nodes: Nodes) -> float:
    """Factor by which a deviation of w_0^2 changes over one cycle."""
    return float(np.prod(factors(nodes)))


def factors(nodes: Nodes) -> Values:
    """By how much a deviation of w^2 changes over each step (n,)."""
    damping = nodes.b * nodes.step
    return (nodes.inertia[:-1] - damping) / (nodes.inertia[1:] + damping)


def _check_squares(nodes: Nodes, squares: Values) -> None:
    """Raise `AccuracyError` if the square of a speed is not positive."""
    least = int(np.argmin(squares))
    if squares[least] > 0:
        return
    worst = warning(nodes)
    cause = "the step is too wide" if worst > 1 else "the load stops the machine"
    raise AccuracyError(
        f"w^2 is {squares[least]:.4g} at node {least}: {cause} (largest B dphi / J = {worst:.3g})",
        where=WHERE,
        value=float(squares[least]),
        limit=0.0,
        remedy="more nodes, or the exact regime",
    )


def _squares(nodes: Nodes, first: float) -> Values:
    """w^2 (n + 1,) from w_0^2; a recurrence has no vectorised form that keeps its digits."""
    damping = nodes.b * nodes.step
    rises = (nodes.moment[:-1] + nodes.moment[1:] + 2 * nodes.a) * nodes.step / (nodes.inertia[1:] + damping)
    squares = [first]
    for factor, rise in zip(factors(nodes).tolist(), rises.tolist(), strict=True):
        squares.append(factor * squares[-1] + rise)
    return np.array(squares)
