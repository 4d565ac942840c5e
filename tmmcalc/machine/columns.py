"""The columns of the table of a steady motion.

t omega eps                 time since position 0, angular speed of the input shaft, its angular acceleration
M_d M_load                  moment of the drive, reduced moment of everything else
omega_idle omega_textbook   speed without technological loads; by the recurrence (3.57)
"""

from __future__ import annotations

from tmmcalc.core.columns import Column, degrees
from tmmcalc.machine.motion import Motion


def motion_columns(result: Motion) -> list[Column]:
    """All columns of a steady motion in their usual order."""
    idle, textbook = result.omega_idle, result.textbook
    columns = [
        Column("phi", "deg", lambda: degrees(result.phi)),
        Column("omega", "rad/s", lambda: result.omega),
        Column("eps", "rad/s^2", lambda: result.eps),
        Column("t", "s", lambda: result.time),
        Column("M_d", "N*m", lambda: result.driving),
        Column("M_load", "N*m", lambda: result.load),
    ]
    if idle is not None:
        columns.append(Column("omega_idle", "rad/s", lambda: idle))
    if textbook is not None:
        columns.append(Column("omega_textbook", "rad/s", lambda: textbook.regime.omega))
    return columns
