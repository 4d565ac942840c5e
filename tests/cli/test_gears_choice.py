"""``tmmcalc gears strength`` and ``tmmcalc gears compare``: the whole chain from a spec, formats, messages."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path
from typing import Any

import pytest
from sparing import sparing

from .conftest import CONFIGS, ROOT, Cli

READY = sorted(file.stem for file in CONFIGS.glob("gears-*.toml") if "\n[strength]" in file.read_text(encoding="utf-8"))
CASES: dict[str, Any] = {
    case["id"]: case for case in json.loads((ROOT / "tests" / "cases" / "gear-trains.json").read_text())
}
CHAIN = """
[train]
layout = "AI"
ratio = "31.29"
tolerance = "0.5"
tolerance_kind = "absolute"
module_ratios = [[4, 7]]

[strength]
torque = "75 N*m"
face_width = 0.6
material = { steel = "40Kh", treatment = "improved", hardness = "300 HB", load = "one-sided" }
"""


@pytest.fixture(autouse=True)
def chain() -> None:
    Path("gears.toml").write_text(CHAIN)


def test_the_whole_chain_of_the_course(cli: Cli) -> None:
    """GT-S18: candidates, modules, widths, mass, inertia, size, the Pareto front and the train of least inertia."""
    code, out, err = cli("gears", "compare", "gears.toml", "-f", "csv", "-q")
    assert (code, err) == (0, "")
    rows = {tuple(int(row[f"z_{w}"]) for w in ("1", "2", "2'", "3")): row for row in csv.DictReader(io.StringIO(out))}
    expected = CASES["GT-S18"]["expected"]
    assert len(rows) == expected["n_candidates"]
    for case in expected["candidates"]:
        row = rows[tuple(case["z"])]
        for column, key, scale in (
            ("m_1[m]", "m1", 1e3),
            ("m_2[m]", "m2", 1e3),
            ("b_1[m]", "b1", 1e3),
            ("b_2[m]", "b2", 1e3),
        ):
            assert scale * float(row[column]) == pytest.approx(case[key], abs=1e-9)
        assert float(row["mass[kg]"]) == pytest.approx(case["M_sum_kg"], abs=6e-5)
        assert float(row["inertia[kg*m^2]"]) == pytest.approx(case["J_kgm2"], abs=6e-6)
        assert 1e3 * float(row["size[m]"]) == pytest.approx(case["D_mm"], abs=1e-9)
    front = {teeth for teeth, row in rows.items() if row["front"] == "yes"}
    assert front == {tuple(case["z"]) for case in expected["pareto_front"]}
    printed = json.loads(cli("gears", "compare", "gears.toml", "-f", "json", "-q").out)
    assert printed["teeth"] == min(expected["candidates"], key=lambda case: case["J_kgm2"])["z"]
    assert printed["J_crank[kg*m^2]"] == printed["J_output[kg*m^2]"] == printed["inertia[kg*m^2]"]
    assert printed["ratio_exact"] == "3933/125"


def test_table_of_the_front(cli: Cli) -> None:
    code, out, _ = cli("gears", "compare", "gears.toml", "-q")
    assert code == 0
    assert "best train          AI with 3 planets: 25/136/20/112 (row 4)" in out
    assert "its inertia is the least, 3.1731 kg*m^2; next 3.5305 kg*m^2" in " ".join(out.split())
    heads = [line.split() for line in out.splitlines() if line.split()[:2] == ["i", "z_1"]]
    assert heads == [
        ["i", "z_1", "z_2", "z_2'", "z_3", "m_1", "m_2", "b_1", "b_2", "mass", "inertia", "size", "envelope"]
    ]
    listed = [line.split()[:5] for line in out.splitlines() if len(line.split()) == 13 and line.split()[0].isdigit()]
    assert [row[1:] for row in listed] == [
        ["25", "136", "20", "112"],
        ["27", "141", "20", "116"],
        ["28", "140", "19", "115"],
        ["28", "133", "17", "109"],
    ]


def test_coefficients_with_their_sources(cli: Cli) -> None:
    code, out, _ = cli("gears", "strength", "gears.toml", "-q", "--rows", "2")
    text = " ".join(out.split())
    assert code == 0
    assert "wheels 1, 2, 2', 3 sigma_Hlim = 670 MPa: textbook, Table D.4.4" in text
    assert "strong enough 11 of 11" in text
    coefficients = json.loads(cli("gears", "strength", "gears.toml", "-q", "-f", "json").out)["coefficients"]
    assert all(each["source"] for each in coefficients)
    one = " ".join(cli("gears", "strength", "gears.toml", "-q", "--train", "4").out.split())
    assert "AI with 3 planets: 25/136/20/112" in one
    assert "mesh 1-2" in one
    assert f"A_H = {CASES['GT-S18']['expected']['A_H']:.4f} mm" in one
    code, out, err = cli("gears", "strength", "gears.toml", "-q", "--train", "12")
    assert (code, out) == (2, "")
    assert "there is no row 12: 11 sets are sized" in err


def test_rows_count_from_1_everywhere(cli: Cli) -> None:
    """The row of the table, of the list, of --train and of choose is one number."""
    for command in ("strength", "compare"):
        listed = list(csv.DictReader(io.StringIO(cli("gears", command, "gears.toml", "-q", "-f", "csv").out)))
        assert [row["i"] for row in listed] == [str(k) for k in range(1, 12)]
    text = cli("gears", "strength", "gears.toml", "-q", "--rows", "11").out
    lines = [line.split() for line in text.splitlines()]
    shown = {cells[0]: "/".join(cells[1:5]) for cells in lines if len(cells) > 8 and "".join(cells[:5]).isdigit()}
    assert len(shown) == 11
    for row in ("1", "11"):
        assert shown[row] in cli("gears", "strength", "gears.toml", "-q", "--train", row).out
        asked = ("--set", f"criteria.choose={row}", "-q", "-f", "json")
        best = json.loads(cli("gears", "compare", "gears.toml", *asked).out)
        assert ("/".join(map(str, best["teeth"])), best["winner_row"]) == (shown[row], int(row))


def test_given_sizes_are_shown_with_stresses_and_margins(cli: Cli) -> None:
    flags = ("--set", 'strength.module=["2 mm", "3.5 mm"]', "--set", 'strength.width=["12 mm", "37 mm"]', "-q")
    out = " ".join(cli("gears", "strength", "gears.toml", *flags, "--rows", "2").out.split())
    for header in ("sigma_H", "sigma_HP", "margin_H", "sigma_F", "sigma_FP", "margin_F"):
        assert f" {header} " in out
    assert re.search(r" 1 22/118/17/97 2 \d", out)
    assert "mm needed at this module" in out
    listed = list(csv.DictReader(io.StringIO(cli("gears", "strength", "gears.toml", *flags, "-f", "csv").out)))
    row = listed[3]
    stress, permissible = float(row["sigma_H_1[Pa]"]), float(row["sigma_HP_1[Pa]"])
    assert float(row["margin_H_1"]) == pytest.approx(1 - stress / permissible, rel=1e-12)
    one = " ".join(cli("gears", "strength", "gears.toml", *flags, "--train", "4").out.split())
    assert f"stage 1: {stress / 1e6:.6g} MPa, permissible {permissible / 1e6:.6g} MPa, margin" in one
    assert "1 + beta_H psi, of the real width" in one


def test_why_sets_are_rejected(cli: Cli) -> None:
    flags = ("--set", 'strength.on_overload="reject"', "--set", "strength.modules_row=1", "-q")
    code, out, _ = cli("gears", "strength", "gears.toml", *flags)
    assert code == 0
    assert "- no pair" in out
    code, out, err = cli("gears", "compare", "gears.toml", *flags)
    assert (code, out) == (3, "")
    assert "11 of 11 sets are not strong enough" in err


@pytest.mark.parametrize("command", ["strength", "compare"])
@sparing("name", READY, every=4)
def test_ready_specs_stay_in_80_columns(cli: Cli, name: str, command: str) -> None:
    code, out, _ = cli("gears", command, str(CONFIGS / f"{name}.toml"), "--no-store", "-q", "--rows", "3")
    assert code == 0
    assert max(map(len, out.splitlines())) <= 80


def test_without_strength_there_is_nothing_to_compare(cli: Cli) -> None:
    Path("gears.toml").write_text(CHAIN.partition("[strength]")[0])
    code, out, err = cli("gears", "compare", "gears.toml", "-q")
    assert (code, out) == (2, "")
    assert "no [strength]: no torque and no materials" in err
    plan = json.loads(cli("plan", "gears.toml", "-f", "json").out)["columns"]
    reasons = dict(zip(plan["stage"], plan["why"], strict=True))
    assert reasons["strength"] == reasons["criteria"] == "no [strength]: no torque and no materials"


def test_a_whole_run_tells_of_the_choice(cli: Cli) -> None:
    found = json.loads(cli("run", "gears.toml", "-f", "json", "-q").out)
    assert found["criteria"]["winner"] == "AI 25/136/20/112"
    assert found["strength"]["accepted"] == 11


def test_one_train_is_chosen_everywhere(cli: Cli) -> None:
    """The winner by its row, or another row by --choose: the same teeth in all commands."""
    flags, row = ("-q", "-f", "json"), 5
    pairs = ("--set", 'pair.strategy="zero"')
    winner = json.loads(cli("gears", "compare", "gears.toml", *flags).out)
    for chosen, asked in ((winner["winner_row"], ()), (row, ("--choose", str(row)))):
        own = json.loads(cli("gears", "compare", "gears.toml", "--set", f"criteria.choose={chosen}", *flags).out)
        teeth = "/".join(map(str, own["teeth"]))
        planetary = json.loads(cli("gears", "planetary", "gears.toml", *asked, *flags).out)
        assert any(title.endswith(f"{teeth}, row {chosen} of 11") for title in planetary)
        for command in ("pair", "measure"):
            out = cli("gears", command, "gears.toml", *pairs, *asked, "-q").out
            assert f"1-2: z = {own['teeth'][0]}/{own['teeth'][1]}" in out
    code, _, err = cli("gears", "pair", str(CONFIGS / "pair-spur.toml"), "--choose", "2")
    assert code == 2
    assert "the pairs of the spec are written out" in err
    code, _, err = cli("gears", "planetary", "gears.toml", "--choose", "12")
    assert code == 2
    assert "there is no row 12" in err
