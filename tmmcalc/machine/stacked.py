"""Steady motions of many machines with motors at once, each on its own panels.

Every step solves the linearised equation of all machines in closed form, panel by panel, from the energy E at its
start: with j = df/dE and Q = int j

    E = exp(Q) (E_start + int exp(-Q) (f - j E))

The arrays have the shape (V, K, N): V machines, K panels, N points. A machine with fewer panels has some of no width at
its end. Machines that draw to their regime from the no-load speed without any doubt are ``clear``; the others are to be
solved alone.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.machine.onemass import SPEEDS
from tmmcalc.numerics.gauss import ORDER, legendre, rule
from tmmcalc.numerics.panels import Panels, Values
from tmmcalc.numerics.roots import Indices

if TYPE_CHECKING:
    from tmmcalc.linkage.stacked.reduction import Cycles
    from tmmcalc.machine.motors.characteristics import Characteristic

Flags = NDArray[np.bool_]

STEPS = 14
CLOSE = 1e-11  # relative step after which nothing is left: digits double
RESOLVED = 1e-12  # last coefficients of the speed, relative
STIFF = 3.0  # decay over a panel above which its polynomial is not trusted
HALVINGS = 3  # of all panels, where some do not resolve the speed
BETWEEN = np.linspace(0.0, 1.0, 9)  # speeds looked at between the regime and the no-load speed


class Machines(NamedTuple):
    """Cycles of V machines."""

    low: Values  # (V, K) lower edges of the panels; infinity: there is no such panel
    width: Values  # (V, K)
    inertia: Values  # (V, K, N) [kg*m^2], all of it
    slope: Values  # dJ/dtheta [kg*m^2/rad]
    moment: Values  # [N*m]
    viscous: Values  # [N*m*s]
    motor: Characteristic  # reduced to the input shaft; its constants (V, 1, 1) where they differ


class Regimes(NamedTuple):
    """Steady motions of V machines."""

    machines: Machines
    omega: Values  # (V, K, N) [rad/s]
    clear: Flags  # (V,)

    @property
    def driving(self) -> Values:
        """Moment of the motor (V, K, N) [N*m]."""
        return self.machines.motor.moment(self.omega)

    @property
    def load(self) -> Values:
        """Moment of everything else (V, K, N) [N*m]."""
        return self.machines.moment + self.machines.viscous * self.omega

    @property
    def acceleration(self) -> Values:
        """Angular acceleration (V, K, N) [rad/s^2]."""
        m = self.machines
        return (self.driving + self.load - m.slope * self.omega * self.omega / 2) / m.inertia


def machines_of(cycles: Cycles, count: int, constant: Any, motor: Characteristic) -> Machines:
    """The machines of ``count`` cycles; ``constant`` (V,) or one number is their further inertia [kg*m^2]."""
    on = cycles.panels
    panels = np.bincount(on.owner, minlength=count)
    number = np.arange(panels.max())
    there = number < panels[:, None]
    at = (np.cumsum(panels) - panels)[:, None] + np.minimum(number, panels[:, None] - 1)
    inertia, slope, moment, viscous = cycles.values[:, at]
    further = np.broadcast_to(np.asarray(constant), count)[:, None, None]
    low, width = np.where(there, on.low[at], np.inf), np.where(there, on.width[at], 0.0)
    return Machines(low, width, inertia + further, slope, moment, viscous, motor)


def regimes(machines: Machines) -> Regimes:
    """The regimes that the machines settle in from their no-load speeds."""
    omega, balanced = _balanced(machines)
    found, resolved = _solved(machines, omega, balanced)
    for _ in range(HALVINGS):
        if np.all(resolved | ~balanced):
            break
        machines = _halved(machines)
        found, resolved = _solved(machines, omega, balanced)
    return found._replace(clear=found.clear & resolved)


def _halved(m: Machines) -> Machines:
    """The machines with all panels halved, their functions interpolated."""
    r = rule(ORDER)
    halves = [legendre(r.points + side, ORDER)[:-1].T @ r.coefficients for side in (-1.0, 0.0)]

    def on_halves(values: Values) -> Values:
        both = np.stack([values @ half.T for half in halves], axis=2)
        return both.reshape(len(values), -1, ORDER)

    low = np.stack((m.low, m.low + m.width / 2), axis=2).reshape(len(m.low), -1)
    inertia, slope, moment, viscous = map(on_halves, (m.inertia, m.slope, m.moment, m.viscous))
    return Machines(low, np.repeat(m.width / 2, 2, axis=1), inertia, slope, moment, viscous, m.motor)


def _solved(machines: Machines, omega: Values, clear: Flags) -> tuple[Regimes, Flags]:
    """The regimes near constant speeds (V,), and which of them the panels resolve."""
    m, motor = machines, machines.motor
    energy = m.inertia * omega[:, None, None] ** 2 / 2
    step = np.full(len(omega), np.inf)
    stiff = np.zeros(len(omega), bool)
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            speed = np.sqrt(2 * energy / m.inertia)
            rate = (motor.slope(speed) + m.viscous) / (m.inertia * speed)
            found, decay = _linear(m, rate, motor.moment(speed) + m.moment + m.viscous * speed - rate * energy)
            step = np.max(np.abs(found - energy) / energy, axis=(1, 2), where=(m.width > 0)[..., None], initial=0.0)
            stiff = decay > STIFF
            energy = np.maximum(found, 0.2 * energy)
            if np.all((step < CLOSE) | ~(step < 1e3) | stiff | ~clear):
                break
        speed = np.sqrt(2 * energy / m.inertia)
        clear = clear & (step < CLOSE) & _draws(m, speed)
    return Regimes(m, speed, clear), ~stiff & _resolved(m, speed)


def _balanced(m: Machines) -> tuple[Values, Flags]:
    """Speeds (V,) at which the mean moments balance, nearest to the no-load speed; and where there is one."""
    reference = np.broadcast_to(np.asarray(m.motor.synchronous or m.motor.nominal or 1.0).ravel(), len(m.low))
    mean = [np.einsum("vkn,n,vk->v", v, rule(ORDER).weights, m.width) for v in (m.moment, m.viscous)]
    period = np.sum(m.width, axis=1)
    omega = (reference[:, None] * SPEEDS)[:, None]
    net = (m.motor.moment(omega) + (mean[0] / period)[:, None, None] + (mean[1] / period)[:, None, None] * omega)[:, 0]
    falls = (net[:, :-1] >= 0) & (net[:, 1:] < 0)
    k = np.argmin(np.where(falls, np.abs(SPEEDS[:-1] - 1), np.inf), axis=1)
    every = np.arange(len(k))
    a, b = net[every, k], net[every, k + 1]
    part = a / np.where(a == b, 1.0, a - b)
    clear = falls.any(axis=1)
    return np.where(clear, reference * (SPEEDS[k] + (SPEEDS[k + 1] - SPEEDS[k]) * part), reference), clear


def _linear(m: Machines, rate: Values, rest: Values) -> tuple[Values, Values]:
    """Periodic solutions (V, K, N) of E' = rate E + rest, and the largest decay over a panel (V,)."""
    r, width = rule(ORDER), m.width[..., None]
    powers = width * (rate @ r.primitive.T)
    whole = m.width * (rate @ r.weights)
    lessened = np.exp(-powers) * rest
    inner, gains = width * (lessened @ r.primitive.T), m.width * (lessened @ r.weights)
    growth = np.exp(whole)
    starts = np.empty_like(gains)
    end = np.zeros(len(gains))
    for k in range(gains.shape[1]):
        starts[:, k] = end
        end = growth[:, k] * (end + gains[:, k])
    grown = np.cumprod(growth, axis=1)
    starts[:, 1:] += (end / (1 - grown[:, -1]))[:, None] * grown[:, :-1]
    starts[:, 0] = end / (1 - grown[:, -1])
    return np.exp(powers) * (starts[..., None] + inner), np.max(np.abs(whole), axis=1)


