"""The pieces of the sheet of a cam, read back: lengths times the written scale are those of the results."""

from __future__ import annotations

import re
from functools import cache
from math import degrees
from pathlib import Path

import numpy as np
import pytest
from paper import arcs, curves, frames, inside, of_words, on_sheet, written

from tmmcalc.cams.pictures.cam_profile import PENS
from tmmcalc.cams.pictures.profilemarks import LAID
from tmmcalc.cams.pictures.zone import BASE, LIMIT, MARKED
from tmmcalc.core.stage import STAGES, resolve
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec, parse_spec
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Field
from tmmcalc.report.drawing.order import CHOOSE, PHASE, POLYGONS, POSITIONS, Order
from tmmcalc.report.drawing.pens import DIMENSION, OTHER
from tmmcalc.report.drawing.scales import ENLARGEMENTS, REDUCTIONS
from tmmcalc.report.drawing.shapes import Arc, Dimension, Drawing, Stroke
from tmmcalc.report.language import speaking

CONFIGS = Path(__file__).parents[2] / "configs"
CAMS = ("cam", "cam-flat", "cam-oscillating")
STEPS = (1.0, 2.0, 2.5, 4.0, 5.0)
SCALE = re.compile(r"= ([\d.]+) m/mm \(([\d.]+):([\d.]+)\)")
FACTOR = re.compile(r"\$μ_\{([^}]*)\}\$ = ([\d.e+-]+)")


@cache
def order_of(name: str) -> Order:
    spec = load_spec(CONFIGS / f"{name}.toml")
    results = run(spec).results
    flags = dict.fromkeys((POSITIONS, POLYGONS, CHOOSE, PHASE))
    return Order(spec, results, flags, results.__getitem__, parse_spec)


@cache
def drawn(name: str, language: str = "en", size: str = "good") -> dict[str, Drawing]:
    """Each piece alone on a drawing, by its heading."""
    order, found = order_of(name), {}
    with speaking(language):
        for stage in order.results:
            picture = STAGES[stage].picture
            if (stage.startswith("cam_") or stage == "indexing") and picture is not None and picture.pieces:
                for piece in resolve(picture.pieces)(order):
                    assert piece.sheet == "cam"
                    wide, high = getattr(piece, size)
                    drawing = Drawing(wide, high, piece.heading)
                    piece.draw(drawing, Box(0.0, 0.0, wide, high))
                    found[piece.heading] = drawing
    return found


def piece(name: str, begin: str) -> Drawing:
    (found,) = [drawing for heading, drawing in drawn(name).items() if heading.startswith(begin)]
    return found


def scale_of(drawing: Drawing) -> float:
    """The written scale [m/mm], which is a standard one, and the same as the ratio beside it."""
    (found,) = [match for text in written(drawing) if (match := SCALE.search(text))]
    mu, paper, real = map(float, found.groups())
    assert mu == pytest.approx(1e-3 * real / paper)
    assert (real in REDUCTIONS) if paper == 1 else (paper in ENLARGEMENTS)
    return mu


def factors_of(drawing: Drawing) -> dict[str, float]:
    """The written scale factors, of which each is 1, 2, 2.5, 4 or 5 times a power of ten."""
    found = {sign: float(value) for text in written(drawing) for sign, value in FACTOR.findall(text)}
    for value in found.values():
        assert any(abs(value / step - 10.0 ** round(np.log10(value / step))) < 1e-9 * value / step for step in STEPS)
    return found


@pytest.mark.parametrize("name", [*CAMS, "cam-lantern"])
@pytest.mark.parametrize("size", ["good", "least"])
def test_pieces_stay_in_their_room(name: str, size: str) -> None:
    found = drawn(name, size=size)
    assert len(found) == {"cam": 6, "cam-flat": 5, "cam-oscillating": 6, "cam-lantern": 2}[name]
    assert {heading: on_sheet(drawing) for heading, drawing in found.items() if on_sheet(drawing)} == {}


@pytest.mark.parametrize("name", [*CAMS, "cam-lantern"])
def test_names_of_pieces_have_a_free_place(name: str) -> None:
    for language in ("en", "uk"):
        fields = [field for drawing in drawn(name, language).values() for field in drawing.fields]
        assert sum(len(field.labels.faults) for field in fields) <= 1
        assert sum(field.labels.count for field in fields) > 5


@pytest.mark.parametrize("name", CAMS)
def test_the_diagrams_of_the_law_have_their_scale_factors(name: str) -> None:
    result, drawing = order_of(name).results["cam_law"], piece(name, "Diagrams of")
    factors = factors_of(drawing)
    letter, unit = ("ψ", 1.0) if result.turns else ("S", 1e3)
    fields = frames(drawing)
    assert factors["φ"] == 1.0
    for field, order in zip(fields, (2, 1, 0), strict=True):
        assert field.box.width * factors["φ"] == pytest.approx(360.0)
        factor = factors[letter + "'" * order]
        heights = [z.imag for z in _on_paper(drawing, field) if len(z) > 100]
        zero = field.place(0j).imag
        peak = max(float(z.max()) for z in heights) - zero
        exact = result.stroke * (degrees(1) if result.turns else 1e3)
        if order:
            exact = unit * max(each.value for each in result.extremes if each.order == order)
        assert peak * factor == pytest.approx(exact, rel=1e-3)


