"""Ready specs through all stages: one number each that is known from elsewhere, and what a scene leaves out."""

from __future__ import annotations

import json
import math
from importlib import import_module
from inspect import Parameter, signature
from pathlib import Path
from types import FunctionType, NoneType

import numpy as np
import pytest
from sparing import sparing

import tmmcalc
from tmmcalc.core.plan import plan
from tmmcalc.core.stage import resolve
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.project import templates
from tmmcalc.rooms import STAGES

from .independent import project

CONFIGS = Path(templates.folder())
CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases" / "dynamics.json").read_text())}
PROJECTS = ["shaper", "press", "four-stroke-engine", "piston-compressor", "piston-pump", "geared-pump", "elastic-drive"]


def done(name: str) -> RunResult:
    """A run of a ready spec, the same for all tests of this process."""
    return project(name).run


READY = [name for name in templates.names() if "/" not in name]


@sparing("name", READY, every=12, first=2)
def test_every_ready_spec_runs(name: str) -> None:
    result = done(name)
    assert result.outcomes
    assert result.outcomes.keys() == set(result.plan.running)


@sparing("name", PROJECTS, every=3, first=1)
def test_all_numbers_are_finite(name: str) -> None:
    for stage in done(name).outcomes:
        for key, array in done(name).record(stage).arrays.items():
            assert array.dtype.kind in "US" or np.isfinite(array).all(), f"{stage}.{key}"
        table = done(name).table(stage)
        for column in table.columns if table is not None else ():
            assert column.dtype.kind in "US" or np.isfinite(column).all()


def test_shaper_work_of_the_cutting_force() -> None:
    """The textbook's appendix: 7500 N over positions 2 to 12."""
    reduction = done("shaper").results["reduction"]
    (cutting,) = (c for c in reduction.contributions if c.name == "Q5")
    assert cutting.work == pytest.approx(CASES["dyn-shaper-reduced"]["expected"]["A_Q_exact_J"], rel=1e-4)
    expected = CASES["dyn-shaper-reduced"]["expected"]["M_Q_Nm"]
    assert reduction.moment[1] == pytest.approx(np.array(expected), abs=0.02)


def test_shaper_motor_by_its_parabola() -> None:
    expected = CASES["dyn-shaper-motion-idle"]["expected"]
    textbook = done("shaper").results["motion"].textbook
    assert textbook.a == pytest.approx(expected["A"], rel=1e-6)
    assert textbook.b == pytest.approx(expected["B"], rel=1e-6)


def test_press_forces_and_efficiency() -> None:
    expected = CASES["dyn-press-friction"]["expected"]
    forces = done("press").results["forces"]
    # at 270 degrees the rod is at rest and the friction of its pins jumps: the case takes the limit before, as the book
    rows = [forces.labels.index("9-" if i == 9 else str(i)) for i in range(13)]
    assert forces.drive[rows] == pytest.approx(np.array(expected["M_bal"]), rel=1e-5)
    power = done("press").results["power"]
    assert power.efficiency == pytest.approx(CASES["dyn-press-reduced"]["expected"]["eta_fine"], abs=1e-4)


def test_flywheel_keeps_what_it_was_made_for() -> None:
    for name in ("press", "four-stroke-engine", "piston-compressor", "piston-pump"):
        flywheel, motion = (done(name).results[stage] for stage in ("flywheel", "motion"))
        assert motion.regime.delta == pytest.approx(flywheel.delta, rel=1e-7)


def test_four_stroke_work_is_the_area_of_the_indicator_diagram() -> None:
    """The work of the gas is the integral of p dV, taken here from the tables of the spec alone."""
    spec = tmmcalc.load_spec(CONFIGS / "four-stroke-engine.toml")
    indicator = spec.loads[0].indicator
    stroke, area = 2 * 0.055, math.pi / 4 * 0.095**2
    work = sum(float(np.trapezoid(np.array(s.p), np.array(s.x))) for s in indicator.strokes) * stroke * area
    contributions = done("four-stroke-engine").results["reduction"].contributions
    (gas,) = (c.work for c in contributions if c.name == "gas")
    assert gas == pytest.approx(work, rel=1e-12)
    assert done("four-stroke-engine").results["reduction"].cycle.period == pytest.approx(4 * math.pi)


