"""``tmmcalc tolerance`` in one process and in several, and after it was killed: the same to the last digit."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from cli.conftest import Cli

ROOT = Path(__file__).parents[2]
TABLES = """
[[tolerances]]
of = ["mechanism.links[id=1].points.A[0]", "mechanism.fixed.O[1]"]
tolerance = "js9"

[[tolerances]]
joint = "O"
clearance = "0.06 mm"

[[constraints]]
name = "stroke"
value = "kinematics.stroke_D"
at_least = "657.9 mm"
"""
RESULTS = "kinematics.stroke_D,forces.max(R_A)"
NAMES = ("--of", RESULTS, "--set", "mechanism.grid.positions=12", "--balance", "none", "-q")


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    file = tmp_path / "s.toml"
    file.write_text((ROOT / "configs" / "shaper.toml").read_text(encoding="utf-8") + TABLES, encoding="utf-8")
    return file


@pytest.mark.slow
def test_two_processes_are_one(cli: Cli, spec: Path, tmp_path: Path) -> None:
    pytest.importorskip("joblib")
    told = [
        cli("tolerance", str(spec), *NAMES, "--samples", "1024", "-o", str(tmp_path / f"{jobs}.csv"), "--jobs", jobs)
        for jobs in ("1", "2")
    ]
    assert told[0].code == 0, told[0].err
    assert told[0].out == told[1].out
    assert (tmp_path / "1.csv").read_bytes() == (tmp_path / "2.csv").read_bytes()
    plain = cli("tolerance", str(spec), *NAMES, "--samples", "1024")
    assert plain.out == told[0].out


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="kills a process")
def test_a_killed_run_goes_on(cli: Cli, spec: Path, tmp_path: Path) -> None:
    words = ["tolerance", str(spec), *NAMES, "--samples", "4096"]
    whole = cli(*words, "-o", str(tmp_path / "whole.csv"))
    assert whole.code == 0, whole.err
    killed = tmp_path / "killed.csv"
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    run = subprocess.Popen([sys.executable, "-m", "tmmcalc", *words, "-o", str(killed)], env=environment)
    part = killed.with_name("killed.csv.part")
    until = time.monotonic() + 60
    while time.monotonic() < until and run.poll() is None and not (part.exists() and part.stat().st_size > 20_000):
        time.sleep(0.005)
    run.send_signal(signal.SIGKILL)
    run.wait()
    assert not killed.exists()
    done = len(part.read_bytes().splitlines()) - 2
    assert 0 < done < 4096
    again = cli(*words, "-o", str(killed))
    assert again.out == whole.out
    assert killed.read_bytes() == (tmp_path / "whole.csv").read_bytes()
    assert not part.exists()


def test_what_is_wrong_is_one_error(cli: Cli, spec: Path) -> None:
    shaper = str(ROOT / "configs" / "shaper.toml")
    assert "nothing varies" in cli("tolerance", shaper, "--of", "kinematics.stroke_D").err
    teeth = spec.read_text(encoding="utf-8") + '\n[[tolerances]]\nof = "mechanism.grid.positions"\ntolerance = "1"\n'
    spec.write_text(teeth, encoding="utf-8")
    told = cli("tolerance", str(spec), "--of", "kinematics.stroke_D")
    assert told.code == 2


@pytest.mark.slow
def test_results_are_listed_as_for_sensitivities_and_overrides_hold_for_all(cli: Cli, spec: Path) -> None:
    """Commas within brackets are part of a name, flags add; a title that is overridden is that of the document."""
    one = ("--samples", "64", "-q", "--set", "mechanism.grid.positions=12", "--set", 'project.title="Mine"')
    told = cli("tolerance", str(spec), "--of", RESULTS, "--of", "kinematics.max(x_D)@2..5", *one)
    assert told.code == 0, told.err
    assert told.out.startswith("Mine")
    for name in ("kinematics.stroke_D", "forces.max(R_A)", "kinematics.max(x_D)@2..5"):
        assert name in told.out
    none = cli("tolerance", str(spec), "--of", "kinematics.stroke_D,", *one)
    assert none.code == 2
    assert "--of: a name is missing" in none.err


@pytest.mark.slow
def test_pictures_speak_the_language_that_is_asked_for(cli: Cli, spec: Path, tmp_path: Path) -> None:
    """Words, units and decimal signs of histograms and of the band."""
    asked = ("--of", "kinematics.stroke_D", "--band", "kinematics.S_D", "--samples", "2048", "-q", "--balance", "none")
    fixed = ("--set", "mechanism.grid.positions=12", "--language", "uk")
    picture = tmp_path / "uk.svg"
    told = cli("tolerance", str(spec), *asked, *fixed, "--picture", str(picture))
    assert told.code == 0, told.err
    drawn = picture.read_text(encoding="utf-8")
    words = ("Shaper: допуски", "kinematics.stroke_D, м", "густина вибірки", "номінал", "найгірший випадок")
    for said in (*words, "0,135 %, 99,865 %", "5 %, 95 %", "медіана", "kinematics.S_D: відхилення від номіналу, м"):
        assert said in drawn
    assert "0.135" not in drawn
