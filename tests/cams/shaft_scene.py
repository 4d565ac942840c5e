"""A cam on the shaft of a torque diagram with a motor, and the same machine by hand."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from tmmcalc.pipeline.runner import run
from tmmcalc.project import parse_spec

TURN = 2 * math.pi
RISE, HIGH, BACK = math.radians(80), math.radians(20), math.radians(90)
BEGIN = math.radians(230)
STROKE, START, ROLLER, TOP = 0.024, 0.04, 0.01, 0.19
MASS, FORCE, WEIGHT, FRICTION = 1.2, -120.0, -1.2 * 9.81, 0.1
STIFFNESS, PRELOAD = 30e3, 300.0
SPEED, INERTIA = 100.0, 0.05

TEXT = """
[torque]
speed = "100 rad/s"
formula = "20*sin(theta) - 5"
inertia = "0.05 kg*m^2"
{torque}
[motor]
power = "1 kW"
speed = "100 rad/s"
characteristic = "table"
table = {{ speed = ["20 rad/s", "120 rad/s"], moment = ["50 N*m", 0] }}
[transmission]
ratio = {gears}
[cam]
{cam}
follower = "translating"
stroke = "24 mm"
rise = "80 deg"
high_dwell = "20 deg"
return_angle = "90 deg"
law = "{law}"
crank_angle = "{phase} deg"
start_distance = "40 mm"
roller_radius = "10 mm"
[cam.loads]
{loads}
[cam.guide]
top = "190 mm"
"""
LOADS = 'mass = "1.2 kg"\nforce = "-120 N"\ngravity = "-9.81 m/s^2"\nfriction = 0.1\n[cam.spring]\n'
GIVEN = 'stiffness = "30 N/mm"\npreload = "300 N"'


def spec_of(
    cam: str = 'shaft = "crank"',
    torque: str = "",
    loads: str = LOADS + GIVEN,
    law: str = "shun",
    gears: float = 1,
    phase: float = 230,
) -> Any:
    return parse_spec(TEXT.format(cam=cam, torque=torque, loads=loads, law=law, gears=gears, phase=phase))


def results(spec: Any, target: str) -> dict[str, Any]:
    return dict(run(spec, target=target).results)


class Lifted(NamedTuple):
    """y, y', y'' of the follower, and the sense of its motion."""

    y: float
    slope: float
    second: float
    sense: int


def lifted(phi: float) -> Lifted:
    """The 3-4-5 polynomial on rise and return, by its own formula."""

    def law(k: float) -> tuple[float, float, float]:
        return (
            STROKE * k**3 * (10 - 15 * k + 6 * k * k),
            STROKE * 30 * k**2 * (1 - k) ** 2,
            STROKE * 60 * k * (1 - 3 * k + 2 * k * k),
        )

    phi %= TURN
    if phi < RISE:
        y, slope, second = law(phi / RISE)
        return Lifted(y, slope / RISE, second / RISE**2, 1)
    if phi < RISE + HIGH:
        return Lifted(STROKE, 0.0, 0.0, 1)
    if phi < RISE + HIGH + BACK:
        y, slope, second = law((RISE + HIGH + BACK - phi) / BACK)
        return Lifted(y, -slope / BACK, second / BACK**2, -1)
    return Lifted(0.0, 0.0, 0.0, -1)


def moment(theta: float, ratio: float) -> float:
    """What diagram and cam give the shaft [N*m] beside inertia, by the equilibrium of the stem in its guide."""
    now = lifted(ratio * (theta - BEGIN))
    static = (FORCE if now.sense > 0 else 0.0) + WEIGHT - PRELOAD - STIFFNESS * now.y
    load = static - MASS * (SPEED * ratio) ** 2 * now.second
    angle = math.atan2(now.slope, START + now.y)
    length = TOP - (START + STROKE + ROLLER)
    mu = FRICTION * abs(math.sin(angle)) * (1 + 2 * (STROKE + ROLLER - now.y) / length)
    push = -load / (math.cos(angle) - math.copysign(now.sense, -load * now.sense) * mu)
    rubbed = mu * abs(push * now.slope)
    return 20 * math.sin(theta) - 5 + (static * now.slope - rubbed) * ratio


def inertia(theta: float, ratio: float) -> float:
    """Of the shaft and the follower [kg*m^2]."""
    return INERTIA + MASS * (lifted(ratio * (theta - BEGIN)).slope * ratio) ** 2


def breaks(ratio: float, period: float) -> list[float]:
    """Angles of the shaft between which all is smooth, but where the force on the cam changes its sign."""
    ends = (0.0, RISE, RISE + HIGH, RISE + HIGH + BACK)
    places = {(BEGIN + (end + TURN * k) / ratio) % period for end in ends for k in range(8)}
    return sorted({0.0, period, *places})
