"""The note on the loaded cam: forces, requirements, best sizes, vibration, indexing drives; every variant of them.

Numbers are those of the textbook's worked cases, of the paper on cam-lantern drives, or of other formulas.
"""

from __future__ import annotations

import re
from math import pi, sin
from pathlib import Path

import pytest

from note.naming import unnamed
from note.scenes import told
from tmmcalc.core.stage import STAGES, resolve
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.note.tree import Equation
from tmmcalc.pipeline.chapters import stages_of
from tmmcalc.pipeline.picturing import NONE, order_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.language import speaking, tr_name
from tmmcalc.report.manuscript import Chapter, Table
from tmmcalc.rooms import CHAPTERS

ONLY = ("cams",)
HEAD = '[project]\ntitle = "t"\n\n'
STEM = (
    '[cam]\nfollower = "translating"\nstroke = "20 mm"\nrise = "80 deg"\nhigh_dwell = "20 deg"\n'
    'return_angle = "90 deg"\nlaw = "{law}"\nspeed = "{speed}"\nstart_distance = "50 mm"\noffset = "{offset}"\n'
    'roller_radius = "8 mm"\nsteps = 12\nrotation = "{rotation}"\n{more}'
)
ROCKER = (
    '[cam]\nfollower = "oscillating"\nrocker_turn = "{turn}"\nrotation = "{rotation}"\nstroke = "30 deg"\n'
    'rise = "60 deg"\nhigh_dwell = "30 deg"\nreturn_angle = "70 deg"\nlaw = "{law}"\nspeed = "100 rad/s"\n'
    'centre_distance = "100 mm"\nrocker_length = "100 mm"\nstart_angle = "30 deg"\nroller_radius = "10 mm"\n'
    "steps = 10\n"
)
FACE = (
    '[cam]\nfollower = "flat"\nstroke = "12 mm"\nrise = "70 deg"\nhigh_dwell = "20 deg"\nreturn_angle = "80 deg"\n'
    'law = "{law}"\nspeed = "120 rad/s"\nrotation = "{rotation}"\nsteps = 12\n\n[cam.limits]\nconvex_radius = "3 mm"\n'
)
USUAL = {"law": "cosine", "speed": "100 rad/s", "offset": "5 mm", "rotation": "clockwise", "turn": "with", "more": ""}
GUIDE = '[cam.guide]\ntop = "125 mm"\nstem_radius = "3.5 mm"\nland = "4 mm"\ngap = "1 mm"\n'
LENGTH = '[cam.guide]\nlength = "40 mm"\nstem_radius = "4 mm"\nland = "5 mm"\n'
NEEDS = (
    '[cam.requirements]\nwidth = "8 mm"\ncontact = "400 MPa"\nrolling_arm = "0.05 mm"\nroller_friction = 0.1\n'
    'pin_friction = 0.1\npin_pressure = "5 MPa"\nspan = "100 mm"\nbending = "100 MPa"\ndeflection = "0.01 mm"\n'
    'guide_pressure = "5 MPa"\n'
)
NUMBER = re.compile(r"−?\d+(\.\d+)?(·10\^\S+)?(°| |$)")  # what an equation with its result ends with


OF_ROCKER = NEEDS.replace('guide_pressure = "5 MPa"\n', "")
OF_FACE = (
    '[cam.requirements]\nwidth = "8 mm"\ncontact = "400 MPa"\nspan = "100 mm"\nbending = "100 MPa"\n'
    'deflection = "0.01 mm"\nguide_pressure = "5 MPa"\n'
)


def stem(**own: str) -> str:
    return STEM.format(**{**USUAL, **own})


def rocker(**own: str) -> str:
    return ROCKER.format(**{**USUAL, **own})


def face(**own: str) -> str:
    return FACE.format(**{**USUAL, **own})


def loads(**own: object) -> str:
    said = {"mass": '"0.2 kg"', **own}
    return "[cam.loads]\n" + "".join(f"{key} = {value}\n" for key, value in said.items() if value is not None)


