"""What a run leaves: equal bytes, untouched files, resume, damage, and the rule for make."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from .conftest import Cli, environment

DATA = ("structure.toml", "kinematics.toml", "kinematics.npz", "kinematics.csv")


def contents(folder: str = "my.out") -> dict[str, bytes]:
    return {name: (Path(folder) / name).read_bytes() for name in DATA}


def test_equal_runs_leave_equal_bytes(cli: Cli) -> None:
    assert cli("run", "my.toml", "-o", "a", "-q").code == 0
    assert cli("run", "my.toml", "-o", "b", "-q").code == 0
    assert contents("a") == contents("b")


def test_second_run_loads_and_touches_nothing(cli: Cli) -> None:
    first = cli("kinematics", "my.toml", "-q")
    for name in DATA:
        os.utime(Path("my.out") / name, (1, 1))
    code, out, err = cli("kinematics", "my.toml")
    assert (code, out) == (0, first.out)
    assert err.startswith("2 stages loaded in ")
    assert cli("kinematics", "my.toml", "-q", "--fresh").out == first.out
    assert {(Path("my.out") / name).stat().st_mtime for name in DATA} == {1}


def test_a_change_that_a_stage_does_not_read_leaves_it_valid(cli: Cli) -> None:
    cli("run", "my.toml", "-q")
    _, _, err = cli("run", "my.toml", "-v", "--set", "mechanism.links[id=3].mass=60")
    assert "structure: loaded" in err
    assert "kinematics: loaded" in err
    assert "forces: computed" in err
    _, _, err = cli("run", "my.toml", "-v", "--set", "mechanism.grid.positions=12")
    assert "structure: loaded" in err
    assert "kinematics: computed" in err


def test_from_computes_that_stage_and_all_after_it(cli: Cli) -> None:
    cli("run", "my.toml", "-q")
    _, _, err = cli("run", "my.toml", "-v", "--from", "kinematics")
    assert "structure: loaded" in err
    assert "kinematics: computed" in err
    assert "forced from kinematics" in err


@sparing("name", ["kinematics.npz", "kinematics.toml", "structure.toml"], every=3)
@pytest.mark.parametrize("flags", [(), ("-q",)])
def test_a_damaged_file_is_told_and_made_again(cli: Cli, name: str, flags: tuple[str, ...]) -> None:
    cli("run", "my.toml", "-q")
    whole, first = contents(), cli("kinematics", "my.toml", "-q").out
    file = Path("my.out") / name
    file.write_bytes(file.read_bytes()[:-40])
    code, out, err = cli("kinematics", "my.toml", *flags)
    assert (code, out) == (0, first)
    assert "warning: " in err
    assert name in err
    assert contents() == whole


def test_no_store_leaves_no_files(cli: Cli) -> None:
    stored = cli("kinematics", "my.toml", "-q", "-f", "csv").out
    shutil.rmtree("my.out")
    assert cli("kinematics", "my.toml", "-q", "-f", "csv", "--no-store").out == stored
    assert not Path("my.out").exists()


def test_csv_is_written_up_to_2000_rows_or_as_asked(cli: Cli) -> None:
    many = ("--set", "mechanism.grid.positions=2001")
    file = Path("my.out/kinematics.csv")
    cli("structure", "my.toml", "-q")
    cli("kinematics", "my.toml", "-q", "--no-csv")
    assert not file.exists()
    cli("kinematics", "my.toml", "-q")
    assert file.exists()
    out = cli("kinematics", "my.toml", "-q", *many, "--positions", "0").out
    assert not file.exists()
    assert "kinematics.csv" not in out
    cli("kinematics", "my.toml", "-q", *many, "--csv", "--positions", "0")
    assert len(file.read_text().splitlines()) == 2003


def test_csv_file_holds_every_digit(cli: Cli) -> None:
    printed = cli("kinematics", "my.toml", "-q", "-f", "csv").out
    assert Path("my.out/kinematics.csv").read_text() == printed
    header, *rows = (line.split(",") for line in printed.splitlines())
    with np.load("my.out/kinematics.npz") as arrays:
        assert [float(row[header.index("S_D[m]")]) for row in rows] == arrays["output_s"][0].tolist()


def test_output_folder_that_cannot_be_made(cli: Cli) -> None:
    code, out, err = cli("run", "my.toml", "-o", "my.toml/x", "-q")
    assert (code, out) == (2, "")
    assert "my.toml" in err


LOAD = '\n[[loads]]\nlink = 5\npoint = "D"\n[loads.table]\nfile = "q.csv"\n'


def test_the_depfile_names_the_spec_and_its_files(cli: Cli) -> None:
    home = Path("variants")
    home.mkdir()
    (home / "q.csv").write_text("phi[deg],Q[N]\n0,0\n180,1500\n")
    (home / "motors.csv").write_text("name,power_kW,synchronous_rpm,speed_rpm\nM1,7.5,1500,1455\n")
    motor = '[motor]\nname = "choose"\ncatalogue = "motors.csv"\n'
    (home / "loaded.toml").write_text(Path("my.toml").read_text() + LOAD + motor)
    assert cli("structure", "variants/loaded.toml", "-q", "--depfile", "d.mk").code == 0
    rule, *phony = Path("d.mk").read_text().split("\n\n")
    assert rule == "loaded.out/structure.toml: variants/loaded.toml variants/q.csv variants/motors.csv"
    assert phony == ["variants/loaded.toml:", "variants/q.csv:", "variants/motors.csv:\n"]


def test_a_changed_table_computes_the_stages_that_read_it(cli: Cli) -> None:
    Path("q.csv").write_text("phi[deg],Q[N]\n0,0\n180,1500\n")
    Path("loaded.toml").write_text(Path("my.toml").read_text() + LOAD)
    assert cli("forces", "loaded.toml", "-q").code == 0
    Path("q.csv").write_text("phi[deg],Q[N]\n0,0\n180,1501\n")
    _, _, err = cli("forces", "loaded.toml", "-v")
    assert "kinematics: loaded" in err
    assert "forces: computed" in err


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("make") is None, reason="there is no make here")
def test_make_has_nothing_to_do_the_second_time(folder: Path) -> None:
    shutil.copy("my.toml", "other one.toml")
    command = f'"{sys.executable}" -m tmmcalc run'
    Path("Makefile").write_text(
        "all: my.out/kinematics.toml other.out/kinematics.toml\n"
        f"my.out/kinematics.toml:\n\t{command} my.toml -q --depfile my.d > my.txt\n"
        f'other.out/kinematics.toml:\n\t{command} "other one.toml" -o other.out -q --depfile other.d > other.txt\n'
        "-include my.d other.d\n"
    )

    def make(*flags: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(["make", *flags], cwd=folder, env=environment(), capture_output=True, text=True)

    first = make()
    assert first.returncode == 0, first.stderr
    assert Path("my.txt").read_text() == Path("other.txt").read_text()
    assert make("-q").returncode == 0
    later = Path("my.out/kinematics.toml").stat().st_mtime + 5
    os.utime("other one.toml", (later, later))
    todo = make("-n")
    assert "other.out" in todo.stdout
    assert "my.d" not in todo.stdout


@pytest.mark.parametrize("args", [("schema",), ("init", "four-bar"), ("stress", "--ladder", "none")])
def test_a_dash_prints_what_is_printed_without_it(cli: Cli, args: tuple[str, ...]) -> None:
    assert cli(*args, "-o", "-") == cli(*args)
    assert not Path("-").exists()


@pytest.mark.parametrize(
    "args",
    [
        ("run", "my.toml", "-o"),
        ("kinematics", "my.toml", "--depfile"),
        ("plot", "my.toml", "-o"),
        ("plot", "my.toml", "--all", "-o"),
        ("accuracy", "my.toml", "--plot"),
        ("synth", "my.toml", "--spec"),
    ],
)
def test_a_dash_names_no_file_and_no_folder(cli: Cli, args: tuple[str, ...]) -> None:
    code, out, err = cli(*args, "-")
    assert (code, out) == (2, "")
    assert f"{args[-1]}: - is standard output, and what is written here is files" in err
    assert not Path("-").exists()
