"""What the equivalent scene of a rung does otherwise, be it to crash, is told."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tmmcalc.core.errors import NoSolutionError, SpecError, UsageError
from tmmcalc.core.stored import Table
from tmmcalc.pipeline.outcome import Outcome, RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.stress import gears, linkage, numbering, scales, synthesis
from tmmcalc.stress.compare import Alignment, difference
from tmmcalc.stress.ladders import LADDERS
from tmmcalc.stress.results import DISPUTED, ERROR, FAULT, OK, WARNING, Ladder, Met, Rung
from tmmcalc.stress.run import solve_stress
from tmmcalc.stress.similarity import in_units
from tmmcalc.stress.stages import between
from tmmcalc.stress.units import Factors

from .scenes import variants

Runs = Callable[..., RunResult]


def twins_end(monkeypatch: pytest.MonkeyPatch, ending: Runs) -> None:
    """Let the twins of rungs be run by ``ending``, and all other scenes as they are."""
    made: list[bool] = []

    def twin(document: Any) -> Any:
        made.append(True)
        return scales.twin(document)

    def either(spec: Any, **more: Any) -> RunResult:
        return ending(spec, **more) if made and made.pop() else run(spec, **more)

    monkeypatch.setattr("tmmcalc.stress.run.twin", twin)
    monkeypatch.setattr("tmmcalc.stress.scene.run", either)


def dead_point(monkeypatch: pytest.MonkeyPatch, *left: float) -> Ladder:
    monkeypatch.setattr(linkage, "DISTANCES", left)
    (ladder,) = solve_stress(variants("four-bar"), ["dead-point"], "kinematics").ladders
    return ladder


def of_stage(rung: Rung, stage: str = "kinematics") -> Met:
    (met,) = (met for met in rung.met if met.stage == stage)
    return met


def crash(*_: object, **__: object) -> RunResult:
    raise ValueError("not a number")


@pytest.mark.slow
def test_a_crash_on_the_twin_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    twins_end(monkeypatch, crash)
    monkeypatch.setattr(linkage, "DISTANCES", (1.0, 0.1))
    result = solve_stress(variants("four-bar"), ["dead-point"], "kinematics")
    assert len(result.faults) == 2
    _, rung, met = result.faults[0]
    assert (met.stage, met.code, met.message) == ("twin", 1, "in other units: ValueError: not a number")
    assert of_stage(rung).status == OK
    assert of_stage(rung).error is None


@pytest.mark.slow
def test_a_crash_as_the_twin_is_written_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    def unwritten(document: object) -> None:
        raise TypeError("no such unit")

    monkeypatch.setattr("tmmcalc.stress.run.twin", unwritten)
    (rung,) = dead_point(monkeypatch, 1.0).rungs
    assert (rung.met[-1].status, rung.met[-1].message) == (FAULT, "in other units: TypeError: no such unit")


def test_a_crash_on_the_way_to_the_edge_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    """And no ladder after it is lost."""
    monkeypatch.setattr("tmmcalc.stress.linkage.limit_of", crash)
    ladders = solve_stress(variants("four-bar"), ["dead-point", "direction"], "kinematics").ladders
    assert [met.status for met in ladders[0].rungs[0].met] == [FAULT]
    assert {met.status for met in ladders[1].rungs[0].met} == {OK}


def refusing(spec: Any, **more: Any) -> RunResult:
    """A run without its kinematics."""
    found = run(spec, **more)
    kept = {name: each for name, each in found.outcomes.items() if name != "kinematics"}
    return replace(found, outcomes=kept, failures={"kinematics": NoSolutionError("dead point", where="kinematics")})


@pytest.mark.slow
def test_a_stage_that_only_the_twin_refuses_is_disputed(monkeypatch: pytest.MonkeyPatch) -> None:
    twins_end(monkeypatch, refusing)
    met = of_stage(dead_point(monkeypatch, 1.0).rungs[0])
    assert (met.status, met.code, met.told) == (DISPUTED, 0, False)
    assert met.message == "in other units: kinematics: dead point"
    assert met.skipped == ("all (in other units it has no result)",)


@pytest.mark.slow
def test_beside_a_warning_it_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    twins_end(monkeypatch, refusing)
    met = of_stage(dead_point(monkeypatch, 1e-8).rungs[0])
    assert (met.status, met.told) == (WARNING, True)
    assert met.message.startswith("warning")
    assert met.message.endswith("; in other units: kinematics: dead point")


@pytest.mark.slow
def test_a_twin_that_is_refused_as_a_whole_is_disputed(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(*_: object, **__: object) -> RunResult:
        raise UsageError("no such length", where="spec")

    twins_end(monkeypatch, refused)
    met = dead_point(monkeypatch, 1.0).rungs[0].met[-1]
    assert (met.stage, met.status, met.message) == ("twin", DISPUTED, "in other units: spec: no such length")


@pytest.mark.slow
def test_an_error_that_the_twin_has_not_is_told_so(monkeypatch: pytest.MonkeyPatch) -> None:
    ordinary = scales.twin(variants("four-bar").data)
    monkeypatch.setattr("tmmcalc.stress.run.twin", lambda _: ordinary)
    met = of_stage(dead_point(monkeypatch, 0.0).rungs[0])
    assert (met.status, met.code) == (ERROR, 3)
    assert met.message.endswith("; in other units it has a result")


@pytest.mark.slow
def test_a_number_that_is_none_in_the_twin_alone_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(spec: Any, **more: Any) -> RunResult:
        found = run(spec, **more)
        outcome = found.outcomes["kinematics"]
        spoilt = replace(outcome.record, scalars={**outcome.record.scalars, "stroke": float("nan")})
        return replace(found, outcomes={**found.outcomes, "kinematics": Outcome(outcome.stage, lambda: spoilt)})

    twins_end(monkeypatch, broken)
    met = of_stage(dead_point(monkeypatch, 1.0).rungs[0])
    assert (met.status, met.message) == (FAULT, "in other units kinematics.stroke is no finite number")


def test_a_twin_is_known_by_its_field(monkeypatch: pytest.MonkeyPatch) -> None:
    """Which scene is in which units does not hang on the very object of the factors."""
    monkeypatch.setattr("tmmcalc.stress.run.TWIN", replace(scales.TWIN))
    met = of_stage(dead_point(monkeypatch, 1.0).rungs[0])
    assert met.error is not None
    assert met.error < 1e-14


def test_the_reason_why_nothing_stands_beside_a_rung() -> None:
    (ladder,) = solve_stress(variants("gears-pairs"), ["torque"], "criteria").ladders
    assert {rung.note for rung in ladder.rungs} == {
        "nothing beside it: scale: [train]: modules are standard, and strength is empirical"
    }


def test_a_ladder_named_twice_is_climbed_once() -> None:
    ladders = solve_stress(variants("four-bar"), ["direction", "direction"], "kinematics").ladders
    assert [ladder.name for ladder in ladders] == ["direction"]


@pytest.mark.parametrize("angle", ["15deg", "15 °", "1.5e1 deg", " 0.25 rad "])
def test_quantities_are_read_as_the_spec_reads_them(angle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gears, "LEFT", (1.0,))
    source = variants("pair-helical", f"pair.helix_angle={angle!r}")
    (rung,) = solve_stress(source, ["mesh-angle"], "pair").ladders[0].rungs
    assert 0 < (rung.met[0].error or 0.0) < 1e-13


def test_quotients_are_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(synthesis, "DISTANCES", (1.0,))
    source = variants("synth-slotted-link", "synthesis.slotted_link.time_ratio='7/5'")
    (rung,) = solve_stress(source, ["time-ratio"]).ladders[0].rungs
    assert rung.setting == "K = 1 + 0.4"
    assert 0 < (rung.met[0].error or 0.0) < 1e-13


def test_the_output_of_a_function_may_be_a_travel() -> None:
    function = {"range": ["1/2", 2], "input_range": "90 deg", "output_range": "64mm", "expression": "x"}
    narrow = synthesis.narrowed(function, 0.25)
    assert narrow == {
        **function,
        "range": [0.5, 0.875],
        "input_range": f"{np.pi / 8!r} rad",
        "output_range": "0.016 m",
    }


class Told:
    """A run of one stage that tells a table, of a linkage that reaches 2 m."""

    def __init__(self, **columns: Sequence[float]) -> None:
        arrays = [np.asarray(column, float) for column in columns.values()]
        header = [name.replace("__", "[") + "]" * ("__" in name) for name in columns]
        self.told = Table(["place", *header], [np.arange(len(arrays[0])), *arrays])
        self.outcomes: dict[str, object] = {}

    def table(self, stage: str) -> Table:
        return self.told


def apart(one: Told, two: Told) -> Any:
    return difference("forces", one, two)


def test_what_one_scene_tells_alone_is_named() -> None:
    found = apart(Told(R__N=[1, 2], Q__N=[1, 1]), Told(R__N=[1, 2], P__N=[3, 3]))
    assert (found.size, found.skipped) == (0.0, ("Q (in one scene only)", "P (in one scene only)"))


def test_a_zero_without_a_size_is_not_compared() -> None:
    """Forces of nothing beside a rounding of what cancels: no number of newtons is small by itself."""
    found = apart(Told(R__N=[0, 0]), Told(R__N=[0, 3e-17]))
    assert (found.size, found.skipped) == (None, ("R (zero beside 3.0e-17 N)",))
    assert apart(Told(R__N=[0, 0]), Told(R__N=[0, 0])).size == 0


def test_zeros_are_relative_to_what_they_are_made_from() -> None:
    assert apart(Told(a__deg=[0]), Told(a__deg=[3.6e-14])).size == pytest.approx(1e-16)
    assert apart(Told(delta=[0]), Told(delta=[2e-17])).size == 2e-17
    scaled = difference("forces", Told(R__N=[0, 4]), Told(R__N=[1, 12]), Alignment(Factors(3.0)))
    assert scaled.size == pytest.approx(1 / 12)


def test_tables_of_other_lengths_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numbering, "POSITIONS", ())
    (rung,) = solve_stress(variants("four-bar"), ["positions"], "kinematics").ladders[0].rungs
    assert of_stage(rung).skipped == ("table (13 rows beside 5)",)


def test_a_spec_that_no_longer_reads_ends_its_ladder_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    def unread(*_: object, **__: object) -> RunResult:
        raise SpecError("my.toml", [])

    monkeypatch.setattr("tmmcalc.stress.run.LADDERS", {name: LADDERS[name] for name in ("positions", "direction")})
    monkeypatch.setattr("tmmcalc.stress.scene.run", unread)
    result = solve_stress(variants("four-bar"), stage="kinematics")
    assert [ladder.name for ladder in result.ladders] == ["direction"]
    assert [name for name, _ in result.without] == ["positions"]


@pytest.mark.slow
def test_an_acceleration_is_relative_to_its_peak_over_the_cycle() -> None:
    """w^2 (J + m x'^2) is constant: peaks of about w^2/(2 l) at the angles l = sqrt(J/m)/x'' about a dead centre.

    At the rows, 15 deg apart, what is not zero there is 1e-11 of that, and rounding of what is zero larger still.
    """
    source = variants("extreme/inertia-tiny")
    one, two = (run(source.of(in_units(source.data, factors)), target="motion") for factors in (Factors(), scales.TWIN))
    found = difference("motion", one, two, Alignment(scales.TWIN))
    near = np.sqrt(2.5e-11 / 10) / (0.05 + 0.05**2 / 0.2)
    speed = one.results["motion"].omega[0]
    # of y/(1 + y^2)^2 the largest is 3 sqrt(3)/16
    peak = speed**2 / near * 3 * np.sqrt(3) / 16
    assert between("motion", one)["eps"] == pytest.approx(peak, rel=1e-3)
    assert np.max(np.abs(one.results["motion"].eps)) < 1e-6 * peak
    assert found.size is not None
    assert found.size < one.record("motion").error["speed"]


def optimum(scale: float) -> RunResult:
    source = variants("cam-translating")
    return run(source.of(in_units(source.data, Factors(scale, scale**3))), target="cam_optimum")


@pytest.mark.slow
def test_a_shaft_in_whole_millimetres_is_not_compared_where_it_decides() -> None:
    """Of a cam of a hundredth the size the least shaft, 1 mm, is larger than the cam."""
    found = difference("cam_optimum", optimum(1.0), optimum(0.01), Alignment(Factors(0.01, 1e-6)))
    assert (found.size, found.skipped) == (None, ("all (the shaft decides, which is in whole millimetres)",))


@pytest.mark.slow
def test_an_optimum_with_forces_of_any_size_is_the_same() -> None:
    """At a hundred times the size forces are 1e8 times as large, some 1e10 N."""
    found = difference("cam_optimum", optimum(1.0), optimum(100.0), Alignment(Factors(100.0, 1e6)))
    assert found.size is not None
    assert found.size < 1e-13
