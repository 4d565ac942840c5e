"""``tmmcalc gears pair``, ``blocking`` and ``measure`` through the command line: formats, faults, exit codes."""

from __future__ import annotations

import csv
import io
import json
import math
import re
import tomllib
from pathlib import Path

import pytest

from .conftest import CONFIGS, Cli

CASES = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[1] / "cases" / "involute-geometry.json").read_text())
}
HELICAL = """
[project]
title = "Reducer"

[pair]
teeth = [14, 17]
module = "5 mm"
helix_angle = "15 deg"
centre_distance = "85 mm"
x1 = 0.6
face_width = "40 mm"
"""
SEVERAL = """
[pair]
module = "2 mm"

[[pair.meshes]]
name = "first"
teeth = [20, 45]

[[pair.meshes]]
name = "second"
teeth = [25, 80]
kind = "internal"
"""
SPUR = """
[pair]
teeth = [14, 17]
module = "5 mm"
x1 = 0.6
x2 = 0.522
"""
FLAGS = ("--no-store", "-q")


@pytest.fixture
def helical(folder: Path) -> str:
    (folder / "helical.toml").write_text(HELICAL)
    return "helical.toml"


@pytest.fixture
def several(folder: Path) -> str:
    (folder / "several.toml").write_text(SEVERAL)
    return "several.toml"


@pytest.fixture
def spur(folder: Path) -> str:
    (folder / "spur.toml").write_text(SPUR)
    return "spur.toml"


def test_the_pair_of_the_course(cli: Cli, helical: str) -> None:
    """IG-S04."""
    expected = CASES["IG-S04"]["expected"]
    code, out, err = cli("gears", "pair", *FLAGS, helical)
    assert (code, err) == (0, "")
    assert out.startswith("Reducer: pairs of gears\n")
    degrees, minutes, seconds = expected["alpha_tw_dms"]
    assert f"27.95685 deg = {degrees} deg {minutes}'{seconds}\"" in out
    assert re.search(r"\nreference radius +r +36\.2347 +43\.9992\n", out)
    assert "warning: transverse contact ratio 1.112 below 1.2" in out
    assert max(map(len, out.splitlines())) <= 80
    assert cli("gears", "pair", *FLAGS, helical, "--strict").code == 5


def test_formats_of_pairs(cli: Cli, helical: str) -> None:
    expected = CASES["IG-S04"]["expected"]
    as_json = json.loads(cli("gears", "pair", *FLAGS, helical, "-f", "json").out)
    assert tomllib.loads(cli("gears", "pair", *FLAGS, helical, "-f", "toml").out) == as_json
    assert as_json["alpha_tw[rad]"] == pytest.approx(expected["alpha_tw_rad"], abs=1e-9)
    assert as_json["x_2"] == pytest.approx(expected["x_sum"] - 0.6, abs=1e-6)
    assert as_json["wheels"]["2"]["r_a[m]"] == pytest.approx(expected["r_a2"] / 1000, abs=1e-9)
    answer = cli("gears", "pair", *FLAGS, helical, "-f", "csv")
    assert "warning: transverse contact ratio" in answer.err
    rows = list(csv.DictReader(io.StringIO(answer.out)))
    active = [row for row in rows if row["active"] == "yes"]
    assert float(active[0]["theta1"]) == pytest.approx(expected["theta1_at_A2"], abs=1e-6)
    assert float(active[-1]["theta2"]) == pytest.approx(expected["theta2_at_A1"], abs=1e-6)


def test_one_of_several(cli: Cli, several: str) -> None:
    code, out, _ = cli("gears", "pair", *FLAGS, several)
    assert code == 0
    assert "\nfirst: z = 20/45\n" in out
    assert "\nsecond: z = 25/80 (ring)\n" in out
    alone = cli("gears", "pair", *FLAGS, several, "--pair", "second").out
    assert "z = 20/45" not in alone
    assert "wheel 2 (ring)" in alone
    code, out, err = cli("gears", "pair", *FLAGS, several, "--pair", "third")
    assert (code, out) == (2, "")
    assert "pairs: first, second" in err


