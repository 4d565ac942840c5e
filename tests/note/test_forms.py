"""The note in its forms: read back, in both languages, nothing over the edge, no word of the other language."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Iterator
from html.parser import HTMLParser
from io import BytesIO
from typing import Any
from xml.etree import ElementTree

import pytest

from note.scenes import CONFIGS, SPECS, written
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.docx import document
from tmmcalc.note.html import page
from tmmcalc.note.tree import Contents, Cover, Equation, Grid, Image, Points, Text, Title, Written, plain_text, tied
from tmmcalc.note.typst import pdf, source
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.layout import Row
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.formula.setting import letters
from tmmcalc.report.formula.symbols import symbol_of
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.typst import typst
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Chapter, Heading, Line, Paragraph, Place, Table

LATIN = re.compile(r"[A-Za-z]{3,}")
KINDS = {"RRR", "RRP", "RPR", "PRP", "RPP"}  # of dyads
NUMERALS = {"III", "VII"}  # of meshes
MARKS = {"AIR", "ISO"}  # of motors, of standards
NAMED = {"resistance"}  # the load of a linkage that is sought
MM = 72 / 25.4


@pytest.fixture(scope="module", params=["en", pytest.param("uk", marks=pytest.mark.slow)])
def spoken(request: pytest.FixtureRequest) -> Any:
    """A language, and the shaper's note in it."""
    with speaking(request.param):
        yield request.param, written("shaper")


def test_a_pdf_keeps_its_margins_and_can_be_searched(spoken: Any) -> None:
    language, note = spoken
    reader = pytest.importorskip("pypdfium2")
    read = reader.PdfDocument(pdf(source(note, language, "Shaper")))
    assert 10 <= len(read) <= 52
    whole = ""
    for sheet in read:
        found = sheet.get_textpage()
        whole += found.get_text_bounded()
        assert sheet.get_size() == pytest.approx((210 * MM, 297 * MM), abs=0.1)
        for k in range(found.count_rects()):
            left, bottom, right, top = found.get_rect(k)
            assert left >= 25 * MM - 0.5
            assert right <= 200 * MM + 7.0  # the space that ends a line
            assert bottom >= 9 * MM  # the number of the page
            assert top <= 282 * MM + 2.0  # ascenders
    assert {"en": "Force analysis", "uk": "Силовий розрахунок"}[language] in whole


@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n == "shaper" else pytest.mark.slow) for n in SPECS])
def test_ukrainian_has_no_english_left(name: str) -> None:
    """Latin words are names that the spec gives; in formulas there are indices and functions."""
    with speaking("uk"):
        note = written(name)
        formulas = [plain(part) for each in note if isinstance(each, Equation) for part in each.parts]
    own = set(LATIN.findall((CONFIGS / f"{name}.toml").read_text(encoding="utf-8")))
    assert not set(LATIN.findall(" ".join(words(note)))) - own - KINDS - NUMERALS - MARKS - NAMED
    assert not [formula for formula in formulas if re.search(r"\d\.\d", formula)]
    assert not [formula for formula in formulas if re.search(r"−0(,0*)?(?![\d,])", formula)]


def words(note: list[Written]) -> Iterator[str]:
    """The words of a note without its formulas."""
    for each in note:
        match each:
            case Title(_, said):
                yield from said_in(said)
            case Contents(said):
                yield said
            case Cover(head, kind, _, people, foot):
                yield from (*head, *kind, foot, *(each for pair in people for each in pair))
            case Image(caption):
                yield from said_in(caption.whole)
            case Equation(_, _, lead):
                yield lead
            case Text():
                yield from said_in(each)
            case Points(items):
                yield from (part for item in items for part in said_in(item))
            case Grid(caption, head, rows):
                yield from said_in(caption.whole)
                yield from (part for row in (head, *rows) for cell in row for part in said_in(cell))


def said_in(text: Text) -> Iterator[str]:
    yield from (part for part in text.parts if isinstance(part, str))


