"""The picture of the synthesis of a rocker: borders of the zone, what the pivot takes of it, angles without a limit."""

from math import radians

import numpy as np
from paper import curves, frames, written
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.pictures.cam_synthesis import synthesis_drawing
from tmmcalc.cams.pictures.zone import LIMIT, PASSING, swept_of
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits, Loads

PROGRAM = turn("sine", stroke=radians(30))
SPRING, BOTH = AngleLimits(radians(45), None), AngleLimits(radians(45), radians(45))
PIVOT = Loads(10.0, pivot_radius=0.02)
SCENES = {
    "given": task_of(PROGRAM, "oscillating", limits=SPRING, rocker=0.1, centres=0.1, start=radians(30), roller=0.01),
    "against": task_of(PROGRAM, "oscillating", limits=BOTH, rocker=0.1, assembly=-1, sense=-1),
    "pivot": task_of(PROGRAM, "oscillating", limits=BOTH, rocker=0.1, roller=0.005, loads=PIVOT),
}


def within(z, border):
    """Whether places lie in a polygon, by the turns that it makes around each of them."""
    from_here = border[:, None] - z.ravel()
    turns = np.angle(np.roll(from_here, -1, axis=0) / from_here).sum(axis=0) / (2 * np.pi)
    return (np.abs(turns) > 0.5).reshape(z.shape)


@sparing("name", SCENES, every=3)
def test_both_borders_of_the_zone_have_their_line(name):
    task = SCENES[name]
    result = solve_synthesis(task)
    drawing = synthesis_drawing(task, result)
    assert len({text for text in written(drawing) if text.startswith("$K$")}) >= 2
    (board,) = frames(drawing)
    drawn = [line[1] - line[0] for line in curves(board, LIMIT) if len(line) == 2]
    assert len({round(float(np.degrees(np.angle(along)) % 180), 3) for along in drawn}) >= 2


@sparing("name", SCENES, every=3)
def test_the_border_at_the_pivot_parts_what_passes_from_what_sweeps(name):
    """On the branch |OC| - r2 = l0 - r_A for the highest rocker; a place is inside the drawn area if it sweeps."""
    task = SCENES[name]
    result = solve_synthesis(task)
    follower, room = result.follower, result.pivot
    branch, border = swept_of(task, result)
    u, spare = np.exp(1j * radians(30)), (follower.roller - room.pivot) / follower.rocker
    close = branch[np.abs(branch) < 50]
    np.testing.assert_allclose(np.abs(close - u) - np.abs(close), spare, atol=1e-10)
    x, y = np.meshgrid(np.linspace(-4, 4, 41), np.linspace(-4, 4, 41))
    over = np.abs(x + 1j * y - u) - np.abs(x + 1j * y) - spare
    clear = np.abs(over) > 0.02
    inside = within(x + 1j * y, border)
    assert np.array_equal(inside[clear], over[clear] > 0)
    (board,) = frames(synthesis_drawing(task, result))
    assert curves(board, PASSING)


def test_the_pivot_of_a_groove_bounds_nothing():
    task = task_of(PROGRAM, "oscillating", limits=BOTH, rocker=0.1, closure="groove")
    result = solve_synthesis(task)
    assert swept_of(task, result) is None
    assert not any("passes the pivot" in text for text in written(synthesis_drawing(task, result)))


def test_an_angle_beside_no_limit_says_so():
    task = SCENES["given"]
    said = written(synthesis_drawing(task, solve_synthesis(task)))
    assert said.count("$|θ|$ max, return") == 1 + len(solve_synthesis(task).designs)
    assert sum("(not limited)" in text for text in said) == said.count("$|θ|$ max, return")