STEEL = '[cam.requirements]\nwidth = "8 mm"\nmaterial = {{ treatment = "{}", hardness = "{}" }}\n'
KINDS = {
    "friction, weight, force": stem() + loads(friction=0.1, gravity='"-9.81 m/s^2"', force='"-50 N"') + GUIDE + NEEDS,
    "counter-clockwise": stem(rotation="counter-clockwise", offset="-8 mm", law="sine")
    + loads(friction=0.15, force='"-30 N"', force_return='"-10 N"')
    + LENGTH
    + NEEDS,
    "no spring": stem(law="shun")
    + loads(force='"-900 N"', force_return='"-500 N"')
    + '[cam.spring]\nmethod = "none"\n',
    "spring given": stem() + loads() + '[cam.spring]\nstiffness = "3 N/mm"\npreload = "40 N"\n' + NEEDS,
    "contact lost": stem() + loads() + '[cam.spring]\nstiffness = "1 N/mm"\npreload = "5 N"\n',
    "tangent": stem(law="shun") + loads(gravity='"-9.81 m/s^2"') + '[cam.spring]\nleast_contact = "5 N"\n',
    "tangent, deflection": stem() + loads() + '[cam.spring]\nleast_contact = "5 N"\ndeflection = "15 mm"\n',
    "exact": stem(law="sine") + loads() + "[cam.spring]\nsafety = 1.4\nexact = true\n",
    "both phases": stem(law="const", more="")
    .replace('law = "const"', 'rise_law = "cosine"\nreturn_law = "const"')
    .replace('"90 deg"', '"80 deg"')
    + loads()
    + "[cam.spring]\nsafety = 1.3\n",
    "wire": stem() + loads() + '[cam.spring]\nsafety = 1.3\nwire = "2 mm"\ncoil = "16 mm"\nshear_stress = "500 MPa"\n',
    "force by a table": stem()
    + loads(
        force_table='{ phi = ["0 deg", "60 deg", "60 deg", "200 deg"], force = ["-20 N", "-60 N", "-5 N", "-5 N"] }'
    )
    + NEEDS,
    "groove": stem(more='closure = "groove"\n', law="sine", offset="0 mm") + loads() + GUIDE + NEEDS,
    "groove with friction": stem(more='closure = "groove"\n', law="cosine") + loads(friction=0.1) + GUIDE,
    "groove, one wall": stem(more='closure = "groove"\n', law="shun")
    + loads(force='"-900 N"', force_return='"-900 N"')
    + GUIDE
    + NEEDS,
    "pin and inertia given": stem()
    + loads()
    + NEEDS.replace('pin_pressure = "5 MPa"', 'pin_pressure = "5 MPa"\npin = "3 mm"\nroller_inertia = "5e-7 kg*m^2"'),
    "slips": stem(law="sine", speed="140 rad/s") + loads() + NEEDS.replace("0.1\npin_friction", "0.02\npin_friction"),
    "improved steel": stem() + loads() + STEEL.format("improved", "300 HB"),
    "carburised steel": stem() + loads() + STEEL.format("carburised", "60 HRC"),
    "no concave parts": stem(offset="0 mm", law="const").replace('"50 mm"', '"25 mm"')
    + '[cam.limits]\nallow_concave = false\nshaft_radius = "7 mm"\n'
    + loads()
    + NEEDS,
    "knife edge": stem().replace('"8 mm"', '"0 mm"') + loads() + NEEDS,
    "rocker with friction": rocker(law="linear")
    + loads(mass=None, inertia='"1e-4 kg*m^2"', pivot_friction=0.1, pivot_radius='"8 mm"', force='"-1 N*m"')
    + OF_ROCKER,
    "rocker against, counter-clockwise": rocker(turn="against", rotation="counter-clockwise", law="parab2")
    + loads(mass=None, inertia='"1e-4 kg*m^2"', pivot_friction=0.1, pivot_radius='"8 mm"')
    + OF_ROCKER
    + '[cam.elastic]\nstiffness = "900 N*m/rad"\ndamping = 0.02\n',
    "rocker against": rocker(turn="against") + loads(mass=None, inertia='"1e-4 kg*m^2"') + OF_ROCKER,
    "rocker, tangent": rocker(law="poly5", rotation="counter-clockwise")
    + loads(mass=None, inertia='"1e-4 kg*m^2"')
    + '[cam.spring]\nleast_contact = "0.2 N*m"\n',
    "rocker in a groove": rocker(law="sine").replace("steps", 'closure = "groove"\nsteps')
    + loads(mass=None, inertia='"1e-4 kg*m^2"')
    + OF_ROCKER,
    "rocker, exact": rocker(law="const") + loads(mass=None, inertia='"1e-4 kg*m^2"') + "[cam.spring]\nexact = true\n",
    "flat, best sizes": face(law="sine") + loads(friction=0.1) + LENGTH + OF_FACE + "[cam.optimum]\n",
    "flat, counter-clockwise": face(law="const", rotation="counter-clockwise")
    + loads(friction=0.05, force='"-40 N"')
    + LENGTH
    + OF_FACE
    + '[cam.optimum]\nphases = "rise"\n',
    "flat without friction": face(law="poly4567") + loads() + LENGTH + OF_FACE.replace('"400 MPa"', '"300 MPa"'),
    "best sizes, counter-clockwise": stem(rotation="counter-clockwise", law="sine", offset="-3 mm")
    + loads(friction=0.1)
    + GUIDE
    + NEEDS
    + '[cam.optimum]\nphases = "rise"\n',
    "design game": stem(offset="0 mm")
    + loads(friction=0.1)
    + GUIDE
    + NEEDS
    + '[cam.optimum]\nlaws = ["sine"]\nsafeties = [1.5]\ncontacts = { "steel" = "600 MPa" }\n'
    + 'roller_ratios = { "needles" = 1.2 }\n',
    "as asked none": stem(offset="0 mm")
    + loads(friction=0.1)
    + GUIDE
    + NEEDS.replace('"400 MPa"', '"60 MPa"')
    + '[cam.optimum]\ncontacts = { "hard" = "600 MPa" }\n',
    "elastic without damping": stem(law="sine") + loads(force='"-50 N"') + '[cam.elastic]\nstiffness = "733 N/mm"\n',
    "elastic parts": stem(law="const", speed="300 rad/s")
    + loads()
    + '[cam.elastic]\nstiffness = "400 N/mm"\ndamping = 0.01\nmass = "0.3 kg"\n',
    "elastic groove": stem(more='closure = "groove"\n')
    + loads()
    + '[cam.elastic]\nstiffness = "400 N/mm"\ndamping = 0.05\n',
    "indexing, chosen": '[indexing]\nrollers = 10\nstep_angle = "120 deg"\nlaw = "modified_sine"\n'
    'wheel_radius = "60 mm"\n',
    "indexing, ends": '[indexing]\nrollers = 8\nstep_angle = "100 deg"\nlaw = { constant_ends = 0.1 }\n'
    'wheel_radius = "60 mm"\nratio = 2.1\n',
    "indexing, code": '[indexing]\nrollers = 8\nstep_angle = "110 deg"\nlaw = "0010"\nwheel_radius = "60 mm"\n',
    "indexing, B alone": '[indexing]\nrollers = 6\nstep_angle = "90 deg"\nlaw = { peak_velocity = 1.625 }\n'
    'wheel_radius = "50 mm"\n',
    "indexing, equal rollers": '[indexing]\nrollers = 8\nstep_angle = "90 deg"\ndwells = ["120 deg", "60 deg"]\n'
    'law = "shun"\nwheel_radius = "60 mm"\nfriction = 0\n',
    "indexing, four rollers": '[indexing]\nrollers = 4\nstep_angle = "90 deg"\nlaw = "cosine"\n'
    'wheel_radius = "40 mm"\npressure_angle = "60 deg"\n',
}


