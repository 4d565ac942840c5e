"""``tmmcalc synth`` of a six-bar with a dwell: table, formats, columns, the ready spec, the picture."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from .conftest import CONFIGS, Cli

pytestmark = pytest.mark.slow

SPEC, ROCKER, OPTIMUM = (str(CONFIGS / f"synth-dwell{name}.toml") for name in ("", "-rocker", "-optimum"))


def test_the_table(cli: Cli) -> None:
    code, out, _ = cli("synth", SPEC, "-q", "--no-store")
    assert code == 0
    for said in ("99.61", "stroke h", "wanted 200 mm", "2.01495 mm at 76.72672 deg", "135.22984 deg", "0.1 % of the"):
        assert said in out or said == "99.61"
    assert "98.99163 mm, crank" in out
    assert out.count("\n14'") == 1


def test_json_and_csv(cli: Cli) -> None:
    code, out, _ = cli("synth", SPEC, "-q", "--no-store", "--format", "json")
    found = json.loads(out)
    assert code == 0
    assert found["l_OA[m]"] == pytest.approx(0.2 * 0.280227 / 0.566164, rel=1e-5)
    assert found["relative_trajectory"]["uniform"] == pytest.approx(0.001, abs=1e-5)
    assert found["agreement"]["forces"] < 1e-12
    code, out, _ = cli("synth", SPEC, "-q", "--no-store", "--format", "csv", "--columns", "phi,S,M_1")
    rows = list(csv.reader(line for line in io.StringIO(out) if not line.startswith("#")))
    assert code == 0
    assert rows[0][0] == "i"
    assert [header.partition("[")[0] for header in rows[0][1:]] == ["phi", "S", "M_1"]
    assert len(rows) == 1 + 24 + 1 + 4


def test_a_column_that_is_not_there(cli: Cli) -> None:
    code, _, err = cli("synth", ROCKER, "-q", "--no-store", "--columns", "N")
    assert code == 2
    assert "no column is called 'N'" in err


@pytest.mark.parametrize("spec", [SPEC, ROCKER])
def test_the_ready_spec_runs(cli: Cli, tmp_path: Path, spec: str) -> None:
    ready = tmp_path / "ready.toml"
    assert cli("synth", spec, "-q", "--no-store", "--spec", str(ready))[0] == 0
    code, out, _ = cli("check", str(ready))
    assert (code, "5 moving links, 7 joints" in out) == (0, True)
    code, out, _ = cli("kinematics", str(ready), "-q", "--no-store")
    assert (code, "I(0,1) -> IV(2,3,4,5)" in out) == (0, True)
    assert cli("forces", str(ready), "-q", "--no-store")[0] == 0
    picture = tmp_path / "ready.svg"
    assert cli("plot", str(ready), "-q", "-o", str(picture))[0] == 0
    assert picture.stat().st_size > 10_000


def test_an_optimum_is_stored_and_loaded(cli: Cli, tmp_path: Path) -> None:
    short = [("population", 16), ("generations", 1), ("polish", 0)]
    flags = [part for key, value in short for part in ("--set", f"synthesis.dwell.optimum.{key}={value}")]
    flags += ["--set", "synthesis.solutions=1", "-o", str(tmp_path / "out")]
    code, out, err = cli("synth", OPTIMUM, *flags)
    assert code == 0
    assert "linkages tried" in out
    assert "refused: " in out
    assert "1 stage computed" in err
    code, again, err = cli("synth", OPTIMUM, *flags)
    assert code == 0
    assert "1 stage loaded" in err
    assert again == out


@pytest.mark.parametrize("spec", [SPEC, ROCKER])
def test_the_picture(cli: Cli, tmp_path: Path, spec: str) -> None:
    picture = tmp_path / "dwell.svg"
    assert cli("plot", spec, "synthesis", "-q", "-o", str(picture))[0] == 0
    assert "dwell, in the diagrams" in picture.read_text()
