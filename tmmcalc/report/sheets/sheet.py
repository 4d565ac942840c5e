"""Sheets of pieces: how many there are, what stands on which, and each of them as a drawing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import combinations, pairwise
from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.core.errors import TmmError
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import message, plain
from tmmcalc.report.drawing.reach import around, reach
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.sheets import gost, iso
from tmmcalc.report.sheets.formats import FORMATS
from tmmcalc.report.sheets.layout import GAP, Layout, Place, Room, arranged
from tmmcalc.report.sheets.piece import SHEETS, Piece
from tmmcalc.report.sheets.titles import Titles, name_of

if TYPE_CHECKING:
    from tmmcalc.report.tables.sheets import WhoTable

HEADINGS = {"a1": 5.0, "a2": 5.0, "a3": 3.5}  # height of the lettering [mm]
INSIDE = 6.0  # free inside the frame [mm]
SLACK = 1.0  # that a piece may reach over its room, which is far from the next [mm]
TRIES = 2  # to bring a piece within its room
BARE = 10.0  # margin of paper without a frame [mm]


class Style(NamedTuple):
    """How all sheets of a project look."""

    format: str
    frame: str
    language: str
    title: str  # of the project
    who: WhoTable


class Sheet(NamedTuple):
    """One sheet: what it is about, which of the sheets about it this is, its pieces in their places."""

    subject: str  # one of SHEETS
    part: int  # from 1
    number: int  # among all sheets, from 1
    total: int  # of all sheets
    format: str
    layout: Layout

    @property
    def file(self) -> str:
        """What its file is called, without a suffix."""
        return self.subject if self.part == 1 else f"{self.subject}-{self.part}"

    def warnings(self, style: Style) -> Iterator[str]:
        """What stands on it that was meant to stand elsewhere."""
        names = ", ".join(message(place.piece.heading) for place in self.layout.places)
        if self.format != style.format:
            yield f"warning: {self.file} is {self.format.upper()}, which its picture needs: {names}"
        elif self.part > 1:
            yield f"warning: {self.file} is a further sheet, as {self.subject} has no room for: {names}"


def planned(pieces: Iterable[Piece], style: Style) -> tuple[list[Sheet], list[str]]:
    """All sheets of these pieces, in their order, and warnings of pieces that no paper holds."""
    by_subject: dict[str, list[Piece]] = {subject: [] for subject in SHEETS}
    for piece in pieces:
        by_subject[piece.sheet].append(piece)
    parts: list[tuple[str, int, str, Layout]] = []
    warnings: list[str] = []
    for subject, own in by_subject.items():
        laid, left = _laid(own, style)
        parts += [(subject, part, *each) for part, each in enumerate(laid, 1)]
        warnings += [f"warning: {subject}: no paper has room for: {message(piece.heading)}" for piece in left]
    sheets = [
        Sheet(subject, part, number, len(parts), size, layout)
        for number, (subject, part, size, layout) in enumerate(parts, 1)
    ]
    return sheets, warnings


def _laid(pieces: Sequence[Piece], style: Style) -> tuple[list[tuple[str, Layout]], list[Piece]]:
    """As few sheets as hold the pieces in their order, filled alike, and the pieces that no paper holds.

    A piece that needs larger paper has a sheet of its own, the smallest that holds it.
    """
    found: list[tuple[str, Layout]] = []
    left: list[Piece] = []
    run: list[Piece] = []
    for piece in pieces:
        if _on([piece], style.format, style) is not None:
            run.append(piece)
            continue
        found += _shared(run, style)
        run = []
        if (alone := _larger(piece, style)) is not None:
            found.append(alone)
        else:
            left.append(piece)
    return [*found, *_shared(run, style)], left


def _shared(pieces: Sequence[Piece], style: Style) -> list[tuple[str, Layout]]:
    """The fewest sheets that hold these pieces, each of which fits on one, in their order."""
    if not pieces:
        return []
    if (layout := _on(pieces, style.format, style)) is not None:
        return [(style.format, layout)]
    count, at = 0, 0
    while at < len(pieces):  # as many as go on each: so many sheets are needed
        at = next(end for end in range(len(pieces), at, -1) if _on(pieces[at:end], style.format, style) is not None)
        count += 1
    for ends in _splits([piece.good[0] * piece.good[1] for piece in pieces], count):
        parts = [_on(pieces[a:b], style.format, style) for a, b in pairwise(ends)]
        if None not in parts:
            break
    return [(style.format, layout) for layout in parts if layout is not None]


def _splits(areas: Sequence[float], count: int) -> list[tuple[int, ...]]:
    """Ways to divide a row of pieces among so many sheets, from the first to after the last, the most even first."""
    ways = [(0, *inner, len(areas)) for inner in combinations(range(1, len(areas)), count - 1)]
    return sorted(ways, key=lambda ends: (max(sum(areas[a:b]) for a, b in pairwise(ends)), [-end for end in ends]))


def _on(pieces: Sequence[Piece], size: str, style: Style) -> Layout | None:
    return arranged(pieces, room_of(size, style.frame), HEADINGS[size])


def _larger(piece: Piece, style: Style) -> tuple[str, Layout] | None:
    """A piece alone on the smallest larger format that holds it."""
    sizes = list(FORMATS)
    tried = ((size, _on([piece], size, style)) for size in reversed(sizes[: sizes.index(style.format)]))
    return next(((size, layout) for size, layout in tried if layout is not None), None)


def room_of(size: str, frame: str) -> Room:
    """What a frame on paper of this format leaves to pieces."""
    wide, high = FORMATS[size]
    if frame == "none":
        head = HEADINGS[size] * 1.25 + 2 * INSIDE
        return Room(Box(BARE, BARE, wide - BARE, high - BARE - head))
    kind = gost if frame == "gost" else iso
    box = Box(kind.LEFT, kind.ELSEWHERE, wide - kind.ELSEWHERE, high - kind.ELSEWHERE).inset(*4 * (INSIDE,))
    block = kind.SIZE[0] - INSIDE + GAP, kind.SIZE[1] - INSIDE + GAP
    corner = (gost.CORNER[0] - INSIDE + GAP, gost.CORNER[1] - INSIDE + GAP / 2) if frame == "gost" else (0.0, 0.0)
    return Room(box, block, corner)


def drawn(sheet: Sheet, style: Style, failed: Callable[[Piece, TmmError], None]) -> Drawing:
    """The drawing of a sheet; ``failed`` is told of every piece that could not be drawn, whose place stays empty."""
    titles = Titles(style.title, name_of(sheet.subject), sheet.number, sheet.total, sheet.format, style.who)
    drawing = Drawing(*FORMATS[sheet.format], f"{style.title}: {titles.name}" if style.title else titles.name)
    {"gost": gost.frame, "iso": iso.frame, "none": _bare}[style.frame](drawing, titles)
    height = HEADINGS[sheet.format]
    for place in sheet.layout.places:
        if place.piece.heading:
            drawing.add(Words(place.head, "\n".join(place.heading), height, 1j))
        before = drawing.mark()
        try:
            draw_within(drawing, place)
        except TmmError as error:
            drawing.undo(before)
            failed(place.piece, error)
    return drawing


def draw_within(drawing: Drawing, place: Place) -> None:
    """Draw a piece in its room; where words of it reach over that, again in a smaller one, as far as it can be read."""
    box, before = place.box, drawing.mark()
    for _ in range(TRIES):
        place.piece.draw(drawing, box)
        found = around(map(reach, drawing.since(before)))
        over = [
            max(0.0, out - SLACK)
            for out in (
                place.box.left - found.left,
                place.box.bottom - found.bottom,
                found.right - place.box.right,
                found.top - place.box.top,
            )
        ]
        smaller = box.inset(*over)
        least = place.piece.least
        if not any(over) or smaller.width < least[0] or smaller.height < least[1]:
            return
        drawing.undo(before)
        box = smaller
    place.piece.draw(drawing, box)


def _bare(drawing: Drawing, titles: Titles) -> Box:
    """Paper without a frame: a line that says what it is."""
    said = (
        tr(
            "{title}. {name}. Sheet {number} of {count}",
            title=plain(titles.title),
            name=titles.name,
            number=titles.number,
            count=titles.total,
        )
        if titles.title
        else tr("{name}. Sheet {number} of {count}", name=titles.name, number=titles.number, count=titles.total)
    )
    box = Box(BARE, BARE, drawing.width - BARE, drawing.height - BARE)
    height = HEADINGS[titles.format]
    drawing.add(Words(complex(box.middle.real, box.top), said, height, 1j))
    return box
