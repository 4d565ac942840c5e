"""The documents of the synthesis: sizes of the best solution, its post-check, defects, and all solutions in a table."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmmcalc.core.columns import picked
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, keyed
from tmmcalc.linkage.synthesis.columns import columns
from tmmcalc.linkage.synthesis.results import SAME, Check, Design, Precision, Size, StrokeTimes, Synthesis, check_key
from tmmcalc.report.document import Document, Fact, View, angles_in_degrees
from tmmcalc.report.numbers import angle, number

ANGLE = math.degrees(1.0)
FEW = 10  # points that are listed for people


def summary(result: Synthesis, title: str) -> Document:
    """Sizes of the best solution, its checks and warnings, and its merits unless the stage's table has them."""
    best = result.best
    merits = () if best.dwell is None else _merit_facts(best)
    facts = (_kind_fact(result), *_size_facts(best.sizes), *map(_check_fact, best.checks), *merits)
    warnings = tuple(note for note in result.notes if note.startswith("warning"))
    return angles_in_degrees(Document(title, facts, warnings))


def document(
    result: Synthesis, title: str, *, choose: int = 1, patterns: Sequence[str] = (), everything: bool = False
) -> Document:
    """Solution ``choose`` in full, all of them in the table; ``patterns`` choose its columns by name."""
    design = result.designs[choose - 1]
    facts = tuple(_facts(result, design, choose))
    if design.dwell is not None:
        from tmmcalc.linkage.facts.dwell import dwell_table

        table = dwell_table(design.dwell, patterns, everything)
    else:
        table = _table(result, patterns, everything)
    return angles_in_degrees(Document(title, facts, result.notes, table, wide=not patterns))


def _facts(result: Synthesis, design: Design, choose: int) -> Iterator[Fact]:
    yield _kind_fact(result)
    count = len(result.designs)
    shown = f"{choose} of {count}, {design.name}" if count > 1 else design.name
    yield Fact("solution", shown, {"solution": choose, "solutions": count} | keyed(design, "name"))
    yield Fact("chosen by", result.rule, keyed(result, "rule"))
    yield from _size_facts(design.sizes)
    if design.times is not None:
        yield from _time_facts(design.times)
    for found in design.checks:
        yield _check_fact(found)
    yield from _merit_facts(design)
    if design.precision is not None:
        yield _sense_fact(design.precision)
        yield _precision_fact(design.precision)
    if design.dwell is not None:
        from tmmcalc.linkage.facts.dwell import dwell_facts

        yield from dwell_facts(design.dwell)
    defects = "\n".join(design.defects) or "none"
    yield Fact("defects", defects, keyed(design, "defects"))
    yield Fact("residual", f"{result.residual:.0e}", keyed(result, "residual"))
    if result.counters:
        text = ", ".join(
            f"{value} {name if value != 1 else name.removesuffix('s')}" for name, value in result.counters.items()
        )
        yield Fact("search", text, keyed(result, "counters"))


def _merit_facts(design: Design) -> Iterator[Fact]:
    for name, value in design.merits.items():
        told = Quantity(name, "")
        unit, factor = ("mm", 1e3) if told.unit == "m" else (told.unit, 1.0)
        yield Fact(told.name.replace("_", " "), f"{number(factor * value, 6)} {unit}".strip(), {name: value})


def _kind_fact(result: Synthesis) -> Fact:
    return Fact("synthesis", result.kind.replace("_", " "), keyed(result, "kind"))


def shown(value: float, unit: str) -> str:
    """A size for people: mm, deg, or a number."""
    if unit == "rad":
        return f"{angle(value * ANGLE)} deg"
    return f"{number(1e3 * value, 7)} mm" if unit == "m" else number(value, 7)


def _size_facts(sizes: Sequence[Size]) -> Iterator[Fact]:
    meanings: list[str] = []
    for size in sizes:
        meanings.append(meanings[-1] if size.meaning == SAME else size.meaning)
    for size, meaning in zip(sizes, meanings, strict=True):
        alone = meanings.count(meaning) == 1
        said = meaning if alone else Phrase("{quantity}: {word}", quantity=meaning, word=size.symbol)
        text = f"{shown(size.value, size.unit)}, {size.meaning}"
        yield Fact(size.symbol, text, {size.told.key: size.value}, said)


