"""Efficiencies of meshes as they are known: given, by the friction of teeth, or of general engineering values."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.model import EXTERNAL, INTERNAL, WHERE
from tmmcalc.gears.scheme import layout_of

SLIDING = 2.3  # of standard teeth of 20 degrees: pi (1 - e + e1^2 + e2^2), e1 + e2 = e the contact ratio


def mesh_efficiency(first: ArrayLike, second: ArrayLike, sign: ArrayLike = EXTERNAL, friction: float = 0.08) -> Values:
    """Efficiency 1 - 2.3 f (1/z1 -+ 1/z2) of pairs of wheels, minus for an internal pair (Kudryavtsev).

    Arrays broadcast; ``sign`` as in `Mesh`, ``friction`` f is that of the teeth, 0.05 to 0.1 in oil [-].
    Raises `UsageError` if the friction leaves no efficiency.

    >>> mesh_efficiency(20, 60).round(6).item(), mesh_efficiency(20, 60, 1).round(6).item()
    (0.987733, 0.993867)
    """
    loss = SLIDING * friction * np.abs(1 / np.asarray(first) - np.asarray(sign) / np.asarray(second))
    worst = float(np.max(loss, initial=0.0))
    if friction < 0 or not worst < 1:
        raise UsageError(
            f"friction {friction:g} of the teeth takes {worst:.4g} of the power",
            where=WHERE,
            value=friction,
            remedy="a coefficient of 0.05 to 0.1 is usual in oil",
        )
    return 1 - loss


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
    return Phrase(
        "efficiencies of meshes are general values: {external:g}, of internal ones {internal:g}",
        external=usual.external,
        internal=usual.internal,
    )
