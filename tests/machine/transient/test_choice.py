"""The automatic choice, what a run loads, and its refusals."""

from __future__ import annotations

import math
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from sparing import sparing

from machine.transient.scenes import Motor, constant, cycle, event, kloss, line, run, upsetter, upsetter_drive
from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.scenario import Brake, LoadStep, Scenario

MOTOR = kloss(242.0, 0.2773, 10.714, 10.0)


def test_an_ordinary_run_up_does_not_load_scipy() -> None:
    program = (
        "import sys; sys.path.insert(0, 'tests');"
        "from machine.transient.scenes import *;"
        "r = run(upsetter_drive(kloss(242.0, 0.2773, 10.714, 10.0), 30.6), Scenario('start', 3.0));"
        "assert r.method == 'merson', r.reason;"
        "print('scipy' in sys.modules, 'pydantic' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "False"]


CHOICES = [
    ("one mass", upsetter_drive(MOTOR, 30.6), "merson", "not stiff"),
    ("light mass", upsetter_drive(MOTOR, 0.002), "collocation", "stiff, stability alone"),
    ("slow lag", replace(upsetter_drive(MOTOR, 30.6), time_constant=0.05), "merson", "not stiff"),
    ("quick lag", replace(upsetter_drive(MOTOR, 30.6), time_constant=1e-5), "collocation", "time constant 1e-05 s"),
    ("soft shaft", Drive((Mass(1.0), Mass(1.0)), (Shaft(100.0),), constant(1.0)), "merson", "not stiff"),
    ("shaft that swings", Drive((Mass(1.0), Mass(1.0)), (Shaft(1e5),), constant(1.0)), "collocation", "periods"),
    ("little damped", Drive((Mass(1.0), Mass(1.0)), (Shaft(1e9, 2e3),), constant(1.0)), "collocation", "stiff"),
    ("damped shaft", Drive((Mass(1.0), Mass(1.0)), (Shaft(1e6, 1e4),), constant(1.0)), "collocation", "stiff"),
]


@sparing(("name", "drive", "method", "reason"), CHOICES, ids=[c[0] for c in CHOICES], every=3)
def test_the_method_that_is_chosen(name: str, drive: Drive, method: str, reason: str) -> None:
    result = run(drive, Scenario("start", 0.5, load=(LoadStep(0.0),)))
    assert result.method == method
    assert reason in result.reason
    assert result.imbalance < 1e-7


def test_a_method_that_is_asked_for_is_taken() -> None:
    result = run(upsetter_drive(MOTOR, 30.6), Scenario("start", 0.2), "Radau")
    assert (result.method, result.reason) == ("Radau", "asked for")


def test_only_the_stiffest_shaft_becomes_rigid() -> None:
    masses, soft, stiff = (Mass(1.0), Mass(1.0), Mass(1.0)), Shaft(1e3, 1.0), Shaft(1e11)
    result = run(Drive(masses, (soft, stiff), constant(10.0)), Scenario("start", 1.0))
    assert result.rigid == (1,)
    np.testing.assert_allclose(result.omega[1], result.omega[2], rtol=1e-15)
    assert np.ptp(result.omega[0] - result.omega[1]) > 0.01
    np.testing.assert_allclose(result.shaft_moment[1], result.alpha[2], atol=1e-9)
    assert "shaft 2 is taken as rigid" in str(result.verdicts[0])


def test_a_stiff_shaft_that_is_damped_stays_elastic() -> None:
    """The softer shaft swings on and on; the stiffer one does not, and needs not be rigid."""
    masses = (Mass(1.0), Mass(1.0), Mass(1.0))
    result = run(Drive(masses, (Shaft(1e11, 2e5), Shaft(1e9)), constant(10.0)), Scenario("start", 1.0))
    assert result.rigid == (1,)
    assert result.method == "collocation"
    np.testing.assert_allclose(result.omega[0], 10 / 3 * result.t, rtol=1e-6, atol=1e-4)
    assert result.shaft_moment[0, -1] == pytest.approx(20 / 3, rel=1e-6)


def test_an_explicit_method_on_a_stiff_drive_gives_up_by_name() -> None:
    drive = Drive((Mass(0.5), Mass(2.0)), (Shaft(1e12),), constant(50.0))
    for method in ("merson", "DOP853"):
        with pytest.raises(AccuracyError, match="20000 evaluations took the motion only to t ="):
            run(drive, Scenario("start", 0.5), method, budget=20_000)


def test_fixed_steps_beyond_stability_are_an_error_and_no_numbers() -> None:
    drive = Drive((Mass(0.01),), characteristic=line(50.0, 10.0))
    for method in ("merson", "rk4"):
        with pytest.raises(AccuracyError, match=r"steps of 0.02 s are unstable: .* 0.0002 s"):
            run(drive, Scenario("start", 20.0), method, step=0.02)


def test_fixed_steps_that_blow_up_are_an_error() -> None:
    """A load that grows with the cube of the speed where no eigenvalue of the start tells it."""
    motor = Motor(lambda w: w**3, lambda w: 3 * w * w)
    with pytest.raises(AccuracyError, match=r"grew beyond all bounds at t = .* steps of 0.01 s"):
        run(Drive((Mass(1.0),), characteristic=motor), Scenario("runaway", 2.0, speed=1.0), "merson", step=0.01)


def test_coarse_fixed_steps_are_warned_of() -> None:
    result = run(upsetter_drive(MOTOR, 30.6), Scenario("loaded", 1.0, speed=10.7), "rk4", step=0.2)
    assert any("energy and work differ" in str(verdict) for verdict in result.verdicts)
    assert result.error > 1e-5


def test_an_equilibrium_on_a_jump_is_named() -> None:
    """Both sides drive the crank at rest to the jump: no motion is defined there."""
    drive = Drive((Mass(1.0),), cycle=cycle(lambda p: np.where(p < 2.0, 5.0, -5.0), 0.0, (2.0,)))
    with pytest.raises(NoSolutionError, match=r"at rest at 114.592 deg on a jump .* with 5 and -5 N\*m"):
        run(drive, Scenario("rest", 1.0, angle=2.0, standstill="pass"))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Mass(-1.0), "inertia of a mass is -1"),
        (lambda: Mass(math.nan), "inertia of a mass is nan"),
        (lambda: Shaft(-5.0), "stiffness of a shaft is -5"),
        (lambda: Shaft(1e3, -1.0), "damping of a shaft is -1"),
        (lambda: Shaft(1e3, ratio=0.0), "gear ratio of a shaft is 0"),
        (lambda: Shaft(0.0), "carries no moment"),
        (lambda: Drive((Mass(1.0), Mass(1.0))), "2 masses are joined by 1 shafts, not 0"),
        (lambda: Drive((Mass(0.0), Mass(1.0)), (Shaft(1e3),)), "before the crank has no inertia"),
        (lambda: Drive((Mass(1.0),), time_constant=-1.0), "electromagnetic time constant is -1"),
        (lambda: LoadStep(1.0, time=1.0, speed=2.0), "waits for the time 1 s and for the speed 2"),
        (lambda: Brake(-1.0), "does not brake"),
        (lambda: Scenario("x", 0.0), "duration is 0"),
        (lambda: Scenario("x", math.inf), "duration is inf"),
        (lambda: Scenario("x", 1.0, end_angle=-1.0), "end_angle is -1"),
        (lambda: Scenario("x", 1.0, motor=((2.0, 1.0),)), "motor is 2"),
        (lambda: Scenario("x", 1.0, load=()), "no load factor at the start"),
        (lambda: Scenario("x", 1.0, load=(LoadStep(1.0, time=1.0),)), "no load factor at the start"),
        (lambda: Method("euler"), "no method 'euler'"),
        (lambda: Method("rk4"), "rk4 with the step None"),
        (lambda: Method("merson", step=-0.1), "merson with the step -0.1"),
        (lambda: Method("Radau", step=0.1), "takes no step of 0.1 s"),
        (lambda: Method(tolerance=1e-16), "tolerance is 1e-16"),
        (lambda: run(Drive((Mass(0.0),)), Scenario("x", 1.0)), "the crank has no inertia"),
        (lambda: run(Drive((Mass(1.0),)), Scenario("x", 1.0, brake=Brake(1.0, mass=3))), "brake is on mass 3"),
    ],
)
def test_refusals(make: object, message: str) -> None:
    with pytest.raises(UsageError) as caught:
        make()
    assert message in str(caught.value)
    assert caught.value.remedy


