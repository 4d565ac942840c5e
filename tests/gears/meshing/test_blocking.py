"""The stage of the blocking contour against a raster with marching squares, scipy's optimisers and the worked cases."""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from functools import cache
from math import cos, pi, radians, sin, tan
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import RACKS
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.blocking import blocking_columns, solve_blocking
from tmmcalc.gears.meshing.choice import contour_task
from tmmcalc.gears.meshing.contours import Blocking
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask

CASES = json.loads((Path(__file__).parents[2] / "cases" / "involute-geometry.json").read_text())
STEP = 0.01  # of the raster


def pair_task(z1, z2, ratio=1.0, tip=0.0, helix=0.0, rack="GOST 13755", **more):
    limits = QualityLimits(contact_ratio=ratio, tip_thickness=tip)
    return PairTask((z1, z2), 0.004, helix=radians(helix), rack=RACKS[rack], limits=limits, refuse=False, **more)


TEN = [
    pair_task(14, 17),
    pair_task(14, 17, 1.1, 0.4, 15.0),
    pair_task(20, 60, 1.2, 0.25, 25.0),
    pair_task(9, 80, 1.0, 0.2),
    pair_task(12, 12, 1.0, 0.25),
    pair_task(40, 41, 1.2, 0.4, 8.0),
    pair_task(25, 31, 1.1, 0.25, 0.0, "stub 20"),
    pair_task(30, 90, 1.0, 0.4, 20.0, "ISO 53 D"),
    pair_task(36, 50, 1.2, 0.25, 0.0, "AGMA 14.5"),
    pair_task(11, 26, 1.0, 0.4, 30.0, "ISO 53 C"),
]
NAMES = [f"{t.teeth[0]}/{t.teeth[1]}" for t in TEN]


def solved(task):
    return Pairs((solve_pair(task),), "", ())


@cache
def contour_of(task):
    return solve_blocking(solved(task)).pairs[0]


def least_on_raster(task, strict, x1, x2):
    """The least margin on the raster of x1 (n, 1) and x2 (1, m), by the formulas of the standard; nan: no pair."""
    rack, beta = task.rack, task.helix
    alpha_t = np.arctan(tan(rack.angle) / cos(beta))
    r = [z / (2 * cos(beta)) for z in task.teeth]
    b = [value * cos(alpha_t) for value in r]
    total = x1 + x2
    lines = total[0, 0] + STEP * np.arange(sum(total.shape) - 1)  # the sums on the raster, each once
    w = inverse_involute(involute(alpha_t) + 2 * lines * tan(rack.angle) / sum(task.teeth))
    w = w[np.add.outer(np.arange(total.shape[0]), np.arange(total.shape[1]))]
    shorter = total - (sum(b) / np.cos(w) - sum(r))
    g = sum(b) * np.tan(w)
    tips = [own + rack.addendum + x - shorter for own, x in zip(r, (x1, x2), strict=True)]
    with np.errstate(invalid="ignore"):
        rho = [np.sqrt(tip**2 - base**2) for tip, base in zip(tips, b, strict=True)]
        rows = [(rho[0] + rho[1] - g) * cos(beta) / (pi * cos(alpha_t)) - task.limits.contact_ratio]
        for i, x in enumerate((x1, x2)):
            wheel = Wheel(task.teeth[i], x.ravel(), beta, rack)
            form = np.asarray(junction(wheel).curvature_radius).reshape(x.shape)
            half = (pi / 2 + 2 * x * tan(rack.angle)) / task.teeth[i] + involute(alpha_t)
            half = half - involute(np.arccos(b[i] / tips[i]))
            thick = 2 * tips[i] * half * np.cos(np.arctan(tan(beta) * tips[i] / r[i]))
            rows += [g - rho[1 - i] - form, thick - task.limits.tip_thickness]
            if strict:
                least = rack.straight - r[i] * sin(alpha_t) ** 2
                rows.append(np.broadcast_to(x - least, total.shape))
    return np.min(rows, axis=0)


def crossings(x1, x2, value):
    """Points where the value changes its sign along the lines of the raster (n, 2), by linear interpolation."""
    points = []
    for axis in (0, 1):
        a, b = (value[:-1], value[1:]) if axis == 0 else (value[:, :-1], value[:, 1:])
        k, j = np.nonzero((a >= 0) != (b >= 0))
        t = a[k, j] / (a[k, j] - b[k, j])
        points.append(np.column_stack((x1[k] + (STEP * t if axis == 0 else 0), x2[j] + (STEP * t if axis else 0))))
    return np.concatenate(points)


