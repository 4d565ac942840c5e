"""``tmmcalc gears planetary`` through the command line: formats, faults and their exit codes."""

from __future__ import annotations

import csv
import io
import json
import math
import tomllib
from pathlib import Path

import pytest

from .conftest import CONFIGS, Cli

FERGUSON = (
    '[gearing]\nlayout = "AA"\nteeth = [100, 101, 100, 99]\nspeeds = { H = "1000 rpm" }\nload = { 1 = "10 N*m" }\n'
)
DIFFERENTIAL = str(CONFIGS / "gears-differential.toml")
RAVIGNEAUX = str(CONFIGS / "gears-ravigneaux.toml")
COMMAND = ("gears", "planetary", "--no-store", "-q")


@pytest.fixture
def ferguson(folder: Path) -> str:
    (folder / "ferguson.toml").write_text(FERGUSON)
    return "ferguson.toml"


def test_ferguson(cli: Cli, ferguson: str) -> None:
    """Ten thousand to one; the losses make it self-locking backwards, with the figure of table 4.6."""
    code, out, err = cli(*COMMAND, ferguson)
    assert (code, err) == (0, "")
    assert "ratio H : 1            10000\n" in out
    assert "ratio 1 : H            1/10000 = 0.0001\n" in out
    assert "self-locking: no load can be moved this way" in out
    assert max(map(len, out.splitlines())) <= 80


def test_formats(cli: Cli, ferguson: str) -> None:
    as_json = json.loads(cli(*COMMAND, ferguson, "-f", "json").out)
    as_toml = tomllib.loads(cli(*COMMAND, ferguson, "-f", "toml").out)
    assert as_json == as_toml
    assert as_json["i_H_1_exact"] == "10000"
    assert as_json["eta_H_1"] == pytest.approx(as_json["eta_formula_H_1"], rel=1e-12)
    rows = list(csv.DictReader(io.StringIO(cli(*COMMAND, ferguson, "-f", "csv").out)))
    assert [row["member"] for row in rows] == ["1", "2", "3", "H"]
    assert float(rows[0]["omega[rad/s]"]) == pytest.approx(0.1 * math.pi / 30, rel=1e-12)
    assert rows[0]["i exact"] == "10000"
    assert rows[2]["i"] == ""


def test_differential(cli: Cli) -> None:
    code, out, _ = cli(*COMMAND, DIFFERENTIAL)
    assert code == 0
    assert "n_right = 22/37 n_pinion - n_left" in out


@pytest.mark.parametrize(
    ("override", "code", "said"),
    [
        ("gearing.speeds={small=10}", 2, "are not determined: 1 more must be given"),
        ("gearing.speeds={small=10,H=0,ring=10}", 2, "make it 4.05405"),
        ("gearing.speeds={smal=10,H=0}", 2, 'did you mean "small"?'),
        ('gearing.locked=[["small","ring"]]', 3, "let it not turn"),
        ('gearing.load={ring="2 N*m",small="3 N*m"}', 2, "leave out a known torque"),
    ],
)
def test_wrong_input(cli: Cli, override: str, code: int, said: str) -> None:
    found = cli(*COMMAND, RAVIGNEAUX, "--set", override)
    assert (found.code, found.out) == (code, "")
    assert said in found.err


def test_self_locking_is_a_warning(cli: Cli, ferguson: str) -> None:
    overrides = ("--set", 'gearing.speeds={1="1 rpm"}', "--set", "gearing.load={H=10}")
    code, out, _ = cli(*COMMAND, ferguson, *overrides)
    assert code == 0
    assert "warning: self-locking: with torques H = -10 N*m" in out
    assert cli(*COMMAND, ferguson, *overrides, "--strict").code == 5


def test_a_spec_without_gears(cli: Cli) -> None:
    code, _, err = cli(*COMMAND, "my.toml")
    assert code == 2
    assert "neither [gearing] nor [train]" in err


