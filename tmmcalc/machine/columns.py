"""The columns of the table of a steady motion: the input coordinate, and what `Motion` holds of every position."""

from __future__ import annotations

from tmmcalc.core.columns import Column, columns_of
from tmmcalc.linkage.columns import phi_column
from tmmcalc.machine.motion import Motion


def motion_columns(result: Motion) -> list[Column]:
    """All columns of a steady motion in their usual order."""
    return [phi_column(result.phi, turns=True), *columns_of(result)]
