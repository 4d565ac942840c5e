"""``-f xlsx``: where the workbook goes, and that every number of a run stands in it."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import openpyxl
import pytest
from sparing import sparing

from .conftest import CONFIGS, Cli


def number(cell: str) -> object:
    """A cell of a CSV as a workbook has it."""
    try:
        return int(cell) if cell.isdecimal() else float(cell)
    except ValueError:
        return cell or None


def table(page: openpyxl.worksheet.worksheet.Worksheet) -> list[list[object]]:
    """The table of a page, without what stands beside it."""
    width = openpyxl.utils.range_boundaries(page.auto_filter.ref)[2]
    height = openpyxl.utils.range_boundaries(page.auto_filter.ref)[3]
    return [[cell.value for cell in row] for row in page.iter_rows(1, height, 1, width)]


@sparing("name", ["shaper", "pair-spur", "cam", "manipulator"], every=4, first=1)
def test_a_run_in_a_workbook_is_that_in_csv_and_json(cli: Cli, name: str) -> None:
    spec = str(CONFIGS / f"{name}.toml")
    told = json.loads(cli("run", spec, "-o", "out", "-f", "json").out)
    code, out, err = cli("run", spec, "-o", "out", "-f", "xlsx")
    assert (code, out) == (0, "")
    assert "wrote out/run.xlsx" in err
    book = openpyxl.load_workbook("out/run.xlsx")
    assert book.sheetnames[:2] == ["given", "summary"]
    for file in Path("out").glob("*.csv"):
        rows = list(csv.reader(io.StringIO(file.read_text())))
        if len(rows) <= 2001:
            page = book[file.stem]
            assert table(page) == [rows[0], *([number(cell) for cell in row] for row in rows[1:])]
            assert page.freeze_panes in ("A2", "B2")
    stages = {stage for stage, part in told.items() if isinstance(part, dict)}
    rows = list(book["summary"].iter_rows(2, values_only=True))
    assert {row[0] for row in rows} == stages
    found = {(row[0], f"{row[1]}[{row[4]}]" if row[4] else row[1]): row[3] for row in rows}
    for stage in stages:
        for key, value in told[stage].items():
            if isinstance(value, int | float | bool):
                assert found[stage, key] == value, (stage, key)
    assert sum(bool(row[5]) for row in rows) > 0.9 * len(rows)


@pytest.mark.slow
def test_the_charts_of_a_run(cli: Cli) -> None:
    cli("run", str(CONFIGS / "shaper.toml"), "-o", "out", "-f", "xlsx", "-q")
    book = openpyxl.load_workbook("out/run.xlsx")
    drawn = {page.title: len(page._charts) for page in book if page._charts}
    assert drawn == {"charts": 15, "kinematics": 6, "forces": 2, "reduction": 2, "motion": 4, "balance": 1}
    named = [chart.series[0].tx.strRef.f for chart in book["kinematics"]._charts]
    assert named[:2] == ["kinematics!$C$1", "kinematics!$D$1"]
    assert (book["kinematics"]["C1"].value, book["kinematics"]["D1"].value) == ("S_D[m]", "vS_D[m/s]")


def test_what_is_given(cli: Cli) -> None:
    cli("run", "my.toml", "-f", "xlsx", "-o", "a.xlsx", "-q", "--set", 'mechanism.input.speed="60 rpm"')
    rows = {row[0]: row[1:] for row in openpyxl.load_workbook("a.xlsx")["given"].iter_rows(values_only=True)}
    assert rows["key"] == ("value", "unit", "written", "meaning")
    assert rows["mechanism.input.speed"][:3] == (6.283185307179586, "rad/s", "60 rpm")
    assert rows["mechanism.links[0].points.A[0]"][1:3] == ("m", "200 mm")
    assert rows["mechanism.links[0].points.A[0]"][0] == 0.2


def test_a_table_of_a_command(cli: Cli) -> None:
    asked = ("kinematics", "my.toml", "--columns", "phi,S_D", "--positions", "0:6", "-q")
    rows = list(csv.reader(io.StringIO(cli(*asked, "-f", "csv").out)))
    assert cli(*asked, "-f", "xlsx", "-o", "few.xlsx").code == 0
    book = openpyxl.load_workbook("few.xlsx")
    assert book.sheetnames == ["summary", "charts", "kinematics"]
    assert table(book["kinematics"]) == [rows[0], *([number(cell) for cell in row] for row in rows[1:])]
    assert len(book["kinematics"]._charts) == 1
    beside = [row[4] for row in book["kinematics"].iter_rows(1, 3, values_only=True)]
    assert beside == [f"error estimate: {what}" for what in ("position", "velocity", "acceleration")]


def test_a_hostile_title_and_name_stay_texts(cli: Cli) -> None:
    text = Path("my.toml").read_text().replace('title = "', 'title = "=cmd|calc!A0 ')
    assert "=cmd" in text
    Path("my.toml").write_text(text)
    cli("run", "my.toml", "-f", "xlsx", "-o", "a.xlsx", "-q")
    cell = next(
        row[1] for row in openpyxl.load_workbook("a.xlsx")["given"].iter_rows() if row[0].value == "project.title"
    )
    assert (cell.value[:5], cell.data_type) == ("=cmd|", "s")


def test_standard_output_into_a_pipe(process: Cli, folder: Path) -> None:
    import subprocess
    import sys

    done = subprocess.run(
        [sys.executable, "-m", "tmmcalc", "forces", "my.toml", "-f", "xlsx"], capture_output=True, check=True
    )
    assert openpyxl.load_workbook(io.BytesIO(done.stdout)).sheetnames == ["summary", "charts", "forces"]
    assert b"PK" not in done.stderr
    assert not list(folder.rglob("*.xlsx"))


def test_on_a_terminal_it_goes_into_the_folder(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tmmcalc.cli.job.sys.stdout.isatty", lambda: True, raising=False)
    assert cli("forces", "my.toml", "-f", "xlsx", "-q") == (0, "", "")
    assert Path("my.out/forces.xlsx").is_file()
    code, out, err = cli("forces", "my.toml", "-f", "xlsx", "--no-store")
    assert (code, out) == (2, "")
    assert "there is no folder for the workbook\n  -> name its file, such as -o my.xlsx" in err
    code, out, err = cli("plan", "my.toml", "-f", "xlsx")
    assert (code, out) == (2, "")
    assert "a workbook cannot be shown on a terminal" in err


def test_the_same_workbook_is_left_alone(cli: Cli) -> None:
    cli("run", "my.toml", "-f", "xlsx", "-o", "a.xlsx", "-q")
    before = Path("a.xlsx").stat().st_mtime_ns
    cli("run", "my.toml", "-f", "xlsx", "-o", "a.xlsx", "-q")
    assert Path("a.xlsx").stat().st_mtime_ns == before


def test_a_makefile_knows_the_workbook(cli: Cli) -> None:
    cli("run", "my.toml", "--to", "kinematics", "-f", "xlsx", "-o", "a.xlsx", "-q", "--depfile", "a.d")
    targets, _, needs = Path("a.d").read_text().partition(":")
    assert "a.xlsx" in targets
    assert "my.toml" in needs


@pytest.mark.slow
def test_several_specs_have_a_workbook_each(cli: Cli) -> None:
    Path("b.toml").write_text(Path("my.toml").read_text())
    code, out, _ = cli("run", "my.toml", "b.toml", "--to", "kinematics", "-f", "xlsx", "-o", "all", "-q")
    assert code == 0
    assert out.startswith("Run of several specs")
    for name in ("my", "b"):
        assert "kinematics" in openpyxl.load_workbook(f"all/{name}.out/run.xlsx").sheetnames
    code, _, err = cli("run", "my.toml", "b.toml", "-f", "xlsx", "-o", "all.xlsx")
    assert (code, "every spec has its own workbook" in err) == (2, True)


def test_a_long_table_comes_if_it_is_asked_for(cli: Cli) -> None:
    asked = ("run", "my.toml", "--to", "kinematics", "--set", "mechanism.grid.positions=2400", "-f", "xlsx", "-q")
    cli(*asked, "-o", "a.xlsx")
    page = openpyxl.load_workbook("a.xlsx")["kinematics"]
    assert page["B1"].value.startswith("2401 rows of 92 columns are many: --csv writes them")
    cli(*asked, "-o", "a.xlsx", "--csv", "--columns", "phi,S_D")
    assert openpyxl.load_workbook("a.xlsx")["kinematics"].auto_filter.ref == "A1:C2402"


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("forces", "my.toml", "-o", "a.xlsx"), "-o: a.xlsx is the name of a workbook\n  -> add --format xlsx"),
        (("forces", "my.toml", "-f", "xlsx", "-o", "no/a.xlsx"), "-o: there is no folder no"),
    ],
)
def test_places_where_no_workbook_can_be(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli(*args)
    assert (code, out) == (2, "")
    assert said in err
    assert not Path("my.out").exists()


@pytest.mark.parametrize("command", ["run", "forces", "names", "plan"])
def test_without_xlsxwriter_nothing_is_computed(cli: Cli, command: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tmmcalc.report.workbook.find_spec", lambda name: None)
    code, out, err = cli(command, "my.toml", "-f", "xlsx")
    assert (code, out) == (2, "")
    assert "workbooks need XlsxWriter, which is not installed" in err
    assert "[xlsx]" in err
    assert not Path("my.out").exists()
