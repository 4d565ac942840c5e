"""The document of a class that was made: how many variants, what was refused, how far apart they are, their spread."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.classroom.keying import told_of
from tmmcalc.classroom.making import Made
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number


def class_document(made: Made, title: str) -> Document:
    """What was drawn now, with a row for each asked result; the candidates that were refused, by demand.

    And the mistakes that cannot be seen in some answers of many variants, as the right ones come out with them.
    """
    refused = (Document("refused", table=_refused(made)),) if made.refused else ()
    unseen = (Document("right with a mistake in many variants", table=_unseen(made)),) if made.own.unavoided else ()
    return Document(title, tuple(_facts(made)), tuple(_notes(made)), _spread(made), parts=(*refused, *unseen))


def _facts(made: Made) -> Iterator[Fact]:
    count, fresh = len(made.own.variants), len(made.fresh)
    of_them = "" if fresh == count else f", {fresh} of them now"
    yield Fact("variants", f"{count}{of_them}", {"variants": count, "drawn_now": fresh})
    named = sum(bool(each.student) for each in made.own.variants)
    if named:
        yield Fact("students", str(named), {"students": named})
    yield Fact("seed", str(made.own.seed), {"seed": made.own.seed})
    tried = fresh + sum(made.refused.values())
    if tried:
        yield Fact(
            "candidates", f"{tried}, {tried - fresh} of them refused", {"tried": tried, "refused": tried - fresh}
        )
    if not math.isnan(made.least):
        text = f"{100 * made.least:.3g} % of the ranges of what is drawn, in the mean"
        yield Fact("least distance", text, {"least_distance": made.least})


def _notes(made: Made) -> Iterator[str]:
    for at, item in enumerate(made.items):
        values = [each.values[at] for each in made.fresh]
        if len(values) > 1 and max(values) - min(values) <= item.tolerance * max(map(abs, values)):
            yield f"note: {item.name} is the same in all variants that were drawn now, within its tolerance"


def _spread(made: Made) -> View | None:
    """A row for each asked result of the variants that were drawn now."""
    if not made.fresh:
        return None
    rows = []
    for at, (item, factor) in enumerate(zip(made.items, made.factors, strict=True)):
        sizes = [abs(each.values[at]) for each in made.fresh]
        ratio = max(sizes) / min(sizes) if min(sizes) > 0 else math.nan
        values = [each.values[at] * factor for each in made.fresh]
        rows.append((item.name, item.unit, min(values), max(values), "" if math.isnan(ratio) else number(ratio, 3)))
    headers = ("asked", "unit", "least", "greatest", "spread")
    return View(headers, [*map(list, zip(*rows, strict=True))])


def _refused(made: Made) -> View:
    return View(("candidates", "refused by"), [[*made.refused.values()], [*made.refused]])


def _unseen(made: Made) -> View:
    """A row for each mistake: the asked results that are right with it, within tolerance."""
    found: dict[str, list[str]] = {}
    for item, mistake in made.own.unavoided or ():
        found.setdefault(mistake, []).append(item)
    return View(
        ("mistake", "right"),
        [[told_of(mistake).title for mistake in found], [", ".join(items) for items in found.values()]],
    )
