"""The losses of the meshes are left out: the efficiency of the train is 1 (textbook 4.6)."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables


def _tables(document: Document, part: str) -> Tables:
    gearing = document.get("gearing")
    if not gearing:
        return {}
    kept = {key: value for key, value in gearing.items() if key not in ("efficiency", "friction", "meshes")}
    meshes = [{**mesh, "efficiency": 1} for mesh in gearing.get("meshes", ())]
    return {"gearing": {**kept, **({"meshes": meshes} if meshes else {"efficiency": 1})}}


MISTAKE = Mistake(
    "the losses of the meshes are left out",
    "Does all the power that is put in come out of the train?",
    OFTEN,
    tables=_tables,
)
