"""Profiles of the wheels of a project against the swept tool, the worked cases, circles through their own points."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, radians, sin, tan
from typing import Any

import numpy as np
import pytest
from sparing import sparing

from gears.involute.profile.envelope import CASES, half_angles
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.internal.ring import Cutter, angle_of_shifts
from tmmcalc.gears.involute.profile.shaping import shaped_ring
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.meshing.members import Member, both, members
from tmmcalc.gears.meshing.meshoutlines import mesh_tracks
from tmmcalc.gears.meshing.outlines import Bow, Cubics, Line
from tmmcalc.gears.meshing.profiles import Profiles, WheelProfile
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.meshing.tooth import profile_columns, solve_profiles
from tmmcalc.rooms import STAGES

M = 0.005
SHAPED = Cutter(25, 0.05, 0.2)


def solved(
    teeth: tuple[int, int], shifts: tuple[float, float] = (0.0, 0.0), module: float = M, **more: Any
) -> MeshPair:
    return solve_pair(PairTask(teeth, module, strategy="given", shifts=shifts, refuse=False, **more))


def profiles(*pairs: MeshPair, points: int = 50, train: str = "") -> Profiles:
    return solve_profiles(Pairs(pairs, train, ()), points)


def of_part(wheel: WheelProfile, *names: str) -> np.ndarray:
    chosen = np.isin(wheel.part, names)
    return wheel.x[chosen] + 1j * wheel.y[chosen]


MESHES = [
    solved((13, 30), (0.25, 0.15), name="spur"),
    solved((10, 30), name="undercut"),
    solved((14, 27), (0.52, 0.31), name="helical", helix=radians(15)),
    solved((30, 40), (0.95, 0.0), name="far", fillet="circle"),
    solved((20, 60), (0.1, 0.1), name="ring", kind="internal"),
    solved((20, 60), (0.1, 0.1), name="shaped", kind="internal", cutter=SHAPED),
    solved((14, 0), (0.3, 0.0), name="rack", kind="rack", helix=0.3),
]


@pytest.mark.parametrize(
    ("teeth", "shift", "helix", "fillet"),
    [(10, 0.0, 0, "ellipse"), (13, 0.25, 0, "circle"), (14, 0.6, 15, "ellipse"), (14, 0.6, 15, "circle")],
)
def test_profile_is_what_the_rack_leaves(teeth: int, shift: float, helix: int, fillet: Any) -> None:
    found = profiles(solved((teeth, 40), (shift, 0.0), helix=radians(helix), fillet=fillet), points=12).wheels[0]
    places = of_part(found, "fillet", "involute")
    # the first point of the fillet lies on the root circle, where every angle of the space is swept
    places = places[np.abs(places) > found.root * (1 + 1e-12)]
    wheel = Wheel(teeth, shift, radians(helix))
    swept = half_angles(wheel, np.abs(places) / M, fillet)
    assert len(places) >= 22
    assert np.abs((np.angle(places) - pi / 2 - swept) * np.abs(places)).max() < 1e-9


@pytest.mark.parametrize(("name", "mate"), [("IG-S08", 40), ("IG-S11", 40)])
def test_worked_profiles(name: str, mate: int) -> None:
    data, expected = CASES[name]["inputs"], CASES[name]["expected"]
    pair = solved((data["z"], mate), (data["x"], 0.0), tips=(data["r_a"] * 1e-3, None))
    wheel = profiles(pair, points=4000).wheels[0]
    limit, root, tip, form = wheel.rolls
    assert (limit, root, tip) == pytest.approx([expected[key] for key in ("phi_L", "phi_D", "phi_A")], abs=6e-9)
    assert wheel.form * 1e3 == pytest.approx(expected["r_F"], abs=1e-6)
    assert wheel.undercut is (name == "IG-S08")
    assert (form > limit + 0.1) is wheel.undercut
    assert (wheel.tip * 1e3, wheel.root * 1e3) == pytest.approx((expected["r_a"], expected["r_f"]), abs=1e-6)
    places = of_part(wheel, "fillet", "involute")
    radii = np.array([row["radius"] for row in expected["flank"]]) * 1e-3
    angles = np.interp(radii, np.abs(places), np.angle(places) - pi / 2)
    assert angles == pytest.approx([row["half_tooth_angle_rad"] for row in expected["flank"]], abs=1e-6)


def test_profile_runs_from_the_middle_of_the_space_to_the_middle_of_the_tip() -> None:
    for wheel in profiles(*MESHES).wheels:
        places = wheel.x + 1j * wheel.y
        assert abs(places[-1].real) < 1e-15
        assert places[-1].imag == pytest.approx(wheel.tip, rel=1e-14)
        if wheel.kind == "rack":
            pitch = pi * M / cos(0.3)
            assert (places[0].real, places[0].imag) == pytest.approx((-pitch / 2, wheel.root), rel=1e-14)
        else:
            assert np.angle(places[0]) == pytest.approx(pi / 2 + pi / wheel.teeth, rel=1e-14)
            assert abs(places[0]) == pytest.approx(wheel.root, rel=1e-14)
        assert wheel.join < 1e-16
        # no part is left out: steps stay below what its number of points makes of the height
        assert np.abs(np.diff(places)).max() < 0.4 * M
        order = [name for k, name in enumerate(wheel.part.tolist()) if k == 0 or name != wheel.part[k - 1]]
        assert order == ["root", "fillet", "flank" if wheel.kind == "rack" else "involute", "tip"]


def test_radii_of_curvature_are_those_of_circles_through_the_points() -> None:
    for wheel in profiles(*MESHES, points=3000).wheels:
        # metal lies to the right of the way up a tooth that points outward, to the left where it points inward
        side = 1.0 if wheel.kind == "ring" else -1.0
        for name in ("root", "fillet", "involute", "tip"):
            places, radius = of_part(wheel, name), wheel.radius[wheel.part == name]
            if wheel.kind == "rack" and name != "fillet":
                assert not radius.any()
                continue
            places, radius = places[::60], radius[::60]
            area = (np.conj(places[1:-1] - places[:-2]) * (places[2:] - places[:-2])).imag / 2
            sides = np.abs(np.diff(places))
            circle = sides[1:] * sides[:-1] * np.abs(places[2:] - places[:-2]) / (4 * area)
            far = np.abs(radius[1:-1]) > 0.02 * M  # a circle through distant points tells nothing of a sharp bend
            assert (side * circle / radius[1:-1])[far] == pytest.approx(1.0, rel=6e-2)
            middle = np.median(side * circle / radius[1:-1])
            assert middle == pytest.approx(1.0, rel=2e-3)


def test_least_radius_of_the_fillet() -> None:
    for wheel in profiles(*MESHES, points=3000).wheels:
        sampled = np.abs(wheel.radius[wheel.part == "fillet"]).min()
        assert 0 < wheel.fillet_least_radius <= sampled * (1 + 1e-12)
        assert wheel.fillet_least_radius == pytest.approx(sampled, rel=1e-5)
    spur = profiles(MESHES[0]).wheels[1]
    assert spur.fillet_least_radius * 1e3 == pytest.approx(CASES["IG-S07"]["expected"]["table"][0]["R"], abs=1e-5)


def test_fillet_of_a_shaped_ring_is_the_envelope_of_the_rounding() -> None:
    pair = MESHES[5]
    ring = Member(pair, 1).ring
    flank = shaped_ring(ring, SHAPED, Member(pair, 1).tip)
    tool = Wheel(SHAPED.teeth, SHAPED.shift)
    _, distance = angle_of_shifts(tool, ring)
    # the centre of the rounding: on the parallel of the cutter's involute, one radius below its tip
    orbit = float(tool.plain_tip) + 0.25 - SHAPED.rounding
    arm = np.sqrt(orbit**2 - tool.base**2)
    polar = float(tool.half_angle) + float(involute(radians(20))) - (arm + SHAPED.rounding) / tool.base
    polar += np.arctan2(arm, tool.base)
    theta = np.linspace(flank.angle, pi / 2, 9)
    for place in flank.on_fillet(theta):
        low, high = -0.6, 0.6
        for _ in range(12):
            turn = np.linspace(low, high, 201)  # of the cutter, both counter-clockwise
            centre = (distance * 1j + orbit * 1j * np.exp(1j * (turn + polar))) * np.exp(-1j * turn * 25 / 60)
            away = np.abs(place - centre)
            best = int(np.argmin(away))
            low, high = turn[max(best - 1, 0)], turn[min(best + 1, 200)]
        assert away[best] == pytest.approx(SHAPED.rounding, abs=1e-12)
    assert flank.form == pytest.approx(ring.form, rel=1e-14)
    assert abs(flank.on_fillet(pi / 2)) == pytest.approx(ring.root, rel=1e-14)
    h = 1e-6
    rate = (flank.on_fillet(theta + h) - flank.on_fillet(theta - h)) / (2 * h)
    assert rate == pytest.approx(flank.on_fillet_rate(theta), abs=1e-8)


@pytest.mark.parametrize(
    ("cutter", "tip", "words"),
    [
        (Cutter(25, 0.0, 1.3), 29.0, "narrower than its rounding"),
        (Cutter(25, 0.0, 3.0), 29.0, "below its base circle"),
        (SHAPED, 31.0, "no involute is left"),
        (SHAPED, 28.0, "no involute is left"),
    ],
)
def test_cutters_that_do_not_exist(cutter: Cutter, tip: float, words: str) -> None:
    ring = replace(Member(MESHES[4], 1).ring, cutter=cutter)
    with pytest.raises(NoSolutionError, match=words) as caught:
        shaped_ring(ring, cutter, tip)
    assert caught.value.remedy


def test_rack_is_the_counterpart_of_the_tool() -> None:
    wheel = profiles(MESHES[6]).wheels[1]
    slope = tan(radians(20)) / cos(0.3)
    flank = of_part(wheel, "flank")
    assert -flank.real == pytest.approx(pi / 4 * M / cos(0.3) - flank.imag * slope, abs=1e-16)
    assert (flank[0].imag, flank[-1].imag) == pytest.approx((-M, M))
    # an ellipse whose half axes are the radius along the tooth and 1/cos(beta) of it across
    radius = 0.25 / (1 - sin(radians(20))) * M
    fillet = of_part(wheel, "fillet")
    centre = complex(fillet[0].real, -1.25 * M + radius)
    offset = fillet - centre
    assert np.hypot(offset.real * cos(0.3), offset.imag) == pytest.approx(radius, rel=1e-12)
    assert wheel.rolls == (0.0, 0.0, 0.0, 0.0)


def test_rolls_of_a_shaped_ring_run_on_from_fillet_to_involute() -> None:
    wheel = profiles(MESHES[5]).wheels[1]
    roll = wheel.roll[np.isin(wheel.part, ["fillet", "involute"])]
    assert np.all(np.abs(np.diff(roll)) < 0.02)
    assert roll[49] == pytest.approx(roll[50], abs=1e-13)
    assert wheel.rolls == (roll[49], roll[0], roll[-1], roll[50])


def signed_distance(points: np.ndarray, polygon: np.ndarray) -> np.ndarray:
    """Distance from a closed polygon, negative inside."""
    start, run = polygon[None, :], (np.roll(polygon, -1) - polygon)[None, :]
    part = np.clip(((points[:, None] - start) / run).real, 0, 1)
    away = np.abs(points[:, None] - start - part * run).min(axis=1)
    y, first, last = points.imag[:, None], start.imag, (start + run).imag
    across = (first > y) != (last > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = start.real + (y - first) / run.imag * run.real
    inside = (across & (points.real[:, None] < at)).sum(axis=1) % 2 == 1
    return np.where(inside, -away, away)


@pytest.mark.parametrize("pair", MESHES, ids=[pair.task.name for pair in MESHES])
@sparing("phase", [0.0, 0.07, -0.31], every=3, first=1)
def test_tracks_in_mesh_touch_and_do_not_overlap(pair: MeshPair, phase: float) -> None:
    first, second = mesh_tracks(pair, 1e-4 * M, phase)
    dense = second.polygon
    if pair.task.kind == "rack":  # its straight flanks have no points between their ends
        dense = (dense + np.linspace(0, 1, 50)[:, None] * np.diff(dense, append=dense[-1])).ravel()
    near = dense[np.abs(dense) < pair.sizes[0].tip + 0.1 * M]
    depth = signed_distance(near, first.polygon)
    assert depth.min() > -1.5e-4 * M
    assert depth.min() < 1.5e-4 * M
    # both flanks of a tooth touch: no backlash
    touching = near[depth < 1.5e-4 * M]
    assert {bool(side) for side in (touching.real - np.median(touching.real)) > 0} == {True, False}


@pytest.mark.parametrize("whole", [True, False])
def test_tracks_are_continuous(whole: bool) -> None:
    for pair in MESHES:
        for one in mesh_tracks(pair, 1e-6, 0.1, whole):
            ends = [(p.control[0, 0], p.control[-1, 3]) if isinstance(p, Cubics) else p.ends for p in one.pieces]
            following = [*ends[1:], ends[0]] if one.closed else ends[1:]
            for (_, end), (begin, _) in zip(ends, following, strict=False):
                assert abs(end - begin) < 1e-15
            assert one.closed is (whole and one.member.shape != "rack")
            assert {type(piece) for piece in one.pieces} <= {Cubics, Bow, Line}
            corners = np.array([begin for begin, _ in ends[:30]])
            assert signed_distance(corners, one.polygon) == pytest.approx(0.0, abs=2e-6)


def test_a_tooth_is_part_of_the_wheel() -> None:
    for pair in MESHES:
        for one, every in zip(mesh_tracks(pair, 1e-6, 0.1, False), mesh_tracks(pair, 1e-6, 0.1, True), strict=True):
            assert np.abs(signed_distance(one.polygon, every.polygon)).max() < 2e-6


def test_a_wheel_of_a_train_is_told_once() -> None:
    pairs = (
        solved((17, 40), name="1-2", wheels=("1", "2")),
        solved((40, 20), name="2-3", wheels=("2", "3")),
        solved((18, 30), name="2'-4", wheels=("2'", "4"), module=0.004),
    )
    train, apart = profiles(*pairs, train="a train"), profiles(*pairs)
    assert [wheel.wheel for wheel in train.wheels] == ["1", "2", "3", "2'", "4"]
    assert {wheel.pair for wheel in train.wheels} == {""}
    assert [(wheel.pair, wheel.wheel) for wheel in apart.wheels][:3] == [("1-2", "1"), ("1-2", "2"), ("2-3", "2")]
    assert [member.label for member in members(Pairs(pairs, "", ()))][-1] == "2'-4/4"


def test_wheels_without_a_profile_are_remarks() -> None:
    pair = solved((17, 40))
    broken = replace(pair, task=replace(pair.task, tips=(0.0399, None)))  # below the beginning of the involute
    found = profiles(broken)
    assert [wheel.wheel for wheel in found.wheels] == ["2"]
    assert found.remarks == (found.remarks[0],)
    assert "wheel 1 has no profile" in found.remarks[0]
    with pytest.raises(NoSolutionError):
        half_tooth(both(broken)[0])
    pointed = profiles(solved((8, 40), (0.75, 0.0)))
    assert len(pointed.wheels) == 2
    assert "wheel 1 is pointed at the radius" in pointed.remarks[0]
    assert "tip" not in pointed.wheels[0].part
    assert profile_columns(Profiles((), ()))["x[m]"].size == 0


def test_columns_and_points() -> None:
    found = profiles(*MESHES[:2], points=20)
    columns = profile_columns(found)
    assert list(columns) == ["pair", "wheel", "part", "phi[rad]", "x[m]", "y[m]", "R[m]"]
    assert {len(column) for column in columns.values()} == {sum(len(wheel.x) for wheel in found.wheels)}
    assert (columns["part"] == "fillet").sum() == (columns["part"] == "involute").sum() == 80
    assert "pair" not in profile_columns(profiles(solved((20, 30))))
    with pytest.raises(UsageError, match="too few"):
        profiles(MESHES[0], points=2)


def test_record_of_the_stage_and_back() -> None:
    found = profiles(*MESHES, points=7)
    declared = STAGES["profile"]
    again = declared.load(declared.dump(found))
    assert again.remarks == found.remarks
    for one, other in zip(found.wheels, again.wheels, strict=True):
        for name in one.__dataclass_fields__:
            assert np.array_equal(getattr(one, name), getattr(other, name)), name
    one, other = (declared.table(each) for each in (again, found))
    assert one is not None
    assert other is not None
    assert one.columns[0].tolist() == other.columns[0].tolist()
