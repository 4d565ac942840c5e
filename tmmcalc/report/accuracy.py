"""The document of a study of accuracy: error beside run time of every method, what is cheapest for a tolerance."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from tmmcalc.accuracy.study import Accuracy, Point, Series, Study
from tmmcalc.report.accuracyladder import ladder_document
from tmmcalc.report.document import Document, Fact, View

NUMBER = re.compile(r"[-+]?\d[\d.]*(?:e[-+]?\d+)?")  # in a reason: settings that fail alike differ in numbers alone
TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12)
TOLD = ("stage", "quantity", "method", "setting", "size", "error", "seconds", "evaluations", "order", "failed")


def accuracy_document(result: Accuracy, title: str, tolerance: float | None = None) -> Document:
    """One part a study: the reference, the cheapest method for ``tolerance`` (by default for four), all settings."""
    parts = tuple(_part(study, (tolerance,) if tolerance else TOLERANCES) for study in result.studies)
    parts += tuple(ladder_document(ladder) for ladder in result.ladders)
    facts = [Fact("studied", ", ".join(dict.fromkeys(study.stage for study in result.studies)) or "nothing")]
    if result.without:
        facts.append(Fact("one method only", ", ".join(result.without), {"one_method_only": list(result.without)}))
    return Document(title, tuple(facts), parts=parts)


def tidy_document(result: Accuracy, title: str) -> Document:
    """One table of all settings of all studies, for programs; what does not apply is empty."""
    rows = [
        (study.stage, study.quantity, series.method, point.setting, point.size, point.error, point.seconds,
         point.evaluations, series.order, point.failed)
        for study in result.studies
        for series in study.series
        for point in series.points
    ]  # fmt: skip
    columns = [["" if cell is None else cell for cell in column] for column in zip(*rows, strict=True)]
    return Document(title, table=View(TOLD, columns or [[] for _ in TOLD]))


def _part(study: Study, tolerances: Sequence[float]) -> Document:
    reference = Fact(
        "reference",
        f"{study.reference.name}, error {study.reference.error:.1e}",
        {"reference": study.reference.name, "reference_error": study.reference.error},
    )
    notes = [f"{series.method}: {series.note}" for series in study.series if series.note]
    notes += [note for series in study.series for note in _failures(series)]
    title = f"{study.stage}: {study.quantity}"
    return Document(title, (reference, *_cheapest(study, tolerances)), tuple(notes), _view(study.series))


def _failures(series: Series) -> Iterator[str]:
    """Why settings of a method gave no result, each reason once."""
    settings: dict[str, list[str]] = {}
    for point in series.points:
        if point.failed:
            settings.setdefault(NUMBER.sub("#", point.failed), []).append(point.setting)
    reasons = {NUMBER.sub("#", p.failed): p.failed for p in series.points if p.failed}
    for key, told in settings.items():
        many = f" (at {told[-1]})" if len(told) > 1 and "#" in key else ""
        yield f"{series.method}, {', '.join(told)}: {reasons[key]}{many}"


def _cheapest(study: Study, tolerances: Sequence[float]) -> Iterator[Fact]:
    """The cheapest method for every tolerance; tolerances with the same one stand in one line."""
    found = [(tolerance, study.cheapest(tolerance)) for tolerance in tolerances]
    for chosen, run in groupby(found, key=lambda item: item[1]):
        asked = [tolerance for tolerance, _ in run]
        values = {f"cheapest_{tolerance:.0e}": _choice(chosen) for tolerance in asked}
        label = f"cheapest for {asked[0]:.0e}" + (f" to {asked[-1]:.0e}" if len(asked) > 1 else "")
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


def called(series: Series, point: Point) -> str:
    """A method at a setting, in words."""
    return f"{series.method}, {point.setting}" if point.setting else series.method


def _time(seconds: float | None) -> str:
    return "" if seconds is None else f"{seconds * 1e3:.3g} ms"


def _view(all_series: Sequence[Series]) -> View:
    rows = [(series, point, k == 0) for series in all_series for k, point in enumerate(series.points)]
    counted = any(point.evaluations is not None for _, point, _ in rows)
    headers = ["method", "setting", "error", "time[ms]", *(["evaluations"] if counted else []), "order", "theory"]
    columns: list[list[str]] = [
        [series.method if first else "" for series, _, first in rows],
        [point.setting for _, point, _ in rows],
        ["failed" if point.error is None else f"{point.error:.1e}" for _, point, _ in rows],
        ["" if point.seconds is None else f"{point.seconds * 1e3:.3g}" for _, point, _ in rows],
        *([["" if p.evaluations is None else str(p.evaluations) for _, p, _ in rows]] if counted else []),
        list(_orders(rows)),
        [_order(series.expected) if first else "" for series, _, first in rows],
    ]
    return View(headers, columns)


def _orders(rows: Sequence[tuple[Series, Point, bool]]) -> Iterator[str]:
    for series, _, first in rows:
        yield _order(series.order) if first else ""


def _order(value: float | None) -> str:
    return "" if value is None else f"{value:.3g}"