def distances(points, one, two):
    """Distances of points (n, 2) from the polygon through (one, two)."""
    start = np.column_stack((one, two))[:-1]
    run = np.column_stack((np.diff(one), np.diff(two)))
    to = points[:, None] - start
    t = np.clip(np.sum(to * run, axis=2) / np.maximum(np.sum(run * run, axis=1), 1e-300), 0, 1)
    return np.sqrt(np.min(np.sum((to - t[..., None] * run) ** 2, axis=2), axis=1))


@sparing("task", TEN, ids=NAMES, every=8)
def test_outlines_against_a_raster_with_marching_squares(task):
    found = contour_of(task)
    for area in (found.strict, found.tolerated):
        outlines = [outline for outline in (area.main, *area.pieces) if outline is not None]
        assert area.main is not None
        low = [min(o.x1.min() for o in outlines), min(o.x2.min() for o in outlines)]
        high = [max(o.x1.max() for o in outlines), max(o.x2.max() for o in outlines)]
        low, high = np.maximum(low, -2.5) - 0.153, np.minimum(high, 4.0) + 0.147
        x1, x2 = np.arange(low[0], high[0], STEP), np.arange(low[1], high[1], STEP)
        value = np.nan_to_num(least_on_raster(task, area.strict, x1[:, None], x2[None, :]), nan=-1.0)
        border = crossings(x1, x2, value)
        away = np.min([distances(border, o.x1, o.x2) for o in outlines], axis=0)
        assert np.max(away) < 1.2 * STEP  # a corner may lie between two lines of the raster
        assert np.median(away) < 2e-4
        for outline in outlines:
            edge = np.append(outline.edge, outline.edge[-1])
            real = np.array([not outline.edges[k].startswith("tip") for k in edge])
            places = np.column_stack((outline.x1, outline.x2))[real]
            places = places[np.all((places > low + STEP) & (places < high - STEP), axis=1)]
            to = np.sqrt(np.min(np.sum((places[:, None] - border) ** 2, axis=2), axis=1))
            assert np.mean(to > 2.5 * STEP) < 0.1  # a tip thinner than a step is not seen on the raster
        if np.all(low > -2.5) and np.all(high < 4.0):
            covered = np.sum(value >= 0) * STEP**2
            assert sum(o.area for o in outlines) == pytest.approx(covered, abs=0.6 * STEP * len(border) * STEP + 1e-3)


@sparing("task", TEN, ids=NAMES, every=8)
def test_corners_lie_on_two_lines_and_edges_on_one(task):
    asked, found = contour_task(task), contour_of(task)
    for area in (found.strict, found.tolerated):
        for outline in filter(None, (area.main, *area.pieces)):
            here = margins(asked, outline.x1, outline.x2)
            for k, line in enumerate(outline.edges):
                if not line.startswith("tip"):
                    kept = getattr(here, line.replace("interference", "tolerated"))[:-1][outline.edge == k]
                    assert np.max(np.abs(kept)) < 1e-9
            for corner in outline.corners:
                here = margins(asked, corner.x1, corner.x2)
                for line in corner.lines:
                    if not line.startswith("tip"):
                        assert abs(float(getattr(here, line.replace("interference", "tolerated")))) < 1e-10


NECKED = [
    pair_task(17, 40, rack="stub 20", strategy="given", shifts=(0.5, -0.85)),
    pair_task(100, 200, rack="ISO 53 C"),
    pair_task(8, 60, helix=25.0, rack="ISO 53 C"),
    pair_task(100, 200, rack="ISO 53 B"),
    pair_task(20, 30, helix=30.0, rack="AGMA 14.5"),
    pair_task(81, 81, 1.3, 0.4, 25.0, "ISO 53 D"),
]


