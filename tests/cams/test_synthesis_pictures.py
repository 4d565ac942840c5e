"""The picture of the synthesis of a rocker: borders of the zone, what the pivot takes of it, angles without a limit."""

from math import radians

import numpy as np
import pytest
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits, Loads

pytest.importorskip("matplotlib")

from matplotlib.colors import to_hex
from matplotlib.text import Text

from tmmcalc.cams.pictures.cam_synthesis import synthesis_figure
from tmmcalc.cams.pictures.zone import LIMIT, PASSING, swept_of

PROGRAM = turn("sine", stroke=radians(30))
SPRING, BOTH = AngleLimits(radians(45), None), AngleLimits(radians(45), radians(45))
PIVOT = Loads(10.0, pivot_radius=0.02)
SCENES = {
    "given": task_of(PROGRAM, "oscillating", limits=SPRING, rocker=0.1, centres=0.1, start=radians(30), roller=0.01),
    "against": task_of(PROGRAM, "oscillating", limits=BOTH, rocker=0.1, assembly=-1, sense=-1),
    "pivot": task_of(PROGRAM, "oscillating", limits=BOTH, rocker=0.1, roller=0.005, loads=PIVOT),
}


def texts(figure):
    return [each.get_text() for each in figure.findobj(Text)]


def lines(figure, style):
    return [
        line
        for line in figure.axes[0].lines
        if to_hex(line.get_color()) == style["color"] and line.get_linewidth() == style["linewidth"]
    ]


@sparing("name", SCENES, every=3)
def test_both_borders_of_the_zone_have_their_line(name):
    task = SCENES[name]
    result = solve_synthesis(task)
    figure = synthesis_figure(task, result)
    assert len({text for text in texts(figure) if text.startswith("$K$")}) >= 2
    drawn = [np.diff(line.get_xydata(), axis=0)[0] for line in lines(figure, LIMIT) if len(line.get_xdata()) == 2]
    directions = {round(float(np.degrees(np.arctan2(y, x)) % 180), 3) for x, y in drawn}
    assert len(directions) >= 2


@sparing("name", SCENES, every=3)
def test_the_border_at_the_pivot_parts_what_passes_from_what_sweeps(name):
    """On the branch |OC| - r2 = l0 - r_A for the highest rocker; a place is inside the drawn area if it sweeps."""
    from matplotlib.path import Path

    task = SCENES[name]
    result = solve_synthesis(task)
    follower, room = result.follower, result.pivot
    branch, border = swept_of(task, result)
    u, spare = np.exp(1j * radians(30)), (follower.roller - room.pivot) / follower.rocker
    close = branch[np.abs(branch) < 50]
    np.testing.assert_allclose(np.abs(close - u) - np.abs(close), spare, atol=1e-10)
    area = Path(np.column_stack((border.real, border.imag)))
    x, y = np.meshgrid(np.linspace(-4, 4, 41), np.linspace(-4, 4, 41))
    over = np.abs(x + 1j * y - u) - np.abs(x + 1j * y) - spare
    clear = np.abs(over) > 0.02
    inside = area.contains_points(np.column_stack((x.ravel(), y.ravel()))).reshape(x.shape)
    assert np.array_equal(inside[clear], over[clear] > 0)
    assert lines(synthesis_figure(task, result), PASSING)


def test_the_pivot_of_a_groove_bounds_nothing():
    task = task_of(PROGRAM, "oscillating", limits=BOTH, rocker=0.1, closure="groove")
    result = solve_synthesis(task)
    assert swept_of(task, result) is None
    assert not any("passes the pivot" in text for text in texts(synthesis_figure(task, result)))


def test_an_angle_beside_no_limit_says_so():
    task = SCENES["given"]
    said = texts(synthesis_figure(task, solve_synthesis(task)))
    assert said.count("$|\\theta|$ max, return") == 1 + len(solve_synthesis(task).designs)
    assert sum("(not limited)" in text for text in said) == said.count("$|\\theta|$ max, return")
