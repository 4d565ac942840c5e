"""The columns of a six-bar with a dwell, by position, in SI with angles in degrees."""

from __future__ import annotations

from functools import partial

import numpy as np

from tmmcalc.core.columns import Column, column, degrees
from tmmcalc.core.quantity import Quantity, quantities
from tmmcalc.linkage.synthesis.dwell.results import DwellMotion
from tmmcalc.linkage.synthesis.dwell.task import OutputKind

USUAL = ("phi", "S", "dS", "d2S", "x_B", "y_B", "R35", "R45", "R21", "N", "delta", "M_1")  # where none are chosen
PIN = (Quantity("x_B[m]", "x of B"), Quantity("y_B[m]", "y of B"))


def columns_of(m: DwellMotion, output: OutputKind) -> list[Column]:
    """The columns of the positions; those of the guide only of a slider."""
    slides = output == "slider"
    places = {"unit": "m", "slope": "m"} if slides else {"unit": "deg", "slope": ""}
    known = {name: told.of(**places) for name, told in quantities(DwellMotion).items()}

    def own(*names: str) -> list[Column]:
        return [column(known[name], partial(getattr, m, name)) for name in names]

    return [
        Column(known["phi"].name, "deg", lambda: degrees(m.phi)),
        Column(known["crank"].name, "deg", lambda: degrees(m.crank)),
        Column(known["theta"].name, "deg", lambda: degrees(m.theta)),
        column(known["s"], lambda: m.s if slides else np.degrees(m.s)),
        column(PIN[0], lambda: m.b.real),
        column(PIN[1], lambda: m.b.imag),
        *own("ds", "dds", "f3", "f4", "r21"),
        *(own("normal", "couple") if slides else ()),
        Column(known["delta"].name, "deg", lambda: np.degrees(m.delta)),
        *own("moment"),
    ]
