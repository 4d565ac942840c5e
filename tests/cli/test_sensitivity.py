"""``tmmcalc sensitivity`` as its user meets it."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from cli.conftest import Cli

SHAPER = Path(__file__).parents[2] / "configs" / "shaper.toml"
CRANK, AXIS = "mechanism.links[id=1].points.A[0]", "mechanism.fixed.O[1]"


def test_the_command(cli: Cli) -> None:
    told = cli("sensitivity", str(SHAPER), "--of", "stroke_D,kinematics.K_D", "--to", f"{CRANK},{AXIS}")
    assert told.code == 0
    assert "kinematics.stroke_D" in told.out
    assert "+1 %" in told.out
    assert "200 mm" in told.out
    wide = cli("sensitivity", str(SHAPER), "--of", "kinematics.stroke_D", "--to", CRANK, "--format", "csv")
    (row,) = csv.DictReader(io.StringIO(wide.out))
    assert row["key"] == f"{CRANK}[mm]"
    assert float(row["derivative"]) == pytest.approx(0.658064516129 / 200)
    assert row["from"] == "both"
    whole = json.loads(cli("sensitivity", str(SHAPER), "--of", "stroke_D", "--to", CRANK, "--format", "json").out)
    assert whole["variants"] == 4  # that hold an exact derivative against differences
    assert row["way"] == "exact"


def test_curves_over_the_rows(cli: Cli, tmp_path: Path) -> None:
    """The displacement of the ram at its far dead centre grows as the stroke does."""
    asked = ("--curve", "kinematics.S_D", "--to", f"{CRANK},{AXIS}")
    rows = [*csv.DictReader(io.StringIO(cli("sensitivity", str(SHAPER), *asked, "--format", "csv").out))]
    assert {row["way"] for row in rows} == {"exact"}
    assert len(rows) == 2 * 25
    assert [float(row["at"]) for row in rows[:3]] == [0, 15, 30]
    assert float(rows[0]["derivative"]) == 0
    picture = tmp_path / "curves.svg"
    told = cli("sensitivity", str(SHAPER), *asked, "--picture", str(picture))
    assert told.code == 0
    assert "A mechanism.links[id=1].points.A[0]" in told.out
    assert "change for 1 % of the key" in picture.read_text(encoding="utf-8")


def test_bars_of_results(cli: Cli, tmp_path: Path) -> None:
    picture = tmp_path / "bars.svg"
    asked = ("--of", "stroke_D,kinematics.transmission_min_RRP(4,5)", "--to", f"{CRANK},{AXIS}", "--language", "uk")
    assert cli("sensitivity", str(SHAPER), *asked, "--picture", str(picture)).code == 0
    assert "Чутливість kinematics.stroke_D" in picture.read_text(encoding="utf-8")


def test_what_is_wrong_is_one_error(cli: Cli) -> None:
    told = cli("sensitivity", str(SHAPER), "--of", "stroke_D,", "--to", CRANK)
    assert told.code == 2
    assert "a name is missing" in told.err
    assert cli("sensitivity", str(SHAPER), "--of", "stroke_D", "--to", "title").code == 2
    assert "nothing is asked for" in cli("sensitivity", str(SHAPER)).err
    assert "no column is called" in cli("sensitivity", str(SHAPER), "--curve", "speed_of_light", "--to", CRANK).err
