"""Tables of the small calculators in SI, columns by their headers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from tmmcalc.extras.contact import Contact
    from tmmcalc.extras.falling_ball import Ball
    from tmmcalc.extras.reliability import Reliability


def contact_columns(result: Contact) -> dict[str, np.ndarray]:
    """A row a node: place, gap, pressure, opening."""
    return {
        "i": np.array(result.labels),
        "x[m]": result.x,
        "y[m]": result.y,
        "h[m]": result.gap,
        "p[Pa]": result.pressure,
        "opening[m]": result.opening,
    }


def reliability_columns(result: Reliability) -> dict[str, np.ndarray]:
    """A row a time: strength, reliability, density, intensity of failures."""
    return {
        "i": np.array(result.labels),
        "t[-]": result.t,
        "x[-]": result.x,
        "R[-]": result.kept,
        "f[-]": result.density,
        "intensity[-]": result.intensity,
    }


def ball_columns(result: Ball) -> dict[str, np.ndarray]:
    """A row a time: radius, speed, acceleration, way."""
    return {
        "i": np.array(result.labels),
        "t[s]": result.t,
        "r[m]": result.radius,
        "v[m/s]": result.v,
        "a[m/s^2]": result.a,
        "S[m]": result.way,
    }
