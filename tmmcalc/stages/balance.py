"""Stage ``balance``: shaking force and moment of the linkage on its foundation, and balancing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.linkage.balance.columns import columns
from tmmcalc.linkage.balance.task import BalanceTask, Balancing
from tmmcalc.pipeline.stage import Record, Table
from tmmcalc.stages.conversion import from_record, to_record

if TYPE_CHECKING:
    from tmmcalc.linkage.loading import Body
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.spec import Spec

Given = tuple["Mechanism", "tuple[Body, ...]", BalanceTask]


def inputs(spec: Spec) -> Given:
    """The linkage, its masses, what is asked of the balance."""
    from tmmcalc.spec.balance import to_balance
    from tmmcalc.spec.linkage import to_linkage
    from tmmcalc.spec.loading import to_loading

    return to_linkage(spec.mechanism), to_loading(spec).bodies, to_balance(spec)


def solve(given: Given, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Balancing:
    """Shaking force and moment, and what the schemes leave."""
    from tmmcalc.linkage.balance.task import solve_balance

    mechanism, bodies, task = given
    return solve_balance(mechanism, bodies, upstream["kinematics"], task)


def dump(result: Balancing) -> Record:
    """Arrays by the names of the fields: shaking, and what each scheme leaves."""
    return to_record(result, {"forces": result.shaking.error})


def load(record: Record) -> Balancing:
    """Build the result from its record."""
    result: Balancing = from_record(Balancing, record)
    return result


def table(result: Balancing) -> Table:
    """All columns, one row a position."""
    chosen = columns(result)
    return Table(["i", *(c.header for c in chosen)], [np.array(result.labels), *(c.make() for c in chosen)])
