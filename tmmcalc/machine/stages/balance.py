"""Stage ``balance``: shaking forces of the linkage on its foundation, of an engine, of a rotor; and balancing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.conversion import restore
from tmmcalc.core.records import record
from tmmcalc.core.stage import said
from tmmcalc.core.stored import DeferredColumns, Record, Table
from tmmcalc.linkage.wanted import NO_CSV, is_long
from tmmcalc.machine.wanted import shakes

if TYPE_CHECKING:
    from tmmcalc.linkage.loading import Body
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.linkage.results import Kinematics
    from tmmcalc.machine.balance.enginetask import Engine
    from tmmcalc.machine.balance.rotortask import BalancedRotor
    from tmmcalc.machine.balance.solve import BalanceTask, Balancing
    from tmmcalc.machine.model import EngineTask, RotorTask
    from tmmcalc.machine.room import MachineTables


NO_LINKAGE = "no linkage with masses: no shaking force over positions"
NO_ENGINE = "no [engine]: no orders of cylinders"
NO_ROTOR = "no [rotor]: no correction planes"

kinds = (
    "tmmcalc.machine.balance.solve:Balancing",
    "tmmcalc.machine.balance.enginetask:Engine",
    "tmmcalc.machine.balance.rotortask:BalancedRotor",
)


columns = "tmmcalc.machine.balance.columns:linkage_columns"
declares = ("tmmcalc.linkage.columns:PHI",)


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


def inputs(spec: MachineTables) -> Given:
    """The linkage with its masses, the engine, the rotor: as far as the spec has them."""
    from tmmcalc.machine.tables.tasks.balance import to_engine, to_rotor

    return Given(_linkage(spec), to_engine(spec), to_rotor(spec))


def _linkage(spec: MachineTables) -> tuple[Mechanism, tuple[Body, ...], BalanceTask] | None:
    if not shakes(spec):
        return None
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.machine.tables.tasks.balance import to_balance

    return to_linkage(spec.linkage), to_loading(spec).bodies, to_balance(spec)


def solve(given: Given, kinematics: Kinematics | None = None) -> Balances:
    """Shaking forces, and what balancing leaves of them."""
    linkage = engine = rotor = None
    if given.linkage is not None:
        from tmmcalc.machine.balance.solve import solve_balance

        mechanism, bodies, task = given.linkage
        assert kinematics is not None
        linkage = solve_balance(mechanism, bodies, kinematics, task)
    if given.engine is not None:
        from tmmcalc.machine.balance.enginetask import solve_engine

        engine = solve_engine(given.engine)
    if given.rotor is not None:
        from tmmcalc.machine.balance.rotortask import solve_rotor

        rotor = solve_rotor(given.rotor)
    return Balances(linkage, engine, rotor)


def errors(result: Balances) -> dict[str, Any]:
    """Estimates of its errors."""
    errors = result.linkage.errors if result.linkage is not None else {}
    if result.engine is not None:
        errors["engine"] = result.engine.balance.error
    if result.rotor is not None:
        errors["rotor"] = result.rotor.balance.error
    return errors


def load(record: Record) -> Balances:
    """Build the result from its record; parts that it has not are not even imported."""
    return Balances(_linkage_in(record), _engine_in(record), _rotor_in(record))


def _linkage_in(record: Record) -> Balancing | None:
    if "linkage" not in record.scalars:
        return None
    from tmmcalc.machine.balance.solve import Balancing

    found: Balancing = _part(Balancing, "linkage", record)
    return found


def _engine_in(record: Record) -> Engine | None:
    if "engine" not in record.scalars:
        return None
    from tmmcalc.machine.balance.enginetask import Engine

    found: Engine = _part(Engine, "engine", record)
    return found


def _rotor_in(record: Record) -> BalancedRotor | None:
    if "rotor" not in record.scalars:
        return None
    from tmmcalc.machine.balance.rotortask import BalancedRotor

    found: BalancedRotor = _part(BalancedRotor, "rotor", record)
    return found


def _part(kind: type, name: str, record: Record) -> Any:
    return restore(kind, record.scalars[name], record.arrays, name)


def table(result: Balances) -> Table | None:
    """All columns of the linkage, one row a position; None without one."""
    if result.linkage is None:
        return None
    from tmmcalc.machine.balance.columns import linkage_columns

    chosen = linkage_columns(result)
    return Table(
        ["i", *(c.header for c in chosen)], DeferredColumns([np.array(result.labels), *(c.make for c in chosen)])
    )


def omits(spec: MachineTables) -> tuple[str, ...]:
    """What is not there to be balanced."""
    linkage = shakes(spec)
    return said(
        (not linkage, NO_LINKAGE),
        (spec.engine is None, NO_ENGINE),
        (spec.rotor is None, NO_ROTOR),
        (linkage and is_long(spec), NO_CSV),
    )
