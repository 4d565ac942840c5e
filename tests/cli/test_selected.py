"""``plan --why``, and stages and columns that are selected on the command line."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from .conftest import CONFIGS, Cli


def test_why_tells_of_every_stage(cli: Cli) -> None:
    shutil.copy(CONFIGS / "press.toml", "press.toml")
    code, out, err = cli("plan", "press.toml", "--why", "-f", "json")
    assert (code, err) == (0, "")
    told = json.loads(out)
    assert told["reduction"]["read_by"] == ["power", "flywheel", "motion"]
    assert "a constant moment drives: no regime under a motor is integrated" in told["motion"]["leaves_out"]
    assert told["not_imported"] == ["scipy", "joblib"]
    left = told["left out"]["columns"]
    comes = dict(zip(left["stage"], left["comes in with"], strict=True))
    assert comes["transient"] == "[[transients]]"
    assert list(Path().glob("*.out")) == []


def test_why_fits_the_terminal(cli: Cli) -> None:
    shutil.copy(CONFIGS / "elastic-drive.toml", "drive.toml")
    out = cli("plan", "drive.toml", "--why").out
    assert max(map(len, out.splitlines())) <= 80
    assert "leaves out" in out
    assert "comes in with" in out


def test_why_names_heavy_packages(cli: Cli) -> None:
    shutil.copy(CONFIGS / "vibratory-device.toml", "device.toml")
    told = json.loads(cli("plan", "device.toml", "--why", "-f", "json").out)
    assert told["packages"] == ["scipy.integrate"]
    assert told["not_imported"] == ["joblib"]


def test_run_writes_the_columns_asked_for(cli: Cli) -> None:
    assert cli("run", "my.toml", "--to", "forces", "--columns", "phi,R_*", "-o", "out", "-q").code == 0
    assert Path("out/kinematics.csv").read_text().startswith("i,phi[deg]\n")
    head = Path("out/forces.csv").read_text().partition("\n")[0].split(",")
    assert head[:2] == ["i", "phi[deg]"]
    assert all(name.startswith("R_") for name in head[2:])


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--columns", "phi", "--no-store"), "--no-store writes no CSV files"),
        (("--columns", "phi", "--no-csv"), "--no-csv writes no CSV files"),
        (("--columns", "fi"), "no stage has a column called 'fi'"),
        (("--columns", " , "), "no column is named"),
        (("--skip", "force"), "did you mean forces?"),
    ],
)
def test_run_refuses(cli: Cli, flags: tuple[str, ...], said: str) -> None:
    code, out, err = cli("run", "my.toml", "-q", "-o", "out", *flags)
    assert (code, out) == (2, "")
    assert said in err


def test_a_skipped_stage(cli: Cli) -> None:
    columns = json.loads(cli("plan", "my.toml", "--skip", "reduction", "-f", "json").out)["columns"]
    why = dict(zip(columns["stage"], columns["why"], strict=True))
    assert why["reduction"] == "left out by --skip"
    assert why["power"] == "reads reduction, which --skip leaves out"
    assert cli("run", "my.toml", "--skip", "reduction", "--skip", "balance", "-o", "out", "-q").code == 0
    assert {path.stem for path in Path("out").glob("*.toml")} == {"structure", "kinematics", "forces"}
