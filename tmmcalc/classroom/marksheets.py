"""The marks as tables: one for the grade book, all of them for the teacher; and the sheet of a student.

The sheet of a student tells what he wrote, what it is and a hint, and no number of the key.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Sequence
from typing import Any

from tmmcalc.classroom.explaining import Explanation
from tmmcalc.classroom.marking import Marked, Marks
from tmmcalc.classroom.model import Key, Keybook, Told
from tmmcalc.classroom.statistics import Statistics
from tmmcalc.classroom.verdicts import Standing, distance
from tmmcalc.classroom.wording import NONE, cell_of, header_of, standing_said, title_of
from tmmcalc.core.cells import harmless
from tmmcalc.core.printable import printable
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.worksheets import Worksheet

FIGURES = 5  # of numbers that people compare
MOST_OFF = 10.0  # part of a value; beyond it how far an answer is off says nothing


def grades(marks: Marks) -> Worksheet:
    """A row a student: points, and of each item its points and what the answer is."""
    items = [item.name for item in marks.items]
    headers = [
        "variant",
        "student",
        "points",
        "of",
        "file",
        *(f"{name}{end}" for name in items for end in ("", ": is")),
    ]
    rows = [_graded(marks, each) for each in marks.counting]
    rows += [
        [key.number, key.student, None, _tidy(marks.most), NONE] + [None, None] * len(items) for key in marks.absent
    ]
    return _sheet("marks", headers, sorted(rows, key=lambda row: row[0]))


def _graded(marks: Marks, each: Marked) -> list[Any]:
    of_items = (cell for got, what in zip(each.points, each.standings, strict=True) for cell in (_tidy(got), str(what)))
    return [each.number, each.student, _tidy(each.total), _tidy(marks.most), each.source, *of_items]


def teachers(marks: Marks, book: Keybook, statistics: Statistics) -> list[Worksheet]:
    """All that is known: marks, answers beside the key, explanations, statistics, what could not be read."""
    keys = {key.number: key for key in book.keys}
    return [
        grades(marks),
        _answers(marks, keys),
        _explanations(marks),
        _items(marks, statistics),
        _made(marks, statistics),
        _remarks(marks, statistics, keys),
    ]


def _answers(marks: Marks, keys: dict[int, Key]) -> Worksheet:
    headers = ["variant", "student", "file", "counts", "item", "unit", "answer", "right", "off", "is", "points", "why"]
    rows = [
        [
            *(each.number, each.student, each.source, "yes" if each.counts else "no", item.name, item.unit),
            each.answers[k].text,
            _round(keys[each.number].values[k]),
            _off(each, marks, keys[each.number], k),
            str(each.standings[k]),
            _tidy(each.points[k]),
            _why(each, k, marks.mistakes),
        ]
        for each in marks.marked
        for k, item in enumerate(marks.items)
    ]
    return _sheet("answers", headers, rows)


def _why(each: Marked, k: int, mistakes: Sequence[Told]) -> str:
    """Why an answer is no number, or what explains it."""
    fault = each.answers[k].fault
    return tr_name(fault) if fault else "; ".join(told(x, mistakes) for x in each.explanations if k in x.items)


def _off(each: Marked, marks: Marks, key: Key, k: int) -> str:
    """By what part of the right value an answer is off."""
    right, value = key.values[k], each.answers[k].value
    if not right or not math.isfinite(right) or not math.isfinite(value):
        return ""
    return _percent(distance(value, marks.items[k], right) / abs(right))


def _explanations(marks: Marks) -> Worksheet:
    headers = ["variant", "student", "file", "mistake", "items", "against it", "off by", "odds"]
    rows = [
        [
            *(each.number, each.student, each.source, told(x, marks.mistakes)),
            ", ".join(marks.items[k].name for k in x.items),
            ", ".join(marks.items[k].name for k in x.against),
            _percent(x.deviation),
            float(f"{x.odds:.1e}"),
        ]
        for each in marks.marked
        for x in each.explanations
    ]
    return _sheet("mistakes", headers, rows)


def _percent(part: float) -> str:
    """A part of something in per cent, to two figures that stand still: 0 where it is nothing, no more than a thousand.

    >>> _percent(1e-9), _percent(0.0123), _percent(1.004), _percent(3e7)
    ('0 %', '1.2 %', '100 %', '> 1000 %')
    """
    if part > MOST_OFF:
        return f"> {100 * MOST_OFF:.0f} %"
    shown = f"{100 * part:.0f}" if part >= 0.0995 else f"{100 * part:.1f}"
    return f"{'0' if shown == '0.0' else shown} %"


def told(explanation: Explanation, mistakes: Sequence[Told]) -> str:
    """The mistakes of an explanation, which give equal numbers."""
    return _titles(explanation.mistakes, mistakes)


def _titles(numbers: Sequence[int], mistakes: Sequence[Told]) -> str:
    return tr(" or ").join(dict.fromkeys(tr_name(mistakes[m].title) for m in numbers))


def _items(marks: Marks, statistics: Statistics) -> Worksheet:
    standings = list(Standing)
    headers = ["item", "share of points", *map(str, standings)]
    rows = [
        [marks.items[went.item].name, _round(went.share), *(went.counts.get(each, 0) for each in standings)]
        for went in statistics.items
    ]
    return _sheet("items", headers, rows)


def _made(marks: Marks, statistics: Statistics) -> Worksheet:
    rows = [
        [_titles(made.mistakes, marks.mistakes), len(made.numbers), listed(made.numbers)] for made in statistics.made
    ]
    return _sheet("common mistakes", ["mistake", "students", "variants"], rows)


def _remarks(marks: Marks, statistics: Statistics, keys: dict[int, Key]) -> Worksheet:
    rows = [
        [tr("file"), each.source, f"{each.message}{f'; {each.remedy}' if each.remedy else ''}"]
        for each in marks.refused
    ]
    for each in marks.marked:
        rows += [
            [tr("answers"), _who(each.number, keys), f"{each.source}: {tr_name(remark)}"] for remark in each.remarks
        ]
        if not each.counts:
            said = tr("{file}: {points} points; a later one counts", file=each.source, points=number(each.total))
            rows.append([tr("earlier hand-in"), _who(each.number, keys), said])
    for equal in statistics.equal:
        who = ", ".join(_who(number, keys) for number in equal.numbers)
        name = marks.items[equal.item].name
        said = tr("{name}: {answer} stands in each, where other numbers are right", name=name, answer=equal.text)
        rows.append([tr("equal numbers"), who, said])
    for foreign in statistics.foreign:
        names = ", ".join(marks.items[k].name for k in foreign.items)
        said = tr("{names}: wrong here, right in variant {other}", names=names, other=_who(foreign.other, keys))
        rows.append([tr("answers of another variant"), _who(foreign.number, keys), said])
    return _sheet("remarks", ["of", "what", "remark"], rows)


def _who(number: int, keys: dict[int, Key]) -> str:
    return f"{number} {keys[number].student}".strip()


def listed(numbers: Sequence[int]) -> str:
    """Numbers of variants in a row."""
    return ", ".join(map(str, numbers))


def students_sheet(marks: Marks, each: Marked) -> str:
    """The sheet of a student as Markdown: his answers, what they are, hints; no number of the key."""
    lines = [
        f"# {_md(' '.join((tr('Variant {number}', number=each.number), each.student)).strip())}",
        "",
        tr("Points: {points} of {most}.", points=number(each.total), most=number(marks.most)),
        "",
        f"| {tr('Name')} | {tr('Unit')} | {tr('Answer')} | {tr('It is')} | {tr('Points for it')} |",
        "|-|-|-|-|-|",
    ]
    for item, answer, what, got in zip(marks.items, each.answers, each.standings, each.points, strict=True):
        points = tr("{points} of {most}", points=number(got), most=number(item.weight))
        cells = (item.name, tr_unit(item.unit), answer.text, standing_said(what), points)
        lines.append(f"| {' | '.join(map(_md, cells))} |")
    lines += ["", *(f"- {_md(line)}" for line in hints_of(marks.items, marks.mistakes, each))]
    return "\n".join(lines).rstrip() + "\n"


def hints_of(items: Sequence[Any], mistakes: Sequence[Told], each: Marked) -> Iterator[str]:
    """What a student is told of his answers, without a number of the key."""
    for k, answer in enumerate(each.answers):
        if answer.fault:
            yield f"{items[k].name}: {tr_name(answer.fault)}"
    for explanation in each.explanations:
        names = ", ".join(items[k].name for k in explanation.items)
        hints = dict.fromkeys(tr_name(mistakes[m].hint) for m in explanation.mistakes)
        yield f"{names}: {tr(' Or: ').join(hints)}"
    yield from map(tr_name, each.remarks)


def _md(text: str) -> str:
    """A text in a cell of Markdown, where it marks up nothing."""
    shown = printable(text).replace("\n", " ")
    for sign in "\\`*_[]<>|#":
        shown = shown.replace(sign, f"\\{sign}")
    return shown


def as_csv(sheet: Worksheet) -> str:
    """A table as CSV; a text that a spreadsheet would take for a formula begins with an apostrophe."""
    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow([harmless(header) for header in sheet.headers])
    writer.writerows([harmless(cell) for cell in row] for row in zip(*sheet.columns, strict=True))
    return buffer.getvalue()


def as_markdown(sheets: Sequence[Worksheet], title: str) -> str:
    """Tables under headings, in the language in force."""
    lines = [f"# {_md(title_of(title))}"]
    for sheet in sheets:
        lines += ["", f"## {_md(title_of(sheet.name))}", ""]
        if not sheet.rows:
            lines.append(tr("None."))
            continue
        headers = [_md(header_of(header, sheet.name)) for header in sheet.headers]
        lines += [f"| {' | '.join(headers)} |", "|-" * len(headers) + "|"]
        for row in zip(*sheet.columns, strict=True):
            cells = (_md(cell_of(cell, header)) for cell, header in zip(row, sheet.headers, strict=True))
            lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def _sheet(name: str, headers: Sequence[str], rows: Sequence[Sequence[Any]]) -> Worksheet:
    columns = [list(column) for column in zip(*rows, strict=True)] or [[] for _ in headers]
    return Worksheet(name, list(headers), columns)


def _tidy(points: float) -> float | int:
    """Points as they are told: 3 for 3.0, 0.8 for sums of rounded parts."""
    rounded = round(points, 6)
    return int(rounded) if rounded == int(rounded) else rounded


def _round(value: float) -> float | None:
    return float(f"{value:.{FIGURES}g}") if math.isfinite(value) else None
