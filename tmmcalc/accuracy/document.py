"""The document of a study of accuracy: error beside run time of every method, what is cheapest for a tolerance."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import fields
from itertools import groupby
from typing import Any

from tmmcalc.accuracy.ladder_document import ladder_document, ladder_rows
from tmmcalc.core.studies.study import Accuracy, Point, Series, Study
from tmmcalc.report.document import Document, Fact, View

NUMBER = re.compile(r"[-+]?\d[\d.]*(?:e[-+]?\d+)?")  # in a reason: settings that fail alike differ in numbers alone
TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12)
ERROR = "error"
TOLD = (
    "stage", "quantity", "reference", "reference_error", "method", "setting", "size", "error", "seconds", "runs",
    "count", "order", "theory", "failed", "cheapest",
)  # fmt: skip


def accuracy_document(result: Accuracy, title: str, tolerance: float | None = None) -> Document:
    """One part a study: the reference, the cheapest method for ``tolerance`` (by default for four), all settings."""
    parts = tuple(_part(study, _asked(tolerance)) for study in result.studies)
    parts += tuple(ladder_document(ladder) for ladder in result.ladders)
    stages = [study.stage for study in result.studies] + [ladder.stage for ladder in result.ladders]
    facts = [_listed("studied", dict.fromkeys(stages))]
    facts += [_listed(label, names) for label, names in _unstudied(result) if names]
    return Document(title, tuple(facts), parts=parts)


def _asked(tolerance: float | None) -> Sequence[float]:
    return TOLERANCES if tolerance is None else (tolerance,)


def told(tolerance: float) -> str:
    """A tolerance with as many digits as it has.

    >>> told(1e-6), told(1.44e-6)
    ('1e-06', '1.44e-06')
    """
    return next(text for digits in range(17) if float(text := f"{tolerance:.{digits}e}") == tolerance)


def _unstudied(result: Accuracy) -> Iterator[tuple[str, Sequence[str]]]:
    yield "one method only", result.without
    yield "no choice in this scene", result.settled
    yield "without a result", tuple(result.failures)


def _listed(label: str, names: Iterable[str]) -> Fact:
    stages = list(names)
    return Fact(label, ", ".join(stages) or "nothing", {label.replace(" ", "_"): stages})


def tidy_document(result: Accuracy, title: str, tolerance: float | None = None) -> Document:
    """One table of all settings of all studies and ladders, for programs; what does not apply is empty."""
    rows = [row for study in result.studies for row in _rows(study, _asked(tolerance))]
    rows += [row for ladder in result.ladders for row in ladder_rows(ladder)]
    columns = [["" if cell is None else cell for cell in column] for column in zip(*rows, strict=True)]
    return Document(title, table=View(TOLD, columns or [[] for _ in TOLD]))


def _rows(study: Study, tolerances: Sequence[float]) -> Iterator[tuple[Any, ...]]:
    """Rows for programs; the last cell names the tolerances for which the row is the cheapest."""
    found = [(told(tolerance), study.cheapest(tolerance)) for tolerance in tolerances]
    for series in study.series:
        for point in series.points:
            best = " ".join(name for name, chosen in found if chosen is not None and chosen[1] is point)
            yield (
                study.stage, study.quantity, study.reference.name, study.reference.error, series.method, point.setting,
                point.size, point.error, point.seconds, point.runs, point.count, series.order, series.expected,
                point.failed, best,
            )  # fmt: skip


def _part(study: Study, tolerances: Sequence[float]) -> Document:
    reference = Fact(
        "reference",
        f"{study.reference.name}, error {study.reference.error:.1e}",
        {
            "reference": study.reference.name,
            "reference_error": study.reference.error,
            "methods": [plain(series) | {"points": list(map(plain, series.points))} for series in study.series],
        },
    )
    notes = [f"{series.method}: {series.note}" for series in study.series if series.note]
    notes += [note for series in study.series for note in _failures(series)]
    title = f"{study.stage}: {study.quantity}"
    facts = (reference, *_cheapest(study, tolerances), *_never(study, tolerances))
    return Document(title, facts, tuple(notes), _view(study.series))


def plain(row: Series | Point) -> dict[str, Any]:
    """The fields of a record that say something, by name."""
    values = {field.name: getattr(row, field.name) for field in fields(row)}
    return {name: value for name, value in values.items() if value not in (None, "")}


def _failures(series: Series) -> Iterator[str]:
    """Why settings of a method gave no result, each reason once."""
    settings: dict[str, list[str]] = {}
    for point in series.points:
        if point.failed:
            settings.setdefault(NUMBER.sub("#", point.failed), []).append(point.setting)
    reasons = {NUMBER.sub("#", p.failed): p.failed for p in series.points if p.failed}
    for key, failing in settings.items():
        many = f" (at {failing[-1]})" if len(failing) > 1 and "#" in key else ""
        yield f"{', '.join(filter(None, (series.method, *failing)))}: {reasons[key]}{many}"


def _cheapest(study: Study, tolerances: Sequence[float]) -> Iterator[Fact]:
    """The cheapest method for every tolerance; tolerances with the same one stand in one line."""
    found = [(tolerance, study.cheapest(tolerance)) for tolerance in tolerances]
    for chosen, run in groupby(found, key=lambda item: item[1]):
        asked = [tolerance for tolerance, _ in run]
        values = {f"cheapest_{told(tolerance)}": _choice(chosen) for tolerance in asked}
        label = f"cheapest for {told(asked[0])}" + (f" to {told(asked[-1])}" if len(asked) > 1 else "")
        if chosen is None:
            yield Fact(label, "none reaches it", values)
        else:
            series, point = chosen
            yield Fact(label, f"{called(series, point)}: error {point.error:.1e} in {_time(point.seconds)}", values)


def _choice(found: tuple[Series, Point] | None) -> dict[str, object] | None:
    if found is None:
        return None
    series, point = found
    return {"method": series.method, "setting": point.setting, "error": point.error, "seconds": point.seconds}


def _never(study: Study, tolerances: Sequence[float]) -> Iterator[Fact]:
    """The methods that keep no tolerance so tight at any setting, each at the loosest that it misses."""
    missing = {series.method: series for series in study.series}
    for tolerance in sorted(tolerances, reverse=True):
        missed = [series for series in missing.values() if series.cheapest(tolerance) is None]
        if not missed:
            continue
        text = "\n".join(f"{series.method}: {_least(series, tolerance)}" for series in missed)
        least = {series.method: series.best.error if series.best else "no result" for series in missed}
        values = {f"never_{told(tolerance)}": least}
        yield Fact(f"never {told(tolerance)}", text, values)
        for series in missed:
            del missing[series.method]


def _least(series: Series, tolerance: float) -> str:
    if series.best is None:
        return "no result"
    chance = ", by chance: finer ones miss it" if (series.best.error or 0.0) <= tolerance else ""
    return f"{series.best.error:.1e} at best" + (f", {series.best.setting}" if series.best.setting else "") + chance


def called(series: Series, point: Point) -> str:
    """A method at a setting, in words."""
    return f"{series.method}, {point.setting}" if point.setting else series.method


def _time(seconds: float | None) -> str:
    return "" if seconds is None else f"{seconds * 1e3:.3g} ms"


def _view(all_series: Sequence[Series]) -> View:
    rows = [(series, point, k == 0) for series in all_series for k, point in enumerate(series.points)]
    columns: dict[str, list[float | int | str]] = {
        "method": [series.method if first else "" for series, _, first in rows],
        "setting": [point.setting for _, point, _ in rows],
        ERROR: ["failed" if point.error is None else point.error for _, point, _ in rows],
        "time[ms]": ["" if point.seconds is None else f"{point.seconds * 1e3:.3g}" for _, point, _ in rows],
        "count": ["" if point.count is None else point.count for _, point, _ in rows],
        "order": [_order(series.order) if first else "" for series, _, first in rows],
        "theory": [_order(series.expected) if first else "" for series, _, first in rows],
    }
    shown = {name: cells for name, cells in columns.items() if any(cell != "" for cell in cells)}
    return View(list(shown), list(shown.values()), scientific=[ERROR])


def _order(value: float | None) -> str:
    return "" if value is None else f"{value:.3g}"
