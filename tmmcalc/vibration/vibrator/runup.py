"""Start with a prescribed angle psi(t): exact propagation of the linear equations under the given force.

In the coordinates s = (w eta, eta') of the modes s' = A s + f(t) with |A| about the highest frequency. Over a step
h, |A| h <= 1/2, e^(A t) is a short series, and the force between the Gauss points of the step is a polynomial as good
as exact:

    s(t + c h) = e^(A c h) s(t) + sum_j W(c, j) f_j,   W(c, j) = integral of e^(A (c h - t)) l_j(t) over 0 .. c h

The work of the force and of the dampers is summed at the same points: energy less work is the check.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.gauss import legendre, rule
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.energies import COUNT, Excitation
from tmmcalc.vibration.vibrator.modes import Modes
from tmmcalc.vibration.vibrator.task import RunUp

POINTS = 10  # of a step
FINE = 16  # of the integrals W
SPAN = 0.5  # |A| h and psi' h of a step
TERMS = 24  # of the series: SPAN^24/24! is far below rounding
MOST = 300_000  # steps


@record
class DeviceMotion:
    """Motion in time at n rows."""

    t: Values = quantity("t[s]", "time")  # (n,) as the others but q
    psi: Values = quantity("psi[rad]", "angle of the unbalance")
    omega: Values = quantity("omega[rad/s]", "speed of the rotor")
    q: Values  # (7, n) coordinates [m] and [rad]
    energy: Values = quantity("E[J]", "kinetic and potential energy")
    work: Values = quantity("W[J]", "work put in so far")
    lost: Values = quantity("D[J]", "work taken by the dampers so far")
    error: float = quantity("energy_error", "largest of E + D - W over the largest energy")

    @derived("end_omega[rad/s]", "speed of the rotor at the end")
    def end_omega(self) -> float:
        """Of the last row."""
        return float(self.omega[-1])


class _Piece(NamedTuple):
    """Part of the start with one law of the angle: rows at equal times, each of some steps."""

    begin: float
    end: float
    rows: int
    epsilon: float
    omega: float  # at the beginning
    psi: float


class _Step(NamedTuple):
    """What carries the state over a step of h."""

    whole: Values  # e^(A h) (14, 14)
    kick: Values  # W(1, j) (14, POINTS, 7), of forces on the modes
    inner: Values  # e^(A c h) (POINTS, 14, 14)
    inside: Values  # W(c, j) (POINTS, 14, POINTS, 7)


def run_up(modes: Modes, excitation: Excitation, speed: float, asked: RunUp) -> DeviceMotion:
    """The motion from rest while the rotor speeds up evenly to ``speed`` [rad/s] and then keeps it.

    Raises `UsageError` where the time is too long to follow.
    """
    state, totals = np.zeros(2 * COUNT), np.zeros(2)
    states: list[Values] = [state[None]]
    sums: list[Values] = [totals[None]]
    laws = []
    for piece in _pieces(speed, asked):
        laws.append(piece)
        found, added = _propagated(modes, excitation, piece, asked.tangential, state)
        states.append(found)
        sums.append(totals + added)
        state, totals = found[-1], sums[-1][-1]
    t, psi, omega = _angles(laws)
    whole, both = np.concatenate(states), np.concatenate(sums)
    energy = np.sum(whole**2, axis=1) / 2
    open_ = energy + both[:, 1] - both[:, 0]
    largest = float(np.max(energy))
    eta = whole[:, :COUNT] / modes.frequency
    error = float(np.max(np.abs(open_))) / largest if largest else 0.0
    return DeviceMotion(t, psi, omega, modes.shapes @ eta.T, energy, both[:, 0], both[:, 1], error)


def steps_of(modes: Modes, fastest: float, duration: float, where: str) -> float:
    """How many steps the frequencies of device and rotor ask for; raises `UsageError` where they are too many."""
    rate = max(float(np.linalg.norm(_system(modes), 2)), fastest)
    steps = duration * rate / SPAN
    if steps > MOST:
        raise UsageError(
            f"{duration:.6g} s with frequencies up to {rate:.6g} rad/s take {steps:.6g} steps",
            where=where,
            value=steps,
            limit=float(MOST),
            remedy="write a shorter duration",
        )
    return steps


def _pieces(speed: float, asked: RunUp) -> list[_Piece]:
    """Speeding up, then the constant speed."""
    until = min(speed / asked.acceleration, asked.duration)
    first = max(2, round(asked.rows * until / asked.duration))
    listed = [_Piece(0.0, until, first, asked.acceleration, 0.0, 0.0)]
    if until < asked.duration:
        rest = max(2, asked.rows - first)
        listed.append(_Piece(until, asked.duration, rest, 0.0, speed, asked.acceleration * until**2 / 2))
    return listed


def _angles(pieces: list[_Piece]) -> tuple[Values, Values, Values]:
    """Time, angle and speed of the rotor at the rows."""
    t, psi, omega = [np.zeros(1)], [np.zeros(1)], [np.zeros(1)]
    for piece in pieces:
        s = (piece.end - piece.begin) * np.arange(1, piece.rows + 1) / piece.rows
        t.append(piece.begin + s)
        psi.append(piece.psi + piece.omega * s + piece.epsilon * s**2 / 2)
        omega.append(piece.omega + piece.epsilon * s)
    return np.concatenate(t), np.concatenate(psi), np.concatenate(omega)


def _propagated(
    modes: Modes, excitation: Excitation, piece: _Piece, tangential: bool, first: Values
) -> tuple[Values, Values]:
    """States (rows, 14) and work and loss (rows, 2) since the beginning of the piece, at its rows."""
    duration = piece.end - piece.begin
    fastest = piece.omega + piece.epsilon * duration
    each = max(1, int(np.ceil(steps_of(modes, fastest, duration, "vibrator.start") / piece.rows)))
    steps, h = piece.rows * each, duration / piece.rows / each
    step = _step(modes, h)
    tau = h * (np.arange(steps)[:, None] + rule(POINTS).points)
    psi = piece.psi + piece.omega * tau + piece.epsilon * tau**2 / 2
    epsilon = np.full_like(tau, piece.epsilon)
    force = excitation.force(psi, piece.omega + piece.epsilon * tau, epsilon, tangential=tangential) @ modes.shapes
    kicks = np.einsum("ajm,njm->na", step.kick, force)
    states = _chained(step.whole, kicks, first)
    velocity = np.einsum("iab,nb->nia", step.inner[:, COUNT:], states[:-1])
    velocity += np.einsum("iajm,njm->nia", step.inside[:, COUNT:], force)
    weights = h * rule(POINTS).weights
    work = np.einsum("nim,nim,i->n", force, velocity, weights)
    lost = np.einsum("nia,ab,nib,i->n", velocity, modes.damping, velocity, weights)
    sums = np.cumsum(np.stack((work, lost), axis=1), axis=0)
    return states[each::each], sums[each - 1 :: each]


def _chained(whole: Values, kicks: Values, first: Values) -> Values:
    """States (steps + 1, 14) at the ends of the steps."""
    found = np.empty((len(kicks) + 1, len(first)))
    found[0] = state = first
    for k, kick in enumerate(kicks):
        state = whole @ state + kick
        found[k + 1] = state
    return found


def _system(modes: Modes) -> Values:
    """A (14, 14) of s = (w eta, eta')."""
    w = np.diag(modes.frequency)
    return np.block([[np.zeros((COUNT, COUNT)), w], [-w, -modes.damping]])


def _step(modes: Modes, h: float) -> _Step:
    """The matrices of a step."""
    r, fine = rule(POINTS), rule(FINE)
    a = _system(modes)
    ends = np.append(r.points, 1.0)
    left = ends[:, None] * (1 - fine.points)  # (c h - t)/h at the fine points of 0 .. c
    at = (ends[:, None] * fine.points).ravel()
    basis = (legendre(2 * at - 1, POINTS - 1).T @ r.coefficients).reshape(len(ends), FINE, POINTS)
    carried = exponential(a * h, left.ravel()).reshape(len(ends), FINE, *a.shape)[..., COUNT:]
    weights = h * ends[:, None] * fine.weights
    inside = np.einsum("if,ifab,ifj->iajb", weights, carried, basis)
    inner = exponential(a * h, ends)
    return _Step(inner[-1], inside[-1], inner[:-1], inside[:-1])


def exponential(a: Values, factors: Values) -> Values:
    """e^(a c) (m, n, n) for factors c (m,) in 0 .. 1 and a matrix of norm below 1, by its series."""
    total = np.broadcast_to(np.eye(len(a)), (len(factors), *a.shape)).copy()
    power = np.eye(len(a))
    for k in range(1, TERMS):
        power = power @ a / k
        total += factors[:, None, None] ** k * power
    return total