def test_pump_work_is_force_times_stroke() -> None:
    work = {c.name: c.work for c in done("piston-pump").results["reduction"].contributions}
    assert work["delivery"] == pytest.approx(-8000 * 0.15, rel=1e-12)
    assert work["suction"] == pytest.approx(-600 * 0.15, rel=1e-12)


@pytest.mark.slow
def test_elastic_drive_starts_and_stops() -> None:
    motions = done("elastic-drive").results["transient"].motions
    ends = {motion.name: motion.end for motion in motions}
    assert ends["start-up"] == "time"
    assert ends["emergency stop"] == "standstill"
    assert max(motion.imbalance for motion in motions) < 1e-6


def test_torque_diagram_without_a_mechanism() -> None:
    """Excess M sin(theta): J_F = 2 M / (delta omega^2)."""
    case = CASES["dyn-flywheel-sine"]
    text = '[torque]\nspeed = "20 rad/s"\nformula = "100*sin(theta)"\n[flywheel]\ndelta = 0.02\n'
    result = run(tmmcalc.parse_spec(text))
    assert result.results["flywheel"].addition == pytest.approx(case["expected"]["J_F"], rel=1e-12)
    assert "kinematics" not in result.outcomes


@sparing("name", PROJECTS, every=3, first=1)
def test_stored_and_computed_results_are_the_same(name: str, tmp_path: Path) -> None:
    spec = tmmcalc.load_spec(CONFIGS / f"{name}.toml")
    first = run(spec, out=tmp_path)
    second = run(spec, out=tmp_path)
    assert {event.kind for event in second.events} <= {"loaded", "left out"}
    for stage in first.outcomes:
        one, other = first.record(stage), second.record(stage)
        assert one.scalars == other.scalars
        assert all(np.array_equal(one.arrays[key], other.arrays[key]) for key in one.arrays)


def test_change_of_a_load_leaves_kinematics_and_balance_alone(tmp_path: Path) -> None:
    file = CONFIGS / "press.toml"
    run(tmmcalc.load_spec(file), out=tmp_path)
    changed = tmmcalc.load_spec(file, ["loads[name=Q3].factor=0.5"])
    kinds = {event.stage: event.kind for event in run(changed, out=tmp_path).events}
    assert kinds["kinematics"] == kinds["balance"] == "loaded"
    assert kinds["forces"] == kinds["reduction"] == kinds["flywheel"] == "computed"


def test_plan_says_why_stages_are_left_out() -> None:
    reasons = {step.stage: step.reason for step in plan(tmmcalc.load_spec(CONFIGS / "crank-slider.toml")).steps}
    assert "no loads, masses or springs" in reasons["forces"]
    assert "[flywheel]" in reasons["flywheel"]
    assert "[[transients]]" in reasons["transient"]


def test_a_driven_slider_is_the_reason_for_all_that_needs_a_cycle() -> None:
    reasons = {step.stage: step.reason for step in plan(tmmcalc.load_spec(CONFIGS / "hydraulic-lift.toml")).steps}
    for stage in ("power", "flywheel", "motion"):
        assert "driven slider" in reasons[stage]