def test_a_pair_that_cannot_work(cli: Cli, spur: str) -> None:
    """Refused with the reason; or all of it told."""
    overrides = ("--set", "pair.x1=-0.3", "--set", "pair.x2=0")
    code, out, err = cli("gears", "pair", *FLAGS, spur, *overrides)
    assert (code, out) == (3, "")
    assert "cuts into the fillet" in err
    code, out, _ = cli("gears", "pair", *FLAGS, spur, *overrides, "--set", "pair.refuse=false")
    assert code == 0
    assert "warning: cannot work: " in out


def test_measures(cli: Cli, helical: str) -> None:
    """One more tooth is one more base pitch, balls as asked."""
    pitch = 0.005 * math.pi * math.cos(math.radians(20))
    both = [
        json.loads(cli("gears", "measure", *FLAGS, helical, "--wheel", "1", "--teeth", k, "-f", "json").out)["wheel 1"]
        for k in ("2", "3")
    ]
    assert both[1]["W[m]"] - both[0]["W[m]"] == pytest.approx(pitch, rel=1e-12)
    code, out, _ = cli("gears", "measure", *FLAGS, helical, "--ball", "8.5 mm", "--teeth", "9")
    assert code == 0
    assert out.count("with D = 8.5 mm") == 2
    assert out.count("not valid: beyond the tip; not admitted by the textbook's") == 2
    assert max(map(len, out.splitlines())) <= 80
    rows = list(csv.DictReader(io.StringIO(cli("gears", "measure", *FLAGS, helical, "-f", "csv").out)))
    assert {row["wheel"] for row in rows} == {"1", "2"}


def test_sliding_in_steps(cli: Cli, helical: str) -> None:
    """As program 1.15 lists it: 0.5, 2.5, 4.5 mm ... up to g; the table of the stage stays as it is."""
    usual = cli("gears", "pair", *FLAGS, helical, "-f", "csv").out
    out = cli("gears", "pair", *FLAGS, helical, "--sliding-step", "2 mm", "-f", "csv").out
    rows = list(csv.DictReader(io.StringIO(out)))
    assert [float(row["rho1[m]"]) for row in rows] == pytest.approx([0.0005 + 0.002 * k for k in range(20)])
    g, u = CASES["IG-S06"]["expected"]["N1N2"] / 1000, 17 / 14
    for row in rows:
        rho = float(row["rho1[m]"])
        assert float(row["theta1"]) == pytest.approx(1 - (g - rho) / (u * rho), rel=1e-6)
    assert cli("gears", "pair", *FLAGS, helical, "-f", "csv").out == usual
    table = cli("gears", "pair", *FLAGS, helical, "--sliding-step", "2 mm").out
    assert "\nsliding\n" in table
    assert max(map(len, table.splitlines())) <= 80
    code, _, err = cli("gears", "pair", *FLAGS, helical, "--sliding-step", "2")
    assert code == 2
    assert "--sliding-step" in err


def test_circles_of_the_tooth(cli: Cli, helical: str) -> None:
    flags = ("--wheel", "2", "--radius", "45 mm", "--radius", "48 mm", "-f", "json")
    found = json.loads(cli("gears", "measure", *FLAGS, helical, *flags).out)["wheel 2"]
    asked = [row for row in found["chords"] if row["circle"] == "asked"]
    assert [row["r[m]"] for row in asked] == pytest.approx([0.045, 0.048], rel=1e-14)
    for row in asked:
        assert row["s_t[m]"] == pytest.approx(2 * row["r[m]"] * row["theta[rad]"], rel=1e-13)
        assert row["arc[m]"] == pytest.approx(row["s_t[m]"] * math.cos(row["beta_y[rad]"]), rel=1e-13)


