"""How finely the rod is divided: elements that close in on its layers, and a degree that no longer changes the answer.

A soft rod under its weight hangs as a chain but for thin layers at its ends, where bending counts: at the joint over
sqrt(E I/N), at the lower end over the length on which the tension grows enough.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.extended import MARGIN
from tmmcalc.vibration.pendulum.basis import Basis, graded
from tmmcalc.vibration.pendulum.task import PendulumTask
from tmmcalc.vibration.pendulum.whirl import Plane, plane_of

LAYERED = 0.05  # part of the length: thinner layers get elements of their own
WEAK, STRONG = 1e-3, 1e-7  # thinnest that are followed: of an end without a moment, and of one that has it
DEGREES = (11, 16, 21, 26, 31, 36, 41, 46)  # that are tried on one element
FEWER = (6, 8, 10, 12, 14, 16, 20, 24)  # on several
AGREED = 1e-11  # of a frequency: two degrees that agree so well are fine enough
ALLOWED = 1e-6  # a larger change of the last degree is a failure
MOST = 220  # functions


def resolved(task: PendulumTask, number: int) -> tuple[Plane, float]:
    """The plane of this number in a basis in which its frequencies no longer change, and the change that is left.

    It is the last change (relative), less by the factor by which that one was less than the change before, with a
    margin. A mesh that the task gives is taken as it is, its error by halving the elements. Raises `AccuracyError`.
    """
    tilts = task.pivot is not None
    if task.mesh.elements is not None:
        many, degree = task.mesh.elements, task.mesh.degree
        given, halved = (plane_of(task, number, _even(n, degree, tilts)) for n in (many, 2 * many))
        taken = 1 - 0.25 ** (task.mesh.degree - 1)  # of an error of that order by halves
        return given, _change(halved, given) / taken
    edges = graded(*_layers(task, number))
    nodal = len(edges) > 2
    first, *others = FEWER if nodal else DEGREES
    found, change, left = plane_of(task, number, Basis(edges, first, tilts, nodal)), np.inf, np.inf
    for degree in others:
        finer = Basis(edges, degree, tilts, nodal)
        if finer.count > MOST:
            break
        better = plane_of(task, number, finer)
        before, change = change, _change(better, found)
        found, left = better, MARGIN * change * min(1.0, change / before)
        if change < AGREED:
            return found, left
    if change > ALLOWED:
        raise AccuracyError(
            f"{found.basis.count} functions leave an error of {change:.2g} in the natural frequencies"
            if np.isfinite(change)
            else f"the number of natural frequencies does not settle with {found.basis.count} functions",
            where="pendulum",
            value=float(change),
            limit=ALLOWED,
            remedy="ask for fewer modes, or for a rod that is less soft",
        )
    return found, left


def _even(many: int, degree: int, tilts: bool) -> Basis:
    return Basis(tuple(np.linspace(0.0, 1.0, many + 1).tolist()), degree, tilts)


def _change(better: Plane, found: Plane) -> float:
    finer, coarser = better.frequencies, found.frequencies
    if coarser.shape != finer.shape:
        return np.inf
    return float(np.max(np.abs(coarser / finer - 1)))


def _layers(task: PendulumTask, plane: int) -> tuple[float, float]:
    """Thickness of the layers at the joint and at the lower end, parts of the length; 1 where there is none."""
    rod, g = task.rod, task.gravity
    if g == 0:
        return 1.0, 1.0
    bending = rod.bending[plane]
    top = sqrt(bending / (g * (rod.density * rod.length + task.disc.mass))) / rod.length
    tension = g * task.disc.mass + (rod.density * g) ** (2 / 3) * bending ** (1 / 3)
    bottom = sqrt(bending / tension) / rod.length
    turned = task.disc.diametral[plane] > 0 or task.disc.polar > 0
    return _followed(top, task.pivot == 0), _followed(bottom, not turned)


def _followed(thickness: float, weak: bool) -> float:
    return max(thickness, WEAK if weak else STRONG) if thickness < LAYERED else 1.0
