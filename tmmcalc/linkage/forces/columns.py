"""The columns of the forces table.

R_A_x R_A_y R_A   force of the lower-numbered link on the higher-numbered one in joint A, and its size
N_D M_D           prismatic pair: normal force, and couple about the slider's point; N'_D N''_D its edge reactions
F_fr_D M_fr_A     friction along the line of a prismatic pair, about the pin of a revolute one
M_drive P_drive   moment (F_drive: force) of the drive along the positive input coordinate, and its power
F_mesh_x F_mesh_y force of the pinion on the crank's gear
equilibrium virtual   residuals, relative
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.linkage.columns import phi_column
from tmmcalc.linkage.forces.edges import edge_reactions
from tmmcalc.linkage.forces.results import Forces, PairForces


def columns(result: Forces) -> list[Column]:
    """All columns of a result in their usual order."""
    drive = ("M_drive", "N*m") if result.turns else ("F_drive", "N")
    pairs = [column for j, pair in enumerate(result.pairs) for column in _pair(result, j, pair)]
    return [
        phi_column(result.phi, result.turns),
        Column(*drive, lambda: result.drive),
        Column("P_drive", "W", lambda: result.power),
        *pairs,
        *_mesh(result),
        Column("equilibrium", "-", lambda: result.equilibrium),
        Column("virtual", "-", lambda: result.virtual),
    ]


def _pair(result: Forces, j: int, pair: PairForces) -> Iterator[Column]:
    name = pair.joint
    yield Column(f"R_{name}_x", "N", lambda: result.reaction[j].real)
    yield Column(f"R_{name}_y", "N", lambda: result.reaction[j].imag)
    yield Column(f"R_{name}", "N", lambda: np.abs(result.reaction[j]))
    if pair.kind == "prismatic":
        yield Column(f"N_{name}", "N", lambda: result.normal[j])
        yield Column(f"M_{name}", "N*m", lambda: result.couple[j])
        if pair.length:
            ahead, behind = edge_reactions(result.normal[j], result.couple[j], pair.length)
            yield Column(f"N'_{name}", "N", lambda: ahead)
            yield Column(f"N''_{name}", "N", lambda: behind)
        if pair.friction:
            yield Column(f"F_fr_{name}", "N", lambda: result.friction[j])
    elif pair.friction and pair.radius:
        yield Column(f"M_fr_{name}", "N*m", lambda: result.friction[j])


def _mesh(result: Forces) -> Iterator[Column]:
    mesh = result.mesh
    if mesh is not None:
        yield Column("F_mesh_x", "N", lambda: mesh.real)
        yield Column("F_mesh_y", "N", lambda: mesh.imag)
