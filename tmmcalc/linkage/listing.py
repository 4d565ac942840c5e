"""All assemblies of every group at one input coordinate, and which of them the mechanism takes there."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage import solvers
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.kinematics import placed
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.mounts import Motions
from tmmcalc.linkage.placing import chosen_at, own_points, tied
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.steps import build
from tmmcalc.linkage.structure import Group, Structure, solve_structure
from tmmcalc.linkage.variants import ONE_ASSEMBLY, given_variants
from tmmcalc.records import record


@record
class GroupAssembly:
    """One assembly of a group."""

    group: str
    variant: int  # what assembly.variants takes for it: the sign of a dyad, the number of a higher group
    taken: bool
    regularity: float  # 1 the best, 0 singular
    determinant: float | None  # of a higher group's equations with unit columns: its sign stays along a branch
    points: dict[str, complex]  # places of the named points of its links but its outer pins [m]


@record
class Listing:
    """All assemblies of the groups at the input coordinate ``x`` [rad or m], group by group."""

    x: float
    turns: bool
    assemblies: tuple[GroupAssembly, ...]
    undecided: str  # the group of which nothing tells the assembly; those after it are not listed


class _Placed(NamedTuple):
    """A group on one assembly, with the motions of all links up to it, and its distance from the sketch."""

    told: GroupAssembly
    motions: Motions
    gap: float  # inf without a sketched point


def list_assemblies(mechanism: Mechanism, structure: Structure | None = None) -> Listing:
    """Every assembly of every group at assembly.at, input.start, the sketched angle of the crank, or position 0.

    A group sees those before it on the assembly that the spec takes. Where nothing tells which one is meant, the list
    ends with that group. Raises `NoSolutionError` if nothing gives the input coordinate.
    """
    structure = structure or solve_structure(mechanism)
    at = chosen_at(mechanism)
    chain, x = Chain(mechanism, structure, ()), np.array([placed(mechanism, structure)[2] if at is None else at])
    given, found = given_variants(mechanism, structure), list[GroupAssembly]()
    motions, undecided = chain.evaluate(x, order=0).motions, ""
    for group in structure.groups:
        ways = _dyads(mechanism, group, motions, x) if group.kind else _higher(mechanism, group, motions, x)
        taken = _taken(ways, given.get(group.name), bool(group.kind))
        found += [replace(one.told, taken=one is taken) for one in ways]
        if taken is None:
            undecided = group.name
            break
        motions = taken.motions
    return Listing(float(x[0]), chain.turns, tuple(found), undecided)


def _taken(ways: list[_Placed], given: int | None, dyad: bool) -> _Placed | None:
    """The assembly that the spec means: numbered, nearest to the sketch, the only one; of a dyad else the first.

    None where the sketch stands equally near to two.
    """
    if given is not None:
        return next((one for one in ways if one.told.variant == given), None)
    by_gap = sorted(ways, key=lambda one: one.gap)
    if not by_gap:
        return None
    if np.isfinite(by_gap[0].gap):
        return None if len(by_gap) > 1 and tied(by_gap[0].gap, by_gap[1].gap) else by_gap[0]
    return by_gap[0] if dyad or len(by_gap) == 1 else None


def _dyads(mechanism: Mechanism, group: Group, motions: Motions, x: Real) -> list[_Placed]:
    """The variants of a dyad that reach."""
    found = []
    for sign in (1,) if group.kind in ONE_ASSEMBLY else (1, -1):
        step, moved = build(mechanism, group, sign), dict(motions)
        with np.errstate(divide="ignore", invalid="ignore"):
            _, at = step.advance(moved, {}, x, 0, solvers.closed)
        if np.isfinite(moved[group.links[0]].u).all() and np.isfinite(moved[group.links[1]].r).all():
            found.append(_told(mechanism, group, sign, moved, float(np.ravel(step.regularity(at))[0]), None))
    return found


def _higher(mechanism: Mechanism, group: Group, motions: Motions, x: Real) -> list[_Placed]:
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
        sizes = (float(closed.regularity[0]), float(closed.determinant[0]))
        found.append(_told(mechanism, group, number, moved, *sizes))
    return found


def _told(
    mechanism: Mechanism, group: Group, variant: int, motions: Motions, regularity: float, determinant: float | None
) -> _Placed:
    """One assembly with the places of its points."""
    own = own_points(mechanism, group)
    points = {name: complex(np.ravel(motions[k].point(p).r)[0]) for name, k, p in own}
    sketch = mechanism.assembly.sketch
    gaps = [abs(points[name] - sketch[name]) for name in points if name in sketch]
    gap = float(np.sqrt(np.mean(np.square(gaps)))) if gaps else float("inf")
    return _Placed(GroupAssembly(group.name, variant, False, regularity, determinant, points), motions, gap)
