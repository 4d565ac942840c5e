"""The pictures of synthesis and pressure angle: what is drawn against the record."""

from math import radians

import numpy as np
import pytest
from sparing import sparing

pytest.importorskip("matplotlib")

from drawing import draw_cam
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon

from cams.turns import task_of, turn
from tmmcalc.cams.pictures.cam_pressure import pressure_figure
from tmmcalc.cams.pictures.cam_synthesis import synthesis_figure
from tmmcalc.cams.pictures.zone import LIMIT, ZONE
from tmmcalc.cams.pressure.solve import solve_pressure
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits

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


def limit_lines(axes):
    return [line for line in axes.lines if line.get_color() == LIMIT["color"] and len(line.get_xdata()) == 2]


def test_tangents_touch_the_curve_and_meet_in_the_axis():
    task = TASKS["translating"]
    found = solve_synthesis(task)
    axes = synthesis_figure(task, found).axes[0]
    o = -1e3 * complex(found.follower.start, found.follower.offset)
    curve = max(axes.lines, key=lambda line: len(line.get_xdata()))
    points = np.asarray(curve.get_xdata()) + 1j * np.asarray(curve.get_ydata())
    distances = []
    for line in limit_lines(axes):
        a, b = (complex(x, y) for x, y in zip(line.get_xdata(), line.get_ydata(), strict=True))
        along = (b - a) / abs(b - a)
        distances.append(abs((np.conj(along) * (o - a)).imag))
        side = (np.conj(along) * (points - a)).imag
        assert min(side.max(), -side.min()) < 1e-2 * np.ptp(points.imag)  # all of the curve on one side
    assert sorted(distances)[1] < 1e-9


@sparing("name", ["oscillating", "mirrored"], every=2)
def test_lines_of_the_rocker_meet_in_the_axis(name):
    task = TASKS[name]
    axes = synthesis_figure(task, solve_synthesis(task)).axes[0]
    lines = limit_lines(axes)
    assert len(lines) == 2
    for line in lines:
        a, b = (complex(x, y) for x, y in zip(line.get_xdata(), line.get_ydata(), strict=True))
        assert abs((np.conj(b - a) * (0 - a)).imag) / abs(b - a) < 1e-12  # O is the origin
    zone = next(p for p in axes.patches if isinstance(p, Polygon) and p.get_hatch() == ZONE["hatch"])
    corners = zone.get_xy()
    assert np.min(np.hypot(*corners.T)) < 1e-12


def test_the_angle_and_its_limits():
    task = TASKS["exceeded"]
    found = solve_pressure(task, solve_synthesis(task).follower)
    axes = pressure_figure(task, found).axes[0]
    curve = max(axes.lines, key=lambda line: len(line.get_xdata()))
    assert np.max(curve.get_ydata()) == pytest.approx(np.degrees(found.rise.largest.value), abs=0.5)
    levels = {round(float(line.get_ydata()[0]), 9) for line in limit_lines(axes) if isinstance(line, Line2D)}
    assert levels == {32.0, -32.0, 40.0, -40.0}
    assert len(axes.collections) == len(found.rise.exceeded) + len(found.back.exceeded) > 0
