"""The documents of wanted paths: how far each is from its points, and the table with a row a point."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmmcalc.core.columns import Column
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import keyed
from tmmcalc.linkage.paths.columns import path_columns
from tmmcalc.linkage.paths.results import PathDeviation, Paths
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.positions import with_positions

ORDERS = {
    "along": "in their order, along the motion",
    "against": "in their order, against the motion",
    "none": "not in their order",
    None: "when they are prescribed",
}


def summary(result: Paths, title: str) -> Document:
    """Facts and notes, without the table."""
    return Document(title, tuple(_facts(result)), tuple(str(grade) for grade in result.grades))


def document(
    result: Paths,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """Summary and table; ``patterns`` choose columns, ``rows`` points by index, ``everything`` takes all rows."""
    told, available = summary(result, title), path_columns(result)
    return with_positions(
        told,
        result.labels,
        available,
        patterns,
        rows,
        example="phi,d*,distance",
        everything=everything,
        where=where,
        further=further,
    )


def _facts(result: Paths) -> Iterator[Fact]:
    whole = "of a whole turn of the crank" if result.closed else "over the analysed range of the input"
    yield Fact("paths", whole, keyed(result, "closed"))
    for path in result.paths:
        yield from _path_facts(result, path)
    error = keyed(result.error)
    text = f"distance {result.error.distance:.0e}, place {result.error.place:.0e}"
    yield Fact("error estimate", text, {"error": error})


def _path_facts(result: Paths, path: PathDeviation) -> Iterator[Fact]:
    places = {"path": path.name, "own": "rad" if result.turns else "m"}
    turned = "[deg]" if result.turns else ""
    at = f"phi = {_input(result, path.worst_at)}"
    text = f"rms {_mm(path.rms)} mm; greatest {_mm(path.largest)} mm, of point {path.worst} at {at}"
    values = keyed(path, "rms", "largest", "worst", f"worst_at{turned}", **places)
    yield Fact(Phrase("distance from path {name}", name=path.name), text, values)
    yield Fact(
        Phrase("sum of squares of {name}", name=path.name),
        f"{number(1e6 * path.total)} mm^2 over {path.count} point{'s' if path.count != 1 else ''}",
        keyed(path, "total", **places),
    )
    yield Fact(
        Phrase("path {name} meets its points", name=path.name),
        f"{ORDERS[path.order]}, over {_input(result, path.covered)} of the input",
        keyed(path, "ordered", f"covered{turned}", **places),
    )


def _mm(length: float) -> str:
    return number(1e3 * length)


def _input(result: Paths, x: float) -> str:
    return f"{angle(math.degrees(x))} deg" if result.turns else f"{number(x)} m"
