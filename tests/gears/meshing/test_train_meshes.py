"""The meshes of chosen trains: centre distances, sums of shifts, planets in two meshes, what is asked wrongly."""

from dataclasses import replace
from functools import cache
from math import cos, radians, tan

import numpy as np
import pytest
from scipy.optimize import brentq
from sparing import sparing

from gears.stages.trains import AI, AIBAR, COAXIAL, UNFOLDED, chosen
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairsTask, PairTask
from tmmcalc.gears.meshing.train import chains, name_of, solve_meshes
from tmmcalc.gears.scheme import layout_of

ONE = 'planets = 1\nmodule_ratios = [[1, 1]]\ntolerance = "1 %"\n'
SPECS = {
    "unfolded2": UNFOLDED,
    "unfolded3": 'layout = "unfolded3"\nratio = 40\ntolerance = "1 %"\n',
    "coaxial": COAXIAL,
    "AIbar": AIBAR,
    "AI": AI,
    "AA": f'layout = "AA"\nratio_kind = "i_H1"\nratio = 20\nz_max = 80\n{ONE}'
    'constraints = { mesh_angle_max = "24 deg" }\n',
    "II": f'layout = "II"\nratio_kind = "i_H1"\nratio = 20\nz_max = 60\nring_max = 90\n{ONE}',
    "AII": 'layout = "AII"\nratio = -60\ntolerance = "2 %"\nplanets = 3\nmodule_ratios = [[1, 1]]\nz_max = 60\n'
    "ring_max = 150\n",
    "2A-AA": 'layout = "2A-AA"\nratio = 5\ntolerance = "1 %"\nplanets = 3\nz_min = 18\nz_max = 100\n'
    'constraints = { mesh_angle_max = "26 deg" }\n',
}
USUAL = PairTask((1, 1), 1.0, strategy="given_aw")
COMMON = ("coaxial", "AIbar", "AI", "AA", "II", "AII")


@cache
def selection(layout):
    return chosen(SPECS[layout])


def solved(layout, usual=USUAL, own=None, solve=solve_pair):
    return solve_meshes(PairsTask(usual=usual, own=own or {}), selection(layout), solve)


def teeth_of(layout):
    winner = selection(layout).winner
    return dict(zip(layout_of(layout).wheels, winner.teeth, strict=True))


def angles_of(layout):
    found = selection(layout)
    pool = found.pool
    return found.variants[found.winner.variant].sets.angles[pool.row[found.winner.place]]


def sum_of(pair):
    """x1 + x2 of a solved pair by its centre distance alone."""
    task, slope = pair.task, tan(radians(20))
    start = np.arctan(slope / cos(task.helix))
    one, two = task.teeth
    count = one + two if task.kind == "external" else one - two
    ratio = abs(count) * task.module / (2 * cos(task.helix)) / pair.distance * cos(start)
    angle = brentq(lambda a: cos(a) - ratio, 1e-9, 1.5, xtol=1e-16)
    return count * ((tan(angle) - angle) - (tan(start) - start)) / (2 * slope)


def each_wheel(found):
    """Shifts and tips of every wheel in all of its meshes."""
    shifts, tips = {}, {}
    for pair in found.pairs:
        for wheel, x, sizes in zip(pair.task.wheels, pair.shifts, pair.sizes, strict=True):
            assert sizes.name == wheel
            shifts.setdefault(wheel, []).append(x)
            tips.setdefault(wheel, []).append(sizes.tip)
    return shifts, tips


@sparing("layout", LAYOUTS, every=3)
def test_every_layout(layout):
    found = solved(layout)
    scheme, winner, teeth = layout_of(layout), selection(layout).winner, teeth_of(layout)
    assert found.train == winner.name
    assert [pair.task.name for pair in found.pairs] == [name_of(mesh) for mesh in scheme.meshes]
    for pair, mesh, angle in zip(found.pairs, scheme.meshes, angles_of(layout), strict=True):
        task = pair.task
        assert task.teeth == tuple(teeth[wheel] for wheel in task.wheels)
        assert set(task.wheels) == {mesh.first, mesh.second}
        assert (task.kind == "internal") == mesh.internal
        if mesh.internal:
            assert task.wheels[1] in scheme.rings
            assert pair.sizes[1].kind == "ring"
        assert (task.module, task.face_width) == (winner.modules[mesh.stage], winner.widths[mesh.stage])
        total = task.teeth[1] + (-1 if mesh.internal else 1) * task.teeth[0]
        assert pair.distance == pytest.approx(task.module * total / 2 * cos(radians(20)) / cos(angle), rel=1e-12)
        assert sum(pair.shifts) == pytest.approx(sum_of(pair), abs=1e-10)
        assert pair.verdict != "fail"
    for values in (*each_wheel(found)[0].values(), *each_wheel(found)[1].values()):
        assert max(values) - min(values) <= 1e-12
    if layout in COMMON:
        distances = [pair.distance for pair in found.pairs]
        assert max(distances) - min(distances) <= 1e-12 * max(distances)
        assert "all meshes have the centre distance" in found.remarks[0]


