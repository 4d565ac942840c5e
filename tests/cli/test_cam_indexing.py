"""``tmmcalc cam indexing`` on real files."""

from __future__ import annotations

import csv
import json
from io import StringIO
from pathlib import Path

import pytest

from cli.conftest import Cli

SPEC = """
[project]
title = "Indexing table"

[indexing]
rollers = 6
step_angle = "90 deg"
law = "shun"
wheel_radius = "50 mm"
centre_distance = "130 mm"
roller_radius = "12 mm"
"""


@pytest.fixture(autouse=True)
def spec(folder: Path) -> Path:
    file = folder / "lantern.toml"
    file.write_text(SPEC)
    return file


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(StringIO(text)))


def test_the_drive_in_words_and_as_a_table(cli: Cli) -> None:
    answer = cli("cam", "indexing", "lantern.toml")
    assert answer.code == 0
    assert "lambda_min = 2.25, lambda_max = 3.70167" in answer.out
    assert "k_m = 0.742217" in answer.out
    rows = rows_of(cli("cam", "indexing", "lantern.toml", "--format", "csv").out)
    assert len(rows) == 21
    assert float(rows[10]["R_B[m]"]) == pytest.approx(0.08, rel=1e-12)  # the groove passes the line of centres
    assert float(rows[20]["beta[deg]"]) == pytest.approx(60, rel=1e-12)
    stored = Path("lantern.out") / "indexing.csv"
    assert rows_of(stored.read_text()) == rows


def test_a_stored_result_is_the_computed_one(cli: Cli) -> None:
    first = cli("cam", "indexing", "lantern.toml", "--format", "json")
    again = cli("cam", "indexing", "lantern.toml", "--format", "json")
    assert first.out == again.out
    assert "1 stage loaded in" in again.err


def test_laws_and_numbers_of_rollers_in_one_table(cli: Cli) -> None:
    answer = cli("cam", "indexing", "lantern.toml", "--compare", "--format", "csv", "--set", "indexing.law='0000'")
    rows = rows_of(answer.out)
    assert [row["z2"] for row in rows[:5]] == ["6", "8", "10", "12", "14"]
    assert [round(float(row["lambda_max"]), 2) for row in rows[:5]] == [3.7, 2.14, 1.72, 1.52, 1.41]
    sine = next(row for row in rows if row["law"] == "sine")
    assert float(sine["lambda_min"]) == pytest.approx(7 / 3)
    assert sine["z2_max"] == "8"
    assert not Path("lantern.out").exists()
    assert float(sine["largest_step_given[deg]"]) == pytest.approx(147.82965, abs=1e-5)  # the spec has lambda = 2.6
    told = cli("cam", "indexing", "lantern.toml", "--compare").out
    for part in ("at lambda_min", "at lambda_max, where", "at lambda = 2.6", "limits, those of phi_p"):
        assert f"\n{part}" in told
    assert max(map(len, told.splitlines())) <= 80
    people = cli("cam", "indexing", "lantern.toml", "--compare", "--columns", "law,z2,theta2_*").out
    assert "k_m_min" not in people
    assert "theta2_max" in people


def test_files(cli: Cli) -> None:
    files = ("--svg", "a.svg", "--nc", "a.csv", "--tolerance", "10 um")
    answer = cli("cam", "indexing", "lantern.toml", *files)
    assert answer.code == 0
    assert 'id="working profile"' in Path("a.svg").read_text()
    assert len(rows_of(Path("a.csv").read_text())) > 50
    assert cli("cam", "indexing", "lantern.toml", "--tolerance", "10 um").code == 2
    assert cli("cam", "indexing", "lantern.toml", "--svg", "a.svg", "--nc", "a.svg").code == 2
    assert cli("cam", "indexing", "lantern.toml", "--compare", "--svg", "a.svg").code == 2
    assert cli("cam", "indexing", "lantern.toml", "--compare", "--positions", "1").code == 2


@pytest.mark.slow
def test_pictures(cli: Cli) -> None:
    assert cli("plot", "lantern.toml", "indexing", "-o", "a.svg", "--phase", "20 deg").code == 0
    assert Path("a.svg").stat().st_size > 10_000
    assert cli("plot", "lantern.toml", "indexing", "--positions", "3").code == 2


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ("indexing.centre_distance='110 mm'", "lambda = 2.2 is below lambda_min = 2.25"),
        ("indexing.roller_radius='30 mm'", "convex parts of B would be undercut"),
    ],
)
def test_a_drive_that_cannot_work(cli: Cli, change: str, said: str) -> None:
    answer = cli("cam", "indexing", "lantern.toml", "--set", change)
    assert answer.code == 3
    assert said in " ".join(answer.err.split())


def test_warnings_under_strict(cli: Cli) -> None:
    assert cli("cam", "indexing", "lantern.toml", "--strict").code == 0
    answer = cli("cam", "indexing", "lantern.toml", "--strict", "--set", "indexing.centre_distance='200 mm'")
    assert answer.code == 5
    assert "above lambda_max" in " ".join(answer.err.split())


def test_a_law_known_by_its_b_alone(cli: Cli) -> None:
    without = SPEC.replace('law = "shun"', "law = { peak_velocity = 1.625 }").replace('roller_radius = "12 mm"\n', "")
    Path("lantern.toml").write_text(without)
    answer = cli("cam", "indexing", "lantern.toml", "--format", "json")
    assert answer.code == 0
    assert "lambda_min" in json.dumps(json.loads(answer.out))
    assert cli("cam", "indexing", "lantern.toml").code == 0
    assert cli("run", "lantern.toml").code == 0
    assert cli("cam", "indexing", "lantern.toml", "--compare").code == 0


def test_the_whole_run_and_its_plan(cli: Cli) -> None:
    run = cli("run", "lantern.toml")
    assert run.code == 0
    assert "tip of the lobe" in run.out
    assert "indexing" in cli("plan", "lantern.toml").out
    assert cli("check", "lantern.toml").out == "lantern.toml: ok (an indexing drive of 6 rollers)\n"
