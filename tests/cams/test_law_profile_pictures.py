"""The pictures of law and profile: every follower is drawn, equal bytes each time, texts that a reader looks for."""

from itertools import combinations
from math import degrees, radians
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.lawresult import solve_law
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.task import Loads
from tmmcalc.core.errors import UsageError

pytest.importorskip("matplotlib")

from drawing import draw_cam

from tmmcalc.cams.pictures.cam_law import law_figure
from tmmcalc.cams.pictures.cam_profile import profile_figure

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


def texts(figure):
    from matplotlib.text import Text

    return " ".join(each.get_text() for each in figure.findobj(Text))


@sparing("name", SCENES, every=5)
def test_profiles(name, tmp_path: Path):
    program, follower, asked = SCENES[name]
    task = task_of(program, follower.kind, steps=6, **asked)
    result = solve_profile(task, follower)
    said = texts(profile_figure(task, result))
    assert ("second wall" in said) == (name == "groove")
    assert ("undercut" in said) == (name == "undercut")
    assert "low dwell" in said
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
    figure = profile_figure(task, result)
    axes = next(each for each in figure.axes if "curvature" in each.get_ylabel())
    drawn = np.concatenate([line.get_ydata() for line in axes.lines if len(line.get_ydata()) > 100])
    low, high = axes.get_ylim()
    assert np.isfinite(drawn).all()
    assert low < drawn.min() < drawn.max() < high
    peak = 1e-3 / (1 / result.sharpest.value - roller)
    assert drawn.max() == pytest.approx(peak, rel=1e-3)
    assert f"{peak:.4g}" in texts(figure)


@pytest.mark.slow
@pytest.mark.parametrize(("program", "kind"), [(STEM, "translating"), (ROCKER, "oscillating")])
def test_laws(program, kind, tmp_path: Path):
    task = task_of(program, kind, steps=6, loads=Loads(60.0))
    result = solve_law(task)
    said = texts(law_figure(task, result))
    assert ("b, c" in said.replace("b, c", "", 1)) == (program is STEM)  # no high dwell: one point in both diagrams
    assert "572.96 rpm" in said
    file = tmp_path / "law.png"
    draw_cam("cam_law", task, result, file)
    assert file.read_bytes().startswith(b"\x89PNG")
    with pytest.raises(UsageError, match="no picture format"):
        draw_cam("cam_law", task, result, tmp_path / "law.gif")


def boxes(figure, names):
    """Extents [dots] of the texts that begin with one of the names."""
    from matplotlib.text import Text

    found = [each for each in figure.findobj(Text) if each.get_text().startswith(names)]
    return {each.get_text(): each.get_window_extent() for each in found}


def apart(every):
    return not any(a.overlaps(b) for a, b in combinations(every, 2))


FACE = turn("const", rise=60, high=0, back=60)
SHORT = turn("cosine", rise=5, high=0, back=5)
NAMED = {**SCENES, "face": (FACE, Follower("flat", 0.08), {}), "short": (SHORT, Follower("translating", 0.5), {})}


@sparing("name", NAMED, every=8)
def test_phases_are_named_clear_of_each_other_and_of_the_walls(name):
    program, follower, asked = NAMED[name]
    task = task_of(program, follower.kind, **asked)
    result = solve_profile(task, follower)
    figure = profile_figure(task, result)
    found = boxes(figure, ("rise ", "high dwell ", "return ", "low dwell "))
    assert sorted(found) == sorted(f"{phase.kind} {degrees(phase.angle):.6g}°" for phase in program.phases)
    assert apart(found.values())
    axes = figure.axes[0]
    for wall in (result.working, result.outer):
        if wall is not None:
            on_paper = axes.transData.transform(np.column_stack((wall.points.real, wall.points.imag)))
            assert not any(box.count_contains(on_paper) for box in found.values())


@sparing("name", NAMED, every=8)
def test_positions_are_numbered_as_in_the_tables_and_can_be_read(name):
    from matplotlib.text import Text

    program, follower, asked = NAMED[name]
    task = task_of(program, follower.kind, **asked)
    result = solve_profile(task, follower)
    figure = profile_figure(task, result)
    assert "at i of the tables" in texts(figure)
    written = [
        each for each in figure.axes[0].findobj(Text) if each.get_text().isdigit() and each.get_fontsize() == 6.5
    ]
    assert len(written) >= 3
    assert apart([each.get_window_extent() for each in written])
    curve = result.working.points if result.flat else result.pitch
    for each in written:
        row = result.positions.labels.index(each.get_text())
        place = figure.axes[0].transData.transform([curve[row].real, curve[row].imag])
        middle = figure.axes[0].transData.transform(each.get_position())
        assert np.hypot(*(place - middle)) < 6.5 * figure.dpi / 25.4


@pytest.mark.slow
def test_only_the_line_of_the_cusp_has_its_look():
    """It bounds the pitch curve: the working profile may cross it, and must not be taken for it."""
    follower = Follower("translating", 0.055, 0.01, 0.02)
    task = task_of(STEM)
    axes = profile_figure(task, solve_profile(task, follower)).axes[1]
    (cusp,) = [line for line in axes.lines if {*line.get_ydata()} == {1e-3 / follower.roller}]
    assert {line.get_color() for line in axes.lines if line is not cusp}.isdisjoint({cusp.get_color()})
    assert "cusp of the pitch curve" in " ".join(each.get_text() for each in axes.get_legend().get_texts())


@pytest.mark.slow
def test_short_phases_are_named_beside_each_other():
    task = task_of(turn("cosine", rise=5, high=5, back=5))
    figure = law_figure(task, solve_law(task))
    found = boxes(figure, ("rise\n", "high dwell\n", "return\n", "low dwell\n"))
    assert len(found) == 4
    assert apart(found.values())
    frame = figure.axes[0].get_window_extent()
    assert all(box.x0 > frame.x0 - 1 and box.x1 < frame.x1 for box in found.values())


@pytest.mark.slow
def test_a_rocker_has_one_unit_for_its_angle_in_the_portrait():
    task = task_of(ROCKER, "oscillating")
    figure = law_figure(task, solve_law(task))
    portrait = figure.axes[-1]
    assert max(np.max(line.get_xdata()) for line in portrait.lines if len(line.get_xdata()) > 9) == pytest.approx(
        radians(20)
    )
    assert portrait.get_xlabel().endswith(", rad")
    assert [axes.get_ylabel().rpartition("$")[2] for axes in figure.axes] == [", °", "", ", 1/rad", ", 1/rad²", ""]


@pytest.mark.slow
def test_a_jump_at_the_begin_of_the_turn_is_drawn_over_the_frame():
    program = turn("cosine")
    axes = law_figure(task_of(program, steps=6), solve_law(task_of(program, steps=6))).axes[2]
    places = {
        line.get_xdata()[0]
        for line in axes.lines
        if len(line.get_xdata()) == 2 and line.get_xdata()[0] == line.get_xdata()[1] and not line.get_clip_on()
    }
    assert places == {0.0, 360.0}