@sparing("layout", COMMON, every=3)
def test_the_first_mesh_frees_the_common_distance(layout):
    strategy = "max_contact_ratio" if layout == "AIbar" else "balanced"
    found = solved(layout, replace(USUAL, strategy=strategy))
    first = found.pairs[0]
    alone = solve_pair(replace(first.task, strategy=strategy, distance=None, shifts=(None, None), tips=(None, None)))
    assert first.distance == pytest.approx(alone.distance, rel=1e-12)
    for pair in found.pairs:
        assert pair.distance == pytest.approx(first.distance, rel=1e-12)
        assert sum(pair.shifts) == pytest.approx(sum_of(pair), abs=1e-10)
    for values in (*each_wheel(found)[0].values(), *each_wheel(found)[1].values()):
        assert max(values) - min(values) <= 1e-12
    assert "as mesh 1-2 asks" in found.remarks[0]


def test_the_first_mesh_alone_may_be_given_its_own_distance():
    distance = 1.003 * solved("AI").pairs[0].distance
    own = {"1-2": replace(USUAL, distance=distance)}
    assert [pair.distance for pair in solved("AI", own=own).pairs] == pytest.approx([distance] * 2, rel=1e-12)
    given = {"1-2": replace(USUAL, strategy="given", shifts=(0.4, 0.2))}
    found = solved("AI", own=given)
    assert found.pairs[0].shifts == (0.4, 0.2)
    assert found.pairs[1].distance == pytest.approx(found.pairs[0].distance, rel=1e-12)


@pytest.mark.parametrize(
    "change",
    [
        {"strategy": "balanced"},
        {"strategy": "given", "shifts": (0.1, 0.2)},
        {"distance": 0.2},
        {"strategy": "max_contact_ratio"},
    ],
)
def test_other_meshes_do_not_free_it(change):
    with pytest.raises(UsageError, match="mesh 2'-3 asks for its own centre distance") as error:
        solved("AI", own={"2'-3": replace(USUAL, **change)})
    assert "given_aw" in error.value.remedy
    with pytest.raises(UsageError, match="mesh 1-2 asks for its own"):
        solved("2A-AA", replace(USUAL, **change))
    with pytest.raises(UsageError, match="mesh 3-4 asks for its own"):
        solved("2A-AA", own={"3-4": replace(USUAL, **change)})


def test_zero_shifts_stand_where_the_teeth_have_the_reference_distance():
    found = solved("AIbar", replace(USUAL, strategy="zero"))
    assert all(pair.shifts == (0.0, 0.0) for pair in found.pairs)
    assert not any("without shifts" in remark for remark in found.remarks)
    assert min(angles_of("2A-AA")) < max(angles_of("2A-AA"))
    with pytest.raises(UsageError, match="strategy zero"):
        solved("2A-AA", replace(USUAL, strategy="zero"))


def test_unfolded_meshes_are_free():
    own = {"2'-3": replace(USUAL, strategy="balanced")}
    found, plain = solved("unfolded2", own=own), solved("unfolded2")
    assert found.pairs[0].shifts == plain.pairs[0].shifts
    assert found.pairs[1].distance > plain.pairs[1].distance


def test_a_planet_takes_a_shift_that_both_meshes_admit():
    found = solved("AIbar", replace(USUAL, strategy="equal_sliding"))
    alone = solve_pair(replace(found.pairs[0].task, strategy="equal_sliding", shifts=(None, None), tips=(None, None)))
    assert found.pairs[0].distance == pytest.approx(alone.distance, rel=1e-12)
    assert found.pairs[0].shifts[1] < alone.shifts[1] - 0.01
    assert any("x = " in remark and "2-3 admits as well" in remark for remark in found.remarks)
    # the shift that mesh 1-2 alone would have does not work with the ring, and a little beyond the limit neither
    ring = found.pairs[1].task
    for shift in (alone.shifts[1], found.pairs[0].shifts[1] + 1e-6):
        tip = found.pairs[0].sizes[1].tip + (shift - found.pairs[0].shifts[1]) * ring.module
        tried = solve_pair(replace(ring, shifts=(shift, None), tips=(tip, None), refuse=False))
        assert tried.verdict == "fail"


def test_no_shift_of_the_planet_suits_both_meshes():
    with pytest.raises(NoSolutionError) as error:
        solved("AIbar", replace(USUAL, strategy="max_contact_strength"))
    assert "no shift of wheel 2 suits all of its meshes" in error.value.message
    assert "meshes 1-2 and 2-3 share wheels" in error.value.remedy
    told = solved("AIbar", replace(USUAL, strategy="max_contact_strength", refuse=False))
    assert told.pairs[1].verdict == "fail"
    assert any("no shift of wheel 2" in remark for remark in told.remarks)


