"""A pinion in a ring from the task to every size."""

from dataclasses import replace
from math import cos, hypot, pi, radians, sin, sqrt

import numpy as np
import pytest

from gears.meshing.pairs import MM, M, lengths, plain_everywhere
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask


def inside(z1: int, z2: int, beta_deg: float = 0.0, **more) -> PairTask:
    return PairTask((z1, z2), **({"module": M, "kind": "internal", "helix": radians(beta_deg)} | more))


TASKS = [
    inside(20, 60, strategy="zero"),
    inside(20, 60, 15, strategy="given", shifts=(0.3, 0.1), face_width=0.04),
    inside(25, 71, strategy="given_aw", distance=0.1145),
    inside(30, 90, strategy="equal_shift", cutter=Cutter(20, 0.1, 0.2)),
    inside(18, 80, strategy="balanced"),
]


@pytest.mark.parametrize("task", TASKS)
def test_identities(task):
    found = solve_pair(task)
    (one, two), line = found.sizes, found.line
    assert found.verdict != "fail"
    assert two.kind == "ring"
    assert two.operating - one.operating == pytest.approx(found.distance, rel=1e-13)
    assert two.base - one.base == pytest.approx(found.distance * cos(found.angle_w), rel=1e-13)
    assert line.length == pytest.approx(-found.distance * sin(found.angle_w), rel=1e-13)
    # A2 lies on the tip circle of the ring, A1 on that of the pinion, both seen from their own base circles
    assert hypot(two.base, line.start - line.length) == pytest.approx(two.tip, rel=1e-13)
    assert hypot(one.base, line.end) == pytest.approx(one.tip, rel=1e-13)
    pitch = pi * M / cos(task.helix) * cos(found.angle_t)
    assert found.contact_ratio == pytest.approx((line.end - line.start) / pitch, rel=1e-12)
    assert found.shortened == pytest.approx((line.ends - line.begins) / pitch, rel=1e-12)
    assert one.active == pytest.approx(hypot(one.base, line.begins), rel=1e-13)
    assert two.active == pytest.approx(hypot(two.base, line.ends - line.length), rel=1e-13)
    assert one.form <= one.active * (1 + 1e-14)
    assert two.active <= two.form * (1 + 1e-14) <= two.root * (1 + 1e-13)
    assert found.clearances[0] == pytest.approx(two.tip - found.distance - one.root, rel=1e-9)
    # no backlash: the arcs of both teeth fill the pitch
    arcs = [next(row for row in each.chords if row.name == "operating") for each in found.measures]
    assert sum(row.arc for row in arcs) == pytest.approx(
        2 * pi * one.operating / one.teeth * cos(arcs[0].helix), rel=1e-12
    )
    table = found.sliding
    at = int(np.argmin(np.abs(table.along)))
    assert max(abs(table.theta1[at]), abs(table.theta2[at])) < 1e-13
    assert np.array_equal(table.active, (table.rho1 >= line.begins) & (table.rho1 <= line.ends))
    assert table.rho1[0] > 0


def test_zero_pair_by_hand():
    found = solve_pair(TASKS[0])
    assert found.shifts == (0.0, 0.0)
    assert found.distance == pytest.approx(0.1, rel=1e-14)
    assert [w.reference for w in found.sizes] == pytest.approx([0.05, 0.15])
    assert found.sizes[1].root == pytest.approx(0.15 + 1.25 * M)
    # the ring's tip is drawn back to where the involute of the pinion begins
    limit = 10 * sin(radians(20)) - 1 / sin(radians(20))
    reach = 20 * sin(radians(20)) + limit
    assert found.sizes[1].tip == pytest.approx(M * hypot(30 * cos(radians(20)), reach), rel=1e-13)
    assert f"{1000 * (found.sizes[1].tip - 0.145):.6g} mm shorter" in found.note
    assert found.measures[1].spans == ()
    assert found.measures[1].span_teeth is None
    assert found.measures[1].balls.on_flank


