"""Machines for the flywheel tests, their kinematics written out here: nothing comes from the program's linkages."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle

Array = NDArray[Any]
TURN = 2 * np.pi

_FILE = Path(__file__).parents[2] / "cases" / "dynamics.json"
CASES: dict[str, Any] = {case["id"]: case for case in json.loads(_FILE.read_text(encoding="utf-8"))}


def press(phi: Array) -> tuple[Array, Array]:
    """Reduced inertia and resisting moment of the case dyn-flywheel-positional at crank angles phi."""
    given = CASES["dyn-flywheel-positional"]["inputs"]
    l1, l2, l_as = given["l1"], given["l2"], given["l_AS2"]
    s, c = np.sin(phi), np.cos(phi)
    sin_p = -l1 * s / l2
    turn = -l1 * c / (l2 * np.sqrt(1 - sin_p**2))  # of the rod per radian of the crank
    cos_p = np.sqrt(1 - sin_p**2)
    x_s, y_s = -l1 * s - l_as * sin_p * turn, l1 * c + l_as * cos_p * turn
    x_b = -l1 * s - l2 * sin_p * turn
    inertia = given["m2"] * (x_s**2 + y_s**2) + given["J_S2"] * turn**2 + given["m3"] * x_b**2
    start = 7 * np.pi / 6
    force = np.where(phi > start * (1 + 1e-12), -given["Q3_coefficient_rad"] * (phi - start) ** 2, 0.0)
    return inertia, force * x_b - given["m2"] * given["g"] * y_s


def press_cycle(widest: float = np.pi / 6) -> Cycle:
    on = panels(0.0, TURN, (7 * np.pi / 6,), widest)
    inertia, moment = press(on.x)
    nothing = np.zeros_like(moment)
    return Cycle(on, inertia, on.slope(inertia), moment, nothing, nothing, 5.0)


def upsetter(phi: Array, load: float = 1.0) -> tuple[Array, Array]:
    """Reduced inertia and moment of the case dyn-upsetter-flywheel-motor; phi = pi counts as loaded."""
    given = CASES["dyn-upsetter-flywheel-motor"]["inputs"]
    l1, ratio = given["l1"], given["l2_over_l1"]
    s, c = np.sin(phi), np.cos(phi)
    slider = -l1 * s - l1 * s * c / np.sqrt(ratio**2 - s**2)
    force = np.where(phi <= np.pi * (1 + 1e-12), load * given["q_N_per_rad2"] * phi**2, 0.0) - given["G3"]
    return given["m3"] * slider**2, force * slider


def upsetter_cycle(load: float = 1.0) -> Cycle:
    on = panels(0.0, TURN, (np.pi,))
    inertia, moment = upsetter(on.x, load)
    nothing = np.zeros_like(moment)
    return Cycle(on, inertia, on.slope(inertia), moment, nothing, nothing, 10.0)


def parabola() -> tuple[float, float]:
    """A and B of the upsetter's motor, M = A - B omega^2 (3.55), (3.56)."""
    given = CASES["dyn-upsetter-flywheel-motor"]["inputs"]
    nominal, synchronous = given["omega_N"], given["omega_sync"]
    moment = given["P_N_W"] / nominal
    b = moment / (synchronous**2 - nominal**2)
    return b * synchronous**2, b


def brute_delta(work: Array, inertia: Array, constant: float, speed: float) -> float:
    """Coefficient of speed fluctuation on given samples, by bisection on the initial energy."""
    total = inertia + constant
    low, high = -float(np.min(work)), float(np.max(total)) * speed**2 * 50 + float(np.ptp(work))
    for _ in range(200):
        middle = (low + high) / 2
        omega = np.sqrt(2 * (middle + work) / total)
        low, high = (middle, high) if omega.max() + omega.min() < 2 * speed else (low, middle)
    return float(omega.max() - omega.min()) / speed
