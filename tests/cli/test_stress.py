"""``tmmcalc stress`` through the real entry point."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

import pytest
from sparing import sparing

from tmmcalc.stress import linkage, shipped
from tmmcalc.stress.results import DISPUTED, FAULT, Ladder, Met, Rung, Stress

from .conftest import CONFIGS, Cli


def test_ladders_of_a_spec(cli: Cli) -> None:
    code, out, err = cli("stress", "my.toml", "--ladder", "direction", "--ladder", "start", "--stage", "kinematics")
    assert (code, err) == (0, "")
    assert "direction: direction of turning" in out
    assert "start: first position over the turn" in out
    assert "faults of the program  none" in out
    assert "Traceback" not in out


@pytest.mark.slow
def test_json_and_csv_hold_every_stage_on_every_rung(cli: Cli) -> None:
    asked = ("stress", "my.toml", "--ladder", "scale", "--stage", "kinematics")
    _, out, _ = cli(*asked, "--format", "json")
    told: dict[str, Any] = json.loads(out)
    assert told["faults"] == 0
    _, out, _ = cli(*asked, "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert {row["stage"] for row in rows} == {"structure", "kinematics"}
    moving = [row for row in rows if row["stage"] == "kinematics"]
    assert len(moving) == 11
    assert all(float(row["error"]) < 1e-13 for row in moving)
    assert {row["status"] for row in moving} == {"ok"}


@sparing("suffix", ["svg", "png"], every=2)
def test_picture(cli: Cli, suffix: str) -> None:
    code, _, err = cli("stress", "my.toml", "--ladder", "direction", "--stage", "kinematics", "--plot", f"a.{suffix}")
    assert code == 0
    assert f"wrote a.{suffix}" in err
    assert Path(f"a.{suffix}").stat().st_size > 5000


@pytest.mark.parametrize(
    ("flags", "words"),
    [
        (("my.toml", "--ladder", "up"), "no ladder is called 'up'"),
        (("my.toml", "--ladder", "cusp"), "no cam"),
        (("my.toml", "--stage", "kinematic"), "kinematics"),
        (("my.toml", "--plot", "a.txt"), "format"),
        (("my.toml", "-o", "a.svg", "--plot", "a.svg"), "a.svg would be written twice"),
        (("none.toml",), "there is no file"),
        (("--ladder", "scale"), "no spec is named"),
    ],
)
def test_refusals(cli: Cli, flags: tuple[str, ...], words: str) -> None:
    code, out, err = cli("stress", *flags)
    assert (code, out) == (2, "")
    assert words in err


def test_overrides(cli: Cli) -> None:
    code, _, err = cli("stress", "my.toml", "--set", "mechanism.grid.positions=2")
    assert code == 2
    assert "mechanism.grid.positions" in err


def test_shipped_scenes(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        shipped, "scenes", lambda: ["extreme/positions-few", "extreme/dead-point", "extreme/couple-pure"]
    )
    code, out, err = cli("stress")
    assert (code, err) == (0, "")
    assert "dead-point: exit code 3, kinematics" in out
    assert "faults of the program  none" in out


def test_all_extreme_scenes_are_shipped() -> None:
    assert len(shipped.scenes()) == len(list((CONFIGS / "extreme").glob("*.toml"))) >= 50


def test_a_fault_ends_with_exit_code_1(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    rung = Rung("x 1", 1.0, None, (Met("forces", FAULT, 1, "forces.error is no finite number"),))
    found = Stress((Ladder("scale", "units", "s", "itself", (rung,)),), ())
    monkeypatch.setattr("tmmcalc.stress.run.solve_stress", lambda *_: found)
    code, out, _ = cli("stress", "my.toml")
    assert code == 1
    assert "warning: scale, x 1: forces: forces.error is no finite number" in " ".join(out.split())


@sparing("form", ["csv", "json", "toml", "table"], every=4)
def test_the_tables_in_a_file_and_not_printed(cli: Cli, form: str) -> None:
    asked = ("stress", "my.toml", "--ladder", "direction", "--stage", "kinematics", "-f", form)
    _, printed, _ = cli(*asked)
    code, out, err = cli(*asked, "-o", "stress.out")
    assert (code, out) == (0, "")
    assert "wrote stress.out" in err
    assert Path("stress.out").read_text(encoding="utf-8") == printed


@pytest.mark.slow
def test_numbers_keep_their_digits(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(linkage, "DISTANCES", (1.0, 1e-8, 0.0))
    ladders = "--ladder", "dead-point", "--ladder", "direction"
    _, out, _ = cli("stress", "my.toml", *ladders, "--stage", "kinematics", "-f", "json")
    whole: dict[str, Any] = json.loads(out)
    assert all(isinstance(value, float) for value in whole["columns"]["at worst"])
    (part,) = (value for name, value in whole.items() if name.startswith("dead-point"))
    _, out, _ = cli("stress", "my.toml", *ladders, "--stage", "kinematics", "-f", "csv")
    rows = [row for row in csv.DictReader(io.StringIO(out)) if row["ladder"] == "dead-point"]
    told = {rung["setting"]: rung["condition"] for rung in part["rungs"] if "condition" in rung}
    assert told == {row["setting"]: float(row["condition"]) for row in rows if row["condition"]}
    assert part["columns"]["1/regularity"][: len(told)] == list(told.values())
    errors = {met["error"] for rung in part["rungs"] for met in rung["met"] if "error" in met}
    assert errors == {float(row["error"]) for row in rows if row["error"]}
    assert any(len(f"{error!r}") > 10 for error in errors)


def test_a_folder_that_is_not_there(cli: Cli) -> None:
    code, out, err = cli("stress", "my.toml", "-o", "nowhere/stress.csv")
    assert (code, out) == (2, "")
    assert "there is no folder nowhere" in err


@pytest.mark.slow
def test_a_fault_in_the_twin_alone_ends_with_exit_code_1(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    def unwritten(document: object) -> None:
        raise ValueError("no such unit")

    monkeypatch.setattr(linkage, "DISTANCES", (1.0,))
    monkeypatch.setattr("tmmcalc.stress.run.twin", unwritten)
    code, out, _ = cli("stress", "my.toml", "--ladder", "dead-point", "--stage", "kinematics")
    assert code == 1
    assert "twin: in other units: ValueError: no such unit" in " ".join(out.split())


def test_disputed_results_are_told(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    met = Met("forces", DISPUTED, message="in other units: dead point", skipped=("all (no result)",))
    found = Stress((Ladder("scale", "units", "s", "itself", (Rung("x 1", 1.0, None, (met,)),)),), ())
    monkeypatch.setattr("tmmcalc.stress.run.solve_stress", lambda *_: found)
    code, out, _ = cli("stress", "my.toml")
    assert code == 0
    for words in (
        "forces on scale: refused by the equivalent scene",
        "x 1: forces is disputed, in other units: dead point",
        "x 1: not compared in forces: all (no result)",
        "forces: disputed",
    ):
        assert words in " ".join(out.split())
    _, out, _ = cli("stress", "my.toml", "-f", "csv")
    (row,) = csv.DictReader(io.StringIO(out))
    assert (row["status"], row["told"], row["skipped"]) == ("disputed", "no", "all (no result)")


@pytest.mark.slow
def test_the_table_on_top_has_what_is_lost_and_who_tells(cli: Cli) -> None:
    code, out, _ = cli("stress", "my.toml", "--ladder", "dead-point", "--stage", "kinematics")
    assert code == 0
    top = out.split("dead-point: toward")[0]
    assert "told by" in top
    assert "estimate" in top
    assert "of other scenes" not in top
    _, out, _ = cli("stress", "my.toml", "--ladder", "direction", "--stage", "kinematics")
    assert "all stages on all ladders keep twelve digits" in " ".join(out.split())
