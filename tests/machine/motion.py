"""Scenes for the tests of steady motion: machines from closed formulas, motors of their own, an independent reference.

Nothing here comes from the program's linkages or motors: the upsetter and the shaper are written out, the motors are
the least that the contract of a characteristic asks for, and the reference integrates the equation of motion by scipy.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from tmmcalc.core.numerics.panels import Panels, panels, resolved
from tmmcalc.machine.cycle import Cycle

TURN = 2 * math.pi
_FILE = Path(__file__).parents[1] / "cases" / "dynamics.json"
CASES: dict[str, Any] = {case["id"]: case for case in json.loads(_FILE.read_text(encoding="utf-8"))}
UPSETTER = CASES["dyn-upsetter-regime-30"]["inputs"]


@dataclass(frozen=True)
class Motor:
    """The optional speeds of a characteristic."""

    synchronous: float | None = None
    nominal: float | None = None
    critical: float | None = None
    least: float | None = None
    most: float | None = None
    name: str = "test"


@dataclass(frozen=True)
class Kloss(Motor):
    pull_out: float = 1.0  # M_K
    slip: float = 0.1  # s_K

    def moment(self, omega: Any) -> Any:
        s = 1 - omega / self.synchronous
        return 2 * self.pull_out * self.slip * s / (s * s + self.slip**2)

    def slope(self, omega: Any) -> Any:
        s = 1 - omega / self.synchronous
        gain = (self.slip**2 - s * s) / (s * s + self.slip**2) ** 2
        return -2 * self.pull_out * self.slip * gain / self.synchronous


@dataclass(frozen=True)
class Parabola(Motor):
    a: float = 1.0
    b: float = 1.0

    def moment(self, omega: Any) -> Any:
        return self.a - self.b * omega * omega

    def slope(self, omega: Any) -> Any:
        return -2 * self.b * omega


@dataclass(frozen=True)
class Line(Motor):
    stiffness: float = 1.0

    def moment(self, omega: Any) -> Any:
        return self.stiffness * (self.synchronous - omega)

    def slope(self, omega: Any) -> Any:
        return -self.stiffness + 0 * omega


@dataclass(frozen=True)
class Series(Motor):
    scale: float = 1.0

    def moment(self, omega: Any) -> Any:
        return self.scale / (1 + omega) ** 2

    def slope(self, omega: Any) -> Any:
        return -2 * self.scale / (1 + omega) ** 3


@dataclass(frozen=True)
class Constant(Motor):
    value: float = 1.0

    def moment(self, omega: Any) -> Any:
        return self.value + 0 * omega

    def slope(self, omega: Any) -> Any:
        return 0 * omega


@dataclass(frozen=True)
class Lossy(Motor):
    """Another motor behind a gearing whose losses bend its characteristic at the no-load speed."""

    base: Any = None
    efficiency: float = 0.8

    def factor(self, omega: Any) -> Any:
        return np.where(self.base.moment(omega) > 0, self.efficiency, 1 / self.efficiency)

    def moment(self, omega: Any) -> Any:
        return self.factor(omega) * self.base.moment(omega)

    def slope(self, omega: Any) -> Any:
        return self.factor(omega) * self.base.slope(omega)


def upsetter_motor(kind: str) -> Any:
    """The motor of the textbook's cold-heading machine, reduced to its crank."""
    nominal, sync, overload = UPSETTER["omega_N"], UPSETTER["omega_sync"], UPSETTER["K"]
    moment = UPSETTER["P_N_W"] / nominal
    if kind == "par":
        b = moment / (sync**2 - nominal**2)
        return Parabola(sync, nominal, a=b * sync**2, b=b, name="parabolic", least=nominal, most=sync)
    if kind == "lin":
        return Line(sync, nominal, stiffness=moment / (sync - nominal))
    slip = (1 - nominal / sync) * (overload + math.sqrt(overload**2 - 1))
    return Kloss(sync, nominal, sync * (1 - slip), pull_out=overload * moment, slip=slip)


def slider(phi: Any) -> tuple[Any, Any]:
    """First and second derivative of the slider's position over the crank angle."""
    l1, ratio = UPSETTER["l1"], 1 / UPSETTER["l2_over_l1"]
    s, c = np.sin(phi), np.cos(phi)
    root = np.sqrt(1 - (ratio * s) ** 2)
    first = -l1 * (s + ratio * s * c / root)
    second = -l1 * (c + ratio * (c * c - s * s) / root + ratio**3 * (s * c) ** 2 / root**3)
    return first, second


def upsetter_functions(load: float) -> Callable[[Any], tuple[Any, Any, Any]]:
    """phi -> reduced inertia, its derivative, reduced moment."""

    def at(phi: Any) -> tuple[Any, Any, Any]:
        first, second = slider(phi)
        force = load * UPSETTER["q_N_per_rad2"] * phi**2 * (phi < math.pi) - UPSETTER["G3"]
        return UPSETTER["m3"] * first**2, 2 * UPSETTER["m3"] * first * second, force * first

    return at


