"""Tables of the small calculators in SI, columns by their headers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.quantity import headed

if TYPE_CHECKING:
    from tmmcalc.extras.contact import Contact
    from tmmcalc.extras.falling_ball import Ball
    from tmmcalc.extras.liner import Liner
    from tmmcalc.extras.reliability import Reliability
    from tmmcalc.extras.tie_down import TieDown


def contact_columns(result: Contact) -> dict[str, np.ndarray]:
    """A row a node: place, gap, pressure, opening."""
    return _numbered(result, "x", "y", "gap", "pressure", "opening")


def reliability_columns(result: Reliability) -> dict[str, np.ndarray]:
    """A row a time: strength, reliability, density, intensity of failures."""
    return _numbered(result, "t", "x", "kept", "density", "intensity")


def ball_columns(result: Ball) -> dict[str, np.ndarray]:
    """A row a time: radius, speed, acceleration, way."""
    return _numbered(result, "t", "radius", "v", "a", "way")


def tie_down_columns(result: TieDown) -> dict[str, np.ndarray]:
    """A row a value of k: forces of a stretched tie by (3) and by equilibrium, of an opposite one."""
    return _numbered(result, "k", "forces", "balance", "slackening")


def liner_columns(result: Liner) -> dict[str, np.ndarray]:
    """A row a place along the bore: deflection, slope, moment, force, stresses."""
    return _numbered(result, "x", "w", "slope", "bend", "shear", "axial", "hoop", "inner", "outer")


def _numbered(result: Any, *names: str) -> dict[str, np.ndarray]:
    return {"i": np.array(result.labels), **headed(result, *names)}
