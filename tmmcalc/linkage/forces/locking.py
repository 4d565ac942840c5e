"""What friction does to the motion as a whole: self-locking refused, further solutions told."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from tmmcalc.errors import NoSolutionError
from tmmcalc.linkage.forces.friction import Solution
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.results import Grade

SHOWN = 6  # positions named in a message

Named = Callable[[NDArray[np.intp]], list[str]]


def refuse_locked(statics: Statics, solutions: Mapping[str, Solution], named: Named) -> None:
    """Raise `NoSolutionError` where a group locks itself, with the part of its friction that it could take.

    ``named`` gives the words for row numbers.
    """
    for name, solution in solutions.items():
        if not solution.locked.any():
            continue
        rows = np.flatnonzero(solution.locked)
        limit = float(np.min(solution.limit[rows]))
        places = f"{', '.join(named(rows[:SHOWN]))}{' ...' if len(rows) > SHOWN else ''}"
        rubbing = [j.name for j in statics.joints if j.name in statics.scales and _joins(statics, name, j)]
        raise NoSolutionError(
            f"self-locking at {places}: the friction in {', '.join(rubbing)} holds the group against any drive; "
            f"it moves up to {limit:.4g} times this friction",
            where=f"forces, group {name}",
            value=1.0,
            limit=limit,
            remedy="lessen the friction coefficients, or the angle between the load and the motion there",
        )


def _joins(statics: Statics, group_name: str, joint: Joint) -> bool:
    chain = statics.scene.chain
    for group in chain.structure.groups:
        if group.name == group_name:
            return joint.name in (*group.inner, *group.outer)
    return joint.name == chain.input_joint.name


def further_solutions(solutions: Mapping[str, Solution], labels: tuple[str, ...]) -> tuple[Grade, ...]:
    """Warnings where the equations of friction have more than one solution."""
    grades = []
    for name, solution in solutions.items():
        rows = np.flatnonzero(solution.ambiguous)
        if rows.size:
            named = ", ".join(labels[i] for i in rows[:SHOWN]) + (" ..." if len(rows) > SHOWN else "")
            text = f"the friction has a further solution at {named}; the one that grows out of no friction is taken"
            grades.append(Grade("warning", f"group {name}", text))
    return tuple(grades)
