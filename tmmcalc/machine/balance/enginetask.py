"""Balance of an engine as a project asks for it."""

from __future__ import annotations

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.machine.balance.engines import EngineBalance, ShaftWeights, corrected, engine_balance, shaft_weights
from tmmcalc.machine.balance.firing import Firing, firing
from tmmcalc.machine.model import EngineTask


@record
class Engine:
    """Shaking forces and couples of an engine, and what weights on its crankshaft and on balance shafts leave."""

    cylinders: int = quantity("cylinders", "number of cylinders")
    balance: EngineBalance
    firing: Firing | None  # None without a firing order
    crankshaft: ShaftWeights  # weights of the first order on the crankshaft
    with_crankshaft: EngineBalance
    shafts: tuple[ShaftWeights, ...]  # crankshaft and balance shafts of the orders -1, 2, -2
    with_shafts: EngineBalance


def solve_engine(task: EngineTask) -> Engine:
    """The engine as it is, with weights on the crankshaft, and with balance shafts of the first and second order."""
    balance = engine_balance(task.cylinders, task.speed, orders=task.orders)
    positions = [cylinder.position_along_shaft for cylinder in task.cylinders]
    low, high = min(positions), max(positions)
    planes = (low, high) if high > low else (low - 0.5, low + 0.5)
    crankshaft = shaft_weights(balance, 1, planes)
    shafts = (crankshaft, *(shaft_weights(balance, order, planes) for order in (-1, 2, -2)))
    sense = 1 if task.speed > 0 else -1
    fired = None
    if task.firing_order is not None:
        fired = firing(task.cylinders, task.firing_order, strokes=task.strokes, sense=sense)
    return Engine(
        len(task.cylinders),
        balance,
        fired,
        crankshaft,
        corrected(balance, [crankshaft]),
        shafts,
        corrected(balance, shafts),
    )