def _on_paper(drawing: Drawing, field: Field) -> list[np.ndarray]:
    return [s.points for s in drawing.shapes if isinstance(s, Stroke) and inside(s.points, field.box)]


def wall_of(drawing: Drawing) -> np.ndarray:
    """The working profile on paper (n,)."""
    strokes = (shape for shape in drawing.shapes if isinstance(shape, Stroke) and shape.pen == PENS["inner"])
    (found,) = [stroke.points for stroke in strokes if len(stroke.points) > 2]  # not its sample
    return found


@pytest.mark.parametrize("name", CAMS)
def test_the_profile_is_to_scale(name: str) -> None:
    """Base circle, roller, farthest place and dimensions on paper, times the scale, are the results."""
    result, drawing = order_of(name).results["cam_profile"], piece(name, "Profile of the cam")
    mu, follower = scale_of(drawing), result.follower
    (board,) = frames(drawing)
    circles = [shape for shape in drawing.shapes if isinstance(shape, Arc) and shape.whole]
    centre = board.place(0j)
    base = [each.radius for each in circles if each.pen == PENS["base"]]
    assert [radius * mu for radius in base] == pytest.approx([follower.base])
    wall = wall_of(drawing)
    far = float(np.max(np.abs(wall - centre))) * mu
    (said,) = [text for text in written(drawing) if text.startswith("$r_{max}$ = ")]
    assert float(said.rpartition(" = ")[2]) == pytest.approx(1e3 * far, rel=1e-4)
    assert far == pytest.approx(float(np.max(np.abs(result.working.points))), rel=1e-4)
    rollers = [each for each in circles if each.pen == OTHER]
    numbers = [words.text for words in of_words(drawing) if words.text.isdigit()]
    marks = [each for each in circles if each.pen.layer == "POINTS" and each.radius == 0.45]
    assert 12 <= len(marks) <= 24
    assert len(numbers) >= 0.5 * len(marks)
    assert all(each.radius * mu == pytest.approx(follower.roller) for each in rollers)
    assert len(rollers) == (len(marks) if follower.roller else 0)
    for each in (shape for shape in drawing.shapes if isinstance(shape, Dimension)):
        way = each.second - each.first
        length = abs(way) if each.angle is None else abs((way * np.exp(-1j * each.angle)).real)
        told = float(each.text.rpartition(" = ")[2].replace("−", ""))
        assert length * mu * 1e3 == pytest.approx(told, rel=1e-4)


@pytest.mark.parametrize("name", ["cam", "cam-oscillating"])
def test_the_working_profile_is_the_envelope_of_the_roller_circles(name: str) -> None:
    """No circle reaches into the profile, and each touches it."""
    drawing = piece(name, "Profile of the cam")
    wall = wall_of(drawing)
    rollers = [shape for shape in drawing.shapes if isinstance(shape, Arc) and shape.pen == OTHER]
    gaps = [float(np.min(np.abs(wall - each.centre))) - each.radius for each in rollers]
    assert len(gaps) >= 12
    assert np.max(np.abs(gaps)) < 0.02  # mm of paper, of which a chord of the profile is 1


def test_pieces_of_the_face_touch_the_profile() -> None:
    drawing = piece("cam-flat", "Profile of the cam")
    (board,) = frames(drawing)
    centre = board.place(0j)
    wall = wall_of(drawing)
    faces = [s.points for s in drawing.shapes if isinstance(s, Stroke) and s.pen == OTHER and len(s.points) == 2]
    touching = [z for z in faces if abs(z[0] + z[1] - 2 * centre) > 2 and np.min(np.abs(wall - z.mean())) < 0.5]
    assert len(touching) >= 12
    for first, second in touching:
        across = 1j * (second - first) / abs(second - first)
        outward = across if ((first - centre) * np.conj(across)).real > 0 else -across
        assert np.max(((wall - first) * np.conj(outward)).real) == pytest.approx(0.0, abs=0.02)


@pytest.mark.parametrize("name", ["cam", "cam-oscillating", "cam-flat"])
def test_lifts_are_laid_off_from_the_base_circle(name: str) -> None:
    """Each begins on the base circle and ends at its position."""
    order, drawing = order_of(name), piece(name, "Profile of the cam")
    result, mu = order.results["cam_profile"], scale_of(drawing)
    (board,) = frames(drawing)
    laid = [s.points - board.place(0j) for s in drawing.shapes if isinstance(s, Stroke) and s.pen == LAID]
    ways = [z for z in laid if len(z) == 9]
    assert len(ways) >= 12
    assert [abs(z[0]) * mu for z in ways] == pytest.approx([result.follower.base] * len(ways), rel=1e-9)
    law = order.results["cam_law"]
    if not law.turns:
        lifts = {round(float(y), 9) for y in law.motion[0]}
        assert {round(float(abs(z[-1] - z[0])) * mu, 9) for z in ways} <= lifts


