"""The two edges of a slider, where the parallel forces act that its normal force and couple stand for (fig. 3.1b)."""

from __future__ import annotations

from tmmcalc.core.plane import Real


def edge_reactions(normal: Real, couple: Real, length: float) -> tuple[Real, Real]:
    """Forces N', N'' [N] at the edges of a slider of this length, ahead of and behind its point, along the normal.

    N' + N'' = N, (N' - N'') length/2 = couple. They point the same way unless the resultant leaves the slider.

    >>> edge_reactions(10.0, 1.0, 0.5)
    (7.0, 3.0)
    """
    return normal / 2 + couple / length, normal / 2 - couple / length