def test_of_a_train(cli: Cli) -> None:
    bare = str(CONFIGS / "gears-radial-planets.toml")
    code, out, _ = cli(*COMMAND, bare, "--choose", "3")
    assert code == 0
    assert ", set 3 of " in out
    code, out, _ = cli(*COMMAND, str(CONFIGS / "gears-single-planets.toml"), "--choose", "3", "--external")
    assert code == 0
    assert "AIbar with 3 planets: 20/52/124, row 3 of 32" in out
    assert "needs internal wheels" in out
    found = json.loads(cli(*COMMAND, str(CONFIGS / "gears-double-planets.toml"), "-f", "json").out)
    types = found["types for the ratio 31.29 with 3 planets"]["columns"]
    assert types["U"][types["type"].index("AI")] == pytest.approx(30.29, rel=1e-15)


def test_run_and_check(cli: Cli) -> None:
    code, out, _ = cli("check", DIFFERENTIAL, RAVIGNEAUX)
    assert code == 0
    assert out.count("meshes)") == 2
    code, out, _ = cli("run", RAVIGNEAUX, "-q", "-o", "out")
    assert code == 0
    assert "\ngearing\n" in out
    assert Path("out/gearing.csv").exists()


S20 = next(
    case
    for case in json.loads((Path(__file__).parents[1] / "cases" / "gear-trains.json").read_text())
    if case["id"] == "GT-S20"
)


@pytest.mark.parametrize("item", range(3))
@pytest.mark.parametrize("by_angles", [False, True])
def test_real_teeth_of_pairs_of_planets(cli: Cli, folder: Path, item: int, by_angles: bool) -> None:
    """GT-S20 from the command line; the second item by its mesh angles as well."""
    given, expected = S20["inputs"]["items"][item], S20["expected"]["items"][item]
    shape = f"t1 = {given['t1']}\nt2 = {given['t2']}\n"
    if by_angles:
        angles = {1: ["20 deg", "25 deg", "22 deg"]}.get(item, ["21 deg"] * 3)
        shape = f"mesh_angles = {json.dumps(angles)}\n"
    radial = f"[train.radial]\ny = {given['y']}\nassembly_number = {given['N']}\n{shape}"
    train = f'[train]\nlayout = "2A-AA"\nratio = "{given["i_1H"]}"\nplanets = {given["k"]}\nz_max = 110\n'
    (folder / "radial.toml").write_text(train + radial)
    code, out, _ = cli(*COMMAND, "radial.toml", "-f", "json")
    assert code == 0
    (part,) = (value for title, value in json.loads(out).items() if "real-valued teeth" in title)
    for key in ("Z1", "Z2", "Z3", "Z4", "denominator", "i_min_coaxial", "i_max_neighbour1", "i_bound_neighbour2"):
        assert part[key] == pytest.approx(expected[key], abs=1e-4)
    assert part["i_range"] == pytest.approx(expected["i_range"], abs=1e-4)
    assert part["second_bracket"] == pytest.approx(expected["second_bracket"], abs=1e-4)
    assert part["neighbour2_is_upper_bound"] is expected["neighbour2_is_upper_bound"]
    assert abs(part["coaxial_residual"]) < 1e-6
    first = [part["columns"][name][0] for name in ("y", "D", "i_min", "i_max")]
    assert first == pytest.approx([given["y"], expected["denominator"], *expected["i_range"]], abs=1e-4)


def test_yes_and_no_are_truths_for_programs(cli: Cli, folder: Path) -> None:
    (folder / "several.toml").write_text('[train]\nlayout = ["AIbar", "AI"]\nratio = "7.29"\nsum_max = 90\n')
    columns = json.loads(cli("gears", "synth", "--no-store", "-q", "several.toml", "-f", "json").out)["columns"]
    assert {*columns["coprime"]} == {True, False}
    assert {*columns["textbook"]} <= {True, False, ""}
    printed = cli("gears", "synth", "--no-store", "-q", "several.toml").out
    assert " yes " in printed or " no " in printed
    assert "True" not in printed + cli("gears", "synth", "--no-store", "-q", "several.toml", "-f", "csv").out
