"""The counterweight on the crank for which the largest shaking force left is least.

In the crank frame the shaking force runs through a closed hodograph and the counterweight's force stands still, so that
what remains is the distance of the hodograph from a fixed point. It is least at the worst position where that point is
the centre of the smallest circle around the hodograph.
"""

from __future__ import annotations

from tmmcalc.machine.balance.circle import enclosing_circle
from tmmcalc.machine.balance.schemes import Balance, RotatingWeight, per_moment, with_weights
from tmmcalc.machine.balance.shaking import MARGIN, Shaking


def minimax_counterweight(shaking: Shaking) -> Balance:
    """One counterweight on the crank, for the least possible maximum of the force left.

    ``gap`` of the result bounds how far its maximum can be above the least. Raises `AccuracyError` if that bound
    does not close.
    """
    scale = shaking.scale or 1.0
    # the contacts are peaks of the force: no margin for angles that were not looked at
    circle = enclosing_circle(shaking.series.turned(-1), shaking.error / MARGIN * scale)
    factor = per_moment(1, shaking.speed, shaking.acceleration)
    weight = RotatingWeight(1, -circle.center / factor, shaking.pivot)
    gap = circle.gap / circle.radius if circle.radius else 0.0
    return with_weights(shaking, [weight], "minimax", gap, circle.error / scale)
