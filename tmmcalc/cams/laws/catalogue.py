"""The laws by name: the seven of the textbook's table 5.1, and what is usual beside them.

Common factors of the powers stand in front as in the table; of the laws in two halves the second is the first turned
about the middle.
"""

from __future__ import annotations

from math import pi

import numpy as np

from tmmcalc.cams.laws.law import Acceleration, Law, of_acceleration, polynomial
from tmmcalc.core.errors import UsageError

_WHOLE = np.array([0.0, 1.0])


def _harmonic(name: str, coefficients: list[float], amplitude: float, frequency: float, phase: float) -> Law:
    one = (np.array([value]) for value in (amplitude, frequency, phase))
    return Law(name, _WHOLE, np.array([coefficients]), *one)


def _modified_trapezoid() -> Law:
    """s'' rises as a quarter sine, stays, falls as a half cosine, stays, and rises back."""
    rise = Acceleration(0.0, amplitude=1.0, frequency=4 * pi)
    fall = Acceleration(3 / 8, amplitude=1.0, frequency=4 * pi, phase=pi / 2)
    back = Acceleration(7 / 8, amplitude=-1.0, frequency=4 * pi, phase=pi / 2)
    high, low = Acceleration(1 / 8, (1.0,)), Acceleration(5 / 8, (-1.0,))
    return of_acceleration("modified_trapezoid", rise, high, fall, low, back)


def _modified_sine() -> Law:
    """s'' rises as a quarter sine, falls as a slower half cosine, and rises back."""
    rise = Acceleration(0.0, amplitude=1.0, frequency=4 * pi)
    fall = Acceleration(1 / 8, amplitude=1.0, frequency=4 * pi / 3, phase=pi / 2)
    back = Acceleration(7 / 8, amplitude=-1.0, frequency=4 * pi, phase=pi / 2)
    return of_acceleration("modified_sine", rise, fall, back)


LAWS: dict[str, Law] = {
    law.name: law
    for law in (
        _harmonic("sine", [0.0, 1.0], -1 / (2 * pi), 2 * pi, 0.0),
        _harmonic("cosine", [0.5], -0.5, pi, pi / 2),
        polynomial("linear", (0.0, [0, 0, 3, -2])),
        polynomial("parab2", (0.0, [0, 0, 0, 8, -8]), (0.5, [0.5, 2, 0, -8, 8])),
        polynomial("const", (0.0, [0, 0, 2]), (0.5, [0.5, 2, -2])),
        polynomial("shun", (0.0, [0, 0, 0, 10, -15, 6])),
        polynomial("poly5", (0.0, [0, 0, 0, 18, -55, 78, -56, 16])),
        polynomial("poly4567", (0.0, [0, 0, 0, 0, 35, -84, 70, -20])),
        _modified_trapezoid(),
        _modified_sine(),
    )
}

TITLES: dict[str, str] = {
    "sine": "cycloidal",
    "cosine": "simple harmonic",
    "linear": "acceleration on a falling straight line",
    "parab2": "acceleration of two parabolas",
    "const": "piecewise constant acceleration",
    "shun": "3-4-5 polynomial",
    "poly5": "3-4-5-6-7 polynomial, acceleration of the fifth degree",
    "poly4567": "4-5-6-7 polynomial",
    "modified_trapezoid": "modified trapezoidal acceleration",
    "modified_sine": "modified sine acceleration",
}


def law_of(name: str) -> Law:
    """The law of this name; raises `UsageError` with the known ones."""
    if name in LAWS:
        return LAWS[name]
    raise UsageError(f"no law of motion is called {name!r}", where="law", remedy=f"laws: {', '.join(LAWS)}")
