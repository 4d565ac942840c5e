"""Face widths: the width coefficient that a standard module leaves, and its rounding to whole millimetres (4.42)."""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.model import Values
from tmmcalc.gears.strength.task import Rounding

PER_MM = 1000  # millimetres in a metre
SLACK = 1e-9  # relative: a width that is a whole number of millimetres stays


def adapted(psi: Values | float, required: Values, module: Values) -> Values:
    """Coefficient psi* with which ``module`` is as strong as ``required`` is with ``psi``. Textbook (4.42)."""
    return psi * (required / module) ** 3


def face_width(psi: Values | float, module: Values, teeth: Values, rounding: Rounding = "ceil") -> Values:
    """Face width b = psi m Z [m] in whole millimetres; arrays of one shape.

    "ceil" rounds up; "floor1", as the textbook's program, adds a whole millimetre to a whole number too.

    >>> float(face_width(0.6, np.array(2e-3), np.array(20.0))), float(face_width(0.6, 2e-3, 20.0, "floor1"))
    (0.024, 0.025)
    """
    width = psi * module * teeth * PER_MM
    whole = np.ceil(width * (1 - SLACK)) if rounding == "ceil" else np.floor(width * (1 + SLACK)) + 1
    return whole / PER_MM