@pytest.mark.slow
def test_a_document_of_word_has_every_formula_as_an_equation(spoken: Any) -> None:
    _, note = spoken
    archive = zipfile.ZipFile(BytesIO(document(note, "Shaper")))
    assert archive.testzip() is None
    root = ElementTree.fromstring(archive.read("word/document.xml"))
    math = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"
    equations = [each for each in note if isinstance(each, Equation)]
    assert len(root.findall(f".//{math}oMath")) >= len(equations)
    assert all(len(each) for each in root.iter(f"{math}num"))
    said = "".join(each.text or "" for each in root.iter() if each.tag.endswith("}t"))
    assert all(f"({each.number})" in said for each in equations if each.number)
    assert all(tied(part) in said for part in words(note))


class Balance(HTMLParser):
    """Counts what is open, and notes what is asked for from elsewhere."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.links: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.links += [
            str(value) for name, value in attrs if name in ("src", "href") and not str(value).startswith("#")
        ]
        if tag not in ("meta", "mspace"):
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        pass

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_a_page_is_whole_and_asks_for_nothing(spoken: Any) -> None:
    language, note = spoken
    read = Balance()
    found = page(note, "Shaper", language)
    read.feed(found)
    assert not read.open
    assert not read.links
    assert f'lang="{language}"' in found
    assert all(plain_text(each.text) in found for each in note if isinstance(each, Title))


def test_formulas_are_numbered_in_a_row(spoken: Any) -> None:
    numbers = [each.number for each in spoken[1] if isinstance(each, Equation) and each.number]
    by_chapter: dict[str, list[int]] = {}
    for number in numbers:
        chapter, _, rest = number.partition(".")
        by_chapter.setdefault(chapter, []).append(int(rest))
    assert [*by_chapter] == sorted(by_chapter)
    assert all(found == list(range(1, len(found) + 1)) for found in by_chapter.values())


def test_a_semicolon_behind_a_reference_stays() -> None:
    """In Typst the first one behind a call ends it and is not set."""
    blocks = (Paragraph("In table {tab:a}; see there."), Table("A", ("B",), (("c",),), "a"))
    assert "[1.1];; see there." in source(Assembler().written([Chapter("x", "X", blocks)]), "en", "X")


def test_letters_within_the_meaning_of_a_letter_are_set_as_letters() -> None:
    lexicon = {"S'": Given(2.0, "", "derivative by $k$"), "a": Given(2.0, "", "")}
    line = Line(read("S' = a"), (Place("", lexicon),))
    found = next(each for each in Assembler().written([Chapter("x", "X", (line,))]) if isinstance(each, Text))
    assert Row((letters(symbol_of("k")),)) in found.parts
    assert "derivative by k" in plain_text(found)


def test_words_in_an_index_have_no_gaps_beside_them() -> None:
    """A space beside a text in the mathematics of Typst is set as one."""
    for name in ("M_{F,A}", "a_{Σ,max}", "v_{W2(3,4)C}", "R_{x1,i}"):
        index = typst(letters(symbol_of(name))).partition("b: ")[2].partition(", t:")[0]
        assert " " not in index.replace(", upright", ",upright"), index


@pytest.mark.parametrize(
    ("names", "unit", "meaning", "told"),
    [
        (("R_x", "R_y"), "N", "reaction of link 1", "projections of the reaction of link 1"),
        (("x_A", "y_A"), "m", "pivot of the crank", "coordinates of the pivot of the crank"),
        (("v_x", "v_y"), "m/s", "projections of the velocity", "projections of the velocity"),
        (("z_1", "z_2"), "", "number of teeth", "numbers of teeth"),
    ],
)
def test_letters_of_one_meaning_are_explained_together(
    names: tuple[str, str], unit: str, meaning: str, told: str
) -> None:
    lexicon = {name: Given(2.0, unit, meaning) for name in names} | {"S": Given(4.0, unit, "sum")}
    line = Line(read(f"S = {names[0]} + {names[1]}"), (Place("", lexicon),))
    with speaking("en"):
        found = next(each for each in Assembler().written([Chapter("x", "X", (line,))]) if isinstance(each, Text))
    assert told in plain_text(found)


@pytest.mark.parametrize(("words", "floating"), [(1, 2), (2000, 1)])
def test_tables_that_follow_a_waiting_one_float_after_it(words: int, floating: int) -> None:
    """One that stood in the text would come before the one that waits for the next page."""
    long, short = (Table("A", ("B",), ((60 * "b ",),) * rows, f"t{rows}") for rows in (20, 3))
    note = Assembler().written([Chapter("x", "X", (long, Paragraph("word " * words), short, Heading("C")))])
    assert source(note, "en", "X").count("#floated(") == floating


def test_what_ends_with_a_colon_is_not_parted_from_what_it_leads_to() -> None:
    blocks = (Paragraph("The table:"), Table("A", ("B",), (("c",),), "a"))
    note = Assembler().written([Chapter("x", "X", blocks)])
    assert "#leading[The table:]" in source(note, "en", "X")
    root = ElementTree.fromstring(zipfile.ZipFile(BytesIO(document(note, "X"))).read("word/document.xml"))
    space = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
    (paragraph,) = (p for p in root.iter(f"{space}p") if "The table:" in "".join(p.itertext()))
    assert paragraph.find(f"{space}pPr/{space}keepNext") is not None


def test_a_formula_at_the_end_of_a_page_is_not_parted_from_what_its_letters_are() -> None:
    """Down the page line by line: somewhere the formula would be the last line of it."""
    reader = pytest.importorskip("pypdfium2")
    said = "way of the slider from the far end of its stroke, where the crank and the rod lie in one line, to the place"
    told = {"v": Given(6.0, "m/s", "mean velocity"), "s": Given(3.0, "m", said), "t": Given(0.5, "s", "time")}
    line = Line(read("v = s/t"), (Place("", told),))
    ends = []
    for count in range(25, 45):
        blocks = (Paragraph("The line."),) * count
        note = Assembler().written([Chapter("x", "Motion", (*blocks, line, *blocks[:9]))])
        pages = [sheet.get_textpage().get_text_bounded() for sheet in reader.PdfDocument(pdf(source(note, "en", "")))]
        assert not any(page.startswith("where") for page in pages), count
        ends.append(pages[0].count("The line."))
    assert min(ends) < max(ends) < 45  # the end of the page was passed


def test_numbers_of_parts_without_a_chapter_do_not_begin_anew_in_word() -> None:
    parts = [Chapter(name, name, (Table("A", ("B",), (("c",),), name),), number="") for name in ("task", "conclusions")]
    held = document(Assembler().written(parts), "X")
    said = zipfile.ZipFile(BytesIO(held)).read("word/document.xml").decode()
    assert re.findall(r"SEQ Table \\\* ARABIC \\s 1 \\r (\d)", said) == ["1", "2"]


def test_contents_of_word_lead_to_their_titles_and_ask_for_pages() -> None:
    """Their lines are links with fields of pages; what Word writes anew when it opens the file looks the same."""
    titles = [Title("1", Text(("Motion",)), 1), Title("1.1", Text(("Plans",)), 2), Title("", Text(("Conclusions",)), 1)]
    archive = zipfile.ZipFile(BytesIO(document([Contents("Contents", 3), *titles], "X")))
    space = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
    root, styles, settings = (
        ElementTree.fromstring(archive.read(f"word/{part}.xml")) for part in ("document", "styles", "settings")
    )
    marks = [each.get(f"{space}name") for each in root.iter(f"{space}bookmarkStart")]
    links = [*root.iter(f"{space}hyperlink")]
    assert [link.get(f"{space}anchor") for link in links] == marks
    codes = ["".join(each.text or "" for each in link.iter(f"{space}instrText")) for link in links]
    assert codes == [f" PAGEREF {mark} \\h " for mark in marks]
    update = settings.find(f"{space}updateFields")
    assert update is not None
    assert update.get(f"{space}val") == "true"
    named = {style.find(f"{space}name").get(f"{space}val"): style for style in styles.iter(f"{space}style")}  # type: ignore[union-attr]
    worn = [
        each.get(f"{space}val")
        for paragraph in root.iter(f"{space}p")
        if paragraph.find(f"{space}hyperlink") is not None
        for each in paragraph.iter(f"{space}pStyle")
    ]
    kinds = [named[f"toc {level}"].get(f"{space}styleId") for level in (1, 2, 1)]
    assert worn == kinds
    for level in (1, 2):
        tab = named[f"toc {level}"].find(f".//{space}tab")
        assert tab is not None
        assert tab.get(f"{space}leader") == "dot"
