"""Places of the cycle and the extreme values there, as the stages after kinematics give them.

A place is phi, the input coordinate counted from position 0: negative along the motion of a clockwise crank. The
results hold theta, which is counted along the motion and never negative.
"""

from __future__ import annotations

import math
from typing import Protocol

from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.results import Extreme
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import angle, number

VALUE = Quantity("{name}[{unit}]", "{name} at its extreme")
PLACE = Quantity("{name}_at_phi[{step}]", "input coordinate from position 0 where {name} stands")


class Result(Protocol):
    """What a result tells of its input: coordinates of the positions, speed, whether it turns."""

    @property
    def phi(self) -> Real:
        """Input coordinate from position 0 (n,) [rad or m]."""

    @property
    def speed(self) -> float:
        """Mean speed, signed [rad/s or m/s]."""

    @property
    def turns(self) -> bool:
        """A crank, and not a driven slider."""


@record
class Shaft:
    """A turning input by its positions, for results that hold no signed speed: only its sign counts."""

    phi: Real  # (n,) [rad]
    turns: bool = True

    @property
    def speed(self) -> float:
        """1 or -1."""
        return math.copysign(1.0, self.phi[-1] - self.phi[0])


def phi_of(result: Result, theta: float) -> float:
    """The input coordinate from position 0 at theta, in the unit of its column: deg or m."""
    phi = math.copysign(theta, result.speed) if theta else 0.0
    return math.degrees(phi) if result.turns else phi


def place(result: Result, theta: float) -> str:
    """A place for people: ``phi = 210 deg``."""
    phi = phi_of(result, theta)
    if result.turns:
        return f"phi = {angle(phi)} deg"
    return f"phi = {number(phi, peak=float(abs(result.phi).max()))} m"


def extreme_values(result: Result, key: str, unit: str, extreme: Extreme) -> dict[str, float]:
    """An extreme for programs: its value and its place."""
    places = {"name": key, "unit": unit, "step": "deg" if result.turns else "m"}
    return {VALUE.of(**places).key: extreme.value, PLACE.of(**places).key: phi_of(result, extreme.x)}


def span_fact(result: Result, label: str, key: str, unit: str, pair: tuple[Extreme, Extreme]) -> Fact:
    """The least and the largest value of a quantity over the cycle, with their places."""
    peak = max(abs(extreme.value) for extreme in pair)
    values = {
        name: value
        for word, extreme in zip(("min", "max"), pair, strict=True)
        for name, value in extreme_values(result, f"{key}_{word}", unit, extreme).items()
    }
    if pair[1].value - pair[0].value <= 1e-12 * peak:
        return Fact(label, f"{number(pair[1].value)} {unit} everywhere", values)
    lines = [
        f"{word} {number(extreme.value, peak=peak)} {unit} at {place(result, extreme.x)}"
        for word, extreme in zip(("min", "max"), pair, strict=True)
    ]
    return Fact(label, "\n".join(lines), values)


def speed_text(result: Result) -> str:
    """The speed of the input for people."""
    if not result.turns:
        return f"{number(result.speed)} m/s"
    return f"{number(result.speed)} rad/s ({number(result.speed * 30 / math.pi)} rpm)"
