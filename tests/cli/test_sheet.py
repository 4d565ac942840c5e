"""``tmmcalc sheet``: which sheets, in which forms, what is refused, what of the spec holds; drawn of toy pieces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from pages import size, words
from report.sheets.toys import toy

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.sheets.piece import Piece
from tmmcalc.report.sheets.wish import positions_of
from tmmcalc.rooms import STAGES

from .conftest import Cli

WHO = '\n[sheets]\nformat = "a3"\nlanguage = "uk"\n[sheets.who]\ndesignation = "TMM-{sheet}"\n'


def of_linkage(order: Order) -> Iterator[Piece]:
    result = order.results["kinematics"]
    for row in positions_of(order, result.labels) or [0]:
        yield toy(f"Plan of position {result.labels[row]}", (150, 100))


def of_forces(order: Order) -> Iterator[Piece]:
    yield toy("Polygons", (300, 200), (200, 150), sheet="forces")
    yield toy("Lever", (300, 200), (200, 150), sheet="forces")


def broken(order: Order) -> Iterator[Piece]:
    def draw(drawing: object, box: object) -> None:
        raise NoSolutionError("there is no lever", where="forces")

    yield next(of_forces(order))
    yield Piece("forces", "Lever", draw, (20, 20), (200, 200))


@pytest.fixture(autouse=True)
def pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of all stages these two alone offer pieces."""
    for name, stage in STAGES.items():
        if stage.picture is not None:
            offered = {"kinematics": f"{__name__}:of_linkage", "forces": f"{__name__}:of_forces"}.get(name, "")
            monkeypatch.setitem(STAGES, name, replace(stage, picture=replace(stage.picture, pieces=offered)))


def test_the_sheets_that_the_scene_has(cli: Cli) -> None:
    code, out, err = cli("sheet", "my.toml", "-o", "drawn")
    assert (code, out) == (0, "")
    assert err.endswith("2 sheets in drawn: linkage.pdf, forces.pdf\n")
    assert sorted(file.name for file in Path("drawn").iterdir()) == ["forces.pdf", "linkage.pdf"]
    data = Path("drawn/forces.pdf").read_bytes()
    assert size(data) == pytest.approx((841, 594), abs=0.01)
    assert "2/2" in words(data)
    assert Path("my.out/kinematics.toml").is_file()


def test_results_are_stored_once(cli: Cli) -> None:
    assert cli("run", "my.toml", "--to", "forces", "-q").code == 0
    assert "3 stages loaded" not in cli("sheet", "my.toml").err
    before = {file: file.stat().st_mtime_ns for file in Path("my.out").iterdir() if file.suffix == ".toml"}
    assert cli("sheet", "my.toml", "-q") == (0, "", "")
    assert all(file.stat().st_mtime_ns == time for file, time in before.items() if file.stem in STAGES)
    Path("other.toml").write_text(Path("my.toml").read_text())
    assert cli("sheet", "other.toml", "--no-store", "-q") == (0, "", "")
    assert not Path("other.out").exists()
    assert Path("other.sheets/linkage.pdf").read_bytes() == Path("my.sheets/linkage.pdf").read_bytes()


def test_all_forms(cli: Cli) -> None:
    assert cli("sheet", "my.toml", "--as", "pdf,dxf,svg,png", "--only", "2", "--format", "a3", "-q") == (0, "", "")
    beginnings = {".pdf": b"%PDF", ".dxf": b"  0\nSECTION", ".svg": b"<?xml", ".png": b"\x89PNG"}
    files = {file.suffix: file for file in Path("my.sheets").iterdir()}
    assert {suffix: files[suffix].read_bytes()[: len(begin)] for suffix, begin in beginnings.items()} == beginnings
    assert {file.stem for file in files.values()} == {"forces"}


def test_the_table_of_the_spec_and_flags_over_it(cli: Cli) -> None:
    with Path("my.toml").open("a") as file:
        file.write(WHO)
    assert cli("sheet", "my.toml", "-q", "--only", "1") == (0, "", "")
    data = Path("my.sheets/linkage.pdf").read_bytes()
    assert size(data) == pytest.approx((420, 297), abs=0.01)
    told = words(data)
    assert "Розроб." in told  # gost is usual in Ukrainian
    assert "TMM-1" in told
    flags = (
        "--language",
        "en",
        "--format",
        "a2",
        "--set",
        "sheets.who.designation='other'",
        "--set",
        "sheets.positions=[7]",
    )
    assert cli("sheet", "my.toml", "-q", *flags) == (0, "", "")
    data = Path("my.sheets/linkage.pdf").read_bytes()
    assert size(data) == pytest.approx((594, 420), abs=0.01)
    assert "other" in words(data)
    assert "Identification number" in words(data)
    assert "Plan of position 7" in words(data)
    assert cli("sheet", "my.toml", "-q", "--frame", "none").code == 0
    assert "Розроб." not in words(Path("my.sheets/linkage.pdf").read_bytes())


