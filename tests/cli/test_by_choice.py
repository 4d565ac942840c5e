"""What is told by choice of kinematics and forces: plans, links by themselves, the lever, columns that no table has."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from .conftest import CONFIGS, Cli

DYNAMICS = Path(__file__).parents[1] / "cases" / "dynamics.json"


@pytest.fixture(autouse=True)
def spec(folder: Path) -> None:
    for name in ("shaper", "press"):
        shutil.copy(CONFIGS / f"{name}.toml", folder)


def told(cli: Cli, *args: str) -> dict[str, Any]:
    code, out, err = cli(*args, "-q", "--no-store", "-f", "json")
    assert (code, err) == (0, "")
    found: dict[str, Any] = json.loads(out)
    return found


def test_plans_to_scale(cli: Cli) -> None:
    found = told(cli, "kinematics", "shaper.toml", "--polygons", "4,9", "--scale", "40 mm")
    columns = found["columns"]
    assert {*columns["i"]} == {"4", "9"}
    assert found["mu_v[m/s/mm]"] == pytest.approx(0.2 * 5.759587 / 40)
    row = [*zip(columns["i"], columns["plan"], columns["to"], strict=True)].index(("9", "a", "a2"))
    assert columns["segment[mm]"][row] == pytest.approx(40)
    assert "omega_3[rad/s]" in found["rotation_in_9"]


# a table of the textbook, the case of its numbers, its columns with their names there; M23 acts on the other link
TABLES = (
    ("dyn-press-ideal", "RT0_A=R21T RN0_A=R21N N0_B0=R30 R0_B_x=R32x R0_B_y=R32y M0_drive=M_bal"),
    (
        "dyn-press-friction",
        "M_fr_A=M21 M_fr_B=-M23 F_fr_B0=F30 RT_A=R21T RN_A=R21N N_B0=R30 h_B0=h_mm R_B_x=R32x R_B_y=R32y M_drive=M_bal",
    ),
)


@pytest.mark.parametrize(("case", "names"), TABLES, ids=["D.3.1", "D.3.2"])
def test_tables_of_all_positions(cli: Cli, case: str, names: str) -> None:
    """One command prints table D.3.1 of the press, without friction, and one table D.3.2."""
    book = next(each for each in json.loads(DYNAMICS.read_text()) if each["id"] == case)
    near = {key: book["tolerance"][key] for key in ("rel", "abs")}
    pairs = [pair.split("=") for pair in names.split()]
    columns = ",".join(own for own, _ in pairs)
    found = told(cli, "forces", "press.toml", "--columns", columns, "--positions", "0:12")["columns"]
    by_name = {header.partition("[")[0]: values for header, values in found.items()}
    labels = [str(i) if i != 9 else "9-" for i in range(13)]  # at 270 deg the textbook has the limit before
    rows = [by_name["i"].index(label) for label in labels]
    for own, theirs in pairs:
        sign, scale = (-1 if theirs.startswith("-") else 1), (1e3 if theirs.endswith("_mm") else 1)
        values = [sign * scale * by_name[own][row] for row in rows]
        assert values == pytest.approx(book["expected"][theirs.lstrip("-")], **near), own


def test_the_lever_balances(cli: Cli) -> None:
    found = told(cli, "forces", "shaper.toml", "--lever", "4,21")
    for label in ("4", "21"):
        balance = found[f"balance_in_{label}"]
        assert balance["M_drive_lever[N*m]"] == pytest.approx(balance["M_drive[N*m]"], rel=1e-9)
        rows = [k for k, i in enumerate(found["columns"]["i"]) if i == label]
        moments = [found["columns"]["moment[N*mm]"][k] for k in rows]
        assert sum(moments) == pytest.approx(balance["moment_sum[N*mm]"])


def test_links_by_themselves(cli: Cli) -> None:
    found = told(cli, "forces", "press.toml", "--bodies", "9-")
    assert found["link_2_in_9-"]["about"] == "B"
    columns = found["columns"]
    row = columns["name"].index("R21")
    assert columns["moment[N*m]"][row] == pytest.approx(columns["arm[m]"][row] * columns["force[N]"][row])
    couple = columns["name"].index("M21")
    assert columns["force[N]"][couple] == ""
    assert abs(found["link_2_in_9-"]["moment_left[N*m]"]) < 1e-12


@pytest.mark.parametrize("stage", ["kinematics", "forces"])
def test_no_table_and_no_file_has_the_columns_by_choice(cli: Cli, stage: str, folder: Path) -> None:
    code, out, _ = cli(stage, "shaper.toml", "-q", "-f", "csv")
    headers = out.splitlines()[0].split(",")
    file = (folder / "shaper.out" / f"{stage}.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
    assert code == 0
    assert headers == file
    assert not [name for name in headers if name.startswith(("vrel", "an_", "aK", "Pi", "RT", "R0", "h_", "A_fr"))]


def test_a_wildcard_means_the_table_first(cli: Cli) -> None:
    columns = told(cli, "forces", "press.toml", "--columns", "R_*,RT_*,Pi_*,h_B0", "--positions", "1,2")["columns"]
    assert [*columns][-6:] == ["Pi_2_y[N]", "Pi_2[N]", "Pi_3_x[N]", "Pi_3_y[N]", "Pi_3[N]", "h_B0[m]"]
    assert "RT_A[N]" in columns
    assert not [name for name in columns if name.startswith("R0")]


@pytest.mark.parametrize(
    ("args", "words"),
    [
        (("kinematics", "shaper.toml", "--polygons", "99"), "no position is called '99'"),
        (("kinematics", "shaper.toml", "--polygons", "3", "--plan"), "print one table each"),
        (("kinematics", "shaper.toml", "--polygons", "3", "--positions", "2"), "leave --positions out"),
        (("kinematics", "shaper.toml", "--polygons", "3", "--method", "differences"), "exact derivatives"),
        (("kinematics", "shaper.toml", "--scale", "40 mm"), "only the plans have a scale"),
        (("kinematics", "shaper.toml", "--polygons", "3", "--scale", "0 mm"), "no length of a segment"),
        (("kinematics", "shaper.toml", "--polygons", "3", "--scale", "4 kg"), "write --scale crank"),
        (("kinematics", "shaper.toml", "--columns", "vrel_D_B"), "did you mean vrel_D_C"),
        (("forces", "shaper.toml", "--lever", "4,x"), "no position is called 'x'"),
        (("forces", "shaper.toml", "--lever", "4", "--bodies", "4"), "print one table each"),
        (("forces", "shaper.toml", "--lever", "4", "--columns", "phi"), "leave --columns and --positions out"),
        (("forces", "shaper.toml", "--bodies", "4", "--stop", "0.1"), "add --iterations"),
        (("forces", "shaper.toml", "--columns", "Pi_9_x"), "no column is called 'Pi_9_x'"),
    ],
)
def test_what_is_refused(cli: Cli, args: tuple[str, ...], words: str) -> None:
    code, out, err = cli(*args, "-q", "--no-store")
    assert (code, out) == (2, "")
    assert words in err
