"""The pictures of law and profile: every follower is drawn, equal bytes each time, texts that a reader looks for."""

from math import radians
from pathlib import Path

import pytest

from tests.cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.lawresult import solve_law
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.task import Loads
from tmmcalc.errors import UsageError

pytest.importorskip("matplotlib")

from tmmcalc.report.pictures.cams import draw_cam
from tmmcalc.report.pictures.cams.law import law_figure
from tmmcalc.report.pictures.cams.profile import profile_figure

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


@pytest.mark.parametrize("name", SCENES)
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


def test_a_jump_at_the_begin_of_the_turn_is_drawn_over_the_frame():
    program = turn("cosine")
    axes = law_figure(task_of(program, steps=6), solve_law(task_of(program, steps=6))).axes[2]
    places = {
        line.get_xdata()[0]
        for line in axes.lines
        if len(line.get_xdata()) == 2 and line.get_xdata()[0] == line.get_xdata()[1] and not line.get_clip_on()
    }
    assert places == {0.0, 360.0}
