"""``tmmcalc transient`` and ``tmmcalc balance``: formats, columns, positions, pictures; the summary of a whole run."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest
from machines import spec_text
from sparing import sparing

from .conftest import Cli

TRANSIENTS = """
[[transients]]
name = "start"
duration = "0.5 s"
load = 0

[[transients]]
name = "stop"
duration = "5 s"
start_speed = "60 rpm"
motor = "off"
load = 0
brake = { moment = "200 N*m" }
"""
ENGINE = """
[engine]
arrangement = "in-line"
cylinders = 2
speed = "1500 rpm"
spacing = "100 mm"
crank_radius = "40 mm"
rod_length = "150 mm"
reciprocating_mass = 0.5
"""


@pytest.fixture(autouse=True)
def press() -> None:
    text = spec_text(more=TRANSIENTS).replace("[motor]", '[motor]\ncharacteristic = "kloss"')
    Path("press.toml").write_text(text)
    Path("engine.toml").write_text(ENGINE)


def test_csv_of_transients_has_the_rows_of_the_stage_file(cli: Cli) -> None:
    code, out, err = cli("transient", "press.toml", "--format", "csv", "--csv", "-q")
    assert (code, err) == (0, "")
    printed, stored = (
        list(csv.reader(io.StringIO(text))) for text in (out, Path("press.out/transient.csv").read_text())
    )
    assert printed[0] == stored[0]
    assert [[row[0], *map(float, row[1:])] for row in printed[1:]] == [
        [row[0], *map(float, row[1:])] for row in stored[1:]
    ]
    assert {row[0] for row in printed[1:]} == {"start", "stop"}


def test_columns_of_transients(cli: Cli) -> None:
    code, out, _ = cli("transient", "press.toml", "--columns", "t,M_*", "-q")
    assert code == 0
    heads = [line.split() for line in out.splitlines() if line.split()[:2] == ["t", "M_motor"]]
    assert heads == [["t", "M_motor", "M_load"]] * 2
    assert "all: press.out/transient.csv" in out or "rows     all" in out
    code, out, err = cli("transient", "press.toml", "--columns", "speed", "-q")
    assert (code, out) == (2, "")
    assert "no column is called 'speed'" in err


def test_a_whole_run_tells_of_both_stages(cli: Cli) -> None:
    code, out, _ = cli("run", "press.toml", "--format", "json", "-q")
    found = json.loads(out)
    assert code == 0
    assert found["transient"]["stop"]["end"] == "standstill"
    assert found["balance"]["D_least_squares_ratio"] > 1


def test_an_engine_has_no_positions(cli: Cli) -> None:
    code, out, err = cli("balance", "engine.toml", "--format", "json", "-q")
    assert (code, err) == (0, "")
    assert json.loads(out)["columns"]["order"] == [1, 2, 4, 6]
    for flags, said in ((("--positions", "3"), "no positions to choose from"), (("--columns", "R"), "no table of")):
        code, out, err = cli("balance", "engine.toml", *flags, "-q")
        assert (code, out) == (2, "")
        assert said in err


def test_the_table_of_a_linkage(cli: Cli) -> None:
    code, out, _ = cli(
        "balance", "press.toml", "--columns", "phi,R,D_minimax", "--positions", "0:4:2", "-f", "csv", "-q"
    )
    assert code == 0
    header, *rows = csv.reader(io.StringIO(out))
    assert header == ["i", "phi[deg]", "R[N]", "D_minimax[N]"]
    assert [row[:2] for row in rows] == [["0", "0.0"], ["2", "60.0"], ["4", "120.0"]]


@pytest.mark.slow
@sparing(
    ("spec", "stage"), [("press.toml", "transient"), ("press.toml", "balance"), ("engine.toml", "balance")], every=3
)
def test_pictures(cli: Cli, spec: str, stage: str) -> None:
    assert cli("plot", spec, stage, "-o", "a.png", "-q") == (0, "", "")
    assert Path("a.png").read_bytes().startswith(b"\x89PNG")
    code, _, err = cli("plot", spec, stage, "--positions", "1")
    assert code == 2
    assert f"--positions cannot be used with the picture of {stage}" in err
