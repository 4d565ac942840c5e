"""The picture of the blocking contour: what is drawn against the record that it shows."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing import drawn
from sparing import sparing

pytest.importorskip("matplotlib")

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, PathPatch

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.meshing.blocking import solve_blocking
from tmmcalc.gears.meshing.choice import contour_task
from tmmcalc.gears.meshing.contours import Blocking, ContourLine, PairContour
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.pictures.blocking import blocking_figure
from tmmcalc.gears.pictures.contourkey import SIZE
from tmmcalc.gears.pictures.contourlines import least_shifts, number_of, strokes
from tmmcalc.gears.pictures.contourlook import BELT, BORDER, FILL, STRICT, together
from tmmcalc.gears.pictures.contourpaths import paths_of, smooth
from tmmcalc.report.drawing.style import INK, MARK

PAIRS: dict[str, dict[str, Any]] = {
    "14/17": {"teeth": (14, 17), "shifts": (0.6, 0.5222)},
    "14/27": {"teeth": (14, 27), "shifts": (0.35, 0.2), "helix": math.radians(15), "name": "1-2"},
    "10/80": {"teeth": (10, 80), "shifts": (0.6, 0.6), "limits": QualityLimits(tip_thickness=0.3)},
    "5/200": {"teeth": (5, 200), "shifts": (0.73, 2.3)},
    "30/100": {"teeth": (30, 100), "shifts": (0.2, 0.1)},
    "stub": {
        "teeth": (14, 17),
        "shifts": (0.0, 0.0),
        "rack": Rack(addendum=0.8, clearance=0.3),
        "limits": QualityLimits(contact_ratio=1.1),
    },
    "empty": {"teeth": (14, 17), "shifts": (0.4, 0.3), "limits": QualityLimits(contact_ratio=1.9)},
}


def task_of(name: str) -> PairTask:
    return PairTask(module=0.005, strategy="given", refuse=False, **PAIRS[name])


@cache
def pair_of(name: str) -> PairContour:
    (found,) = solve_blocking(Pairs((solve_pair(task_of(name)),), "", ())).pairs
    return found


def line(number: str, title: str, value: float) -> ContourLine:
    return ContourLine(number, title, value, np.array([0.0, 1.0]), np.array([0.0, value]))


@cache
def sheet_of(name: str) -> tuple[PairContour, Figure, Axes, Axes]:
    pair = pair_of(name)
    figure = blocking_figure(Blocking((pair,), ()))
    FigureCanvasAgg(figure)  # keeps the renderer by which texts are measured, else each is measured by one of its own
    plane, key = figure.axes
    return pair, figure, plane, key


def texts(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.texts]


def data(line: Line2D) -> np.ndarray:
    return np.asarray(line.get_xydata())


def rings(axes: Axes) -> list[Circle]:
    return [patch for patch in axes.patches if isinstance(patch, Circle)]


def corners(axes: Axes) -> tuple[complex, complex]:
    (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
    return complex(x0, y0), complex(x1, y1)


def shoelace(x: np.ndarray, y: np.ndarray) -> float:
    return float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2


def border(axes: Axes, width: float) -> np.ndarray:
    (line,) = [line for line in axes.lines if line.get_linewidth() == width and line.get_color() == INK and loop(line)]
    return data(line)


def loop(line: Line2D) -> bool:
    z = data(line)
    return len(z) > 3 and bool(np.all(z[0] == z[-1]))


@sparing("name", PAIRS, every=3)
class TestSheet:
    def test_both_directions_have_one_scale(self, name: str) -> None:
        _, _, axes, _ = sheet_of(name)
        box, (x0, x1), (y0, y1) = axes.get_window_extent(), axes.get_xlim(), axes.get_ylim()
        assert (x1 - x0) / box.width == pytest.approx((y1 - y0) / box.height, rel=1e-9)

    def test_contours_and_chosen_shifts_are_inside(self, name: str) -> None:
        pair, _, axes, _ = sheet_of(name)
        low, high = corners(axes)
        spots = [complex(pair.points[0].x1, pair.points[0].x2)]
        for area in (pair.strict, pair.tolerated):
            if area.main is not None:
                spots += (area.main.x1 + 1j * area.main.x2).tolist()
        assert all(low.real < z.real < high.real and low.imag < z.imag < high.imag for z in spots)

    def test_every_line_of_the_record_is_drawn(self, name: str) -> None:
        pair, _, axes, _ = sheet_of(name)
        low, high = corners(axes)
        labels = {str(line.get_label()).rstrip("abc"): line for line in axes.lines}
        drawn = [(str(line.get_label()).rstrip("abc"), data(line)) for line in axes.lines]
        shown = 0
        for line in pair.lines:
            inside = (line.x1 > low.real) & (line.x1 < high.real) & (line.x2 > low.imag) & (line.x2 < high.imag)
            if line.number.split(", ")[0] in ("14", "15", "16"):
                if f"_{line.number}" not in labels:
                    assert not low.real + low.imag < line.value < high.real + high.imag
                    continue
                assert np.allclose(data(labels[f"_{line.number}"]).sum(axis=1), line.value, atol=1e-12)
                shown += 1
            elif np.count_nonzero(inside) > 20:
                path = np.column_stack((line.x1, line.x2))
                assert any(label == f"_{line.number}" and np.array_equal(path, z) for label, z in drawn)
                shown += 1
        assert shown >= 2

    def test_every_line_has_its_number_and_a_row_of_the_key(self, name: str) -> None:
        _, _, axes, key = sheet_of(name)
        numbers = {part for line in axes.lines for part in str(line.get_label())[1:].split(", ")}
        numbers = {part for part in numbers if part[:1].isdigit() and not part.startswith("child")}
        assert {"2", "14"} < numbers
        assert numbers <= set(texts(axes))
        assert numbers <= set(texts(key))

    def test_numbers_are_clear_of_each_other_and_of_the_border(self, name: str) -> None:
        _, _, axes, _ = sheet_of(name)
        low, high = corners(axes)
        found = [complex(*ring.center) for ring in rings(axes)]
        radius = rings(axes)[0].radius
        assert all(low.real + radius < z.real < high.real - radius for z in found)
        assert all(low.imag + radius < z.imag < high.imag - radius for z in found)
        apart = [abs(a - b) for k, a in enumerate(found) for b in found[:k]]
        assert min(apart) > 2 * radius

    def test_names_of_points_stand_in_the_picture_apart(self, name: str) -> None:
        pair, _, axes, _ = sheet_of(name)
        said = {point.name for point in pair.points}
        boxes = [text.get_window_extent() for text in axes.texts if said & set(text.get_text().split(" = "))]
        assert boxes
        frame = axes.get_window_extent()
        for k, box in enumerate(boxes):
            assert frame.x0 < box.x0 < box.x1 < frame.x1
            assert frame.y0 < box.y0 < box.y1 < frame.y1
            assert not any(box.overlaps(other) for other in boxes[:k])

    def test_the_key_keeps_to_its_column(self, name: str) -> None:
        _, figure, axes, key = sheet_of(name)
        column, page = key.get_window_extent(), figure.bbox
        for text in key.texts:
            box = text.get_window_extent()
            assert axes.get_window_extent().x1 < box.x0
            assert box.x1 < page.x1
            assert column.y0 - 2 < box.y0

    def test_chosen_shifts_in_figures(self, name: str) -> None:
        pair, _, _, key = sheet_of(name)
        point, said = pair.points[0], [text.replace("\N{MINUS SIGN}", "-") for text in texts(key)]
        for value in (
            f"{point.x1:.4f}",
            f"{point.x2:.4f}",
            f"{point.contact_ratio:.3f}",
            f"{1e3 * point.distance:.3f}",
        ):
            assert value in said
        for value in (*point.tip_thickness, *pair.margins.values()):
            assert f"{value:.3f}" in said or f"{value:.4f}" in said
        where = "strict contour" if point.strict else "hatched belt" if point.tolerated else "not admissible"
        assert any(text.startswith("Chosen shifts: ") and text.endswith(where) for text in said)


@sparing("name", [name for name in PAIRS if name != "empty"], every=3)
class TestAreas:
    @pytest.mark.parametrize("strict", [True, False])
    def test_borders_are_closed_and_those_of_the_record(self, name: str, strict: bool) -> None:
        pair, _, axes, _ = sheet_of(name)
        look, area = (STRICT, pair.strict) if strict else (BELT, pair.tolerated)
        main = area.main
        assert main is not None
        drawn = border(axes, look[BORDER]["linewidth"])
        points = {tuple(point) for point in drawn.tolist()}
        assert {(x1, x2) for x1, x2 in zip(main.x1.tolist(), main.x2.tolist(), strict=True)} <= points
        assert shoelace(*drawn.T) == pytest.approx(main.area, rel=2e-4)

    def test_points_between_those_of_the_record_lie_on_the_contour(self, name: str) -> None:
        pair, task = pair_of(name), contour_task(task_of(name))
        assert pair.strict.main is not None
        z = smooth(pair.strict.main)
        assert len(z) > 3 * pair.strict.main.x1.size
        assert np.max(np.abs(margins(task, z.real, z.imag).least())) < 2e-3

    def test_the_filled_areas(self, name: str) -> None:
        pair, _, axes, _ = sheet_of(name)
        filled = [patch for patch in axes.patches if isinstance(patch, PathPatch) and patch.get_facecolor()[3] > 0]
        (hatch, *pale) = axes.collections
        for look, which in ((BELT, pair.tolerated), (STRICT, pair.strict)):
            (patch,) = [patch for patch in filled if to_hex(patch.get_facecolor()) == look[FILL]["facecolor"]][:1]
            assert which.main is not None
            assert shoelace(*patch.get_path().vertices.T) == pytest.approx(which.main.area, rel=2e-4)
            if look is BELT:
                clip = hatch.get_clip_path()
                assert clip is not None
                assert np.array_equal(
                    clip.get_fully_transformed_path().vertices,
                    patch.get_transform().transform(patch.get_path().vertices),
                )
        assert len(pale) == bool(pair.tolerated.pieces)
        strokes_over = [patch.get_zorder() for patch in filled]
        assert strokes_over == sorted(strokes_over)


class TestLines:
    def test_limits_of_undercut_run_across_the_picture(self) -> None:
        _, _, axes, _ = sheet_of("14/17")
        low, high = corners(axes)
        least = [1 - z * math.sin(math.radians(20)) ** 2 / 2 for z in (14, 17)]
        for number, place, ends in (("_2", 0, (low.imag, high.imag)), ("_10", 1, (low.real, high.real))):
            (line,) = [data(line) for line in axes.lines if line.get_label() == number]
            assert line[:, place] == pytest.approx(least[place], abs=1e-12)
            assert line[:, 1 - place] == pytest.approx(ends, abs=1e-12)

    def test_limits_without_chosen_shifts_come_from_the_edges(self) -> None:
        pair = pair_of("14/17")
        known = least_shifts(pair)
        bare = least_shifts(replace(pair, points=(), margins={}))
        assert bare == pytest.approx(known, abs=1e-12)

    def test_equal_numbers_of_several_values_get_letters(self) -> None:
        other = line("9", "tip thickness of wheel 1", 0.0), line("8", "tip thickness of wheel 1", 0.25)
        pair = replace(pair_of("10/80"), lines=other)
        found = {stroke.number: stroke.text for stroke in strokes(pair, -3 - 3j, 3 + 3j)}
        assert found["9a"] == "least tip thickness of wheel 1: 0.3 $m$"
        assert found["9b"] == "tip thickness of wheel 1: 0"
        assert found["8"] == "tip thickness of wheel 1: 0.25 $m$"
        assert found["5"] == "least contact ratio: 1"

    def test_the_least_contact_ratio_is_line_5_only_if_it_is_one(self) -> None:
        other = line("4", "contact ratio", 1.2), line("5", "contact ratio", 1.0), line("4", "contact ratio", 1.1)
        found = {s.number: s.text for s in strokes(replace(pair_of("stub"), lines=other), -3 - 3j, 3 + 3j)}
        assert (found["4a"], found["4b"]) == ("least contact ratio: 1.1", "contact ratio: 1.2")
        assert found["5"] == "contact ratio: 1"
        assert "4c" not in found

    def test_numbers_in_the_key_are_those_of_the_picture(self) -> None:
        pair, _, _, key = sheet_of("stub")
        lines = strokes(pair, -3 - 3j, 3 + 3j)
        assert [number_of(pair, name, lines) for name in ("contact_ratio", "undercut2", "interference1", "tip1")] == [
            "4a",
            "10",
            "3",
            "",
        ]
        assert "contact ratio (4a)" in texts(key)
        assert number_of(replace(pair, thickness=0.25), "thickness2", ()) == "8'"

    def test_words(self) -> None:
        said = "x1 + x2 = 0: reference and pitch circles coincide"
        other = line("15", said, 0.0), line("6", "equal sliding", 0.0), line("14", "x1 + x2, chosen", -0.25)
        found = {s.number: s.text for s in strokes(replace(pair_of("empty"), lines=other), -3 - 3j, 3 + 3j)}
        assert found["15"] == "x₁ + x₂ = 0: reference and pitch circles coincide"
        assert found["6"] == "equal sliding"
        assert found["14"] == "x₁ + x₂, chosen: −0.25"

    def test_edges_end_in_corners(self) -> None:
        main = pair_of("30/100").strict.main
        assert main is not None
        spots = np.array([complex(corner.x1, corner.x2) for corner in main.corners])
        ends = [z[k] for key in set(main.edges) for z in paths_of(main, key) for k in (0, -1)]
        assert max(float(np.min(np.abs(spots - z))) for z in ends) < 1e-9
        assert len(ends) == 2 * len(spots)
        assert np.min(np.abs(spots - (1 - 1j))) < 1e-12

    def test_lines_are_stronger_in_the_contour(self) -> None:
        _, _, axes, _ = sheet_of("14/17")
        thin = next(line for line in axes.lines if line.get_label() == "_6")
        (strong,) = [line for line in axes.lines if line is not thin and np.array_equal(data(line), data(thin))]
        assert strong.get_linewidth() > thin.get_linewidth()
        assert strong.get_clip_path() is not None


class TestEmpty:
    def test_reason_and_lines(self) -> None:
        pair, _, axes, key = sheet_of("empty")
        assert pair.tolerated.reason in {" ".join(text.split()) for text in texts(axes)}
        said = " ".join(texts(key))
        assert f"Strict contour: {pair.strict.reason}" in said
        assert f"Tolerated contour: {pair.tolerated.reason}" in said
        assert "Areas" not in texts(key)
        assert not axes.collections
        assert {"2", "4a", "4b", "4c", "5", "9", "10"} <= set(texts(axes))


class TestKey:
    @pytest.mark.slow
    def test_much_text_shrinks(self) -> None:
        pair = replace(pair_of("empty"), missing=tuple(f"D{k}: lies outside of the contour" for k in range(40)))
        _, key = blocking_figure(Blocking((pair,), ())).axes
        lowest = min(text.get_window_extent().y0 for text in key.texts)
        assert key.get_window_extent().y0 - 2 < lowest
        assert max(text.get_fontsize() for text in key.texts) < SIZE


class TestPoints:
    def test_points_that_coincide_share_a_label(self) -> None:
        pair = pair_of("14/17")
        first, *others = pair.points
        moved = replace(first, x1=others[0].x1, x2=others[0].x2)
        assert together((moved, *others), 1e-3)[0][1] == f"chosen = {others[0].name}"

    def test_the_reason_covers_no_number(self) -> None:
        _, _, axes, _ = sheet_of("empty")
        (reason,) = [text for text in axes.texts if text.get_text().startswith("no shifts")]
        box = reason.get_window_extent()
        assert not any(box.overlaps(ring.get_window_extent()) for ring in rings(axes))

    @pytest.mark.slow
    def test_sliding_that_does_not_exist_is_a_dash(self) -> None:
        pair = pair_of("14/27")
        first = replace(pair.points[0], sliding=(0.0, 0.9))
        _, key = blocking_figure(Blocking((replace(pair, points=(first, *pair.points[1:])),), ())).axes
        assert texts(key).count("\N{EN DASH}") == 1

    @pytest.mark.slow
    def test_sliding_on_the_limit_of_undercut_has_no_end(self) -> None:
        pair, _, _, key = sheet_of("14/27")
        (corner,) = [point for point in pair.points if point.name == "E"]
        across = math.atan(math.tan(math.radians(20)) / math.cos(math.radians(15)))
        assert corner.x1 == pytest.approx(1 - 7 * math.sin(across) ** 2 / math.cos(math.radians(15)), rel=1e-12)
        assert texts(key).count("\N{MINUS SIGN}\N{INFINITY}") == 1

    def test_a_broken_condition_is_marked(self) -> None:
        pair, _, _, key = sheet_of("empty")
        (text,) = [
            text for text in key.texts if text.get_text() == f"\N{MINUS SIGN}{-pair.margins['contact_ratio']:.4f}"
        ]
        assert text.get_color() == MARK


class TestFigure:
    @pytest.mark.slow
    def test_a_sheet_a_pair_or_the_one_that_is_asked_for(self) -> None:
        both = Blocking((pair_of("empty"), replace(pair_of("empty"), name="second")), ())
        assert len(blocking_figure(both).axes) == 4
        figure = blocking_figure(both, choose=2)
        assert len(figure.axes) == 2
        (sheet,) = figure.subfigs
        assert "second: $z$ = 14/17" in sheet.get_suptitle()

    @pytest.mark.parametrize("choose", [0, 2])
    def test_a_pair_that_there_is_not(self, choose: int) -> None:
        with pytest.raises(UsageError, match=f"no contour {choose}"):
            blocking_figure(Blocking((pair_of("empty"),), ()), choose=choose)

    def test_no_pair_at_all(self) -> None:
        with pytest.raises(UsageError, match="no pair has a blocking contour") as caught:
            blocking_figure(Blocking((), ("a ring has none",)))
        assert caught.value.remedy == "a ring has none"

    @pytest.mark.slow
    def test_equal_results_give_equal_bytes(self, tmp_path: Path) -> None:
        files = [tmp_path / name for name in ("one.svg", "two.svg")]
        for file in files:
            drawn("blocking", "gears", file, Blocking((pair_of("5/200"),), ()))
        first, second = (file.read_bytes() for file in files)
        assert first == second
        assert first.startswith(b"<?xml")
