"""The contour against the worked case, its own defining conditions and a raster of independent margins."""

from __future__ import annotations

import numpy as np
import pytest
from sparing import sparing

from gears.involute.contour.pairs import PAIRS, case, random_tasks, task
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.contour.contour import contour, contours
from tmmcalc.gears.involute.contour.frame import frame_of
from tmmcalc.gears.involute.contour.interval import interval, intervals
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.pair import pair_of_shifts
from tmmcalc.gears.involute.rack import RACKS


def test_margins_of_the_worked_case():
    for point in case("IG-S09")["expected"]["points"]:
        found = margins(task(14, 17), point["x1"], point["x2"])
        pairs = {
            "uc1": found.undercut1,
            "uc2": found.undercut2,
            "eps_alpha": found.contact_ratio + 1,
            "s_a1": found.thickness1,
            "s_a2": found.thickness2,
            "int1": found.interference1,
            "int2": found.interference2,
            "theta1_A2": found.theta1,
            "theta2_A1": found.theta2,
        }
        for name, value in pairs.items():
            assert float(value) == pytest.approx(point[name], abs=1e-6), name


def test_corners_and_area_of_the_worked_case():
    strict, tolerated = contours(task(14, 17))
    expected = case("IG-S09")["expected"]
    names = {"undercut1", "undercut2", "interference1", "interference2"}
    found = {frozenset(c.lines): c for c in strict.region.corners}
    for corner in expected["strict_vertices"]:
        lines = frozenset(k if k in names else "contact_ratio" for k in corner["curves"])
        assert (found[lines].x1, found[lines].x2) == pytest.approx((corner["x1"], corner["x2"]), abs=1e-5)
    assert len(found) == len(expected["strict_vertices"])
    assert strict.region.area == pytest.approx(expected["strict_area"], abs=1e-3)
    places = [(c.x1, c.x2) for c in tolerated.region.corners]
    assert len(places) == len(expected["allowed_undercut_vertices"])
    for corner in expected["allowed_undercut_vertices"]:
        assert min(np.hypot(x1 - corner["x1"], x2 - corner["x2"]) for x1, x2 in places) < 2e-5


@sparing("asked", [*PAIRS, *random_tasks(10)], ids=lambda t: f"{t.first.teeth}/{t.second.teeth}", every=5)
def test_corners_meet_two_conditions_and_edges_one(asked):
    for found in contours(asked):
        for region in filter(None, (found.main, *found.pieces)):
            for corner in region.corners:
                here = margins(asked, corner.x1, corner.x2)
                for line in corner.lines:
                    if line.startswith("tip"):
                        pair = pair_of_shifts(*asked.wheels(corner.x1, corner.x2))
                        k = int(line[-1]) - 1
                        assert abs(float(pair.tips[k]) - pair.wheels[k].reference) < 1e-10
                        continue
                    name = line.replace("interference", "tolerated")
                    assert abs(float(getattr(here, name))) < 1e-10, corner
            for edge in region.edges:
                if edge.line.startswith("tip"):
                    continue
                name = edge.line.replace("interference", "tolerated")
                here = margins(asked, edge.x1, edge.x2)
                assert np.max(np.abs(getattr(here, name))) < 1e-9, edge.line
            start = [(e.x1[0], e.x2[0]) for e in region.edges]
            end = [(e.x1[-1], e.x2[-1]) for e in region.edges]
            assert np.allclose(start, [end[-1], *end[:-1]], atol=1e-12)


def enclosed(region, x1, x2):
    """Whether points lie in the closed curve of a region: an odd number of its steps lies to the right."""
    one, two = region.outline
    inside = np.zeros(x1.shape, dtype=bool)
    for a1, a2, b1, b2 in zip(one[:-1], two[:-1], one[1:], two[1:], strict=True):
        if a2 != b2:
            crossed = (a2 > x2) != (b2 > x2)
            inside ^= crossed & (x1 < a1 + (x2 - a2) * (b1 - a1) / (b2 - a2))
    return inside


def names_of(region):
    return [edge.line for edge in region.edges] + [line for corner in region.corners for line in corner.lines]