@sparing("task", NECKED, ids=[f"{t.teeth[0]}/{t.teeth[1]}" for t in NECKED], every=6)
def test_a_necked_contour_is_one_closed_curve(task):
    """Straight flanks that end below h_a*: what a neck joins is one area, without an edge that is no condition."""
    found = contour_of(task)
    for area in (found.strict, found.tolerated):
        main = area.main
        assert not {"tip1", "tip2"} & {*main.edges, *(line for corner in main.corners for line in corner.lines)}
        low1, high1, low2, high2 = main.x1.min(), main.x1.max(), main.x2.min(), main.x2.max()
        x1, x2 = np.arange(low1 - 0.053, high1 + 0.05, STEP), np.arange(low2 - 0.047, high2 + 0.05, STEP)
        value = np.nan_to_num(least_on_raster(task, area.strict, x1[:, None], x2[None, :]), nan=-1.0)
        outlines = (main, *area.pieces)
        border = crossings(x1, x2, value)
        away = np.concatenate(
            [np.min([distances(part, o.x1, o.x2) for o in outlines], axis=0) for part in np.array_split(border, 8)]
        )
        assert np.max(away) < 1.2 * STEP
        assert np.median(away) < 3e-4
        assert sum(o.area for o in outlines) == pytest.approx(np.sum(value >= 0) * STEP**2, rel=0.01)
        chosen = found.points[0]
        assert chosen.strict == (float(margins(contour_task(task), chosen.x1, chosen.x2).least(True)) >= -1e-9)
    if found.points[0].tolerated:
        assert found.low - 1e-9 <= found.points[0].x1 <= found.high + 1e-9


@pytest.mark.parametrize("shifts", [(1.5, -1.4), (0.05, 0.05), (-1.4, 1.5)])
def test_the_interval_holds_the_chosen_shifts(shifts):
    """Also beyond a pinch point, where there are three intervals on the line."""
    found = contour_of(pair_task(100, 200, strategy="given", shifts=shifts))
    assert found.points[0].strict
    assert found.low < shifts[0] < found.high
    total, asked = sum(shifts), contour_task(pair_task(100, 200))
    inner = np.linspace(found.low, found.high, 50)
    assert np.min(margins(asked, inner, total - inner).least()) > -1e-9
    outer = np.array([found.low - 1e-4, found.high + 1e-4])
    assert np.max(margins(asked, outer, total - outer).least()) < 0


@pytest.mark.parametrize("task", [NECKED[1], TEN[2], TEN[7]], ids=["100/200", "20/60", "30/90"])
def test_the_line_of_equal_strength_reaches_its_point(task):
    found = contour_of(task)
    point = next(point for point in found.points if point.name == "equal strength")
    x1, x2 = (
        np.concatenate([getattr(line, k) for line in found.lines if line.number == "12, 13"]) for k in ("x1", "x2")
    )
    assert np.min(np.hypot(x1 - point.x1, x2 - point.x2)) < 1e-7 or not np.isclose(
        found.strict.main.area, found.tolerated.main.area
    )
    assert np.max(x1 + x2) >= point.x1 + point.x2 - 1e-9
    here = margins(contour_task(task), x1, x2)
    assert np.min(here.least(False)) > -1e-8
    ends = [here.least(False)[k] for k in (0, -1)]
    assert np.max(ends) < 1e-8  # both ends of the line lie on the contour


@pytest.mark.parametrize("task", TEN[::5], ids=NAMES[::5])
def test_points_against_scipy(task):
    from scipy.optimize import minimize, root

    asked, found = contour_task(task), contour_of(task)
    points = {point.name: point for point in found.points}
    start = np.array([points["balanced"].x1, points["balanced"].x2])
    names = ("undercut1", "undercut2", "tolerated1", "tolerated2", "contact_ratio", "thickness1", "thickness2")

    def limits(x):
        here = margins(asked, *x)
        return np.array([float(getattr(here, name)) for name in names])

    bounds = {"type": "ineq", "fun": limits}
    settings = {"ftol": 1e-14, "maxiter": 200}
    best = minimize(lambda x: -x.sum(), start, constraints=bounds, method="SLSQP", options=settings)
    assert points["C"].x1 + points["C"].x2 == pytest.approx(-best.fun, abs=2e-7)
    best = minimize(
        lambda x: -float(margins(asked, *x).contact_ratio), start, constraints=bounds, method="SLSQP", options=settings
    )
    assert points["E"].contact_ratio - task.limits.contact_ratio == pytest.approx(-best.fun, abs=2e-7)
    assert found.strict.best_contact_ratio == pytest.approx(points["E"].contact_ratio, abs=1e-12)
    if "D" in points:

        def equations(x):
            here = margins(asked, *x)
            return [
                float(here.contact_ratio) + task.limits.contact_ratio - task.desired,
                float(here.theta1 - here.theta2),
            ]

        met = root(equations, start, tol=1e-13)
        assert met.success
        assert (points["D"].x1, points["D"].x2) == pytest.approx(tuple(met.x), abs=1e-9)
    balanced = points["balanced"]
    clear = distances(np.array([[balanced.x1, balanced.x2]]), found.strict.main.x1, found.strict.main.x2)[0]
    rng = np.random.default_rng(1)
    for _ in range(40):  # no place near it is farther from the outline
        other = start + rng.normal(0, 0.05, 2)
        if np.all(limits(other) >= 0):
            assert distances(other[None], found.strict.main.x1, found.strict.main.x2)[0] <= clear + 1e-4