def cycle_of(
    functions: Callable[[Any], tuple[Any, Any, Any]],
    breaks: tuple[float, ...] = (),
    period: float = TURN,
    speed: float = 10.0,
    viscous: float = 0.0,
    quadratic: float = 0.0,
) -> Cycle:
    """The cycle of functions theta -> (J, dJ/dtheta, M)."""

    def rows(x: np.ndarray) -> np.ndarray:
        return np.stack([np.broadcast_to(row, x.shape) for row in functions(x)])

    on, (inertia, slope, moment), error = resolved(rows, panels(0.0, period, breaks))
    zero = np.zeros_like(moment)
    return Cycle(on, inertia, slope, moment, zero + viscous, zero + quadratic, speed, error)


def upsetter(load: float = 1.0, **more: float) -> Cycle:
    return cycle_of(upsetter_functions(load), (math.pi,), **more)


def shaper_inertia(phi: Any) -> Any:
    """Reduced inertia of the textbook's shaper (rocker and ram), phi from its extreme right position."""
    given = CASES["dyn-shaper-motion-idle"]["inputs"]
    l1, l0, l_c, l4 = given["l1"], given["l0"], given["l_C"], given["l4"]
    angle = phi - math.asin(l1 / l0)
    a_x, a_y = l1 * np.cos(angle), l0 + l1 * np.sin(angle)
    rocker = np.arctan2(a_y, a_x)
    turn = (a_x * l1 * np.cos(angle) + a_y * l1 * np.sin(angle)) / (a_x**2 + a_y**2)
    sin4 = (given["y_D"] - l_c * np.sin(rocker)) / l4
    rod = -l_c * np.cos(rocker) * turn / (l4 * np.sqrt(1 - sin4**2))
    ram = -l_c * np.sin(rocker) * turn - l4 * sin4 * rod
    return given["J_3_about_B"] * turn**2 + given["m5"] * ram**2


def shaper() -> Cycle:
    """The shaper without load; the derivative of its inertia is that of the interpolant."""
    on, (inertia,), error = resolved(lambda x: shaper_inertia(x)[None], panels(0.0, TURN))
    zero = np.zeros_like(inertia)
    return Cycle(on, inertia, on.slope(inertia), zero, zero, zero, 5.76, error)


def of_pieces(loads: list[float], breaks: list[float], inertia: float = 0.0) -> Cycle:
    """A load that is constant between the breaks, the first and the last of which are the ends of the cycle."""
    on = panels(breaks[0], breaks[-1], breaks[1:-1])
    zero = np.zeros_like(on.x)
    load = np.array(loads)[np.searchsorted(breaks, on.x) - 1]
    return Cycle(on, zero + inertia, zero, load, zero, zero, 10.0)


def reference(
    functions: Callable[[Any], tuple[Any, Any, Any]],
    breaks: list[float],
    constant: float,
    motor: Any,
    start: tuple[float, ...],
    *,
    lag: float = 0.0,
    viscous: float = 0.0,
    quadratic: float = 0.0,
    method: str = "DOP853",
    turns: int = 1,
    step: float = math.inf,
) -> Callable[[np.ndarray], np.ndarray]:
    """omega(theta) after some turns from (omega[, moment]) at theta = 0, by scipy at its finest, in omega itself.

    The equation is d omega/d theta = (M - omega^2 J'/2) / (J omega), not the one that the program solves. Where the
    motor's curve bends the largest ``step`` [rad] keeps the error of scipy down.
    """

    def rhs(x: float, y: np.ndarray, inside: float) -> list[float]:
        variable, slope, load = functions(min(max(x, inside - width), inside + width))
        omega = y[0]
        drive = y[1] if lag else motor.moment(omega)
        net = drive + load + viscous * omega + quadratic * omega**2 - omega**2 * slope / 2
        rate = [net / ((variable + constant) * omega)]
        return [*rate, (motor.moment(omega) - y[1]) / (lag * omega)] if lag else rate

    y, pieces = np.array(start), []
    for turn in range(turns):
        for low, high in pairwise(breaks):
            middle, width = (low + high) / 2, (high - low) / 2 * (1 - 1e-14)
            found = solve_ivp(
                rhs,
                (low, high),
                y,
                method,
                rtol=1e-12,
                atol=1e-13,
                max_step=step,
                args=(middle,),
                dense_output=turn == turns - 1,
            )
            assert found.success
            y = found.y[:, -1]
            if turn == turns - 1:
                pieces.append((low, high, found.sol))

    def omega(x: np.ndarray) -> np.ndarray:
        result = np.empty(x.shape)
        for low, high, solution in pieces:
            mine = (x >= low) & (x <= high)
            result[mine] = solution(x[mine])[0]
        return result

    return omega


def refined(cycle: Cycle, times: int = 1) -> Panels:
    """Panels of a cycle, halved."""
    on = cycle.panels
    for _ in range(times):
        on = on.split(np.ones(on.count, bool))
    return on
