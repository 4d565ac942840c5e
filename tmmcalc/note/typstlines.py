"""Formulas in a source of Typst: with what their letters are, with their numbers, broken where they are too wide."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.note.tree import ACROSS, Equation, Text, part_width
from tmmcalc.note.typstwords import EM, GAP, SIZE, escaped, set_text
from tmmcalc.report.formula.breaking import broken, width
from tmmcalc.report.formula.layout import Row
from tmmcalc.report.formula.typst import typst as typeset

NUMBERS, WORDS = 10.5, 9.0  # sizes of formulas with numbers, and of words before these [pt]
INDENT, NUMBER = 13.0, 12.0  # room before a formula, and for its number [mm]
NEARLY = 1.04  # of the estimated width: what a formula may take


def set_lines(group: Sequence[Equation], said: Text | None) -> Iterator[str]:
    """A formula with its number and what its letters are, then its numbers at places, two beside each other."""
    formulas = [*group]
    if formulas[0].number:
        yield from _formula(formulas.pop(0), said, holds=len(group) > 1)
    while formulas:
        two = formulas[:2]
        beside = _beside(two) if len(two) == 2 else None
        yield beside or _line([two[0]], ACROSS)
        del formulas[: 2 if beside else 1]


def _formula(formula: Equation, said: Text | None, *, holds: bool) -> Iterator[str]:
    """A formula with its number; what its letters are beside it, where there is room, or under it."""
    (row, *more) = _broken(formula, ACROSS)
    free = ACROSS - INDENT - NUMBER - width(row) * EM - 2 * GAP
    if said is not None and not more and sum(map(part_width, said.parts)) * EM <= free:
        cells = f"[], [$ {typeset(row)} $], [,], [{set_text(said)}], [({formula.number})]"
        columns = f"({INDENT:g}mm, auto, auto, 1fr, auto)"
        gutter = f"column-gutter: (0mm, 0mm, {GAP:g}mm, 0mm)"
        yield f"#line({columns}, {str(holds).lower()}, {gutter}, {cells}){_eq(formula)}"
        return
    yield _line([formula], ACROSS, holds=holds or said is not None)
    if said is not None:
        yield f"#explained[{set_text(said)}]"


def _beside(two: Sequence[Equation]) -> str | None:
    """Two formulas beside each other, where each has room in one row so."""
    half = (ACROSS - GAP) / 2
    halves = [_broken(each, half) for each in two]
    fits = all(
        len(rows) == 1 and width(rows[0]) * _em(each) <= half - _lead(each)
        for each, rows in zip(two, halves, strict=True)
    )
    return _line(two, half) if fits else None


def _line(formulas: Sequence[Equation], wide: float, *, holds: bool = False) -> str:
    """Formulas in a row, each in so much room, with the words before it and its number."""
    label, held = _eq(formulas[0]), str(holds).lower()
    told = [_told(formula, wide) for formula in formulas]
    if len(formulas) == 1:
        before, body, number = told[0]
        named = (f"before: {before}" if formulas[0].lead else "", f"number: {number}" if formulas[0].number else "")
        return f"#alone({', '.join(filter(None, (f'{_lead(formulas[0]):g}mm', held, body, *named)))}){label}"
    columns = [each for formula in formulas for each in (f"{_lead(formula):g}mm", "1fr", "auto")]
    return f"#line(({', '.join(columns)}), {held}, {', '.join(cell for cells in told for cell in cells)}){label}"


def _told(formula: Equation, wide: float) -> tuple[str, str, str]:
    """The words before a formula, the formula in its rows, its number."""
    rows = _broken(formula, wide)
    body = " \\\n quad ".join(map(typeset, rows))
    number = f"[({formula.number})]" if formula.number else "[]"
    return f"text(size: {WORDS}pt)[{escaped(formula.lead)}]", _sized(f"$ {body} $", rows, formula, wide), number


def _sized(body: str, rows: Sequence[Row], formula: Equation, wide: float) -> str:
    """The rows in letters in which even those that cannot be broken have room."""
    room = wide - _lead(formula) - (NUMBER if formula.number else 0.0)
    size = SIZE if formula.number else NUMBERS
    needed = (max(map(width, rows)) + (1.0 if rows[1:] else 0.0)) * _em(formula)
    return f"text(size: {size * min(1.0, room / needed):.4g}pt)[{body}]"


def _broken(formula: Equation, wide: float) -> list[Row]:
    """The rows of a formula in so much room [mm]."""
    room = wide - _lead(formula) - (NUMBER if formula.number else 0.0)
    whole = broken(formula.parts, room / _em(formula))
    return whole if len(whole) == 1 else broken(formula.parts, room / _em(formula) - 1.0)  # what goes on stands in


def _em(formula: Equation) -> float:
    """The letter M of a formula [mm]."""
    return EM * NEARLY * (1.0 if formula.number else NUMBERS / SIZE)


def _lead(formula: Equation) -> float:
    """The room of the words before a formula [mm]."""
    return max(INDENT, part_width(formula.lead) * EM * WORDS / SIZE + GAP)


def _eq(formula: Equation) -> str:
    return f" <eq:{formula.key}>" if formula.key else ""
