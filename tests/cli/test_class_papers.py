"""What the commands of a class write for people and for courses: sheets, notes, questions, results, grades."""

from __future__ import annotations

import csv
import re
import shutil
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import openpyxl
import pytest

from .conftest import CONFIGS, Cli, Once

ROSTER = "km-01@example.org\nkm-02@example.org\n=1+1@example.org\n"


@pytest.fixture
def made(cli: Cli, once: Once) -> Cli:
    """A class of three by a roster of addresses, with sheets as text."""

    def make() -> None:
        told = cli("class", "make", "assignment.toml", "--skip-mistakes", "--sheets", "txt", "-j", "1")
        assert told.code == 0
        assert told.err.splitlines()[-2:] == ["wrote class/sheets", "wrote class/answers"]

    text = (CONFIGS / "assignment-shaper.toml").read_text(encoding="utf-8")
    Path("assignment.toml").write_text(text.replace("[class]\n", '[class]\nroster = "roster.txt"\n', 1))
    Path("roster.txt").write_text(ROSTER)
    once(Path("class"), make)
    return cli


@pytest.fixture
def keyed(made: Cli, once: Once) -> Cli:
    """The same with its keys."""

    def make() -> None:
        assert made("class", "keys", "class", "-q", "-j", "1").code == 0

    once(Path("class/keys"), make)
    return made


def stems(folder: str, suffix: str) -> list[str]:
    return sorted(path.stem for path in Path(folder).glob(f"*{suffix}"))


def fill(values: dict[str, str], factor: float) -> None:
    """The answers of the first two students into their tables: right values of the keys times a factor."""
    with Path("class/keys/keys.csv").open(encoding="utf-8-sig", newline="") as lines:
        rows = [*csv.DictReader(lines)]
    for file in sorted(Path("class/answers").glob("*.csv"))[:2]:
        text = file.read_text(encoding="utf-8-sig")
        for row in rows:
            if row["variant"] == str(int(file.name[:2])):
                value = values.get(row["name"], f"{float(row['value']) * factor:.4g}")
                text = text.replace(f"\n{row['name']};;", f"\n{row['name']};{value};")
        file.write_text(text, encoding="utf-8")


def test_sheets_and_tables_stand_in_their_folders(made: Cli) -> None:
    assert stems("class/sheets", ".txt") == stems("class/answers", ".csv") == stems("class/variants", ".toml")
    assert len(stems("class/sheets", "")) == 3
    assert not Path("class/keys").exists()


@pytest.mark.slow
def test_no_sheets_and_a_form_that_there_is_not(cli: Cli) -> None:
    shutil.copy(CONFIGS / "assignment-shaper.toml", "assignment.toml")
    told = cli("class", "make", "assignment.toml", "-n", "2", "--sheets", "odt", "--skip-mistakes")
    assert (told.code, Path("class").exists()) == (2, False)
    assert told.err.startswith("error: --sheets: a task sheet has no form 'odt'")
    assert cli("class", "make", "assignment.toml", "-n", "2", "--no-sheets", "--skip-mistakes", "-q").code == 0
    assert not Path("class/sheets").exists()
    assert not Path("class/answers").exists()


def test_a_pdf_without_typst_is_one_message(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    def without(name: str, *rest: Any) -> Any:
        return None if name == "typst" else find_spec(name, *rest)

    monkeypatch.setattr("tmmcalc.note.forms.find_spec", without)
    shutil.copy(CONFIGS / "assignment-shaper.toml", "assignment.toml")
    told = cli("class", "make", "assignment.toml", "-n", "2", "--skip-mistakes")
    assert told.code == 2
    assert "--sheets: a task sheet as pdf needs typst, which is not installed" in told.err
    assert "html and txt need nothing" in told.err
    assert not Path("class").exists()


@pytest.mark.slow
def test_keys_with_notes_a_page_and_questions(made: Cli) -> None:
    words = ("--notes", "txt", "--page", "html", "--moodle", "m.xml", "--moodle-dataset", "d.xml", "-j", "1")
    told = made("class", "keys", "class", *words)
    assert told.code == 0
    assert stems("class/keys", ".txt") == stems("class/variants", ".toml")
    assert "km-02@example.org" in Path("class/keys/keys.html").read_text(encoding="utf-8")
    for file, kinds in (("m.xml", {"category", "description", "numerical"}), ("d.xml", {"category", "calculated"})):
        root = ElementTree.fromstring(Path(file).read_bytes())
        assert {each.attrib["type"] for each in root} == kinds
    again = made("class", "keys", "class", "--moodle", "m.xml", "--moodle-dataset", "m.xml")
    assert (again.code, "written twice" in again.err) == (2, True)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--page", "odt"), "--page: a page of keys has no form 'odt'"),
        (("--notes", "odt"), "--notes: a note has no form 'odt'"),
        (("--moodle", "no/m.xml"), "--moodle: there is no folder no"),
    ],
)
def test_faults_are_told_before_keys_are_made(made: Cli, words: tuple[str, ...], said: str) -> None:
    told = made("class", "keys", "class", *words)
    assert told.code == 2
    assert said in told.err
    assert not Path("class/keys").exists()


