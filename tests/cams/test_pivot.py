"""The cam and the pivot of its rocker: the largest radius against points of the profile, refusal, growth, remarks."""

from dataclasses import replace
from math import pi, radians, sqrt

import numpy as np
import pytest

from cams.turns import task_of, turn
from tmmcalc.cams.facts.cam_profile import document as profile_document
from tmmcalc.cams.facts.cam_synthesis import document as synthesis_document
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pivot import highest, pivot_room
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.task import AngleLimits, Loads
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError

PROGRAM = turn("sine", stroke=radians(30))
SIZES = {"centres": 0.1, "rocker": 0.1}
LIMITS = AngleLimits(radians(45), None)


def follower_at(start, roller=0.01):
    return Follower("oscillating", radians(start), roller=roller, **SIZES)


def task(**asked):
    return task_of(PROGRAM, "oscillating", limits=LIMITS, **asked)


@pytest.mark.parametrize("start", [30, 45])
@pytest.mark.parametrize("assembly", [1, -1])
def test_the_largest_radius_is_that_of_the_drawn_profile(start, assembly):
    follower = replace(follower_at(start), assembly=assembly)
    room = pivot_room(task(), follower)
    drawn = np.abs(Rim(follower, PROGRAM).at(np.linspace(0, 2 * pi, 7200)).offset(follower.roller))
    assert room.radius == pytest.approx(drawn.max(), rel=1e-9)
    assert room.phi == pytest.approx(radians(60), abs=1e-12)


def test_a_cam_through_the_pivot_is_refused_with_its_place():
    follower = follower_at(60)
    with pytest.raises(NoSolutionError, match=r"sweeps over the rocker's pivot: .*131\.421 mm .*phi = 60 deg") as fault:
        solve_profile(task(), follower)
    assert fault.value.value == pytest.approx(0.1 * sqrt(2) - 0.01, rel=1e-12)
    assert fault.value.limit == 0.1
    assert "centre_distance" in fault.value.remedy
    found = solve_profile(task(report_faults=True), follower)
    assert any(note.startswith("warning: the cam sweeps over") for note in found.remarks)
    assert found.pivot.clearance == pytest.approx(0.11 - 0.1 * sqrt(2), rel=1e-12)
    assert "swept over" in next(f.text for f in profile_document(found, "").facts if f.label == "rocker's pivot")
    assert from_record(type(found), to_record(found)).pivot == found.pivot


def test_the_radius_of_the_pivot_counts():
    follower = follower_at(30)  # top of the pitch curve at l0: 10 mm are left
    free = solve_profile(task(), follower)
    assert free.pivot.clearance == pytest.approx(0.01, rel=1e-9)
    assert "10 mm left" in next(f.text for f in profile_document(free, "").facts if f.label == "rocker's pivot")
    with pytest.raises(NoSolutionError, match="less its radius of 12 mm"):
        solve_profile(replace(task(), loads=Loads(10.0, pivot_radius=0.012)), follower)


def test_the_disc_of_a_groove_may_reach_beyond_the_pivot():
    """The rocker is beside it; what counts is the second wall, and it is told where the pivot has to be."""
    follower = follower_at(30, 0.005)  # top of the pitch curve at l0
    found = solve_profile(task(closure="groove"), follower)
    drawn = np.abs(Rim(follower, PROGRAM).at(np.linspace(0, 2 * pi, 7200)).offset(-follower.roller))
    assert found.pivot.radius == pytest.approx(drawn.max(), rel=1e-9)
    assert found.pivot.clearance == pytest.approx(-0.005, rel=1e-9)
    (note,) = [each for each in found.remarks if "pivot" in each]
    assert note.startswith("note: the second wall reaches beyond the rocker's pivot: it reaches 105 mm")
    assert "beside the disc" in note
    told = next(f.text for f in profile_document(found, "").facts if f.label == "rocker's pivot")
    assert "beside the disc, which reaches 5 mm beyond its centre" in told
    near = solve_profile(task(closure="groove"), follower_at(15, 0.003))
    assert not any("pivot" in each for each in near.remarks)
    assert near.pivot.clearance > 0


def test_others_have_no_pivot():
    assert pivot_room(task_of(turn()), Follower("translating", 0.05)) is None


def test_given_sizes_are_warned_of():
    found = solve_synthesis(task(start=radians(60), roller=0.01, **SIZES))
    assert any("sweeps over the rocker's pivot" in note for note in found.notes)
    assert "rocker's pivot" in {fact.label for fact in synthesis_document(found, "").facts}
    assert not any("sweeps over" in n for n in solve_synthesis(task(start=radians(30), roller=0.01, **SIZES)).notes)


def test_highest_is_the_top_of_the_law():
    y, phi = highest(PROGRAM)
    assert (y, phi) == (pytest.approx(radians(30), rel=1e-12), pytest.approx(radians(60), abs=1e-12))
