"""All assemblies of every group at one input coordinate, and which of them the mechanism takes there."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.assemblies import assemblies_of, chosen
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.placing import chosen_at, placed
from tmmcalc.linkage.structure import Structure, solve_structure
from tmmcalc.linkage.variants import given_variants


@record
class GroupAssembly:
    """One assembly of a group."""

    group: str = quantity("group", "name of the group")
    variant: int = quantity("variant", "what assembly.variants takes: the sign of a dyad, the number of a higher group")
    taken: bool = quantity("taken", "the mechanism takes this assembly")
    regularity: float = quantity("regularity", "1 the best, 0 singular")
    # of a higher group alone
    determinant: float | None = quantity(
        "determinant", "of the group's equations with unit columns; its sign stays along a branch"
    )
    points: dict[str, complex] = quantity(
        "points[m]", "places of the named points of the group's links but of its outer pins"
    )


@record
class Listing:
    """All assemblies of the groups at one input coordinate [rad or m], group by group."""

    x: float = quantity("x[{unit}]", "input coordinate")
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
        place = placed(mechanism, structure)
        told, at = {step.group.name: step.variant for step in place.chain.steps}, place.start
    chain, x = Chain(mechanism, structure, ()), np.array([at])
    motions, found = chain.evaluate(x, order=0).motions, list[GroupAssembly]()
    for group in structure.groups:
        assemblies, taken, reason = assemblies_of(mechanism, group, motions, x), None, ""
        try:
            taken = chosen(chain, group, assemblies, at, told.get(group.name))
        except (NoSolutionError, UsageError) as error:
            reason = error.message
        found += [
            GroupAssembly(
                group.name,
                assembly.variant,
                assembly is taken,
                assembly.regularity,
                assembly.determinant,
                assembly.points,
            )
            for assembly in assemblies
        ]
        if taken is None:
            return Listing(at, chain.turns, tuple(found), group.name, reason)
        motions = taken.motions
    return Listing(at, chain.turns, tuple(found), "", "")
