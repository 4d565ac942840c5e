"""What the extreme scenes ought to give, from closed forms and from integrators that share nothing with the package.

The in-line crank-slider of all linkages here: crank r, rod l, slider on the x axis, phi from the outer dead centre.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

Array = NDArray[Any]
TURN = 2 * math.pi
DENSE = np.linspace(0.0, TURN, 7201)


@dataclass(frozen=True)
class Slider:
    """Crank-slider with a rod of mass m2, inertia j2 about its centre at the distance s from A, and a slider m3."""

    r: float = 0.05
    l: float = 0.2
    m2: float = 0.0
    j2: float = 0.0
    s: float = 0.0
    m3: float = 0.0

    def lean(self, phi: Any) -> Any:
        """Angle of the rod below the x axis."""
        return np.arcsin(self.r / self.l * np.sin(phi))

    def x(self, phi: Any) -> Any:
        return self.r * np.cos(phi) + self.l * np.cos(self.lean(phi))

    def x1(self, phi: Any) -> Any:
        """dx/dphi."""
        return -self.r * np.sin(phi) - self.r * np.cos(phi) * np.tan(self.lean(phi))

    def x2(self, phi: Any) -> Any:
        """d2x/dphi2."""
        lean, turn = self.lean(phi), self.turn(phi)
        return -self.r * np.cos(phi) + self.r * (np.sin(phi) * np.tan(lean) - np.cos(phi) * turn / np.cos(lean) ** 2)

    def turn(self, phi: Any) -> Any:
        """Speed of the lean against that of the crank."""
        return self.r * np.cos(phi) / (self.l * np.cos(self.lean(phi)))

    def inertia(self, phi: Any) -> Any:
        """Reduced inertia [kg*m^2]."""
        lean, turn = self.lean(phi), self.turn(phi)
        centre_x = -self.r * np.sin(phi) - self.s * np.sin(lean) * turn
        centre_y = self.r * np.cos(phi) - self.s * np.cos(lean) * turn
        return self.m2 * (centre_x**2 + centre_y**2) + self.j2 * turn**2 + self.m3 * self.x1(phi) ** 2


@dataclass(frozen=True)
class Pressed:
    """A crank-slider whose slider bears the force q along x over phi in [start, end], driven by a constant moment."""

    slider: Slider
    q: float
    start: float = 0.0
    end: float = math.pi

    def moment(self, phi: Any) -> Any:
        """Reduced moment of the force [N*m]."""
        turned = np.mod(phi, TURN)
        return self.q * self.slider.x1(phi) * ((turned >= self.start) & (turned <= self.end))

    @property
    def work(self) -> float:
        """Work of the force over a turn [J], negative."""
        return float(self.q * (self.slider.x(self.end) - self.slider.x(self.start)))

    def surplus(self, phi: Any) -> Any:
        """Work of force and constant driving moment from 0 to phi [J]."""
        at = np.clip(phi, self.start, self.end)
        return self.q * (self.slider.x(at) - self.slider.x(self.start)) - self.work * phi / TURN

    def flywheel(self, delta: float, speed: float) -> float:
        """Constant inertia for the unevenness delta, (3.53) without its neglect of delta^2."""
        high, low = (speed**2 * (1 + sign * delta / 2) ** 2 / 2 for sign in (1, -1))
        top = largest(lambda phi: self.surplus(phi) - high * self.slider.inertia(phi))
        bottom = -largest(lambda phi: low * self.slider.inertia(phi) - self.surplus(phi))
        return (top - bottom) / (delta * speed**2)


def largest(f: Callable[[Any], Any]) -> float:
    """Largest value of f over a turn: a dense scan, then a search about its best place."""
    best = int(np.argmax(f(DENSE)))
    span = DENSE[max(best - 1, 0)], DENSE[min(best + 1, len(DENSE) - 1)]
    found = minimize_scalar(lambda phi: -float(f(phi)), bounds=span, method="bounded", options={"xatol": 1e-9})
    return max(-float(found.fun), float(f(DENSE[best])))


@dataclass(frozen=True)
class Induction:
    """An induction motor behind a gear, all reduced to the crank."""

    power: float  # rated [W]
    rated: float  # speed of the crank then [rad/s]
    synchronous: float
    overload: float = 2.2

    @property
    def nominal(self) -> float:
        """Rated moment."""
        return self.power / self.rated

    @property
    def parabola(self) -> tuple[float, float]:
        """A and B of A - B w^2."""
        b = self.nominal / ((self.synchronous - self.rated) * (self.synchronous + self.rated))
        return b * self.synchronous**2, b

    def kloss(self, w: Any) -> Any:
        slip, rated = 1 - w / self.synchronous, 1 - self.rated / self.synchronous
        critical = rated * (self.overload + math.sqrt(self.overload**2 - 1))
        return 2 * self.overload * self.nominal * slip * critical / (slip**2 + critical**2)


def slip_by_parabola(load: Pressed, motor: Induction, inertia: float, at: Array) -> Array:
    """(1 - w^2/w_c^2)/rated slip at ascending angles in [0, 2 pi), a massless linkage in its periodic regime.

    J/2 dy/dphi = A - B y + M of y = w^2, written for the small difference itself: nothing cancels.
    """
    (_, b), rated = motor.parabola, 1 - motor.rated / motor.synchronous

    def rate(phi: float, z: Array) -> Array:
        return -2 * (load.moment(phi) / motor.synchronous**2 / rated + b * z) / inertia

    memory = math.ceil(40 * inertia / (2 * b) / TURN)  # turns until the beginning is forgotten to exp(-40)
    nodes = sorted({0.0, load.end, TURN, *map(float, at)})
    z, found = np.array([0.0]), {0.0: 0.0}
    for _ in range(memory + 1):
        for first, last in pairwise(nodes):
            found[first] = float(z[0])
            # a hair within, as the load ends at the very node; ends of steps, as output between them is of low order
            span = (first + 1e-13, last - 1e-13)
            steps = solve_ivp(
                rate, span, z, "Radau", rtol=1e-10, atol=1e-13, jac=lambda *_: np.array([[-2 * b / inertia]])
            )
            assert steps.success
            z = steps.y[:, -1]
    return np.array([found[float(phi)] for phi in at])


def passes(load: Pressed, motor: Induction, inertia: float, turns: int = 12) -> float | None:
    """Angle [rad] at which a massless linkage stalls, coming from the synchronous speed; None if it does not.

    The energy is followed over the angle, which needs no time and no speed in the denominator.
    """

    def rate(phi: float, energy: Array) -> Array:
        w = math.sqrt(max(2 * energy[0] / inertia, 0.0))
        return np.array([motor.kloss(w) + load.moment(phi)])

    def still(_: float, energy: Array) -> float:
        return float(energy[0])

    stop: Any = still
    stop.terminal = True
    energy = [inertia * motor.synchronous**2 / 2]
    edges = [0.0, load.start, load.end, TURN]
    for turn in range(turns):
        for first, last in pairwise(edges):
            if last <= first:
                continue
            span = (turn * TURN + first + 1e-12, turn * TURN + last - 1e-12)
            found = solve_ivp(rate, span, energy, "LSODA", events=stop, rtol=1e-9, atol=1e-9 * energy[0])
            if found.t_events[0].size:
                return float(found.t_events[0][0])
            energy = list(found.y[:, -1])
    return None
