"""The note on the extras beside the collection's worked numbers, and what each option of a table tells."""

from __future__ import annotations

import re
from math import exp, pi
from pathlib import Path

import pytest

from note.naming import unnamed
from note.scenes import blocks, told, written
from note.test_forms import LATIN, words
from note.test_lines import mutants, wrong
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.conclusions import conclusions
from tmmcalc.note.plaintext import text
from tmmcalc.note.tree import Equation
from tmmcalc.pipeline.chapters import chapters_of, stages_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Chapter, Line, Result

ONLY = ("extras",)
TITLES = {"extras": "Further calculations"}
HEAD = '[project]\ntitle = "t"\n\n'
READY = ("ball", "bearing", "contact", "liner", "reliability", "tie-down", "transloader")
BALL = '[falling_ball]\nradius = "1 mm"\ndrag = 1e-4\ndecay = 0.5\n'
BEARING = '[bearing]\nspeed = "45 rpm"\ninner = "150 mm"\nouter = "340 mm"\nroller = "39 mm"\ncount = 14\n'
LINER = (
    '[liner]\nradius = "69 mm"\nthickness = "6.5 mm"\nring_outer = "80 mm"\nring_width = "10 mm"\nmoment = "1.3 kN"\n'
)
RELIABILITY = "[reliability]\nload = [2, 2.5]\nrate = 0.36\n"
TIES = '[tie_down]\nweight = "70 kN"\nelevation = "40 deg"\nfriction = 0.4\n'
SUPPORT = (
    '[tie_down.support]\nfriction = 0.2\nbase = "15 m"\ncradle_arm = "12 m"\narm = "3 m"\nweight = "3 kN"\n'
    'diameter = "3 m"\n'
)
CRANE = '[transloader]\ncapacity = "16 t"\n'
PART = (
    '[[transloader.parts]]\nname = "beam"\narea = "210 cm^2"\nstrength = "240 MPa"\nendurance = "180 MPa"\n'
    "influence = { dead_weight = -0.12, rated_load = 2.4, equivalent_wind = -1.5, hurricane = 2.0, shock = 0.8 }\n"
)
KINDS = {  # specs in which formulas differ from those of the ready specs
    "circle": '[contact]\nload = "1 kN"\nradii = "20 mm"\ncells = 8\n',
    "wide ellipse": '[contact]\nload = "1 kN"\nmodulus = "113200 MPa"\nradii = ["40 mm", "20 mm"]\ncells = 8\n',
    "gap by a formula": '[contact]\nload = "1 kN"\ngap = "x**2/0.04 + y**4/1e-4"\nsize = "1 mm"\ncells = 8\n',
    "gap no formula of a note": '[contact]\nload = "1 kN"\ngap = "max(x**2, y**2)/0.04 if x < 1 else x**2"\n'
    'size = "1 mm"\ncells = 8\n',
    "gap by a table": '[contact]\nload = "10 N"\ncells = 8\n[contact.table]\nx = ["-1 mm", 0, "1 mm"]\n'
    'y = ["-1 mm", 0, "1 mm"]\nh = [["0.05 mm", "0.025 mm", "0.05 mm"], ["0.025 mm", 0, "0.025 mm"], '
    '["0.05 mm", "0.025 mm", "0.05 mm"]]\n',
    "strength": f"{RELIABILITY}strength = 2.56\ndecay = 2.6e-4\ntimes = [50, 150, 1500]\n",
    "strength without times": f"{RELIABILITY}strength = 2.56\ndecay = 2.6e-4\n",
    "weak from the start": f"{RELIABILITY}strength = 2.3\ndecay = 0.3\ntimes = [0.2, 2]\n",
    "every shock": f"{RELIABILITY}strength = 1.9\ndecay = 2.6e-4\ntimes = [2]\n",
    "loads from nothing": "[reliability]\nload = [0, 2.5]\nrate = 0.36\nstrength = 2.6\ndecay = 0.01\n",
    "readings": "[reliability]\nreadings = [2.1, 2.4, 2.2, 2.05]\nrate = 0.36\nitems = 30\nleast_life = 100\n"
    "mean_life = 150\n",
    "readings from nothing": "[reliability]\nreadings = [0.1, 2.4]\nrate = 0.36\nstrength = 5\ndecay = 0.01\n",
    "friction holds": f'{TIES}factor = 0.3\npreload = "8 kN"\n',
    "all ties": f'{TIES}factor = 0.7\npreload = "8 kN"\nsection = "1.8 cm^2"\nstrength = "60 MPa"\n',
    "two ties": f'{TIES}factor = 1.2\nplan_angle = "10 deg"\nsection = "0.5 cm^2"\nstrength = "240 MPa"\n',
    "preload by a thread": f"{TIES}factor = 1.0\n[tie_down.thread]\n"
    'moment = "30 N*m"\ndiameter = "14.7 mm"\nlead_angle = "2.5 deg"\nfriction_angle = "11.7 deg"\n' + SUPPORT,
    "ties that yield": f'{TIES}factor = 0.7\npreload = "80 kN"\nsection = "1.8 cm^2"\nstrength = "240 MPa"\n',
    "driven on": f'{BALL}reaction = "accelerating"\nrelative_speed = "4 m/s"\ntimes = ["0.5 s", "2 s"]\n',
    "without reaction": f'{BALL}initial_speed = "3 m/s"\n',
    "drag alone": f'{BALL}gravity = 0\ninitial_speed = "6 m/s"\ntimes = ["1 s"]\n',
    "drag alone, even": f'{BALL}gravity = 0\ninitial_speed = "5 m/s"\ntimes = ["1 s"]\n',
    "balanced": f'{BALL}gravity = "9 m/s^2"\nrelative_speed = "6 m/s"\ninitial_speed = "7 m/s"\n',
    "nothing moves": f"{BALL}gravity = 0\n",
    "own speed, on": f'{BALL}reaction = "accelerating"\nrelative_speed = "own"\ninitial_speed = "1 m/s"\n',
    "own speed, braked": f'{BALL}relative_speed = "own"\ninitial_speed = "1 m/s"\ntimes = ["0.3 s", "3 s"]\n',
    "behind the stop": f'{BALL}relative_speed = "10 m/s"\ninitial_speed = "7 m/s"\nduration = "3 s"\n'
    'times = ["1 s", "2 s"]\n',
    "rises": f'{BALL}relative_speed = "10 m/s"\ntimes = ["1 s"]\nduration = "2 s"\n',
    "large arguments": BALL.replace("1e-4", "2.0").replace("0.5", "0.01") + 'times = ["1 s"]\n',
    "angular contact": f'{BEARING}contact_angle = "25 deg"\n',
    "sound": f"{BEARING}peak = [4, 4.2]\nrms = [1.4, 1.4]\n",
    "a defect": f"{BEARING}peak = [4, 8.2]\nrms = [1.4, 1.4]\n",
    "long liner": f'{LINER}continuity = "centre"\n',
    "short liner": f'{LINER}length = "40 mm"\nload = "20 N/mm"\nallowed = "20 MPa"\n',
    "thick liner": LINER.replace("6.5", "8").replace('moment = "1.3 kN"', 'pressure = "3 MPa"'),
    "capacity alone": '[transloader]\ncapacity = "17 t"\n',
    "usual speeds": f'{CRANE}span = "100 m"\ntrolley = {{ path = "60 m", acceleration = "0.6 m/s^2" }}\n'
    'hoist = { height = "25 m", acceleration = "1.5 m/s^2" }\n'
    'inertia = { weights = ["157 kN", "290 kN"], time = "5 s" }\n',
    "speeds too high": f'{CRANE}trolley = {{ path = "6 m", acceleration = "0.5 m/s^2", speed = "3 m/s" }}\n'
    'inertia = { weights = ["157 kN"], speed = "2 m/s", time = "5 s" }\n',
    "product, with blanks": f'{CRANE}mass = "560 t"\nfactors = "product"\nblanks = "with"\n'
    'equivalent_wind = { pressure = "60 Pa", area = "210 m^2" }\nloads = { hurricane = "380 kN", shock = "240 kN" }\n'
    f'{PART}importance = [1.2, 1.1, 1.0]\nmechanism = "luffing"\nduty = "medium"\nmaking = "forged"\n',
    "too strained": f'{CRANE}mass = "560 t"\n'
    f'loads = {{ hurricane = "9000 kN", equivalent_wind = "1000 kN", shock = "9000 kN" }}\n{PART}',
}
FEW = {
    "nothing moves": 0,
    "capacity alone": 1,
    "sound": 10,
    "a defect": 10,
    "speeds too high": 5,
}  # lines at least, where they are few


