"""The documents of the train stage: of every variant what was asked, what the constraints removed, the tooth sets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.quantity import Quantity
from tmmcalc.gears.advice import called, remedies, removals, why_none
from tmmcalc.gears.bounds import step_bounds
from tmmcalc.gears.columns import ANGLE, ASSEMBLY, COPRIME, GAP, STEP, TEXTBOOK, set_columns, stacked
from tmmcalc.gears.model import Interval, TrainTask
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.trains import Request, Trains, Variant
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

RATIO_KIND = Quantity("ratio_kind", "which ratio is asked for")
RATIO = Quantity("ratio", "ratio that is asked for")
RATIO_EXACT = Quantity("ratio_exact", "ratio that is asked for, exactly")
RATIO_OF = Quantity("ratio_of", "where the ratio comes from")
LEAST, LARGEST = Quantity("z_min", "least number of teeth"), Quantity("z_max", "largest number of teeth")
LEAST_RING = Quantity("ring_min", "least number of teeth of a ring")
LARGEST_RING = Quantity("ring_max", "largest number of teeth of a ring")
COUNT, HELD = Quantity("count", "tooth sets that are found"), Quantity("held", "tooth sets that are kept in the table")
PLANETS = Quantity("planets", "number of planets")
# steps of the textbook's search
BY_TEETH = Quantity("e_min_teeth", "least step e by the least number of teeth")
FIRST, LAST = Quantity("e_first", "first step e that is tried"), Quantity("e_max", "largest step e")
BY_NEIGHBOURS = Quantity("e_min_neighbours", "least step e at which planets pass each other")
BY_NEIGHBOURS_BOOK = Quantity(
    "e_min_neighbours_textbook", "least step e at which planets pass each other, by the textbook's formula"
)
ROWS, FEW = 20, 5  # rows of the table; of the summary of a whole run
LISTED = 6  # proportions of modules that are named one by one

LEGEND = {
    "m_1:m_2": "m_1:m_2 modules of the stages",
    ASSEMBLY.key: "assembly the whole number of its condition",
    GAP.key: GAP.meaning,
    ANGLE.key: f"{ANGLE.name} {ANGLE.meaning}",
    STEP.key: STEP.meaning,
    TEXTBOOK.key: "textbook whether its stepping finds the set",
}


def summary(result: Trains, title: str) -> Document:
    """Facts, notes and the first few sets of every variant; of several variants each is a part."""
    return document(result, title, rows=FEW)


def document(result: Trains, title: str, *, rows: int = ROWS, everything: bool = False) -> Document:
    """Facts, notes and the first ``rows`` sets of every variant; with ``everything`` all sets in one table instead."""
    shown = 0 if everything else rows
    parts = tuple(_variant_document(variant, shown) for variant in result.variants)
    document = replace(parts[0], title=title) if len(parts) == 1 else Document(title, parts=parts)
    if not everything:
        return document
    return replace(document, table=_view(stacked(result, words=False)))


def _variant_document(variant: Variant, rows: int) -> Document:
    view = _shown(variant, rows) if rows and len(variant.sets) else None
    facts = (
        *_task_facts(variant.request),
        *_removal_facts(variant),
        *_set_facts(variant, rows),
        *([] if view is None else [_legend_fact(view, variant.request.scheme)]),
    )
    more = "--format csv prints all of them"
    return Document(variant.request.title, facts, tuple(_notes(variant)), view, wide=True, more=more)


def _task_facts(request: Request) -> Iterator[Fact]:
    """Layout, ratio, limits of teeth, modules."""
    task, scheme = request.task, request.scheme
    called = f" ({scheme.designation})" if scheme.planetary and scheme.designation != scheme.key else ""
    values: dict[str, Any] = {"layout": scheme.key}
    if scheme.branched:
        values[PLANETS.key] = task.planets
    yield Fact("layout", f"{scheme.key}{called}: {scheme.title}", values)
    yield Fact("ratio", *_ratio(request))
    limits = task.limits
    text = f"{limits.least} to {limits.largest}"
    values = {LEAST.key: limits.least, LARGEST.key: limits.largest}
    if not scheme.branched:
        text += f", pinions to {limits.largest_pinion}"
        values["z_pinion_max"] = limits.largest_pinion
    if scheme.rings:
        text += f", rings {limits.least_ring} to {limits.largest_ring}"
        values |= {LEAST_RING.key: limits.least_ring, LARGEST_RING.key: limits.largest_ring}
    if limits.largest_sum is not None:
        text += f", Z1 + Z2 to {limits.largest_sum}"
        values["sum_max"] = limits.largest_sum
    if task.teeth is not None:
        text, values = f"{', '.join(map(str, task.teeth))} as given; no others are sought", {"teeth": list(task.teeth)}
    yield Fact("numbers of teeth", text, values)
    if scheme.branched and scheme.stages > 1:
        yield _modules_fact(task.proportions)
    if scheme.stepped and len(task.proportions) == 1:
        yield _steps_fact(task)


def _steps_fact(task: TrainTask) -> Fact:
    """The textbook's bounds of e for the one proportion of modules; the search does not rest on them."""
    mu1, mu2 = task.proportions[0]
    bounds = step_bounds(task, (mu1, mu2))
    values: dict[str, Any] = {BY_TEETH.key: bounds.teeth.root, FIRST.key: bounds.first, LAST.key: bounds.largest}
    text = f"from {bounds.first} to {number(bounds.largest, 4)}: by teeth {number(bounds.teeth.root, 6)}"
    if bounds.neighbours is not None and bounds.neighbours_book is not None:
        values[BY_NEIGHBOURS.key] = bounds.neighbours.root
        values[BY_NEIGHBOURS_BOOK.key] = bounds.neighbours_book.root
        own, book = (number(part.root, 6) for part in (bounds.neighbours, bounds.neighbours_book))
        text += f", by neighbours {own} (textbook {book})"
    if not bounds.compatible:
        text += "\nnone is left: fewer planets, or larger wheels"
    return Fact("step e", text, values)