def test_the_worked_case():
    expected = next(c for c in CASES if c["id"] == "IG-S09")["expected"]
    found = contour_of(pair_task(14, 17))
    points = {point.name: point for point in found.points}
    total = points["C"].x1 + points["C"].x2
    assert total == pytest.approx(expected["max_contact_strength_eps1"]["x_sum"], abs=1e-5)
    assert (points["D"].x1, points["D"].x2) == pytest.approx(tuple(expected["equal_sliding_eps1_2"].values()), abs=1e-5)
    assert points["E"].contact_ratio == pytest.approx(1.41823, abs=1e-5)
    assert found.strict.main.area == pytest.approx(expected["strict_area"], abs=1e-3)
    names = {"undercut1", "undercut2", "interference1", "interference2"}
    corners = {frozenset(corner.lines): corner for corner in found.strict.main.corners}
    for corner in expected["strict_vertices"]:
        lines = frozenset(name if name in names else "contact_ratio" for name in corner["curves"])
        assert (corners[lines].x1, corners[lines].x2) == pytest.approx((corner["x1"], corner["x2"]), abs=1e-5)


def test_the_interval_at_the_chosen_sum():
    case = next(c for c in CASES if c["id"] == "IG-S14")
    names = {"uc1": "undercut1", "int1": "interference1", "sa2": "thickness2", "eps": "contact_ratio"}
    total = case["inputs"]["x_sum"]
    for variant, ((low, low_line), (high, high_line)) in zip(
        case["inputs"]["variants"], case["expected"]["intervals"], strict=True
    ):
        shifts = {"strategy": "given", "shifts": (total / 2, total / 2)}
        found = contour_of(pair_task(14, 17, variant["eps_min"], variant["s_a_min"], 15.0, **shifts))
        assert (found.low, found.high) == pytest.approx((low, high), abs=1e-5)
        assert found.ends == (names[low_line], names[high_line])


@pytest.mark.parametrize("task", [TEN[0], TEN[2], TEN[7]], ids=["14/17", "20/60", "30/90"])
def test_lines_hold_their_quantity(task):
    asked, found = contour_task(task), contour_of(task)
    seen = {line.number for line in found.lines}
    assert {"4", "5", "6", "14", "15", "16"} <= seen
    for line in found.lines:
        assert line.x1.size >= 2
        here = margins(asked, line.x1, line.x2)
        if line.title == "contact ratio":
            assert here.contact_ratio + task.limits.contact_ratio == pytest.approx(line.value, abs=1e-9)
        elif line.title.startswith("tip thickness"):
            thick = getattr(here, f"thickness{line.title.split()[4][0]}")
            assert thick + task.limits.tip_thickness == pytest.approx(line.value, abs=1e-9)
        elif line.number == "6":
            assert here.theta1 == pytest.approx(here.theta2, rel=1e-6)
        elif line.number in ("14", "15", "16"):
            assert line.x1 + line.x2 == pytest.approx(line.value, abs=1e-12)


