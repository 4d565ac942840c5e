"""Efficiencies of meshes as they are known: given, by the friction of teeth, or of general engineering values."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.network.friction import mesh_efficiency
from tmmcalc.gears.network.model import EXTERNAL, INTERNAL
from tmmcalc.gears.scheme import layout_of


def efficiency_of_mesh(
    first: int, second: int, internal: bool, efficiency: float | None = None, friction: float | None = None
) -> float:
    """Efficiency of a mesh of these numbers of teeth [-].

    >>> round(efficiency_of_mesh(20, 60, False, friction=0.08), 6), efficiency_of_mesh(20, 60, True)
    (0.987733, 0.985)
    """
    if efficiency is not None:
        return efficiency
    if friction is not None:
        return float(mesh_efficiency(first, second, INTERNAL if internal else EXTERNAL, friction))
    usual = MeshEfficiency()
    return usual.internal if internal else usual.external


def layout_efficiencies(
    layout: str,
    teeth: Sequence[int],
    efficiency: float | Sequence[float] | None = None,
    friction: float | None = None,
) -> list[float]:
    """Efficiency of every mesh of a layout: a list as it is, one for all, or as `efficiency_of_mesh` finds it."""
    scheme = layout_of(layout)
    if isinstance(efficiency, Sequence):
        return list(efficiency)
    z = dict(zip(scheme.wheels, teeth, strict=True))
    return [
        efficiency_of_mesh(z[mesh.first], z[mesh.second], mesh.internal, efficiency, friction) for mesh in scheme.meshes
    ]


def usual_efficiencies() -> str:
    """The words for efficiencies that nobody gave.

    >>> usual_efficiencies()
    'efficiencies of meshes are general values: 0.975, of internal ones 0.985'
    """
    usual = MeshEfficiency()
    return f"efficiencies of meshes are general values: {usual.external:g}, of internal ones {usual.internal:g}"
