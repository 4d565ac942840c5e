"""Stage ``vibrator``: springs, modes, steady vibration and starts of a vibratory assembly device."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.stage import said
from tmmcalc.vibration.tables.tasks.vibration import to_vibrator
from tmmcalc.vibration.vibrator.results import VibratorResult

if TYPE_CHECKING:
    from tmmcalc.vibration.room import VibrationTables


NO_EXCITATION = "no [vibrator.unbalance] or no speed: no steady vibration"
NO_CURVE = "no [vibrator.curve]: no resonance curve"
NO_START = "no [vibrator.start]: no start with a given angle"
NO_DRIVE = "no [vibrator.drive]: no start under a motor"

inputs = to_vibrator
solve = "tmmcalc.vibration.vibrator.solve:solve_vibrator"
kind = VibratorResult
columns = "tmmcalc.vibration.vibrator.columns:columns"
series = {
    "modes": ("mode shapes", "f"),
    "curve": ("resonance curve", "omega"),
    "steady": ("steady vibration", "t"),
    "start": ("start with a given angle", "t"),
    "drive": ("start by the motor", "t"),
}


def omits(spec: VibrationTables) -> tuple[str, ...]:
    """Kinds of motion that are not asked for."""
    table = spec.vibrator
    if table is None:
        return ()
    return said(
        (table.unbalance is None or table.speed is None, NO_EXCITATION),
        (table.curve is None or table.unbalance is None, NO_CURVE),
        (table.start is None, NO_START),
        (table.drive is None, NO_DRIVE),
    )


def packages(spec: VibrationTables) -> tuple[str, ...]:
    """A start under a motor is integrated."""
    return ("scipy.integrate",) if spec.vibrator is not None and spec.vibrator.drive is not None else ()
