"""All assemblies of every group at one input coordinate, and which of them the mechanism takes there."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.records import record
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.placing import chosen_at, placed
from tmmcalc.linkage.structure import Structure, solve_structure
from tmmcalc.linkage.variants import given_variants
from tmmcalc.linkage.ways import chosen, ways_of


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
    undecided: str  # the group of which none is taken; those after it are not listed
    reason: str  # why


def list_assemblies(mechanism: Mechanism, structure: Structure | None = None) -> Listing:
    """Every assembly of every group at assembly.at, input.start, the sketched angle of the crank, or position 0.

    A group sees those before it on the assembly that the spec takes. Where none is taken, the list ends with that
    group. Raises `NoSolutionError` if nothing gives the input coordinate.
    """
    structure = structure or solve_structure(mechanism)
    told, at = given_variants(mechanism, structure), chosen_at(mechanism, structure)
    if at is None:
        chain, _, at = placed(mechanism, structure)
        told = {step.group.name: step.variant for step in chain.steps}
    chain, x = Chain(mechanism, structure, ()), np.array([at])
    motions, found = chain.evaluate(x, order=0).motions, list[GroupAssembly]()
    for group in structure.groups:
        ways, taken, reason = ways_of(mechanism, group, motions, x), None, ""
        try:
            taken = chosen(chain, group, ways, at, told.get(group.name))
        except (NoSolutionError, UsageError) as error:
            reason = error.message
        found += [
            GroupAssembly(group.name, way.variant, way is taken, way.regularity, way.determinant, way.points)
            for way in ways
        ]
        if taken is None:
            return Listing(at, chain.turns, tuple(found), group.name, reason)
        motions = taken.motions
    return Listing(at, chain.turns, tuple(found), "", "")