def _ratio(request: Request) -> tuple[str, dict[str, Any]]:
    """The ratio as it was asked for, and the tooth ratios that this admits."""
    kind, nominal = request.kind, float(request.nominal)
    text = f"{kind} = {number(nominal, 10)}, {_interval(request.admitted)} admitted"
    values = {
        RATIO_KIND.key: kind,
        RATIO.key: nominal,
        RATIO_EXACT.key: str(request.nominal),
        "ratio_admitted": _ends(request.admitted),
    }
    if request.origin:
        text += f"\n{request.origin}"
        values[RATIO_OF.key] = request.origin
    if kind not in ("u", "i_14"):
        text += f"\nU = {number(float(request.task.nominal), 10)}, {_interval(request.task.ratio)}"
        values["U_admitted"] = _ends(request.task.ratio)
    return text, values


def _interval(interval: Interval) -> str:
    return f"{number(float(interval.low), 10)} to {number(float(interval.high), 10)}"


def _ends(interval: Interval) -> list[float]:
    return [float(interval.low), float(interval.high)]


def _modules_fact(proportions: tuple[tuple[int, ...], ...]) -> Fact:
    named = [":".join(map(str, each)) for each in proportions]
    text = ", ".join(named)
    if len(named) > LISTED:
        text = f"{len(named)} proportions, {named[0]} to {named[-1]}"
    return Fact("modules m_1:m_2", text, {"module_ratios": [list(each) for each in proportions]})


def _removal_facts(variant: Variant) -> Iterator[Fact]:
    """The candidates, and what each constraint removed of those that came to it."""
    synthesis = variant.synthesis
    steps = removals(variant)
    by_program = variant.request.method == "textbook"
    what = "found by the textbook's program" if by_program else "combinations of wheels"
    if variant.request.task.teeth is not None:
        what = "of the given teeth, one a proportion of modules"
    yield Fact(
        "candidates",
        f"{synthesis.candidates} {what}",
        {"candidates": synthesis.candidates, "removed": {name: removed for name, removed, _ in steps}},
    )
    for name, removed, left in steps:
        yield Fact(f"- {called(name)}", f"removed {removed} of {left}")


def _set_facts(variant: Variant, rows: int) -> Iterator[Fact]:
    """How many sets there are, and how many of them are held, coprime, in the textbook's way, in the table."""
    synthesis, held = variant.synthesis, len(variant.sets)
    values: dict[str, Any] = {COUNT.key: synthesis.count, HELD.key: held}
    if not held:
        yield Fact("tooth sets", "none", values)
        return
    columns = set_columns(variant)
    of_them = "" if synthesis.complete else f" of the {held} held"
    lines = [f"{synthesis.count}"]
    for header, words in ((COPRIME.key, "with coprime meshes"), (TEXTBOOK.key, "found by the textbook's stepping")):
        if header in columns:
            values[header] = int(np.count_nonzero(columns[header]))
            lines.append(f"{values[header]}{of_them} {words}")
    yield Fact("tooth sets", "\n".join(lines), values)
    if 0 < rows < held:
        yield Fact("rows", f"the first {rows} of {held} by Z1 + Z2; --rows for more, --format csv for all")


def _shown(variant: Variant, rows: int) -> View:
    """The first rows, the proportion of modules in one column."""
    columns: dict[str, np.ndarray] = {}
    every = {header: column[:rows] for header, column in set_columns(variant).items()}
    for header, column in every.items():
        if header == "mu_1":
            pairs = zip(column.tolist(), every["mu_2"].tolist(), strict=True)
            columns["m_1:m_2"] = np.array([f"{first}:{second}" for first, second in pairs])
        elif header != "mu_2":
            columns[header] = column
    return _view(columns)


def _view(columns: dict[str, np.ndarray]) -> View:
    return View(list(columns), [column.tolist() for column in columns.values()])


def _legend_fact(view: View, scheme: Layout) -> Fact:
    """What stands in the table."""
    lines = [text for header, text in LEGEND.items() if header in view.headers]
    if scheme.paired and GAP.key in view.headers:
        lines.append("gap at the operating centre distances; tested by (8) at those of the rack, which are smaller")
    return Fact("in the table", "\n".join(["error of the ratio against the one asked for", *lines]))


def _notes(variant: Variant) -> Iterator[str]:
    """What is unusual, what is not held, and where there is nothing what would help."""
    request, synthesis = variant.request, variant.synthesis
    for remark in request.remarks:
        yield Phrase("warning: {title}: {remark}", title=request.title, remark=remark)
    if not synthesis.count:
        yield Phrase(
            "warning: {why}; what would help: {remedies}",
            why=listed(why_none(variant), "; "),
            remedies=listed(remedies(variant), "; "),
        )
    if not synthesis.complete:
        text = "note: the {sets} sets with the least Z1 + Z2 are held, {count} are counted; a larger keep holds more"
        yield Phrase(text, sets=len(variant.sets), count=synthesis.count)