TOLD = ("cam_forces", "cam_strength", "cam_optimum", "cam_elastic", "indexing")
QUICK = ("friction, weight, force", "groove", "rocker with friction", "flat, counter-clockwise", "indexing, B alone")
LATIN = re.compile(r"[A-Za-z]{3,}")


def told_of(kind: str, folder: Path) -> list[Chapter]:
    """The chapters of a kind in the language in force."""
    return of_text(KINDS[kind], folder)


def of_text(said: str, folder: Path) -> list[Chapter]:
    """The chapter of a spec, its second half."""
    spec = folder / "spec.toml"
    spec.write_text(HEAD + said, encoding="utf-8")
    done = run(load_spec(spec), target=stages_of(ONLY))
    order = order_of(done.spec, done.results, NONE)
    blocks = [block for name in TOLD if name in done.results for block in resolve(f"{STAGES[name].note}:blocks")(order)]
    return [Chapter("cams", tr_name(CHAPTERS["cams"]), tuple(blocks))]


def values(chapters: list[Chapter]) -> dict[tuple[str, str], float]:
    """What the lines give, by their left sides and places; the last of each."""
    found: dict[tuple[str, str], float] = {}
    for each in Assembler().written(chapters):
        if isinstance(each, Equation) and NUMBER.match(plain(each.parts[-1])):
            number = re.split(r"[ °]", plain(each.parts[-1]).replace("−", "-").replace("·10^", "e"))[0]
            found[plain(each.parts[0]), each.lead] = float(number)
    return found


@pytest.mark.parametrize("kind", [pytest.param(n, marks=() if n in QUICK else pytest.mark.slow) for n in KINDS])
def test_every_kind_is_exact_and_works_out_as_printed(kind: str, tmp_path: Path) -> None:
    found, chapters = Assembler(), told_of(kind, tmp_path)
    assert not [each for chapter in chapters for each in unnamed(chapter.blocks)]
    note = found.written(chapters)
    assert len(found.lines) > 10
    for line in found.lines:
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)
    assert "nan" not in text(note)


