"""The assemblies of a group at one input coordinate, and which of them the mechanism takes.

A dyad has two at most, told apart by a sign; a group of class III or higher, or one with the drive inside it, has all
the assemblies of its loops, which are numbered. One is meant by its sign or number, or it is the one that the sketched
points of the group are nearest to.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.plane import Real
from tmmcalc.linkage import solvers
from tmmcalc.linkage.assembly import coordinate
from tmmcalc.linkage.chain import Chain, step_of
from tmmcalc.linkage.dyads import ONE_ASSEMBLY
from tmmcalc.linkage.dyads.base import Motions
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.structure import Group

TIED = 1e-6  # relative difference of distances that does not tell two assemblies apart


class AssembledGroup(NamedTuple):
    """A group on one of its assemblies at one input coordinate."""

    variant: int  # what assembly.variants takes for it: the sign of a dyad, the number of a higher group
    motions: Motions  # of all links up to the group
    points: dict[str, complex]  # places of the named points of its links but its outer pins [m]
    gap: float  # root mean square distance of these points from the sketch [m]; inf if none of them is sketched
    regularity: float  # 1 the best, 0 singular
    determinant: float | None = None  # of a higher group's equations with unit columns: its sign stays along a branch
    unknowns: Real | None = None  # (N,) of a higher group's loops


def own_points(mechanism: Mechanism, group: Group) -> dict[str, tuple[int, complex]]:
    """Named points of the links of a group, with link and place on it, but for outer pins, which others place."""
    outer = [mechanism.joint(name) for name in group.outer]
    pins = {pin for joint in outer if joint.kind == "revolute" for pin in zip(joint.links, joint.points, strict=True)}
    points = ((name, k, p) for k in group.links for name, p in mechanism.link(k).points.items())
    return {name: (k, p) for name, k, p in points if (k, p) not in pins}


def assemblies_of(mechanism: Mechanism, group: Group, motions: Motions, x: Real) -> list[AssembledGroup]:
    """All assemblies of a group at the one input coordinate x (1,), from the motions of the groups before it there."""
    return _of_dyad(mechanism, group, motions, x) if group.kind else _of_higher(mechanism, group, motions, x)


def _of_dyad(mechanism: Mechanism, group: Group, motions: Motions, x: Real) -> list[AssembledGroup]:
    """The variants of a dyad if it reaches."""
    found = []
    for sign in (1,) if group.kind in ONE_ASSEMBLY else (1, -1):
        step, moved = step_of(mechanism, group, sign), dict(motions)
        with np.errstate(divide="ignore", invalid="ignore"):
            _, placed = step.advance(moved, {}, x, 0, solvers.closed)
        if all(np.isfinite(moved[k].r).all() and np.isfinite(moved[k].u).all() for k in group.links):
            regularity = float(np.ravel(step.regularity(placed))[0])
            found.append(AssembledGroup(sign, moved, *_seen(mechanism, group, moved), regularity))
    return found


def _of_higher(mechanism: Mechanism, group: Group, motions: Motions, x: Real) -> list[AssembledGroup]:
    """The assemblies of a group of class III or higher, or with the drive inside it."""
    from tmmcalc.linkage.loops.assemblies import assemblies
    from tmmcalc.linkage.loops.closure import Loops
    from tmmcalc.linkage.loops.equations import equations_of

    equations = equations_of(mechanism, group)
    loops = Loops(equations, motions, equations.given(motions), x)
    found = []
    for number, q in enumerate(assemblies(loops).T, 1):
        closed, moved, still = loops.place(q[:, None]), dict(motions), np.zeros((len(q), 1))
        loops.move(closed, still, still, moved, {})
        sizes = float(closed.regularity[0]), float(closed.determinant[0])
        found.append(AssembledGroup(number, moved, *_seen(mechanism, group, moved), *sizes, q))
    return found


def _seen(mechanism: Mechanism, group: Group, motions: Motions) -> tuple[dict[str, complex], float]:
    """The places of the points of a group, and their distance from the sketch."""
    own, sketch = own_points(mechanism, group), mechanism.assembly.sketch
    points = {name: complex(np.ravel(motions[k].point(p).r)[0]) for name, (k, p) in own.items()}
    gaps = [abs(points[name] - sketch[name]) for name in points if name in sketch]
    return points, float(np.sqrt(np.mean(np.square(gaps)))) if gaps else float("inf")


def chosen(
    chain: Chain, group: Group, assemblies: list[AssembledGroup], at: float, variant: int | None
) -> AssembledGroup:
    """The assembly that the spec means: of its variant, nearest to the sketch, the only one; of a dyad else the first.

    ``chain`` holds the groups before. Raises `UsageError` or `NoSolutionError` where none is meant, or not one alone.
    """
    where = f"kinematics, group {group.name}"
    if not assemblies:
        dyad = f" variant of {group.name}" if group.kind else ""
        raise NoSolutionError(
            f"no assembly{dyad} exists at {coordinate(chain, at)}",
            where=where,
            remedy="give assembly.at, another input coordinate, or check the lengths",
        )
    if variant is not None:
        return _numbered(chain, group, assemblies, at, variant)
    by_gap = sorted(assemblies, key=lambda assembly: assembly.gap)
    if np.isfinite(by_gap[0].gap):
        return _nearest(group, by_gap)
    if group.kind or len(assemblies) == 1:
        return assemblies[0]
    raise NoSolutionError(
        f"the group has {len(assemblies)} assemblies at {coordinate(chain, at)}, and nothing tells which one is meant",
        where=where,
        remedy="sketch its points in assembly.sketch, or give the number of the assembly in assembly.variants; "
        "tmmcalc structure --assemblies lists them",
    )


def _numbered(chain: Chain, group: Group, assemblies: list[AssembledGroup], at: float, variant: int) -> AssembledGroup:
    """The assembly of this variant."""
    found = next((assembly for assembly in assemblies if assembly.variant == variant), None)
    if found is None:
        raise UsageError(
            f"there is no assembly {variant}: at {coordinate(chain, at)} the group has {len(assemblies)}",
            where=f"mechanism.assembly.variants, {group.name}",
            remedy="tmmcalc structure --assemblies lists them",
        )
    return found


def _nearest(group: Group, by_gap: list[AssembledGroup]) -> AssembledGroup:
    """The first of the assemblies, which ascend by their distance from the sketch, unless the second is as near."""
    first, *others = by_gap
    if not others or not tied(first.gap, others[0].gap):
        return first
    if group.kind == "RPR":  # without an offset both variants look the same
        return max(by_gap, key=lambda assembly: assembly.variant)
    both = f"both variants of {group.name}" if group.kind else f"the assemblies {first.variant} and {others[0].variant}"
    raise NoSolutionError(
        f"the sketch stands equally near to {both}",
        where=f"kinematics, group {group.name}",
        remedy="sketch more of its points, off the line of the pivots, or give assembly.variants",
    )


def tied(nearest: float, next_one: float) -> bool:
    """Whether two distances of a sketch [m] do not tell two assemblies apart."""
    return next_one <= nearest * (1 + TIED) + 1e-15