def chapters(kind: str, folder: Path) -> list[Chapter]:
    """The chapters of a kind in the language in force."""
    spec = folder / "scene.toml"
    spec.write_text(HEAD + KINDS[kind], encoding="utf-8")
    done = run(load_spec(spec), target=stages_of(ONLY))
    return chapters_of(TITLES, done.spec, done.results, NONE)


@pytest.mark.parametrize("kind", KINDS)
def test_every_option_is_told_in_lines_that_are_exact(kind: str, tmp_path: Path) -> None:
    found = Assembler()
    made = chapters(kind, tmp_path)
    said = text(found.written([*made, conclusions(made, [], [])]))
    assert not [each for chapter in made for each in unnamed(chapter.blocks)]
    assert len(found.lines) >= FEW.get(kind, 6)
    for line in found.lines:
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)
    assert not re.search(r"\bnan\b|\binf\b|\$", said)


@pytest.mark.parametrize("kind", KINDS)
def test_no_english_is_left_in_ukrainian(kind: str, tmp_path: Path) -> None:
    with speaking("uk"):
        note = Assembler().written(chapters(kind, tmp_path))
    own = set(LATIN.findall(KINDS[kind]))
    assert not set(LATIN.findall(" ".join(words(note)))) - own


def test_mutants_are_caught() -> None:
    """Less than 1 in 100 is missed."""
    caught, missed = 0, []
    for name in READY:
        for block in blocks(told(f"extra-{name}", only=ONLY)):
            if not isinstance(block, Line):
                continue
            for mutant in mutants(block.formula):
                if any(wrong(mutant, place.lexicon) for place in block.places):
                    caught += 1
                else:
                    missed.append((name, mutant))
    assert caught > 400
    assert len(missed) <= 0.01 * (caught + len(missed)), missed


