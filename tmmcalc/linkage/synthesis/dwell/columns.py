"""The columns of a six-bar with a dwell, by position, in SI with angles in degrees."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.columns import Column, degrees
from tmmcalc.linkage.synthesis.dwell.results import Motion
from tmmcalc.linkage.synthesis.dwell.task import OutputKind

USUAL = ("phi", "S", "dS", "d2S", "x_B", "y_B", "R35", "R45", "R21", "N", "delta", "M_1")  # where none are chosen


def columns_of(m: Motion, output: OutputKind) -> list[Column]:
    """The columns of the positions; those of the guide only of a slider."""
    slides = output == "slider"
    unit = "m" if slides else "rad"
    columns = [
        Column("phi", "deg", lambda: degrees(m.phi)),
        Column("phi_1", "deg", lambda: degrees(m.crank)),
        Column("theta", "deg", lambda: degrees(m.theta)),
        Column("S", unit, lambda: m.s),
        Column("x_B", "m", lambda: m.b.real),
        Column("y_B", "m", lambda: m.b.imag),
        Column("dS", unit, lambda: m.ds),
        Column("d2S", unit, lambda: m.dds),
        Column("R35", "N", lambda: m.f3),
        Column("R45", "N", lambda: m.f4),
        Column("R21", "N", lambda: m.r21),
    ]
    if slides:
        columns += [Column("N", "N", lambda: m.normal), Column("M_N", "N*m", lambda: m.couple)]
    columns += [Column("delta", "deg", lambda: np.degrees(m.delta)), Column("M_1", "N*m", lambda: m.moment)]
    return columns
