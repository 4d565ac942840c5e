"""Stage ``balance``: shaking forces of the linkage on its foundation, of an engine, of a rotor; and balancing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.linkage.balance.columns import columns
from tmmcalc.linkage.balance.task import BalanceTask, Balancing
from tmmcalc.machine.balancing.task import BalancedRotor, Engine
from tmmcalc.machine.model import EngineTask, RotorTask
from tmmcalc.pipeline.stage import Record, Table
from tmmcalc.records import record
from tmmcalc.stages.conversion import from_record, to_record

if TYPE_CHECKING:
    from tmmcalc.linkage.loading import Body
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.spec import Spec


@record
class Balances:
    """What of a spec is balanced; None: it has none."""

    linkage: Balancing | None
    engine: Engine | None
    rotor: BalancedRotor | None

    @property
    def labels(self) -> tuple[str, ...]:
        """Labels of the positions of the linkage."""
        return self.linkage.labels if self.linkage is not None else ()


@record
class Given:
    """What the stage reads."""

    linkage: tuple[Mechanism, tuple[Body, ...], BalanceTask] | None
    engine: EngineTask | None
    rotor: RotorTask | None


def inputs(spec: Spec) -> Given:
    """The linkage with its masses, the engine, the rotor: as far as the spec has them."""
    from tmmcalc.spec.balancing import to_engine, to_rotor

    return Given(_linkage(spec), to_engine(spec), to_rotor(spec))


def _linkage(spec: Spec) -> tuple[Mechanism, tuple[Body, ...], BalanceTask] | None:
    from tmmcalc.stages.wanted import shakes

    if not shakes(spec):
        return None
    from tmmcalc.spec.balancing import to_balance
    from tmmcalc.spec.linkage import to_linkage
    from tmmcalc.spec.loading import to_loading

    return to_linkage(spec.linkage), to_loading(spec).bodies, to_balance(spec)


def solve(given: Given, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Balances:
    """Shaking forces, and what balancing leaves of them."""
    from tmmcalc.linkage.balance.task import solve_balance
    from tmmcalc.machine.balancing.task import solve_engine, solve_rotor

    linkage = None
    if given.linkage is not None:
        mechanism, bodies, task = given.linkage
        linkage = solve_balance(mechanism, bodies, upstream["kinematics"], task)
    return Balances(
        linkage,
        solve_engine(given.engine) if given.engine is not None else None,
        solve_rotor(given.rotor) if given.rotor is not None else None,
    )


def dump(result: Balances) -> Record:
    """Arrays by the names of the fields: ``linkage.shaking.force``, what each scheme leaves, ..."""
    errors = {"linkage": result.linkage.shaking.error} if result.linkage is not None else {}
    if result.engine is not None:
        errors["engine"] = result.engine.balance.error
    return to_record(result, errors)


def load(record: Record) -> Balances:
    """Build the result from its record."""
    result: Balances = from_record(Balances, record)
    return result


def table(result: Balances) -> Table | None:
    """All columns of the linkage, one row a position; None without one."""
    if result.linkage is None:
        return None
    chosen = columns(result.linkage)
    return Table(["i", *(c.header for c in chosen)], [np.array(result.labels), *(c.make() for c in chosen)])
