"""Studies of the flywheel, and ladders of stiffness: search against Brent, the textbook's step against the choice."""

from __future__ import annotations

import pytest

from tmmcalc import load_spec
from tmmcalc.accuracy.ladder_document import ladder_document
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.machine.accuracy.ladder import ASKED, STIFFNESSES, ladders
from tmmcalc.machine.stages import transient
from tmmcalc.machine.transient.solve import beginning
from tmmcalc.pipeline.runner import run

from .scenes import CONFIGS, ONCE, errors_in, errors_of, series_of, studies_of


@pytest.mark.slow
def test_flywheel_under_a_motor() -> None:
    for study in solve_accuracy(load_spec(CONFIGS / "piston-pump.toml"), "flywheel", ONCE).studies:
        assert study.reference.error < 1e-12
        assert max(errors_of(study, "search")) < 2e-9
        bisection = series_of(study, "bisection")
        assert bisection.order == pytest.approx(1.0, abs=0.2)
        assert errors_in(bisection)[-1] < 1e-10
        corrections = errors_of(study, "correction (3.60)")
        assert corrections == sorted(corrections, reverse=True)
        assert min(errors_of(study, "tangents, exact")) > 0.1, "the slip of the motor is left out"


def test_flywheel_under_forces_of_position() -> None:
    studies = solve_accuracy(load_spec(CONFIGS / "press.toml"), "flywheel", ONCE).studies
    assert {study.quantity for study in studies} == {"constant inertia needed", "unevenness reached"}
    for study in studies:
        assert max(errors_of(study, "tangents, exact")) < 1e-13
        delta = 0.1 / 2  # of the speeds; the textbook drops its square
        assert max(errors_of(study, "tangents, book")) < delta**2
        assert series_of(study, "table, book").order == pytest.approx(1.2, abs=0.2), "the load of the press jumps"


def test_a_tiny_unevenness_takes_no_digits_of_either_reference() -> None:
    for study in studies_of("extreme/delta-tiny", "flywheel").values():
        assert study.reference.error < 1e-14
        best = study.series[0].best
        assert best is not None
        assert best.error is not None
        assert best.error < 1e-14


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