def _resolved(m: Machines, omega: Values) -> Flags:
    """Machines whose speed the panels resolve."""
    tail = np.max(np.abs(omega @ rule(ORDER).coefficients[-3:].T), axis=2, initial=0.0)
    return np.all((tail <= RESOLVED * np.max(omega, axis=2)) | (m.width == 0), axis=1)


def _draws(m: Machines, omega: Values) -> Flags:
    """Machines whose moments fall with the speed from the regime to the no-load speed, and do not bend there."""
    top = np.asarray(m.motor.synchronous or m.motor.nominal or 1.0)
    inside = (m.width > 0)[..., None]
    falls = np.all((m.viscous <= 0) | ~inside, axis=(1, 2))
    low = np.min(omega, axis=(1, 2), where=inside, initial=np.inf)
    high = np.max(omega, axis=(1, 2), where=inside, initial=0.0)
    until = np.maximum(np.broadcast_to(top.ravel(), low.shape), high)
    between = (low[:, None] + (until - low)[:, None] * BETWEEN)[:, None]
    smooth = (high < until) | (not hasattr(m.motor, "base"))  # beyond it losses of gears bend
    return np.asarray(falls & smooth & np.all(m.motor.slope(between)[:, 0] < 0, axis=1))


def is_smooth(motor: Characteristic) -> bool:
    """Whether a characteristic is smooth at all speeds, or but for losses of gears at all below the no-load speed."""
    from tmmcalc.machine.motors.characteristics import Kloss, Parabolic, Straight
    from tmmcalc.machine.motors.gearing import Reduced

    return isinstance(motor.base if isinstance(motor, Reduced) else motor, Parabolic | Straight | Kloss)