@sparing("asked", [*PAIRS, *random_tasks(12, 3)], ids=lambda t: f"{t.first.teeth}/{t.second.teeth}", every=8)
def test_membership_and_area_against_a_raster(asked):
    for found in contours(asked):
        regions = [r for r in (found.main, *found.pieces) if r is not None]
        low1, high1, low2, high2 = -2.0, 2.5, -2.0, 3.0
        if found.main is not None:
            one, two = found.main.outline
            low1, high1, low2, high2 = one.min(), one.max(), two.min(), two.max()
        n = 140
        step1, step2 = (high1 - low1) / n, (high2 - low2) / n
        x1, x2 = np.meshgrid(low1 + step1 * (np.arange(n) + 0.5), low2 + step2 * (np.arange(n) + 0.5), indexing="ij")
        raster = margins(asked, x1, x2).least(found.strict) >= 0
        inside = np.zeros_like(raster)
        for region in regions:
            inside |= enclosed(region, x1, x2)
        assert np.sum(inside != raster) <= 0.004 * raster.sum() + 6
        if found.main is not None and not found.pieces:
            assert found.main.area == pytest.approx(raster.sum() * step1 * step2, rel=0.01)


NECKS = [
    task(190, 141, 1.1, 0.25, 0, RACKS["ISO 53 D"]),
    task(71, 109, 1.0, 0.25, 45, RACKS["ISO 53 D"]),
    task(164, 55, 1.1, 0.0, 0, RACKS["stub 20"]),
    task(64, 108, 1.1, 0.0, 45, RACKS["ISO 53 C"]),
]


@sparing("asked", NECKS, ids=lambda t: f"{t.first.teeth}/{t.second.teeth}", every=4)
def test_areas_that_a_deep_straight_flank_joins(asked):
    """The flank ends below h_a*, so meshes with one tip or both inside the reference circles adjoin the main region."""
    for found in contours(asked):
        assert found.untraced == ()
        assert len({part.branch for part in found.main.parts}) > 1
        assert not any(line.startswith("tip") for region in (found.main, *found.pieces) for line in names_of(region))
        polygon = np.array(found.main.outline)
        twice = np.sum(polygon[0, :-1] * polygon[1, 1:] - polygon[0, 1:] * polygon[1, :-1])
        assert found.main.area == pytest.approx(twice / 2, rel=2e-3)
        span = np.linspace(-4.9, 6.0, 180)
        x1, x2 = np.meshgrid(span + 0.001, span, indexing="ij")
        raster = margins(asked, x1, x2).least(found.strict) >= 0
        inside = np.zeros_like(raster)
        for region in (found.main, *found.pieces):
            inside |= enclosed(region, x1, x2)
        assert np.sum(inside != raster) <= 0.002 * raster.sum() + 4


def test_a_pair_of_equal_wheels_has_a_symmetrical_region():
    """The corners of both sides lie on the same lines of constant sum."""
    for rack in ("ISO 53 B", "stub 20"):
        region = contour(task(81, 81, rack=RACKS[rack])).region
        places = {(round(c.x1, 9), round(c.x2, 9)) for c in region.corners}
        assert places == {(x2, x1) for x1, x2 in places}
        mirrored = region.outline[::-1]
        assert (
            np.max(
                np.min(np.hypot(*(np.subtract.outer(*pair) for pair in zip(mirrored, region.outline, strict=True))), 1)
            )
            < 1e-6
        )


@pytest.mark.parametrize("asked", [*NECKS, task(100, 200)], ids=lambda t: f"{t.first.teeth}/{t.second.teeth}")
def test_intervals_of_a_line_against_its_points(asked):
    """Every run of admissible points of a line is one interval, whatever tip circles are inside reference circles."""
    frame = frame_of(asked)
    x1 = np.linspace(-6.0, 6.0, 6001)
    for total in (-1.5, -0.3, 0.4, 1.3, 2.1):
        good = margins(asked, x1, total - x1).least() >= 0
        ends = np.flatnonzero(np.diff(np.concatenate(([0], good.astype(int), [0]))))
        found = [each for each in intervals(frame, total) if each.high - each.low > 0.004]
        low, high = x1[ends[::2]], x1[ends[1::2] - 1]
        assert [each.low for each in found] == pytest.approx(low, abs=0.0021)
        assert [each.high for each in found] == pytest.approx(high, abs=0.0021)
        for each in found:
            for x, line in ((each.low, each.low_line), (each.high, each.high_line)):
                there = margins(asked, x, total - x)
                assert abs(float(getattr(there, line.replace("interference", "tolerated")))) < 1e-9