def test_what_programs_get_of_a_pair(cli: Cli, helical: str) -> None:
    """IG-S04; keys that a hand calculation has beside the radii."""
    expected = CASES["IG-S04"]["expected"]
    found = json.loads(cli("gears", "pair", *FLAGS, helical, "-f", "json").out)
    for key in ("inv_alpha_t", "inv_alpha_tw"):
        assert found[key] == pytest.approx(expected[key], abs=1e-9)
    assert found["gamma[rad]"] == pytest.approx(expected["gamma_rad"], abs=1e-9)
    assert found["p_t[m]"] == pytest.approx(expected["p_t"] / 1000, abs=1e-9)
    assert found["alpha_tw_dms"] == expected["alpha_tw_dms"]
    alpha_t = math.radians(expected["alpha_t_deg"])
    assert found["rho_t*"] == pytest.approx(0.25 / (1 - math.sin(alpha_t)), abs=1e-8)
    flat = math.pi / 4 / math.cos(math.radians(15)) - math.tan(alpha_t) - found["rho_t*"] * math.cos(alpha_t)
    assert found["e_S[m]"] == pytest.approx(0.005 * flat, abs=1e-9)
    for number, wheel in found["wheels"].items():
        assert wheel["r_gamma[m]"] == pytest.approx(expected[f"r{number}"] * expected["gamma_rad"] / 1000, abs=1e-9)
        assert wheel["psi_w[rad]"] == pytest.approx(wheel["psi[rad]"] - expected["gamma_rad"], abs=1e-9)
        assert wheel["s_ta[m]"] == pytest.approx(expected[f"s_a{number}_transverse"] / 1000, abs=1e-9)
        assert {"Y_F", "s_Fn[m]", "h_F[m]", "z_min"} <= set(wheel)
        assert "r_p_left[m]" not in wheel
    assert not any(key.endswith("_left") for key in found)


def test_shortened_flanks_have_their_own_names(cli: Cli, spur: str) -> None:
    spec = ("--set", "pair.teeth=[10, 20]", "--set", "pair.x1=0.15", "--set", "pair.x2=0.3")
    more = ("--set", "pair.helix_angle='12 deg'", "--set", "pair.face_width='30 mm'", "--set", "pair.refuse=false")
    found = json.loads(cli("gears", "pair", *FLAGS, spur, *spec, *more, "-f", "json").out)
    assert found["theta_1"] == pytest.approx(-29.93941, abs=1e-5)
    assert found["lambda_start"] == pytest.approx(9.92566, abs=1e-5)
    assert found["wheels"]["1"]["r_p[m]"] == pytest.approx(0.02395940, abs=1e-8)
    assert found["eps_gamma"] == pytest.approx(found["eps_alpha"] + found["eps_beta"], rel=1e-14)
    assert found["eps_gamma_shortened"] == pytest.approx(found["eps_alpha_shortened"] + found["eps_beta"], rel=1e-14)
    assert found["theta_1"] < found["theta_1_left"] < 0
    assert found["wheels"]["1"]["r_p_left[m]"] > found["wheels"]["1"]["r_p[m]"]
    total = next(check for check in found["checks"] if check["check"] == "total contact ratio")
    assert total["value"] == found["eps_gamma"]


def test_lines_of_the_contour(cli: Cli, spur: str) -> None:
    found = json.loads(cli("gears", "blocking", *FLAGS, spur, "-f", "json").out)
    numbers = {line["number"] for line in found["lines"]}
    assert {"4", "5", "6", "7", "8", "9", "14", "15", "16"} <= numbers
    for line in found["lines"]:
        assert len(line["x_1"]) == len(line["x_2"]) >= 2
        if line["number"] in ("14", "15", "16"):
            totals = [one + two for one, two in zip(line["x_1"], line["x_2"], strict=True)]
            assert totals == pytest.approx([line["value"]] * len(totals), abs=1e-12)


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--ball", "8.5"), "'8.5' has no unit"),
        (("--ball", "8.5 deg"), "is an angle"),
        (("--ball", "0 mm"), "'0 mm' is not above zero"),
        (("--wheel", "3"), "wheels: 1, 2"),
        (("--pair", "3"), "no pair is called '3'"),
        (("--teeth", "1"), "--teeth"),
        (("--radius", "67"), "'67' has no unit"),
        (("--radius", "0 mm"), "--radius"),
    ],
)
def test_wrong_measures(cli: Cli, helical: str, flags: tuple[str, str], said: str) -> None:
    code, out, err = cli("gears", "measure", *FLAGS, helical, *flags)
    assert (code, out) == (2, "")
    assert said in err


