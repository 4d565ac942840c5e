"""The cam stages through the pipeline: beside a machine, stored and loaded, left out where nothing asks for them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from tmmcalc import run
from tmmcalc.cams.speed import Speed
from tmmcalc.cams.task import CamTask
from tmmcalc.core.plan import plan
from tmmcalc.project import parse_spec
from tmmcalc.project.templates import folder
from tmmcalc.rooms import STAGES

CONFIGS = Path(folder())
CAM = """
[cam]
follower = "translating"
stroke = "20 mm"
rise = "80 deg"
high_dwell = "20 deg"
return_angle = "90 deg"
law = "poly4567"
start_distance = "60 mm"
roller_radius = "10 mm"
crank_angle = "{begin} deg"
step = "5 deg"
[cam.loads]
mass = {mass}
[cam.spring]
stiffness = "4 N/mm"
preload = "200 N"
"""


def machine_with_cam(begin: float = 0.0, mass: float = 2.0) -> tmmcalc.Spec:
    text = (CONFIGS / "press.toml").read_text()
    return parse_spec(text + CAM.format(begin=begin, mass=mass))


@pytest.mark.parametrize("begin", [0.0, 130.0])
def test_a_cam_on_the_crank_takes_the_speed_of_the_machine(begin: float) -> None:
    found = run(machine_with_cam(begin))
    forces, motion = found.results["cam_forces"], found.results["motion"]
    law = found.results["cam_law"]
    y, first, second = law.motion[:3]
    assert np.array_equal(y, forces.lift)
    at = np.mod(forces.positions.phi + np.radians(begin), 2 * np.pi)
    regime = motion.regime
    omega, eps = regime.panels.at(np.stack((regime.omega, regime.acceleration)), at)
    inner = np.abs(np.sin(forces.positions.phi / 2)) > 1e-6  # the seam of the turn has two sides
    assert forces.inertia[inner] == pytest.approx(
        -2.0 * (second * omega**2 + first * eps)[inner], rel=1e-9, abs=1e-9 * np.max(np.abs(forces.inertia))
    )
    assert np.ptp(omega) > 0.01 * np.mean(omega)
    assert forces.work.error < 1e-9
    assert any("stage motion" in note for note in forces.notes)


def test_inertia_gives_no_work_at_a_varying_speed() -> None:
    """m (y'' omega^2 + y' eps) y' is the slope of m omega^2 y'^2/2, which a turn brings back."""
    found = run(machine_with_cam(40.0))
    program = tmmcalc.cams.tables.tasks.cam.to_cam(machine_with_cam(40.0)).program
    regime = found.results["motion"].regime
    speed = Speed(regime.panels, regime.omega, regime.acceleration, np.radians(40.0))
    edges = np.unique(np.concatenate((program.edges, speed.edges, np.linspace(0, 2 * np.pi, 200))))
    t, w = np.polynomial.legendre.leggauss(12)
    x = (edges[:-1, None] + np.diff(edges)[:, None] * (t + 1) / 2).ravel()
    weights = (np.diff(edges)[:, None] * w / 2).ravel()
    motion = program.at(x)
    power = speed.acceleration(x, motion) * motion[1]
    assert abs(weights @ power) < 1e-9 * (weights @ np.abs(power))


def test_a_speed_of_its_own_needs_no_machine() -> None:
    spec = parse_spec(
        (CONFIGS / "press.toml").read_text()
        + CAM.format(begin=0, mass=2.0).replace("[cam]", '[cam]\nspeed = "120 rpm"')
    )
    assert "motion" not in plan(spec, "cam_forces").running
    assert "motion" in plan(machine_with_cam(), "cam_forces").running


OPTIMUM = """
[cam.guide]
stem_radius = "8 mm"
land = "10 mm"
[cam.requirements]
width = "12 mm"
contact = "600 MPa"
guide_pressure = "5 MPa"
[cam.optimum]
"""


def test_the_optimum_takes_the_speed_of_the_machine() -> None:
    text = (CONFIGS / "press.toml").read_text() + CAM.format(begin=40.0, mass=2.0) + OPTIMUM
    spec = parse_spec(text)
    assert "motion" in plan(spec, "cam_optimum").running
    assert "motion" not in plan(parse_spec(text.replace("[cam]", '[cam]\nspeed = "120 rpm"')), "cam_optimum").running
    result = tmmcalc.solve_cam_optimum(spec)
    assert any("turns with the crank" in note for note in result.notes)


@pytest.mark.parametrize(("stage", "turns"), [("cam_forces", True), ("cam_strength", True), ("cam_profile", False)])
def test_a_picture_shows_the_speed_that_the_stage_had(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, stage: str, turns: bool
) -> None:
    from importlib import import_module

    from drawing import draw_stage

    from tmmcalc.report.drawing.page import sheets

    drawn: list[CamTask] = []

    def drawing(task: CamTask, result: object) -> object:
        drawn.append(task)
        return sheets(1)[0]

    monkeypatch.setattr(
        import_module(f"tmmcalc.cams.pictures.{stage}"), f"{stage.removeprefix('cam_')}_drawing", drawing
    )
    text = (CONFIGS / "press.toml").read_text() + CAM.format(begin=40.0, mass=2.0) + OPTIMUM
    spec = parse_spec(text)
    draw_stage(stage, spec, run(spec, target=stage).results, tmp_path / "a.svg")
    assert [task.turning is not None for task in drawn] == [turns]


def test_every_stage_of_a_cam_has_its_public_function() -> None:
    stages = [stage.name for stage in STAGES.values() if stage.name.startswith("cam_")]
    assert len(stages) == 9
    for stage in stages:
        assert f"solve_{stage}" in tmmcalc.__all__
    spec = tmmcalc.load_spec(CONFIGS / "cam-translating.toml")
    found = tmmcalc.solve_cam_elastic(spec)
    assert found.frequency == pytest.approx(np.sqrt(2e6 / 0.2))
    assert found.phases == run(spec, target="cam_elastic").results["cam_elastic"].phases


def test_stored_results_are_the_computed_ones(tmp_path: Path) -> None:
    spec = tmmcalc.load_spec(CONFIGS / "cam-translating.toml")
    first, second = run(spec, out=tmp_path), run(spec, out=tmp_path)
    assert {step.kind for step in second.events if step.stage.startswith("cam_")} <= {"loaded", "left out"}
    one, two = first.results["cam_forces"], second.results["cam_forces"]
    assert np.array_equal(one.contact, two.contact)
    assert one.extremes == two.extremes
    assert first.results["cam_optimum"].least == second.results["cam_optimum"].least


def test_what_the_cam_does_not_ask_for_is_left_out() -> None:
    bare = parse_spec(
        '[cam]\nfollower = "flat"\nstroke = "10 mm"\nrise = "90 deg"\nreturn_angle = "90 deg"\nlaw = "sine"'
    )
    planned = plan(bare)
    assert set(planned.running) == {"cam_law", "cam_synthesis", "cam_profile", "cam_pressure"}
    assert "[cam.loads]" in planned.step("cam_forces").reason
    for stage in ("cam_strength", "cam_optimum", "cam_elastic"):
        assert "[cam" in planned.step(stage).reason
    steps = plan(tmmcalc.load_spec(CONFIGS / "shaper.toml")).steps
    assert all("no [cam]" in step.reason for step in steps if step.stage.startswith("cam_"))