def test_the_interval_near_a_point_is_the_one_that_holds_it():
    asked = task(100, 200)
    found = intervals(frame_of(asked), 0.1)
    assert len(found) > 1
    point = 1.5
    holding = min(found, key=lambda each: each.distance(point))
    assert holding.low < point < holding.high
    assert float(margins(asked, point, 0.1 - point).least()) > 0
    assert sum(each.distance(point) == 0 for each in found) == 1


def test_a_region_between_two_lines_of_the_scan_is_found():
    """A triangle of a few thousandths, in which the first look sees one line on each side only."""
    found = contour(task(10, 5, 1.0, 0.0, 15, RACKS["ISO 53 B"]), strict=False).region
    assert len(found.corners) == 3
    x1, x2 = (np.array([getattr(corner, name) for corner in found.corners]) for name in ("x1", "x2"))
    triangle = abs(np.sum(x1 * np.roll(x2, -1) - np.roll(x1, -1) * x2)) / 2
    assert found.area == pytest.approx(triangle, rel=0.02)


@sparing("rack", list(RACKS), every=4)
def test_every_piece_is_traced(rack):
    rng = np.random.default_rng(20)
    for _ in range(12):
        z1, z2 = (int(z) for z in np.round(np.exp(rng.uniform(np.log(5), np.log(200), 2))))
        ratio, tip, helix = (float(rng.choice(v)) for v in ((1.0, 1.1, 1.2), (0.0, 0.25, 0.4), (0, 15, 30, 45)))
        for found in contours(task(z1, z2, ratio, tip, helix, RACKS[rack])):
            assert found.untraced == (), (z1, z2, ratio, tip, helix)


@pytest.mark.slow
def test_area_is_that_of_a_much_finer_polygon():
    found = contour(task(14, 17)).region
    w = np.linspace(found.angles[0], found.angles[-1], 20001)[1:-1]
    from tmmcalc.gears.involute.contour.bounds import cuts

    lines = cuts(contour(task(14, 17)).frame, w)
    low, high, _, _ = lines.ends(True)
    assert found.area == pytest.approx(np.trapezoid(high - low, lines.sums.total), abs=5e-6)


def test_branches_touch_at_the_pinch_points():
    asked = task(100, 150)
    assert abs(float(margins(asked, 1.0, -1.0).interference1)) < 1e-12
    assert abs(float(margins(asked, -1.0, 1.0).interference2)) < 1e-12
    found = contour(asked)
    assert any(np.hypot(c.x1 - 1, c.x2 + 1) < 1e-9 for c in found.region.corners)
    assert found.pieces
    assert min(np.min(np.hypot(p.outline[0] - 1, p.outline[1] + 1)) for p in found.pieces) < 1e-9
    assert found.region.outline[0].min() >= -1 - 1e-12


def test_interval_on_a_line_of_constant_sum():
    worked = case("IG-S14")
    names = {"uc1": "undercut1", "int1": "interference1", "sa2": "thickness2", "eps": "contact_ratio"}
    for variant, ((low, low_line), (high, high_line)) in zip(
        worked["inputs"]["variants"], worked["expected"]["intervals"], strict=True
    ):
        frame = frame_of(task(14, 17, variant["eps_min"], variant["s_a_min"], 15))
        found = interval(frame, worked["inputs"]["x_sum"])
        assert (found.low, found.high) == pytest.approx((low, high), abs=1e-5)
        assert (found.low_line, found.high_line) == (names[low_line], names[high_line])


def test_an_empty_contour_tells_the_best_contact_ratio():
    found = contour(task(14, 17, 1.6))
    assert found.main is None
    with pytest.raises(NoSolutionError, match=r"1\.4182") as error:
        _ = found.region
    assert error.value.value == pytest.approx(1.41823, abs=1e-5)


def test_sums_that_no_pair_has_are_refused():
    frame = frame_of(task(14, 17))
    with pytest.raises(NoSolutionError, match="base circles"):
        interval(frame, -3.0)
    with pytest.raises(NoSolutionError, match="undercut"):
        interval(frame, 0.0)
