"""The torque diagram of a spec as a cycle: its law, several equal ones in phase, the constant load that closes it."""

from __future__ import annotations

from dataclasses import replace

from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.diagram.sources import from_formula, from_harmonics, from_pieces, from_table
from tmmcalc.machine.diagram.superposition import balanced, superposed
from tmmcalc.machine.model import TorqueFormula, TorqueHarmonics, TorqueTask


def cycle_of(task: TorqueTask) -> Cycle:
    """The moment of the diagram and the inertia of its shaft over one cycle; raises `UsageError` for a bad law."""
    cycle = _law(task)
    if task.delays:
        cycle = superposed(cycle, task.delays)
    if task.balanced:
        cycle = balanced(cycle)
    return replace(cycle, inertia=cycle.inertia + task.inertia)


def _law(task: TorqueTask) -> Cycle:
    law, speed, period = task.law, task.speed, task.period
    if isinstance(law, TorqueFormula):
        return from_formula(law.text, speed, period=period, constants=dict(law.constants))
    if isinstance(law, TorqueHarmonics):
        return from_harmonics(law.constant, law.terms, speed, period=period)
    if law.interpolation == "linear":
        return from_pieces(tuple(zip(law.theta, law.moment, strict=True)), speed, period=period)
    return from_table(law.theta, law.moment, speed, period=period, kind="pchip")
