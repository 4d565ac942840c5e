"""Documents, commands and pictures of the cam's forces and requirements."""

import json
from math import radians

import pytest
from sparing import sparing
from typer.testing import CliRunner

from tmmcalc.cams.facts.cam_forces import document as forces_document
from tmmcalc.cams.facts.cam_forces import summary as forces_summary
from tmmcalc.cams.facts.cam_strength import document as strength_document
from tmmcalc.cams.facts.cam_strength import summary as strength_summary
from tmmcalc.cams.facts.cam_strength import turn_document
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.program import TURN, Phase, Program
from tmmcalc.cams.strength.solve import solve_strength
from tmmcalc.cams.task import AngleLimits, Asked, CamTask, Guide, Loads, Requirements, Spring
from tmmcalc.cli.app import app
from tmmcalc.report.render import render

SPEC = """
[cam]
follower = "translating"
stroke = "20 mm"
speed = 100
rise = "80 deg"
high_dwell = "20 deg"
return_angle = "90 deg"
rise_law = "cosine"
return_law = "shun"
start_distance = "50 mm"
offset = "5 mm"
roller_radius = "8 mm"
step = "10 deg"
[cam.loads]
mass = 0.2
friction = 0.1
[cam.spring]
safety = 1.5
[cam.guide]
top = "125 mm"
stem_radius = "4 mm"
land = "5 mm"
[cam.requirements]
width = "8 mm"
contact = "300 MPa"
span = "100 mm"
bending = "100 MPa"
"""
NEEDS = Requirements(width=0.008, contact=4e8, rolling_arm=5e-5, roller_friction=0.1, pin=0.002, span=0.1, bending=1e8)


def cams():
    angles = [radians(each) for each in (80, 20, 90)]
    stories = (
        ("translating", 0.02, Follower("translating", 0.05, 0.005, 0.008), 0.2, "groove", Spring("none")),
        ("flat", 0.01, Follower("flat", 0.05), 0.2, "force", Spring()),
        ("oscillating", 0.4, Follower("oscillating", 0.6, 0.0, 0.008, 0.1, 0.08), 1e-4, "force", Spring()),
    )
    for kind, stroke, follower, mass, closure, spring in stories:
        phases = (
            Phase("rise", angles[0], 0.0, stroke, LAWS["sine"]),
            Phase("high dwell", angles[1], stroke, stroke),
            Phase("return", angles[2], stroke, 0.0, LAWS["shun"]),
            Phase("low dwell", TURN - sum(angles), 0.0, 0.0),
        )
        loads = Loads(100.0, mass, spring=spring, friction=0.1, pivot_friction=0.1, pivot_radius=0.005)
        guide = Guide(length=0.05, stem=0.004, land=0.005)
        asked = Asked(kind, closure=closure)
        yield (
            CamTask(Program(phases), asked, AngleLimits(1.0, None), loads=loads, guide=guide, requirements=NEEDS),
            follower,
        )


@pytest.mark.parametrize(("task", "follower"), list(cams()), ids=["groove", "flat", "rocker"])
def test_documents_in_all_formats(task, follower, capsys):
    forces, strength = solve_forces(task, follower), solve_strength(task, follower)
    documents = [
        forces_document(forces, "F"), forces_document(forces, "F", everything=True), forces_summary(forces, "F"),
        strength_document(strength, "S"), strength_document(strength, "S", everything=True),
        strength_summary(strength, "S"), turn_document(strength, "T"), turn_document(strength, "T", everything=True),
    ]  # fmt: skip
    for document in documents:
        for form in ("table", "csv", "json", "toml"):
            render(document, form)
            out = capsys.readouterr().out
            assert out
            assert "nan" not in out.lower().replace("nance", "")
            assert "inf" not in out.lower()


def run(tmp_path, *words, spec=SPEC):
    file = tmp_path / "cam.toml"
    file.write_text(spec)
    return CliRunner().invoke(app, ["cam", words[0], str(file), "-o", str(tmp_path / "out"), *words[1:]])


def test_forces_command(tmp_path):
    result = run(tmp_path, "forces", "--columns", "phi,R,N1", "--positions", "0:3")
    assert result.exit_code == 0, result.output
    assert "5.0625 N/mm" in result.output
    values = json.loads(run(tmp_path, "forces", "-f", "json").stdout)
    assert values["c[N/m]"] == pytest.approx(5062.5)
    assert values["R_max[N]"] == pytest.approx(163.2143, rel=1e-4)
    assert len(values["columns"]["R[N]"]) == 38
    assert (tmp_path / "out" / "cam_forces.csv").read_text().startswith("i,phi[deg],dS[m],P_in[N]")


def test_strength_command(tmp_path):
    result = run(tmp_path, "strength")
    assert result.exit_code == 0, result.output
    assert "exceeded" in result.output
    assert run(tmp_path, "strength", "--strict").exception.exit_code == 5
    values = json.loads(run(tmp_path, "strength", "-f", "json").stdout)
    margins = {each["requirement"]: each for each in values["margins"]}
    assert margins["contact stress"]["verdict"] == "exceeded"
    assert margins["contact stress"]["value[Pa]"] == pytest.approx(307.4149e6, rel=1e-4)
    assert margins["no slip"]["verdict"] == "not judged"
    turn = run(tmp_path, "strength", "--turn", "-f", "csv")
    assert turn.stdout.splitlines()[0].startswith("i,phi[deg],kappa[1/m]")
    assert run(tmp_path, "strength", "-f", "csv").stdout == turn.stdout


def test_jamming_ends_with_its_code(tmp_path):
    steep = SPEC.replace('"50 mm"', '"8 mm"').replace("friction = 0.1", "friction = 0.5")
    result = run(tmp_path, "forces", spec=steep)
    assert result.exception.exit_code == 3
    assert "jams for phi from" in str(result.exception)


@sparing(("task", "follower"), list(cams()), ids=["groove", "flat", "rocker"], every=3, first=1)
def test_pictures(task, follower, tmp_path):
    from drawing import draw_cam

    for name, result in (
        ("cam_forces", solve_forces(task, follower)),
        ("cam_strength", solve_strength(task, follower)),
    ):
        file = tmp_path / f"{name}.svg"
        draw_cam(name, task, result, file)
        first = file.read_bytes()
        assert first.startswith(b"<?xml")
        draw_cam(name, task, result, file)
        assert file.read_bytes() == first
