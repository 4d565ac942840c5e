"""The torque diagram of a spec as a cycle: its law, several equal ones in phase, the constant load that closes it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.diagram.sources import from_formula, from_harmonics, from_inertia, from_table
from tmmcalc.machine.diagram.superposition import balanced, combined, superposed
from tmmcalc.machine.model import TorqueFormula, TorqueHarmonics, TorqueTask

HUGE = 1e100  # [N*m] beyond every machine; squares of moments must remain numbers


def cycle_of(task: TorqueTask) -> Cycle:
    """The moment of the diagram and the inertia of its shaft over one cycle; raises `UsageError` for a bad law.

    The reduced inertia that varies is that of one diagram, as its moment is; equal diagrams on the shaft each have it.
    """
    cycle = _law(task)
    _check_size(cycle)
    if task.reduced is not None:
        table = task.reduced
        of_table = from_inertia(table.theta, table.inertia, task.speed, period=table.period, kind=table.interpolation)
        cycle = combined([(cycle, 0.0), (of_table, 0.0)])
    if task.delays:
        cycle = superposed(cycle, task.delays)
    if task.balanced:
        cycle = balanced(cycle)
    return replace(cycle, inertia=cycle.inertia + task.inertia)


def _check_size(cycle: Cycle) -> None:
    """Raise `UsageError` for a moment whose square would overflow."""
    size = np.abs(cycle.moment)
    k = np.unravel_index(int(np.argmax(size)), size.shape)
    if size[k] > HUGE:
        raise UsageError(
            f"a moment of {cycle.moment[k]:.4g} N*m at {math.degrees(cycle.panels.x[k]):.4g} deg",
            where="torque diagram",
            value=float(size[k]),
            limit=HUGE,
            remedy=f"moments up to {HUGE:g} N*m can be computed; check the exponents of the diagram",
        )


def _law(task: TorqueTask) -> Cycle:
    law, speed, period = task.law, task.speed, task.period
    if isinstance(law, TorqueFormula):
        return from_formula(law.text, speed, period=period, constants=dict(law.constants))
    if isinstance(law, TorqueHarmonics):
        return from_harmonics(law.constant, law.terms, speed, period=period)
    return from_table(law.theta, law.moment, speed, period=period, kind=law.interpolation)
