"""Directions of the losses of a train: which wheel of each mesh drives in its carrier's frame.

They follow from the torques, which depend on them. The search begins with those of the train without losses and
corrects them until they agree with the torques that they lead to; if that fails all combinations are tried, nearest
first. Of several that agree the one that grows out of no losses is so preferred. If none agrees the train locks itself.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.equilibrium import Statics, lossy_matrix
from tmmcalc.gears.network.model import WHERE

ZERO = 1e-13  # a torque below this part of the largest is rounding
EXHAUSTIVE = 12  # meshes with losses up to which all directions are tried
HALVINGS = 20  # in search of the losses that lock


def agreeing_directions(statics: Statics) -> tuple[Values, Values]:
    """Directions (a,) and unknown torques (n,) in agreement; raises `NoSolutionError` if there are none."""
    found = _search(statics, 1.0)
    if found is None:
        raise _locked(statics)
    return found


def _search(statics: Statics, part: float) -> tuple[Values, Values] | None:
    """Directions that agree for a part of the losses: by correction from none, then among all, nearest first."""
    start = _driving(statics, _solved(statics, np.zeros(len(statics.active)), part))
    directions = start
    for _ in range(len(statics.active) + 1):
        x = _solved(statics, directions, part)
        if _agree(statics, directions, x):
            return directions, x
        directions = _driving(statics, x)
    return _among_all(statics, np.where(start == 0, 1.0, start), part)


def _among_all(statics: Statics, start: Values, part: float) -> tuple[Values, Values] | None:
    a = min(len(start), EXHAUSTIVE)
    flips = [list(chosen) for k in range(a + 1) for chosen in combinations(range(a), k)]
    directions = np.tile(start, (len(flips), 1))
    for row, chosen in zip(directions, flips, strict=True):
        row[chosen] *= -1
    x = _solved(statics, directions, part)
    good = np.flatnonzero(_agree(statics, directions, x))
    return (directions[good[0]], x[good[0]]) if good.size else None


def _driving(statics: Statics, x: Values) -> Values:
    """Directions (..., a) that torques lead to; 0 where a mesh carries none."""
    return -np.sign(x[..., statics.active] * statics.motion.rolling[statics.active, 0])


def _solved(statics: Statics, directions: Values, part: float = 1.0) -> Values:
    """Unknown torques (..., n) for directions (..., a); zeros where the losses leave no equilibrium."""
    matrix = lossy_matrix(statics, directions, part)
    right = np.broadcast_to(-statics.load[:, None], (*matrix.shape[:-1], 1))
    try:
        x = np.linalg.solve(matrix, right)[..., 0]
        return np.where(np.abs(x) > ZERO * np.max(np.abs(x), axis=-1, keepdims=True), x, 0.0)
    except np.linalg.LinAlgError:
        if matrix.ndim > 2:
            return np.array([_solved(statics, row, part) for row in directions])
        return np.zeros(len(matrix))


def _agree(statics: Statics, directions: Values, x: Values) -> NDArray[np.bool_]:
    """Whether (...) torques lead to the directions that they were found with."""
    found = _driving(statics, x)
    carried = np.any(x != 0, axis=-1) | (not statics.load.any())
    return np.all((found == directions) | (found == 0), axis=-1) & carried


def _locked(statics: Statics) -> NoSolutionError:
    """The error of a train that locks itself, with the part of the losses up to which it turns."""
    low, high = 0.0, 1.0
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if _search(statics, middle) is None else (middle, high)
    lossy = [str(statics.network.meshes[j]) for j in statics.active]
    loads = [f"{n} = {t:g}" for n, t in zip(statics.network.members, statics.load, strict=True) if t]
    return NoSolutionError(
        Phrase(
            "self-locking: with torques {loads} N*m the losses of meshes {lossy} hold the train against any "
            "drive; it turns up to {low:.4g} times these losses",
            loads=loads,
            lossy=lossy,
            low=low,
        ),
        where=WHERE,
        value=1.0,
        limit=low,
        remedy="raise the efficiencies of the meshes, drive at another member, or take another type of train",
    )
