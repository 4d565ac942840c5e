"""A machine whose every figure follows from closed forms, and one whole spec with motor, gears and flywheel."""

from __future__ import annotations

import math

import numpy as np
from written import PINS, link, slide

from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.motion import Positions

TURN = 2 * math.pi


def sine(moment: float, inertia: float = 0.0, speed: float = 20.0) -> Cycle:
    """Load -moment sin(theta) about a mean of zero, constant inertia of the links."""
    on = panels(0.0, TURN)
    zero = np.zeros_like(on.x)
    return Cycle(on, zero + inertia, zero, moment * np.sin(on.x), zero, zero, speed)


def steps(loads: tuple[float, ...], speed: float = 10.0, inertia: float = 1.0) -> Cycle:
    """Loads that are constant over equal parts of a turn."""
    edges = np.linspace(0.0, TURN, len(loads) + 1)
    on = panels(0.0, TURN, edges[1:-1])
    zero = np.zeros_like(on.x)
    load = np.array(loads)[np.clip(np.searchsorted(edges, on.x) - 1, 0, None)]
    return Cycle(on, zero + inertia, zero, load, zero, zero, speed)


def positions(n: int, sense: float = 1.0) -> Positions:
    """Labels, phi and theta of n equal steps."""
    theta = np.linspace(0.0, TURN, n + 1)
    return Positions(tuple(map(str, range(n + 1))), sense * theta, theta)


LINKAGE = {
    "links": link(1, 'O = [0, 0], A = ["50 mm", 0]')
    + link(2, 'A = [0, 0], B = ["200 mm", 0]', "mass = 4", "inertia = 0.02", 'center = ["80 mm", 0]')
    + link(3, "B = [0, 0]", "mass = 10"),
    "joints": PINS + slide("B0", 3, 0, 'through = "O", angle = "0 deg"', "friction = 0.1"),
}
SPEC = """
[project]
title = "Press with its motor"

[mechanism.grid]
positions = 12

[mechanism.input]
joint = "O"
speed = "{speed}"
start = "0 deg"

[mechanism.fixed]
O = [0, 0]

{links}{joints}
[[mechanism.outputs]]
point = "B"
direction = "0 deg"

[[loads]]
name = "Q"
link = 3
point = "B"
direction = "180 deg"
force = "2 kN"
between = ["200 deg", "350 deg"]

[transmission]
efficiency = {efficiency}
inertia = 0.4

[flywheel]
delta = 0.02
diameter = "500 mm"
width = "60 mm"
inertia = "{existing}"

{motor}
"""

MOTOR = """
[motor]
power = "1.5 kW"
speed = "1420 rpm"
synchronous_speed = "1500 rpm"
overload = 2.2
inertia = 0.004
"""


def spec_text(
    motor: str = MOTOR, speed: str = "90 rpm", existing: str = "3 kg*m^2", efficiency: float = 1.0, more: str = ""
) -> str:
    """The spec with its motor, or another one in its place."""
    return SPEC.format(**LINKAGE, motor=motor, speed=speed, existing=existing, efficiency=efficiency) + more
