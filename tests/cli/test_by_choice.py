"""What is told by choice of kinematics and forces: plans, links by themselves, the lever, columns that no table has."""

from __future__ import annotations

import csv
import json
import shutil
from math import pi
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


def test_terms_of_the_lever_by_name(cli: Cli) -> None:
    """A wildcard finds them, each with unit and meaning; by the scale they make up the drive."""
    named = told(cli, "names", "shaper.toml", "lever_M*", "lever_mu_v")["columns"]
    keys = ("name", "unit", "value", "meaning")
    rows = zip(*(named[key] for key in keys), strict=True)
    found = {name.removeprefix("forces."): (unit, value, meaning) for name, unit, value, meaning in rows}
    scale = found.pop("lever_mu_v")[1]
    assert found["lever_M_Q5"] == ("N*mm", "", "moment of load Q5 about the pole of Zhukovsky's lever")
    assert all(unit == "N*mm" and meaning for unit, _, meaning in found.values())
    del found["lever_M"]
    table = told(cli, "forces", "shaper.toml", "--columns", f"M_drive,{','.join(found)}", "--positions", "4")["columns"]
    total = sum(table[f"{name}[N*mm]"][0] for name in found)
    assert table["M_drive[N*m]"][0] == pytest.approx(-total * scale / (2 * pi * 55 / 60), rel=1e-9)


def test_terms_in_a_sweep_and_a_constraint(cli: Cli, folder: Path) -> None:
    """The arm of the rod's reaction is no longer than the slotted link of 1020 mm; weights go with masses."""
    rule = '[[constraints]]\nname = "arm"\nvalue = "forces.size(eq_3_h_R34)"\nat_most = "{} m"\n'
    spec = (folder / "shaper.toml").read_text(encoding="utf-8")
    for limit, holds in (("1.1", True), ("0.9", False)):
        (folder / "ruled.toml").write_text(f"{spec}\n{rule.format(limit)}", encoding="utf-8")
        judged = told(cli, "feasibility", "ruled.toml")
        assert judged["feasible"] is holds
    names = "forces.max(lever_F_G5),forces.size(lever_M_Q5),forces.M_drive_lever@4,forces.M_drive@4"
    code, out, _ = cli(
        *("sweep", "shaper.toml", "--set", "mechanism.links[id=5].mass=100,200", "--columns", names, "-o", "-", "-q")
    )
    assert code == 0
    rows = [*csv.DictReader(out.splitlines())]
    assert [float(row["forces.max(lever_F_G5)[N]"]) for row in rows] == pytest.approx([981.0, 1962.0])
    assert len({row["forces.size(lever_M_Q5)[N*mm]"] for row in rows}) == 1  # a mass has no part in it
    for row in rows:
        balance = [float(row[f"forces.{name}@4[N*m]"]) for name in ("M_drive_lever", "M_drive")]
        assert balance[0] == pytest.approx(balance[1], rel=1e-9)


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


def test_passes_of_friction_have_a_column_by_pair(cli: Cli) -> None:
    """A slider rubs along its line, a pin about itself: the last pass is near the forces of the table."""
    for group, spec, joint, name in (("RRP(4,5)", "shaper", "D0", "F_fr_D0"), ("RRP(2,3)", "press", "A", "M_fr_A")):
        passes = told(cli, "forces", f"{spec}.toml", "--iterations", f"{group}@4", "--stop", "1e-6")["columns"]
        (header,) = [each for each in passes if each.startswith(name)]
        table = told(cli, "forces", f"{spec}.toml", "--columns", name, "--positions", "4")["columns"]
        assert passes[header][-1] == pytest.approx(table[header][0], rel=1e-4), joint
