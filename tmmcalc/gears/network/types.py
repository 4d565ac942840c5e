"""Simple planetary types by closed formulas: ratio, efficiency, self-locking, and which type suits a required ratio.

Wheel 1 and the carrier H move, wheel 3 is fixed. i_1H = w1/wH = 1 - i_13^H (4.19), where i_13^H = -+U is the ratio of
the inverted train, carrier stopped: minus for AI and AI-bar, plus for AA and II. eta0 is the efficiency of the inverted
train; losses of bearings are left out. Wheel 1 drives where ``driver`` is "1", the carrier where it is "H".
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import Values
from tmmcalc.gears.scheme import layout_of

Driver = Literal["1", "H"]
Numbers = Values | float

WHERE = "planetary type"


def inverted_ratio(i_1h: Numbers) -> Values:
    """Ratio i_13^H of the inverted train (4.19); its own inverse.

    >>> inverted_ratio(7.25).item()
    -6.25
    """
    return 1 - np.asarray(i_1h, dtype=float)


def tooth_ratio(layout: str, i_1h: Numbers) -> Values:
    """Tooth ratio U of a type for i_1H; zero or negative where the type does not give it.

    >>> tooth_ratio("AI", 31.0).item()
    30.0
    """
    return _sign(layout) * (np.asarray(i_1h, dtype=float) - 1)


def _sign(layout: str) -> int:
    scheme = layout_of(layout)
    if scheme.sign:
        return scheme.sign
    raise UsageError(
        f"the ratio of {scheme.title} is not 1 + U or 1 - U",
        where=WHERE,
        remedy=f"types of this form: {', '.join(key for key, layout in LAYOUTS.items() if layout.sign)}",
    )


def efficiency(i_1h: Numbers, eta0: Numbers, driver: Driver = "1") -> Values:
    """Efficiency of a planetary train of ratio i_1H (textbook, table 4.6); zero or negative: self-locking.

    Arrays broadcast. Raises `NoSolutionError` at i_1H = 0 (wheel 1 stands), `UsageError` unless 0 < eta0 <= 1.

    >>> efficiency(np.array([7.29, -7.15, 0.05]), 0.9).round(4).tolist()
    [0.9137, 0.886, -1.1111]
    """
    i, eta = _checked(i_1h, eta0, driver)
    loss = 1 - eta
    slow = (i > 0) & (i < 1)
    if driver == "1":
        return np.where(slow, (i - loss) / (eta * i), eta + loss / i)
    with np.errstate(divide="ignore", invalid="ignore"):  # of the branch that is not taken
        return np.where(slow, i / (loss + eta * i), eta * i / (i - loss))


def self_locking(i_1h: Numbers, eta0: Numbers, driver: Driver = "1") -> np.ndarray:
    """Whether the train locks itself: only under wheel 1, for -(1 - eta0)/eta0 <= i_1H <= 1 - eta0.

    Raises as `efficiency` does.

    >>> self_locking(np.array([0.05, 0.5]), 0.9).tolist()
    [True, False]
    """
    i, eta = _checked(i_1h, eta0, driver)
    return (driver == "1") & (eta * (1 - i) <= 1) & (i + eta <= 1)


def _checked(i_1h: Numbers, eta0: Numbers, driver: str) -> tuple[Values, Values]:
    i, eta = np.broadcast_arrays(np.multiply(i_1h, 1.0), np.multiply(eta0, 1.0))
    if driver not in ("1", "H"):
        raise UsageError(f"the driver is {driver!r}", where=WHERE, remedy='wheel "1" or carrier "H"')
    if not np.all((eta > 0) & (eta <= 1)):
        worst = float(eta[~((eta > 0) & (eta <= 1))][0])
        raise UsageError(
            f"the efficiency of the inverted train is {worst:g}",
            where=WHERE,
            value=worst,
            limit=1.0,
            remedy="above 0 and at most 1",
        )
    if not np.all(np.isfinite(i) & (i != 0)):
        raise NoSolutionError(
            f"i_1H is {float(i[~(np.isfinite(i) & (i != 0))][0]):g}: one of wheel 1 and the carrier stands",
            where=WHERE,
            remedy="take a ratio other than 0, and finite",
        )
    return i, eta
