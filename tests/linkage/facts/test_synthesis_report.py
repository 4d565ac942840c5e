"""What the documents, pictures and commands of the synthesis say, against the records that they show."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from paper import curves, diagram, written
from sparing import sparing
from typer.testing import CliRunner

import tmmcalc
from tmmcalc.cli.app import app
from tmmcalc.linkage.facts.plan import plan_document
from tmmcalc.linkage.facts.synthesis import document as synthesis_document
from tmmcalc.linkage.facts.synthesis import summary as synthesis_summary
from tmmcalc.linkage.pictures.synthesis import synthesis_drawing
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec, parse_spec, templates
from tmmcalc.report.document import Document
from tmmcalc.report.drawing.pens import CURVES, MARK
from tmmcalc.report.drawing.shapes import Dimension

CONFIGS = Path(templates.folder())


def payload(document: Document) -> dict[str, Any]:
    """All values that programs get."""
    return {key: value for fact in document.facts for key, value in fact.values.items()}


def solved(name: str) -> Synthesis:
    return tmmcalc.solve_synthesis(load_spec(CONFIGS / f"synth-{name}.toml"))


def told(name: str, unit: str) -> str:
    """The key of a size: angles are told in degrees."""
    return name if unit == "-" else f"{name}[{unit.replace('rad', 'deg')}]"


def shown(value: float, unit: str) -> float:
    return math.degrees(value) if unit == "rad" else value


@sparing("name", ["slider-crank", "crank-rocker", "function", "motion"], every=4)
def test_document_holds_sizes_checks_and_solutions(name: str) -> None:
    found = solved(name)
    values = payload(synthesis_document(found, "synthesis", everything=True))
    for size in found.best.sizes:
        assert values[told(size.symbol, size.unit)] == pytest.approx(shown(size.value, size.unit), rel=1e-15)
    for each in found.best.checks:
        achieved = values[f"check_{each.name.replace(' ', '_')}"][told("achieved", each.unit)]
        assert achieved == pytest.approx(shown(each.achieved, each.unit), rel=1e-15)
    view = synthesis_document(found, "synthesis", everything=True).table
    assert view is not None
    assert {len(column) for column in view.columns} == {len(found.designs)}
    people = synthesis_document(found, "synthesis").table
    assert people is not None
    for header, column in zip(view.headers, view.columns, strict=True):
        if header.endswith("[m]"):
            drawn = people.columns[people.headers.index(header.replace("[m]", "[mm]"))]
            assert list(drawn) == pytest.approx([1e3 * value for value in column])
    assert len(synthesis_summary(found, "synthesis").facts) == 1 + len(found.best.sizes) + len(found.best.checks)


@pytest.mark.parametrize(("name", "unit"), [("crank-rocker", "rad"), ("slider-crank", "m")])
def test_mean_speeds_have_the_unit_of_the_stroke(name: str, unit: str) -> None:
    found = solved(name)
    values = payload(synthesis_document(found, "synthesis"))
    symbol = "omega" if unit == "rad" else "v"
    assert found.best.times is not None
    assert values[f"{symbol}_p[{unit}/s]"] == found.best.times.working_speed
    assert values[f"{symbol}_mean[{unit}/s]"] == pytest.approx(2 * found.best.times.stroke / found.best.times.period)


@pytest.mark.slow
def test_the_sense_of_the_crank_is_told() -> None:
    found = solved("motion")
    document = synthesis_document(found, "synthesis")
    (text,) = (fact.text for fact in document.facts if fact.label == "crank turns")
    assert found.best.precision is not None
    falling = found.best.precision.crank[1] < found.best.precision.crank[0]
    assert text.startswith("clockwise" if falling else "counter-clockwise")
    assert payload(document)["sense"] == (-1 if falling else 1)


@pytest.mark.slow
def test_the_stored_result_is_the_computed_one(tmp_path: Path) -> None:
    for name in ("slotted-link", "function", "motion"):
        spec = load_spec(CONFIGS / f"synth-{name}.toml")
        first, second = (run(spec, target="synthesis", out=tmp_path / name).results["synthesis"] for _ in range(2))
        assert [design.spec for design in first.designs] == [design.spec for design in second.designs]
        assert first.best.merits == second.best.merits
        if first.best.precision is not None:
            assert np.array_equal(first.best.precision.crank, second.best.precision.crank)


def test_command_writes_a_spec_that_the_others_run(tmp_path: Path) -> None:
    runner, ready = CliRunner(), tmp_path / "ready.toml"
    spec = str(CONFIGS / "synth-crank-rocker.toml")
    done = runner.invoke(app, ["synth", spec, "--no-store", "-q", "--choose", "2", "--spec", str(ready)])
    assert done.exit_code == 0, done.output
    assert "2 of 2" in done.output
    ready_made = parse_spec(solved("crank-rocker").designs[1].spec)
    assert load_spec(ready).linkage == ready_made.linkage
    assert runner.invoke(app, ["check", str(ready)]).exit_code == 0
    shown = runner.invoke(app, ["kinematics", str(ready), "--no-store", "-q", "--plan", "--format", "json"])
    plan = json.loads(shown.output[shown.output.index("{") :])
    assert plan["K"] == pytest.approx(1.2, rel=1e-9)
    assert plan["stroke[deg]"] == pytest.approx(40, rel=1e-9)
    refused = runner.invoke(app, ["synth", spec, "--no-store", "-q", "--choose", "9"])
    assert refused.exit_code != 0
    picture = tmp_path / "picture.svg"
    assert runner.invoke(app, ["plot", spec, "synthesis", "-o", str(picture), "-q"]).exit_code == 0
    assert picture.stat().st_size > 10_000


def test_plan_goes_with_no_other_table() -> None:
    spec = str(CONFIGS / "crank-slider.toml")
    for flag in ("--study", "--dimensionless"):
        assert CliRunner().invoke(app, ["kinematics", spec, "--no-store", "--plan", flag]).exit_code != 0


def test_plan_of_a_link_that_never_reverses() -> None:
    spec = load_spec(CONFIGS / "slotted-link.toml")
    plan = tmmcalc.position_plan(to_linkage(spec.linkage), tmmcalc.solve_kinematics(spec))
    assert set(plan.strokes) == {""}
    assert len(plan.labels) == 24
    table = plan_document(plan, "plan").table
    assert table is not None
    assert list(table.columns[3]) == pytest.approx(np.degrees(plan.value))


def test_picture_shows_both_extremes_with_dimensions() -> None:
    found = solved("slider-crank")
    mechanism = to_linkage(parse_spec(found.best.spec).linkage)
    drawing = synthesis_drawing(mechanism, found)
    stroke, *_ = [shape.text for shape in drawing.shapes if isinstance(shape, Dimension)]
    texts = [*written(drawing), *(shape.text for shape in drawing.shapes if isinstance(shape, Dimension))]
    assert stroke.startswith("$S$ = 200")
    for symbol in "rle":
        assert any(text.startswith(f"${symbol}$ = {1e3 * found.best.size(symbol):.2f}"[:9]) for text in texts), symbol
    assert any(text.startswith(("6'", "12'")) for text in texts)  # the second extreme


@pytest.mark.slow
def test_picture_marks_the_wanted_points() -> None:
    found = solved("motion")
    mechanism = to_linkage(parse_spec(found.best.spec).linkage)
    drawing = synthesis_drawing(mechanism, found)
    (board,) = drawing.fields
    assert {"1", "2", "3", "4"} <= set(written(drawing))
    precision = found.best.precision
    assert precision is not None
    middles = [complex(np.mean(line)) for line in curves(board, MARK) if len(line) == 2]
    for point in precision.points:
        assert min(abs(middle - point) for middle in middles) < 1e-12


@pytest.mark.slow
def test_picture_of_a_function_shows_its_error() -> None:
    found = solved("function")
    mechanism = to_linkage(parse_spec(found.best.spec).linkage)
    below = diagram(synthesis_drawing(mechanism, found), "error, °")
    precision = found.best.precision
    assert precision is not None
    (curve,) = curves(below, CURVES[0])
    assert len(curve) == len(precision.fine)
    assert np.max(np.abs(curve.imag)) == pytest.approx(math.degrees(np.max(np.abs(precision.error))))