def test_distance_and_shifts_are_inverse():
    found = solve_pair(inside(25, 71, strategy="given_aw", distance=0.1145))
    assert found.distance == 0.1145
    back = solve_pair(inside(25, 71, strategy="given", shifts=found.shifts))
    assert back.distance == pytest.approx(0.1145, rel=1e-14)
    fixed = solve_pair(inside(25, 71, strategy="given_aw", distance=0.1145, shifts=(None, found.shifts[1])))
    assert fixed.shifts == pytest.approx(found.shifts, abs=1e-14)


@pytest.mark.parametrize("task", TASKS)
def test_plain_and_scaled(task):
    found = solve_pair(task)
    plain_everywhere(found)
    back = from_record(MeshPair, to_record(found))
    assert repr(back) == repr(found)
    sized = {
        "module": 0.2 * M,
        "distance": None if task.distance is None else 0.2 * task.distance,
        "face_width": None if task.face_width is None else 0.2 * task.face_width,
    }
    small, large = lengths(solve_pair(replace(task, **sized))), lengths(found)
    assert small.keys() == large.keys()
    for key, value in large.items():
        assert small[key] == pytest.approx(0.2 * value, rel=1e-8, abs=1e-12 * M), key


def test_refusals():
    with pytest.raises(NoSolutionError, match=r"pair z = 30/32 \(ring\).*collide(?s:.*)nearest admissible"):
        solve_pair(inside(30, 32, strategy="zero"))
    told = solve_pair(inside(30, 32, strategy="zero", refuse=False))
    assert told.verdict == "fail"
    assert told.broken
    assert told.nearest is not None
    better = solve_pair(inside(30, 32, strategy="given", shifts=told.nearest))
    assert better.verdict != "fail"
    with pytest.raises(NoSolutionError, match="does not fit into a ring"):
        solve_pair(inside(30, 30, strategy="zero"))
    least = (60 - 20) / 2 * 5 * cos(radians(20))
    with pytest.raises(
        NoSolutionError, match=f"90 mm does not exceed the difference of the base radii, {least:.6g} mm"
    ):
        solve_pair(inside(20, 60, strategy="given_aw", distance=0.09))
    with pytest.raises(UsageError, match="no strategy"):
        solve_pair(inside(20, 60, strategy="max_contact_ratio"))


def test_undercut_of_the_pinion():
    task = inside(10, 60, strategy="given", shifts=(0.2, 0.0))
    assert next(c for c in solve_pair(task).checks if c.name == "undercut").verdict == "warn"
    with pytest.raises(NoSolutionError, match=r"undercut.*\n.*0.415111"):
        solve_pair(replace(task, limits=QualityLimits(undercut=False)))


def test_tips_as_asked():
    usual = solve_pair(TASKS[1])
    tips = usual.sizes[0].tip - 0.3 * MM, usual.sizes[1].tip + 0.4 * MM
    found = solve_pair(replace(TASKS[1], tips=tips))
    assert (found.sizes[0].tip, found.sizes[1].tip) == pytest.approx(tips, rel=1e-15)
    assert found.line.end == pytest.approx(sqrt(tips[0] ** 2 - found.sizes[0].base ** 2), rel=1e-13)
    assert found.clearances[0] == pytest.approx(usual.clearances[0] + 0.4 * MM, rel=1e-9)
    assert found.contact_ratio < usual.contact_ratio
    with pytest.raises(NoSolutionError, match=r"(?s)fillet.*tip diameters by the rule"):
        solve_pair(replace(TASKS[1], tips=(None, usual.sizes[1].tip - 2 * MM)))
    low = solve_pair(replace(TASKS[1], tips=(None, usual.sizes[1].base * 0.99), refuse=False))
    plain_everywhere(low)
    assert low.verdict == "fail"


def test_circle_and_ellipse_differ_only_where_the_pinion_is_undercut():
    for x1, same in ((0.3, True), (-0.2, False)):
        task = inside(14, 60, 25, strategy="given", shifts=(x1, 0.1), refuse=False)
        tips = [solve_pair(replace(task, fillet=shape)).sizes[1].tip for shape in ("ellipse", "circle")]
        assert (abs(tips[0] - tips[1]) < 1e-15) == same
        assert all(c.verdict != "fail" for c in solve_pair(replace(task, fillet="circle")).checks if "fillet" in c.name)
