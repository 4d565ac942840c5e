"""Motions in time of whole projects and of put together drives: invariants, and what the stage refuses or says."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from machines import MOTOR, spec_text
from scipy.integrate import solve_ivp
from sparing import sparing

from machine.transient.scenes import constant, cycle, kloss, upsetter
from tmmcalc.api import run
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.facts.transient import summary as transient_summary
from tmmcalc.machine.model import DriveShaft, TransientTask
from tmmcalc.machine.motors.gearing import reduced
from tmmcalc.machine.stages import transient
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Shaft
from tmmcalc.machine.transient.scenario import LoadStep, Scenario
from tmmcalc.machine.transient.solve import Machine, solve_transients
from tmmcalc.machine.transient.timed import TimedMotion
from tmmcalc.project import parse_spec

RATIO, EFFICIENCY, ROTOR = 8.0, 0.9, 0.02
FAST = kloss(242.0 / RATIO / EFFICIENCY, 0.2773, 10.714 * RATIO, 10.0 * RATIO)
STEPS = (LoadStep(0.0), LoadStep(1.0, speed=10.0, quiet=True))


def machine(stiffness: float | None, damping: float = 0.0, lag: float = 0.0) -> Machine:
    """The upsetter with a motor behind lossy gears: one mass, or rotor and crank on a shaft."""
    shafts = () if stiffness is None else (DriveShaft("shaft", Shaft(stiffness, damping, ratio=RATIO), 0.0),)
    return Machine(
        upsetter(1.0),
        upsetter(0.0),
        ConstantInertia(rotor=ROTOR * RATIO**2, further=29.0),
        reduced(FAST, 1.0, EFFICIENCY),
        reduced(FAST, RATIO, EFFICIENCY),
        lag,
        RATIO,
        shafts,
    )


def solved(drive: Machine, scenario: Scenario, *, steady: bool = False) -> TimedMotion:
    (motion,) = solve_transients(drive, [TransientTask(scenario, Method(), steady)], 10.0).motions
    return motion


@pytest.mark.slow
@sparing("lag", [0.0, 0.02], every=2)
def test_a_stiff_chain_is_one_mass(lag: float) -> None:
    """Efficiency and inertias are the same on either way; what is left goes with 1/c."""
    scenario = Scenario("start", 6.0, load=STEPS, end_angle=12.0)
    one = solved(machine(None, lag=lag), scenario)
    gaps = []
    for stiffness in (1e6, 1e7, 1e8):
        chain = solved(machine(stiffness, stiffness * 1e-3, lag), scenario)
        assert chain.rigid == ()
        assert chain.end == one.end == "angle"
        gaps.append(abs(float(chain.t[-1] / one.t[-1]) - 1) + abs(float(chain.omega[-1, -1] / one.omega[0, -1]) - 1))
    assert gaps[2] < 1e-6
    assert gaps[2] < gaps[1] / 5 < gaps[0] / 25


@sparing("lag", [0.0, 0.002, 0.05], every=3)
def test_a_motion_begun_in_the_steady_one_repeats_it(lag: float) -> None:
    motion = solved(machine(None, lag=lag), Scenario("on", 600.0, settled=True, until_steady=True), steady=True)
    assert motion.end == "steady"
    (steady,) = [event for event in motion.events if event.kind == "steady"]
    assert steady.angle == pytest.approx(4 * math.pi, abs=1e-12)  # the second cycle shows it
    assert steady.speed == pytest.approx(float(motion.omega[0, 0]), rel=1e-7)
    turned = solved(machine(None, lag=lag), Scenario("on", 9.0, settled=True, end_angle=2 * math.pi), steady=True)
    assert turned.omega[0, -1] == pytest.approx(float(turned.omega[0, 0]), rel=1e-7)
    assert turned.motor_moment[-1] == pytest.approx(float(turned.motor_moment[0]), rel=1e-5)


def test_the_dynamic_factor_of_a_sudden_moment_is_two() -> None:
    """40 (1 - cos(w t)) of an undamped shaft against the 40 N*m of a rigid one."""
    shaft = DriveShaft("s", Shaft(2e4), 2.0)
    drive = Machine(cycle(0.0), None, ConstantInertia(rotor=0.5), constant(50.0), None, 0.0, 1.0, (shaft,))
    (motion,) = solve_transients(drive, [TransientTask(Scenario("twist", 0.3), Method(), False)], 1.0).motions
    assert motion.rigid_moment == pytest.approx((40.0,), rel=1e-12)
    fact = next(f for f in transient_summary_facts(motion) if f.label.startswith("shaft"))
    assert fact.values["M_1_2_dynamic_factor"] == pytest.approx(2.0, rel=1e-2)
    assert solved(machine(None), Scenario("start", 0.1)).rigid_moment == ()


def transient_summary_facts(motion: TimedMotion) -> Any:
    from tmmcalc.machine.transient.timed import TimedMotions

    return transient_summary(TimedMotions((motion,)), "t").facts


def test_the_rms_moment_stands_against_the_rated_one() -> None:
    motion = solved(machine(None), Scenario("start", 1.0, load=(LoadStep(0.0),)))
    fact = next(f for f in transient_summary_facts(motion) if f.label == "moment of the motor")
    rated = EFFICIENCY * RATIO * FAST.moment(10.0 * RATIO)
    assert fact.values["M_motor_rated[N*m]"] == pytest.approx(rated)
    ratio = fact.values["M_motor_rms[N*m]"] / rated
    assert fact.values["M_motor_rms_over_rated"] == pytest.approx(ratio)
    assert ("heating" in " ".join(map(str, motion.verdicts))) == (ratio > 1)
    assert f"{'exceeds' if ratio > 1 else 'does not exceed'} it" in fact.text


TRANSIENT = '[[transients]]\nname = "start"\nduration = "0.2 s"\nload = {load}\n{more}'


def whole(motor: str = MOTOR, more: str = "", load: float = 0.0) -> str:
    return spec_text(motor=motor, more=TRANSIENT.format(load=load, more=more))


@pytest.mark.parametrize("begin", ["", 'from = "steady"\n'])
def test_a_positional_drive_leaves_the_motor_in(begin: str) -> None:
    """The same motion with and without the key, and a note that says so."""
    plain, positional = whole(more=begin, load=1.0), whole(more=begin, load=1.0) + '[motion]\ndrive = "positional"\n'
    (one,) = run(parse_spec(plain), target="transient").results["transient"].motions
    (other,) = run(parse_spec(positional), target="transient").results["transient"].motions
    assert np.any(one.motor_moment != 0)
    np.testing.assert_array_equal(one.omega, other.omega)
    assert not [v for v in one.verdicts if "positional" in v.message]
    assert [v.severity for v in other.verdicts if "positional" in v.message] == ["note"]


def test_a_machine_that_locks_without_its_loads_has_no_other_load_factor() -> None:
    for steps in ("load_steps = [{ factor = 0.5, time = 0.1 }]\n", ""):
        spec = parse_spec(whole(more=steps, load=1.0))
        results = run(spec, target="transient").results
        read = {**results, "reduction": replace(results["reduction"], idle=None)}
        if steps:
            with pytest.raises(NoSolutionError, match=r"load factor 0\.5 has no meaning.*locks the machine") as caught:
                transient.solve(*transient.inputs(spec), tolerance=0.0, **read)
            assert caught.value.remedy
        else:
            assert transient.solve(*transient.inputs(spec), tolerance=0.0, **read).motions[0].t[-1] > 0


def test_without_a_duration_the_run_ends_steady() -> None:
    text = whole(motor=MOTOR + 'characteristic = "kloss"\n').replace('duration = "0.2 s"\n', "")
    result = run(parse_spec(text))
    (motion,) = result.results["transient"].motions
    assert motion.end == "steady"
    assert 0 < motion.t[-1] < 100
    late = motion.turning[1] > motion.theta[0, -1] - 2 * math.pi
    assert np.ptp(motion.turning[2, late]) < 0.05 * motion.omega[0, -1]


@pytest.mark.slow
def test_a_crank_turned_back_against_another_integration() -> None:
    """The slider's weight swings a crank with friction: forwards by one cycle, backwards by the other one."""
    more = 'motor = "off"\nstandstill = "pass"\nstart_speed = "0.9 rad/s"\nstart_angle = "20 deg"\n'
    text = whole(more=more).replace('duration = "0.2 s"', 'duration = "20 s"').replace("[project]", "[project]", 1)
    spec = parse_spec(text.replace("[mechanism.grid]", '[mechanism]\ngravity = "9.81 m/s^2"\n[mechanism.grid]', 1))
    result = run(spec, target="transient")
    (motion,) = result.results["transient"].motions
    reduction = result.results["reduction"]
    given = transient.inputs(spec)
    forward, (_, back) = reduction.idle, transient.back_of(given[-1], reduction)
    total = float(motion.kinetic[0] / motion.omega[0, 0] ** 2 * 2) - float(
        forward.panels.at(forward.inertia, motion.theta[0, :1])[0]
    )

    def f(way: Any) -> Any:
        def rate(_: float, y: np.ndarray) -> list[float]:
            j, d, m = (
                float(way.panels.at(v, np.array([y[0] % (2 * math.pi)]))[0])
                for v in (way.inertia, way.slope, way.moment)
            )
            return [y[1], (m - d * y[1] ** 2 / 2) / (j + total)]

        return rate

    turns = [event for event in motion.events if event.kind in ("reversal", "standstill")]
    assert turns
    y, t, sign = np.array([motion.theta[0, 0], motion.omega[0, 0]]), 0.0, 1.0
    for event in turns[:3]:
        y[1] = y[1] or sign * 1e-13

        def rest(_: float, state: np.ndarray) -> float:
            return float(state[1])

        rest.terminal, rest.direction = True, -sign
        piece = solve_ivp(
            f(forward if sign > 0 else back), (t, 30.0), y, events=rest, rtol=1e-10, atol=1e-12, max_step=0.1
        )
        t, y, sign = float(piece.t[-1]), np.array([piece.y[0, -1], 0.0]), -sign
        assert event.time == pytest.approx(t, abs=1e-6)
        assert event.angle == pytest.approx(float(y[0]), abs=1e-7)
