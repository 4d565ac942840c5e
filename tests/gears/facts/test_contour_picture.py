"""The picture of the blocking contour: what is drawn against the record that it shows."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing import drawn
from paper import covered, data, inside, of_words, on_sheet, written
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.meshing.blocking import solve_blocking
from tmmcalc.gears.meshing.choice import contour_task
from tmmcalc.gears.meshing.contours import Blocking, ContourLine, MissingPoints, PairContour
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.pictures.blocking import blocking_drawing
from tmmcalc.gears.pictures.contourkey import HEADING
from tmmcalc.gears.pictures.contourlines import least_shifts, number_of, strokes
from tmmcalc.gears.pictures.contourlook import BELT, RING, STRICT, Look, together
from tmmcalc.gears.pictures.contourpaths import outlines, paths_of, smooth
from tmmcalc.report.drawing import written as bytes_of
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import MARK, Pen
from tmmcalc.report.drawing.shapes import Arc, Area, Drawing, Hatching, Stroke, hatch_lines
from tmmcalc.report.drawing.wording import corners
from tmmcalc.report.language import speaking

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
def sheet_of(name: str) -> tuple[PairContour, Drawing, Board]:
    pair = pair_of(name)
    drawing = blocking_drawing(Blocking((pair,), ()))
    (board,) = drawing.fields
    assert isinstance(board, Board)
    return pair, drawing, board


def plane(name: str) -> list[str]:
    """What is written in the plane of the shifts."""
    _, drawing, board = sheet_of(name)
    return written(drawing, board.box)


def key(name: str) -> list[str]:
    """What is written in the key beside it."""
    _, drawing, board = sheet_of(name)
    return [words.text for words in of_words(drawing) if words.at.real > board.box.right]


def lines_of(name: str, *pens: Pen) -> list[np.ndarray]:
    """What is drawn with any of these pens in the plane, as shifts."""
    _, drawing, board = sheet_of(name)
    shapes = [shape for shape in drawing.shapes if isinstance(shape, Stroke) and inside(shape.points, board.box)]
    return [data(board, shape.points) for shape in shapes if shape.pen in pens]


def strokes_of(name: str) -> dict[str, list[np.ndarray]]:
    """What is drawn of every line, by its number with letters."""
    pair, _, board = sheet_of(name)
    return {s.number: lines_of(name, *s.pens) for s in strokes(pair, *window(board))}


def window(board: Board) -> tuple[complex, complex]:
    box = board.box
    return board.data(complex(box.left, box.bottom)), board.data(complex(box.right, box.top))


def rings(name: str) -> list[complex]:
    """Centres on paper of the numbers' circles in the plane."""
    _, drawing, board = sheet_of(name)
    shapes = [shape for shape in drawing.shapes if isinstance(shape, Arc) and shape.pen.layer == "NUMBERS"]
    return [shape.centre for shape in shapes if shape.radius == RING and inside(shape.points, board.box)]


def distance_to(lines: list[np.ndarray], points: np.ndarray) -> np.ndarray:
    """Distance of points (n,) from polylines."""
    start = np.concatenate([line[:-1] for line in lines])
    run = np.concatenate([np.diff(line) for line in lines])
    start, run = start[np.abs(run) > 0], run[np.abs(run) > 0]
    t = np.clip(((points[:, None] - start) / run).real, 0.0, 1.0)
    return np.asarray(np.min(np.abs(points[:, None] - start - t * run), axis=1))


def shoelace(z: np.ndarray) -> float:
    after = np.roll(z, -1)
    return float(np.sum(z.real * after.imag - after.real * z.imag)) / 2


def border(name: str, look: Look) -> np.ndarray:
    (line,) = lines_of(name, look.border)
    return line


def closed(outline: Any) -> np.ndarray:
    return np.asarray(outline.x1 + 1j * outline.x2)