def test_pull_out_and_overload_are_noted_once_with_their_depth() -> None:
    result = run(upsetter_drive(MOTOR, 3.0), Scenario("loaded", 6.0, speed=10.7))
    kinds = [e.kind for e in result.events]
    assert kinds.count("overload") == kinds.count("pull-out") == 1
    assert event(result, "overload").speed == pytest.approx(10.0, abs=1e-12)
    assert event(result, "pull-out").speed == pytest.approx(MOTOR.critical, abs=1e-12)
    texts = [str(verdict) for verdict in result.verdicts]
    assert texts[0].startswith("warning")
    assert any(text.startswith("note: overload at t =") for text in texts)


def test_a_run_down_is_no_overload() -> None:
    drive = Drive((Mass(30.6),), characteristic=MOTOR, cycle=upsetter(0.0))
    result = run(drive, Scenario("run-down", 20.0, speed=10.7, motor=((0.0, 0.5),), brake=Brake(40.0, start=0.5)))
    assert result.end == "standstill"
    assert [e.kind for e in result.events] == ["motor off", "brake on", "standstill"]
    slowed = run(upsetter_drive(MOTOR, 30.6), Scenario("off", 9.0, speed=10.7, motor=((0.0, 1.0),), brake=Brake(40.0)))
    overload = next(str(verdict) for verdict in slowed.verdicts if "overload" in str(verdict))
    lowest = slowed.omega[0, slowed.t < 1.0].min()
    assert f"its lowest speed afterwards is {lowest:.6g} rad/s" in overload
    assert result.verdicts == ()


def test_a_light_crank_of_its_own_inertia() -> None:
    """The crank may have no constant inertia where that of the links is enough."""
    drive = Drive((Mass(0.0),), characteristic=constant(2.0), cycle=cycle(0.0, 0.5))
    assert run(drive, Scenario("start", 1.0)).omega[0, -1] == pytest.approx(4.0, abs=1e-12)
