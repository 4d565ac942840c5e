"""Stage ``structure``: mobility, Assur groups, order of assembly."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.conversion import plain, restore
from tmmcalc.core.stored import Record
from tmmcalc.linkage.structure import Structure, skeleton, solve_structure

if TYPE_CHECKING:
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.linkage.room import LinkageTables

solve = solve_structure
kind = Structure


def inputs(spec: LinkageTables) -> Mechanism:
    """Links and joints with their kinds and links: the metric plays no part."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return skeleton(to_linkage(spec.linkage))


def dump(result: Structure) -> Record:
    """All of it is scalars; the formula is added for readers."""
    return Record(scalars={"formula": result.formula, "class_number": result.class_number, **plain(result)})


def load(record: Record) -> Structure:
    """Build the result from its record."""
    structure: Structure = restore(Structure, record.scalars)
    return structure
