"""Motion in time of the pendulum: from a deflection, or hanging from a carrier that moves.

    M z'' - i Omega G z' + K(g + a_up) z = -b (a_x + i a_y) + f m e Omega^2 exp(i Omega t)

Between the times at which the carrier's acceleration changes the coefficients are constant: the motion about the shape
of equilibrium and the whirl of the unbalance m e, whose heavy side begins at x, is a sum of the whirl modes, exact at
every time. Energy and the work of acceleration and unbalance are the check.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.vibration.pendulum.basis import Basis
from tmmcalc.vibration.pendulum.energies import Matrices, matrices
from tmmcalc.vibration.pendulum.task import PendulumTask, Swing
from tmmcalc.vibration.pendulum.whirl import unbalance_whirl, whirl

Complex = NDArray[np.complexfloating]
ALLOWED = 0.05  # of the path's size: a larger error is a failure
FINER = 6  # degrees more, by which the error of the path is seen


@record
class SwingCourse:
    """The lower end and the carrier at n times."""

    t: Values = quantity("t[s]", "time")  # (n,) as all arrays here
    v: Values = quantity("v[m]", "displacement of the lower end from under the joint along x")
    w: Values = quantity("w[m]", "displacement of the lower end from under the joint along y")
    slope_v: Values = quantity("slope_v[rad]", "slope of the lower end along x", symbol="v'")
    slope_w: Values = quantity("slope_w[rad]", "slope of the lower end along y", symbol="w'")
    energy: Values = quantity("E[J]", "energy against the carrier")
    carrier_x: Values = quantity("x_O[m]", "x of the joint")
    carrier_y: Values = quantity("y_O[m]", "y of the joint")
    balance: float = quantity("energy_balance", "largest of energy less work in a piece, over the largest energy")
    error: float = quantity("path_error", "error of the lower end's path over its largest distance, by refinement")

    @derived("distance_max[m]", "largest distance of the lower end from under the joint")
    def distance(self) -> float:
        """Over the rows."""
        return float(np.max(np.hypot(self.v, self.w)))

    @derived("distance_max_at[s]", "time of the largest distance")
    def distance_at(self) -> float:
        """Of the first one."""
        return float(self.t[np.argmax(np.hypot(self.v, self.w))])

    @derived("slope_max[rad]", "largest slope of the lower end")
    def slope(self) -> float:
        """Over the rows."""
        return float(np.max(np.hypot(self.slope_v, self.slope_w)))


class _Piece(NamedTuple):
    """A time in which the carrier's acceleration is constant."""

    begin: float
    end: float
    across: complex  # a_x + i a_y [m/s^2]
    up: float


class _Plane(NamedTuple):
    """What is moved together: z = v + i w of an axisymmetric rotor, or v, or w."""

    number: int
    along: complex  # of a motion along x
    across: complex  # of a motion along y


class _Path(NamedTuple):
    """The lower end and the energy at the times of a piece, and the state at its end."""

    tip: Complex
    slope: Complex
    energy: Values
    open: float  # largest of energy less work, over the largest energy
    state: Complex


BOTH, XZ, YZ = _Plane(0, 1.0, 1j), _Plane(0, 1.0, 0.0), _Plane(1, 0.0, 1.0)


def swing(task: PendulumTask, asked: Swing, bases: tuple[Basis, Basis]) -> SwingCourse:
    """The motion in each plane (one complex sum if the rotor is axisymmetric), with the error of the path.

    Raises `NoSolutionError` where the carrier falls so fast that nothing holds the rod, `AccuracyError` where the
    path is uncertain.
    """
    found = _course(task, asked, bases)
    finer = [replace(each, degree=each.degree + FINER) for each in bases]
    other = _course(task, asked, finer)
    path, better = found.v + 1j * found.w, other.v + 1j * other.w
    largest = float(np.max(np.abs(better)))
    error = float(np.max(np.abs(path - better))) / largest if largest else 0.0
    worst = max(error, other.balance)
    if worst > ALLOWED:
        raise AccuracyError(
            f"the path of the lower end is uncertain by {worst:.2g} of its size",
            where="pendulum.swing",
            value=worst,
            limit=ALLOWED,
            remedy="the rod is very soft for its length: begin with a tilt, or shorten the time",
        )
    return replace(other, error=error)


def _course(task: PendulumTask, asked: Swing, bases: Sequence[Basis]) -> SwingCourse:
    t = np.linspace(0.0, asked.duration, asked.rows + 1)
    if task.axisymmetric:
        tip, slope, energy, open_ = _moved(task, asked, bases[0], BOTH, t)
    else:
        first, second = _moved(task, asked, bases[0], XZ, t), _moved(task, asked, bases[1], YZ, t)
        tip = first[0].real + 1j * second[0].real
        slope = first[1].real + 1j * second[1].real
        energy, open_ = first[2] + second[2], max(first[3], second[3])
    place = _carrier(asked, t)
    return SwingCourse(t, tip.real, tip.imag, slope.real, slope.imag, energy, place.real, place.imag, open_, 0.0)


def _pieces(asked: Swing) -> Iterator[_Piece]:
    """Times of constant acceleration from 0 to the end."""
    times = [0.0, *(t for t in asked.times if 0 < t < asked.duration), asked.duration]
    for begin, end in pairwise(times):
        yield _Piece(
            begin,
            end,
            complex(_rate(asked, asked.x, begin, end), _rate(asked, asked.y, begin, end)),
            _rate(asked, asked.up, begin, end),
        )


def _rate(asked: Swing, speeds: tuple[float, ...], begin: float, end: float) -> float:
    if not speeds:
        return 0.0
    first, last = np.interp([begin, end], asked.times, speeds)
    return float(last - first) / (end - begin)


