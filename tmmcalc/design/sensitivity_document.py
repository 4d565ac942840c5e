"""The document of sensitivities: of every result the numbers that it depends on, the one that matters most first."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.headers import key_and_unit
from tmmcalc.design.courses import Course
from tmmcalc.design.ladders import Reach
from tmmcalc.design.sensitivity import Partial, Sensitivity
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

HEADERS = ("key", "value", "derivative", "for 1 %", "error", "way")
TIDY = ("result", "key", "value", "derivative", "left", "right", "error", "relative", "curvature", "from", "way")
BY_ROW = ("column", "row", "at", "value", "key", "key_value", "derivative", "error", "from", "way")
SHOWN = 5  # ends that are told
MOST = 6  # keys of which a table for people tells in every row
LETTERS = "ABCDEF"
ROUNDING = 1e-9  # of what the largest derivative does: less is none
POOR = 1e-6  # an error above is told of each
PERCENT = 0.01  # of a key: the change that the table tells of
BENT = 0.25  # of the change by the derivative: where one per cent adds more to it, this is told
OTHER = {"right": "smaller", "left": "larger"}  # than the value: where there is none


def sensitivity_document(result: Sensitivity, title: str) -> Document:
    """One part a result; before them how near variants without a solution are, and which keys take no small change."""
    parts = tuple(_part(result, name, value) for name, value in zip(result.names, result.found, strict=True))
    return Document(title, (*_facts(result),), parts=parts)


def tidy_sensitivity(result: Sensitivity, title: str) -> Document:
    """One table of all derivatives, for programs; what there is not is empty."""
    rows = [
        (each.name, each.key, each.value, *map(_or_none, (each.slope.value, each.slope.left, each.slope.right)),
         _or_none(each.slope.error), _or_none(each.relative), _or_none(each.slope.curvature), each.slope.side, each.way)
        for name in result.names
        for each in result.of(name)
    ]  # fmt: skip
    columns = [*map(list, zip(*rows, strict=True))] or [[] for _ in TIDY]
    return Document(title, (*_facts(result),), table=View(TIDY, columns))


def courses_document(every: Sequence[Course], result: Sensitivity, title: str) -> Document:
    """One part a column: what one per cent of the keys that matter most does to it in every row."""
    return Document(title, (*_facts(result),), parts=tuple(_course(course) for course in every))


def tidy_courses(every: Sequence[Course], result: Sensitivity, title: str) -> Document:
    """One table of all derivatives in all rows, for programs."""
    rows = [
        (course.column, label, x, value, each.key, each.value, *map(_or_none, (each.slope.value, each.slope.error)),
         each.slope.side, each.way)
        for course in every
        for own in course.partials
        for label, x, value, each in zip(course.labels, course.x, course.values, own, strict=True)
    ]  # fmt: skip
    columns = [*map(list, zip(*rows, strict=True))] or [[] for _ in BY_ROW]
    return Document(title, (*_facts(result),), table=View(BY_ROW, columns))


def _course(course: Course) -> Document:
    bare, unit = key_and_unit(course.column)
    telling, count = course.telling[:MOST], len(course.partials)
    facts = [Fact("depends on", f"{len(course.telling)} of {count} numbers", {"keys": len(course.telling)})]
    keys = [f"{letter} {key_and_unit(own[0].key)[0]}" for letter, own in zip(LETTERS, telling, strict=False)]
    facts += [Fact("keys" if k == 0 else "", key) for k, key in enumerate(keys)]
    told = [[number(each.slope.value * PERCENT * each.value) for each in own] for own in telling]
    headers = ["row", *([course.over] if course.over else []), f"value {unit}".rstrip(), *LETTERS[: len(told)]]
    places = [[number(x) for x in course.x]] if course.over else []
    columns = [[*course.labels], *places, [number(value) for value in course.values], *told]
    notes = ["note: the columns by letters are what one per cent of these keys does, in the unit of the value"] * bool(
        told
    )
    for own in course.partials:
        at = [label for label, each in zip(course.labels, own, strict=True) if each.slope.side == "jump"]
        if at:
            key = key_and_unit(own[0].key)[0]
            notes.append(
                f"warning: {key}: the column jumps in {len(at)} rows, the first of them {at[0]}: no derivative"
            )
    return Document(bare, tuple(facts), tuple(notes), View(tuple(headers), columns), name=bare)


def bent(each: Partial) -> bool:
    """Whether the second derivative adds to the change for one per cent what is no longer small against it."""
    bend = abs(each.slope.curvature) * PERCENT * abs(each.value) / 2
    return bool(bend > BENT * abs(each.slope.value) and abs(each.slope.value) > each.slope.error)


def _facts(result: Sensitivity) -> Iterator[Fact]:
    yield Fact("variants", str(result.solved), {"variants": result.solved})
    yield from _ends(result)
    yield from _fixed(result)


def _part(result: Sensitivity, name: str, value: float) -> Document:
    every = result.of(name)
    does = [abs(each.slope.value * each.value) for each in every]
    least = ROUNDING * max((each for each in does if np.isfinite(each)), default=0.0)
    shown = [each for each, own in zip(every, does, strict=True) if each.acts and not 0 < own < least]
    bare, unit = key_and_unit(name)
    facts = [
        Fact("value", f"{number(value)} {unit}".rstrip(), {"value": value}),
        Fact("depends on", f"{len(shown)} of {len(every)} numbers", {"keys": len(shown)}),
    ]
    errors = [each.error for each in shown if np.isfinite(each.error)]
    if errors:
        facts.append(Fact("derivatives", f"off by {max(errors):.0e} of them at most", {"error": max(errors)}))
    rows = [_row(each, unit) for each in shown]
    table = View(HEADERS, [*map(list, zip(*rows, strict=True))]) if rows else None
    return Document(bare, tuple(facts), tuple(_notes(shown, unit, result.reaches)), table, name=bare)


def _row(each: Partial, unit: str) -> tuple[str, ...]:
    """Key, value, derivative, what one per cent of the key does to the result (of a key that is 0 none), error, way."""
    key, own = key_and_unit(each.key)
    percent = f"{each.relative:+.3g} %" if np.isfinite(each.relative) else ""
    value = each.slope.side if np.isnan(each.slope.value) else f"{number(each.slope.value)} {per(unit, own)}"
    error = f"{each.error:.0e}" if np.isfinite(each.error) else ""
    return key, f"{number(each.value)} {own}".rstrip(), value.rstrip(), percent, error, each.way


def _notes(shown: Sequence[Partial], unit: str, reaches: Sequence[Reach]) -> Iterator[str]:
    """Kinks with both sides, jumps, and where no straight line stands for the result."""
    for each in shown:
        below = per(unit, key_and_unit(each.key)[1])
        if each.slope.side == "kink":
            left, right = (f"{number(side)} {below}".rstrip() for side in (each.slope.left, each.slope.right))
            yield f"warning: {each.key}: a kink, {left} to smaller values and {right} to larger ones"
        elif each.slope.side == "jump":
            yield f"warning: {each.key}: the result jumps here, so that it has no derivative"
        elif each.slope.side in ("left", "right"):
            ends = [
                abs(one.step)
                for one in reaches
                if one.key == each.key and (one.step < 0) == (each.slope.side == "right")
            ]
            own = key_and_unit(each.key)[1]
            first = f"{number(min(ends), 3)} {own}".rstrip() if ends else "the smallest step"
            yield f"note: {each.key}: to {OTHER[each.slope.side]} values there is no solution from {first} on"
        elif each.slope.side == "none" and each.way == "exact":
            yield (
                f"warning: {each.key}: the derivative holds for the least of changes alone: small steps do not follow "
                "it, as near a dead point or the end of what can be assembled"
            )
        elif each.slope.side == "none":
            yield (
                f"warning: {each.key}: differences do not settle (off by {each.slope.error:.1e}): no straight line "
                "stands for the result here, which a dead point or the end of what can be assembled does"
            )
        elif each.error > POOR:
            yield f"note: {each.key}: the derivative is known to {each.error:.1e} of it alone"
        if bent(each):
            step = PERCENT * abs(each.value)
            sides = [sign * each.slope.value * step + each.slope.curvature * step**2 / 2 for sign in (1, -1)]
            more, less = (f"{number(side)} {unit}".rstrip() for side in sides)
            yield (
                f"warning: {each.key}: no straight line stands for one per cent, of which more changes the result by "
                f"{more}, less by {less}, as its bend tells"
            )


def per(unit: str, below: str) -> str:
    """Unit of a derivative.

    >>> per("N", "mm"), per("", "kg*m^2"), per("m", "")
    ('N/mm', '1/(kg*m^2)', 'm')
    """
    if not below:
        return unit
    return f"{unit or '1'}/({below})" if {"*", "/"} & set(below) else f"{unit or '1'}/{below}"


def _ends(result: Sensitivity) -> Iterator[Fact]:
    """Keys of which a small step has no solution any more, the nearest ones first."""
    near = sorted(result.reaches, key=lambda each: abs(each.step))
    for at, each in enumerate(near[:SHOWN], 1):
        values = {f"end_{at}": {"key": each.key, "step": each.step, "reason": each.reason}}
        yield Fact("no solution", f"{each.key} {each.step:+.3g}: {each.reason}", values)
    if len(near) > SHOWN:
        yield Fact("no solution", f"{len(near) - SHOWN} keys more")


def _fixed(result: Sensitivity) -> Iterator[Fact]:
    """Keys that take no small change, by the number of each reason."""
    if result.fixed:
        whole = [key for key, reason in result.fixed if "whole number" in reason]
        others = [f"{key}: {reason}" for key, reason in result.fixed if key not in whole]
        text = "; ".join([f"{len(whole)} whole numbers"] * bool(whole) + others)
        yield Fact("left out", text, {"left_out": [key for key, _ in result.fixed]})


def _or_none(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
