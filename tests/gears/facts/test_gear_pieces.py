"""Pieces of the sheet of gears, read back from paper: scales, circles, line of action, arcs, tables, points."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from paper import covered, curves, inside, of_words, written
from sparing import sparing

from gears.facts.test_mesh_pictures import ALL, M, distance_to, solved
from tmmcalc.api import run
from tmmcalc.core.plane import Plane
from tmmcalc.gears.meshing.booktables import book_tables
from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.meshing.members import Member, both
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.pictures.mesh import TALL, draw_mesh
from tmmcalc.gears.pictures.pairtable import draw_parameters, draw_quality
from tmmcalc.gears.pictures.pieces import pair as pieces_of_pair
from tmmcalc.gears.pictures.placedpair import CIRCLES, PlacedPair, placed_pair
from tmmcalc.gears.pictures.sketch import ACTIVE, COLOURS, CONTACT_ARC, circle_pen, up_of
from tmmcalc.gears.pictures.toothdrawing import runs_of
from tmmcalc.gears.pictures.toothpoints import DOT, INTERVALS, draw_tooth_points
from tmmcalc.pipeline.picturing import pieces_of
from tmmcalc.project import load_spec, parse_spec
from tmmcalc.project.templates import path
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.scales import SERIES
from tmmcalc.report.drawing.shapes import Arc, Drawing
from tmmcalc.report.drawing.wording import corners
from tmmcalc.report.language import speaking
from tmmcalc.report.sheets.piece import Piece

WIDE, HIGH = 340.0, 250.0
SPECS = ("course-project", "pair-helical", "pair-internal", "pair-rack", "gears-coaxial", "gears-ravigneaux", "pair")


@cache
def mesh(name: str) -> tuple[Drawing, Board, PlacedPair]:
    drawing, pair = Drawing(WIDE, HIGH), placed_pair(solved(name))
    return drawing, draw_mesh(drawing, Box(30.0, 5.0, WIDE - 30.0, HIGH - 5.0), pair), pair


def scale(name: str) -> float:
    """Metres to a mm of paper."""
    board = mesh(name)[1]
    return abs(board.data(1.0) - board.data(0.0))


@pytest.mark.parametrize("name", ALL)
class TestMesh:
    def test_standard_scale_with_tall_teeth(self, name: str) -> None:
        sizes = solved(name).sizes[0]
        assert min(abs(np.array(SERIES) - scale(name))) < 1e-15
        assert abs(sizes.tip - sizes.root) / scale(name) >= TALL

    def test_active_part_is_the_contact_ratio_times_the_base_pitch(self, name: str) -> None:
        """p_t cos(alpha_t) = pi m cos(alpha_t)/cos(beta), in mm of paper to the scale."""
        _, board, pair = mesh(name)
        (line,) = curves(board, ACTIVE)
        found, task = pair.found, pair.found.task
        pitch = math.pi * task.module / math.cos(task.helix) * math.cos(found.angle_t)
        places = board.paper(line)
        assert abs(places[-1] - places[0]) * scale(name) == pytest.approx(found.shortened * pitch, rel=1e-9)

    def test_angle_of_the_line_of_action(self, name: str) -> None:
        """cos(alpha_tw) = r_b/r_w, of the strokes on paper against the common tangent."""
        _, board, pair = mesh(name)
        (line,) = curves(board, ACTIVE)
        places = board.paper(line)
        way, sizes = complex(places[-1] - places[0]), pair.found.sizes[0]
        assert abs(way.imag / way.real) == pytest.approx(math.tan(math.acos(sizes.base / sizes.operating)), rel=1e-9)

    def test_circles(self, name: str) -> None:
        """Radius on paper times scale, of every circle that crosses the line of centres in the frame."""
        drawing, board, pair = mesh(name)
        drawn = [shape for shape in drawing.shapes if isinstance(shape, Arc)]
        for body in pair.bodies:
            for circle in CIRCLES if body.sizes is not None else ():
                radius = getattr(body.sizes, circle)
                same = [other for other in CIRCLES if abs(getattr(body.sizes, other) - radius) < 1e-9 * M]
                pens = [circle_pen(other, COLOURS[body.number - 1], body.number) for other in same]
                own = [each for each in drawn if each.pen in pens]
                at = board.paper([body.centre + up_of(body) * radius])
                if inside(at, board.box):
                    assert any(each.radius * scale(name) == pytest.approx(radius, rel=1e-9) for each in own)
                assert all(abs(board.data(each.centre) - body.centre) < 1e-9 for each in own)

    def test_arcs_of_contact_roll_on_one_another(self, name: str) -> None:
        """Their length is g_alpha/cos(alpha_tw), and the flank stands at their end when the contact begins or ends."""
        _, board, pair = mesh(name)
        line = pair.found.line
        for body in pair.bodies:
            if body.sizes is None:
                continue
            pen = CONTACT_ARC._replace(colour=COLOURS[body.number - 1])
            parts = curves(board, pen)
            assert parts
            length = float(sum(np.sum(np.abs(np.diff(part))) for part in parts))
            whole = (line.ends - line.begins) / math.cos(pair.found.angle_w)
            if len(parts) == 1 and length > 0.98 * whole:
                assert length == pytest.approx(whole, rel=1e-3)  # chords
            for rho, end in ((line.begins, 0), (line.ends, -1)):
                phase = (line.pitch - rho) / pair.found.sizes[0].base
                turned = placed_pair(pair.found, phase).bodies[body.number - 1]
                arc = parts[0 if end == 0 else -1]
                if abs(abs(arc[end] - body.centre) - body.sizes.operating) < 1e-9 and length > 0.98 * whole:
                    crossing = _crossing(turned.flanks, body.centre, body.sizes.operating)
                    assert min(abs(crossing - arc[end])) < 2e-3 * M


def _crossing(flanks: tuple[Plane, ...], centre: complex, radius: float) -> Plane:
    """Where flanks cross a circle."""
    found = []
    for flank in flanks:
        size = np.abs(flank - centre)
        order = np.argsort(size)
        if size.min() <= radius <= size.max():
            found.append(
                complex(
                    np.interp(radius, size[order], flank.real[order]), np.interp(radius, size[order], flank.imag[order])
                )
            )
    return np.array(found)


@cache
def points(name: str, place: int) -> tuple[Drawing, Board, Member]:
    member = both(solved(name))[place]
    tables = book_tables(member, "tooth", INTERVALS)
    assert tables is not None
    drawing = Drawing(WIDE, HIGH)
    return drawing, draw_tooth_points(drawing, Box(5.0, 5.0, WIDE - 5.0, HIGH - 5.0), tables), member


def marked(board: Board, drawing: Drawing) -> Plane:
    """The numbered points as data."""
    return np.array(
        [board.data(each.centre) for each in drawing.shapes if isinstance(each, Arc) and each.radius == DOT]
    )


WHEELS = [(name, place) for name in ("spur", "undercut", "large", "ring", "helical") for place in (0, 1)]


class TestPoints:
    @pytest.mark.parametrize(("name", "place"), WHEELS)
    def test_they_lie_on_the_exact_outline(self, name: str, place: int) -> None:
        """On paper, but where the circle of the textbook stands for the ellipse of a helical rack."""
        drawing, board, member = points(name, place)
        half = half_tooth(member)
        outline = np.concatenate([*runs_of(member, half).values()])
        away = distance_to(outline, marked(board, drawing))
        assert len(away) == 2 * INTERVALS + 1 or half.undercut or name == "helical"
        assert np.sort(away)[INTERVALS] < 2e-4 * M  # chords of the outline
        allowed = 0.01 * M if name == "helical" else 2e-4 * M
        if not half.undercut:  # beyond the crossing the circle goes on under the involute
            assert away.max() < allowed

    @pytest.mark.parametrize(("name", "place"), [("spur", 0), ("spur", 1), ("large", 0)])
    def test_they_are_those_of_the_textbooks_formulas(self, name: str, place: int) -> None:
        """X and Y of (4.77), (4.79) and of (4.85) to (4.91), in the axes of the tooth."""
        drawing, board, member = points(name, place)
        wheel, rack = member.wheel, member.wheel.rack
        z, x, alpha = wheel.teeth, float(wheel.shift), rack.angle
        r, base = M * z / 2, M * z / 2 * math.cos(alpha)
        psi = (math.pi / 2 + 2 * x * math.tan(alpha)) / z
        rho = rack.clearance / (1 - math.sin(alpha)) * M
        first = M * (x - rack.addendum) / (r * math.sin(alpha) * math.cos(alpha))
        tip = math.tan(math.acos(base / member.found.sizes[place].tip)) - math.tan(alpha)
        xs, ys = (
            M * (x - rack.addendum) * math.tan(alpha) - rho * math.cos(alpha),
            M * (x - rack.addendum) + rho * math.sin(alpha),
        )
        last = xs / r
        wanted = []
        for phi in np.linspace(tip, first, INTERVALS + 1):
            f = phi - psi
            across = r * (math.sin(f) - phi * math.cos(alpha) * math.cos(f + alpha))
            wanted.append(complex(across, r * (math.cos(f) + phi * math.cos(alpha) * math.sin(f + alpha))))
        for phi in np.linspace(last, first, INTERVALS + 1)[:-1]:
            f, p = phi - psi, r * phi - xs
            centre = complex((ys + r) * math.sin(f) - p * math.cos(f), (ys + r) * math.cos(f) + p * math.sin(f))
            rate = complex(ys * math.cos(f) + p * math.sin(f), -ys * math.sin(f) + p * math.cos(f))
            v = abs(rate)
            wanted.append(centre + complex(-rho * rate.imag / v, rho * rate.real / v))
        shown = marked(board, drawing)
        assert len(shown) == len(wanted)
        assert max(np.min(np.abs(shown[:, None] - np.array(wanted)), axis=0)) < 1e-9
        said = written(drawing)
        for at in wanted:
            for value in (at.real, at.imag - base):
                assert f"{round(1e3 * value, 4) + 0.0:.4f}".replace("-", "−") in said


class TestTables:
    @sparing("name", ALL, every=8)
    def test_parameters_are_the_results(self, name: str) -> None:
        found, drawing = solved(name), Drawing(WIDE, HIGH)
        draw_parameters(drawing, Box(5.0, 5.0, 160.0, HIGH - 5.0), found)
        said = {text.replace("−", "-") for text in written(drawing)}
        for sizes in found.sizes:
            lengths = (sizes.tip, sizes.root, sizes.base, sizes.reference, sizes.operating, sizes.thickness)
            for value in (*(1e3 * each for each in lengths), sizes.shift):
                assert any(_reads(text, value) for text in said)
        for value in (found.contact_ratio, 1e3 * found.distance, 1e3 * found.task.module):
            assert any(_reads(text, value) for text in said)

    def test_quality_tells_what_is_not_kept(self) -> None:
        found, drawing = solved("undercut"), Drawing(WIDE, HIGH)
        draw_quality(drawing, Box(5.0, 5.0, 200.0, HIGH - 5.0), found)
        said = written(drawing)
        bad = [check for check in found.checks if check.verdict != "ok"]
        assert bad
        assert said.count("not recommended") + said.count("not kept") == len(bad)
        assert f"{found.contact_ratio:.4f}" in said


def _reads(text: str, value: float) -> bool:
    try:
        return float(text) == pytest.approx(value, rel=1e-4, abs=1e-3)
    except ValueError:
        return False


@cache
def offered(name: str, language: str) -> list[Piece]:
    done = run(load_spec(path(name)))
    with speaking(language):
        return [
            piece
            for stage in done.results
            for piece in pieces_of(stage, done.spec, done.results)
            if piece.sheet == "gears"
        ]


def counted(name: str, language: str) -> tuple[int, int]:
    """Names in all pieces at both sizes, and those that found no free place; all words are in their rectangles."""
    count = faults = 0
    assert offered(name, language)
    for piece in offered(name, language):
        for wide, high in (piece.least, piece.good):
            drawing, box = Drawing(wide + 20, high + 20), Box(10.0, 10.0, wide + 10, high + 10)
            with speaking(language):
                piece.draw(drawing, box)
            around = box.inset(-1, -1, -1, -1)
            assert not [words.text for words in of_words(drawing) if not inside(corners(words), around)], piece.heading
            assert not covered(drawing, 0.6), piece.heading
            count += sum(field.labels.count for field in drawing.fields)
            faults += sum(len(field.labels.faults) for field in drawing.fields)
    return count, faults


@sparing("language", ["en", "uk"], every=2)
def test_pieces_keep_their_words_in_their_rectangles(language: str) -> None:
    """Names that found no free place are below one in a hundred."""
    found = [counted(name, language) for name in SPECS]
    assert sum(faults for _, faults in found) < 0.01 * sum(count for count, _ in found)


def test_a_pair_without_a_profile_has_its_tables_alone() -> None:
    """Its wheels cannot be drawn; the numbers still can be handed in."""
    found: MeshPair = solved("pointed")
    order = Order(None, {"pair": Pairs((found,), "", ())}, {"--choose": None}, {}.get, parse_spec)
    headings = [piece.heading for piece in pieces_of_pair(order)]
    assert len(headings) in (2, 4)
    assert any(text.startswith("Parameters") for text in headings)
