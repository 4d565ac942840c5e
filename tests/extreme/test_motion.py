"""Steady motion at the edges: inertia ratios of 1e-6 to 1e6, a slip of 1e-5, loads that stall the motor, no masses."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from sparing import sparing

from tmmcalc import NoSolutionError, UsageError

from .scenes import solved
from .truth import TURN, Induction, Pressed, Slider, largest, passes, slip_by_parabola

SYNCHRONOUS = 1500 / 20 * TURN / 60
STROKE = 0.1


def motor(power: float, rated: float) -> Induction:
    return Induction(power, rated / 20 * TURN / 60, SYNCHRONOUS)


@sparing("ratio", [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6], every=3)
def test_inertia_ratios_without_loads(ratio: float) -> None:
    """The kinetic energy is constant, so omega = c/sqrt(J + m x'^2) with (max + min)/2 = 5 rad/s."""
    slider, constant = Slider(m3=10), 10 * 0.05**2 * ratio
    motion = solved("inertia-ratio", f"motion.inertia={constant!r}", target="motion").results["motion"]
    added = largest(slider.inertia) / constant
    root = math.sqrt(1 + added)
    fastest = 5 * 2 * root / (root + 1)
    assert motion.regime.delta == pytest.approx(2 * added / (root + 1) ** 2, rel=1e-12, abs=2e-16)
    assert motion.omega == pytest.approx(fastest / np.sqrt(1 + slider.inertia(motion.phi) / constant), rel=1e-9)
    places = sorted({float(p) for k in range(3) for p in np.pi * k + np.array([0, 1e-3, -1e-3, 1e-2, -1e-2])})
    time, _ = quad(
        lambda phi: math.sqrt(1 + float(slider.inertia(phi)) / constant) / fastest,
        0,
        TURN,
        points=[p for p in places if 0 < p < TURN],
        epsabs=0,
        epsrel=1e-12,
        limit=500,
    )
    assert motion.regime.cycle_time == pytest.approx(time, rel=max(1e-11, motion.regime.error))


@sparing("slip", [1e-5, 1e-4, 1e-3, 1e-2, 1e-1], every=5)
def test_slip(slip: float) -> None:
    driven, load = motor(1100, 1500 * (1 - slip)), Pressed(Slider(), 2000)
    motion = solved("slip", f'motor.speed="{1500 * (1 - slip)!r} rpm"', target="motion").results["motion"]
    behind = (1 - (motion.omega[:-1] / SYNCHRONOUS) ** 2) / slip
    assert behind == pytest.approx(slip_by_parabola(load, driven, 2.0, np.asarray(motion.phi[:-1])), abs=2e-9)
    # never above the synchronous speed, never below that of the largest load
    a, _ = driven.parabola
    least = math.sqrt(1 - largest(lambda phi: -load.moment(phi)) / a)
    assert least * (1 - 1e-12) <= motion.regime.omega_min / SYNCHRONOUS
    assert motion.regime.omega_max / SYNCHRONOUS <= 1 + 1e-12


@pytest.mark.parametrize("inertia", [float(j) for j in np.geomspace(1e-6, 1e6, 7)])
def test_inertia_ratios_with_a_motor(inertia: float) -> None:
    """Without inertia the motor gives the load of every instant, with much of it the mean one."""
    driven, load = motor(1100, 1410), Pressed(Slider(), 2000)
    a, b = driven.parabola
    regime = (
        solved("slip", 'motor.speed="1410 rpm"', f"motion.inertia={inertia!r}", target="motion")
        .results["motion"]
        .regime
    )
    lowest, highest = (math.sqrt((a - m) / b) for m in (largest(lambda phi: -load.moment(phi)), 0.0))
    assert lowest * (1 - 1e-12) <= regime.omega_min <= regime.omega_max <= highest * (1 + 1e-12)
    if inertia <= 1e-4:
        assert regime.omega_min == pytest.approx(lowest, rel=1e-6)
        assert regime.omega_max == pytest.approx(highest, rel=1e-6)
    if inertia >= 1e4:
        speed = math.sqrt((a + load.work / TURN) / b)
        swing = np.ptp(load.surplus(np.linspace(0, TURN, 20001)))
        assert regime.mean == pytest.approx(speed, rel=1e-4)
        assert regime.delta == pytest.approx(swing / (inertia * speed**2), rel=1e-3)


def test_stall_by_the_mean_load() -> None:
    with pytest.raises(
        NoSolutionError, match=r"steady motion: the mean resisting moment 190\.986 N\*m exceeds"
    ) as refused:
        solved("stall-mean")
    assert refused.value.value == pytest.approx(12000 * STROKE / TURN, rel=1e-12)
    assert refused.value.limit == pytest.approx(2.2 * motor(550, 1410).nominal, rel=1e-9)
    assert refused.value.exit_code == 3


def test_stall_by_the_peak_of_the_load() -> None:
    load, driven = Pressed(Slider(), 8000, math.radians(60), math.radians(120)), motor(550, 1410)
    with pytest.raises(NoSolutionError, match=r"the machine stalls at 61\.3344 deg of cycle 1") as refused:
        solved("stall-peak")
    limit = refused.value.limit
    assert limit is not None
    stopped = passes(load, driven, 0.2)
    assert stopped is not None
    assert math.degrees(stopped) == pytest.approx(61.3344, abs=2e-4)
    assert passes(load, driven, 0.99 * limit) is not None
    assert passes(load, driven, 1.01 * limit) is None
    assert solved("stall-peak", f"motion.inertia={1.01 * limit!r}").results["motion"].regime.stable


def test_nothing_stores_kinetic_energy() -> None:
    """A motor on a linkage without masses, no inertia anywhere: the speed follows the load at once."""
    bare = ("motion.inertia=0",)
    whole = solved("slip", *bare)
    left_out = {event.stage: event.message for event in whole.events if event.kind == "left out"}
    assert "nothing stores kinetic energy" in left_out["motion"]
    with pytest.raises(UsageError, match="nothing stores kinetic energy") as refused:
        solved("slip", *bare, target="motion")
    assert refused.value.exit_code == 2


def test_positional_forces_with_too_little_energy() -> None:
    """The constant moment that balances the press does not turn a light machine through its stroke."""
    with pytest.raises(NoSolutionError, match="the machine would stop at") as refused:
        solved("delta-tiny", "flywheel.inertia=1e-6", target="motion")
    assert refused.value.limit is not None
    assert refused.value.limit > 1e-6
