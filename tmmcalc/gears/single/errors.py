"""What rounding leaves of a wheel without a mate: its measures again by ISO 21771 in extended precision."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.extended import apart
from tmmcalc.gears.meshing.errors import arcs, balls_error, cut_of, span_error
from tmmcalc.gears.single.results import SingleError, SingleWheel


def single_error(found: SingleWheel) -> SingleError:
    """Largest relative difference of the measures and the same in extended precision."""
    task, m = found.task, np.longdouble(found.task.module)
    cut = cut_of([task.wheel.teeth], [task.shift], task.rack, task.helix)
    own = np.sign(cut.teeth) * (np.abs(cut.reference) + np.sign(cut.teeth) * (task.rack.addendum + cut.shift))
    tips = own if task.tip is None else np.sign(cut.teeth) * np.longdouble(task.tip) / m
    tips = np.sign(cut.teeth) * np.maximum(np.abs(tips), np.abs(cut.base))
    return SingleError(
        thickness=apart([found.thickness, found.tip_thickness], m * arcs(cut, tips)),
        span=span_error([found.measures], cut, m),
        balls=balls_error([found.measures], cut, m, task.measuring.body),
        outline=None if found.profile is None else found.profile.error,
    )
