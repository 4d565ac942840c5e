"""The torque diagram of a spec as a cycle: its law, several equal ones in phase, the constant load that closes it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.diagram.sources import from_formula, from_harmonics, from_pieces, from_table
from tmmcalc.machine.diagram.superposition import balanced, superposed
from tmmcalc.machine.model import TorqueFormula, TorqueHarmonics, TorqueTask

HUGE = 1e100  # [N*m] beyond every machine; squares of moments must remain numbers


def cycle_of(task: TorqueTask) -> Cycle:
    """The moment of the diagram and the inertia of its shaft over one cycle; raises `UsageError` for a bad law."""
    cycle = _law(task)
    _check_size(cycle)
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
    if law.interpolation == "linear":
        return from_pieces(tuple(zip(law.theta, law.moment, strict=True)), speed, period=period)
    return from_table(law.theta, law.moment, speed, period=period, kind="pchip")
