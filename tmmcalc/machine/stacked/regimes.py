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

from tmmcalc.core.numerics.alike import rows_of
from tmmcalc.core.numerics.gauss import ORDER, legendre, rule, tail
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.machine.onemass import SPEEDS
from tmmcalc.machine.steady import LOSS

if TYPE_CHECKING:
    from tmmcalc.core.numerics.mesh import Mesh
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

    def at(self, which: Indices, further: Values) -> Machines:
        """Some of the machines (v,), each with a ``further`` inertia (v,) [kg*m^2]."""
        low, width, inertia, slope, moment, viscous = (part[which] for part in self[:-1])
        inertia = inertia + further[:, None, None]
        return Machines(low, width, inertia, slope, moment, viscous, rows_of(self.motor, which))


class Regimes(NamedTuple):
    """Steady motions of V machines."""

    machines: Machines
    omega: Values  # (V, K, N) [rad/s]
    multiplier: Values  # (V,) factor of a deviation in a cycle
    tail: Values  # (V, K) last coefficients of the speed, relative
    clear: Flags  # (V,)
    steps: int  # of Newton's method

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


def machines_of(on: Mesh, values: Values, count: int, constant: Any, motor: Characteristic) -> Machines:
    """The machines of ``count`` cycles on panels, from J, dJ/dtheta, moment, moment per speed (4, P, N).

    ``constant`` (V,) or one number is their further inertia [kg*m^2].
    """
    panels = np.bincount(on.owner, minlength=count)
    number = np.arange(panels.max())
    there = number < panels[:, None]
    at = (np.cumsum(panels) - panels)[:, None] + np.minimum(number, panels[:, None] - 1)
    inertia, slope, moment, viscous = values[:, at]
    further = np.broadcast_to(np.asarray(constant), count)[:, None, None]
    low, width = np.where(there, on.low[at], np.inf), np.where(there, on.width[at], 0.0)
    return Machines(low, width, inertia + further, slope, moment, viscous, motor)


def regimes(machines: Machines, halvings: int = HALVINGS) -> Regimes:
    """The regimes that the machines settle in from their no-load speeds; panels are halved so many times at most."""
    omega, balanced = _balanced(machines)
    found, resolved = _solved(machines, omega, balanced)
    for _ in range(halvings):
        if np.all(resolved | ~balanced):
            break
        machines = _halved(machines)
        found, resolved = _solved(machines, omega, balanced)
    return found._replace(clear=found.clear & resolved & ~_steep(found))


def _steep(found: Regimes) -> Flags:
    """Machines whose acceleration is so small a difference of moments that the speed has to be solved again alone."""
    m, omega = found.machines, found.omega
    inside = (m.width > 0)[..., None]
    left = np.abs(found.acceleration) * m.inertia
    fall = np.abs(np.broadcast_to(m.motor.slope(omega), omega.shape)) * omega
    most = (np.max(v, axis=(1, 2), where=inside, initial=0.0) for v in (fall, left))
    steep, small = most
    return np.asarray(steep > LOSS * small)


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
    step, steps = np.full(len(omega), np.inf), 0
    stiff = np.zeros(len(omega), bool)
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            steps += 1
            speed = np.sqrt(2 * energy / m.inertia)
            rate = (motor.slope(speed) + m.viscous) / (m.inertia * speed)
            found, decay = _linear(m, rate, motor.moment(speed) + m.moment + m.viscous * speed - rate * energy)
            step = np.max(np.abs(found - energy) / energy, axis=(1, 2), where=(m.width > 0)[..., None], initial=0.0)
            stiff = decay > STIFF
            energy = np.maximum(found, 0.2 * energy)
            if np.all((step < CLOSE) | ~(step < 1e3) | stiff | ~clear):
                break
        speed = np.sqrt(2 * energy / m.inertia)
        rate = (motor.slope(speed) + m.viscous) / (m.inertia * speed)
        multiplier = np.exp(np.sum(m.width * (rate @ rule(ORDER).weights), axis=1))
        clear = clear & (step < CLOSE) & _draws(m, speed)
        tail = _tail(m, speed)
    return Regimes(m, speed, multiplier, tail, clear, steps), ~stiff & np.all(tail <= RESOLVED, axis=1)


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


def _tail(m: Machines, omega: Values) -> Values:
    """What every panel (V, K) leaves out of the speed, relative to its own largest."""
    return np.where(m.width > 0, tail(omega) / np.max(omega, axis=2), 0.0)


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
