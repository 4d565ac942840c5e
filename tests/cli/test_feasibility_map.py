"""``tmmcalc feasibility --over``: the map, its formats and picture, what is refused."""

from __future__ import annotations

import csv
import io
import json
import shutil
from pathlib import Path

import pytest

import tmmcalc

from .conftest import CONFIGS, Cli

RATIO = ("--over", "synthesis.crank_rocker.time_ratio=1.1:1.4:3")
SWING = ("--over", "synthesis.crank_rocker.swing=30 deg:50 deg:2")


@pytest.fixture(autouse=True)
def spec(folder: Path) -> None:
    shutil.copy(CONFIGS / "feasibility.toml", folder / "f.toml")


@pytest.mark.slow
def test_every_point_is_what_the_command_says_of_its_spec(cli: Cli) -> None:
    code, out, err = cli(
        "feasibility", "f.toml", "-q", *RATIO, "--over", "synthesis.crank_rocker.swing=0.6,0.8", "-f", "csv"
    )
    assert (code, err) == (0, "")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert len(rows) == 6
    for row in rows:
        keys = ("synthesis.crank_rocker.time_ratio", "synthesis.crank_rocker.swing")
        alone = tmmcalc.solve_feasibility(tmmcalc.load_spec("f.toml", [f"{key}={row[key]}" for key in keys]))
        assert row["feasible"] == ("yes" if alone.feasible else "no")
        assert row["fails"] == ", ".join(alone.failing)
        assert float(row["function (R0)"]) == alone.function
        assert [float(row[f"margin_{each.name}"]) for each in alone.verdicts] == [
            each.margin for each in alone.verdicts
        ]


def test_people_get_signs_and_programs_the_best_point(cli: Cli) -> None:
    code, out, _ = cli("feasibility", "f.toml", "-q", *RATIO)
    assert code == 0
    assert out.splitlines()[-1] == ".**"
    told = json.loads(cli("feasibility", "f.toml", "-q", *RATIO, "-f", "json").out)
    assert told["best_point"]["overrides"] == ["synthesis.crank_rocker.time_ratio=1.1"]
    assert told["feasible"] == 1
    result = tmmcalc.map_feasibility("f.toml", [RATIO[1]])
    assert told["columns"]["function (R0)"] == result.function.tolist()
    assert not Path("f.out").exists()


def test_strict_without_a_feasible_point(cli: Cli) -> None:
    never = ("--set", 'constraints[0].at_least="89 deg"')
    code, out, err = cli("feasibility", "f.toml", "-q", "--strict", *RATIO, *never)
    assert code == 5
    assert "nearest point" in out
    assert "no point is feasible" in err


def test_points_without_a_solution(cli: Cli) -> None:
    code, out, _ = cli("feasibility", "f.toml", "-q", "--over", "synthesis.crank_rocker.time_ratio=1.2,9", "-f", "json")
    assert code == 0
    told = json.loads(out)
    assert told["without_solution"] == 1
    assert told["columns"]["margin_calm"][1] is None
    assert told["columns"]["fails"][1]


@pytest.mark.slow
def test_pictures(cli: Cli) -> None:
    for flags, file in ((RATIO, "one.svg"), ((*RATIO, *SWING), "two.svg")):
        assert cli("feasibility", "f.toml", *flags, "-q", "--picture", file).code == 0
        drawn = Path(file).read_text(encoding="utf-8")
        assert drawn.startswith("<?xml")
        assert "the rule holds" in drawn
        assert all(name in drawn for name in ("calm", "best point"))


@pytest.mark.parametrize(
    ("flags", "words"),
    [
        (("--picture", "a.svg"), "there is no map to draw"),
        ((*RATIO, "--fresh"), "--fresh: a map leaves no stage files"),
        ((*RATIO, "--picture", "a.gif"), "gif"),
        ((*RATIO, *RATIO), "two ranges of synthesis.crank_rocker.time_ratio"),
        ((*RATIO, *SWING, "--over", "feasibility.smoothness=1:2:2"), "3 ranges"),
        (("--over", "synthesis.crank_rocker.time_ratio=1:2"), "is no range"),
        (("--over", "synthesis.crank_rocker.time_ratio=1.2:1.2:5"), "does not vary"),
        (("--over", "synthesis.crank_rocker.time_ratio=1:2:10001"), "10001 points are too many"),
        (("--over", "synthesis.crank_rocker.time_ration=1:2:2"), "time_ration"),
        ((*RATIO, "--set", 'constraints[1].column="omega_9"'), "tells no 'omega_9'"),
    ],
)
def test_what_is_refused_is_one_message(cli: Cli, flags: tuple[str, ...], words: str) -> None:
    code, out, err = cli("feasibility", "f.toml", "-q", *flags)
    assert (code, out) == (2, "")
    assert words in err
