"""Stage ``pendulum``: whirl, critical speeds, torsion and motion in time of a pendulum-rotor."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.vibration.pendulum.results import PendulumResult
from tmmcalc.vibration.pendulum.task import PendulumTask

if TYPE_CHECKING:
    from tmmcalc.vibration.room import VibrationTables


def inputs(spec: VibrationTables) -> PendulumTask:
    """The rod, the disc, the joint, and what is asked of them."""
    from tmmcalc.vibration.tables.tasks.vibration import to_pendulum

    return to_pendulum(spec)


def solve(given: PendulumTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> PendulumResult:
    """Everything that is asked of the pendulum."""
    from tmmcalc.vibration.pendulum.solve import solve_pendulum

    return solve_pendulum(given)


def columns(result: PendulumResult) -> Mapping[str, Any]:
    """One row a time, a speed of spin or a place along the rod; the first column tells of what."""
    from tmmcalc.vibration.pendulum.columns import pendulum_columns
    from tmmcalc.vibration.series import as_text

    return {header: as_text(column) for header, column in pendulum_columns(result).items()}
