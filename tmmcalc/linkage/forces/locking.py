"""What friction does to the motion as a whole: self-locking refused, further solutions told."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.forces.friction import Solution
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.results import Grade

SHOWN = 6  # positions named in a message
CLOSE = 1e-3  # part of the friction: nearer to the brink than this it is told by the distance
BLIND = 1e-8  # and nearer than this the brink and the friction cannot be told apart
MAGNIFIED = 100.0  # growth of errors of the loads from which on the friction is near to locking

Named = Callable[[NDArray[np.intp]], list[str]]
Seen = tuple[Real, Mapping[str, Solution]]  # angles (n,) and how friction came out there


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
            + _brink(limit),
            where=f"forces, group {name}",
            value=1.0,
            limit=limit,
            remedy="lessen the friction coefficients, or the angle between the load and the motion there",
        )


def _brink(limit: float) -> str:
    """Up to which part of its friction the group moves, in words that tell it from the whole."""
    if 1 - limit > CLOSE:
        return f"it moves up to {limit:.4g} times this friction"
    if 1 - limit > BLIND:
        return f"it moves up to 1 - {1 - limit:.2g} times this friction"
    return f"the brink lies within {BLIND:g} of this friction, too near to be told from it"


def _joins(statics: Statics, group_name: str, joint: Joint) -> bool:
    chain = statics.scene.chain
    for group in chain.structure.groups:
        if group.name == group_name:
            return joint.name in (*group.inner, *group.outer)
    return joint.name == chain.input_joint.name


def magnified(seen: Sequence[Seen], named: Callable[[Real], list[str]]) -> tuple[Grade, ...]:
    """Warnings where friction is so near to locking a group that it magnifies errors; ``named`` words angles."""
    worst: dict[str, tuple[float, float]] = {}
    for theta, solutions in seen:
        for name, solution in solutions.items():
            k = int(np.argmax(solution.amplification))
            worst[name] = max(worst.get(name, (0.0, 0.0)), (float(solution.amplification[k]), float(theta[k])))
    return tuple(
        Grade(
            "warning",
            Phrase("group {name}", name=name),
            Phrase(
                "near to self-locking at {named}: errors of the loads and of the friction coefficients grow "
                "{factor:.2g}-fold in the reactions",
                named=named(np.array([at]))[0],
                factor=factor,
            ),
            factor,
            MAGNIFIED,
            name="amplification",
        )
        for name, (factor, at) in worst.items()
        if factor > MAGNIFIED
    )


def further_solutions(
    seen: Sequence[Seen], labels: tuple[str, ...], named: Callable[[Real], list[str]]
) -> tuple[Grade, ...]:
    """Warnings where the equations of friction have more than one solution: at positions, seen first, and between."""
    grades = []
    for name, solution in seen[0][1].items():
        rows = np.flatnonzero(solution.ambiguous)
        places = (
            [", ".join(labels[i] for i in rows[:SHOWN]) + (" ..." if len(rows) > SHOWN else "")] if rows.size else []
        )
        places += [listed(named(np.array(run)), " to ") for run in _runs(seen[1:], name)[:SHOWN]]
        if places:
            text = Phrase(
                "the friction has a further solution at {places}; the one that grows out of no friction is taken",
                places=listed(places, "; "),
            )
            grades.append(Grade("warning", Phrase("group {name}", name=name), text))
    return tuple(grades)


def _runs(seen: Sequence[Seen], name: str) -> list[tuple[float, ...]]:
    """First and last angle of every row of neighbouring angles with a further solution; one angle if they are one."""
    theta = np.concatenate([at for at, _ in seen]) if seen else np.empty(0)
    flags = [solutions[name].ambiguous for _, solutions in seen]
    if not theta.size:
        return []
    order = np.argsort(theta)
    theta, told = theta[order], np.concatenate(([False], np.concatenate(flags)[order], [False]))
    begins, ends = np.flatnonzero(told[1:] & ~told[:-1]), np.flatnonzero(told[:-1] & ~told[1:]) - 1
    pairs = zip(theta[begins].tolist(), theta[ends].tolist(), strict=True)
    return [(a,) if a == b else (a, b) for a, b in pairs]