@pytest.mark.slow
def test_results_and_grades(keyed: Cli) -> None:
    fill({"H": "=1+1", "K": "<b>$x$</b>"}, 1.0)
    words = ("--sheets", "results", "--sheet-form", "html", "--full", "full.html", "--gradebook", "g.csv")
    told = keyed("class", "mark", "class", "class/answers", *words)
    assert told.code == 0, told.err
    assert len(stems("results", ".html")) == 2
    sheet = next(Path("results").glob("01*.html")).read_text(encoding="utf-8")
    assert "&lt;b&gt;x&lt;/b&gt;" in sheet
    assert "right answer" in sheet
    full = Path("full.html").read_text(encoding="utf-8")
    assert full.count("<table>") >= 4
    with Path("g.csv").open(encoding="utf-8-sig", newline="") as lines:
        rows = [*csv.reader(lines)]
    assert rows[0] == ["Email address", "Shaper: an assignment (0–8)", "Shaper: an assignment (feedback)"]
    assert [row[0] for row in rows[1:]] == ["km-01@example.org", "km-02@example.org", f"'{ROSTER.splitlines()[2]}"]
    assert [float(row[1]) for row in rows[1:3]] == [6, 6]
    assert rows[3][1:] == ["", "Nothing was handed in."]
    assert "H: unreadable" in rows[1][2]
    assert not any(cell.startswith(("=", "+", "-", "@")) for row in rows for cell in row)


def test_grades_as_a_workbook_in_ukrainian(keyed: Cli) -> None:
    fill({}, 1.0)
    told = keyed("class", "mark", "class", "class/answers", "--gradebook", "g.xlsx", "--language", "uk", "-q")
    assert told.code == 0
    page = openpyxl.load_workbook("g.xlsx").worksheets[0]
    rows = [[cell.value for cell in row] for row in page.iter_rows()]
    assert [row[1] for row in rows[1:]] == [8, 8, None]
    assert rows[1][2] == "Усі відповіді правильні."
    assert rows[3][2] == "Нічого не подано."


def test_sheets_of_results_of_another_form_are_refused(made: Cli) -> None:
    told = made("class", "mark", "class", "class/answers", "--sheets", "r", "--sheet-form", "odt")
    assert (told.code, "--sheet-form: a sheet has no form 'odt'" in told.err) == (2, True)
    told = made("class", "mark", "class", "class/answers", "--gradebook", "g.pdf")
    assert (told.code, "--gradebook" in told.err) == (2, True)


def test_a_class_of_which_nothing_is_handed_in_is_marked(keyed: Cli) -> None:
    told = keyed("class", "mark", "class", "class/answers", "-o", "marks.csv")
    assert told.code == 0
    assert "nothing from  3" in told.out
    assert Path("marks.csv").read_text(encoding="utf-8-sig").count("nothing was handed in") == 3


@pytest.mark.parametrize(
    ("name", "drawn", "ends", "asked", "told"),
    [
        ("synth-crank-rocker", "synthesis.crank_rocker.swing", ("35 deg", "45 deg", "1 deg"), "synthesis.r", "Θ"),
        ("synth-slider-crank", "synthesis.slider_crank.stroke", ("180 mm", "220 mm", "1 mm"), "synthesis.l", "S"),
        ("synth-function", "synthesis.function.input_range", ("88 deg", "92 deg", "0.5 deg"), "synthesis.b", "Δφ"),
        ("extra-bearing", "bearing.wheel_speed", ("1 m/s", "2 m/s", "0.1 m/s"), "bearing.BPFO", "v"),
        ("manipulator", "manipulator.speed", ("0.5 m/s", "0.8 m/s", "0.05 m/s"), "manipulator.T", "v_m"),
        ("pendulum-rotor", "pendulum.disc.mass", ("3 kg", "5 kg", "0.1 kg"), "pendulum.whirl", "m"),
    ],
)
def test_any_scene_has_sheets_that_tell_what_is_drawn_and_not_what_is_asked(
    cli: Cli, name: str, drawn: str, ends: tuple[str, str, str], asked: str, told: str
) -> None:
    low, high, step = ends
    draw = f'of = "{drawn}"\nat_least = "{low}"\nat_most = "{high}"\nstep = "{step}"'
    own = f'[class]\nspread = 2\n[[class.drawn]]\n{draw}\n[[class.asked]]\nname = "answer"\nresult = "{asked}"\n'
    Path("own.toml").write_text(f"{(CONFIGS / f'{name}.toml').read_text(encoding='utf-8')}\n{own}")
    assert cli("class", "make", "own.toml", "-n", "2", "--seed", "1", "--sheets", "txt", "-q", "-j", "1").code == 0
    assert cli("class", "keys", "class", "-q", "-j", "1").code == 0
    with Path("class/keys/keys.csv").open(encoding="utf-8-sig", newline="") as lines:
        right = [float(row["value"]) for row in csv.DictReader(lines)]
    sheets = [Path(f"class/sheets/{number:02d}.txt").read_text(encoding="utf-8") for number in (1, 2)]
    for sheet, value in zip(sheets, right, strict=True):
        before, after = sheet.split("Data of this variant alone")[1].split("Data of all variants")
        assert f"  {told}  " in before, "what is drawn stands under its letter among the own data"
        assert not any(abs(abs(number) - abs(value)) <= 1e-3 * abs(value) for number in numbers_in(before + after))


def numbers_in(text: str) -> list[float]:
    return [float(each) for each in re.findall(r"(?<![\w.])\d+\.?\d*", text)]
