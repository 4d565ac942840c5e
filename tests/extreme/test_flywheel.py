"""Flywheels for an unevenness of a millionth and of one half, and everything between."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tmmcalc import NoSolutionError

from .scenes import solved
from .truth import DENSE, TURN, Induction, Pressed, Slider, largest

SPEED = 5.0
PRESS = Pressed(Slider(m2=4, j2=0.02, s=0.08, m3=10), 2000)
DELTAS = [float(delta) for delta in np.geomspace(1e-6, 0.5, 7)]


@pytest.mark.parametrize(("name", "delta", "exact"), [("delta-tiny", 1e-6, 1e-10), ("delta-half", 0.5, 1e-12)])
def test_inertia_and_the_regime_with_it(name: str, delta: float, exact: float) -> None:
    results = solved(name).results
    assert results["flywheel"].addition == pytest.approx(PRESS.flywheel(delta, SPEED), rel=exact)
    # speeds are good to 1e-16 of themselves, their difference to 1e-16/delta
    assert results["motion"].regime.delta == pytest.approx(delta, rel=1e-15 / delta + 1e-12)
    assert results["motion"].regime.mean == pytest.approx(SPEED, rel=1e-12)


def test_sweep_of_the_unevenness() -> None:
    """J delta tends to the largest surplus of work less kinetic energy over omega^2 (Mertsalov's), as delta itself."""
    wheels = [
        solved("delta-tiny", f"flywheel.delta={delta!r}", target="flywheel").results["flywheel"] for delta in DELTAS
    ]
    inertias = np.array([wheel.addition for wheel in wheels])
    assert inertias == pytest.approx([PRESS.flywheel(delta, SPEED) for delta in DELTAS], rel=1e-9)
    assert np.all(np.diff(inertias) < 0)

    def surplus(phi: float) -> float:
        return PRESS.surplus(phi) - SPEED**2 * PRESS.slider.inertia(phi) / 2

    limit = (largest(surplus) + largest(lambda phi: -surplus(phi))) / SPEED**2
    off = np.abs(inertias * DELTAS / limit - 1)
    assert np.all(off <= 1e-9 + 0.1 * np.array(DELTAS))
    assert off[-1] > 5e-4  # the limit is not the answer where delta is large


def test_an_unevenness_of_a_millionth_with_a_motor() -> None:
    """The speed is all but constant: the motor gives the mean load, the flywheel takes the rest."""
    motor = Induction(1100, 1410 / 20 * TURN / 60, 1500 / 20 * TURN / 60)
    load = Pressed(Slider(), 2000)
    a, b = motor.parabola
    speed = math.sqrt((a + load.work / TURN) / b)
    amplitude = float(np.ptp(load.surplus(DENSE)))
    results = solved("slip", 'motor.speed="1410 rpm"', "flywheel={delta=1e-6}").results
    assert results["flywheel"].inertia == pytest.approx(amplitude / (1e-6 * speed**2), rel=2e-6)
    assert results["motion"].regime.mean == pytest.approx(speed, rel=1e-6)
    assert results["motion"].regime.delta == pytest.approx(1e-6, rel=1e-7)


def test_a_motor_of_small_slip_needs_no_flywheel_for_one_half() -> None:
    wheel = solved("slip", "flywheel={delta=0.5}").results["flywheel"]
    assert wheel.addition == 0
    assert wheel.required.needed is False
    assert wheel.required.regime.delta < 1e-5


def test_no_flywheel_helps_an_overloaded_motor() -> None:
    with pytest.raises(NoSolutionError, match="the mean resisting moment") as refused:
        solved("stall-mean", "flywheel={delta=0.1}", target="flywheel")
    assert refused.value.value == pytest.approx(12000 * 0.1 / TURN, rel=1e-12)
