"""What the rules for n and l_OF give nearly, made exact: n by the angle of a stroke, l_OF by the swing of a rocker.

Both are one equation in one unknown, solved by secants from the rule; every value of it is a whole turn of the linkage.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from tmmcalc.linkage.synthesis.dwell.criteria import towards_and_away
from tmmcalc.linkage.synthesis.dwell.exact import reversals_of
from tmmcalc.linkage.synthesis.dwell.linkages import Linkages
from tmmcalc.linkage.synthesis.dwell.parameters import with_output
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.turn import patient_turn

PASSES = 12
ROUNDS = 4  # where angle and swing are asked for: each equation disturbs the other a little
MET = 1e-12  # of an angle [rad]
NUDGE = 1e-3  # second point of the secants, relative


def corrected(asked: DwellTask, linkages: Linkages, n: float, left: bool) -> tuple[Linkages, float, bool]:
    """The linkage (1,) whose working angle and swing are those asked for, its n, and whether all were met."""
    longer, met = 1.0, True

    def at(part: float, length: float) -> Linkages:
        return with_output(asked, linkages, np.array([part]), np.array([left]), length)

    def by_angle(part: float, length: float) -> float | None:
        return towards(asked, at(part, length))

    def by_swing(length: float, part: float) -> float | None:
        return swing_of(at(part, length))

    turns = 1 if asked.swing is None or asked.working_angle is None else ROUNDS
    for _ in range(turns):
        if asked.working_angle is not None and asked.pivot is None:
            found = _secant(partial(by_angle, length=longer), n, asked.working_angle)
            met, n = found is not None, n if found is None else found
        if asked.swing is not None and asked.pivot is None:
            found = _secant(partial(by_swing, part=n), longer, asked.swing)
            met, longer = met and found is not None, longer if found is None else found
    return at(n, longer), n, met


def towards(asked: DwellTask, linkages: Linkages) -> float | None:
    """Turn of the crank on the stroke towards the dwell; None if the linkage does not work."""
    turn = patient_turn(linkages)
    if not turn.which.size:
        return None
    far = max(reversals_of(turn), key=lambda peak: abs(peak[0]))[1]
    (begin, end), _ = towards_and_away(asked, np.array([far]))
    return float((end - begin)[0])


def swing_of(linkages: Linkages) -> float | None:
    """Swing of the rocker; None if the linkage does not work."""
    turn = patient_turn(linkages)
    if not turn.which.size:
        return None
    values = [value for value, _ in reversals_of(turn)]
    return max(values) - min(values)


def _secant(f: Callable[[float], float | None], x: float, wanted: float) -> float | None:
    """Where f is ``wanted``, from x on; None if the way there leads out of what works."""
    before, step = f(x), NUDGE * max(abs(x), NUDGE)
    if before is None:
        return None
    if abs(before - wanted) <= MET:
        return x
    last, x = x, x + step
    for _ in range(PASSES):
        value = f(x)
        if value is None or value == before:
            return None
        if abs(value - wanted) <= MET:
            return x
        last, x, before = x, x - (value - wanted) * (x - last) / (value - before), value
    return None
