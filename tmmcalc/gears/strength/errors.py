"""What rounding leaves of a strength calculation: some of its trains again in extended precision.

The formulas are closed. They lose digits only where a ring has hardly more teeth than its planet, u - 1 in (4.38), so
the trains nearest to that and an even choice of the others are taken. Stresses are those of the module and the width
that were chosen: where a rounding would choose others the train is left out.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.core.numerics.extended import EPS, apart, spread, widened
from tmmcalc.core.records import record
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.strength.results import Strength
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.task import StrengthTask

CHOSEN = 12  # trains of each kind
SAME = 1e-9  # relative difference of modules of one choice


@record
class StrengthError:
    """Relative errors, each to the largest value of the trains looked at."""

    module: float  # that contact and bending ask for
    contact_stress: float
    bending_stress: float


def strength_error(sets: ToothSets, task: StrengthTask, found: Strength) -> StrengthError | None:
    """Largest relative differences of the chosen trains; None without any train."""
    if not len(sets):
        return None
    rows = _rows(sets)
    some = replace(sets, teeth=sets.teeth[rows].astype(np.longdouble), modules=sets.modules[rows])
    exact = solve_strength(some, replace(task, torque=widened(task.torque)))
    same = np.all(np.abs(exact.module - found.module[rows]) <= SAME * found.module[rows], axis=1)
    same &= np.all(np.abs(exact.width - found.width[rows]) <= SAME * found.width[rows], axis=1)
    modules = ([getattr(each, name) for name in ("contact_module", "bending_module")] for each in (found, exact))
    told, truth = next(modules), next(modules)
    return StrengthError(
        apart([part[rows] for part in told], truth),
        apart(found.contact_stress[rows][same], exact.contact_stress[same]),
        apart(found.bending_stress[rows][same], exact.bending_stress[same]) + EPS,  # decimals of Y_F and K_m
    )


def _rows(sets: ToothSets) -> np.ndarray:
    """The trains whose meshes cancel most, and an even choice."""
    even = spread(len(sets), CHOSEN)
    internal = [mesh for mesh in sets.scheme.meshes if mesh.internal]
    if not internal or len(even) == len(sets):
        return even
    ratios = np.stack([sets.of(mesh.first) / sets.of(mesh.second) for mesh in internal])
    nearest = np.abs(np.log(ratios)).min(axis=0)
    return np.array(sorted({*even.tolist(), *np.argsort(nearest, kind="stable")[:CHOSEN].tolist()}))
