"""Small displacements drawn larger than they are: by how much, and what is told of it."""

from __future__ import annotations

import math

from tmmcalc.core.notes import Phrase

SHARE = 0.15  # of the size of the scene: as far the largest displacement goes at most


def factor_of(size: float, largest: float) -> float:
    """A round number, 1, 2 or 5 by a power of ten, at least 1.

    >>> factor_of(1.0, 0.01), factor_of(0.2, 1e-5), factor_of(1.0, 0.4)
    (10.0, 2000.0, 1.0)
    """
    if not largest:
        return 1.0
    most = SHARE * size / largest
    power = 10.0 ** math.floor(math.log10(most))
    return max(1.0, *(each * power for each in (1.0, 2.0, 5.0) if each * power <= most))


def told(factor: float) -> str:
    """What stands under the title of the scene."""
    return Phrase("displacements are enlarged, {factor:.7g} : 1", factor=factor) if factor > 1 else ""
