"""The document of the structure stage."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from tmmcalc.core.quantity import keyed, table
from tmmcalc.linkage.structure import ROMAN, Structure
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

if TYPE_CHECKING:
    from tmmcalc.linkage.listing import Listing


def summary(result: Structure, title: str) -> Document:
    """Mobility, structural formula, and one row a group."""
    n, p = result.links, result.joints
    roman = ROMAN.get(result.class_number, str(result.class_number))
    facts = (
        Fact(
            "mobility",
            f"W = 3n - 2p = 3*{n} - 2*{p} = {result.mobility}",
            keyed(result, "mobility", "links", "joints"),
        ),
        Fact("structural formula", result.formula, keyed(result, "formula")),
        Fact("class of the mechanism", roman, keyed(result, "class_number")),
        *named_links(result),
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


def named_links(result: Structure) -> list[Fact]:
    """The numbers of the links that columns carry, with the names that the spec gives them."""
    if not result.names:
        return []
    text = ", ".join(f"{number} {name}" for number, name in result.names.items())
    return [Fact("links", text, keyed(result, "names"))]


def assemblies_document(listing: Listing, structure: Structure, title: str, *, everything: bool = False) -> Document:
    """All assemblies of every group, one row each, with the places of their points.

    ``everything`` writes values for programs: numbers, truth values, two columns a point [m].
    """
    from tmmcalc.linkage.listing import GroupAssembly

    place = f"{number(math.degrees(listing.x))} deg" if listing.turns else f"{number(listing.x)} m"
    counts = {group.name: sum(one.group == group.name for one in listing.assemblies) for group in structure.groups}
    at = keyed(listing, "x[deg]", unit="rad") if listing.turns else keyed(listing, "x", unit="m")
    facts = (
        Fact("structural formula", structure.formula, keyed(structure, "formula")),
        Fact("at the input coordinate", place, at),
        Fact("assemblies", ", ".join(f"{name} {count}" for name, count in counts.items()), {"assemblies": counts}),
    )
    notes = []
    if listing.undecided:
        notes.append(
            f"{listing.undecided}: {listing.reason}: groups after it are not listed; "
            "sketch its points in assembly.sketch, or give its variant in assembly.variants"
        )
    rows = listing.assemblies
    if everything:
        from tmmcalc.linkage.columns import POINT

        columns = table(rows, GroupAssembly, "group", "variant", "taken", "regularity", "determinant")
        for name in dict.fromkeys(name for one in rows for name in one.points):
            places = [one.points.get(name) for one in rows]
            for axis, part in (("x", "real"), ("y", "imag")):
                key = POINT[0].of(axis=axis, point=name, length="m").key
                columns[key] = [None if z is None else getattr(z, part) for z in places]
        return Document(title, facts, tuple(notes), View(list(columns), list(columns.values())))
    size = max((abs(z) * 1e3 for one in rows for z in one.points.values()), default=0.0)
    view = View(
        list(table((), GroupAssembly, "group", "variant", "taken", "regularity", "determinant", "points[mm]")),
        [
            [one.group for one in rows],
            [f"{one.variant:+d}" if one.determinant is None else str(one.variant) for one in rows],
            ["*" if one.taken else "" for one in rows],
            [one.regularity for one in rows],
            ["" if one.determinant is None else number(one.determinant) for one in rows],
            [_places(one.points, size) for one in rows],
        ],
    )
    return Document(title, facts, tuple(notes), view)


def _places(points: dict[str, complex], size: float) -> str:
    """Points with their coordinates in millimetres; what is noise against ``size`` is zero."""
    told = ((name, *(number(part * 1e3, 6, peak=size) for part in (z.real, z.imag))) for name, z in points.items())
    return "  ".join(f"{name} ({x}, {y})" for name, x, y in told)