def _carrier(asked: Swing, t: Values) -> Complex:
    """Place (n,) of the joint, which begins at 0."""
    place = np.zeros(len(t), complex)
    for unit, speeds in ((1.0, asked.x), (1j, asked.y)):
        if not speeds:
            continue
        knots = np.union1d(np.array([0.0, asked.duration]), np.array(asked.times))
        knots = knots[(knots >= 0) & (knots <= asked.duration)]
        v = np.interp(knots, asked.times, speeds)
        way = np.append(0.0, np.cumsum(np.diff(knots) * (v[1:] + v[:-1]) / 2))
        k = np.clip(np.searchsorted(knots, t, side="right") - 1, 0, len(knots) - 2)
        s = t - knots[k]
        place += unit * (way[k] + v[k] * s + (v[k + 1] - v[k]) / (knots[k + 1] - knots[k]) * s**2 / 2)
    return place


def _moved(
    task: PendulumTask, asked: Swing, basis: Basis, plane: _Plane, t: Values
) -> tuple[Complex, Complex, Values, float]:
    """Displacement and slope of the lower end (n,), energy (n,), and the largest open balance of a piece."""
    state = _begin(task, asked, basis, plane)
    paths = []
    for piece in _pieces(asked):
        last = piece.end == asked.duration
        times = t[(t >= piece.begin) & ((t < piece.end) | last)] - piece.begin
        paths.append(_piece(task, basis, plane, piece, state, times))
        state = paths[-1].state
    tip, slope, energy = (np.concatenate([path[k] for path in paths]) for k in range(3))
    return tip, slope, energy, max(path.open for path in paths)


def _piece(task: PendulumTask, basis: Basis, plane: _Plane, piece: _Piece, first: Complex, times: Values) -> _Path:
    """The motion at times (m,) since the beginning of a piece, from the state (z, -i z') there."""
    gravity = task.gravity + piece.up
    if task.gravity > 0 >= gravity and not task.pivot:
        raise NoSolutionError(
            f"the carrier falls with {-piece.up:.6g} m/s^2 from t = {piece.begin:.6g} s: nothing stretches the rod",
            where="pendulum.swing",
            value=gravity,
            limit=0.0,
            remedy="let the carrier's speed change more slowly",
        )
    n, parts = basis.count, matrices(task, basis, plane.number, gravity)
    pull = piece.across.real * plane.along + piece.across.imag * plane.across
    rest = np.zeros(2 * n, complex)
    rest[:n] = -pull * np.linalg.solve(parts.stiffness, parts.load)
    pencil = whirl(parts, np.array(task.spin))
    turning = _whirl(task, parts) * np.exp(1j * task.spin * piece.begin)
    whole = np.zeros((2 * n, 2 * n))
    whole[:n, :n], whole[n:, n:] = parts.stiffness, parts.mass
    shares = pencil.y.T @ (whole @ (first - rest - turning))
    at = np.append(times, piece.end - piece.begin)
    states = rest[:, None] + turning[:, None] * np.exp(1j * task.spin * at)
    states += pencil.y @ (shares[:, None] * np.exp(1j / pencil.mu[:, None] * at))
    energy = np.sum(states.conj() * (whole @ states), axis=0).real / 2
    kept = energy + np.real(np.conj(pull) * (parts.load @ states[:n]))
    kept -= _work(task, piece, (parts.tip @ pencil.y[n:]) * shares, 1 / pencil.mu, at)
    largest = float(np.max(energy))
    open_ = float(np.ptp(kept)) / largest if largest else 0.0
    tip, slope = parts.tip @ states[:n], parts.slope @ states[:n]
    return _Path(tip[:-1], slope[:-1], energy[:-1], open_, states[:, -1])


def _whirl(task: PendulumTask, parts: Matrices) -> Complex:
    """(z, -i z') of the steady whirl of the unbalance at the angle 0 of the spin; it is none without both."""
    moment = task.disc.mass * task.disc.eccentricity
    if not moment or not task.spin:
        return np.zeros(2 * len(parts.mass), complex)
    shape = unbalance_whirl(parts, moment, task.spin)
    return np.concatenate((shape, task.spin * shape)).astype(complex)


def _work(task: PendulumTask, piece: _Piece, rates: Complex, frequency: Values, at: Values) -> Values:
    """Work (m,) of the unbalance on the modes since the beginning of the piece; ``rates`` are -i z' of the lower end.

    On its own whirl, which stands still in the axes of the rotor, it does none.
    """
    force = task.disc.mass * task.disc.eccentricity * task.spin**2 * np.exp(1j * task.spin * piece.begin)
    if not force:
        return np.zeros(len(at))
    gap = task.spin - frequency
    done: Values = -np.real(force * np.conj(rates) / gap @ np.expm1(1j * np.outer(gap, at)))
    return done


def _begin(task: PendulumTask, asked: Swing, basis: Basis, plane: _Plane) -> Complex:
    """(z, -i z') at the beginning: tilted, pulled aside, pushed across."""
    n, parts = basis.count, matrices(task, basis, plane.number)
    pulled = np.linalg.solve(parts.stiffness, parts.tip)
    pulled = pulled / float(parts.tip @ pulled)
    state = np.zeros(2 * n, complex)
    state[:n] = asked.deflection * plane.along * pulled
    if asked.tilt:
        state[:n] += asked.tilt * plane.along * task.rod.length * _tilt(basis)
    state[n:] = -1j * asked.push * plane.across * pulled
    return state


def _tilt(basis: Basis) -> Values:
    """The straight tilt f = s in the functions of the basis."""
    found = np.zeros(basis.count)
    found[0] = 1.0
    if basis.nodal:
        for node, at in enumerate(basis.edges[1:]):
            found[1 + 2 * node], found[2 + 2 * node] = at, 1.0
    return found