@pytest.mark.slow
def test_the_worked_cam_with_friction() -> None:
    """Case cams-s20: offset stem, cosine rise, shun return; table positions 3 (20 deg), 6 (40 deg), 19 (145 deg)."""
    found = values(told("cam-translating", "3,6,19", ONLY))
    at = [f"pos. {label}" for label in (3, 6, 19)]
    for name, three, tolerance in (
        ("P_c", (-137.0473, -101.25, -101.25), 5e-5),
        ("R", (160.4557, 121.187, 100.5552), 5e-5),
        ("N_1", (-90.40351, -69.83095, 41.72799), 5e-5),  # the case has sizes of N_1
        ("A", (27.94983, 20.45396, -22.77317), 5e-5),
        ("T", (-2.180409, -2.278125, 2.417166), 5e-5),
        ("σ_H", (307.3875, 277.1295, 252.9168), 5e-5),
    ):
        for place, value in zip(at, three, strict=True):
            assert found[name, place] == pytest.approx(value, rel=tolerance), (name, place)
    for name, value in (
        ("P_M", 101.25),
        ("Q_0", 50.625),
        ("c", 5.0625),
        ("C_1", 0.3642936),
        ("C_2", 0.6237045),
        ("M_E", 4.435643),
        ("r′_1", 3.83668),
    ):
        assert found[name, ""] == pytest.approx(value, rel=5e-5), name
    assert found["D", "at φ = 28.646°"] == pytest.approx(0.4799831, rel=5e-5)
    assert max(value for (name, _), value in found.items() if name == "σ_H") == pytest.approx(307.4149, rel=5e-5)


def test_the_spring_by_the_tangent(tmp_path: Path) -> None:
    """Case cams-s07 of the guide: const law, m = 0.12 kg, 600 rpm, h = 40 mm, S''max = 50.5 mm."""
    said = (
        '[cam]\nfollower = "translating"\nstroke = "40 mm"\nrise = "1.7799766 rad"\nhigh_dwell = "20 deg"\n'
        'return_angle = "120 deg"\nlaw = "const"\nspeed = "600 rpm"\nstart_distance = "60 mm"\noffset = 0\n'
        'roller_radius = "8 mm"\n[cam.loads]\nmass = "0.12 kg"\n[cam.spring]\nleast_contact = "5 N"\n'
        'deflection = "16 mm"\n'
    )
    found = values(of_text(said, tmp_path))
    for name, value in (("P_t", 23.92403), ("c", 0.8034454), ("Q_0", 12.85513), ("Q_max", 44.99294)):
        assert found[name, ""] == pytest.approx(value, rel=3e-5), name


def test_the_lowest_flat_face(tmp_path: Path) -> None:
    """Case cams-s13b: l* = 17.19685 mm, H2 = 71.83835 mm by convexity and the pressure in the guide."""
    said = (
        face(law="sine").replace("80 deg", "70 deg")
        + loads(mass='"0.15 kg"', friction=0.1)
        + '[cam.spring]\nstiffness = "8 N/mm"\npreload = "60 N"\n'
        + LENGTH
        + '[cam.requirements]\nguide_pressure = "5 MPa"\n[cam.optimum]\nphases = "rise"\n'
    )
    found = values(of_text(said, tmp_path))
    assert found["l^*", ""] == pytest.approx(17.19685, rel=3e-5)
    assert found["H_2,min", ""] == pytest.approx(71.83835, rel=3e-5)


def test_a_cycloidal_rise_leaves_what_the_closed_form_says(tmp_path: Path) -> None:
    """A = h |sin(pi tau)|/(pi tau |1 - tau^2|) without damping."""
    found = values(told_of("elastic without damping", tmp_path))
    tau = found["τ_y", "rise"]
    assert found["A_y", "rise"] == pytest.approx(20 * abs(sin(pi * tau) / (pi * tau * (1 - tau**2))), rel=2e-4)


def test_the_indexing_drive_of_the_paper() -> None:
    """Paper 12: z2 = 6, phi_p = 90 deg, Shun: lambda_min = 2.25, theta_1m; vartheta_2(1) = vartheta_1m by symmetry."""
    chapters = told("cam-lantern", None, ONLY)
    found = values(chapters)
    for name, value in (("λ_min", 2.25), ("λ_max", 3.701666), ("δ_0", 16.08517), ("ϑ_1m", 43.91483), ("ρ_m", -2.48731)):
        assert found[name, ""] == pytest.approx(value, rel=2e-5), name
    assert found["ψ_A", ""] == pytest.approx(90 * (0.742217 - 0.5), abs=1e-3)
    assert found["ϑ_B", "at k = 0.75"] == -found["ϑ_B", "at k = 0.25"]


