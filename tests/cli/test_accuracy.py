"""``tmmcalc accuracy``, and ``--tolerance`` of the other commands."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from cli.conftest import CONFIGS, Cli

FAST = ("--repeats", "1")


def test_tables_for_people(cli: Cli) -> None:
    code, out, err = cli("accuracy", "my.toml", *FAST)
    assert (code, err) == (0, "")
    assert "kinematics: velocities" in out
    assert "the same formulas in extended precision (64-bit mantissa), error" in " ".join(out.split())
    assert "cheapest for 1e-03 to 1e-12" in out
    assert max(map(len, out.splitlines())) <= 80
    assert not Path("my.out").exists(), "nothing is stored"


def test_one_tolerance(cli: Cli) -> None:
    code, out, _ = cli("accuracy", "my.toml", "--tolerance", "1e-6", "--format", "json", *FAST)
    assert code == 0
    part = json.loads(out)["kinematics: accelerations"]
    assert part["cheapest_1e-06"]["error"] <= 1e-6
    assert part["reference_error"] < 1e-18


def test_tidy_rows_for_programs(cli: Cli) -> None:
    code, out, _ = cli("accuracy", "my.toml", "--format", "csv", *FAST)
    assert code == 0
    rows = list(csv.DictReader(io.StringIO(out)))
    differences = [r for r in rows if r["method"] == "central differences" and r["quantity"] == "velocities"]
    assert [float(r["size"]) for r in differences] == sorted((float(r["size"]) for r in differences), reverse=True)
    assert float(differences[0]["order"]) == pytest.approx(2.0, abs=0.05)
    assert all(float(r["seconds"]) > 0 for r in rows if not r["failed"])


@pytest.mark.parametrize("suffix", ["svg", "png", "pdf"])
def test_a_diagram(cli: Cli, suffix: str) -> None:
    code, _, err = cli("accuracy", "my.toml", "--plot", f"a.{suffix}", *FAST)
    assert code == 0
    assert Path(f"a.{suffix}").stat().st_size > 10_000
    assert f"wrote a.{suffix}" in err


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--stage", "structure"), "structure has one method only"),
        (("--stage", "kinematik"), "did you mean kinematics?"),
        (("--stage", "motion"), "no [motor]"),
        (("--tolerance", "0"), "0 is no relative error"),
        (("--tolerance", "1.5"), "1.5 is no relative error"),
        (("--plot", "a.gif"), "no picture format"),
        (("--plot", "none/a.svg"), "no folder"),
    ],
)
def test_what_is_refused(cli: Cli, flags: tuple[str, ...], said: str) -> None:
    code, out, err = cli("accuracy", "my.toml", *flags, *FAST)
    assert (code, out) == (2, "")
    assert said in err
    assert not list(Path().glob("a.*"))


def test_a_tolerance_that_is_reached(cli: Cli) -> None:
    assert cli("kinematics", "my.toml", "--tolerance", "1e-10", "--no-store", "-q").code == 0
    assert cli("run", str(CONFIGS / "shaper.toml"), "--tolerance", "1e-10", "--no-store", "-q").code == 0


def test_a_tolerance_that_is_not_reached(cli: Cli) -> None:
    code, _, err = cli("kinematics", "my.toml", "--method", "differences", "--tolerance", "1e-6", "--no-store", "-q")
    assert code == 4
    assert "kinematics: the estimated error of acceleration is" in err
    assert "more than the 1e-06 asked for" in err


def test_a_stored_result_is_held_against_the_tolerance_too(cli: Cli) -> None:
    assert cli("kinematics", "my.toml", "--method", "differences", "-q").code == 0
    code, _, err = cli("kinematics", "my.toml", "--method", "differences", "--tolerance", "1e-6", "-q")
    assert code == 4
    assert "more than the 1e-06 asked for" in err
