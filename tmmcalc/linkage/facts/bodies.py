"""The document of free bodies: what acts on every link, and the equation of its moments with the terms."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.quantity import Quantity, keyed, table
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces, side_of
from tmmcalc.linkage.moments import EquilibriumTerm, LinkEquilibrium, equilibria
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

POSITION = Quantity("i", "number of the position").key
SHOWN = 1e-9  # of the largest moment of a link: a smaller term is not worded


def bodies_document(statics: Statics, result: Forces, title: str, rows: Sequence[int]) -> Document:
    """The links in rows of the result by their indices, one row a force or couple."""
    some = [*dict.fromkeys(rows)]
    sides = np.array([side_of(result, row) for row in some])
    found = dict(zip(some, equilibria(statics, result.theta[some], sides), strict=True))
    facts = tuple(_moments(result.labels[row], each) for row, links in found.items() for each in links)
    labels = [result.labels[row] for row, links in found.items() for each in links for _ in each.terms]
    terms = [term for links in found.values() for each in links for term in each.terms]
    columns = {POSITION: labels, **table(terms, EquilibriumTerm)}
    columns = {key: ["" if cell is None else cell for cell in cells] for key, cells in columns.items()}
    return Document(title, facts, table=View([*columns], [*columns.values()]), wide=True, more="--format csv has them")


def _moments(label: str, found: LinkEquilibrium) -> Fact:
    """The equation of the moments on a link."""
    largest = max((abs(term.moment) for term in found.terms), default=0.0)
    parts = [
        f"{'-' if term.moment < 0 else '+'} {number(abs(term.moment), 6)} ({term.name})"
        for term in found.terms
        if abs(term.moment) > SHOWN * largest
    ]
    text = " ".join(parts).removeprefix("+ ") or "no moment"
    values = {"about": found.about, **keyed(found, "force_left", "moment_left")}
    where = f"link_{found.link}_in_{label}"
    return Fact(
        f"link {found.link} about {found.about}, {label}", f"{text}{' = 0 N*m' if parts else ''}", {where: values}
    )
