"""The blocking contour: boundaries of case s16, corners, closed borders; records and documents."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sparing import sparing

from cams.optimum_scene import CASES, flat_task, roller_task
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.optimum.contour import Contour, contour
from tmmcalc.cams.optimum.margins import NUMBERS, judge, margins
from tmmcalc.cams.optimum.plane import Plane
from tmmcalc.cams.optimum.results import CamOptimum
from tmmcalc.cams.optimum.scene import Scene, scene_of
from tmmcalc.cams.optimum.solve import solve_optimum
from tmmcalc.cams.optimum.zerolines import crossed
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.numerics.roots import bracketed

ROLLER = Follower("translating", 0.06)
SEED = np.array([0.055]), np.array([0.008])


@pytest.fixture(scope="module")
def scene() -> Scene:
    return scene_of(roller_task(), ROLLER, "rise")


@pytest.fixture(scope="module")
def found(scene: Scene) -> Contour:
    return contour(Plane(scene, 0.12), SEED)


def held(scene: Scene, start: Any, roller: Any, height: float = 0.12) -> Any:
    start, roller = np.atleast_1d(start), np.atleast_1d(roller)
    return margins(scene, start, roller, np.full(len(start), height))


def test_boundaries_of_the_case(scene: Scene) -> None:
    """Each printed boundary is a root of its own margin."""
    names = {"slip": 2, "cusp": 3, "tool": 4, "pin": 5, "stem": 7, "guide": 8, "contact": 9}
    for start, sides in CASES["cams-s16"]["expected"]["contour_by_S0_mm"].items():
        for name, roller in {**sides["lower_boundaries"], **sides["upper_boundaries"]}.items():
            row = NUMBERS.index(names[name])
            ends = np.array([(roller - 0.02) * 1e-3]), np.array([(roller + 0.02) * 1e-3])

            def margin(x: Any, _: Any, row: int = row, start: str = start) -> Any:
                return held(scene, np.full(len(x), 1e-3 * float(start)), x)[row]

            assert 1e3 * bracketed(margin, *ends)[0] == pytest.approx(roller, abs=1e-4)


def test_limits_of_figure_5_30() -> None:
    """Case s15: r2 by the contact stress from below, by the pressure in the guide from above, without friction."""
    expected = CASES["cams-s15"]["expected"]
    scene = scene_of(roller_task(0.0), ROLLER, "rise")
    for number, key in ((9, "r2_lower_contact_mm"), (8, "r2_upper_guide_mm")):

        def margin(x: Any, _: Any, row: int = NUMBERS.index(number)) -> Any:
            return held(scene, np.full(len(x), 0.06), x)[row]

        ends = np.array([0.98e-3 * expected[key]]), np.array([1.02e-3 * expected[key]])
        assert 1e3 * bracketed(margin, *ends)[0] == pytest.approx(expected[key], rel=1e-6)


def test_border_is_closed_and_on_the_constraints(scene: Scene, found: Contour) -> None:
    (outline,) = found.outlines
    assert (outline.start[0], outline.roller[0]) == (outline.start[-1], outline.roller[-1])
    least = held(scene, outline.start, outline.roller).min(axis=0)
    assert np.max(np.abs(least)) < 1e-10
    assert outline.area > 0
    assert set(outline.edge.tolist()) == {4, 5, 8}
    for start, sides in CASES["cams-s16"]["expected"]["contour_by_S0_mm"].items():
        low, high = sides["feasible_r2"]
        inside = np.linspace(low, high, 9)[1:-1] * 1e-3
        assert np.all(held(scene, np.full(7, 1e-3 * float(start)), inside) > 0)


def test_corners_meet_two_constraints(scene: Scene, found: Contour) -> None:
    corners = found.outlines[0].corners
    assert sorted(tuple(sorted(corner.numbers)) for corner in corners) == [(4, 5), (4, 8), (5, 8)]
    for corner in corners:
        value = held(scene, corner.start, corner.roller)[:, 0]
        assert max(abs(value[NUMBERS.index(number)]) for number in corner.numbers) < 1e-10
        assert np.min(value) > -1e-10


def test_area_against_a_raster(scene: Scene, found: Contour) -> None:
    low, high, bottom, top = found.window
    x, y = np.linspace(low, high, 160), np.linspace(bottom, top, 160)
    good = np.all(held(scene, np.repeat(x, 160), np.tile(y, 160)) >= 0, axis=0)
    cell = (x[1] - x[0]) * (y[1] - y[0])
    assert found.area == pytest.approx(np.count_nonzero(good) * cell, rel=0.02)


def test_curves_are_roots(scene: Scene, found: Contour) -> None:
    assert {curve.number for curve in found.curves} >= {2, 4, 5, 8, 9}
    for curve in found.curves:
        row = NUMBERS.index(curve.number)
        assert np.max(np.abs(held(scene, curve.start, curve.roller)[row])) < 5e-3


def test_curves_have_no_gaps_where_they_are_steep() -> None:
    """Curve 2 runs close to where the follower jams, beyond which its margin says nothing."""
    scene = scene_of(roller_task(), ROLLER)
    on = contour(Plane(scene, 0.12), SEED)
    low, high, bottom, top = on.window
    sizes = np.array([high - low, top - bottom])
    for number in (2, 5, 7):
        ends = []
        for curve in on.curves:
            if curve.number == number:
                line = np.stack((curve.start - low, curve.roller - bottom), axis=1) / sizes
                ends += [line[0], line[-1]]
        inner = [each for each in ends if np.all(each > 0.01) and np.all(each < 0.99)]
        assert not inner, number


def test_curves_bend_smoothly(found: Contour) -> None:
    """Long chords that turn sharply stay only where the curve itself has a corner."""
    for curve in found.curves:
        points = np.stack((curve.start, curve.roller))
        size = np.array([[found.window[1] - found.window[0]], [found.window[3] - found.window[2]]])
        chord = np.diff(points / size, axis=1)
        along = chord[0] + 1j * chord[1]
        turn = np.abs(np.angle(along[1:] / along[:-1]))
        short = np.minimum(np.abs(along[1:]), np.abs(along[:-1]))
        assert np.all((turn < 0.5) | (short < 0.02)), curve.number


def test_smaller_height_smaller_region(scene: Scene, found: Contour) -> None:
    lower = contour(Plane(scene, 0.11), SEED)
    assert 0 < lower.area < found.area
    for outline in lower.outlines:
        assert np.all(held(scene, outline.start, outline.roller).min(axis=0) > -1e-9)


def test_steps_of_the_shaft_curve() -> None:
    """A shaft in whole mm: the border runs along S0 - r2 = n mm, or along where r1 is one."""
    task = roller_task()
    stout = replace(task, requirements=replace(task.requirements, span=1.2))
    scene = scene_of(stout, ROLLER, "rise")
    (outline,) = contour(Plane(scene, 0.12), (np.array([0.065]), np.array([0.008]))).outlines
    on = np.flatnonzero(outline.edge == 6) + 1
    assert len(on) > 3
    start, roller = outline.start[on], outline.roller[on]
    gap = 1e3 * (start - roller)
    least = 1e3 * judge(scene, start, roller, np.full(len(on), 0.12)).shaft[:2].max(axis=0)
    away = np.minimum(np.abs(gap - np.round(gap)), np.abs(least - np.round(least)))
    assert np.max(away) < 1e-6
    assert any(6 in corner.numbers for corner in outline.corners)


def test_marching_finds_rings_and_open_lines() -> None:
    x = np.linspace(-2, 2, 40)
    ring = crossed(1 - x[:, None] ** 2 - x[None] ** 2)
    assert len(ring.lines) == 1
    assert ring.lines[0][0] == ring.lines[0][-1]
    slope = crossed(x[:, None] - 0.3 * x[None])
    assert len(slope.lines) == 1
    assert slope.lines[0][0] != slope.lines[0][-1]
    assert len(crossed(np.abs(x[:, None] ** 2 + x[None] ** 2 - 2) - 0.7).lines) == 2


def same(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and np.array_equal(a, b)
    if is_dataclass(a):
        return type(a) is type(b) and all(same(getattr(a, f.name), getattr(b, f.name)) for f in fields(a))
    if isinstance(a, tuple):
        return isinstance(b, tuple) and len(a) == len(b) and all(map(same, a, b))
    return type(a) is type(b) and bool(a == b)


@pytest.mark.slow
@sparing("kind", ["translating", "flat"], every=2, first=1)
def test_round_trip_documents_and_pictures(kind: str, tmp_path: Path) -> None:
    from drawing import draw_cam

    from tmmcalc.cams.facts.cam_optimum import document as optimum_document
    from tmmcalc.cams.facts.cam_optimum import summary as optimum_summary
    from tmmcalc.report.plaintext import lines
    from tmmcalc.report.render import _json

    task = roller_task(guide=0.12, laws=("cosine", "sine")) if kind == "translating" else flat_task(laws=("shun",))
    result = solve_optimum(task, ROLLER if kind == "translating" else Follower("flat", 0.05))
    assert same(result, from_record(CamOptimum, to_record(result)))
    text = "\n".join(lines(optimum_document(result, "cam")))
    assert ("blocking contour at H2 = 120 mm" in text) == (kind == "translating")
    assert "pressure in the guide" in text
    assert "H2 = " in "\n".join(lines(optimum_summary(result, "cam")))
    assert '"H2_least[m]"' in _json(optimum_document(result, "cam", everything=True))
    draw_cam("cam_optimum", task, result, tmp_path / "a.png")
    assert (tmp_path / "a.png").stat().st_size > 20_000


def test_height_below_the_least_is_told() -> None:
    result = solve_optimum(roller_task(guide=0.1), ROLLER)
    assert any(note.startswith("warning:") and "105.831 mm" in note for note in result.notes)
    assert [round(1e3 * each.height) for each in result.contours] == [107]