RESULT = re.compile(r"−?\d+(\.\d+)?(·10\^\S+)?(°| |$)")  # what an equation with its result ends with


def values(name: str) -> dict[str, list[float]]:
    """What the lines of a ready spec give, by their left sides."""
    found: dict[str, list[float]] = {}
    for each in Assembler().written(told(f"extra-{name}", only=ONLY)):
        if isinstance(each, Equation) and RESULT.match(plain(each.parts[-1])):
            number = plain(each.parts[-1]).split()[0].rstrip("°").replace("−", "-")
            number = re.sub(r"·10\^(-?\d+)", r"e\1", number)
            found.setdefault(plain(each.parts[0]), []).append(float(number))
    return found


def test_the_collections_ties() -> None:
    """Paper 2: R = 14290 N, vertical load 24665 N, with P0 = 8050 N."""
    found = values("tie-down")
    assert found["R"] == [pytest.approx(14287, abs=1)]
    assert found["V"] == [pytest.approx(24667, abs=1)]
    assert found["ΔR"] == [pytest.approx(6237, abs=1)]


def test_the_collections_product() -> None:
    """Paper 7: r = 2.5594143, t0 = 91.50608697, with beta = 2.566791704e-4."""
    found = values("reliability")
    assert found["r"] == [2.5594]
    assert found["t_0"] == [91.506]
    assert found["T"] == [150]
    assert "β = 0.0002566792" in text(written("extra-reliability", only=ONLY))


