"""Stage ``vibrator``: springs, modes, steady vibration and starts of a vibratory assembly device."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table
from tmmcalc.vibration.vibrator.results import VibratorResult
from tmmcalc.vibration.vibrator.task import VibratorTask

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> VibratorTask:
    """The bodies, springs and unbalance, and what is asked of them."""
    from tmmcalc.vibration.tables.tasks.vibration import to_vibrator

    return to_vibrator(spec)


def solve(given: VibratorTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> VibratorResult:
    """Everything that is asked of the device."""
    from tmmcalc.vibration.vibrator.solve import solve_vibrator

    return solve_vibrator(given)


def dump(result: VibratorResult) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> VibratorResult:
    """Build the result from its record."""
    result: VibratorResult = from_record(VibratorResult, record)
    return result


def table(result: VibratorResult) -> Table:
    """One row a time or a speed; the first column tells of what."""
    from tmmcalc.vibration.series import as_text
    from tmmcalc.vibration.vibrator.columns import vibrator_columns

    columns = vibrator_columns(result)
    return Table(list(columns), [as_text(column) for column in columns.values()])
