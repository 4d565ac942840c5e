"""``tmmcalc cam law`` and ``tmmcalc cam profile`` on real files."""

from __future__ import annotations

import csv
import json
from io import StringIO
from math import radians
from pathlib import Path

import pytest

from cli.conftest import Cli

SPEC = """
[project]
title = "Cam of a press"

[cam]
follower = "translating"
rotation = "counter-clockwise"
stroke = "20 mm"
speed = "600 rpm"
rise = "80 deg"
high_dwell = "30 deg"
return_angle = "100 deg"
rise_law = "cosine"
return_law = "shun"
start_distance = "45 mm"
offset = "8 mm"
roller_radius = "9 mm"
"""


@pytest.fixture(autouse=True)
def spec(folder: Path) -> Path:
    file = folder / "cam.toml"
    file.write_text(SPEC)
    return file


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(StringIO(text)))


def test_the_law_in_words_and_as_a_table(cli: Cli) -> None:
    answer = cli("cam", "law", "cam.toml")
    assert answer.code == 0
    assert "law cosine, simple harmonic" in answer.out
    assert "soft shock at phi = 80 deg" in answer.out
    rows = rows_of(cli("cam", "law", "cam.toml", "--format", "csv").out)
    assert len(rows) == 361 + 1  # the limit before the jump at 80 deg
    top = next(row for row in rows if row["phi[deg]"] == "40.0")
    # S' = pi h/(2 phi_y)
    assert float(top["S1[m]"]) == pytest.approx(0.0225, rel=1e-12)
    assert float(top["v[m/s]"]) == pytest.approx(0.0225 * 62.83185307179586, rel=1e-12)


def test_both_sides_of_a_jump_can_be_named(cli: Cli) -> None:
    out = cli("cam", "law", "cam.toml", "--set", "cam.steps=6", "--positions", "6-,6", "--columns", "phi,S2").out
    assert "-50.625" in out
    assert cli("cam", "law", "cam.toml", "--columns", "X").code == 2


def test_files_of_the_profile(cli: Cli, folder: Path) -> None:
    answer = cli("cam", "profile", "cam.toml", "--svg", "a.svg", "--nc", "a.csv", "--tool", "20 mm")
    assert answer.code == 0
    assert "wrote a.svg and a.csv" in answer.err
    assert 'id="tool path"' in (folder / "a.svg").read_text()
    fine = len(rows_of((folder / "a.csv").read_text()))
    cli("cam", "profile", "cam.toml", "--nc", "a.csv", "--tool", "20 mm", "--tolerance", "0.1 mm")
    assert len(rows_of((folder / "a.csv").read_text())) < fine / 5


def test_the_profile_for_programs(cli: Cli) -> None:
    told = json.loads(cli("cam", "profile", "cam.toml", "--format", "json").out)
    assert "0.0368" in json.dumps(told)  # the largest roller [m]
    rows = rows_of(cli("cam", "profile", "cam.toml", "--format", "csv").out)
    assert float(rows[0]["x_c[m]"]) == pytest.approx(0.008)
    assert float(rows[0]["y_c[m]"]) == pytest.approx(0.045)


def test_an_undercut_profile_is_refused_with_the_roller_that_works(cli: Cli) -> None:
    answer = cli("cam", "profile", "cam.toml", "--set", 'cam.roller_radius="40 mm"')
    assert answer.code == 3
    assert "undercut" in answer.err
    assert "36.877" in answer.err


@pytest.mark.parametrize(
    "flags",
    [
        ["--tolerance", "1 um"],
        ["--svg", "no/a.svg"],
        ["--svg", "a", "--nc", "a"],
        ["--nc", "a.csv", "--tolerance", "1e-15"],
    ],
)
def test_flags_that_cannot_be(cli: Cli, flags: list[str]) -> None:
    assert cli("cam", "profile", "cam.toml", *flags).code == 2


def test_a_second_run_loads_what_the_first_stored(cli: Cli) -> None:
    first = cli("cam", "profile", "cam.toml")
    second = cli("cam", "profile", "cam.toml")
    assert "computed" in first.err
    assert "computed" not in second.err
    assert second.out == first.out


def test_angles_are_exact_in_the_table(cli: Cli) -> None:
    rows = rows_of(cli("cam", "law", "cam.toml", "--format", "csv").out)
    assert radians(float(rows[10]["phi[deg]"])) == pytest.approx(radians(10), rel=1e-15)
