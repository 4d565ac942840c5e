"""``tmmcalc stress`` through the real entry point."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

import pytest

from tmmcalc.stress import shipped
from tmmcalc.stress.results import FAULT, Ladder, Met, Rung, Stress

from .conftest import CONFIGS, Cli


def test_ladders_of_a_spec(cli: Cli) -> None:
    code, out, err = cli("stress", "my.toml", "--ladder", "direction", "--ladder", "start", "--stage", "kinematics")
    assert (code, err) == (0, "")
    assert "direction: direction of turning" in out
    assert "start: first position over the turn" in out
    assert "faults of the program  none" in out
    assert "Traceback" not in out


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


@pytest.mark.parametrize("suffix", ["svg", "png"])
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


def test_every_stage_on_every_rung_in_a_file(cli: Cli) -> None:
    code, out, err = cli("stress", "my.toml", "--ladder", "direction", "--stage", "kinematics", "-o", "stress.csv")
    assert code == 0
    assert "wrote stress.csv" in err
    assert "direction of turning" in out
    rows = list(csv.DictReader(io.StringIO(Path("stress.csv").read_text(encoding="utf-8"))))
    assert {row["stage"] for row in rows} == {"structure", "kinematics"}
    code, out, err = cli("stress", "my.toml", "-o", "nowhere/stress.csv")
    assert (code, out) == (2, "")
    assert "there is no folder nowhere" in err


def test_the_table_on_top_has_what_is_lost_and_who_tells(cli: Cli) -> None:
    code, out, _ = cli("stress", "my.toml", "--ladder", "dead-point", "--stage", "kinematics")
    assert code == 0
    top = out.split("dead-point: toward")[0]
    assert "told by" in top
    assert "estimate" in top
    assert "of other scenes" not in top
    _, out, _ = cli("stress", "my.toml", "--ladder", "direction", "--stage", "kinematics")
    assert "all stages on all ladders keep twelve digits" in " ".join(out.split())
