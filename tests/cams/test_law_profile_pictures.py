"""The pictures of law and profile: every follower is drawn, equal bytes each time, texts that a reader looks for."""

from itertools import combinations
from math import degrees, radians
from pathlib import Path

import numpy as np
import pytest
from drawing import draw_cam
from paper import curves, diagram, frames, named_place, of_words, on_sheet, written
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.lawresult import solve_law
from tmmcalc.cams.pictures.cam_law import law_drawing
from tmmcalc.cams.pictures.cam_profile import profile_drawing
from tmmcalc.cams.pictures.curvature import CUSP, PITCH, WORKING
from tmmcalc.cams.pictures.profilemarks import NUMBER
from tmmcalc.cams.pictures.wording import phase_name
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.task import Loads
from tmmcalc.core.errors import UsageError
from tmmcalc.report.drawing.pens import DIMENSION, PATH
from tmmcalc.report.drawing.shapes import Arc, Dimension
from tmmcalc.report.drawing.wording import corners

STEM, ROCKER = turn("cosine", "const", high=0), turn("sine", stroke=radians(20))
SIZES = {"roller": 0.006, "centres": 0.1, "rocker": 0.09}
SCENES = {
    "stem": (STEM, Follower("translating", 0.055, 0.01, 0.008), {"tool": 0.02}),
    "knife": (STEM, Follower("translating", 0.055, sense=-1), {}),
    "groove": (
        ROCKER,
        Follower("oscillating", radians(35), assembly=-1, **SIZES),
        {"closure": "groove", "tool": 0.004},
    ),
    "flat": (turn("sine", rise=90, back=90, stroke=0.01), Follower("flat", 0.04), {"margin": 0.002}),
    "undercut": (turn("cosine"), Follower("translating", 0.055, roller=0.04), {"report_faults": True}),
}


def texts(drawing):
    return " ".join(written(drawing))


@sparing("name", SCENES, every=5)
def test_profiles(name, tmp_path: Path):
    program, follower, asked = SCENES[name]
    task = task_of(program, follower.kind, steps=6, **asked)
    result = solve_profile(task, follower)
    drawing = profile_drawing(task, result)
    assert not on_sheet(drawing)
    said = texts(drawing)
    assert ("second wall" in said) == (name == "groove")
    assert ("undercut" in said) == (name == "undercut")
    assert "near dwell" in said
    files = tmp_path / "a.svg", tmp_path / "b.svg"
    for file in files:
        draw_cam("cam_profile", task, result, file)
    assert files[0].read_bytes() == files[1].read_bytes()


@pytest.mark.parametrize("roller", [0.008, 0.02, 0.026])
def test_the_curvature_of_a_working_profile_is_whole(roller: float):
    """Its peak is in the picture with its value, however much sharper than the pitch curve it is."""
    follower = Follower("translating", 0.055, 0.01, roller)
    task = task_of(STEM, "translating", steps=6)
    result = solve_profile(task, follower)
    drawing = profile_drawing(task, result)
    field = diagram(drawing, "curvature $κ$, 1/mm")
    drawn = np.concatenate([line.imag for pen in (PITCH, WORKING) for line in curves(field, pen) if len(line) > 100])
    assert len(drawn) > 1000
    assert np.isfinite(drawn).all()
    assert field.y.low < drawn.min() < drawn.max() < field.y.high
    peak = 1e-3 / (1 / result.sharpest.value - roller)
    assert drawn.max() == pytest.approx(peak, rel=1e-3)
    assert f"{peak:.4g}" in texts(drawing)


@pytest.mark.slow
@pytest.mark.parametrize(("program", "kind"), [(STEM, "translating"), (ROCKER, "oscillating")])
def test_laws(program, kind, tmp_path: Path):
    task = task_of(program, kind, steps=6, loads=Loads(60.0))
    result = solve_law(task)
    said = texts(law_drawing(task, result))
    assert ("b, c" in said.replace("b, c", "", 1)) == (program is STEM)  # no high dwell: one point in both diagrams
    assert "572.96 rpm" in said
    file = tmp_path / "law.png"
    draw_cam("cam_law", task, result, file)
    assert file.read_bytes().startswith(b"\x89PNG")
    with pytest.raises(UsageError, match="no picture format"):
        draw_cam("cam_law", task, result, tmp_path / "law.gif")


def boxes(drawing, names):
    """Boxes [mm] of the texts that begin with one of the names: left, right, bottom, top."""
    return {words.text: extent(words) for words in of_words(drawing) if words.text.startswith(names)}


def extent(words):
    z = corners(words)
    return z.real.min(), z.real.max(), z.imag.min(), z.imag.max()


def apart(every):
    return not any(a[0] < b[1] and b[0] < a[1] and a[2] < b[3] and b[2] < a[3] for a, b in combinations(every, 2))


FACE = turn("const", rise=60, high=0, back=60)
SHORT = turn("cosine", rise=5, high=0, back=5)
NAMED = {**SCENES, "face": (FACE, Follower("flat", 0.08), {}), "short": (SHORT, Follower("translating", 0.5), {})}