def test_a_load_factor_without_loads_changes_nothing() -> None:
    """Weights, springs and friction are no technological load: with nothing to switch off all factors are the same."""
    text = (CONFIGS / "press.toml").read_text()
    before, after = text.split("[[loads]]")
    bare = before + "[motion]" + after.split("[motion]", 1)[1].replace('drive = "positional"', 'drive = "motor"')
    motor = '[motor]\npower = "1.1 kW"\nspeed = "1400 rpm"\nsynchronous_speed = "1500 rpm"\noverload = 2.2\n'
    transient = '[[transients]]\nduration = "0.3 s"\nstart_speed = "5 rad/s"\nload = {}\n'
    motions = []
    for factor in (0, 0.5, 1):
        spec = tmmcalc.parse_spec(bare + motor + "inertia = 0.01\n" + transient.format(factor))
        (motion,) = run(spec, target="transient").results["transient"].motions
        motions.append(motion)
    assert np.ptp(motions[0].omega) > 0.01
    for other in motions[1:]:
        np.testing.assert_array_equal(other.omega, motions[0].omega)


@pytest.mark.parametrize(("table", "ratio"), [('shaft = "motor"', 5.0), ("ratio = 5", 5.0), ("", 1.0)])
def test_a_flywheel_on_the_shaft_of_a_motor_that_is_not_given(table: str, ratio: float) -> None:
    """The gears alone tell how fast its shaft turns; what it weighs on the crank is J_F = 2 M/(delta omega^2)."""
    text = '[torque]\nspeed = "20 rad/s"\nformula = "100*sin(theta)"\n[transmission]\nratio = 5\n'
    result = run(tmmcalc.parse_spec(f"{text}[flywheel]\ndelta = 0.02\n{table}\n")).results["flywheel"]
    assert result.addition == pytest.approx(25, rel=1e-12)
    assert result.own == pytest.approx(25 / ratio**2, rel=1e-12)


def test_the_time_constant_by_the_formula() -> None:
    """1/(2 pi 50 Hz s_K) of the textbook's motor, as given by its data and as chosen from a catalogue."""
    text = '[torque]\nspeed = "10 rad/s"\nformula = "-100 + 20*sin(theta)"\ninertia = 30\n[motor]\n'
    given = 'power = "1.5 kW"\nspeed = "1400 rpm"\nsynchronous_speed = "1500 rpm"\noverload = 2.2\n'
    for motor in (given, 'name = "choose"\n'):
        result = run(tmmcalc.parse_spec(f'{text}{motor}time_constant = "auto"\n'))
        found = result.results["power"].duty.motor
        slip = 1 - found.speed / found.synchronous
        critical = slip * (found.overload + math.sqrt(found.overload**2 - 1))
        assert found.time_constant == pytest.approx(1 / (100 * math.pi * critical), rel=1e-12)


def test_every_stage_resolves() -> None:
    for stage in STAGES.values():
        home = import_module(stage.home)
        assert callable(home.inputs)
        solve, task = stage.part("solve"), stage.part("task")
        read = {stage.takes.get(name, name) for name in (*stage.needs, *stage.uses)}
        read |= {"another"} if stage.another else set()
        for function, given in ((task or solve, read), (solve, {*stage.settings})):
            asked = signature(function).parameters if given else {}
            assert given <= asked.keys() or any(each.kind is Parameter.VAR_KEYWORD for each in asked.values())
        assert {type(getattr(home, part, None)) for part in ("errors", "omits", "packages")} <= {FunctionType, NoneType}
        if isinstance(columns := getattr(home, "columns", None), str):
            assert callable(resolve(columns))
        assert isinstance(getattr(home, "kind", None), type) or callable(home.load)
        assert callable(resolve(f"{stage.facts}:summary"))
        for reference in (stage.wanted, stage.reads, stage.studies, stage.picture.figure if stage.picture else ""):
            if reference:
                assert callable(resolve(reference))


def test_every_worked_case_of_dynamics_is_used_by_a_test() -> None:
    """By its name in quotes, as code has it, not in prose; a case that is not verified is not asserted."""
    files = [file for file in Path(__file__).parents[1].rglob("*.py") if file != Path(__file__)]
    code = "\n".join(file.read_text(encoding="utf-8") for file in files)
    unused = {name for name, case in CASES.items() if case["verified"] and f'"{name}"' not in code}
    assert not unused