def test_the_chosen_shifts_come_first_with_their_margins():
    pair = solve_pair(pair_task(14, 17, strategy="given", shifts=(0.6, 0.5221944)))
    found = solve_blocking(Pairs((pair,), "", ())).pairs[0]
    chosen = found.points[0]
    assert (chosen.name, chosen.x1, chosen.x2) == ("chosen", 0.6, 0.5221944)
    assert chosen.contact_ratio == pytest.approx(pair.contact_ratio, abs=1e-12)
    assert chosen.distance == pytest.approx(pair.distance, rel=1e-14)
    for k in (0, 1):
        assert chosen.tip_thickness[k] * 0.004 == pytest.approx(pair.sizes[k].tip_thickness, rel=1e-11)
    assert chosen.sliding == pytest.approx((pair.peaks.theta1, pair.peaks.theta2), rel=1e-10)
    assert chosen.strict
    assert found.margins["undercut1"] == pytest.approx(0.6 - pair.sizes[0].least_shift, abs=1e-13)
    assert found.margins["contact_ratio"] == pytest.approx(pair.contact_ratio - 1, abs=1e-12)
    outside = contour_of(pair_task(14, 17, strategy="zero")).points[0]
    assert not outside.strict
    assert outside.tolerated == (min(contour_of(pair_task(14, 17, strategy="zero")).margins[k] for k in LOOSE) >= 0)


LOOSE = ("tolerated1", "tolerated2", "contact_ratio", "thickness1", "thickness2")


def test_an_empty_contour_is_told_with_the_best_contact_ratio():
    found = contour_of(pair_task(14, 17, 1.6, strategy="given", shifts=(0.3, 0.3)))
    assert found.strict.main is None
    assert "1.4182" in found.strict.reason
    assert found.strict.best_contact_ratio == pytest.approx(1.41823, abs=1e-5)
    assert found.points[0].name == "chosen"
    assert [points.names[:3] for points in found.missing] == [("C", "D", "E")]
    assert (found.low, found.high, found.ends) == (None, None, ("", ""))
    assert {line.number for line in found.lines} >= {"5", "4", "14", "15"}


def test_a_point_outside_is_missing_with_its_reason():
    found = contour_of(pair_task(14, 17, 1.25))
    assert "D" not in {point.name for point in found.points}
    assert any(points.names == ("D",) and "least contact ratio" in points.reason for points in found.missing)


def test_other_pairs_and_given_tips_get_a_remark():
    external = solve_pair(pair_task(14, 17, strategy="given", shifts=(0.5, 0.4)))
    ring = replace(external, task=replace(external.task, kind="internal", teeth=(20, 60)))
    rack = replace(external, task=replace(external.task, kind="rack", teeth=(20, 0)))
    tips = replace(external, task=replace(external.task, tips=(0.036, None)))
    found = solve_blocking(Pairs((ring, external, rack, tips), "", ()))
    assert len(found.pairs) == 2
    assert [text.split(":")[0] for text in found.remarks] == ["z = 20/60 (ring)", "z = 20/rack", "z = 14/17"]


@sparing("task", [TEN[0], TEN[7], pair_task(14, 17, 1.6, strategy="zero")], ids=["a", "b", "empty"], every=3)
def test_the_record_and_the_table(task):
    found = solve_blocking(solved(task))
    record = to_record(found)
    again = from_record(Blocking, record)
    assert to_record(again).scalars == record.scalars
    assert all(np.array_equal(again_, record.arrays[k]) for k, again_ in to_record(again).arrays.items())
    columns = blocking_columns(found)
    assert list(columns) == ["pair", "contour", "line", "x1", "x2"]
    assert len({column.size for column in columns.values()}) == 1
    pair = found.pairs[0]
    outlines = [o for area in (pair.strict, pair.tolerated) for o in (area.main, *area.pieces) if o is not None]
    assert columns["x1"].size == sum(o.x1.size for o in outlines)
    for outline in outlines:
        assert (outline.x1[0], outline.x2[0]) == (outline.x1[-1], outline.x2[-1])
        assert outline.edge.size == outline.x1.size - 1
        twice = np.sum(outline.x1[:-1] * outline.x2[1:] - outline.x1[1:] * outline.x2[:-1])
        assert twice / 2 == pytest.approx(outline.area, rel=5e-3)  # counter-clockwise


@pytest.mark.slow
def test_scipy_is_not_needed():
    code = (
        "import sys; from tmmcalc.gears.meshing.solve import solve_pair;"
        "from tmmcalc.gears.meshing.task import PairTask; from tmmcalc.gears.meshing.results import Pairs;"
        "from tmmcalc.gears.meshing.blocking import solve_blocking;"
        "solve_blocking(Pairs((solve_pair(PairTask((14, 17), 0.005)),), '', ()));"
        "sys.exit(any(m.startswith('scipy') for m in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
