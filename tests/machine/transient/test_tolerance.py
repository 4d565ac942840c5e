"""An error that is asked for is kept, against DOP853 of scipy at 1e-13, and a looser one costs less."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from machine.transient.scenes import at, cycle
from machine.transient.scenes import run as driven
from tmmcalc import load_spec
from tmmcalc.core.errors import AccuracyError
from tmmcalc.machine.motors.characteristics import parabolic
from tmmcalc.machine.stages import transient
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Drive, Mass
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import simulate
from tmmcalc.machine.transient.solve import beginning
from tmmcalc.pipeline.runner import run

CONFIGS = Path(__file__).parents[3] / "configs"
MOTOR = 'motor={power="0.55 kW", speed="1390 rpm", synchronous_speed="1500 rpm", overload=2.2, characteristic="kloss"}'
START = 'transients=[{{name="start-up", duration="{} s", load=0, load_steps=[{{factor=1, time="0.1 s"}}]}}]'
SCENES = {
    "press": (MOTOR, START.format(0.5)),
    "shaper": (START.format(0.4),),
    "elastic-drive": (START.format(0.15),),
}
ASKED = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10)


@sparing("name", SCENES, every=3)
def test_what_is_asked_is_kept_and_less_costs_less(name: str) -> None:
    spec = load_spec(CONFIGS / f"{name}.toml", SCENES[name])
    results = run(spec, target="transient", tolerance=1e-4).results
    given = transient.inputs(spec)
    ((drive, scenario),) = beginning(transient.machine_of(given, results), given[0], 1.0)
    instants = np.linspace(0.0, scenario.duration, 42)[1:-1]
    times = instants.tolist()
    exact = simulate(drive, scenario, Method("DOP853", tolerance=1e-13, compared=False), times)
    true = exact.omega[:, np.searchsorted(exact.t, instants)]
    counts = []
    for asked in ASKED:
        found = simulate(drive, scenario, Method(error=asked), times)
        missed = np.max(np.abs(found.omega[:, np.searchsorted(found.t, instants)] - true)) / np.max(np.abs(true))
        assert missed <= found.error <= asked
        counts.append(found.counters["evaluations"])
    assert counts == sorted(counts)
    assert counts[-1] > 3 * counts[0]


def test_what_cannot_be_reached_is_an_error() -> None:
    spec = load_spec(CONFIGS / "shaper.toml", SCENES["shaper"])
    with pytest.raises(AccuracyError, match=r"the estimated error of .* more than the 1e-15 asked for"):
        run(spec, target="transient", tolerance=1e-15)
    coarse = load_spec(
        CONFIGS / "shaper.toml", ('transients=[{name="coarse", duration="0.3 s", method="rk4", step="20 ms"}]',)
    )
    assert run(coarse, target="transient", tolerance=1e-2).results["transient"].motions[0].error < 1e-2
    with pytest.raises(AccuracyError, match=r"transient: the estimated error of (speed|energy) is"):
        run(coarse, target="transient", tolerance=1e-9)


@pytest.mark.slow
@sparing("lag", [1e-4, 1e-2], every=2)
def test_a_steep_motor_that_lags_is_followed_as_far_as_rounding_allows(lag: float) -> None:
    """The moment of such a motor is rounded to more than the tolerance of a step: that is no reason to refuse."""
    motor = parabolic(100.0, 10.0, 10.003)
    load = cycle(lambda p: -50 - 20 * np.cos(p), lambda p: 0.1 * (1 + np.sin(2 * p)), speed=10.0)
    drive = Drive((Mass(1.0),), (), motor, load, None, lag)
    times = np.linspace(0.02, 0.08, 7).tolist()
    finest, usual = (
        driven(drive, Scenario("held", 0.1, speed=10.0), "collocation", times, tolerance=tolerance)
        for tolerance in (1e-13, 1e-11)
    )
    apart = np.abs(finest.omega[0, at(finest, times)] - usual.omega[0, at(usual, times)])
    assert np.max(apart) <= 10 * (finest.error + usual.error)
    assert finest.error < 1e-11
