"""Efficiency of one pair of wheels by the friction of its teeth."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.model import EXTERNAL, WHERE

SLIDING = 2.3  # of standard teeth of 20 degrees: pi (1 - e + e1^2 + e2^2), e1 + e2 = e the contact ratio


def mesh_efficiency(first: ArrayLike, second: ArrayLike, sign: ArrayLike = EXTERNAL, friction: float = 0.08) -> Values:
    """Efficiency 1 - 2.3 f (1/z1 -+ 1/z2) of pairs of wheels, minus for an internal pair (Kudryavtsev).

    Arrays broadcast; ``sign`` as in `Mesh`, ``friction`` f is that of the teeth, 0.05 to 0.1 in oil [-].
    Raises `UsageError` if the friction leaves no efficiency.

    >>> mesh_efficiency(20, 60).round(6).item(), mesh_efficiency(20, 60, 1).round(6).item()
    (0.987733, 0.993867)
    """
    loss = SLIDING * friction * np.abs(1 / np.asarray(first) - np.asarray(sign) / np.asarray(second))
    worst = float(np.max(loss, initial=0.0))
    if friction < 0 or not worst < 1:
        raise UsageError(
            f"friction {friction:g} of the teeth takes {worst:.4g} of the power",
            where=WHERE,
            value=friction,
            remedy="a coefficient of 0.05 to 0.1 is usual in oil",
        )
    return 1 - loss
