"""``tmmcalc gears pair``, ``blocking`` and ``measure`` through the command line: formats, faults, exit codes."""

from __future__ import annotations

import csv
import io
import json
import math
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
    assert "reference radius                 r       36.2347  43.9992\n" in out
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


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--ball", "8.5"), "'8.5' has no unit"),
        (("--ball", "8.5 deg"), "is an angle"),
        (("--ball", "0 mm"), "0 cannot be measured over"),
        (("--wheel", "3"), "wheels: 1, 2"),
        (("--pair", "3"), "no pair is called '3'"),
        (("--teeth", "0"), "--teeth"),
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
    assert "pair: loaded" in again.err
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
