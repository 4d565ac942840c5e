"""Constraints on the command line: what synth chooses, what gears leaves out, exit codes, the picture."""

from __future__ import annotations

import json
import shutil
import tomllib
from pathlib import Path

import pytest

import tmmcalc

from .conftest import CONFIGS, Cli


@pytest.fixture(autouse=True)
def specs(folder: Path) -> None:
    shutil.copy(CONFIGS / "feasibility.toml", folder / "f.toml")
    light = '\n[[constraints]]\nname = "light"\nstage = "criteria"\ncolumn = "mass"\nat_most = "2.5 kg"\n'
    slim = '\n[[constraints]]\nname = "slim"\nstage = "train"\ncolumn = "D"\nat_most = "500 mm"\n'
    (folder / "g.toml").write_text((CONFIGS / "gears-coaxial.toml").read_text() + light + slim)


def test_synth_takes_the_first_feasible_design(cli: Cli) -> None:
    code, out, err = cli("synth", "f.toml", "--spec", "ready.toml", "-q", "--strict", "--format", "json")
    assert (code, err) == (0, "")
    told = json.loads(out)
    assert told["solution"] == told["constraints"]["chosen"] == 2
    assert told["constraints"]["columns"]["i"] == ["2", "1"]
    assert told["constraints"]["columns"]["fails"] == ["", "calm, short"]
    ready = tmmcalc.load_spec("ready.toml")
    assert abs(ready.linkage.fixed["D"][0]) == pytest.approx(told["L[m]"], rel=1e-12)
    assert tomllib.loads(Path("f.out/feasibility.toml").read_text())["result"]["feasible"] is True


def test_a_design_that_is_asked_for_is_shown_with_what_fails(cli: Cli) -> None:
    code, out, err = cli("synth", "f.toml", "-q", "--strict", "--choose", "1")
    assert code == 5
    assert "1 of 2, crank-rocker" in out
    assert "warning: solution 1 does not keep calm, short; solution 2 is feasible" in out
    assert "constraint calm: kinematics size omega_3 is 2.820655 rad/s; asked: at most 2.5 rad/s" in err
    assert cli("synth", "f.toml", "-q", "--choose", "1").code == 0
    assert cli("synth", "f.toml", "-q", "--choose", "3").code == 2


def test_without_a_feasible_design_the_nearest_is_shown(cli: Cli) -> None:
    impossible = ("--set", 'feasibility.rule="calm"', "--set", 'constraints[1].at_most="1 rad/s"')
    code, out, err = cli("synth", "f.toml", "-q", "--strict", *impossible)
    assert code == 5
    assert "2 of 2, crank-rocker" in out
    assert "solution 2 does not keep calm; no solution is feasible, this one comes nearest" in err
    assert cli("synth", "f.toml", "-q", *impossible).code == 0


def test_feasibility_of_designs(cli: Cli) -> None:
    code, out, _ = cli("feasibility", "f.toml", "-q", "--strict")
    assert code == 0
    assert "2 of 2, crank-rocker" in out
    assert "1 of 2 designs" in out


def test_gears_are_told_what_constraints_removed(cli: Cli) -> None:
    told = json.loads(cli("gears", "synth", "g.toml", "-q", "--format", "json").out)
    assert told["removed"]["constraint slim"] == 129 - told["count"]
    assert max(told["columns"]["D[m]"]) <= 0.5
    code, out, err = cli("gears", "compare", "g.toml", "-q", "--format", "json")
    assert (code, err) == (0, "")
    told = json.loads(out)
    assert max(told["columns"]["mass[kg]"]) <= 2.5
    assert told["coaxial_with_3_layshafts"]["removed"]["light"] > 0
    code, out, err = cli("gears", "compare", "g.toml", "-q", "--set", 'constraints[0].at_most="1 kg"')
    assert (code, out) == (3, "")
    assert "no train keeps the constraints" in err
    assert "light: mass is" in err


@pytest.mark.slow
def test_pictures(cli: Cli) -> None:
    for spec, stage in (("f.toml", "feasibility"), ("f.toml", "synthesis")):
        assert cli("plot", spec, stage, "-o", f"{stage}.svg", "-q") == (0, "", "")
    assert cli("plot", "f.toml", "synthesis", "-o", "two.svg", "-q", "--choose", "2").code == 0
    assert Path("two.svg").read_bytes() == Path("synthesis.svg").read_bytes()
    code, out, err = cli("plot", "my.toml", "feasibility", "-q")
    assert (code, out) == (2, "")
    assert "no [[constraints]]: nothing is to be kept" in err


def test_a_stage_that_the_scene_leaves_out_is_told_before_anything_runs(cli: Cli) -> None:
    none = '[[constraints]]\nname = "safe"\nstage = "pair"\nvalue = "eps_alpha"\nat_least = 1.2\n'
    Path("p.toml").write_text((CONFIGS / "piston-compressor.toml").read_text() + none)
    code, _, err = cli("run", "p.toml")
    assert code == 2
    assert "constraints, safe: this scene has no pair" in err
    assert "no [pair]: no pair of gears is asked for" in err
    assert not Path("p.out").exists()


@pytest.mark.slow
def test_the_error_of_two_stages_is_told_once(cli: Cli) -> None:
    """Forces and reduction read the same load, which fits no linkage of this synthesis."""
    gas = (CONFIGS / "piston-compressor.toml").read_text().partition("[[loads]]")[2].partition("[motor]")[0]
    Path("l.toml").write_text((CONFIGS / "synth-dwell-rocker.toml").read_text() + "[[loads]]" + gas)
    code, _, err = cli("run", "l.toml", "--no-store", "-q")
    assert code == 3
    assert err.count("the point of the load reverses") == 1
