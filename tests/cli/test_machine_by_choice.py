"""What is told by choice of reduction, flywheel and motion: columns, Simpson's rule, tangents, the recurrence."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from .conftest import CONFIGS, Cli

TABLE_D23 = "phi,M_red_Q5,M_red_friction,J_red,omega_textbook,omega_idle_textbook"


@pytest.fixture(autouse=True)
def spec(folder: Path) -> None:
    for name in ("shaper", "press", "class-three"):
        shutil.copy(CONFIGS / f"{name}.toml", folder)


def told(cli: Cli, *args: str) -> dict[str, Any]:
    code, out, err = cli(*args, "-q", "--no-store", "-f", "json")
    assert (code, [line for line in err.splitlines() if not line.startswith("warning")]) == (0, [])
    found: dict[str, Any] = json.loads(out)
    return found


def test_a_table_of_the_textbook_by_one_command(cli: Cli) -> None:
    """Table D.2.3, column by column, out of two stages."""
    columns = told(cli, "motion", "shaper.toml", "--recurrence", "--columns", TABLE_D23)["columns"]
    assert [header.partition("[")[0] for header in columns] == ["i", *TABLE_D23.split(",")]
    reduction = told(cli, "reduce", "shaper.toml", "--columns", "M_red_Q5,M_red_friction,J_red")["columns"]
    for header in ("M_red_Q5[N*m]", "M_red_friction[N*m]", "J_red[kg*m^2]"):
        assert columns[header] == reduction[header]


def test_simpsons_rule_over_a_part(cli: Cli) -> None:
    found = told(cli, "reduce", "shaper.toml", "--ordinates", "--positions", "2:12")
    sums, columns = found["Simpson_Q5"], found["columns"]
    assert columns["i"] == [str(k) for k in range(2, 13)]
    assert columns["Simpson[-]"] == [1, 4, 2, 4, 2, 4, 2, 4, 2, 4, 1]
    assert sums["step[deg]"] == pytest.approx(15)
    assert sums["work_Simpson[J]"] == pytest.approx(np.radians(15) / 3 * columns["sum_ordinates_Q5[N*m]"][-1])
    assert sums["work[J]"] == pytest.approx(-4219.905, abs=1e-3)


def test_tangents_of_wittenbauer(cli: Cli) -> None:
    found = told(cli, "flywheel", "press.toml", "--tangents")
    columns = found["columns"]
    assert columns["i"][-2:] == ["max", "min"]
    assert min(columns["below_max[J]"]) == pytest.approx(0, abs=1e-12)
    assert min(columns["above_min[J]"]) == pytest.approx(0, abs=1e-12)
    drawn = found["tangents"]
    angle = np.degrees(np.arctan(found["slope_max[rad^2/s^2]"] * drawn["mu_J[kg*m^2/mm]"] / drawn["mu_T[J/mm]"]))
    assert drawn["psi_max[deg]"] == pytest.approx(angle)


def test_numbers_of_the_methods(cli: Cli) -> None:
    found = told(cli, "flywheel", "press.toml", "--methods")
    columns = found["columns"]
    assert columns["on"] == ["cycle"] * 5 + ["positions"] * 5
    usual = told(cli, "flywheel", "press.toml")["columns"]
    assert columns["J_F[kg*m^2]"][:5] == usual["J_F[kg*m^2]"]
    assert columns["method"][:5] == usual["method"]
    assert found["mertsalov_by_cycle"]["k_max[rad^2/s^2]"] == found["mertsalov_by_cycle"]["k_min[rad^2/s^2]"]


@pytest.mark.parametrize(
    ("args", "headers"),
    [
        (("reduce", "--columns", "J_red_*", "--positions", "3"), {"J_red_3[kg*m^2]", "J_red_5_mass[kg*m^2]"}),
        (("reduce", "--columns", "M_red_fr_*,load_*,dS_of_*"), {"M_red_fr_A3[N*m]", "load_Q5[N]", "dS_of_Q5[m/rad]"}),
        (("motion", "--columns", "step_*,omega_turn_*"), {"step_kept[J]", "omega_turn_2[rad/s]"}),
    ],
)
def test_columns_by_choice(cli: Cli, args: tuple[str, ...], headers: set[str]) -> None:
    assert headers < {*told(cli, args[0], "shaper.toml", *args[1:])["columns"]}


@pytest.mark.parametrize("stage", ["reduce", "motion"])
def test_no_table_and_no_file_has_them(cli: Cli, stage: str, folder: Path) -> None:
    code, out, _ = cli(stage, "shaper.toml", "-q", "-f", "csv")
    headers = out.splitlines()[0].split(",")
    name = {"reduce": "reduction", "motion": "motion"}[stage]
    file = (folder / "shaper.out" / f"{name}.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
    assert code == 0
    assert headers == file
    assert not [h for h in headers if h.startswith(("J_red_", "M_red_fr_", "load_", "Simpson", "step_", "omega_turn"))]


@pytest.mark.slow
def test_special_points_in_the_plans(cli: Cli) -> None:
    columns = told(cli, "kinematics", "class-three.toml", "--polygons", "4")["columns"]
    assert "w3_2_4" in columns["to"]
    values = told(cli, "kinematics", "class-three.toml", "--columns", "vx_W3_2_4", "--positions", "4")["columns"]
    row = [*zip(columns["plan"], columns["from"], columns["to"], strict=True)].index(("v", "p", "w3_2_4"))
    assert columns["x"][row] == pytest.approx(values["vx_W3_2_4[m/s]"][0])


@pytest.mark.parametrize(
    ("args", "words"),
    [
        (("reduce", "shaper.toml", "--ordinates", "--positions", "0:3"), "an even number of steps, these are 3"),
        (("reduce", "shaper.toml", "--ordinates", "--positions", "0,1,3"), "equal steps"),
        (("reduce", "shaper.toml", "--columns", "J_red_9"), "no column is called 'J_red_9'"),
        (("flywheel", "shaper.toml", "--tangents", "--methods"), "print one table each"),
        (("motion", "press.toml", "--recurrence"), 'write characteristic = "parabolic"'),
        (("motion", "shaper.toml", "--columns", "step_x"), "no column is called 'step_x'"),
        (("kinematics", "shaper.toml", "--columns", "*_W*"), "no column is called '*_W*'"),
    ],
)
def test_what_is_refused(cli: Cli, args: tuple[str, ...], words: str) -> None:
    code, out, err = cli(*args, "-q", "--no-store")
    assert (code, out) == (2, "")
    assert words in err
