"""The columns of the balance table.

R_x, R_y, R       shaking force in fixed axes, and its size; R_x1, R_y1 in the axes of the crank
M_R               shaking moment about the chosen point
D_<scheme>        size of the force left by a scheme; M_D_<scheme> the moment left
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.linkage.columns import phi_column
from tmmcalc.machine.balance.schemes import Balance
from tmmcalc.machine.balance.task import Balancing


def columns(result: Balancing) -> list[Column]:
    """All columns of a result in their usual order."""
    found = result.shaking
    return [
        phi_column(result.phi, turns=True),
        Column("R", "N", lambda: np.abs(found.force)),
        Column("R_x", "N", lambda: found.force.real),
        Column("R_y", "N", lambda: found.force.imag),
        Column("R_x1", "N", lambda: found.turned.real),
        Column("R_y1", "N", lambda: found.turned.imag),
        Column("M_R", "N*m", lambda: found.moment),
        *(column for scheme in result.schemes for column in _left(scheme.name, scheme.balance)),
        *_redistributed(result),
    ]


def _left(scheme: str, balance: Balance) -> Iterator[Column]:
    name = scheme.replace(" ", "_")
    yield Column(f"D_{name}", "N", lambda: np.abs(balance.force))
    yield Column(f"M_D_{name}", "N*m", lambda: balance.moment)


def _redistributed(result: Balancing) -> Iterator[Column]:
    if result.redistribution is not None:
        after = result.redistribution.after
        yield Column("D_counterweights", "N", lambda: np.abs(after.force))
        yield Column("M_D_counterweights", "N*m", lambda: after.moment)
