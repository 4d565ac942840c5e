"""Motors, cycles and drives for the tests of transient motion, independent of the other rooms."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Drive, Mass
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import simulate

CASES = Path(__file__).parents[2] / "cases" / "dynamics.json"
PERIOD = 2 * math.pi
Shape = Callable[[np.ndarray], np.ndarray]


def case(name: str) -> dict[str, Any]:
    return next(c for c in json.loads(CASES.read_text()) if c["id"] == name)


class Motor:
    """A characteristic of any formula."""

    name = "test"
    least = most = None

    def __init__(
        self,
        moment: Callable[[Any], Any],
        slope: Callable[[Any], Any],
        synchronous: float | None = None,
        nominal: float | None = None,
        critical: float | None = None,
    ) -> None:
        self.moment, self.slope = moment, slope
        self.synchronous, self.nominal, self.critical = synchronous, nominal, critical


def constant(moment: float) -> Motor:
    return Motor(lambda w: moment + 0 * w, lambda w: 0 * w)


def line(stiffness: float, synchronous: float) -> Motor:
    return Motor(lambda w: stiffness * (synchronous - w), lambda w: -stiffness + 0 * w, synchronous)


def parabola(a: float, b: float) -> Motor:
    return Motor(lambda w: a - b * w * w, lambda w: -2 * b * w, math.sqrt(a / b))


def kloss(peak: float, critical_slip: float, synchronous: float, nominal: float | None = None) -> Motor:
    def moment(w: Any) -> Any:
        s = 1 - w / synchronous
        return 2 * peak * critical_slip * s / (s * s + critical_slip * critical_slip)

    def slope(w: Any) -> Any:
        s = 1 - w / synchronous
        d = s * s + critical_slip * critical_slip
        return -2 * peak * critical_slip * (critical_slip * critical_slip - s * s) / (d * d * synchronous)

    return Motor(moment, slope, synchronous, nominal, synchronous * (1 - critical_slip))


def cycle(
    moment: Shape | float = 0.0,
    inertia: Shape | float = 0.0,
    breaks: tuple[float, ...] = (),
    viscous: Shape | float = 0.0,
    quadratic: Shape | float = 0.0,
    speed: float = 1.0,
    period: float = PERIOD,
) -> Cycle:
    at = panels(0.0, period, breaks)
    inside = at.x

    def values(shape: Shape | float) -> np.ndarray:
        return shape(inside) if callable(shape) else np.full(inside.shape, float(shape))

    j = values(inertia)
    return Cycle(at, j, at.slope(j), values(moment), values(viscous), values(quadratic), speed)


L1, L2, SLIDER, WEIGHT, FORCE = 0.0375, 3.5 * 0.0375, 30.0, 300.0, 3040.0


def travel(phi: Any) -> Any:
    """S' of the slider of the upsetter, its guide along X (downwards from phi = 0)."""
    return -L1 * np.sin(phi) - L1**2 * np.sin(phi) * np.cos(phi) / np.sqrt(L2**2 - (L1 * np.sin(phi)) ** 2)


def upsetter(factor: float) -> Cycle:
    """Crank-slider press of textbook section 3.4.4.4: slider weight, and a force q phi^2 on the way down."""
    return cycle(
        lambda p: (factor * FORCE * np.where(p < math.pi, p * p, 0.0) - WEIGHT) * travel(p),
        lambda p: SLIDER * travel(p) ** 2,
        (math.pi,),
        speed=10.0,
    )


def upsetter_drive(motor: Motor, constant_inertia: float) -> Drive:
    return Drive((Mass(constant_inertia),), characteristic=motor, cycle=upsetter(1.0), idle=upsetter(0.0))


def run(drive: Drive, scenario: Scenario, name: str = "auto", instants: Any = (), **more: Any) -> Transient:
    return simulate(drive, scenario, Method(name, **more), instants)


def at(result: Transient, times: Any) -> np.ndarray:
    """Rows of the result at times that were asked for."""
    rows = np.searchsorted(result.t, times)
    assert np.array_equal(result.t[rows], times)
    return rows


def event(result: Transient, kind: str, nth: int = 0) -> Any:
    return [e for e in result.events if e.kind == kind][nth]
