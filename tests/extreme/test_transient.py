"""Motions in time at the edges: shafts of 1e3 to 1e12 N*m/rad, a motor that cannot start or stops."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.machine.transient.timed import TimedMotion

from .scenes import solved
from .truth import TURN, Induction, Pressed, Slider, passes

ROTOR, CRANK, DRIVING, LOAD, BEGIN = 0.5, 1.5, 50.0, 30.0, 10.0
CARRIED = (DRIVING * CRANK + LOAD * ROTOR) / (ROTOR + CRANK)  # mean moment of the shaft
RISE = (DRIVING - LOAD) / (ROTOR + CRANK)


def moved(*overrides: str) -> TimedMotion:
    (motion,) = solved("shaft-stiffness", *overrides, target="transient").results["transient"].motions
    return motion


def swinging(motion: TimedMotion, stiffness: float) -> tuple[np.ndarray, np.ndarray]:
    """Speeds of rotor and crank (2, S) and the shaft's moment (S,) of two masses that a moment pulls at either side."""
    rate = math.sqrt(stiffness * (ROTOR + CRANK) / (ROTOR * CRANK))
    swing = CARRIED * np.sin(rate * motion.t) / rate
    speeds = BEGIN + RISE * motion.t + np.stack((swing / ROTOR, -swing / CRANK))
    return speeds, CARRIED * (1 - np.cos(rate * motion.t))


@sparing("stiffness", [1e3, 1e4, 1e5, 1e6], every=4)
def test_shafts_that_swing(stiffness: float) -> None:
    motion = moved(f"shafts[name=shaft].stiffness={stiffness!r}")
    speeds, moment = swinging(motion, stiffness)
    assert motion.rigid == ()
    assert np.max(np.abs(motion.omega - speeds)) <= motion.error * np.max(speeds)
    assert motion.error < 1e-7
    assert motion.shaft_moment[0] == pytest.approx(moment, abs=2e-7 * CARRIED)
    assert motion.imbalance < 1e-11


@pytest.mark.parametrize("stiffness", [1e8, 1e9, 1e10, 1e11, 1e12])
def test_shafts_too_stiff_to_swing(stiffness: float) -> None:
    motion = moved(f"shafts[name=shaft].stiffness={stiffness!r}")
    speeds, _ = swinging(motion, stiffness)
    assert motion.rigid == (0,)
    assert motion.shaft_moment[0] == pytest.approx(np.full(len(motion.t), CARRIED), rel=1e-9)
    assert motion.omega[1] == pytest.approx(BEGIN + RISE * motion.t, rel=1e-12)
    assert np.max(np.abs(motion.omega - speeds)) <= motion.error * np.max(speeds)
    assert any("taken as rigid" in verdict.message for verdict in motion.verdicts)


@pytest.mark.parametrize("stiffness", [1e3, 1e6, 1e9, 1e12])
def test_damped_shafts_end_in_the_rigid_motion(stiffness: float) -> None:
    """Aperiodic damping: what swings at the beginning dies, and the shaft carries the moment of the rigid drive."""
    damping = 2 * math.sqrt(stiffness * ROTOR * CRANK / (ROTOR + CRANK))
    motion = moved(f"shafts[name=shaft]={{name='shaft', stiffness={stiffness!r}, damping={damping!r}}}")
    assert motion.shaft_moment[0, -1] == pytest.approx(CARRIED, rel=1e-6)
    assert motion.omega[1, -1] == pytest.approx(BEGIN + RISE * motion.t[-1], rel=1e-3 if stiffness < 1e6 else 1e-5)


@sparing("ratio", [1e-6, 1e-3, 1e3, 1e6], every=4)
def test_inertia_ratios_on_a_shaft(ratio: float) -> None:
    """The mean speed rises as of one mass, whatever the ratio of the two."""
    motion = moved(f"motor.inertia={1.5 * ratio!r}", "shafts[name=shaft]={name='shaft', stiffness=1000, damping=0.5}")
    momentum = 1.5 * ratio * motion.omega[0] + 1.5 * motion.omega[1]
    expected = 1.5 * (1 + ratio) * BEGIN + (DRIVING - LOAD) * motion.t
    assert momentum == pytest.approx(expected, rel=1e-8 + motion.error * float(np.max(motion.omega)) / BEGIN)


def test_no_start_and_stall() -> None:
    motions = {m.name: m for m in solved("no-start", target="transient").results["transient"].motions}
    driven = Induction(550, 1410 / 20 * TURN / 60, 1500 / 20 * TURN / 60)
    still, stalled = motions["in the load"], motions["towards the load"]
    starting = f"at standstill it gives {driven.kloss(0.0):.5g} N*m at the crank"
    assert still.end == stalled.end == "stall"
    assert "the motor cannot start at the crank angle 90 deg" in still.verdicts[0].message
    assert f"{starting}, the load asks for {8000 * 0.05:.5g} N*m" in still.verdicts[0].message
    assert not np.any(still.omega)
    # from rest the crank comes to the load with less energy than from the synchronous speed
    stop = math.degrees(stalled.theta[-1, -1])
    load = Pressed(Slider(), 8000, math.radians(60), math.radians(120))
    fastest = passes(load, driven, 0.2)
    assert fastest is not None
    assert 60 < stop <= math.degrees(fastest) + 1e-3
    asked = -load.moment(stalled.theta[-1, -1])
    assert f"the load asks for {asked:.5g} N*m" in stalled.verdicts[0].message
    assert stalled.kinetic[-1] == pytest.approx(0, abs=1e-9)
    assert stalled.motor_work[-1] + stalled.load_work[-1] == pytest.approx(0, abs=1e-6)


@sparing("lag", [1e-9, 1e-6, 1e-3], every=3)
def test_lag_of_the_motor(lag: float) -> None:
    """A lag far below all other times changes the motion in proportion to itself."""
    override = ('transients=[{name="run-up", duration="0.3 s", load=0}]',)
    (quick,), (slow,) = (
        solved("no-start", *override, *more, target="transient").results["transient"].motions
        for more in ((), (f"motor.time_constant={lag!r}",))
    )
    speed = 1500 / 20 * TURN / 60
    assert slow.t[-1] == quick.t[-1]
    assert slow.omega[0, -1] == pytest.approx(quick.omega[0, -1], abs=speed * (1e-6 + 20 * lag))


def test_crank_whose_inertia_is_that_of_its_diagram_alone() -> None:
    """Nothing constant turns with the crank: the shaft ends in a mass of the cycle's own inertia."""
    motion = moved("motion.inertia=0", "torque.inertia=1.5")
    speeds, moment = swinging(motion, 1000.0)
    assert np.max(np.abs(motion.omega - speeds)) <= motion.error * np.max(speeds)
    assert motion.shaft_moment[0] == pytest.approx(moment, abs=2e-7 * CARRIED)