def test_the_borders_of_the_region_have_the_allowed_pressure_angle() -> None:
    order, drawing = order_of("cam"), piece("cam", "Admissible places")
    result, mu = order.results["cam_synthesis"], scale_of(drawing)
    (board,) = frames(drawing)
    assert board.mu == pytest.approx(1e3 * mu)
    limits = {round(degrees(on.limit), 6) for on in (result.rise, result.back)}
    tangents = [z for z in curves(board, LIMIT) if len(z) == 2]
    angles = {round(abs(float(np.degrees(np.angle((z[1] - z[0]) ** 2)))) / 2, 6) for z in tangents}
    assert angles == limits == {30.0, 45.0}
    marked = [shape for shape in drawing.shapes if isinstance(shape, Arc) and shape.pen == MARKED]
    assert {round(degrees(each.end - each.start), 6) for each in marked} == limits
    named = re.compile(r"\$θ_(?:P|{Pc})\$ = ([\d.]+)°")
    said = {float(match[1]) for text in written(drawing) if (match := named.fullmatch(text))}
    assert said == limits
    o = -1e3 * complex(result.follower.start, result.follower.offset)
    assert any(abs(centre - o) < 1e-9 for centre, _ in arcs(board))
    lines = [z for z in curves(board, DIMENSION) if len(z) == 2]
    lengths = sorted(round(float(abs(z[1] - z[0])), 3) for z in lines)
    told = [text for text in written(drawing) if re.match(r"\$(S_0|e|R_0)\$ = ", text)]
    assert sorted(round(float(text.rpartition(" = ")[2]), 3) for text in told) == pytest.approx(lengths, abs=2e-3)
    assert len(lengths) == 3


def test_the_borders_of_a_rockers_region_lean_by_the_allowed_angle() -> None:
    """Each line makes the marked angle with the perpendicular of the rocker, which goes through A and K."""
    order, drawing = order_of("cam-oscillating"), piece("cam-oscillating", "Admissible places")
    result = order.results["cam_synthesis"]
    (board,) = frames(drawing)
    assert board.mu == pytest.approx(scale_of(drawing))
    pivot = complex(result.follower.centres)
    lines = [z for z in curves(board, LIMIT) if len(z) == 2]
    assert len(lines) == 2
    for tip, end in lines:
        lean = abs(np.degrees(np.angle((end - tip) / (tip - pivot)))) % 180 - 90
        assert abs(lean) == pytest.approx(degrees(result.rise.limit), abs=1e-6)


def test_the_base_circle_of_a_rockers_region_is_drawn_whole() -> None:
    result, drawing = order_of("cam-oscillating").results["cam_synthesis"], piece("cam-oscillating", "Admissible")
    (board,) = frames(drawing)
    (circle,) = [z for z in curves(board, BASE) if len(z) > 100]
    assert np.abs(circle) == pytest.approx(np.full(len(circle), result.follower.base))
    assert abs(circle[0] - circle[-1]) < 1e-9


def test_the_tangent_of_a_flat_face_falls_at_45_degrees_and_touches() -> None:
    order, drawing = order_of("cam-flat"), piece("cam-flat", "Admissible places")
    found, mu = order.results["cam_synthesis"], scale_of(drawing)
    (board,) = frames(drawing)
    assert board.mu == pytest.approx(1e3 * mu)
    (tangent,) = [z for z in curves(board, LIMIT) if len(z) == 2]
    assert (tangent[1] - tangent[0]) / abs(tangent[1] - tangent[0]) == pytest.approx((1 - 1j) / np.sqrt(2), abs=1e-9)
    level = float(tangent[0].real + tangent[0].imag)
    assert level == pytest.approx(1e3 * found.convexity.least.value, abs=1e-6)
    moving = np.concatenate([z for z in curves(board) if len(z) > 100])
    assert np.min(moving.real + moving.imag) == pytest.approx(level, abs=0.02)
    assert level + 1e3 * found.follower.start == pytest.approx(1e3 * found.convexity.radius)


@pytest.mark.parametrize("begin", ["Curvature of the cam", "Pressure angle"])
def test_other_diagrams_have_standard_factors_too(begin: str) -> None:
    drawing = piece("cam", begin)
    factors = factors_of(drawing)
    (field,) = frames(drawing)
    assert field.box.width * factors["φ"] == pytest.approx(360.0)
    sign = "κ" if begin.startswith("C") else "θ"
    assert field.box.height * factors[sign] == pytest.approx(field.y.high - field.y.low)


def test_pieces_speak_ukrainian() -> None:
    english, ukrainian = drawn("cam"), drawn("cam", "uk")
    assert len(english) == len(ukrainian)
    assert not set(english) & set(ukrainian)
    letters = re.compile(r"[a-z]{4,}")
    for drawing in ukrainian.values():
        assert not [text for text in written(drawing) if letters.search(text.replace("max", "").replace("min", ""))]