def figures(found: Regimes) -> dict[str, Values]:
    """Figures (V,) of the regimes, under their names in the summary of a motion."""
    m = found.machines
    low, high = _extremes(m, found.omega)
    r, period = rule(ORDER), np.sum(m.width, axis=1)
    time, work = (np.einsum("vkn,n,vk->v", v, r.weights, m.width) for v in (1 / found.omega, found.driving))
    return {
        "delta": (high - low) / ((high + low) / 2),
        "omega_min": low,
        "omega_max": high,
        "omega_mean": (high + low) / 2,
        "omega_time_mean": period / time,
        "cycle_time": time,
        "M_d_mean": work / period,
        "P_mean": work / time,
    }


FIGURES = ("delta", "omega_min", "omega_max", "omega_mean", "omega_time_mean", "cycle_time", "M_d_mean", "P_mean")


def _extremes(m: Machines, omega: Values) -> tuple[Values, Values]:
    """Least and largest speed (V,)."""
    there = m.width > 0
    owner = np.nonzero(there)[0]
    row = omega[there]
    # all panels one behind the other, each of the width one
    at, values = Panels(np.arange(len(row) + 1.0)).turning(row)
    own = owner[np.minimum(at.astype(int), len(row) - 1)]
    ends = np.concatenate([row @ end for end in rule(ORDER).ends])
    low, high = np.full(len(omega), np.inf), np.zeros(len(omega))
    inner = slice(0, len(at) - len(ends))
    for which, found in ((own[inner], values[inner]), (np.tile(owner, 2), ends)):
        np.minimum.at(low, which, found)
        np.maximum.at(high, which, found)
    return low, high


class Spots(NamedTuple):
    """Angles (n,) within the panels of V machines: the panel of each (V, n), its place there and what points count."""

    panel: Indices  # (V, n)
    place: Values  # (V, n) from 0 to 1
    parts: Values  # (V, n, N) of the points of the panel in a value

    def at(self, values: Values) -> Values:
        """Values (V, n) of a function (V, K, N); on an edge the limit from above."""
        return np.asarray(np.einsum("vmn,vmn->vm", self._rows(values), self.parts))

    def primitive(self, m: Machines, values: Values) -> Values:
        """Integrals (V, n) of a function (V, K, N) from the first edge on."""
        r, t = rule(ORDER), self.place
        whole = m.width * (values @ r.weights)
        before = np.cumsum(whole, axis=1) - whole
        p = legendre(2 * t.ravel() - 1, ORDER)
        inner = np.vstack((p[1] + 1, (p[2:] - p[:-2]) / (2 * np.arange(1, ORDER) + 1)[:, None])) / 2
        coefficients = self._rows(values) @ r.coefficients.T
        part = np.einsum("vmn,nvm->vm", coefficients, inner.reshape(ORDER, *t.shape))
        width = np.take_along_axis(m.width, self.panel, axis=1)
        return np.asarray(np.take_along_axis(before, self.panel, axis=1) + width * part)

    def _rows(self, values: Values) -> Values:
        return values[np.arange(len(values))[:, None], self.panel]


def spots(m: Machines, theta: Values) -> Spots:
    """Where angles (n,) lie in the panels of all machines."""
    panel = np.maximum(np.sum(m.low[:, :, None] <= theta, axis=1) - 1, 0)
    low, width = (np.take_along_axis(v, panel, axis=1) for v in (m.low, m.width))
    place = (theta - low) / width
    gap = place[..., None] - rule(ORDER).points
    hit = gap == 0
    parts = np.where(hit.any(axis=-1, keepdims=True), hit, rule(ORDER).barycentric / np.where(hit, 1.0, gap))
    return Spots(panel, place, parts / parts.sum(axis=-1, keepdims=True))
