"""Pictures of pairs and tooth profiles: what is drawn against geometry, closed forms and the results that it shows."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing import drawn
from paper import arcs, covered, curves, written
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.core.plane import Plane
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import Kind, PairTask
from tmmcalc.gears.pictures.generation import generation_of
from tmmcalc.gears.pictures.pair import pair_drawing
from tmmcalc.gears.pictures.pairtable import parameters
from tmmcalc.gears.pictures.placedpair import PlacedPair, placed_pair
from tmmcalc.gears.pictures.profile import profile_drawing
from tmmcalc.gears.pictures.sketch import WORKING, spread
from tmmcalc.gears.pictures.slidingcurves import SLIDING, course, singles
from tmmcalc.gears.pictures.toothdrawing import OUTLINE
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.page import A4
from tmmcalc.report.drawing.pens import DIMENSION
from tmmcalc.report.drawing.shapes import Drawing

M = 0.005
TASKS: dict[str, tuple[tuple[int, int], tuple[float, float], Kind, float]] = {
    "helical": ((14, 17), (0.6, 0.522), "external", 15.0),
    "spur": ((14, 27), (0.4, 0.2), "external", 0.0),
    "undercut": ((10, 30), (0.0, 0.0), "external", 0.0),
    "large": ((20, 100), (0.3, 0.0), "external", 0.0),
    "ring": ((20, 60), (0.3, 0.1), "internal", 0.0),
    "helical ring": ((20, 60), (0.0, 0.0), "internal", 20.0),
    "pointed": ((14, 17), (1.2, 1.0), "external", 0.0),
    "rack": ((18, 0), (0.0, 0.0), "rack", 0.0),
    "helical rack": ((14, 0), (0.4, 0.0), "rack", 15.0),
}
ALL = tuple(name for name in TASKS if name != "pointed")
WITH_P0 = ("helical", "spur", "large", "ring")


@cache
def solved(name: str, cutter: Cutter | None = None) -> MeshPair:
    teeth, shifts, kind, helix = TASKS[name]
    more: dict[str, Any] = {"strategy": "given", "refuse": False, "strict": False, "face_width": 0.04}
    return solve_pair(PairTask(teeth, M, kind=kind, shifts=shifts, helix=math.radians(helix), cutter=cutter, **more))


@cache
def drawing_of(name: str) -> Drawing:
    return pair_drawing(Pairs((solved(name),), "", ()))


@cache
def profile_of(name: str) -> Drawing:
    return profile_drawing(Pairs((solved(name),), "", ()))


def placed(name: str, phase: float = 0.0) -> PlacedPair:
    return placed_pair(solved(name), phase)


def distance_to(line: Plane, points: Plane) -> np.ndarray:
    """Distance of points (n,) from a polyline."""
    start, run = line[:-1], np.diff(line)
    start, run = start[np.abs(run) > 0], run[np.abs(run) > 0]
    t = np.clip(((points[:, None] - start) / run).real, 0.0, 1.0)
    return np.asarray(np.min(np.abs(points[:, None] - start - t * run), axis=1))


def inside(polygon: Plane, points: Plane) -> np.ndarray:
    """Whether points (n,) lie inside a closed polygon, by counting crossings."""
    a, b = polygon, np.roll(polygon, -1)
    y = points.imag[:, None]
    crosses = (a.imag > y) != (b.imag > y)
    rise = np.where(crosses, b.imag - a.imag, 1.0)
    x = a.real + (y - a.imag) / rise * (b.real - a.real)
    return np.asarray(np.sum(crosses & (x > points.real[:, None]), axis=1) % 2 == 1)


@pytest.mark.parametrize("name", ALL)
class TestPlaces:
    def test_line_of_action_touches_the_base_circles_and_meets_the_tips(self, name: str) -> None:
        pair = placed(name)
        for body in pair.bodies:
            if body.sizes is None:
                continue
            foot = pair.mark(f"N{body.number}").at
            assert abs(foot - body.centre) == pytest.approx(body.sizes.base, rel=1e-12)
            assert ((foot - body.centre) * np.conj(pair.direction)).real == pytest.approx(0.0, abs=1e-12)
            tip = pair.mark(f"A{body.number}").at
            assert abs(tip - body.centre) == pytest.approx(body.sizes.tip, rel=1e-9)
            assert abs(pair.pitch_point - body.centre) == pytest.approx(body.sizes.operating, rel=1e-12)
        assert pair.mark("P").at == pytest.approx(pair.pitch_point, abs=1e-12)
        if pair.bodies[1].kind == "rack":
            assert pair.mark("A2").at.imag == pytest.approx(pair.bodies[1].edge.imag.min(), abs=1e-12)

    def test_distance_of_the_centres(self, name: str) -> None:
        pair = placed(name)
        first, second = pair.bodies
        assert abs(second.centre - first.centre) == pytest.approx(pair.found.distance, rel=1e-12)

    @pytest.mark.parametrize("phase", [0.0, 0.1, -0.17])
    def test_flanks_touch_where_the_picture_says(self, name: str, phase: float) -> None:
        pair = placed(name, phase)
        at = pair.on_line(pair.contacts())
        assert len(at) >= 1
        for body in pair.bodies:
            assert distance_to(body.edge, at).max() < 2e-4 * M  # chords of the outline
            assert min(np.concatenate([distance_to(flank, at) for flank in body.flanks])) < 2e-4 * M

    @pytest.mark.parametrize("phase", [0.0, 0.1])
    def test_teeth_do_not_overlap(self, name: str, phase: float) -> None:
        first, second = placed(name, phase).bodies
        shown = np.concatenate([first.edge, first.back[::-1]])
        hidden = inside(shown, second.edge)
        assert distance_to(first.edge, second.edge[hidden]).max(initial=0.0) < 3e-4 * M

    def test_outlines_keep_between_tip_and_root(self, name: str) -> None:
        for body in placed(name).bodies:
            if body.sizes is None:
                height = body.edge.imag - body.centre.imag
                assert np.ptp(height) == pytest.approx(2.25 * M)
                continue
            radii = np.abs(body.edge - body.centre)
            low, high = sorted((body.sizes.root, body.sizes.tip))
            assert radii.min() == pytest.approx(low, rel=2e-4)
            assert radii.max() == pytest.approx(high, rel=1e-9)

    def test_active_flanks(self, name: str) -> None:
        pair = placed(name)
        line = pair.found.line
        first = np.abs(pair.bodies[0].flanks[0])
        base = pair.found.sizes[0].base
        assert first.min() == pytest.approx(math.hypot(base, max(line.begins, 0)), rel=1e-9)
        assert first.max() == pytest.approx(math.hypot(base, line.ends), rel=1e-9)
        if pair.bodies[1].sizes is not None:
            second = np.abs(pair.bodies[1].flanks[0] - pair.bodies[1].centre)
            rho = np.abs(line.length - np.array([line.begins, line.ends]))
            reached = np.hypot(pair.bodies[1].sizes.base, rho)
            assert [second.min(), second.max()] == pytest.approx(sorted(reached), rel=1e-9)


@pytest.mark.parametrize("name", WITH_P0)
def test_generating_points_lie_on_flanks_and_reference_circles(name: str) -> None:
    pair = placed(name)
    assert pair.gamma == pytest.approx(_gamma(pair.found), rel=1e-9)
    for body in pair.bodies:
        assert body.sizes is not None
        up = -1j if body.number == 2 and body.kind == "external" else 1j
        at = body.centre + body.sizes.reference * up * np.exp(1j * pair.gamma)
        assert distance_to(body.edge, np.array([at]))[0] < 2e-4 * M


def _gamma(found: MeshPair) -> float:
    sign = -1 if found.task.kind == "internal" else 1
    total = found.task.teeth[0] * sign + found.task.teeth[1]
    return sign * 2 * sum(found.shifts) * math.tan(found.task.rack.angle) / total


@pytest.mark.parametrize("name", TASKS)
def test_active_flanks_lie_on_the_teeth(name: str) -> None:
    for body in placed(name).bodies:
        for flank in body.flanks:
            assert distance_to(body.edge, flank).max() < 2e-4 * M


class TestMesh:
    @sparing("name", ALL, every=8)
    def test_every_circle_is_drawn_with_its_radius(self, name: str) -> None:
        drawing = drawing_of(name)
        shown, said = arcs(drawing.fields[0]), " ".join(written(drawing))
        for body in placed(name).bodies:
            if body.sizes is None:
                assert all(word in said for word in ("root line", "tip line", "datum", "pitch line"))
                continue
            for radius in (
                body.sizes.tip,
                body.sizes.operating,
                body.sizes.base,
                body.sizes.root,
                body.sizes.reference,
            ):
                assert any(abs(at - body.centre) < 1e-9 and abs(r - radius) < 1e-9 for at, r in shown)
                assert f"= {1e3 * radius:.5g}" in said

    def test_scale_holds_on_paper(self) -> None:
        drawing = drawing_of("helical")
        (head,) = [text for text in written(drawing) if "lengths in mm" in text]
        scale = float(head.split("= ")[1].split(" m/mm")[0])
        board = drawing.fields[0]
        for way in (1.0, 1j):
            assert board.place(way * scale) - board.place(0.0) == pytest.approx(way, rel=1e-9)

    @sparing("name", ALL, every=8)
    def test_teeth_are_tall(self, name: str) -> None:
        """A tooth is at least 40 mm high on paper wherever the contact A2A1 and the teeth about it then fit."""
        pair, board = placed(name), drawing_of(name).fields[0]
        mm = abs(board.data(1.0) - board.data(0.0))
        heights = [abs(body.sizes.tip - body.sizes.root) for body in pair.bodies if body.sizes is not None]
        assert min(heights) / mm >= 40
        ends = board.paper(pair.on_line(np.array([pair.found.line.begins, pair.found.line.ends])))
        assert all(board.box.left < z.real < board.box.right for z in ends.tolist())

    @sparing("name", ALL, every=8)
    def test_what_is_drawn_strong_are_the_active_flanks(self, name: str) -> None:
        pair, board = placed(name), drawing_of(name).fields[0]
        for body in pair.bodies:
            shown = curves(board, WORKING[body.number - 1])
            assert shown
            for z in shown:
                assert min(distance_to(flank, z).max() for flank in body.flanks) < 1e-6 * M

    def test_names_of_points(self) -> None:
        said = written(drawing_of("helical"))
        for name in ("N_1", "L_1", "A_2", "A_1", "L_2", "N_2", "P_{01}", "P_{02}", "D_1", "D_2"):
            assert f"${name}$" in said
        assert "$P$" in said
        assert "$α_{tw}$ = 27.956°" in said

    def test_distance_of_the_reference_circles(self) -> None:
        """y m is the centre distance less that of the reference circles, and so long is its line."""
        found, board = solved("helical"), drawing_of("helical").fields[0]
        size = found.distance - found.reference_distance
        upright = [z for z in curves(board, DIMENSION) if len(z) == 2 and abs(z[0].real - z[1].real) < 1e-12]
        assert any(abs(z[1] - z[0]) == pytest.approx(size, rel=1e-9) for z in upright)
        assert "$y$$m$ = 4.765" in written(drawing_of("helical"))

    def test_undercut_ends_the_contact_at_the_involute(self) -> None:
        pair = placed("undercut")
        assert pair.mark("F1").rho == pytest.approx(pair.found.line.begins, rel=1e-9)
        assert pair.mark("A2").rho < 0 < pair.mark("F1").rho
        rows = {row[0]: row for row in parameters(pair.found)}
        assert rows["with the flanks left"][-1] == "1.0927"

    def test_table(self) -> None:
        found = solved("helical")
        rows = {row[0]: row[1:] for row in parameters(found)}
        assert rows["teeth $z$"] == ("14", "17")
        assert rows["centre distance $a_w$"][-1] == "84.999"
        assert rows["contact ratio $ε_α$"][-1] == "1.112"
        # m z/(2 cos beta)
        assert rows["reference circle $r$"] == ("36.235", "43.999")
        assert rows["clearance at the root"] == ("1.25", "1.25")
        shown = written(drawing_of("helical"))
        assert all(text in shown for row in parameters(found) for text in row)

    @sparing("name", ALL, every=8)
    def test_texts_do_not_cover_each_other(self, name: str) -> None:
        assert not covered(drawing_of(name))

    def test_a_pair_that_there_is_not(self) -> None:
        for draw in (pair_drawing, profile_drawing):
            for choose in (0, 2):
                with pytest.raises(UsageError, match=f"no pair {choose}"):
                    draw(Pairs((solved("spur"),), "", ()), choose=choose)

    @pytest.mark.slow
    def test_one_of_several(self) -> None:
        several = Pairs((solved("spur"), solved("large")), "", ())
        assert pair_drawing(several).height == 4 * A4.height
        chosen = pair_drawing(several, choose=2)
        assert chosen.height == 2 * A4.height
        assert "100" in written(chosen)

    def test_a_name_with_a_sign_of_formulas(self) -> None:
        found = solved("spur")
        named = replace(found, task=replace(found.task, name="5 $ a piece"))
        assert any("5 \\$ a piece" in text for text in written(pair_drawing(Pairs((named,), "", ()))))


class TestCourse:
    @pytest.mark.parametrize("name", ALL)
    def test_curves_are_those_of_the_table(self, name: str) -> None:
        found = solved(name)
        table = found.sliding
        points = course(found, table.rho1)
        for own, other in (
            (points.theta1, table.theta1),
            (points.theta2, table.theta2),
            (points.pressure, table.pressure),
        ):
            assert own == pytest.approx(other, rel=1e-9, abs=1e-9)

    @sparing("name", ALL, every=8)
    def test_points_stand_below_their_places_in_the_mesh(self, name: str) -> None:
        pair = placed(name)
        mesh, upper, lower = drawing_of(name).fields[:3]
        line = pair.found.line
        for diagram in (upper, lower):
            assert isinstance(diagram, Diagram)
            assert (diagram.box.left, diagram.box.right) == (mesh.box.left, mesh.box.right)
            for rho in (line.begins, line.pitch, line.ends):
                below = diagram.place(complex(1e3 * rho, 0.0)).real
                assert below == pytest.approx(mesh.place(complex(pair.on_line(rho))).real, abs=1e-6)
        (curve,) = curves(upper, SLIDING[0])
        assert isinstance(upper, Diagram)
        ends = curve[np.argsort(curve.real)][[0, -1]]
        for end, rho in zip(ends, sorted((line.begins, line.ends)), strict=True):
            deep = course(pair.found, np.array([rho])).theta1[0] < upper.y.low  # the frame cuts the curve off
            assert end.imag == pytest.approx(upper.y.low) if deep else end.real == pytest.approx(1e3 * rho, abs=1e-6)
        order = np.argsort(curve.imag)
        assert np.interp(0.0, curve.imag[order], curve.real[order]) == pytest.approx(1e3 * line.pitch, abs=2 * M)

    def test_where_one_pair_of_teeth_touches(self) -> None:
        pair = placed("spur")
        (_, second), (_, first) = singles(pair)
        line, pitch = pair.found.line, math.pi * M * math.cos(math.radians(20))
        assert second == pytest.approx(line.ends - pitch)
        assert first == pytest.approx(line.begins + pitch)
        middle = placed_pair(pair.found, (line.pitch - (first + second) / 2) / pair.found.sizes[0].base)
        assert len(middle.contacts()) == 1
        late = placed_pair(pair.found, (line.pitch - (first + line.ends) / 2) / pair.found.sizes[0].base)
        assert len(late.contacts()) == 2


class TestProfile:
    @sparing("name", ALL, every=8)
    @pytest.mark.parametrize("place", [0, 1])
    def test_the_tool_leaves_the_outline(self, name: str, place: int) -> None:
        member = both(solved(name))[place]
        found = generation_of(member, positions=121)
        space = _closed(found.outline, member.shape)
        cut = np.concatenate(found.positions)
        within = inside(space, cut)
        assert distance_to(found.outline, cut[within]).max(initial=0.0) < 4e-4 * M  # nothing is cut off the tooth
        flank = _flank(member, found.outline)
        near = distance_to(cut, flank)
        assert near.max() < 2e-3 * M  # and every point of the active flank is reached

    def test_the_path_of_the_centre_keeps_its_distance_from_the_fillet(self) -> None:
        member = both(solved("spur"))[0]
        found = generation_of(member)
        assert found.path is not None
        radius = 0.25 * M / (1 - math.sin(math.radians(20)))
        deepest = np.abs(found.path).min()
        assert deepest - radius == pytest.approx(solved("spur").sizes[0].root, rel=1e-6)

    @pytest.mark.parametrize("cutter", [Cutter(25), Cutter(30, 0.1, 0.3)])
    def test_cutter_of_a_ring(self, cutter: Cutter) -> None:
        member = both(solved("ring", cutter))[1]
        found = generation_of(member, positions=121)
        assert "cutter" in found.what
        reached = np.abs(np.concatenate(found.positions)).max()
        assert reached == pytest.approx(member.found.sizes[1].root, rel=1e-6)
        cut = np.concatenate(found.positions)
        within = inside(_closed(found.outline, "ring"), cut)
        assert distance_to(found.outline, cut[within]).max(initial=0.0) < 4e-4 * M

    @sparing("name", ["helical", "undercut", "ring", "rack"], every=8)
    def test_the_enlarged_tooth(self, name: str) -> None:
        drawing = profile_of(name)
        for place in (0, 1):
            member = both(solved(name))[place]
            half = half_tooth(member)
            board = drawing.fields[3 * place + 1]
            height: Callable[[Plane], Any] = np.imag if member.shape == "rack" else np.abs
            (outline,) = curves(board, OUTLINE)
            assert _spans(height(outline), half, member.module)
            assert outline[-1].real == pytest.approx(0.0, abs=1e-9)
            joint = "F" if half.undercut or member.shape != "external" else "L"
            assert {f"${joint}$", "$D$", "$A$"} <= set(written(drawing, board.box))

    @sparing("name", ["helical", "undercut", "ring", "rack"], every=8)
    def test_texts_do_not_cover_each_other(self, name: str) -> None:
        assert not covered(profile_of(name))

    def test_radii_of_curvature(self) -> None:
        sizes = solved("helical").sizes[0]
        said = written(profile_of("helical"))
        assert sizes.limit is not None
        for value in (sizes.limit, math.sqrt(sizes.tip**2 - sizes.base**2)):
            assert any(text == f"{round(1e3 * value, 4):.7g}" for text in said)


def _spans(values: np.ndarray, half: Any, module: float) -> bool:
    low, high = sorted((module * half.root, module * half.tip))
    return bool(abs(values.min() - low) < 1e-9 and abs(values.max() - high) < 1e-9)


def _closed(outline: Plane, shape: str) -> Plane:
    """The metal around a space, its edges closed far behind it."""
    first, last = outline[0], outline[-1]
    if shape == "rack":
        return np.concatenate([outline, [complex(last.real, -1.0), complex(first.real, -1.0)]])
    out = 1.1 if shape == "ring" else 0.5
    radius = out * (np.abs(outline).max() if shape == "ring" else np.abs(outline).min())
    turn = np.angle(np.array([last, first]) / 1j)
    behind = radius * 1j * np.exp(1j * np.linspace(turn[0], turn[1], 60))
    return np.concatenate([outline, behind])


def _flank(member: Any, outline: Plane) -> Plane:
    """Points of the outline within the contact."""
    found, line = member.found, member.found.line
    if member.shape == "rack":
        rise = (np.array([line.begins, line.ends]) - line.pitch) * math.sin(found.angle_w)
        low, high = sorted(M * float(member.wheel.shift) - rise)
        return outline[(outline.imag > low + 1e-6) & (outline.imag < high - 1e-6)]
    rho = np.array([line.begins, line.ends])
    rho = rho if member.place == 0 else np.abs(line.length - rho)
    low, high = sorted(np.hypot(found.sizes[member.place].base, rho))
    radii = np.abs(outline)
    return outline[(radii > low + 1e-6) & (radii < high - 1e-6)]


def test_texts_in_a_column_are_moved_apart_and_kept_in_order() -> None:
    heights = spread([5.0, 4.9, 4.8, 1.0], 0.5, 0.0, 5.2)
    assert heights[0] == pytest.approx(5.2)
    assert np.all(np.diff(heights) <= -0.5 + 1e-5)
    assert heights[-1] == pytest.approx(1.0)
    assert max(heights) <= 5.2 + 1e-5


@pytest.mark.slow
@sparing("stage", ["pair", "profile"], every=2)
def test_equal_results_give_equal_bytes(stage: str, tmp_path: Path) -> None:
    pictures = []
    for name in ("one.svg", "two.svg"):
        drawn(stage, "gears", tmp_path / name, Pairs((solved("helical"),), "", ()))
        pictures.append((tmp_path / name).read_bytes())
    assert pictures[0] == pictures[1]
    assert pictures[0].startswith(b"<?xml")
