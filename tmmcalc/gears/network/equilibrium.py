"""Equilibrium of all members of a train: mesh, lock and outside torques as unknowns of one square system.

It is the transpose of the system of speeds: the torque of a mesh acts on members as its equation weighs their speeds.
Losses change the torque on the second wheel only, by the efficiency in the direction of the rolling power.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.elimination import reduce
from tmmcalc.gears.network.model import FRAME, WHERE, Network
from tmmcalc.gears.network.speeds import Locks, Motion, constraint_rows

REGULAR = 1e6  # condition number below which no exact look at the rank is needed


class Statics(NamedTuple):
    """The equilibrium of all members: matrix (n, n), of unknown mesh, lock and outside torques."""

    network: Network
    motion: Motion
    locked: tuple[tuple[str, str], ...]
    unknown: tuple[str, ...]  # members whose outside torque is sought
    load: Values  # (n,) given outside torques
    constraints: Values  # (m + l, n) whole coefficients of speeds in meshes and locks
    matrix: Values  # without losses
    active: NDArray[np.intp]  # (a,) numbers of meshes that roll with losses


def equilibrium(
    network: Network,
    motion: Motion,
    torques: Mapping[str, float],
    outputs: tuple[str, ...],
    locked: tuple[tuple[str, str], ...],
) -> Statics:
    """The equilibrium with these outside torques given [N*m]; raises `UsageError` unless it determines the others."""
    load = np.zeros(len(network.members))
    for name, torque in torques.items():
        if not isfinite(torque):
            raise UsageError(f"the torque on {name!r} is {torque}", where=WHERE, remedy="give a finite torque in N*m")
        load[network.place[network.known(name)]] = torque
    sought = dict.fromkeys((*motion.driven, *(network.known(name) for name in outputs)))
    unknown = tuple(name for name in sought if name not in torques)
    n = len(network.members)
    constraints: Values = np.array(constraint_rows(network, locked), dtype=float).reshape(-1, n)
    matrix = matrix_of(network, constraints, unknown)
    if matrix.shape[0] != matrix.shape[1] or np.linalg.cond(matrix) > REGULAR:
        _check_determinate(network, locked, unknown)
    lossy = np.array([mesh.efficiency < 1 for mesh in network.meshes], dtype=bool)
    active = np.flatnonzero(lossy & (motion.rolling[:, 0] != 0))
    return Statics(network, motion, locked, unknown, load, constraints, matrix, active)


def matrix_of(network: Network, constraints: Values, unknown: tuple[str, ...]) -> Values:
    """Matrix of the equilibrium without losses, in the kind of numbers of the constraints."""
    teeth = [mesh.first_teeth for mesh in network.meshes] + [1] * (len(constraints) - len(network.meshes))
    outside = np.zeros((len(unknown), len(network.members)))
    outside[np.arange(len(unknown)), [network.place[name] for name in unknown]] = 1.0
    return np.vstack((constraints / np.array(teeth)[:, None], outside)).T


def _check_determinate(network: Network, locked: Locks, unknown: tuple[str, ...]) -> None:
    """Raise `UsageError` unless the equilibrium of the members has as many independent unknown torques as members."""
    n = len(network.members)
    rows = constraint_rows(network, locked)
    rows += [[int(member == name) for member in network.members] for name in unknown]
    reduced = reduce(rows, n)
    names = (*map(str, network.meshes), *(f"lock {a}-{b}" for a, b in locked), *(f"torque on {u}" for u in unknown))
    for row in reduced.dependent.values():
        shared = ", ".join(name for name, c in zip(names, row, strict=True) if c)
        raise UsageError(
            f"equilibrium cannot tell the torques of {shared} apart",
            where=WHERE,
            value=float(len(rows)),
            limit=float(n),
            remedy="give one of the outside torques; write like meshes in parallel as one mesh of several planets",
        )
    if reduced.free:
        moving = ", ".join(network.members[c] for c in reduced.undetermined())
        stated = ", ".join(unknown) or "none"
        raise UsageError(
            f"nothing balances {moving}: {len(reduced.free)} more outside torques must be sought (now: {stated})",
            where=WHERE,
            value=float(len(unknown)),
            limit=float(len(unknown) + len(reduced.free)),
            remedy="name the members that drive or are driven from outside as outputs",
        )


def lossy_matrix(statics: Statics, directions: Values, part: float = 1.0) -> Values:
    """Matrices (..., n, n) with the losses of directions (..., a): +1 the first wheel drives, -1 the second."""
    network = statics.network
    matrix = np.broadcast_to(statics.matrix, (*directions.shape[:-1], *statics.matrix.shape)).copy()
    number = matrix.dtype.type
    for k, j in enumerate(statics.active):
        mesh = network.meshes[j]
        eta = 1 - part * (1 - number(mesh.efficiency))
        second = -mesh.sign * mesh.second_teeth / number(mesh.first_teeth)
        change = second * (eta ** directions[..., k] - 1)
        for name, factor in ((mesh.second, 1), (network.carriers[j], -1)):
            if name != FRAME and not (factor < 0 and network.tilted(mesh.second)):
                matrix[..., network.place[name], j] += factor * change
    return matrix


def residual(statics: Statics, directions: Values, x: Values) -> float:
    """Largest residual of an equilibrium relative to its terms [-]."""
    matrix = lossy_matrix(statics, directions)
    terms = np.abs(matrix) @ np.abs(x) + np.abs(statics.load)
    left = np.abs(matrix @ x + statics.load)
    return float(np.max(left[terms > 0] / terms[terms > 0], initial=0.0))
