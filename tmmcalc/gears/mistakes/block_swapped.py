"""The two wheels of a block are swapped: the teeth of 2 are taken for those of 2' and the other way round."""

from __future__ import annotations

from collections.abc import Sequence
from copy import deepcopy
from typing import Any

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables


def _parts(spec: Any) -> Sequence[str]:
    """The members of a written train that have two wheels of different teeth."""
    meshes = () if spec.gearing is None else spec.gearing.meshes
    teeth: dict[str, list[int]] = {}
    for mesh in meshes:
        teeth.setdefault(mesh.first, []).append(mesh.first_teeth)
        teeth.setdefault(mesh.second, []).append(mesh.second_teeth)
    return tuple(name for name, own in teeth.items() if len(own) == 2 and own[0] != own[1])


def _tables(document: Document, part: str) -> Tables:
    gearing = deepcopy(document.get("gearing", {}))
    ends = [
        (mesh, f"{end}_teeth")
        for mesh in gearing.get("meshes", ())
        for end in ("first", "second")
        if str(mesh[end]) == part
    ]
    if len(ends) != 2:
        return {}
    (one, first), (other, second) = ends
    one[first], other[second] = other[second], one[first]
    return {"gearing": gearing}


MISTAKE = Mistake(
    "the numbers of teeth of the two wheels of a block are swapped",
    "Which wheel of the block is in which mesh?",
    OFTEN,
    tables=_tables,
    parts=_parts,
)
