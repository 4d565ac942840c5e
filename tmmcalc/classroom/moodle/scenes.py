"""What a variant is given, as HTML and a picture for questions; and its own numbers, for sets of data."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from html import escape
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.classroom.papers.making import Order, Scene, make_papers, order_of, traced
from tmmcalc.classroom.papers.tasksheet import given_of, meanings_of, said_in, senses_of
from tmmcalc.note.assembled import drawn, inline
from tmmcalc.note.task import row_of
from tmmcalc.note.tree import plain_text
from tmmcalc.pipeline.chapters import given_in
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.printing import printed_as

if TYPE_CHECKING:
    from tmmcalc.classroom.model import Item
    from tmmcalc.classroom.state import Class
    from tmmcalc.report.manuscript import Datum

FIGURES = 6  # of given numbers
MAKER = "tmmcalc.classroom.moodle.scenes:scene_bytes"


class Told(NamedTuple):
    """A variant as questions tell it."""

    scheme: str  # SVG; empty: none
    said: list[str]  # of the scene, in words
    own: list[list[str]]  # data of this variant alone: what, names, value
    common: list[list[str]]
    numbers: list[list[float]]  # of each of the own data, as they are shown; none where it is a text
    units: list[str]  # of these, as they are shown
    meanings: list[str]  # of the asked results


def scenes_of(
    folder: Path,
    made: Class,
    items: Sequence[Item],
    *,
    jobs: int | None = None,
    tell: Callable[[str], None] = lambda said: None,
    told: Callable[[int], None] = lambda done: None,
) -> list[Told]:
    """The variants of a class as questions tell them, in a language, in the order of the class."""
    assignment = made.file(folder)
    own, further = traced(assignment)
    with TemporaryDirectory() as place:
        orders = [
            order_of(each, items, Path(place) / f"{each.number}.json", MAKER, own, further) for each in made.variants
        ]
        make_papers(assignment, orders, jobs=jobs, tell=tell, told=told)
        return [Told(*json.loads(Path(order.target).read_bytes())) for order in orders]


def scene_bytes(scene: Scene, order: Order) -> bytes:
    """A variant as `Told`, for the process that asked."""
    with scene.run.believed():
        given = given_of(given_in(scene.run.spec, scene.run.results), order.own, order.untold)
        picture = svg(drawn(given.scheme[0])).decode() if given.scheme else ""
        meanings = [plain_text(inline(each)) for each in meanings_of(order.items, scene.run)]
    found = Told(
        picture,
        [plain_text(inline(each.text)) for each in given.said],
        [*map(_cells, given.own)],
        [*map(_cells, given.common)],
        [*map(_numbers, given.own)],
        [tr_unit(printed_as(each.unit)[0]) for each in given.own],
        meanings,
    )
    return json.dumps(found).encode()


def _cells(datum: Datum) -> list[str]:
    return [plain_text(inline(cell)) for cell in row_of(datum)]


def _numbers(datum: Datum) -> list[float]:
    factor = printed_as(datum.unit)[1]
    return [] if datum.text else [float(f"{value * factor:.{FIGURES}g}") for value in datum.values]


def sentences(told: Sequence[str]) -> str:
    """Paragraphs as HTML."""
    return "".join(f"<p>{markup(each)}</p>" for each in told)


def table(rows: Sequence[Sequence[str]], caption: str, cell: Callable[[str], str] | None = None) -> str:
    """A table of data as HTML, of words, or of what ``cell`` makes of them; nothing without rows."""
    if not rows:
        return ""
    made = cell or markup
    body = "".join(f"<tr>{''.join(f'<td>{made(each)}</td>' for each in row)}</tr>" for row in rows)
    head = "".join(f"<th>{markup(each)}</th>" for each in (tr("Quantity"), tr("Designation"), tr("Value")))
    return f"<p>{markup(caption)}</p><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def senses(items: Sequence[Item]) -> str:
    """How positions and senses are counted, as HTML; nothing where the results need no such rule."""
    told = "".join(f"<li>{markup(each)}</li>" for each in senses_of(items))
    return f"<ul>{told}</ul>" if told else ""


def markup(text: str) -> str:
    """Words as HTML; braces would be names of data of the question."""
    return escape(said_in(text))