def test_the_collections_bearing() -> None:
    """Paper 11: omega = 4.8 rad/s, n = 0.764 1/s; the raceway has 0.36 m/s."""
    found = values("bearing")
    assert found["ω"] == [4.8]
    assert found["n"] == [0.76394]
    assert found["v_i"] == [360]


def test_hertz_by_a_sphere(tmp_path: Path) -> None:
    """p0 = (6 P E*^2/(pi^3 R^2))^(1/3), which the note does not use."""
    assembler = Assembler()
    assembler.written(chapters("circle", tmp_path))
    found = {plain_name(line.formula.sides[0]): float(line.found.result) for line in assembler.lines}
    modulus = 206e3 / (2 * (1 - 0.3**2))
    assert found["p_0"] == pytest.approx((6 * 1000 * modulus**2 / (pi**3 * 20**2)) ** (1 / 3), rel=1e-4)


def plain_name(node: object) -> str:
    return str(getattr(node, "key", node))


def test_the_balls_speed_by_steps() -> None:
    """dv/dt = g - alpha/r v^2 - 3 lambda V by Runge and Kutta's method, from 7 m/s to 0.5 s."""

    def slope(t: float, v: float) -> float:
        return 9.81 - 3 * 0.5 * 10 - 1e-4 / (1e-3 * exp(-0.5 * t)) * v * abs(v)

    v, h = 7.0, 0.5 / 200
    for k in range(200):
        t = k * h
        first = slope(t, v)
        second = slope(t + h / 2, v + h / 2 * first)
        third = slope(t + h / 2, v + h / 2 * second)
        v += h / 6 * (first + 2 * second + 2 * third + slope(t + h, v + h * third))
    assert values("ball")["v"][0] == pytest.approx(v, rel=2e-5)


def test_limits_that_fail_are_told(tmp_path: Path) -> None:
    made = chapters("too strained", tmp_path)
    said = text(Assembler().written([*made, conclusions(made, [], [])]))
    assert "Limits that are not kept:" in said
    results = [each for each in blocks(made) if isinstance(each, Result)]
    failing = [each for each in results if float(str(each.given.value)) > (each.limit or 0.0)]
    assert said.count("stress of the part σ = ") == len(failing) > 1
    high = chapters("speeds too high", tmp_path)
    said = text(Assembler().written([*high, conclusions(high, [], [])]))
    assert "speed of the trolley by its way v_1 = 180 m/min is above 51.962 m/min" in said


def test_a_chapter_of_one_subject_has_its_title_and_one_of_several_its_parts(tmp_path: Path) -> None:
    assert [each.title for each in told("extra-bearing", only=ONLY)] == ["Rolling bearing"]
    spec = tmp_path / "scene.toml"
    spec.write_text(HEAD + BEARING + BALL, encoding="utf-8")
    done = run(load_spec(spec), target=stages_of(ONLY))
    (chapter,) = chapters_of(TITLES, done.spec, done.results, NONE)
    said = text(Assembler().written([chapter]))
    assert chapter.title == "Further calculations"
    assert "1.1 Fall of a ball whose radius decreases" in said
    assert "1.2.1 Speed and sizes" in said


def test_what_a_scene_lacks_leaves_no_trace(tmp_path: Path) -> None:
    assert "Crest" not in text(Assembler().written(chapters("angular contact", tmp_path)))
    free = text(Assembler().written(chapters("friction holds", tmp_path)))
    assert "support" not in free
    assert "Stress" not in free
    assert "far end" not in text(Assembler().written(chapters("long liner", tmp_path)))
