"""A flywheel under a tolerance keeps it, against the motion in time with that flywheel, or ends with an error."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from sparing import sparing

from tmmcalc import load_spec
from tmmcalc.core.errors import AccuracyError
from tmmcalc.machine.stages import transient
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import simulate
from tmmcalc.machine.transient.solve import drive_of
from tmmcalc.pipeline.runner import run

CONFIGS = Path(__file__).parents[3] / "configs"


@sparing("asked", [1e-3, 1e-6, 1e-8], every=3)
def test_what_is_asked_is_kept(asked: float) -> None:
    """The unevenness of the motion with the wheel found differs from that asked by no more than the inertia may."""
    spec = load_spec(CONFIGS / "piston-compressor.toml")
    results = run(spec, target="flywheel", tolerance=asked).results
    found = results["flywheel"]
    assert found.error <= asked
    drive, _ = drive_of(replace(transient.machine_of(transient.inputs(spec), results), shafts=()))
    assert drive.cycle is not None
    start = float(found.required.regime.omega_at([0.0])[0])
    motion = simulate(
        drive,
        Scenario("cycle", 10.0, speed=start, end_angle=drive.cycle.period),
        Method("collocation", tolerance=1e-12, compared=False),
    )
    speeds = (*motion.omega[0].tolist(), *motion.turning[2].tolist())
    delta = 2 * (max(speeds) - min(speeds)) / (max(speeds) + min(speeds))
    assert abs(delta / found.delta - 1) <= asked


def test_what_cannot_be_reached_is_an_error() -> None:
    with pytest.raises(
        AccuracyError, match=r"flywheel: the estimated error of inertia is .* more than the 1e-11 asked"
    ):
        run(load_spec(CONFIGS / "piston-compressor.toml"), target="flywheel", tolerance=1e-11)
