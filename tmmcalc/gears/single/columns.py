"""The table of a wheel without a mate: the points of its profile."""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.meshing.profiles import Profiles
from tmmcalc.gears.meshing.tooth import profile_columns
from tmmcalc.gears.single.results import SingleWheel


def wheel_columns(found: SingleWheel) -> dict[str, np.ndarray]:
    """Columns by their headers."""
    return profile_columns(Profiles(() if found.profile is None else (found.profile,), ()))
