"""Stage ``forces``: reactions in all pairs and the drive, with friction where the pairs have it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Late, Record, Table
from tmmcalc.linkage.forces.columns import columns
from tmmcalc.linkage.forces.results import Forces

if TYPE_CHECKING:
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> tuple[Mechanism, Loading]:
    """The linkage and what acts on it."""
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return to_linkage(spec.linkage), to_loading(spec)


def solve(given: tuple[Mechanism, Loading], upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Forces:
    """Solve all positions."""
    from tmmcalc.linkage.forces.forces import solve_forces  # a stored result is loaded without it

    return solve_forces(*given, upstream["kinematics"])


def dump(result: Forces) -> Record:
    """Arrays by the names of the fields: reaction, normal, couple, friction (J, n), drive, power (n,), ..."""
    return to_record(result, {"reactions": result.error})


def load(record: Record) -> Forces:
    """Build the result from its record."""
    result: Forces = from_record(Forces, record)
    return result


def table(result: Forces) -> Table:
    """All columns, one row a position; two where friction jumps."""
    chosen = columns(result)
    return Table(["i", *(c.header for c in chosen)], Late([np.array(result.labels), *(c.make for c in chosen)]))
