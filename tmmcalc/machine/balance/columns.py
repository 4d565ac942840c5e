"""The columns of the balance table."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.columns import phi_column
from tmmcalc.machine.balance.schemes import Balance
from tmmcalc.machine.balance.shaking import Shaking
from tmmcalc.machine.balance.solve import Balancing

FORCE = Quantity("R[N]", "magnitude of the shaking force", source="(3.71)")
FORCE_X = Quantity("R_x[N]", "shaking force along the fixed x axis")
FORCE_Y = Quantity("R_y[N]", "shaking force along the fixed y axis")
ALONG = Quantity("R_x1[N]", "shaking force along the crank")
ACROSS = Quantity("R_y1[N]", "shaking force across the crank")
MOMENT = Quantity("M_R[N*m]", "shaking moment about the chosen point", source="(3.71)")
LEFT = Quantity("D_{scheme}[N]", "size of the force left by {scheme}")
MOMENT_LEFT = Quantity("M_D_{scheme}[N*m]", "moment left by {scheme}")
ON_LINKS = "counterweights"  # the scheme of those on links


def columns(result: Balancing) -> list[Column]:
    """All columns of a result in their usual order."""
    found = result.shaking
    return [
        phi_column(result.phi, turns=True),
        column(FORCE, lambda: np.abs(found.force)),
        column(FORCE_X, lambda: found.force.real),
        column(FORCE_Y, lambda: found.force.imag),
        column(ALONG, lambda: found.turned.real),
        column(ACROSS, lambda: found.turned.imag),
        column(MOMENT, lambda: found.moment),
        *(each for scheme in result.schemes for each in _left(scheme.name, scheme.balance)),
        *([] if result.redistribution is None else _left(ON_LINKS, result.redistribution.after)),
    ]


def linkage_columns(result: Any) -> list[Column]:
    """The columns of the linkage in what the stage has balanced; none without one."""
    return [] if result.linkage is None else columns(result.linkage)


def _left(scheme: str, balance: Balance | Shaking) -> Iterator[Column]:
    yield column(_of(LEFT, scheme), lambda: np.abs(balance.force))
    yield column(_of(MOMENT_LEFT, scheme), lambda: balance.moment)


def _of(told: Quantity, scheme: str) -> Quantity:
    """The quantity of a scheme: its key has no spaces, its meaning the name as it is."""
    return told.of(scheme=scheme.replace(" ", "_"))._replace(meaning=Phrase(told.meaning, scheme=scheme))
