"""Random machines for the tests of estimates: the cycle as the program has it, and the same in extended precision."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from machine.exact import WIDE, Exact, Function
from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.motors.characteristics import kloss, parabolic, straight
from tmmcalc.machine.motors.direct_current import series
from tmmcalc.machine.motors.gearing import reduced
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.steady import driven

TURN = 2 * np.pi
KINDS = ("kloss", "line", "parabola", "series", "with losses")


class Drawn:
    """A random machine: links that swing, a load of waves with or without jumps, resistance, a motor that may lag."""

    def __init__(
        self, rng: np.random.Generator, *, slips: tuple[float, float] = (-6, -1), lagging: float = 0.0
    ) -> None:
        self.speed, self.inertia = 10 ** rng.uniform(0, 2), 10 ** rng.uniform(-1, 2)
        # kinetic energy over the work of the rated moment in a radian
        self.rated = self.inertia * self.speed**2 / 10 ** rng.uniform(-0.5, 4)
        self.slip, self.kind = 10 ** rng.uniform(*slips), str(rng.choice(KINDS))
        share = rng.uniform(0, 0.6) if rng.random() < 0.8 else 0.0
        # the links swing by what the motor holds
        self.swing = min(share * self.inertia / 2, 0.25 * self.rated / self.speed**2) * rng.uniform()
        self.constant, self.base = self.inertia * (1 - share), share * self.inertia
        self.waves = 0.04 * self.rated * rng.normal(size=(2, 3))
        self.mean, self.depth = 0.45 * self.rated, rng.uniform(0.1, 0.5) * self.rated
        self.jumps: tuple[float, ...] = tuple(np.sort(rng.uniform(0.2, 6, 2))) if rng.random() < 0.5 else ()
        self.viscous = -rng.uniform(0, 0.1) * self.rated / self.speed if rng.random() < 0.3 else 0.0
        self.lag = 10 ** rng.uniform(-4, -1.5) if rng.random() < lagging else 0.0
        self.motor = self._motor(rng.uniform(0.05, 0.4))
        on = panels(0, TURN, self.jumps)
        x, none = on.x.astype(WIDE), np.zeros(on.x.shape)
        links, bend, load = (np.asarray(f(x), float) for f in (self.links, self.bend, self.load))
        self.cycle = Cycle(on, links, bend, load, none + self.viscous, none, self.speed)

    def _motor(self, drop: float) -> Any:
        rated, speed, sync = self.rated, self.speed, self.speed * (1 + self.slip)
        if self.kind == "kloss":
            return kloss(2.5 * rated, 4.8 * self.slip, sync, speed)
        if self.kind == "line":
            return straight(rated, speed, sync)
        if self.kind == "parabola":
            return parabolic(rated, speed, sync)
        if self.kind == "series":
            return series(rated, speed, drop)
        return reduced(straight(rated / 21.3 / 0.9, 21.3 * speed, 21.3 * sync), 21.3, 0.9)

    def links(self, x: Any) -> Any:
        """Inertia of the links."""
        return WIDE(self.base) + WIDE(self.swing) * np.sin(2 * x)

    def bend(self, x: Any) -> Any:
        """Its derivative."""
        return 2 * WIDE(self.swing) * np.cos(2 * x)

    def load(self, x: Any, side: Any = None) -> Any:
        """Moment of the load; ``side`` tells on which side of a jump ``x`` lies."""
        side = x if side is None else side
        waves = sum(WIDE(a) * np.cos(k * x) + WIDE(b) * np.sin(k * x) for k, (a, b) in enumerate(self.waves.T, 1))
        if not self.jumps:
            return waves - WIDE(self.mean)
        return waves - WIDE(self.mean) - WIDE(self.depth) * ((side > self.jumps[0]) & (side < self.jumps[1]))

    def regime(self, **options: Any) -> Regime:
        """The regime as the program has it."""
        return driven(self.cycle, self.constant, self.motor, time_constant=self.lag, **options)

    def bends(self, found: Regime) -> bool:
        """Whether the losses of gears bend the characteristic where the machine runs."""
        return self.kind == "with losses" and float(np.min(self.motor.moment(found.omega))) <= 0

    def exact(self, found: Regime, **options: Any) -> Exact:
        """The same in extended precision; raises `RuntimeError` where that is too dear."""
        reference = float(found.omega.flat[0])
        return Exact(
            lambda x: self.links(x) + WIDE(self.constant),
            self.bend,
            self.load,
            *over(self.motor, reference),
            reference,
            lambda x: found.omega_at(x.ravel()).reshape(x.shape),
            jumps=self.jumps,
            viscous=self.viscous,
            lag=self.lag,
            **options,
        )


def over(motor: Any, reference: float) -> tuple[Function, Function]:
    """Moment and slope of a motor over w = omega - ``reference``, without the cancellation in omega_c - omega."""
    r, wide = Fraction(reference), WIDE(reference)
    if motor.name == "constant":
        return lambda w: motor.value + 0 * w, lambda w: 0 * w
    if motor.name == "linear" and hasattr(motor, "base"):
        base, u = motor.base, Fraction(motor.ratio)
        top, fall = (
            _wide(Fraction(base.stiffness) * (Fraction(base.synchronous) - u * r)),
            WIDE(base.stiffness) * WIDE(motor.ratio),
        )
        mean, half = WIDE(motor.mean), WIDE(motor.half)

        def factor(w: Any) -> Any:
            return np.where(top - fall * w > 0, mean + half, mean - half)

        return lambda w: factor(w) * (top - fall * w), lambda w: -factor(w) * fall
    if motor.name == "linear":
        top, fall = _wide(Fraction(motor.synchronous) - r), WIDE(motor.stiffness)
        return lambda w: fall * (top - w), lambda w: -fall + 0 * w
    if motor.name == "parabolic":
        top, b = _wide(Fraction(motor.a) - Fraction(motor.b) * r * r), WIDE(motor.b)
        return lambda w: top - b * w * (2 * wide + w), lambda w: -2 * b * (wide + w)
    if motor.name == "series":
        # M = (m/kappa^2)/(omega + r/kappa)^2 of a flux that is proportional to the current
        c, top = WIDE(motor.scale) / WIDE(motor.rate) ** 2, wide + WIDE(motor.drop) / WIDE(motor.rate)
        return lambda w: c / (top + w) ** 2, lambda w: -2 * c / (top + w) ** 3
    top, c, square = _wide(Fraction(motor.synchronous) - r), WIDE(motor.scale), WIDE(motor.square)

    def slope(w: Any) -> Any:
        d2 = (top - w) ** 2
        return c * (d2 - square) / (d2 + square) ** 2

    return lambda w: c * (top - w) / ((top - w) ** 2 + square), slope


def _wide(value: Fraction) -> Any:
    near = float(value)
    return WIDE(near) + WIDE(float(value - Fraction(near)))