@sparing("name", PAIRS, every=3)
class TestSheet:
    def test_both_directions_have_one_scale(self, name: str) -> None:
        _, _, board = sheet_of(name)
        assert board.place(1.0) - board.place(0.0) == pytest.approx((board.place(1j) - board.place(0.0)) / 1j, rel=1e-9)

    def test_nothing_is_beyond_the_sheet_and_no_words_cover_others(self, name: str) -> None:
        _, drawing, _ = sheet_of(name)
        assert not on_sheet(drawing)
        assert not covered(drawing, 0.3)

    def test_contours_and_chosen_shifts_are_inside(self, name: str) -> None:
        pair, _, board = sheet_of(name)
        spots = [np.array([complex(pair.points[0].x1, pair.points[0].x2)])]
        spots += [closed(area.main) for area in (pair.strict, pair.tolerated) if area.main is not None]
        assert inside(board.paper(np.concatenate(spots)), board.box)

    def test_every_line_of_the_record_is_drawn(self, name: str) -> None:
        pair, _, board = sheet_of(name)
        low, high = window(board)
        shown = 0
        for line in pair.lines:
            drawn = [z for number, z in strokes_of(name).items() if number.rstrip("abc") == line.number and z]
            if line.number.split(", ")[0] in ("14", "15", "16"):
                if not drawn:
                    assert not low.real + low.imag < line.value < high.real + high.imag
                    continue
                assert any(np.allclose(z.real + z.imag, line.value, atol=1e-9) for every in drawn for z in every)
                shown += 1
                continue
            path = line.x1 + 1j * line.x2
            seen = path[(path.real > low.real) & (path.real < high.real)]
            seen = seen[(seen.imag > low.imag) & (seen.imag < high.imag)]
            if seen.size > 20:
                assert min(distance_to(every, seen).max() for every in drawn) < 1e-9
                shown += 1
        assert shown >= 2
        for stroke in strokes(pair, low, high):  # and nothing else is drawn
            for z in strokes_of(name)[stroke.number]:
                assert distance_to(list(stroke.paths), z).max() < 1e-9

    def test_every_line_has_its_number_and_a_row_of_the_key(self, name: str) -> None:
        numbers = {part for number, drawn in strokes_of(name).items() if drawn for part in number.split(", ") if part}
        assert {"2", "14"} < numbers
        seen = numbers & set(plane(name))
        assert seen >= {"2", "14"}
        assert seen == numbers & set(key(name))

    def test_numbers_are_clear_of_each_other_and_of_the_border(self, name: str) -> None:
        _, _, board = sheet_of(name)
        found = rings(name)
        assert inside(np.array(found), board.box.inset(*4 * (RING,)))
        assert min(abs(a - b) for k, a in enumerate(found) for b in found[:k]) > 2 * RING

    def test_names_of_points_stand_in_the_picture_apart(self, name: str) -> None:
        pair, drawing, board = sheet_of(name)
        said = {point.name for point in pair.points}
        boxes = [corners(words) for words in of_words(drawing) if said & set(words.text.split(" = "))]
        boxes = [box for box in boxes if box.real.min() < board.box.right]
        assert boxes
        for box in boxes:
            assert inside(box, board.box)
        for k, a in enumerate(boxes):
            for b in boxes[:k]:
                apart = [max(f(a).min(), f(b).min()) - min(f(a).max(), f(b).max()) for f in (np.real, np.imag)]
                assert max(apart) > 0

    def test_the_key_keeps_to_its_column(self, name: str) -> None:
        _, drawing, board = sheet_of(name)
        boxes = [corners(words) for words in of_words(drawing) if words.at.real > board.box.right]
        boxes = [box for box in boxes if box.imag.max() < board.box.top + 1]
        assert min(box.real.min() for box in boxes) > board.box.right
        assert max(box.real.max() for box in boxes) < drawing.width - 6.9
        assert min(box.imag.min() for box in boxes) > 5.0

    def test_chosen_shifts_in_figures(self, name: str) -> None:
        pair, _, _ = sheet_of(name)
        point, said = pair.points[0], [text.replace("\N{MINUS SIGN}", "-") for text in key(name)]
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
        pair, _, _ = sheet_of(name)
        look, area = (STRICT, pair.strict) if strict else (BELT, pair.tolerated)
        main = area.main
        assert main is not None
        drawn = border(name, look)
        assert abs(drawn[0] - drawn[-1]) < 1e-9
        assert np.max(np.min(np.abs(closed(main)[:, None] - drawn), axis=1)) < 1e-9
        assert shoelace(drawn) == pytest.approx(main.area, rel=2e-4)

    def test_points_between_those_of_the_record_lie_on_the_contour(self, name: str) -> None:
        pair, task = pair_of(name), contour_task(task_of(name))
        assert pair.strict.main is not None
        z = smooth(pair.strict.main)
        assert len(z) > 3 * pair.strict.main.x1.size
        assert np.max(np.abs(margins(task, z.real, z.imag).least())) < 2e-3

    def test_the_filled_areas(self, name: str) -> None:
        pair, drawing, board = sheet_of(name)
        filled = [each for each in drawing.shapes if isinstance(each, Area) and inside(each.points, board.box)]
        order = []
        for look, which in ((BELT, pair.tolerated), (STRICT, pair.strict)):
            at, patch = next((k, shape) for k, shape in enumerate(filled) if shape.fill == look.fill)
            assert which.main is not None
            assert shoelace(data(board, patch.points)) == pytest.approx(which.main.area, rel=2e-4)
            order.append(at)
        assert order == sorted(order)

    def test_what_tolerance_adds_is_hatched(self, name: str) -> None:
        pair, drawing, board = sheet_of(name)
        shapes = [each for each in drawing.shapes if isinstance(each, Hatching) and inside(each.points, board.box)]
        seen = [piece for piece in pair.tolerated.pieces if points_inside(frame_of(board), closed(piece)).any()]
        assert len(shapes) == 1 + bool(seen)
        assert pair.strict.main is not None
        assert pair.tolerated.main is not None
        tolerated, strict = (shoelace(data(board, loop)) for loop in shapes[0].loops)
        added = pair.tolerated.main.area - pair.strict.main.area
        assert tolerated - strict == pytest.approx(added, abs=4e-4 * tolerated)
        lines = hatch_lines(shapes[0])
        middles = data(board, np.array([line.mean() for line in lines]))
        within = [points_inside(closed(area.main)[:-1], middles) for area in (pair.tolerated, pair.strict)]
        near = distance_to([border(name, STRICT), border(name, BELT)], middles) < 0.2 * board.mu
        assert np.all(near | (within[0] & ~within[1]))


