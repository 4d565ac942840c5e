"""Frames and title blocks read back from PDF and DXF: where the standards put their lines, to 0.01 mm."""

from __future__ import annotations

from functools import cache
from itertools import accumulate
from typing import Any

import pytest
from pages import Line, dxf_lines, dxf_words, lines, size, words

from tmmcalc.report.drawing import written
from tmmcalc.report.language import speaking
from tmmcalc.report.sheets.sheet import Style, drawn, planned
from tmmcalc.report.tables.sheets import WhoTable

from .toys import toy

PAPER = {"a1": (841, 594), "a2": (594, 420), "a3": (420, 297)}  # GOST 2.301, ISO 216
COLUMNS = (7, 10, 23, 15, 10, 70, 5, 5, 5, 5, 12, 18)  # GOST 2.104, form 1
ZONES = {"a1": (16, 12), "a2": (12, 8), "a3": (8, 6)}  # ISO 5457, table 3
EXACT = 0.01  # mm
WHO = WhoTable(
    designation="TMM 12.07.00{sheet}",
    drawn_by="O. Kovalenko",
    checked_by="I. Petrenko",
    technical_control="T. Control",
    standards_control="N. Control",
    approved_by="A. Head",
    organisation="University, chair of TMM",
    date="2026-11-23",
    letter="E",
    material="Steel",
)


@cache
def sheet(form: str, size: str, frame: str, language: str) -> bytes:
    style = Style(size, frame, language, "Shaper", WHO)
    with speaking(language):
        (made,), _ = planned([toy("Plan", (200, 150))], style)
        return written(form, drawn(made, style, failed))


def failed(piece: Any, error: Exception) -> None:
    raise error


def both(size: str, frame: str, language: str = "uk") -> list[list[Line]]:
    """The lines of the PDF and of the DXF."""
    return [lines(sheet("pdf", size, frame, language)), dxf_lines(sheet("dxf", size, frame, language))]


def has(found: list[Line], a: complex, b: complex, width: float) -> bool:
    """Whether a line of this width runs from one place to the other."""
    return any(
        abs(line.width - width) < EXACT
        and min(max(abs(line.start - a), abs(line.end - b)), max(abs(line.start - b), abs(line.end - a))) < EXACT
        for line in found
    )


@pytest.mark.parametrize("paper", PAPER)
@pytest.mark.parametrize("frame", ["gost", "iso", "none"])
def test_the_page_has_the_size_of_its_format(paper: str, frame: str) -> None:
    assert size(sheet("pdf", paper, frame, "en")) == pytest.approx(PAPER[paper], abs=EXACT)


@pytest.mark.parametrize("paper", PAPER)
def test_the_frame_of_gost(paper: str) -> None:
    wide, high = PAPER[paper]
    low, top = complex(20, 5), complex(wide - 5, high - 5)
    for found in both(paper, "gost"):
        for a, b in ((low, top.real + 5j), (top.real + 5j, top), (top, 20 + top.imag * 1j), (20 + top.imag * 1j, low)):
            assert has(found, a, b, 0.7)
        corner = complex(20, high - 19)  # the graph of the turned designation, 70 x 14
        assert has(found, corner, corner + 70, 0.7)
        assert has(found, corner + 70, corner + 70 + 14j, 0.7)


@pytest.mark.parametrize("paper", PAPER)
def test_the_title_block_of_gost(paper: str) -> None:
    """Form 1: 185 x 55, lines of the entries thin, all others thick."""
    left, bottom = PAPER[paper][0] - 5 - 185, 5
    x = (0, *accumulate(COLUMNS))
    assert x[-1] == 185
    thick_across = [
        (55, 0, 185),
        (35, 0, 65),
        (30, 0, 65),
        (40, 65, 185),
        (15, 65, 185),
        (35, 135, 185),
        (20, 135, 185),
    ]
    thin_across = [(y, 0, 65) for y in (5, 10, 15, 20, 25, 40, 45, 50)]
    thick_up = [(x[1], 30, 55), *((at, 0, 55) for at in x[2:6]), (x[6], 0, 40)]
    thick_up += [(x[9], 20, 40), (x[11], 20, 40), (x[10], 15, 20)]
    thin_up = [(x[7], 20, 35), (x[8], 20, 35)]
    for found in both(paper, "gost"):
        for rows, width in ((thick_across, 0.7), (thin_across, 0.25)):
            for y, a, b in rows:
                assert has(found, complex(left + a, bottom + y), complex(left + b, bottom + y), width), (y, a, b)
        for columns, width in ((thick_up, 0.7), (thin_up, 0.25)):
            for at, a, b in columns:
                assert has(found, complex(left + at, bottom + a), complex(left + at, bottom + b), width), (at, a, b)


