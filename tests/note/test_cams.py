"""The note on the design of cams: every law, follower and way to give sizes; numbers of the worked cases."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path

import pytest

from note.naming import unnamed
from note.scenes import CONFIGS, told, written
from tmmcalc.cams.laws.catalogue import NAMES
from tmmcalc.cams.notes.laws import BOOK
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.note.tree import Equation
from tmmcalc.pipeline.chapters import chapters_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.drawing.order import POSITIONS
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Block, Chapter, Figure, Paragraph

HEAD = '[project]\ntitle = "t"\n\n[cam]\n'
STAGES = ("cam_law", "cam_synthesis", "cam_profile", "cam_pressure")
STEM = 'follower = "translating"\nstroke = "20 mm"\nrise = "70 deg"\nhigh_dwell = "25 deg"\nreturn_angle = "80 deg"\n'
ROCKER = (
    'follower = "oscillating"\nstroke = "20 deg"\nrise = "70 deg"\nhigh_dwell = "30 deg"\nreturn_angle = "80 deg"\n'
)
FLAT = 'follower = "flat"\nstroke = "12 mm"\nrise = "70 deg"\nhigh_dwell = "20 deg"\nreturn_angle = "75 deg"\n'
SUN, SHUN = 'law = "sine"\nspeed = "100 rpm"\n', 'law = "shun"\n'
ANTI, AGAINST = 'rotation = "counter-clockwise"\n', 'rocker_turn = "against"\n'
BOTH = '[cam.limits]\npressure_angle = "35 deg"\npressure_angle_return = "42 deg"\n'
SAME = '[cam.limits]\npressure_angle = "35 deg"\npressure_angle_return = "35 deg"\n'

KINDS = {
    "stem, free": STEM + SUN + BOTH,
    "stem, free, counter-clockwise": STEM + ANTI + SHUN + BOTH,
    "stem, free, like limits": STEM + ANTI + 'law = "cosine"\n' + SAME,
    "stem, free, return not limited": STEM + SHUN,
    "stem, given offset": STEM + ANTI + SHUN + 'offset = "-4 mm"\n' + BOTH,
    "stem, given start": STEM + SHUN + 'start_distance = "40 mm"\noffset = "3 mm"\nroller_radius = "5 mm"\n' + BOTH,
    "stem, given base": STEM + SHUN + 'base_radius = "45 mm"\noffset = "-3 mm"\nroller_radius = 0\n',
    "stem, given base and start": STEM + ANTI + SHUN + 'base_radius = "45 mm"\nstart_distance = "44 mm"\n',
    "stem, shaft": STEM + SHUN + '[cam.limits]\nshaft_radius = "40 mm"\n',
    "stem, curvature": STEM + SHUN + 'roller_radius = "25 mm"\n',
    "stem, no concave parts": STEM + 'law = "cosine"\n[cam.limits]\nallow_concave = false\n',
    "stem, tool": STEM + SHUN + 'start_distance = "60 mm"\ntool_radius = "30 mm"\nsteps = 8\n',
    "stem, undercut": STEM + SUN + 'start_distance = "30 mm"\nroller_radius = "20 mm"\nrefuse = false\n',
    "groove with a tool": STEM + SUN + ANTI + 'closure = "groove"\nstart_distance = "60 mm"\nroller_radius = "9 mm"\n'
    'tool_radius = "8 mm"\n',
    "groove, second wall": STEM + SUN + 'closure = "groove"\nroller_radius = "24 mm"\n',
    "no dwells": STEM.replace("25 deg", "0 deg").replace("80 deg", "290 deg")
    + 'rise_law = "const"\nreturn_law = "sine"\n',
    "own polynomial": STEM + "law = { polynomial = [0, 0, 3, -2] }\n",
    "own acceleration": STEM + "law = { acceleration = [[0, 0], [0.2, 1], [0.5, 1], [0.5, -1], [0.8, -1], [1, 0]] }\n",
    "own points": STEM + "law = { points = [[0, 0], [0.3, 0.1], [0.6, 0.8], [1, 1]] }\n",
    "rocker": ROCKER + SUN + 'rocker_length = "90 mm"\n' + BOTH,
    "rocker, against": ROCKER + AGAINST + SHUN + 'rocker_length = "90 mm"\n' + BOTH,
    "rocker, counter-clockwise": ROCKER + ANTI + SHUN + 'rocker_length = "90 mm"\n' + SAME,
    "rocker, against, counter-clockwise": ROCKER + ANTI + AGAINST + SUN + 'rocker_length = "90 mm"\n',
    "rocker, given centres": ROCKER + SHUN + 'centre_distance = "120 mm"\n' + BOTH,
    "rocker, given base": ROCKER + SHUN + 'base_radius = "50 mm"\n' + BOTH,
    "rocker, given angle": ROCKER + SHUN + 'rocker_length = "90 mm"\nstart_angle = "28 deg"\n' + BOTH,
    "rocker, both lengths": ROCKER + SHUN + 'rocker_length = "90 mm"\ncentre_distance = "110 mm"\n' + BOTH,
    "rocker, length and base": ROCKER + SHUN + 'rocker_length = "90 mm"\nbase_radius = "60 mm"\n' + BOTH,
    "rocker, centres and base": ROCKER + SHUN + 'centre_distance = "110 mm"\nbase_radius = "60 mm"\n' + BOTH,
    "rocker, three lengths": ROCKER + SHUN + 'rocker_length = "90 mm"\ncentre_distance = "110 mm"\n'
    'base_radius = "55 mm"\n',
    "rocker, length, base, angle": ROCKER + SHUN + 'rocker_length = "90 mm"\nbase_radius = "60 mm"\n'
    'start_angle = "32 deg"\n',
    "rocker, centres, base, angle": ROCKER + SHUN + 'centre_distance = "110 mm"\nbase_radius = "60 mm"\n'
    'start_angle = "30 deg"\n',
    "rocker, shaft": ROCKER + SHUN + 'rocker_length = "90 mm"\n[cam.limits]\nshaft_radius = "35 mm"\n',
    "rocker in a groove": ROCKER + SHUN + 'closure = "groove"\nrocker_length = "90 mm"\ntool_radius = "3 mm"\n',
    "rocker, pivot": ROCKER
    + SUN
    + 'rocker_length = "90 mm"\n[cam.loads]\ninertia = "1e-3 kg*m^2"\npivot_radius = "30 mm"\npivot_friction = 0.1\n',
    "flat": FLAT + SUN + 'face_margin = "2 mm"\n',
    "flat, counter-clockwise": FLAT + ANTI + 'law = "const"\nface_margin = "2 mm"\ntool_radius = "20 mm"\n',
    "flat, shaft": FLAT + SHUN + '[cam.limits]\nshaft_radius = "60 mm"\n',
    "flat, given": FLAT + SHUN + 'start_distance = "20 mm"\nrefuse = false\n',
}
KINDS |= {
    f"law {name}": STEM + f'rise_law = "{name}"\nreturn_law = "{other}"\nstart_distance = "50 mm"\nsteps = 11\n'
    for name, other in zip(NAMES, (*NAMES[1:], NAMES[0]), strict=True)
}
QUICK = ("stem, free, counter-clockwise", "rocker, against", "flat, counter-clockwise", "law modified_sine")
FILE = Path(__file__).parents[1] / "cases" / "cams.json"
CASES = {case["id"]: case for case in json.loads(FILE.read_text(encoding="utf-8"))}
NUMBER = re.compile(r"−?\d+(\.\d+)?(·10\^\S+)?(°| |$)")  # what an equation with its result ends with


def blocks_of(spec: Path, positions: str | None = None) -> list[Chapter]:
    """The chapter of a spec without what is drawn."""
    done = run(load_spec(spec), target=STAGES)
    titles = {"cams": "Cams"}
    found = chapters_of(titles, done.spec, done.results, {**NONE, POSITIONS: positions})
    return [chapter._replace(blocks=tuple(map(_undrawn, chapter.blocks))) for chapter in found]


def _undrawn(block: Block) -> Block:
    return block._replace(draw=lambda drawing, box: None) if isinstance(block, Figure) else block


@pytest.mark.parametrize("kind", [pytest.param(k, marks=() if k in QUICK else pytest.mark.slow) for k in KINDS])
def test_every_kind_of_cam_is_exact_and_works_out_as_printed(kind: str, tmp_path: Path) -> None:
    spec = tmp_path / "spec.toml"
    spec.write_text(HEAD + KINDS[kind], encoding="utf-8")
    found, chapters = Assembler(), blocks_of(spec)
    assert not [each for chapter in chapters for each in unnamed(chapter.blocks)]
    note = found.written(chapters)
    assert len(found.lines) > 20
    for line in found.lines:
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)
    said = text(note)
    assert "nan" not in said
    assert "<" not in said.replace(" < ", "")
    assert "{" not in said


def test_every_law_of_the_catalogue_has_its_formulas() -> None:
    assert set(BOOK) == set(NAMES)


@cache
def values(name: str, positions: str) -> dict[tuple[str, str], float]:
    """What the lines of a ready spec give, by their left sides and places; the first of each."""
    found: dict[tuple[str, str], float] = {}
    for each in Assembler().written(blocks_of(CONFIGS / f"{name}.toml", positions)):
        if isinstance(each, Equation) and NUMBER.match(plain(each.parts[-1])):
            number = plain(each.parts[-1]).split()[0].rstrip("°").replace("−", "-").replace("·10^", "e")
            found.setdefault((plain(each.parts[0]), each.lead), float(number))
    return found


@pytest.mark.parametrize(("name", "case"), [("cam-oscillating", "cams-s08"), ("cam-oscillating-against", "cams-s09")])
def test_the_textbooks_rocker(name: str, case: str) -> None:
    """Program 2.7: motion, profile and curvature, the pressure angle of position 4."""
    table, place = CASES[case]["expected"]["table"], "pos. 4"
    found = values(name, "4")
    for sign, key, factor in (
        ("ψ′", "psi1", 1.0),
        ("ψ′′", "psi2", 1.0),
        ("x", "xc_mm", 1.0),
        ("y", "yc_mm", 1.0),
        ("x_w", "xw_mm", 1.0),
        ("y_w", "yw_mm", 1.0),
        ("ρ", "rho_mm", 1.0),
        ("θ", "theta_deg", 1.0),
    ):
        if key in table:
            assert found[sign, place] == pytest.approx(factor * table[key][4], rel=2e-4), sign


def test_the_least_cam_of_unequal_phases() -> None:
    expected = CASES["cams-s11b"]["expected"]
    found = values("cam-synthesis", "30")
    assert found["S_0^*", ""] == pytest.approx(expected["approx_S0_mm"], rel=1e-4)
    assert found["e^*", ""] == pytest.approx(expected["approx_e_mm"], rel=1e-4)
    assert found["e", ""] == pytest.approx(expected["exact_e_mm"], rel=1e-4)
    assert found["S_0P", ""] == pytest.approx(expected["exact_S0_mm"], rel=1e-4)
    assert found["R_0", ""] == pytest.approx(expected["exact_R0_mm"], rel=1e-4)


def test_the_least_cam_with_a_rocker() -> None:
    expected = CASES["cams-s12"]["expected"]
    found = values("cam-rocker-synthesis", "15")
    assert found["ψ_0^*", ""] == pytest.approx(expected["approx_psi0_deg"], rel=1e-4)
    assert found["l_0^*", ""] == pytest.approx(expected["approx_l0_mm"], rel=1e-4)
    assert found["ψ_0", ""] == pytest.approx(expected["exact_psi0_deg"], rel=1e-4)
    assert found["l_0", ""] == pytest.approx(expected["exact_l0_mm"], rel=1e-4)
    assert found["R_0", ""] == pytest.approx(expected["exact_R0_mm"], rel=1e-4)


def test_the_groove_of_the_case() -> None:
    """Both walls at the middle of the rise, the largest roller."""
    expected, place = CASES["cams-s19"]["expected"], "pos. 30"
    found = values("cam-groove", "30")
    for sign, key in (("x_w", "x_inner"), ("y_w", "y_inner"), ("x_o", "x_outer"), ("y_o", "y_outer"), ("ρ", "rho")):
        assert found[sign, place] == pytest.approx(expected[key][2], rel=1e-4), sign


def test_the_flat_face_of_the_case() -> None:
    expected, place = CASES["cams-s13"]["expected"], "pos. 20"
    found = values("cam-flat", "20")
    at = expected["phi_deg"].index(20)
    assert found["x_w", place] == pytest.approx(expected["x_mm"][at], rel=1e-4)
    assert found["y_w", place] == pytest.approx(expected["y_mm"][at], rel=1e-4)
    assert found["ρ_w", place] == pytest.approx(expected["rho_mm"][at], rel=1e-4)
    assert found["S_0min", ""] == pytest.approx(expected["S0_min_mm"], rel=1e-4)


def test_a_scene_without_it_says_nothing_of_it() -> None:
    flat, groove = (
        text(Assembler().written(blocks_of(CONFIGS / f"{name}.toml"))) for name in ("cam-flat", "cam-groove")
    )
    assert "roller" not in flat
    assert "offset" not in flat
    assert "\n    e = " not in groove


@pytest.mark.slow
def test_the_cam_on_the_crank_is_told_after_its_forces() -> None:
    said = text(written("course-project", only=("cams",)))
    assert said.index("Forces in the cam mechanism") < said.index("The cam as a load of the shaft")
    assert all(f"{name} = " in said for name in ("J_c", "M_cQ", "M_cG", "M_cs", "M_cF", "M_c"))
    assert "The cam as a load" not in text(written("cam-translating", only=("cams",)))


def test_ukrainian_names_the_laws() -> None:
    with speaking("uk"):
        chapters = told("cam-translating", only=("cams",))
    said = " ".join(str(block) for block in chapters[0].blocks if isinstance(block, Paragraph))
    assert "косинусоїдний" in said
    assert "поліном 3-4-5" in said
