"""Torques in the meshes of a train, pinions and ratios of the meshes.

A planetary train is analysed as its inverted fixed-axis train: stopping the carrier changes no torque. From wheel 1,
which carries T1 in all branches together, a mesh passes torque on as the tooth numbers of its wheels; wheels of one
block (2 and 2', 3 and 3') and both meshes of an idler carry the same. So the textbook's factor q, of T1 on the pinion,
is 1 in stage 1, U1 in stage 2, U1 U2 in stage 3.

Extensions beyond the textbook, which knows unfolded, coaxial, AA, AI and AIbar trains with Z1 < Z2:
- the pinion of a mesh is its smaller wheel, whichever drives: u >= 1, and T is that on the smaller wheel;
- in AII the rings share the reaction: T4 = -i_14 T1 goes to the output, T3 = (i_14 - 1) T1 to the frame;
- all meshes of one stage share its width b = psi_bd d of the smallest wheel that is a pinion in the stage.
Losses are neglected.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.letters import teeth_of
from tmmcalc.gears.model import Integers, ToothSets, Values
from tmmcalc.gears.scheme import Layout


@record
class MeshLoads:
    """Meshes of n trains, in the order of the layout's meshes."""

    pinion: Integers  # (n, meshes) column of the smaller wheel in the teeth
    wheel: Integers  # (n, meshes) column of the larger wheel
    teeth: Values  # (n, meshes) Z of the pinion
    u: Values  # (n, meshes) ratio of the teeth, at least 1
    factor: Values  # (n, meshes) (u + 1)/u, in an internal mesh (u - 1)/u
    q: Values  # (n, meshes) torque on the pinion over T1, of all branches together
    reference: Values  # (n, stages) Z of the wheel that psi_bd is told of


def mesh_loads(sets: ToothSets) -> MeshLoads:
    """Torques and ratios of every mesh of every train; raises `UsageError` for wheels that cannot mesh."""
    layout = sets.scheme
    first = np.array([layout.index(mesh.first) for mesh in layout.meshes])
    second = np.array([layout.index(mesh.second) for mesh in layout.meshes])
    teeth = _teeth(sets, layout)
    z1, z2 = teeth[:, first], teeth[:, second]
    swapped = z2 < z1
    small, large = np.minimum(z1, z2), np.maximum(z1, z2)
    internal = np.array([mesh.internal for mesh in layout.meshes])
    _check_rings(layout, z1, z2)
    u = large / small
    stages = [[k for k, mesh in enumerate(layout.meshes) if mesh.stage == stage] for stage in range(layout.stages)]
    return MeshLoads(
        pinion=np.where(swapped, second, first),
        wheel=np.where(swapped, first, second),
        teeth=small,
        u=u,
        factor=np.where(internal, u - 1, u + 1) / u,
        q=_on_first(sets, layout) * small / z1,
        reference=np.stack([small[:, meshes].min(axis=1) for meshes in stages], axis=1),
    )


def _teeth(sets: ToothSets, layout: Layout) -> Values:
    if sets.teeth.ndim != 2 or sets.teeth.shape[1] != len(layout.wheels):
        raise UsageError(
            f"tooth numbers have the shape {sets.teeth.shape}; the layout {layout.key} has {len(layout.wheels)} wheels",
            where="strength",
            remedy=f"one column for each of the wheels {', '.join(layout.wheels)}",
        )
    if sets.teeth.size and sets.teeth.min() < 1:
        raise UsageError("a tooth number is not positive", where="strength", value=int(sets.teeth.min()), limit=1)
    return 1.0 * sets.teeth


def _check_rings(layout: Layout, z1: Values, z2: Values) -> None:
    for k, mesh in enumerate(layout.meshes):
        if not mesh.internal:
            continue
        ring, planet = (z1, z2) if mesh.first in layout.rings else (z2, z1)
        wrong = np.flatnonzero(ring[:, k] <= planet[:, k])
        if wrong.size:
            at = int(wrong[0])
            raise UsageError(
                f"set {at + 1}: the ring has {ring[at, k]:g} teeth, its planet {planet[at, k]:g}",
                where=f"strength, mesh {mesh.first}-{mesh.second}",
                value=ring[at, k],
                limit=planet[at, k],
                remedy="a ring has more teeth than the wheel in it",
            )


def _on_first(sets: ToothSets, layout: Layout) -> Values:
    """Torque (n, meshes) on the first wheel of every mesh over T1."""
    if layout.three_centrals:
        return _on_first_of_three(sets)
    on_shaft = {_shaft(layout.wheels[0]): np.ones(len(sets))}
    torques = []
    for mesh in layout.meshes:
        torque = on_shaft[_shaft(mesh.first)]
        torques.append(torque)
        on_shaft[_shaft(mesh.second)] = torque * sets.of(mesh.second) / sets.of(mesh.first)
    return np.stack(torques, axis=1)


def torque_letters(layout: Layout, pinions: Sequence[str]) -> list[str]:
    """The factor q of every mesh as a formula; ``pinions`` are the smaller wheels of the meshes.

    >>> from tmmcalc.gears.scheme import layout_of
    >>> torque_letters(layout_of("AI"), ("1", "2'")), torque_letters(layout_of("AII"), ("1", "2", "2'"))
    (['1', 'Z2/Z1'], ['1', 'abs(i_14 - 1)*Z2/Z3', "abs(i_14)*Z2'/Z4"])
    """
    if layout.three_centrals:
        first, second, third = (
            "" if pinion == mesh.first else f"*{teeth_of(mesh.second)}/{teeth_of(mesh.first)}"
            for mesh, pinion in zip(layout.meshes, pinions, strict=True)
        )
        return [f"1{first}", f"abs(i_14 - 1)*Z2/Z3{second}", f"abs(i_14)*Z2'/Z4{third}"]
    on_shaft: dict[str, list[str]] = {_shaft(layout.wheels[0]): []}
    letters = []
    for mesh, pinion in zip(layout.meshes, pinions, strict=True):
        passed = on_shaft[_shaft(mesh.first)]
        own = f"{teeth_of(mesh.second)}/{teeth_of(mesh.first)}"
        on_shaft[_shaft(mesh.second)] = [*passed, own]
        letters.append("*".join([*passed, own] if pinion == mesh.second else passed) or "1")
    return letters


def _on_first_of_three(sets: ToothSets) -> Values:
    """AII: the carrier takes no torque, so T1 + T3 + T4 = 0 and T4 = -i_14 T1."""
    z1, z2, z2b, z3, z4 = (1.0 * sets.of(wheel) for wheel in sets.scheme.wheels)
    difference = z2 * z4 - z3 * z2b
    wrong = np.flatnonzero(difference == 0)
    if wrong.size:
        raise UsageError(
            f"set {int(wrong[0]) + 1}: wheel 4 stands still, for Z2 Z4 = Z3 Z2'",
            where="strength",
            remedy="leave it out",
        )
    i_14 = (1 + z3 / z1) * z2 * z4 / difference
    return np.stack([np.ones(len(sets)), abs(i_14 - 1) * z2 / z3, abs(i_14) * z2b / z4], axis=1)


def _shaft(wheel: str) -> str:
    return wheel.rstrip("'")
