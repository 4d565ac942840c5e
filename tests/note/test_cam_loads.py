"""The note on the loaded cam: forces, requirements, best sizes, vibration, indexing drives; every variant of them.

Numbers are those of the textbook's worked cases, of the paper on cam-lantern drives, or of other formulas.
"""

from __future__ import annotations

import math
import re
from functools import cache
from pathlib import Path

import pytest

from note.test_lines import mutants, wrong
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.note.tree import Equation, Written
from tmmcalc.pipeline.chapters import chapters_of, stages_of
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Chapter, Line

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


def told_of(kind: str, folder: Path) -> list[Chapter]:
    """The chapters of a kind in the language in force."""
    spec = folder / "spec.toml"
    spec.write_text(HEAD + KINDS[kind], encoding="utf-8")
    done = run(load_spec(spec), target=stages_of(ONLY))
    return chapters_of({"cams": "Cams"}, done.spec, done.results, NONE)


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_exact_and_works_out_as_printed(kind: str, tmp_path: Path) -> None:
    found = Assembler()
    note = found.written(told_of(kind, tmp_path))
    assert len(found.lines) > 10
    for line in found.lines:
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)
    assert "nan" not in text(note)
