"""The layout of random pieces: nothing lost, nothing over another, outside or squeezed, the order kept."""

from __future__ import annotations

import random
from collections.abc import Iterator
from itertools import combinations

import pytest
from sparing import sparing

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.sheets.formats import FORMATS, FRAMES
from tmmcalc.report.sheets.layout import Layout, Place, Room, arranged, shared
from tmmcalc.report.sheets.piece import Piece
from tmmcalc.report.sheets.sheet import HEADINGS, Style, planned, room_of
from tmmcalc.report.tables.sheets import WhoTable

from .toys import toy

NEAR = 1e-6  # mm


def pieces(seed: int) -> list[Piece]:
    """One to eleven pieces, some wide and some high, some that need almost all that they would like to have."""
    draw = random.Random(seed)
    found = []
    for k in range(draw.randint(1, 11)):
        good = draw.uniform(60, 300), draw.uniform(60, 300)
        part = draw.choice((0.3, 0.5, 0.9))
        found.append(toy(f"Piece {k} of a sheet", good, (good[0] * part, good[1] * part)))
    return found


def style(size: str, frame: str) -> Style:
    return Style(size, frame, "en", "A project", WhoTable())


def whole(place: Place) -> Box:
    """The room of a piece with its heading."""
    return Box(place.box.left, place.box.bottom, place.box.right, place.head.imag)


def apart(one: Box, other: Box) -> bool:
    across = one.right <= other.left + NEAR or other.right <= one.left + NEAR
    return across or one.top <= other.bottom + NEAR or other.top <= one.bottom + NEAR


def taken(room: Room) -> Iterator[Box]:
    """The corners of a room that are not free."""
    box = room.box
    yield Box(box.right - room.block[0], box.bottom, box.right, box.bottom + room.block[1])


@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize("size", FORMATS)
@sparing("seed", range(12), every=4)
def test_random_pieces(seed: int, size: str, frame: str) -> None:
    asked = pieces(seed)
    sheets, warnings = planned(asked, style(size, frame))
    placed = [place for sheet in sheets for place in sheet.layout.places]
    told = [piece for piece in asked if any(piece.heading in warning for warning in warnings)]
    assert [place.piece for place in placed] == [piece for piece in asked if piece not in told]
    for sheet in sheets:
        room, places = room_of(sheet.format, frame), sheet.layout.places
        for place in places:
            assert place.box.width >= place.piece.least[0] - NEAR
            assert place.box.height >= place.piece.least[1] - NEAR
            box = whole(place)
            assert room.box.left - NEAR < box.left < box.right < room.box.right + NEAR
            assert room.box.bottom - NEAR < box.bottom < box.top < room.box.top + NEAR
            assert all(apart(box, corner) for corner in taken(room))
            wide, high = room.corner
            corner = Box(room.box.left, room.box.top - high, room.box.left + wide, room.box.top)
            assert apart(place.box, corner)
        assert all(apart(whole(a), whole(b)) for a, b in combinations(places, 2))


@pytest.mark.parametrize("seed", range(8))
def test_the_field_is_filled(seed: int) -> None:
    """What is left free is gaps and what lies above or beside the title block, most with a piece alone."""
    asked = pieces(seed)
    room = room_of("a1", "gost")
    layout = arranged(asked, room, 5.0)
    if layout is None:
        return
    area = sum(whole(place).width * whole(place).height for place in layout.places)
    assert area > (0.85 if len(asked) > 1 else 0.75) * room.area


def test_equal_pieces_give_equal_layouts() -> None:
    first, second = (planned(pieces(3), style("a2", "gost"))[0] for _ in range(2))
    boxes = [[[place.box for place in sheet.layout.places] for sheet in sheets] for sheets in (first, second)]
    assert boxes[0] == boxes[1]


def test_proportions_are_near_the_good_ones() -> None:
    """Four equal pieces stand two by two, three flat ones one under another, three high ones side by side."""
    room = Room(Box(0.0, 0.0, 400.0, 400.0))

    def layout(good: tuple[float, float], count: int) -> Layout:
        found = arranged([toy("", good) for _ in range(count)], room, 5.0)
        assert found is not None
        return found

    square = layout((100, 100), 4)
    assert len({round(place.box.left) for place in square.places}) == 2
    assert len({round(place.box.top) for place in square.places}) == 2
    assert len({round(place.box.left) for place in layout((300, 100), 3).places}) == 1
    assert len({round(place.box.top) for place in layout((100, 300), 3).places}) == 1


def test_what_has_no_room_goes_to_a_further_sheet() -> None:
    asked = [toy(f"Plan {k}", (200, 180), (150, 130)) for k in range(5)]
    sheets, warnings = planned(asked, style("a3", "gost"))
    assert not warnings
    assert [sheet.file for sheet in sheets] == ["linkage", "linkage-2", "linkage-3"]
    told = [warning for sheet in sheets for warning in sheet.warnings(style("a3", "gost"))]
    assert told[0] == "warning: linkage-2 is a further sheet, as linkage has no room for: Plan 2, Plan 3"
    assert {len(sheet.layout.places) for sheet in sheets} == {1, 2}


def test_a_piece_that_is_too_large_has_larger_paper() -> None:
    asked = [toy("Small", (100, 80)), toy("Large", (500, 350), (480, 300)), toy("Huge", (900, 200), (900, 200))]
    sheets, warnings = planned(asked, style("a3", "iso"))
    assert [(sheet.file, sheet.format) for sheet in sheets] == [("linkage", "a3"), ("linkage-2", "a2")]
    assert [*sheets[1].warnings(style("a3", "iso"))] == ["warning: linkage-2 is A2, which its picture needs: Large"]
    assert warnings == ["warning: linkage: no paper has room for: Huge"]


def test_long_headings_have_room() -> None:
    name = "Plan of accelerations of the mechanism in position 7 of the working stroke, at the limit of the guide"
    layout = arranged([toy(name, (100, 100)) for _ in range(8)], room_of("a3", "gost"), HEADINGS["a3"])
    assert layout is not None
    for place in layout.places:
        assert len(place.heading) > 1
        lines = place.head.imag - place.box.top
        assert lines > HEADINGS["a3"] * (1 + 1.75 * (len(place.heading) - 1))


def test_shares() -> None:
    assert shared([1.0, 3.0], [0.0, 0.0], 8.0) == pytest.approx([2.0, 6.0])
    assert shared([1.0, 3.0], [4.0, 0.0], 8.0) == pytest.approx([4.0, 4.0])
    assert shared([1.0, 1.0], [5.0, 5.0], 8.0) is None