@pytest.mark.slow
def test_what_a_scene_lacks_leaves_no_trace(tmp_path: Path) -> None:
    bare = text(Assembler().written(told_of("no spring", tmp_path)))
    assert not re.search(r"μ|jam|Return spring|guide", bare)
    flat = text(Assembler().written(told_of("flat without friction", tmp_path)))
    assert "roller centre" not in flat
    assert "r_2" not in flat
    rocker_said = text(Assembler().written(told_of("rocker against", tmp_path)))
    assert "N_1" not in rocker_said
    assert "stem" not in rocker_said


@pytest.mark.parametrize("kind", ["counter-clockwise", "rocker with friction", "indexing, ends", "wire"])
def test_ukrainian_has_no_english_left(kind: str, tmp_path: Path) -> None:
    with speaking("uk"):
        said = text(Assembler().written(told_of(kind, tmp_path)))
    sentences = [line for line in said.splitlines() if not re.search(r"[=≤≥_]", line)]
    assert not LATIN.findall("\n".join(sentences))
    assert not re.search(r"\d\.\d+ (мм|Н|МПа|Н·м)", said)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("contact lost", "the closure of the pair is lost"),
        ("both phases", "The return lifts the follower off lower down, at φ = 140°"),
        ("groove with friction", "The roller goes to the other wall of the groove at φ = 40°, 145°"),
        ("slips", "Requirements that are not kept: rolling without slip"),
        ("carburised steel", "D.4.4: carburised, nitrocarburised"),
        ("exact", "The angle φ = "),
    ],
)
def test_what_is_special_is_said(kind: str, said: str, tmp_path: Path) -> None:
    assert said in text(Assembler().written(told_of(kind, tmp_path)))


@pytest.mark.slow
def test_an_extreme_that_a_dwell_keeps_is_told_with_the_dwell() -> None:
    """The part is pushed out until the end of the far dwell; in the near one the spring alone presses."""
    (cam,) = told("course-project", None, ONLY)
    rows = next(each for each in cam.blocks if isinstance(each, Table) and each.key == "cam_extremes").rows
    (load,) = [row for row in rows if row[0].startswith("$P_c$")]
    assert (load[2], load[4]) == ("80–100", "190–360")
    (force,) = [row for row in rows if row[0].startswith("$R$")]
    assert "–" not in force[2] + force[4]  # friction has its sense while the follower moves
    assert "touches the curve" in text(Assembler().written([cam]))
    assert "it does so over the dwell from φ = 190° to 360°" in text(Assembler().written([cam]))


@pytest.mark.slow
def test_a_force_that_dips_within_a_dwell_keeps_no_value_in_it() -> None:
    """From 80° to 100° the follower rests at the top; between 86° and 88° nearly nothing presses on it."""
    force = '{ phi = ["0°", "86°", "87°", "88°", "180°"], force = [-120, -120, -1, -120, -120] }'
    change = f'cam.loads={{ mass = "1.2 kg", force_table = {force}, gravity = -9.81, friction = 0.1 }}'
    (cam,) = told("course-project", None, ONLY, [change])
    rows = next(each for each in cam.blocks if isinstance(each, Table) and each.key == "cam_extremes").rows
    (load,) = [row for row in rows if row[0].startswith("$P_c$")]
    assert "80–100" not in load


@pytest.mark.slow
def test_every_angular_velocity_of_the_cam_has_its_name() -> None:
    """That of a position, the given one, by which friction is reduced, and the mean of the time."""
    said = text(Assembler().written(told("course-project", None, ONLY)))
    assert "ω_n – given angular velocity of the cam" in said
    assert "ω_t – mean angular velocity of the cam over the time of a turn" in said
    assert "ω_m" not in said
    for label in (4, 17):
        first, even = re.findall(rf"pos\. {label}(?:, by [^:]*)?: R = .* = (\S+) N", said)
        friction = next(line for line in said.splitlines() if f"pos. {label}: M_cF" in line)
        assert first != even
        assert f"|{even[:5]}" in friction


@pytest.mark.slow
def test_two_sides_of_a_position_are_said_to_be_so() -> None:
    said = text(Assembler().written(told("course-project", None, ONLY)))
    assert "Rows 0 and 26 are one position" in said
    assert "Where the technological load jumps in a position (here 13)" in said