def _time_facts(times: StrokeTimes) -> Iterator[Fact]:
    yield Fact("speed of the crank", f"{number(times.rpm)} rpm", keyed(times, "crank_speed"))
    text = f"working {number(times.working_time)} s, idle {number(times.idle_time)} s, cycle {number(times.period)} s"
    yield Fact("times", text, keyed(times, "working_time", "idle_time", "period"))
    text = f"working {angle(times.working_angle * ANGLE)} deg, idle {angle(times.idle_angle * ANGLE)} deg of the crank"
    yield Fact("strokes", text, keyed(times, "working_angle", "idle_angle"))
    text = f"working {number(times.working_speed)}, idle {number(times.idle_speed)}, cycle {number(times.mean_speed)}"
    letter = "v" if times.unit == "m" else "omega"
    values = keyed(times, "working_speed", "idle_speed", "mean_speed", letter=letter, unit=times.unit)
    yield Fact(f"mean speeds, {times.unit}/s", text, values)


def _check_fact(found: Check) -> Fact:
    text = f"{shown(found.achieved, found.unit)} by simulation"
    unit = "" if found.unit == "-" else found.unit
    values = keyed(found, "achieved", unit=unit)
    if found.target is not None and found.residual is not None:
        text += f", wanted {shown(found.target, found.unit)} (residual {found.residual:.0e})"
        values |= keyed(found, "target", "residual", unit=unit)
    return Fact(Phrase("check: {name}", name=found.name), text, {check_key(found.name): values})


def _sense_fact(found: Precision) -> Fact:
    """In which sense the crank turns, and between which angles."""
    way = "counter-clockwise" if found.sense > 0 else "clockwise"
    first, last = (angle(float(found.crank[k]) * ANGLE) for k in (0, -1))
    return Fact("crank turns", f"{way}, from {first} to {last} deg", keyed(found, "sense"))


def _precision_fact(found: Precision) -> Fact:
    """Errors at the points; the first of many."""
    values = keyed(found, "crank")
    if len(found.points):
        off = np.abs(found.reached - found.points)
        values |= {key: _pairs(points) for key, points in keyed(found, "points", "reached").items()}
        lines = [
            f"{_point(p)} mm at {angle(x * ANGLE)} deg, off by {1e3 * o:.0e} mm"
            for p, x, o in zip(found.points.tolist(), found.crank, off, strict=True)
        ]
    else:
        values |= keyed(found, "wanted", "found", unit=found.unit)
        factor, unit = (1e3, "mm") if found.unit == "m" else (ANGLE, "deg")
        lines = [
            f"{angle(x * ANGLE)} deg of the crank, off by {abs(factor * (f - w)):.0e} {unit}"
            for x, w, f in zip(found.crank, found.wanted, found.found, strict=True)
        ]
    if len(found.angle_errors):
        values |= keyed(found, "angle_errors")
    rest = [f"... and {len(lines) - FEW} more"] if len(lines) > FEW else []
    return Fact("points", "\n".join([*lines[:FEW], *rest]), {"precision": values})


def _point(p: complex) -> str:
    return f"({number(1e3 * p.real, 6)}, {number(1e3 * p.imag, 6)})"


def _pairs(points: Sequence[complex]) -> list[list[float]]:
    return [[p.real, p.imag] for p in points]


def _table(result: Synthesis, patterns: Sequence[str], everything: bool) -> View:
    found = picked(columns(result), patterns)
    if everything:
        return View(list(found), list(found.values()))
    drawn = [_drawn(header, values) for header, values in found.items()]
    return View([header for header, _ in drawn], [values for _, values in drawn])


def _drawn(header: str, values: Sequence[Any]) -> tuple[str, Sequence[Any]]:
    """A column for people: lengths in mm."""
    if header.endswith("[m]"):
        told, factor = Quantity(header, "").shown("mm")
        return told, [factor * value for value in values]
    return header, values
