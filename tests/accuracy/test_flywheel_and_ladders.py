"""Studies of the flywheel, and ladders of stiffness: search against Brent, the textbook's step against the choice."""

from __future__ import annotations

from pathlib import Path

import pytest

from tmmcalc import load_spec
from tmmcalc.accuracy.ladder import ASKED, STIFFNESSES, ladders
from tmmcalc.accuracy.measure import Clock
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.accuracy.study import Series, Study
from tmmcalc.machine.transient.task import beginning
from tmmcalc.pipeline.runner import run
from tmmcalc.report.accuracyladder import ladder_document
from tmmcalc.stages import transient

CONFIGS = Path(__file__).parents[2] / "configs"
ONCE = Clock(repeats=1, budget=0.0)


def _series(study: Study, name: str) -> Series:
    return next(series for series in study.series if series.method == name)


def _errors(series: Series) -> list[float]:
    return [point.error for point in series.points if point.error is not None]


def test_flywheel_under_a_motor() -> None:
    for study in solve_accuracy(load_spec(CONFIGS / "piston-pump.toml"), "flywheel", ONCE).studies:
        assert study.reference.error < 1e-12
        assert max(_errors(_series(study, "search"))) < 2e-9
        bisection = _series(study, "bisection")
        assert bisection.order == pytest.approx(1.0, abs=0.2)
        assert _errors(bisection)[-1] < 1e-10
        corrections = _errors(_series(study, "correction (3.60)"))
        assert corrections == sorted(corrections, reverse=True)
        assert min(_errors(_series(study, "tangents, exact"))) > 0.1, "the slip of the motor is left out"


def test_flywheel_under_forces_of_position() -> None:
    studies = solve_accuracy(load_spec(CONFIGS / "press.toml"), "flywheel", ONCE).studies
    assert {study.quantity for study in studies} == {"constant inertia needed", "unevenness reached"}
    for study in studies:
        assert max(_errors(_series(study, "tangents, exact"))) < 1e-13
        delta = 0.1 / 2  # of the speeds; the textbook drops its square
        assert max(_errors(_series(study, "tangents, book"))) < delta**2
        assert _series(study, "table, book").order == pytest.approx(1.2, abs=0.2), "the load of the press jumps"


@pytest.mark.slow
def test_ladders_of_an_elastic_drive() -> None:
    start = 'transients=[{name="start-up", duration="0.2 s", load=0}]'
    spec = load_spec(CONFIGS / "elastic-drive.toml", (start,))
    given = transient.inputs(spec)
    results = run(spec, target="transient", tolerance=1e-3).results
    ((drive, scenario),) = beginning(transient.machine_of(given, results), given[0], 1.0)
    shafts, lag = ladders(drive, scenario, ONCE)
    assert shafts.power == pytest.approx(-0.5, abs=0.01)
    assert lag.power == pytest.approx(1.0, abs=0.05)
    for ladder in (shafts, lag):
        counts = [rung.evaluations for rung in ladder.rungs]
        assert max(counts) < 4 * min(counts), counts
        assert max(rung.error for rung in ladder.rungs) < 1e-8
        assert ladder.rungs[-1].textbook_evaluations > 50 * max(counts)
        assert all("unstable" in rung.textbook_fails for rung in ladder.rungs if rung.limit < 0.9 * ASKED)
        text = str(ladder_document(ladder).facts[1].text)
        assert "a step of 0.01 s is asked for, the limit of stability falls from" in text
    assert [rung.value for rung in shafts.rungs] == list(STIFFNESSES)