def test_pages_for_a_printer_at_home(cli: Cli) -> None:
    code, _, err = cli("sheet", "my.toml", "--tile", "a4", "--as", "pdf,svg")
    assert (code, err.splitlines()[-1]) == (
        0,
        "2 sheets in my.sheets: linkage-a4.pdf, linkage.svg, forces-a4.pdf, forces.svg",
    )
    assert sorted(size(Path("my.sheets/linkage-a4.pdf").read_bytes())) == pytest.approx([210, 297], abs=0.01)


def test_a_further_sheet_is_told(cli: Cli) -> None:
    code, _, err = cli("sheet", "my.toml", "--format", "a3", "--frame", "gost")
    assert code == 0
    assert "warning: forces-2 is a further sheet, as forces has no room for: Lever\n" in err
    assert "3 sheets in my.sheets: linkage.pdf, forces.pdf, forces-2.pdf\n" in err
    code, _, err = cli("sheet", "my.toml", "--format", "a3", "--only", "linkage")
    assert "warning" not in err
    assert cli("sheet", "my.toml", "--format", "a3", "--only", "forces", "--strict").code == 5


def test_a_piece_that_cannot_be_drawn_leaves_its_place_empty(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    stage = STAGES["forces"]
    assert stage.picture is not None
    monkeypatch.setitem(STAGES, "forces", replace(stage, picture=replace(stage.picture, pieces=f"{__name__}:broken")))
    code, _, err = cli("sheet", "my.toml")
    assert code == 3
    assert err.endswith("error: forces: there is no lever\n")
    told = words(Path("my.sheets/forces.pdf").read_bytes())
    assert "in Polygons" in told
    assert "in Lever" not in told


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--only", "7"), "there is no sheet '7'\n  -> sheets: 1 linkage, 2 forces"),
        (("--as", "doc"), "--as: there is no form 'doc'\n  -> forms: svg, png, pdf, dxf"),
        (("--format", "a7"), "--format: there is no format 'a7'\n  -> there are: a1, a2, a3"),
        (("--frame", "din"), "--frame: there is no frame 'din'\n  -> there are: gost, iso, none"),
        (("--language", "de"), "--language: there is no language 'de'\n  -> languages: en, uk"),
        (("--tile", "a5"), "--tile: there is no paper 'a5'\n  -> paper: a4"),
        (("--tile", "a4", "--as", "dxf"), "--tile: pages are cut of a pdf\n  -> add pdf to --as, or leave --tile out"),
        (("-o", "my.toml"), "-o: my.toml: File exists\n  -> name a folder"),
        (("-o", "-"), "-o: - is standard output"),
        (("--set", "sheets.positions=[77]"), "sheets.positions: no position is called '77'"),
        (("--set", "sheets.format='a9'"), "sheets.format: 'a9' is no format of a sheet"),
    ],
)
def test_what_is_refused(cli: Cli, flags: tuple[str, ...], said: str) -> None:
    code, out, err = cli("sheet", "my.toml", *flags)
    assert (code, out) == (2, "")
    assert said in err
    assert not Path("my.sheets").exists()


def test_a_scene_without_pieces(cli: Cli) -> None:
    Path("pair.toml").write_text("[pair]\nteeth = [14, 27]\nmodule = 0.005\n")
    code, out, err = cli("sheet", "pair.toml")
    assert (code, out) == (2, "")
    assert "sheet: the scene has no picture that stands on a sheet\n  -> sheets are drawn of a linkage" in err


def test_faults_of_the_table(cli: Cli) -> None:
    with Path("my.toml").open("a") as file:
        file.write(
            '[sheets]\npositions = [2, 2]\nlanguage = "ua"\ndiagrams = []\n[sheets.who]\ndesignation = "A {n}"\n'
            'drawn = "x"\ndrawn_by = "漢"\n'
        )
    code, out, err = cli("check", "my.toml")
    assert (code, out) == (2, "")
    for said in (
        "sheets.positions: 2 is named twice\n    -> remove one of them",
        "sheets.language: 'ua' is no language of drawings\n    -> there are: en, uk",
        "sheets.diagrams: [] is an empty list\n    -> name columns",
        "sheets.who.designation: '{n}' in 'A {n}' is no place; the number of the sheet takes that of {sheet}\n    ->",
        "sheets.who.drawn: unknown key 'drawn' in [sheets.who]\n    -> did you mean \"drawn_by\"?",
        "sheets.who.drawn_by: the font of drawings has no letter '漢' of '漢'\n    -> write it in Latin",
        "my.toml: 6 faults",
    ):
        assert said in err
