"""The pictures of synthesis and pressure angle: what is drawn against the record."""

from math import radians

import numpy as np
import pytest
from drawing import draw_cam
from paper import curves, data, diagram, frames, on_sheet
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.pictures.cam_pressure import EXCEEDED, pressure_drawing
from tmmcalc.cams.pictures.cam_synthesis import synthesis_drawing
from tmmcalc.cams.pictures.zone import HATCH, LIMIT
from tmmcalc.cams.pressure.solve import solve_pressure
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Area, Hatching

LIMITS = AngleLimits(radians(32), radians(40))
TASKS = {
    "translating": task_of(turn("shun", "sine", back=90), limits=LIMITS, offset=None),
    "oscillating": task_of(turn("sine", back=90, stroke=0.3), "oscillating", limits=LIMITS, rocker=0.1),
    "mirrored": task_of(turn("sine", stroke=0.3), "oscillating", limits=LIMITS, rocker=0.1, sense=-1),
    "flat": task_of(turn(), "flat", limits=LIMITS, margin=0.002),
    "exceeded": task_of(turn(), limits=LIMITS, start=0.03),
}


@pytest.mark.slow
@sparing("name", TASKS, every=5)
def test_files(name, tmp_path):
    task = TASKS[name]
    found = solve_synthesis(task)
    for file in (tmp_path / "synthesis.svg", tmp_path / "pressure.svg"):
        if file.stem == "synthesis":
            draw_cam("cam_synthesis", task, found, file)
        else:
            draw_cam("cam_pressure", task, solve_pressure(task, found.follower), file)
        assert file.stat().st_size > 10_000


def limit_lines(board):
    return [line for line in curves(board, LIMIT) if len(line) == 2]


def test_tangents_touch_the_curve_and_meet_in_the_axis():
    task = TASKS["translating"]
    found = solve_synthesis(task)
    drawing = synthesis_drawing(task, found)
    assert not on_sheet(drawing)
    (board,) = frames(drawing)
    o = -1e3 * complex(found.follower.start, found.follower.offset)
    pens = [CURVES[k]._replace(width=0.6) for k in (0, 2)]
    points = np.concatenate([line for pen in pens for line in curves(board, pen)])
    distances = []
    for a, b in limit_lines(board):
        along = (b - a) / abs(b - a)
        distances.append(abs((np.conj(along) * (o - a)).imag))
        side = (np.conj(along) * (points - a)).imag
        assert min(side.max(), -side.min()) < 1e-2 * np.ptp(points.imag)  # all of the curve on one side
    assert sorted(distances)[1] < 1e-9


@sparing("name", ["oscillating", "mirrored"], every=2)
def test_lines_of_the_rocker_meet_in_the_axis(name):
    task = TASKS[name]
    drawing = synthesis_drawing(task, solve_synthesis(task))
    (board,) = frames(drawing)
    lines = limit_lines(board)
    assert len(lines) == 2
    for a, b in lines:
        assert abs((np.conj(b - a) * (0 - a)).imag) / abs(b - a) < 1e-12  # O is the origin
    (zone,) = [each for each in drawing.shapes if isinstance(each, Hatching) and each.pen == HATCH]
    assert np.min(np.abs(data(board, zone.loops[0]))) < 1e-12


def test_the_angle_and_its_limits():
    task = TASKS["exceeded"]
    found = solve_pressure(task, solve_synthesis(task).follower)
    drawing = pressure_drawing(task, found)
    assert not on_sheet(drawing)
    field = diagram(drawing, "pressure angle $θ$, °")
    (curve,) = curves(field, CURVES[0])
    assert np.max(curve.imag) == pytest.approx(np.degrees(found.rise.largest.value), abs=0.5)
    levels = {round(float(line[0].imag), 9) for line in limit_lines(field)}
    assert levels == {32.0, -32.0, 40.0, -40.0}
    beyond = [each for each in drawing.shapes if isinstance(each, Area) and each.fill == EXCEEDED]
    assert len(beyond) == len(found.rise.exceeded) + len(found.back.exceeded) > 0