def test_the_shift_of_a_planet_may_be_given_in_either_mesh():
    by_ring = solved("AIbar", own={"2-3": replace(USUAL, shifts=(0.1, None))})
    by_sun = solved("AIbar", own={"1-2": replace(USUAL, shifts=(None, 0.1))})
    for found in (by_ring, by_sun):
        assert found.pairs[0].shifts == pytest.approx((-0.1, 0.1), abs=1e-12)
        assert found.pairs[1].shifts == pytest.approx((0.1, -0.1), abs=1e-12)
    both = {"1-2": replace(USUAL, shifts=(None, 0.1)), "2-3": replace(USUAL, shifts=(0.2, None))}
    with pytest.raises(UsageError, match=r"mesh 2-3 asks for x = 0\.2 of wheel 2, but mesh 1-2 leaves it x = 0\.1"):
        solved("AIbar", own=both)
    last = solved("2A-AA", own={"3-4": replace(USUAL, shifts=(None, -0.3))})
    assert last.pairs[2].shifts[1] == pytest.approx(-0.3, abs=1e-12)
    assert last.pairs[0].shifts[1] == last.pairs[1].shifts[0]


def test_the_tip_of_a_planet():
    found = solved("AIbar", replace(USUAL, strategy="balanced"))
    one, two = (
        solve_pair(replace(pair.task, tips=(None, None))).sizes[place].tip
        for pair, place in zip(found.pairs, (1, 0), strict=True)
    )
    assert one < two - 1e-6
    assert found.pairs[1].sizes[0].tip == found.pairs[0].sizes[1].tip == pytest.approx(one, rel=1e-12)
    assert any("the smaller of its tips" in remark for remark in found.remarks)
    shorter = solved("AIbar").pairs[0].sizes[1].tip - 2e-4
    given = solved("AIbar", own={"2-3": replace(USUAL, tips=(shorter, None))})
    assert [given.pairs[0].sizes[1].tip, given.pairs[1].sizes[0].tip] == pytest.approx([shorter] * 2, rel=1e-12)
    several = {"1-2": replace(USUAL, tips=(None, shorter + 1e-5)), "2-3": replace(USUAL, tips=(shorter, None))}
    with pytest.raises(UsageError, match="several tip diameters"):
        solved("AIbar", own=several)


def test_helical_stages():
    helical = replace(USUAL, helix=radians(12))
    found = solved("AII", helical)
    plain = solved("AII")
    for one, other in zip(found.pairs, plain.pairs, strict=True):
        assert one.distance == pytest.approx(other.distance / cos(radians(12)), rel=1e-12)
    with pytest.raises(UsageError, match="meshes 1-2 and 2-3 share a wheel"):
        solved("AII", own={"2-3": helical})
    mixed = solved("AI", own={"1-2": replace(USUAL, helix=radians(5))})
    assert mixed.pairs[1].distance == pytest.approx(solved("AI").pairs[0].distance / cos(radians(5)), rel=1e-12)
    assert sum(mixed.pairs[0].shifts) == pytest.approx(0.0, abs=1e-10)
    assert sum(mixed.pairs[1].shifts) == pytest.approx(sum_of(mixed.pairs[1]), abs=1e-10)


def test_helical_teeth_of_a_spur_train_are_told_with_their_distances():
    spur = solved("unfolded2")
    helical = solved("unfolded2", replace(USUAL, helix=radians(12)))
    (said,) = (remark for remark in helical.remarks if "spur teeth" in remark)
    for one, other in zip(spur.pairs, helical.pairs, strict=True):
        assert other.distance == pytest.approx(one.distance / cos(radians(12)), rel=1e-12)
        name = other.task.name
        assert f"{name} {1e3 * other.distance:.6g} mm instead of {1e3 * one.distance:.6g} mm" in said
    assert not any("spur teeth" in remark for remark in spur.remarks)


def test_all_meshes_that_cannot_be_made_are_told_together():
    limits = replace(USUAL.limits, contact_ratio=1.95)
    with pytest.raises(NoSolutionError) as error:
        solved("unfolded3", replace(USUAL, limits=limits))
    for name in ("1-2", "2'-3", "3'-4"):
        assert name in str(error.value)


def test_meshes_with_a_common_planet_are_told_together():
    with pytest.raises(NoSolutionError) as error:
        solved("AIbar", replace(USUAL, limits=replace(USUAL.limits, contact_ratio=2.2)))
    assert "2 of 2" in str(error.value)
    assert "1-2" in str(error.value)
    assert "2-3" in str(error.value)
    assert "all meshes have the centre distance" in str(error.value)


def test_meshes_that_there_are_not():
    with pytest.raises(UsageError, match="no mesh 2-3") as error:
        solved("AI", own={"2-3": USUAL})
    assert "2'-3" in error.value.remedy


@pytest.mark.parametrize(("layout", "most"), [("AI", 2), ("AIbar", 3), ("AII", 4), ("2A-AA", 6)])
def test_no_mesh_is_solved_needlessly(layout, most):
    tasks = []

    def counted(task):
        tasks.append(task)
        return solve_pair(task)

    solved(layout, solve=counted)
    assert len(tasks) == len(set(tasks)) <= most


def test_chains_are_meshes_that_share_a_wheel():
    for layout in LAYOUTS.values():
        found = chains(layout)
        assert [k for chain in found for k in chain] == list(range(len(layout.meshes)))
        wheels = [{w for k in chain for w in (layout.meshes[k].first, layout.meshes[k].second)} for chain in found]
        assert not any(one & other for i, one in enumerate(wheels) for other in wheels[:i])
