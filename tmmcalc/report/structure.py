"""The document of the structure stage."""

from __future__ import annotations

from tmmcalc.linkage.structure import ROMAN, Structure
from tmmcalc.report.document import Document, Fact, View


def structure_document(result: Structure, title: str) -> Document:
    """Mobility, structural formula, and one row a group."""
    n, p = result.links, result.joints
    roman = ROMAN.get(result.class_number, str(result.class_number))
    facts = (
        Fact(
            "mobility",
            f"W = 3n - 2p = 3*{n} - 2*{p} = {result.mobility}",
            {"mobility": result.mobility, "links": n, "joints": p},
        ),
        Fact("structural formula", result.formula, {"formula": result.formula}),
        Fact("class of the mechanism", roman, {"class_number": result.class_number}),
    )
    groups = result.groups
    view = View(
        ["group", "class", "order", "inner joints", "attachment points", "source chain"],
        [
            [g.name for g in groups],
            [ROMAN.get(g.class_number, str(g.class_number)) for g in groups],
            [g.order for g in groups],
            [" ".join(g.inner) for g in groups],
            [" ".join(g.outer) for g in groups],
            [" ".join(map(str, g.source)) for g in groups],
        ],
    )
    return Document(title, facts, (), view)
