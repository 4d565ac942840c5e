"""``tmmcalc accuracy``, and ``--tolerance`` of the other commands."""

from __future__ import annotations

import csv
import io
import json
import tomllib
from pathlib import Path

import pytest
from sparing import sparing

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


def test_rows_name_the_tolerances_that_they_are_the_cheapest_for(cli: Cli) -> None:
    def cheapest(*flags: str) -> dict[str, list[str]]:
        code, out, _ = cli("accuracy", "my.toml", "--stage", "kinematics", "-f", "csv", *flags, *FAST)
        assert code == 0
        found: dict[str, list[str]] = {}
        for row in csv.DictReader(io.StringIO(out)):
            for tolerance in row["cheapest"].split():
                assert float(row["error"]) <= float(tolerance)
                found.setdefault(row["quantity"], []).append(tolerance)
        return found

    for four in cheapest().values():
        assert sorted(four) == ["1e-03", "1e-06", "1e-09", "1e-12"]
    assert cheapest("--tolerance", "1.44e-6")["velocities"] == ["1.44e-06"]


def test_a_tolerance_keeps_its_digits(cli: Cli) -> None:
    code, out, _ = cli("accuracy", "my.toml", "--stage", "kinematics", "--tolerance", "1.44e-6", *FAST)
    assert code == 0
    assert "cheapest for 1.44e-06" in out
    code, out, _ = cli("accuracy", "my.toml", "--stage", "kinematics", "--tolerance", "1.44e-6", "-f", "json", *FAST)
    assert json.loads(out)["kinematics: velocities"]["cheapest_1.44e-06"]["error"] <= 1.44e-6


def test_every_column_of_the_table_is_documented(cli: Cli) -> None:
    _, out, _ = cli("accuracy", "my.toml", "--stage", "kinematics", "-f", "csv", *FAST)
    page = (CONFIGS.parent / "docs" / "files.md").read_text(encoding="utf-8")
    part = page.split("## Table of `accuracy`")[1].split("\n## ")[0]
    assert [name for name in out.splitlines()[0].split(",") if f"`{name}`" not in part] == []


def test_methods_that_never_reach_a_tolerance_say_so(cli: Cli) -> None:
    code, out, _ = cli("accuracy", "my.toml", "--stage", "kinematics", "--tolerance", "1e-9", *FAST)
    assert code == 0
    assert "never 1e-09" in out
    words = " ".join(out.split())
    assert "differences, 6 decimals: 5." in words or "differences, 6 decimals: 6." in words
    code, out, _ = cli("accuracy", "my.toml", "--stage", "kinematics", "--tolerance", "1e-9", "-f", "json", *FAST)
    never = json.loads(out)["kinematics: velocities"]["never_1e-09"]
    assert 1e-6 < never["differences, 6 decimals"] < 1e-3


def test_numbers_for_programs_keep_their_digits(cli: Cli) -> None:
    code, out, _ = cli("accuracy", "my.toml", "--stage", "kinematics", "-f", "json", *FAST)
    part = json.loads(out)["kinematics: velocities"]
    by_name = {method["method"]: method for method in part["methods"]}
    points = by_name["central differences"]["points"]
    assert by_name["central differences"]["order"] == pytest.approx(2.0, abs=0.05)
    assert all(isinstance(point["error"], float) and point["runs"] >= 1 for point in points)
    assert code == 0


@pytest.mark.parametrize("form", ["table", "json", "toml", "csv"])
def test_a_file_in_place_of_the_output(cli: Cli, form: str) -> None:
    code, out, err = cli("accuracy", "my.toml", "--stage", "kinematics", "-f", form, "-o", f"a.{form}", *FAST)
    assert (code, out) == (0, "")
    assert f"wrote a.{form}" in err
    text = Path(f"a.{form}").read_text(encoding="utf-8")
    assert "central differences" in text
    if form == "toml":
        assert tomllib.loads(text)["kinematics: velocities"]["methods"]


@sparing("suffix", ["svg", "png", "pdf"], every=3)
def test_a_diagram(cli: Cli, suffix: str) -> None:
    code, _, err = cli("accuracy", "my.toml", "--stage", "kinematics", "--plot", f"a.{suffix}", *FAST)
    assert code == 0
    assert Path(f"a.{suffix}").stat().st_size > 10_000
    assert f"wrote a.{suffix}" in err


def test_a_scene_without_a_choice_of_methods(cli: Cli) -> None:
    code, out, err = cli("accuracy", str(CONFIGS / "extra-bearing.toml"), "--plot", "a.svg", *FAST)
    assert code == 0
    assert "studied          nothing" in out
    assert "one method only  bearing" in out
    assert "there is nothing to draw" in err
    assert not Path("a.svg").exists()


@pytest.mark.slow
def test_a_stage_without_a_solution_ends_only_what_reads_it(cli: Cli) -> None:
    holding = ("--set", "mechanism.links[id=3].points.C[0]='1289.963 mm'")  # friction in the guide holds the ram
    code, out, err = cli("accuracy", str(CONFIGS / "shaper.toml"), *holding, *FAST)
    assert code == 3
    assert "studied" in out
    assert "kinematics: velocities" in out
    assert "balance" in out
    assert "without a result" in out
    assert "forces, reduction" in out
    assert "self-locking" in err
    code, out, err = cli("accuracy", str(CONFIGS / "shaper.toml"), *holding, "--stage", "forces", *FAST)
    assert (code, out) == (3, "")
    assert "self-locking" in err


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
        (("-o", "none/a.txt"), "no folder"),
        (("-o", "a.svg", "--plot", "./a.svg"), "would be written twice"),
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
