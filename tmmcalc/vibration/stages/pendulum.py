"""Stage ``pendulum``: whirl, critical speeds, torsion and motion in time of a pendulum-rotor."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tmmcalc.vibration.pendulum.results import PendulumResult
from tmmcalc.vibration.tables.tasks.vibration import to_pendulum

inputs = to_pendulum
solve = "tmmcalc.vibration.pendulum.solve:solve_pendulum"
kind = PendulumResult
series = {
    "modes": ("mode shapes", "a"),
    "campbell": ("frequencies over the speed of spin", "spin"),
    "swing": ("motion in time", "t"),
}


def columns(result: PendulumResult) -> Mapping[str, Any]:
    """One row a time, a speed of spin or a place along the rod; the first column tells of what."""
    from tmmcalc.vibration.pendulum.columns import pendulum_columns
    from tmmcalc.vibration.series import as_text

    return {header: as_text(column) for header, column in pendulum_columns(result).items()}
