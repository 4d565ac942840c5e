"""Sheets of the ready specs, read back: what stands where, in true size, readable, in the language that was asked for.

A sample of the specs is quick; all of them are slow.
"""

from __future__ import annotations

import re
from functools import cache
from typing import NamedTuple

import pytest
from drawnsheets import (
    CONFIGS,
    Made,
    alone,
    beyond,
    names_in,
    on_lines,
    only_by_colour,
    over_words,
    result_of,
    sheets_of,
    strange,
    told,
    words_of,
)
from pages import dxf_lines, dxf_words, lines, size, words
from sparing import sparing

from tmmcalc.core.errors import TmmError
from tmmcalc.report.drawing import written
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.sheets.formats import FORMATS
from tmmcalc.report.sheets.sheet import room_of

EXACT = 0.01  # mm
SHARE = 0.01  # of the words that may lie on a line or another word and are not told
SAMPLE = ("shaper", "cam-flat", "gears-single-planets")
NAMES = [
    pytest.param(file.stem, marks=() if file.stem in SAMPLE[1:] else (pytest.mark.slow,))
    for file in sorted(CONFIGS.glob("*.toml"))
]
EXPECTED = {  # sheets of some scenes
    "course-project": ["linkage", "forces", "gears", "cam"],
    "shaper": ["linkage", "forces"],
    "press": ["linkage", "forces"],
    "cam-flat": ["cam"],
    "cam-oscillating": ["cam"],
    "gears-single-planets": ["gears"],
}


class Count(NamedTuple):
    """How many words there are, and how many of them cannot be read and are not told."""

    words: int
    faults: int


@cache
def drawn(name: str, language: str, paper: str = "a1") -> tuple[Made, ...]:
    """The sheets of a spec, none if it has no solution or nothing to draw."""
    try:
        return tuple(sheets_of(name, language, paper)[0])
    except TmmError:
        return ()


def count(made: Made) -> Count:
    known = {*told(made.drawing)}
    wrong = [text for text in on_lines(made.drawing) if text not in known]
    wrong += [one for one, other in over_words(made.drawing) if not {one, other} & known]
    return Count(len(words_of(made.drawing)), len(wrong))


@pytest.mark.parametrize("language", ["en", "uk"])
@pytest.mark.parametrize("name", NAMES)
def test_pieces_stay_in_their_rooms(name: str, language: str) -> None:
    """Nothing reaches over the middle between a piece and the next, nor out of the frame."""
    for made in drawn(name, language):
        wide, high = FORMATS[made.sheet.format]
        frame = Box(20, 5, wide - 5, high - 5)
        for piece, box, drawing in alone(made, language):
            assert beyond(drawing, box) == [], piece.heading
            assert beyond(drawing, frame) == [], piece.heading


@pytest.mark.parametrize("name", NAMES)
def test_in_ukrainian_no_english_word_is_left(name: str) -> None:
    for made in drawn(name, "uk"):
        written_by_users = names_in(result_of(name).spec._written.document)
        left = strange(made.drawing, written_by_users)
        assert left == []


@pytest.mark.parametrize("name", NAMES)
def test_curves_are_told_apart_without_colours(name: str) -> None:
    for made in drawn(name, "en"):
        assert only_by_colour(made.drawing) == []


@pytest.mark.parametrize("name", NAMES)
def test_the_files_hold_what_is_drawn(name: str) -> None:
    """Page, frame and title block of the PDF, the DXF without a fault, every heading to be found in both."""
    for made in drawn(name, "uk"):
        data = written("pdf", made.drawing)
        wide, high = FORMATS[made.sheet.format]
        assert size(data) == pytest.approx((wide, high), abs=EXACT)
        thick = [line for line in lines(data) if abs(line.width - 0.7) < EXACT]
        for corner in (20 + 5j, complex(wide - 5, 5), complex(wide - 190, 60), complex(20, high - 19)):
            assert any(min(abs(line.start - corner), abs(line.end - corner)) < EXACT for line in thick)
        cad = written("dxf", made.drawing)
        told_in_pdf, told_in_dxf = words(data), dxf_words(cad)
        for place in made.sheet.layout.places:
            for word in re.findall("[а-яіїєґ]{4,}", re.sub(r"\$[^$]*\$", " ", place.piece.heading)):
                assert word in told_in_pdf
                assert word in told_in_dxf


@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n in SAMPLE else pytest.mark.slow) for n in EXPECTED])
def test_the_sheets_of_a_scene(name: str) -> None:
    sheets = [made.sheet for made in drawn(name, "en")]
    assert list(dict.fromkeys(sheet.subject for sheet in sheets)) == EXPECTED[name]
    assert [sheet.number for sheet in sheets] == list(range(1, len(sheets) + 1))


@sparing("paper", FORMATS, every=len(FORMATS))
def test_the_crank_has_its_length_at_the_scale(paper: str) -> None:
    """The crank of the shaper, 200 mm, is 200 mm over the number of the scale in PDF and DXF: 50.00 at 1:4."""
    linkage = drawn("shaper", "en", paper)[0]
    cad, data = written("dxf", linkage.drawing), written("pdf", linkage.drawing)
    scale = re.search(r"Position \S+, .* m/mm \((\d+):(\d+(?:\.\d+)?)\)", dxf_words(cad))
    assert scale is not None
    crank = 200.0 * float(scale[1]) / float(scale[2])
    for found in (lines(data), dxf_lines(cad)):
        assert any(abs(abs(line.end - line.start) - crank) < EXACT for line in found if line.width > 0.6)


@pytest.mark.parametrize("paper", ["a2", "a3"])
@sparing("name", SAMPLE, every=3, first=1)
def test_smaller_paper(name: str, paper: str) -> None:
    """Every piece of A1 stands on some sheet of smaller paper, with what it needs."""
    large = [place.piece.heading for made in drawn(name, "en") for place in made.sheet.layout.places]
    small = drawn(name, "en", paper)
    assert [place.piece.heading for made in small for place in made.sheet.layout.places] == large
    for made in small:
        room = room_of(made.sheet.format, "gost").box
        assert made.sheet.format >= "a1"
        for place in made.sheet.layout.places:
            assert place.box.width >= place.piece.least[0] - 1e-6
            assert place.box.height >= place.piece.least[1] - 1e-6
            assert room.left - 1e-6 < place.box.left < place.box.right < room.right + 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", "uk"])
def test_words_are_free_or_told(language: str) -> None:
    """Over all ready specs fewer than one in a hundred words lies on a line or on another, and is not told."""
    counts = [count(made) for file in sorted(CONFIGS.glob("*.toml")) for made in drawn(file.stem, language)]
    assert len(counts) > 60
    assert sum(each.faults for each in counts) < SHARE * sum(each.words for each in counts)