def test_blocking(cli: Cli, spur: str) -> None:
    """IG-S09: corners, points C and E, where the chosen shifts stand; the boundary as csv."""
    expected = CASES["IG-S09"]["expected"]
    code, out, _ = cli("gears", "blocking", *FLAGS, spur)
    assert code == 0
    assert "x_1 = 0.6, x_2 = 0.522: within the strict contour" in out
    assert max(map(len, out.splitlines())) <= 80
    found = json.loads(cli("gears", "blocking", *FLAGS, spur, "-f", "json").out)
    corners = sorted((corner["x_1"], corner["x_2"]) for corner in found["corners"]["strict"])
    vertices = sorted((vertex["x1"], vertex["x2"]) for vertex in expected["strict_vertices"])
    for corner, vertex in zip(corners, vertices, strict=True):
        assert corner == pytest.approx(vertex, abs=2e-4)
    assert found["area_strict"] == pytest.approx(expected["strict_area"], abs=3e-3)
    assert found["margins"]["undercut1"] == pytest.approx(expected["points"][0]["uc1"], abs=1e-5)
    best = found["points"]["E"]
    assert best["eps_alpha"] == pytest.approx(expected["max_contact_ratio"]["eps_alpha"], abs=1e-5)
    strong = found["points"]["C"]
    assert strong["x_1"] + strong["x_2"] == pytest.approx(expected["max_contact_strength_eps1"]["x_sum"], abs=2e-4)
    rows = list(csv.DictReader(io.StringIO(cli("gears", "blocking", *FLAGS, spur, "-f", "csv").out)))
    assert {row["contour"] for row in rows} >= {"strict", "tolerated"}
    low = min(float(row["x1"]) for row in rows if row["contour"] == "strict")
    assert low == pytest.approx(vertices[0][0], abs=2e-4)


def test_a_ring_has_no_contour(cli: Cli, several: str) -> None:
    code, out, _ = cli("gears", "blocking", *FLAGS, several)
    assert code == 0
    assert "first: z = 20/45" in out
    assert "note: " in out
    assert "second" in out


def test_run_and_files(cli: Cli, helical: str) -> None:
    code, out, _ = cli("run", helical, "-q", "-o", "out")
    assert code == 0
    assert "\npair\n" in out
    assert "\nblocking\n" in out
    assert Path("out/pair.csv").exists()
    assert Path("out/blocking.csv").exists()
    again = cli("gears", "pair", helical, "-o", "out")
    assert "1 stage loaded in" in again.err
    assert cli("gears", "pair", *FLAGS, helical).out == again.out


def test_of_a_train(cli: Cli) -> None:
    """Every mesh of the chosen train, at one centre distance, by the names of its wheels."""
    spec = str(CONFIGS / "gears-pairs.toml")
    found = json.loads(cli("gears", "pair", *FLAGS, spec, "-f", "json").out)
    first, second = (pair for key, pair in found.items() if key.startswith(("1-2", "2-3")))
    assert first["a_w[m]"] == pytest.approx(second["a_w[m]"], rel=1e-12)
    assert first["wheels"]["2"]["x"] == second["wheels"]["2"]["x"]
    assert set(second["wheels"]) == {"2", "3"}


def test_a_spec_without_pairs(cli: Cli) -> None:
    for command in ("pair", "blocking", "measure"):
        code, out, err = cli("gears", command, *FLAGS, "my.toml")
        assert (code, out) == (2, "")
        assert "[pair]" in err