@sparing("name", NAMED, every=8)
def test_phases_are_named_clear_of_each_other_and_of_the_walls(name):
    program, follower, asked = NAMED[name]
    task = task_of(program, follower.kind, **asked)
    result = solve_profile(task, follower)
    drawing = profile_drawing(task, result)
    found = boxes(drawing, ("rise ", "far dwell ", "return ", "near dwell "))
    assert sorted(found) == sorted(f"{phase_name(phase.kind)} {degrees(phase.angle):.6g}°" for phase in program.phases)
    assert apart(found.values())
    board = board_of(drawing)
    for wall in (result.working, result.outer):
        if wall is not None:
            z = board.paper(wall.points)
            for left, right, bottom, top in found.values():
                assert not np.any((z.real > left) & (z.real < right) & (z.imag > bottom) & (z.imag < top))


def board_of(drawing):
    (board,) = [each for each in frames(drawing) if not hasattr(each, "x")]
    return board


@sparing("name", NAMED, every=8)
def test_positions_are_numbered_as_in_the_tables_and_can_be_read(name):
    program, follower, asked = NAMED[name]
    task = task_of(program, follower.kind, **asked)
    result = solve_profile(task, follower)
    drawing = profile_drawing(task, result)
    assert "at $i$ of the tables" in texts(drawing)
    numbers = [words for words in of_words(drawing) if words.height == NUMBER and words.colour == PATH.colour]
    assert len(numbers) >= 3
    assert apart([extent(words) for words in numbers])
    curve = result.working.points if result.flat else result.pitch
    for words in numbers:
        row = result.positions.labels.index(words.text)
        assert abs(board_of(drawing).place(complex(curve[row])) - named_place(drawing, words)) < 6.5


@sparing("name", NAMED, every=4)
def test_the_profile_has_its_dimensions(name):
    """Radii end at their circle, distances are to scale, the arcs of the phases have the angles of the phases."""
    program, follower, asked = NAMED[name]
    task = task_of(program, follower.kind, **asked)
    result = solve_profile(task, follower)
    drawing = profile_drawing(task, result)
    board, said = board_of(drawing), written(drawing)
    centre = board.place(0j)
    arcs = [each for each in drawing.shapes if isinstance(each, Arc) and each.pen == DIMENSION]
    angles = [phase.angle for phase in program.phases if phase.angle > 0]
    np.testing.assert_allclose([arc.end - arc.start for arc in arcs], angles, atol=1e-9)
    assert all(abs(arc.centre - centre) < 1e-9 for arc in arcs)
    largest = 1e3 * np.max(np.abs(result.working.points))
    (shown,) = [float(text.rpartition(" = ")[2]) for text in said if text.startswith("$r_{max}$ = ")]
    assert shown == pytest.approx(largest, rel=2e-3)
    assert f"$R_0$ = {1e3 * follower.base:.5g}" in said
    assert (f"$r_2$ = {1e3 * follower.roller:.5g}" in said) == (follower.roller > 0)
    sizes = {each.text: each for each in drawing.shapes if isinstance(each, Dimension)}
    expected = {}
    if follower.kind == "oscillating":
        expected = {"l_0": follower.centres, "l_2": follower.rocker}
    elif follower.offset:
        expected = {"e": follower.offset}
    assert set(sizes) == {f"${symbol}$ = {1e3 * value:.5g}" for symbol, value in expected.items()}
    for symbol, value in expected.items():
        each = sizes[f"${symbol}$ = {1e3 * value:.5g}"]
        along = 1.0 if each.angle is None else np.exp(1j * each.angle)
        way = each.second - each.first
        length = abs(way) if each.angle is None else abs((way * np.conj(along)).real)
        assert length * board.mu == pytest.approx(value, rel=1e-9)


@pytest.mark.slow
def test_only_the_line_of_the_cusp_has_its_look():
    """It bounds the pitch curve: the working profile may cross it, and must not be taken for it."""
    follower = Follower("translating", 0.055, 0.01, 0.02)
    task = task_of(STEM)
    drawing = profile_drawing(task, solve_profile(task, follower))
    field = diagram(drawing, "curvature $κ$, 1/mm")
    (cusp,) = curves(field, CUSP)
    assert cusp.imag == pytest.approx(1e-3 / follower.roller, rel=1e-9)
    assert {PITCH.colour, WORKING.colour}.isdisjoint({CUSP.colour})
    assert "cusp of the working profile" in texts(drawing)


@pytest.mark.slow
def test_short_phases_are_named_beside_each_other():
    task = task_of(turn("cosine", rise=5, high=5, back=5))
    drawing = law_drawing(task, solve_law(task))
    found = boxes(drawing, ("rise\n", "far\ndwell\n", "return\n", "near dwell\n"))
    assert len(found) == 4
    assert apart(found.values())
    frame = frames(drawing)[0].box
    assert all(left > frame.left - 0.1 and right < frame.right for left, right, _, _ in found.values())


@pytest.mark.slow
def test_a_rocker_has_one_unit_for_its_angle_in_the_portrait():
    task = task_of(ROCKER, "oscillating")
    fields = frames(law_drawing(task, solve_law(task)))[:5]
    portrait = fields[-1]
    assert max(np.max(line.real) for line in curves(portrait) if len(line) > 9) == pytest.approx(radians(20))
    assert portrait.x.name.endswith(", rad")
    assert [field.y.name.rpartition("$")[2] for field in fields] == [", °", "", ", 1/rad", ", 1/rad²", ""]
