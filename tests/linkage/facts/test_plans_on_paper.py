"""Plans, lever and scheme read back from paper: lengths times scales are what was computed."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from paper import inside, named_place, of_words
from sparing import sparing

import tmmcalc
from linkage.scenes import CONFIGS
from tmmcalc.core.plane import cross
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.pictures.course import statics_of
from tmmcalc.linkage.pictures.kinematics import kinematics_drawing
from tmmcalc.linkage.pictures.lever import draw_lever
from tmmcalc.linkage.pictures.pieces import of_forces, of_kinematics
from tmmcalc.linkage.pictures.plans import plans_of
from tmmcalc.linkage.pictures.vectors import SPECK, designation, drawn_vectors
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.pens import FORCES, THICK, VECTORS
from tmmcalc.report.drawing.scales import ENLARGEMENTS, MM, REDUCTIONS, STEPS, length_scale, standard_scale
from tmmcalc.report.drawing.shapes import Area, Dimension, Drawing, Stroke
from tmmcalc.report.language import speaking
from tmmcalc.report.sheets.piece import Piece

MOVING = ["shaper", "slotted-link", "class-three", "class-four", "four-dyads", "hydraulic-lift", "engine-compressor"]
LOADED = ["shaper", "press", "geared-press", "class-four", "scissor-lift", "hydraulic-lift"]


@cache
def solved(config: str) -> tuple[Any, Kinematics]:
    spec = tmmcalc.load_spec(Path(CONFIGS) / f"{config}.toml", ["mechanism.grid.positions=12"])
    return spec, tmmcalc.solve_kinematics(spec)


@cache
def loaded(config: str) -> tuple[Any, Kinematics, Forces]:
    return *solved(config), tmmcalc.solve_forces(solved(config)[0])


def arrows(drawing: Drawing, board: Board, layers: set[str]) -> list[tuple[complex, complex]]:
    """Arrows on a board from tail to tip, as data: a stroke and the head that goes on from it."""
    strokes = [s for s in drawing.shapes if isinstance(s, Stroke) and s.pen.layer in layers and len(s.points) == 2]
    heads = [s for s in drawing.shapes if isinstance(s, Area) and s.pen is not None and s.pen.layer in layers]
    found = []
    for head in heads:
        tip, back = complex(head.points[0]), complex(head.points[1] + head.points[2]) / 2
        own = [s for s in strokes if s.pen.layer == head.pen.layer and _goes_on(s, tip, back)]
        tail = complex(own[0].points[0])
        if inside(np.array([tail, tip]), board.box):
            found.append((board.data(tail), board.data(tip)))
    return found


def _goes_on(stroke: Stroke, tip: complex, back: complex) -> bool:
    end, e = complex(stroke.points[1]), (tip - back) / abs(tip - back)
    return abs(end - (tip - 0.8 * abs(tip - back) * e)) < 1e-9


@sparing("config", MOVING, every=4)
def test_segments_times_the_scale_are_velocities_and_accelerations(config: str) -> None:
    spec, result = solved(config)
    mechanism, rows = to_linkage(spec.linkage), [3, 8]
    drawing = kinematics_drawing(mechanism, result, None, rows)
    assert drawing.height == pytest.approx(3 * 210)
    boards = [field for field in drawing.fields[-4:] if isinstance(field, Board)]
    plans = plans_of(mechanism, result, rows)
    polygons = [polygon for plan in plans for polygon in (plan.velocity, plan.acceleration)]
    layers = {pen.layer for pen in VECTORS.values()}
    for board, polygon in zip(boards, polygons, strict=True):
        size = max(map(abs, polygon.vertices.values()))
        found = arrows(drawing, board, layers)
        wanted = [(polygon.vertices[v.tail], polygon.vertices[v.head]) for v in drawn_vectors(polygon)]
        assert len(found) == len(wanted)
        for ends in wanted:
            assert min(abs(a - ends[0]) + abs(b - ends[1]) for a, b in found) < 1e-9 * size
    assert boards[0].mu == boards[2].mu
    assert boards[1].mu == boards[3].mu


@pytest.mark.parametrize("config", MOVING)
def test_every_vector_is_named_beside_its_segment(config: str) -> None:
    spec, result = solved(config)
    mechanism = to_linkage(spec.linkage)
    drawing = kinematics_drawing(mechanism, result, None, [3])
    (plan,) = plans_of(mechanism, result, [3])
    for board, polygon, letter in zip(drawing.fields[-2:], (plan.velocity, plan.acceleration), "va", strict=True):
        here = [w for w in of_words(drawing) if w.clear and inside(np.array([w.at]), board.box)]
        for vector in drawn_vectors(polygon):
            tail, value = polygon.vertices[vector.tail], polygon.value(vector)
            if abs(value) < SPECK * board.mu:
                continue
            said = [w for w in here if w.text == designation(vector, letter)]
            assert said, (vector, letter)
            places = [board.data(named_place(drawing, words)) for words in said]
            away = [abs(at - tail - min(max(((at - tail) / value).real, 0), 1) * value) for at in places]
            assert min(away) < 8.0 * board.mu


def test_points_of_the_shaper_against_the_result() -> None:
    """pd and πd are the velocity and acceleration of the ram, whose column the kinematics stage gives."""
    spec, result = solved("shaper")
    drawing = kinematics_drawing(to_linkage(spec.linkage), result, None, [4])
    d = result.trace.point_names.index("D")
    v, a = result.in_time(result.trace.dr, result.trace.ddr)
    for board, values in zip(drawing.fields[-2:], (v, a), strict=True):
        ends = arrows(drawing, board, {VECTORS["absolute"].layer})
        lengths = [abs(board.place(tip) - board.place(tail)) for tail, tip in ends]
        assert min(abs(length * board.mu - abs(values[d, 4])) for length in lengths) < 1e-9


def lever_of(config: str, row: int) -> tuple[Drawing, Board, Any, Forces]:
    spec, kinematics, forces = loaded(config)
    statics = statics_of(to_linkage(spec.linkage), to_loading(spec), kinematics)
    drawing = Drawing(420.0, 297.0)
    board, found = draw_lever(drawing, Box(10, 10, 410, 287), statics, kinematics, forces, row)
    return drawing, board, found, forces


@sparing("config", LOADED, every=4)
def test_forces_times_arms_read_from_the_drawn_lever_balance_the_drive(config: str) -> None:
    """The lines of the arrows alone are read: their moments about the pole are the powers of the force analysis."""
    _, kinematics, forces = loaded(config)
    drawing, board, found, _ = lever_of(config, 4)
    assert board.labels.faults == [] or len(board.labels.faults) < 0.1 * board.labels.count
    layers = {pen.layer: kind for kind, pen in FORCES.items()}
    drawn = []
    for kind in {force.kind for force in (*found.forces, *found.balancing)}:
        drawn += [(kind, *ends) for ends in arrows(drawing, board, {FORCES[kind].layer})]
    assert set(layers.values()) >= {kind for kind, *_ in drawn}
    moments = {"given": 0.0, "drive": 0.0}
    every = (*found.forces, *found.balancing)
    strongest = max(force.force for force in every)
    turned = {(force.name, force.link) for force in every if abs(force.moment) > 1e-9 * strongest}
    for force in every:
        e = np.exp(1j * math.radians(force.direction))
        tip = complex(force.x, force.y) * board.mu
        own = [
            cross(tail / board.mu, e)
            for kind, tail, head in drawn
            if kind == force.kind and abs((head - tail) / abs(head - tail) - e) < 1e-6 and _on_line(tip, tail, e, board)
        ]
        idle = force.point and (force.name, force.link) not in turned  # a couple on a link that does not turn
        if abs(tip) > 1.0 * board.mu and force.force > 1e-4 * strongest:
            assert bool(own) != bool(idle), force
        arm = own[0] if own else force.arm
        moments["drive" if force.kind == "drive" else "given"] += force.force * float(arm)
    drive = float(forces.drive[4])
    speed = kinematics.speed / board.mu  # of the input, in mm of the plan
    largest = max(abs(drive * speed), *(abs(force.moment) for force in found.forces))
    assert moments["given"] == pytest.approx(-drive * speed, abs=1e-6 * largest)
    assert moments["drive"] == pytest.approx(drive * speed, abs=1e-6 * largest)


def _on_line(tip: complex, tail: complex, e: complex, board: Board) -> bool:
    return abs(cross(tail - tip, e)) < 1e-6 * board.mu


@pytest.mark.parametrize("config", LOADED)
def test_arms_are_dimensions_from_the_pole_across_their_forces(config: str) -> None:
    drawing, board, found, _ = lever_of(config, 4)
    arms = [abs(force.arm) for force in (*found.forces, *found.balancing)]
    dimensions = [shape for shape in drawing.shapes if isinstance(shape, Dimension)]
    assert dimensions
    for each in dimensions:
        length = abs(each.second - each.first)
        assert each.first == board.place(0j)
        assert float(each.text) == pytest.approx(length, abs=0.005 + 1e-9)
        assert min(abs(length - arm) for arm in arms) < 1e-9


def pieces(config: str, stage: str) -> list[Piece]:
    spec, kinematics, *more = loaded(config) if stage == "forces" else solved(config)
    results = {"kinematics": kinematics, **({"forces": more[0]} if more else {})}
    order = Order(spec, results, {}, lambda name: None, lambda text: None)
    return list((of_forces if stage == "forces" else of_kinematics)(order))


def draw(piece: Piece, size: tuple[float, float] | None = None) -> Drawing:
    wide, high = size or piece.good
    drawing = Drawing(wide, high)
    piece.draw(drawing, Box(0.0, 0.0, wide, high))
    return drawing


def test_a_crank_of_200_mm_is_50_mm_long_at_1_to_4() -> None:
    scheme = pieces("shaper", "kinematics")[0]
    drawing = draw(scheme, (380.0, 380.0))
    assert any("(1:4)" in words.text for words in of_words(drawing))
    bars = [abs(s.points[1] - s.points[0]) for s in drawing.shapes if isinstance(s, Stroke) and s.pen == THICK]
    assert min(abs(bar - 50.0) for bar in bars) < 1e-9


@sparing("config", ["shaper", "class-three", "class-four", "scissor-lift", "geared-press", "press"], every=6)
@pytest.mark.parametrize("stage", ["kinematics", "forces"])
def test_pieces_draw_themselves_at_their_least_and_good_sizes(config: str, stage: str) -> None:
    for piece in pieces(config, stage):
        for size in (piece.least, piece.good):
            drawing = draw(piece, size)
            assert len(drawing.shapes) > 3, piece.heading
            for field in drawing.fields:
                assert inside(field.box.corners, Box(0.0, 0.0, *size)), piece.heading
        faults = [fault for field in drawing.fields for fault in field.labels.faults]
        count = sum(field.labels.count for field in drawing.fields)
        assert len(faults) <= 0.1 * count, (piece.heading, faults)


@pytest.mark.parametrize("stage", ["kinematics", "forces"])
def test_pieces_of_the_press_in_ukrainian_have_no_english_left(stage: str) -> None:
    with speaking("uk"):
        for piece in pieces("press", stage):
            assert any("а" <= letter <= "я" for letter in piece.heading.lower())
            for words in of_words(draw(piece)):
                plain = words.text.replace("RRP", "").replace("$", "")
                english = [w for w in plain.replace("\n", " ").split() if w.isascii() and w.isalpha() and len(w) > 3]
                assert english == [], words.text


@pytest.mark.parametrize("least", [1e-7, 0.0031, 0.7, 1.0, 12.0, 4.1e5])
def test_scales_are_of_the_standard_series(least: float) -> None:
    mu = standard_scale(least)
    assert mu >= least * (1 - 1e-9)
    assert any(mu / 10.0 ** math.floor(math.log10(mu)) == pytest.approx(step) for step in STEPS)
    lengths = length_scale(least)
    assert lengths >= least * (1 - 1e-9)
    series = [MM * size for size in REDUCTIONS] + [MM / size for size in ENLARGEMENTS]
    assert min(abs(lengths / each - 1) for each in series) < 1e-9 or lengths == standard_scale(least)


@pytest.mark.parametrize("config", ["shaper", "class-three", "hydraulic-lift"])
@pytest.mark.parametrize("size", ["least", "good"])
def test_diagrams_on_a_sheet_have_the_scale_factors_that_are_written(config: str, size: str) -> None:
    """Lengths on paper times the written factors: the range of the input, the extremes of the output."""
    _, result = solved(config)
    found = next(piece for piece in pieces(config, "kinematics") if piece.heading.startswith("Diagrams"))
    drawing = draw(found, getattr(found, size))
    (told,) = [words.text for words in of_words(drawing) if words.text.count("μ_") == 4]
    along, *up = [float(part.partition(" = ")[2].partition(" ")[0]) for part in told.split(",   ")]
    assert [along, *up] == pytest.approx([standard_scale(mu) for mu in (along, *up)])
    span = abs(float(np.degrees(result.phi[-1]) if result.turns else 1e3 * result.phi[-1]))
    (summary,) = result.summaries
    angular = found.heading.startswith("Diagrams of angles")
    for field, mu, ends in zip(drawing.fields, up, (None, summary.velocity, summary.acceleration), strict=True):
        drawn = [s.points for s in drawing.shapes if isinstance(s, Stroke) and inside(s.points, field.box)]
        (curve,) = [z for z in drawn if len(z) > 100]
        assert np.ptp(curve.real) * along == pytest.approx(span)
        heights = (curve.imag - field.place(0j).imag) * mu
        if ends is not None:
            assert [heights.min(), heights.max()] == pytest.approx(sorted(e.value for e in ends), rel=1e-3)
        else:
            turned = [centre.value for centre in summary.dead_centres]
            stroke = np.ptp(turned or result.s[0])  # without dead centres it goes one way from end to end
            assert np.ptp(heights) == pytest.approx(stroke * (180 / math.pi if angular else 1e3), rel=1e-3)
