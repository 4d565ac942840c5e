"""Laws of one's own that leave 0 to h: the true range of y decides whether a follower is free; faults are counted."""

from math import degrees

import numpy as np
import pytest

from cams.tables.camscenes import cam
from cams.turns import task_of
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pressure.angle import check_reach
from tmmcalc.cams.pressure.solve import solve_pressure
from tmmcalc.cams.profile import solve_profile
from tmmcalc.core.errors import NoSolutionError, SingularityError

POINTS = "law = { points = [[0, 0], [0.3, 0.9], [0.35, 0.1], [1, 1]] }\n"
MOTION = 'rise = "60 deg"\nhigh_dwell = "30 deg"\nreturn_angle = "90 deg"\n' + POINTS


def lowest(program):
    phi = np.linspace(0, np.pi / 2, 40_001)  # the rise: the return runs through the same again
    y = program.at(phi)[0]
    return float(y.min()), float(phi[y.argmin()]), float(y.max())


def test_a_roller_across_the_level_of_the_axis_is_refused():
    task = cam(motion=MOTION)
    low, phi, _ = lowest(task.program)
    assert low < -0.045
    with pytest.raises(SingularityError, match="phi = ") as fault:
        solve_pressure(task, Follower("translating", 0.045))
    assert fault.value.value == pytest.approx(0.045 + low, rel=1e-5)
    assert f"phi = {degrees(phi):.2f}" in str(fault.value)
    check_reach(task.program, Follower("translating", -low + 1e-6))
    with pytest.raises(SingularityError):
        check_reach(task.program, Follower("translating", -low - 1e-6))


def test_a_rocker_across_the_line_of_centres_is_refused_at_both_ends():
    program = cam(kind="RK", motion=MOTION).program
    low, _, high = lowest(program)
    sizes = {"centres": 0.1, "rocker": 0.09}
    for start, good in ((-low + 1e-4, True), (-low - 1e-4, False)):
        follower = Follower("oscillating", start, **sizes)
        if good:
            check_reach(program, follower)
            continue
        with pytest.raises(SingularityError, match="line of centres"):
            check_reach(program, follower)
    with pytest.raises(SingularityError, match="line of centres"):
        check_reach(program, Follower("oscillating", np.pi - high + 1e-4, **sizes))


@pytest.mark.slow
def test_of_many_faults_the_worst_is_named_and_the_rest_counted():
    program = cam(motion=MOTION).program
    follower = Follower("translating", 0.08, roller=0.06)
    wall = solve_profile(task_of(program, report_faults=True), follower).working
    assert len(wall.crossings) > 2
    with pytest.raises(NoSolutionError) as fault:
        solve_profile(task_of(program), follower)
    text = str(fault.value)
    turns = [min(each.second - each.first, 2 * np.pi - each.second + each.first) for each in wall.crossings]
    worst = wall.crossings[int(np.argmax(turns))]
    assert f"{degrees(worst.first):.6g} and {degrees(worst.second):.6g} deg" in text
    assert f"and at {len(turns) - 1} lesser places" in text
    assert text.count(" deg") < 6