def frame_of(board: Board) -> np.ndarray:
    low, high = window(board)
    return np.array([low, complex(high.real, low.imag), high, complex(low.real, high.imag)])


def points_inside(polygon: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Whether points (n,) lie inside a polygon, by the angles under which they see its sides."""
    seen = np.angle((np.roll(polygon, -1) - points[:, None]) * np.conj(polygon - points[:, None])).sum(axis=1)
    return np.asarray(np.abs(seen) > np.pi)


@pytest.mark.slow
def test_the_file_for_cad_programs_has_a_hatch_of_lines() -> None:
    pytest.importorskip("ezdxf")
    import io

    from ezdxf.filemanagement import read

    _, drawing, _ = sheet_of("14/17")
    document = read(io.StringIO(bytes_of("dxf", drawing).decode()))
    hatches = [each for each in document.modelspace().query("HATCH") if not each.dxf.solid_fill]
    assert {each.dxf.layer for each in hatches} == {"TOLERATED_HATCH"}
    assert max(len(each.paths) for each in hatches) == 2


class TestLines:
    def test_limits_of_undercut_run_across_the_picture(self) -> None:
        _, _, board = sheet_of("14/17")
        low, high = window(board)
        least = [1 - z * math.sin(math.radians(20)) ** 2 / 2 for z in (14, 17)]
        ends_of = {"2": (low.imag, high.imag), "10": (low.real, high.real)}
        for number, way, value in (("2", 1, least[0]), ("10", 1j, least[1])):
            z = np.concatenate(strokes_of("14/17")[number])
            across, along = (z.real, z.imag) if way == 1 else (z.imag, z.real)
            assert across == pytest.approx(value, abs=1e-12)
            assert (along.min(), along.max()) == pytest.approx(ends_of[number], abs=1e-12)

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
        pair = pair_of("stub")
        lines = strokes(pair, -3 - 3j, 3 + 3j)
        assert [number_of(pair, name, lines) for name in ("contact_ratio", "undercut2", "interference1", "tip1")] == [
            "4a",
            "10",
            "3",
            "",
        ]
        assert "contact ratio (4a)" in key("stub")
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

    @sparing("name", ["14/17", "30/100", "stub"], every=3)
    def test_lines_are_stronger_in_the_contour(self, name: str) -> None:
        pair, _, board = sheet_of(name)
        loops = [closed(outline)[:-1] for outline in outlines(pair)]
        edges = {line for outline in outlines(pair) for line in outline.edges}
        assert edges
        for stroke in strokes(pair, *window(board)):
            strong, thin = stroke.pens
            assert strong.width > thin.width
            for pen in (strong, thin):
                drawn = lines_of(name, pen)
                if not drawn:
                    continue
                middles = np.concatenate([(z[1:] + z[:-1]) / 2 for z in drawn])
                far = np.min([distance_to([np.append(loop, loop[0])], middles) for loop in loops], axis=0) > 3e-3
                within = np.any([points_inside(loop, middles) for loop in loops], axis=0)
                assert np.all(within[far] == (pen is strong))
        assert lines_of(name, *[s.pens[0] for s in strokes(pair, *window(board)) if s.number == "6"])


class TestEmpty:
    def test_reason_and_lines(self) -> None:
        pair, drawing, _ = sheet_of("empty")
        assert pair.tolerated.reason in {" ".join(text.split()) for text in plane("empty")}
        said = " ".join(key("empty"))
        assert f"Strict contour: {pair.strict.reason}" in said
        assert f"Tolerated contour: {pair.tolerated.reason}" in said
        assert "Areas" not in key("empty")
        assert not any(isinstance(shape, Hatching) for shape in drawing.shapes)
        assert {"2", "4a", "4b", "4c", "5", "9", "10"} <= set(plane("empty"))

    def test_in_ukrainian_no_english_word_is_left(self) -> None:
        """Of reasons with their values: nothing admissible, no point D at all, and one outside."""
        task = replace(task_of("14/17"), limits=QualityLimits(contact_ratio=1.25))
        (outside,) = solve_blocking(Pairs((solve_pair(task),), "", ())).pairs
        for pair, words in ((pair_of("empty"), "без підрізання"), (pair_of("5/200"), "D:"), (outside, "x₁ = 0,")):
            assert pair.missing
            with speaking("uk"):
                said = written(blocking_drawing(Blocking((pair,), ())))
            assert any(words in text for text in said), words
            assert [text for text in said if re.search("[a-z]{3}", re.sub(r"\$[^$]*\$", "", text))] == []


class TestKey:
    @pytest.mark.slow
    def test_much_text_shrinks(self) -> None:
        pair = replace(
            pair_of("empty"), missing=tuple(MissingPoints((f"D{k}",), "outside of the contour") for k in range(40))
        )
        drawing = blocking_drawing(Blocking((pair,), ()))
        right = drawing.fields[0].box.right
        shown = [words for words in of_words(drawing) if words.at.real > right]
        assert min(corners(words).imag.min() for words in shown) > 5.0
        assert max(words.height for words in shown if words.text == "Lines") < HEADING


class TestPoints:
    def test_points_that_coincide_share_a_label(self) -> None:
        pair = pair_of("14/17")
        first, *others = pair.points
        moved = replace(first, x1=others[0].x1, x2=others[0].x2)
        assert together((moved, *others), 1e-3)[0][1] == f"chosen = {others[0].name}"

    def test_the_reason_covers_no_number(self) -> None:
        _, drawing, board = sheet_of("empty")
        (reason,) = [words for words in of_words(drawing) if words.text.startswith("no shifts")]
        box = corners(reason)
        assert inside(box, board.box)
        for at in rings("empty"):
            clear = complex(
                min(max(at.real, box.real.min()), box.real.max()), min(max(at.imag, box.imag.min()), box.imag.max())
            )
            assert abs(at - clear) > RING

    @pytest.mark.slow
    def test_sliding_that_does_not_exist_is_a_dash(self) -> None:
        pair = pair_of("14/27")
        first = replace(pair.points[0], sliding=(0.0, 0.9))
        drawing = blocking_drawing(Blocking((replace(pair, points=(first, *pair.points[1:])),), ()))
        assert written(drawing).count("\N{EN DASH}") == 1

    def test_sliding_of_a_point_on_the_base_circle_has_no_end(self) -> None:
        pair = pair_of("14/17")
        first = replace(pair.points[0], sliding=(-9.519e14, 0.9))
        drawing = blocking_drawing(Blocking((replace(pair, points=(first, *pair.points[1:])),), ()))
        assert "−∞" in written(drawing)
        assert not covered(drawing, 0.3)

    @pytest.mark.slow
    def test_sliding_on_the_limit_of_undercut_has_no_end(self) -> None:
        pair, drawing, _ = sheet_of("14/27")
        (corner,) = [point for point in pair.points if point.name == "E"]
        across = math.atan(math.tan(math.radians(20)) / math.cos(math.radians(15)))
        assert corner.x1 == pytest.approx(1 - 7 * math.sin(across) ** 2 / math.cos(math.radians(15)), rel=1e-12)
        assert written(drawing).count("−∞") == 1

    def test_a_broken_condition_is_marked(self) -> None:
        pair, drawing, _ = sheet_of("empty")
        said = f"\N{MINUS SIGN}{-pair.margins['contact_ratio']:.4f}"
        (words,) = [words for words in of_words(drawing) if words.text == said]
        assert words.colour == MARK.colour


class TestFigure:
    @pytest.mark.slow
    def test_a_sheet_a_pair_or_the_one_that_is_asked_for(self) -> None:
        both = Blocking((pair_of("empty"), replace(pair_of("empty"), name="second")), ())
        assert len(blocking_drawing(both).fields) == 2
        drawing = blocking_drawing(both, choose=2)
        assert len(drawing.fields) == 1
        assert any("second: $z$ = 14/17" in text for text in written(drawing))

    @pytest.mark.parametrize("choose", [0, 2])
    def test_a_pair_that_there_is_not(self, choose: int) -> None:
        with pytest.raises(UsageError, match=f"no pair {choose}"):
            blocking_drawing(Blocking((pair_of("empty"),), ()), choose=choose)

    def test_no_pair_at_all(self) -> None:
        with pytest.raises(UsageError, match="no pair has a blocking contour") as caught:
            blocking_drawing(Blocking((), ("a ring has none",)))
        assert caught.value.remedy == "a ring has none"

    @pytest.mark.slow
    def test_equal_results_give_equal_bytes(self, tmp_path: Path) -> None:
        files = [tmp_path / name for name in ("one.svg", "two.svg")]
        for file in files:
            drawn("blocking", "gears", file, Blocking((pair_of("5/200"),), ()))
        first, second = (file.read_bytes() for file in files)
        assert first == second
        assert first.startswith(b"<?xml")
