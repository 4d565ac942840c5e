"""``tmmcalc gears wheel``, and ``measure`` and ``profile`` of a wheel without a mate."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest

from tmmcalc.project import templates

from .conftest import Cli

WHEEL = str(templates.folder() / "wheel.toml")
RING = """[wheel]
kind = "internal"
teeth = 57
module = "3 mm"
x = -0.3
cutter = { teeth = 25, rounding = 0.1 }
"""


@pytest.fixture
def ring() -> str:
    Path("ring.toml").write_text(RING)
    return "ring.toml"


def test_all_of_a_wheel(cli: Cli) -> None:
    code, out, _ = cli("gears", "wheel", WHEEL)
    assert code == 0
    assert "d = 139.7623 mm, d_a = 152.03 mm" in out
    assert "W = 54.80981 mm over 4 teeth" in out
    assert "good: all 2 conditions are kept" in out
    found = json.loads(cli("gears", "wheel", WHEEL, "-q", "-f", "json").out)
    assert found["W[m]"] == pytest.approx(0.05480981, abs=1e-8)
    assert found["r_s[m]"] == pytest.approx(0.0790985, abs=1e-7)
    assert {check["check"] for check in found["checks"]} == {"undercut", "tip thickness"}
    assert len(found["columns"]["x[m]"]) > 100


def test_a_ring(cli: Cli, ring: str) -> None:
    out = cli("gears", "wheel", ring, "-q").out
    assert "spur ring, without a mate" in out
    assert "cutter interference" in out
    assert "W =" not in out
    assert "between two balls" in cli("gears", "measure", ring, "-q").out


def test_measured_anew(cli: Cli) -> None:
    flags = ("--teeth", "3", "--ball", "8.5 mm", "--radius", "72 mm")
    found = json.loads(cli("gears", "measure", WHEEL, "-q", "-f", "json", *flags).out)["wheel 1"]
    assert found["z_w"] == 3
    assert found["D[m]"] == pytest.approx(0.0085)
    assert [row["circle"] for row in found["chords"]] == ["reference", "tip", "asked", "asked", "asked"]
    rows = csv.DictReader(io.StringIO(cli("gears", "measure", WHEEL, "-q", "-f", "csv").out))
    assert [row["z_w"] for row in rows if row["chosen"] == "yes"] == ["4"]


def test_files_of_its_outline(cli: Cli, ring: str) -> None:
    for spec, tip in ((WHEEL, 0.076015), (ring, 0.0834)):
        names = ("--outline", "w.csv", "--dxf", "w.dxf", "--svg", "w.svg")
        code, out, _ = cli("gears", "profile", spec, "--points", "9", *names)
        assert code == 0, out
        points = np.loadtxt("w.csv", delimiter=",", skiprows=1, usecols=(1, 2))
        radii = np.hypot(*points.T)
        assert (radii.min() if spec == ring else radii.max()) == pytest.approx(tip, abs=1e-9)
        assert Path("w.dxf").read_bytes().startswith(b"  0")
        assert "<svg" in Path("w.svg").read_text()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("measure", "--wheel", "2"), "there is no wheel '2'"),
        (("measure", "--pair", "2"), "a wheel without a mate, no pairs"),
        (("measure", "--choose", "2"), "a wheel without a mate, no pairs"),
        (("profile", "--axis", "pitch"), "no operating pitch circle"),
        (("profile", "--phase", "5 deg", "--svg", "w.svg"), "is not in mesh"),
    ],
)
def test_flags_of_pairs(cli: Cli, words: tuple[str, ...], message: str) -> None:
    command, *flags = words
    code, _, told = cli("gears", command, WHEEL, *flags)
    assert code == 2
    assert message in told


def test_faults_all_at_once(cli: Cli) -> None:
    bad = (
        RING.replace("25", "57")
        + 'span_teeth = 3\nundercut = "none"\naddendum = 1.9\nclearance = 0.9\ntip_thickness_min = 0.3\n'
    )
    Path("bad.toml").write_text(bad + "tip_thickness_wanted = 0.1\n")
    code, _, told = cli("check", "bad.toml")
    assert code == 2
    for text in (
        "plates cannot span the teeth of a ring",
        "a ring is not undercut by a rack",
        "a cutter of 57 teeth does not fit into a ring of 57",
        "no tool has this rack",
        "tip_thickness_wanted = 0.1 is below tip_thickness_min = 0.3",
    ):
        assert text in told
    Path("bad.toml").write_text('[wheel]\nteeth = 20\nmodule = "2 mm"\ncutter = { teeth = 12 }\n')
    assert "cutter is of no use" in cli("check", "bad.toml").err
