"""What is checked of a pair of gears: the table of conditions, the warnings, what programs get of both."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from tmmcalc.core.notes import Note, Phrase, listed
from tmmcalc.core.quantity import Quantity, keyed
from tmmcalc.gears.facts.meshes import known, renamed
from tmmcalc.gears.involute.quality.verdicts import Check, worst
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

VERDICTS = {"ok": "ok", "warn": "warning", "fail": "fails"}
ANGLES = ("pressure angle",)
MARGIN = Quantity("margin[m]", "what is left to the limit, a length")
PLACES = 4  # decimals that people read
PURE = ("sliding", "pressure")  # numbers without a unit, as are all ratios; what is left are lengths in modules


def unit_of(check: Check) -> str:
    """Unit of the numbers of a check: rad, module, or 1."""
    if check.name in ANGLES:
        return "rad"
    return "1" if check.name in PURE or check.name.endswith("ratio") else "module"


def checks_document(found: MeshPair) -> Document:
    """The table of a pair for people."""
    return judged_document(found.checks, found.task.module, lambda wheel: _named(found, wheel))


def judged_document(checks: Sequence[Check], module: float, named: Callable[[int], str]) -> Document:
    """The table for people: angles in degrees, lengths in modules, their margins in millimetres too."""
    legend = "lengths in normal modules, angles in degrees; margin: what is left to the limit"
    return Document("checks", (Fact("in the table", legend),), (), _view(checks, module, named))


def _view(checks: Sequence[Check], module: float, named: Callable[[int], str]) -> View:
    margin, factor_mm = MARGIN.shown("mm")
    columns: dict[str, list[Any]] = {
        name: [] for name in ("check", "wheel", "value", "limit", "margin", margin, "verdict")
    }
    for check in checks:
        unit = unit_of(check)
        factor = math.degrees(1.0) if unit == "rad" else 1.0
        judged = check.limit is not None
        in_mm = factor_mm * module * check.margin
        row = (
            f"{check.name}, deg" if unit == "rad" else check.name,
            named(check.wheel),
            round(factor * check.value, PLACES),
            "" if check.limit is None else round(factor * check.limit, PLACES),
            round(factor * check.margin, PLACES) if judged else "",
            f"{_settled(in_mm):.3f}" if judged and unit == "module" else "",
            VERDICTS[check.verdict] if judged or check.verdict != "ok" else "not judged",
        )
        for cells, cell in zip(columns.values(), row, strict=True):
            cells.append(cell)
    return View(list(columns), list(columns.values()))


def _named(found: MeshPair, wheel: int) -> str:
    """Whose check it is; empty: the pair's."""
    if wheel == 2 and found.task.kind == "rack":
        return "rack"
    return found.task.wheels[wheel - 1] if wheel else ""


def _settled(value: float) -> float:
    """Without the sign of a zero."""
    return round(value, 3) + 0.0


def checks_values(found: MeshPair) -> list[dict[str, Any]]:
    """The checks of a pair for programs."""
    wheels = found.task.wheels
    return judged_values(found.checks, lambda wheel: _named(found, wheel), lambda text: renamed(text, wheels))


def judged_values(
    checks: Sequence[Check], named: Callable[[int], str], said: Callable[[str], str]
) -> list[dict[str, Any]]:
    """The checks for programs, lengths in modules, angles in radians."""
    return [
        known(
            {
                **keyed(check, "name"),
                "wheel": named(check.wheel) or None,
                **keyed(check, "value", "limit"),
                "margin": check.margin if check.limit is not None else None,
                "unit": unit_of(check),
                **keyed(check, "verdict"),
                "text": said(check.text) or None,
            }
        )
        for check in checks
    ]


def verdict_fact(checks: Sequence[Check]) -> Fact:
    """All checks in one line."""
    judged = [check.verdict for check in checks if check.limit is not None or check.verdict != "ok"]
    failed, unusual = judged.count("fail"), judged.count("warn")
    if failed:
        text = f"cannot work: {failed} of {len(judged)} conditions fail"
    elif unusual:
        text = f"works; {unusual} of {len(judged)} conditions not as recommended"
    else:
        text = f"good: all {len(judged)} conditions are kept"
    return Fact("verdict", text, {"verdict": worst(tuple(checks))})


def check_note(check: Check, text: str) -> Note:
    """The warning of a condition that is not kept, in the words of ``text``."""
    unit = "rad" if check.name in ANGLES else ""
    place = "cannot work" if check.verdict == "fail" else ""
    return Note("warning", text, place, check.value, check.limit, unit, check.name)


def pair_notes(found: MeshPair) -> Iterator[Note]:
    """What fails, what is not recommended, how far the nearest good shifts are, what the choice had to give up."""
    wheels = found.task.wheels
    for check in sorted(found.checks, key=lambda check: check.verdict != "fail"):
        if check.verdict != "ok":
            yield check_note(check, renamed(check.text, wheels))
    if found.broken:
        lines = listed([renamed(each, wheels) for each in found.broken], "; ")
        text = Phrase("the shifts lie outside the blocking contour: {lines}", lines=lines)
        if found.nearest is not None:
            x1, x2 = found.nearest
            text = Phrase(
                "{text}; the nearest inside are x1 = {x1}, x2 = {x2}",
                text=text,
                x1=number(x1, 5),
                x2=number(x2, 5),
            )
        yield Note("warning", text)
    if found.note:
        yield Note("note", renamed(found.note, wheels))
