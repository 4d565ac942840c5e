"""``tmmcalc unsteady`` and ``tmmcalc manipulator`` on real files: print, store, resume, draw, strict."""

from __future__ import annotations

import csv
import json
import math
import shutil
from io import StringIO
from pathlib import Path

import pytest
from sparing import sparing

from cli.conftest import CONFIGS, Cli

SPECS = ("crane-luffing", "tipper", "manipulator", "manipulator-angular", "manipulator-direct")


@pytest.fixture(autouse=True)
def specs(folder: Path) -> None:
    for name in SPECS:
        shutil.copy(CONFIGS / f"{name}.toml", folder)


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(StringIO(text)))


def command(name: str) -> str:
    return "unsteady" if name in ("crane-luffing", "tipper") else "manipulator"


def test_the_crane_in_words_and_as_a_table(cli: Cli) -> None:
    answer = cli("unsteady", "crane-luffing.toml")
    assert answer.code == 0
    assert "acceleration 4 s, uniform motion 4 s, deceleration 4 s" in answer.out
    assert "from 78.80682 deg to 62.85885 deg" in answer.out
    rows = rows_of(cli("unsteady", "crane-luffing.toml", "--format", "csv").out)
    assert [row["i"] for row in rows[7:11]] == ["7", "8-", "8", "9"]
    before, after = rows[8:10]
    assert before["t[s]"] == after["t[s]"] == "4.0"
    assert (float(before["a[m/s^2]"]), float(after["a[m/s^2]"])) == (0.05, 0.0)
    assert float(rows[-1]["a[m/s^2]"]) == -0.05
    one = cli("unsteady", "crane-luffing.toml", "--columns", "t,eps_1", "--positions", "8-,8", "--format", "csv").out
    assert [list(row) for row in rows_of(one)] == [["i", "t[s]", "eps_1[rad/s^2]"]] * 2


def test_the_numbers_for_programs(cli: Cli) -> None:
    found = json.loads(cli("unsteady", "crane-luffing.toml", "--format", "json").out)
    assert found["S_m[m]"] == pytest.approx(1.6, rel=1e-14)
    assert (found["t_1[s]"], found["t_2[s]"], found["T[s]"]) == pytest.approx((4, 4, 12))
    assert (found["S_1[m]"], found["S_2[m]"]) == pytest.approx((0.4, 0.8))
    assert found["jumps[s]"] == pytest.approx([0, 4, 8, 12])
    found = json.loads(cli("manipulator", "manipulator.toml", "--format", "json").out)
    assert found["path"][0]["theta_1[deg]"] == pytest.approx(math.degrees(-1.696093), abs=1e-4)
    assert found["path"][0]["q"] == -1
    assert {"omega_2_max[rad/s]", "eps_2_max[rad/s^2]", "v_3_max[m/s]", "a_3_max[m/s^2]"} <= found.keys()
    assert found["press_path[s]"] == []
    assert found["press_straight_line"]


@pytest.mark.slow
@sparing("name", SPECS, every=5)
def test_a_stored_result_is_the_computed_one(cli: Cli, name: str) -> None:
    first = cli(command(name), f"{name}.toml", "-o", "out", "-q", "--format", "json")
    assert first.code == 0
    files = {file: file.read_bytes() for file in Path("out").iterdir() if file.suffix != ".log"}
    again = cli(command(name), f"{name}.toml", "-o", "out", "--format", "json")
    assert again.out == first.out
    assert "loaded" in again.err or "up to date" in again.err or "unchanged" in again.err
    fresh = cli(command(name), f"{name}.toml", "-o", "out", "-q", "--fresh", "--format", "json")
    assert fresh.out == first.out
    assert files == {file: file.read_bytes() for file in files}


@sparing("name", SPECS, every=3)
def test_all_stages_run(cli: Cli, name: str) -> None:
    answer = cli("run", f"{name}.toml", "--no-store", "-q")
    assert answer.code == 0
    assert command(name) in answer.out


@pytest.mark.slow
@pytest.mark.parametrize("name", ["tipper", "manipulator-direct"])
def test_a_picture_is_drawn(cli: Cli, name: str) -> None:
    assert cli("plot", f"{name}.toml", command(name), "-o", "picture.svg", "-q") == (0, "", "")
    assert Path("picture.svg").read_bytes().startswith(b"<?xml")


def test_a_passed_limit_is_strict(cli: Cli) -> None:
    limit = 'manipulator.limits.l_3=["0.95 m", "1.3 m"]'
    answer = cli("manipulator", "manipulator.toml", "--set", limit)
    assert answer.code == 0
    assert "passes its limit of 0.95 m by 0.05112 m" in " ".join(answer.out.split())
    assert cli("manipulator", "manipulator.toml", "--set", limit, "--strict").code == 5


def test_what_cannot_be_is_told(cli: Cli) -> None:
    answer = cli("manipulator", "manipulator-angular.toml", "--set", 'manipulator.forearm="0.3 m"')
    assert answer.code == 3
    assert "the arms reach from 0.6 m to 1.2 m" in " ".join(answer.err.split())
    answer = cli("unsteady", "tipper.toml", "--set", 'unsteady.to="170 deg"')
    assert answer.code == 3
    assert "output 1 never is 170 deg" in " ".join(answer.err.split())
    answer = cli("unsteady", "my.toml")
    assert answer.code == 2
    assert "no [unsteady]" in answer.err


@pytest.mark.slow
def test_no_scipy(cli: Cli) -> None:
    import subprocess
    import sys

    for name in ("crane-luffing", "manipulator"):
        code = (
            "import sys, tmmcalc\n"
            f"tmmcalc.run(tmmcalc.load_spec('{name}.toml'), target='{command(name)}')\n"
            "print([name for name in sys.modules if name.split('.')[0] in ('scipy', 'reportlab')])"
        )
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        assert done.stdout.strip() == "[]"
