"""A machine that takes inertia and ratio of its best gear train: as one with the same numbers written by hand."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from gears.stages.trains import STEEL
from machines import MOTOR, spec_text
from sparing import sparing
from stages.test_laziness import imported, within

import tmmcalc
from tmmcalc.core.plan import plan
from tmmcalc.machine.facts.motion import summary as motion_summary
from tmmcalc.machine.facts.power import summary as power_summary
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run

TRAIN = f"""
[train]
layout = ["AIbar", "AI"]
ratio = "16.1"
module_ratios = [[1, 1]]
sum_max = 120
[strength]
{STEEL}
"""
# a machine whose motor feels the train: heavy teeth under a hundred times the torque
HEAVY = TRAIN.replace("[strength]", '[strength]\ntorque = "700 N*m"')
NO_EFFICIENCY = ("efficiency = 1.0\n", "")
NO_INERTIA = ("inertia = 0.4\n", "")
ASYNCHRONOUS = MOTOR.replace("[motor]", '[motor]\ncharacteristic = "kloss"')
START = '[[transients]]\nname = "start"\nduration = "0.3 s"\nload = 0\n'


def machine(more: str, transmission: str = "", motor: str = ASYNCHRONOUS) -> RunResult:
    text = spec_text(motor=motor, more=more).replace(NO_INERTIA[0], transmission)
    return run(tmmcalc.parse_spec(text))


@pytest.fixture(scope="module")
def geared() -> RunResult:
    return machine(HEAVY + START)


def by_hand(geared: RunResult) -> str:
    best = geared.results["criteria"].winner
    return f"inertia = {best.inertia!r}\nratio = {abs(float(best.ratio))!r}\n"


def test_the_same_motion_as_with_the_numbers_written_by_hand(geared: RunResult) -> None:
    plain = machine(START, by_hand(geared))
    assert "criteria" not in plain.outcomes
    one, other = (found.results["motion"] for found in (geared, plain))
    assert one.inertia.gears == geared.results["criteria"].winner.inertia > 0.3
    np.testing.assert_allclose(one.omega, other.omega, rtol=1e-12)
    np.testing.assert_allclose(one.driving, other.driving, rtol=1e-12, atol=1e-12 * np.abs(other.driving).max())
    assert one.regime.delta == pytest.approx(other.regime.delta, rel=1e-12)
    assert geared.results["power"].duty.ratio == plain.results["power"].duty.ratio
    wheels = [found.results["flywheel"].addition for found in (geared, plain)]
    assert wheels[0] == pytest.approx(wheels[1], rel=1e-12)
    starts = [found.results["transient"].motions[0] for found in (geared, plain)]
    np.testing.assert_allclose(starts[0].omega, starts[1].omega, rtol=1e-12, atol=1e-12)


def test_the_train_is_felt(geared: RunResult) -> None:
    without = machine(HEAVY + START, "inertia = 0\n").results
    assert without["motion"].inertia.gears == 0.0
    assert without["flywheel"].addition > geared.results["flywheel"].addition


def test_the_efficiency_of_the_train_enters_power_motor_and_motion() -> None:
    """Energy over a cycle: what the motor gives at its shaft, times the efficiency, is what the loads take."""
    text = spec_text(motor=ASYNCHRONOUS, more=HEAVY).replace(*NO_INERTIA).replace(*NO_EFFICIENCY)
    found = run(tmmcalc.parse_spec(text), target="motion").results
    power, motion, best = found["power"], found["motion"], found["criteria"].winner
    teeth = 0.975 * 0.985  # the usual values of an external and of an internal mesh
    ratio = abs(float(best.ratio))
    assert best.values["efficiency"] == pytest.approx((1 + teeth * (ratio - 1)) / ratio, rel=1e-12)
    assert power.line.efficiency == best.values["efficiency"]
    assert power.motor_power == pytest.approx(power.mean_power / best.values["efficiency"], rel=1e-14)
    assert f"of gear train {best.name}" in "\n".join(fact.text for fact in power_summary(power, "power").facts)
    regime, side = motion.regime, motion.motor
    eta, given, taken = best.values["efficiency"], np.maximum(regime.driving, 0), np.minimum(regime.driving, 0)
    works = [float(regime.panels.total(part)) for part in (given, taken)]
    assert works[0] > 100 * -works[1] > 0
    assert side.mean_power * regime.cycle_time == pytest.approx(works[0] / eta + works[1] * eta, rel=1e-6)
    cycle = found["reduction"].cycle
    resisted = -float(cycle.panels.total(cycle.moment))
    assert sum(works) == pytest.approx(resisted, rel=1e-9)
    assert side.rated_moment == pytest.approx(power.duty.motor.nominal_moment, rel=1e-9)
    given = text.replace("[transmission]\n", "[transmission]\nefficiency = 0.5\n")
    assert run(tmmcalc.parse_spec(given), target="power").results["power"].line.efficiency == 0.5


def test_reports_say_whose_inertia_and_ratio_they_are(geared: RunResult) -> None:
    name = geared.results["criteria"].winner.name
    for summary, stage in ((motion_summary, "motion"), (power_summary, "power")):
        text = "\n".join(fact.text for fact in summary(geared.results[stage], stage).facts)
        assert f"gear train {name}" in text


def test_what_is_given_is_kept() -> None:
    given = machine(TRAIN, "inertia = 0.4\n").results
    best = given["criteria"].winner
    assert given["motion"].inertia.gears == 0.4
    assert given["motion"].inertia.train == ""
    assert given["power"].duty.ratio == abs(float(best.ratio))
    ratio = machine(TRAIN, "ratio = 15.5\n").results
    assert ratio["power"].duty.ratio == 15.5
    assert ratio["motion"].inertia.train == ratio["criteria"].winner.name


def test_a_gear_between_the_train_and_the_crank() -> None:
    """Wheel 1 turns 32.2 times as fast as the crank, so the output of the train turns twice as fast."""
    found = machine(TRAIN + "moment_ratio = 32.2\n").results
    best = found["criteria"].winner
    assert found["motion"].inertia.gears == pytest.approx(4 * best.inertia, rel=1e-14)
    assert found["power"].duty.ratio == pytest.approx(2 * abs(float(best.ratio)), rel=1e-14)


def test_the_train_is_not_waited_for_where_all_is_given() -> None:
    text = spec_text(more=TRAIN).replace(*NO_INERTIA)
    both = text.replace("[transmission]\n", "[transmission]\nratio = 16\ninertia = 0.1\n")
    every, both = both, both.replace(*NO_EFFICIENCY)
    assert "criteria" in plan(tmmcalc.parse_spec(text), "motion").running
    assert plan(tmmcalc.parse_spec(text), "motion").step("criteria").reason == "needed by power"
    assert "criteria" in plan(tmmcalc.parse_spec(both), "motion").running
    assert not {"train", "strength", "criteria"} & {*plan(tmmcalc.parse_spec(every), "motion").running}


def test_a_torque_diagram_moves_with_the_inertia_of_its_train() -> None:
    head = '[torque]\nspeed = "90 rpm"\nformula = "100*sin(theta)"\n[motion]\ndrive = "positional"\n'
    found = run(tmmcalc.parse_spec(head + HEAVY), target="motion").results
    assert found["motion"].inertia.total == found["criteria"].winner.inertia > 0
    bare = plan(tmmcalc.parse_spec(head), "motion").step("motion")
    assert not bare.runs


@pytest.mark.slow
@sparing("file", ["press.toml", "shaper.toml", "elastic-drive.toml"], every=3)
def test_a_scene_without_a_train_imports_no_gears(file: str) -> None:
    names = imported(file)
    assert not within(
        names,
        "tmmcalc.gears",
        "tmmcalc.gears.tables.tasks.sizing",
        "tmmcalc.gears.tables.criteria",
        "tmmcalc.gears.tables.strength",
    )


def test_the_shaper_through_its_train() -> None:
    """Mean power 4574 W; a train AI of U = 116*87/(22*18) loses 1 - eta_0 of what rolls: 4756 W are required."""
    text = (Path(__file__).parents[3] / "configs" / "shaper.toml").read_text(encoding="utf-8")
    text = text.replace("ratio = 27.27272727272727 ", "# ")
    found = run(
        tmmcalc.parse_spec(f'{text}\n[train]\nlayout = "AI"\n[strength]\nmodules_row = 1\n{STEEL}'), target="power"
    )
    teeth, power = found.results["criteria"].winner.teeth, found.results["power"]
    z_1, z_2, z_b, z_3 = teeth
    ratio = 1 + z_2 * z_3 / (z_1 * z_b)
    eta = (1 + 0.975 * 0.985 * (ratio - 1)) / ratio
    assert found.results["train"].variants[0].request.nominal == Fraction(1450, 55)
    assert power.motor_power == pytest.approx(power.mean_power / eta, rel=1e-12)
    assert power.mean_power == pytest.approx(4574, abs=0.5)
    assert power.motor_power == pytest.approx(4756, abs=1.5)
