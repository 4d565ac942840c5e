"""``tmmcalc gears``: the group, the formats, exit codes, warnings."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import pytest

from tmmcalc.cli.commands import grouped

from .conftest import CONFIGS, Cli

READY = sorted(file.stem for file in CONFIGS.glob("gears-*.toml") if "\n[train]" in file.read_text(encoding="utf-8"))
SINGLE = '[train]\nlayout = "AIbar"\nratio = "7.29"\ntolerance = "0.1"\ntolerance_kind = "absolute"\n'


def write(text: str) -> str:
    Path("gears.toml").write_text(text)
    return "gears.toml"


def test_the_group_lists_its_commands(cli: Cli) -> None:
    code, out, err = cli("gears", "--help")
    assert (code, err) == (0, "")
    assert all(f"\n  {name} " in out for name in grouped("gears"))


@pytest.mark.parametrize("name", grouped("gears"))
def test_help_has_an_example_and_stays_in_80_columns(cli: Cli, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    code, out, err = cli("gears", name, "--help")
    assert (code, err) == (0, "")
    assert f"Example: tmmcalc gears {name}" in out
    assert max(map(len, out.splitlines())) <= 80


@pytest.mark.parametrize(
    ("given", "remedy"),
    [("sinth", "did you mean synth?"), ("my.toml", "tmmcalc gears synth my.toml"), ("zzz", "commands: synth")],
)
def test_unknown_command_of_the_group(cli: Cli, given: str, remedy: str) -> None:
    code, out, err = cli("gears", given)
    assert (code, out) == (2, "")
    assert remedy in err


@pytest.mark.parametrize("name", READY)
def test_ready_specs_have_sets_in_80_columns(cli: Cli, name: str) -> None:
    code, out, _ = cli("gears", "synth", str(CONFIGS / f"{name}.toml"), "--no-store", "-q", "--rows", "3")
    assert code == 0
    assert "\ntooth sets" in out
    assert max(map(len, out.splitlines())) <= 80


def test_rows_of_the_table_and_all_rows_of_csv(cli: Cli) -> None:
    file = write(SINGLE)
    out = cli("gears", "synth", file, "--rows", "4", "-q").out
    table = out.splitlines()[-4:]
    assert [line.split()[:3] for line in table][:2] == [["18", "48", "114"], ["19", "50", "119"]]
    assert "the first 4 of" in out
    assert "removed" in out
    rows = list(csv.DictReader(io.StringIO(cli("gears", "synth", file, "-q", "-f", "csv").out)))
    payload = json.loads(cli("gears", "synth", file, "-q", "-f", "json").out)
    assert len(rows) == payload["count"] == payload["held"] == len(payload["columns"]["z_1"])
    assert payload["candidates"] - sum(payload["removed"].values()) == payload["count"]
    assert (rows[0]["z_1"], rows[0]["z_2"], rows[0]["z_3"]) == ("18", "48", "114")
    assert float(rows[0]["i_1H"]) == pytest.approx(1 + 114 / 18, rel=1e-15)
    assert float(rows[0]["error[%]"]) == pytest.approx(100 * ((1 + 114 / 18) / 7.29 - 1), rel=1e-12)
    assert Path("gears.out/train.csv").read_text().count("\n") == payload["count"] + 1


def test_variants_of_different_layouts_in_one_csv(cli: Cli) -> None:
    file = write(
        '[train]\nlayout = ["AIbar", "AI"]\nratio = "7.29"\nplanets = 3\nmodule_ratios = [[2, 3]]\nsum_max = 70\n'
    )
    rows = list(csv.DictReader(io.StringIO(cli("gears", "synth", file, "-q", "-f", "csv").out)))
    single, double = ([row for row in rows if row["layout"] == layout] for layout in ("AIbar", "AI"))
    assert single
    assert double
    assert {row["z_2'"] for row in single} == {""}
    for row in double:
        z1, z2, pinion, z3 = (int(row[f"z_{wheel}"]) for wheel in ("1", "2", "2'", "3"))
        assert float(row["i_1H"]) == pytest.approx(1 + z2 * z3 / (z1 * pinion), rel=1e-15)
        assert 2 * (z1 + z2) == 3 * (z3 - pinion)


def test_nothing_found_is_exit_code_3_with_what_would_help(cli: Cli) -> None:
    code, out, err = cli("gears", "synth", write(SINGLE + "planets = 4\n"), "-q")
    assert (code, out) == (3, "")
    assert "AIbar with 4 planets: no tooth set; neighbours' gap removed the last" in err
    assert "-> planets 4 -> 3 gives 18/48/114" in err
    assert not Path("gears.out/train.toml").exists()


def test_one_empty_variant_is_a_warning(cli: Cli) -> None:
    file = write(SINGLE + "planets = [3, 4]\n")
    code, out, _ = cli("gears", "synth", file, "-q")
    assert code == 0
    assert "warning: AIbar with 4 planets: no tooth set" in out
    assert cli("gears", "synth", file, "-q", "--strict").code == 5


def test_warnings_of_the_task_and_of_memory(cli: Cli) -> None:
    out = cli("gears", "synth", write(SINGLE + "z_min = 16\nkeep = 5\n"), "-q").out
    assert "warning: AIbar with 3 planets: slight undercut" in out
    assert "note: the 5 sets with the least Z1 + Z2 are held" in out


def test_a_fault_has_its_line(cli: Cli) -> None:
    code, out, err = cli("gears", "synth", write(SINGLE.replace("7.29", "0.5")))
    assert (code, out) == (2, "")
    assert "gears.toml:3:1: train.ratio: layout AIbar cannot have the ratio '0.5'" in err


def test_a_spec_without_train(cli: Cli) -> None:
    code, out, err = cli("gears", "synth", "my.toml")
    assert (code, out) == (2, "")
    assert "no [train]" in err


def test_run_and_check_know_a_train(cli: Cli) -> None:
    file = write(SINGLE)
    assert cli("check", file) == (0, "gears.toml: ok (a gear train, AIbar)\n", "")
    code, out, _ = cli("run", file, "-q")
    assert code == 0
    assert "\ntrain\n" in out
    assert len(re.findall(r"^ *\d+ +\d+ +\d+ ", out, re.MULTILINE)) == 5
