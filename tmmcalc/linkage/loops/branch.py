"""Where a branch stands: unknowns near enough for Newton at any input coordinate that it reaches."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.results import Branch


def within(branch: Branch, x: Real) -> Real:
    """The coordinates (n,) shifted by whole periods into the branch; NaN beyond its ends.

    On a branch that does not come back they are shifted by whole turns, unless it is wider than one: its turns differ.
    """
    if branch.period is not None:
        return branch.low + np.mod(x - branch.low, branch.period)
    if branch.turn is not None and branch.high - branch.low < branch.turn:
        x = np.where(_inside(branch, x), x, branch.low + np.mod(x - branch.low, branch.turn))
    return np.where(_inside(branch, x), x, np.nan)


def _inside(branch: Branch, x: Real) -> np.ndarray:
    return (x >= branch.low) & (x <= branch.high)


def parameter(branch: Branch, x: Real) -> Real:
    """The parameter t (n,) at coordinates inside the branch."""
    part = (x - branch.low) / (branch.high - branch.low)
    low, high = limited(branch)
    if low and high:
        return np.arccos(1 - 2 * part) / np.pi
    if low:
        return np.sqrt(part)
    return 1 - np.sqrt(1 - part) if high else part


def coordinate(branch: Branch, t: Real) -> Real:
    """The coordinates x (n,) at the parameter t (n,)."""
    low, high = limited(branch)
    if low and high:
        part = np.sin(np.pi / 2 * t) ** 2
    elif low:
        part = t * t
    else:
        part = 1 - (1 - t) ** 2 if high else t
    return branch.low + (branch.high - branch.low) * part


def slope(branch: Branch, t: Real) -> Real:
    """Derivative dx/dt (n,) at the parameter t (n,); zero at a limit."""
    low, high = limited(branch)
    if low and high:
        part = np.pi / 2 * np.sin(np.pi * t)
    elif low:
        part = 2 * t
    else:
        part = 2 * (1 - t) if high else np.ones_like(t)
    return np.asarray((branch.high - branch.low) * part)


def limited(branch: Branch) -> tuple[bool, bool]:
    """Whether the branch ends in a limit position at its low and at its high end."""
    ends = {limit.x for limit in branch.limits}
    return branch.low in ends, branch.high in ends


def guess(branch: Branch, x: Real) -> Real:
    """Unknowns (N, n) at coordinates (n,): the cubic through the places of the branch beside them."""
    t = parameter(branch, np.asarray(within(branch, x), dtype=float))
    steps = branch.q.shape[1] - 1
    inside = np.isfinite(t)
    k = np.clip(np.where(inside, t * steps, 0).astype(int), 0, steps - 1)
    p = t * steps - k
    q0, q1, d0, d1 = branch.q[:, k], branch.q[:, k + 1], branch.dq[:, k] / steps, branch.dq[:, k + 1] / steps
    rise = q1 - q0
    return np.asarray(q0 + p * (d0 + p * (3 * rise - 2 * d0 - d1 + p * (d0 + d1 - 2 * rise))))