@pytest.mark.parametrize("paper", PAPER)
def test_the_frame_of_iso(paper: str) -> None:
    wide, high = PAPER[paper]
    across, up = ZONES[paper]
    for found in both(paper, "iso", "en"):
        assert has(found, 20 + 10j, wide - 10 + 10j, 0.7)
        assert has(found, 20 + 10j, 20 + (high - 10) * 1j, 0.7)
        assert has(found, wide - 10 + 10j, complex(wide - 10, high - 10), 0.7)
        assert has(found, complex(20, high - 10), complex(wide - 10, high - 10), 0.7)
        for centre in (complex(wide / 2, 5), complex(wide / 2, high - 15), complex(15, high / 2)):
            along = 10j if centre.real == wide / 2 else 10
            assert has(found, centre, centre + along, 0.7)
        for k in range(1, across // 2):
            assert has(found, complex(wide / 2 + 50 * k, 5), complex(wide / 2 + 50 * k, 10), 0.35)
        for k in range(1, up // 2):
            assert has(found, complex(15, high / 2 - 50 * k), complex(20, high / 2 - 50 * k), 0.35)
        block = complex(wide - 10 - 180, 10)
        assert has(found, block, block + 180, 0.7)
        assert has(found, block + 36j, block + 180 + 36j, 0.7)
        assert has(found, block, block + 36j, 0.7)


def test_zones_are_named() -> None:
    told = words(sheet("pdf", "a2", "iso", "en")).split()
    assert [told.count(str(k)) >= 2 for k in range(1, 13)] == [True] * 12
    assert [told.count(letter) >= 2 for letter in "ABCDEFGH"] == [True] * 8
    assert "I" not in told
    assert "A2" in told


CAPTIONS = {
    "en": (
        "Rev.",
        "Doc. No.",
        "Drawn",
        "Checked",
        "Techn. ctrl.",
        "Stand. ctrl.",
        "Approved",
        "Letter",
        "Mass",
        "Scale",
    ),
    "uk": (
        "Зм.",
        "Арк.",
        "№ докум.",
        "Підп.",
        "Дата",
        "Розроб.",
        "Перевір.",
        "Т. контр.",
        "Н. контр.",
        "Затв.",
        "Літ.",
        "Маса",
    ),
}


@pytest.mark.parametrize("language", CAPTIONS)
def test_the_title_block_can_be_searched(language: str) -> None:
    more = {"en": ("Sheet 1", "Sheets 1", "Format A1"), "uk": ("Масштаб", "Аркуш 1", "Аркушів 1", "Формат A1")}
    for told in (words(sheet("pdf", "a1", "gost", language)), dxf_words(sheet("dxf", "a1", "gost", language))):
        for word in (*CAPTIONS[language], *more[language], "Shaper", "Plan", "in Plan"):
            assert word in told
        for word in ("TMM 12.07.001", "O. Kovalenko", "I. Petrenko", "T. Control", "N. Control", "A. Head", "Steel"):
            assert word in told
        assert told.count("TMM 12.07.001") == 2  # upside down in the corner too


def test_iso_says_what_the_standard_asks_for() -> None:
    told = words(sheet("pdf", "a3", "iso", "en"))
    for word in (
        "Legal owner",
        "Identification number",
        "Date of issue",
        "Sheet",
        "Title",
        "Created by",
        "Approved by",
    ):
        assert word in told
    for word in ("1/1", "University", "2026-11-23", "Document type", "TMM 12.07.001"):
        assert word in told


def test_paper_without_a_frame_says_what_it_is() -> None:
    assert "Shaper. Kinematics of the linkage. Sheet 1 of 1" in words(sheet("pdf", "a3", "none", "en"))
    assert "Shaper. Кінематика важільного механізму. Аркуш 1 з 1" in words(sheet("pdf", "a3", "none", "uk"))


def test_long_texts_stay_in_their_cells() -> None:
    from tmmcalc.report.drawing.shapes import Words
    from tmmcalc.report.drawing.wording import corners

    long = "A chair with a very long name of many words in the university of an even longer name in a city"
    who = WhoTable(designation="T" * 60, drawn_by="Q" * 50, organisation=long, material=long, letter="ABC")
    for frame, size_of in (("gost", (185, 55)), ("iso", (180, 36))):
        style = Style("a3", frame, "en", long, who)
        (made,), _ = planned([toy("Plan", (200, 150))], style)
        drawing = drawn(made, style, failed)
        margin = 5 if frame == "gost" else 10
        left, top = 420 - margin - size_of[0], margin + size_of[1]
        inside = [
            w
            for w in drawing.shapes
            if isinstance(w, Words) and left < w.at.real < 420 - margin and margin < w.at.imag < top
        ]
        assert len(inside) > 10
        for each in inside:
            box = corners(each)
            assert left - EXACT < box.real.min() < box.real.max() < 420 - margin + EXACT
            assert margin - EXACT < box.imag.min() < box.imag.max() < top + EXACT, each.text
