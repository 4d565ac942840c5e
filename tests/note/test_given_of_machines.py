"""The given data of machines, gears and cams: all that a variant is solved by, told in numbers of its own."""

from __future__ import annotations

import re
from functools import cache

import pytest

from note.given import ambiguous, data_of
from note.scenes import CONFIGS, SPECS
from tmmcalc.note.task import row_of
from tmmcalc.pipeline.chapters import task_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Datum

NUMBERS = [  # what the spec writes, with its own number
    ("elastic-drive", "stiffness of shaft “crank shaft”", "24000 N·m/rad"),
    ("elastic-drive", "damping of shaft “motor shaft”", "0.15 N·m·s/rad"),
    ("elastic-drive", "speed before shaft “crank shaft” over the speed behind it and its gear", "5.56"),
    ("elastic-drive", "moment of inertia of the mass behind shaft “motor shaft”", "0.004 kg·m²"),
    ("elastic-drive", "starting moment of the motor over the rated one", "2"),
    ("elastic-drive", "motion “start-up”: speed of the input link above which change 1 comes", "48 rpm"),
    ("elastic-drive", "motion “emergency stop”: moment of the brake, against the motion", "60 N·m"),
    ("electric-braking", "motion “plugging”: resistance added to the armature circuit", "2.8 Ohm"),
    ("electric-braking", "motion “regenerative”: voltage that the armature is connected to", "110 V"),
    ("electric-braking", "moment on the shaft “friction”; one that resists is negative", "−60 N·m, over the angle"),
    ("reduced-machine", "speed ratio of the motor and the input shaft", "3.03125"),
    ("reduced-machine", "moment between the points", "straight lines"),
    ("series-braking", "mean speed of the shaft", "that which the motor gives it"),
    ("press", "highest allowed speed of the rim", "30 m/s"),
    ("rotor", "unbalanced masses", "0.024; 0.031; 0.018 kg"),
    ("rotor", "their angles in axes that turn with the rotor", "30°; 205°; −80°"),
    ("in-line-engine", "length of the connecting rod", "0.145 m"),
    ("in-line-engine", "places of the cylinders along the shaft", "0; 0.096; 0.192; 0.288 m"),
    ("gears-coaxial", "admitted deviation of the ratio", "0.08"),
    ("gears-coaxial", "proportions of the modules of stages 1 and 2", "2:3"),
    ("gears-coaxial", "largest moment on the output shaft of the train, whose losses are not counted", "180 N·m"),
    ("gears-unfolded", "largest relative difference of the diameters of the wheels", "3 %"),
    ("gears-unfolded", "place of the wheels between their bearings, row of table D.4.1", "3; 5"),
    ("gears-kinematic", "largest operating pressure angle", "22°"),
    ("gears-single-planets", "weight of the criterion “inertia”", "2"),
    ("gears-single-planets", "material of the wheels", "40Kh, improved, 300 HB"),
    ("gears-ravigneaux", "torque of the most loaded of the links long over the mean", "1.1"),
    ("pair-spur", "numbers of teeth in the spans", "3; 4"),
    ("geared-press", "open pair: number of teeth of wheel b", "60"),
    ("geared-press", "open pair: efficiency", "0.96"),
    ("cam-flat", "permissible shear stress of the wire", "600 MPa"),
    ("cam-flat", "length by which the face is longer than the contact needs, on both sides", "2 mm"),
    ("cam-own-law", "law of the return: displacements there, in parts of the stroke", "0; 0.1; 0.5; 0.9; 1"),
    ("cam-translating", "safety factor of the closure of the pair", "1.5"),
    ("cam-translating", "modulus of elasticity of the camshaft", "200000 MPa"),  # of a usual value that counts
    ("course-project", "angle of the input shaft from position 0 at which the rise begins", "230°"),
    ("course-project", "deflection of the spring in the lowest position", "25 mm"),
    ("course-project", "schemes of balancing", "least squares, Lanchester's pair"),
]
CHANGES = [  # numbers and words that make another solution
    ("electric-braking", "transmission.inertia=1.6"),
    ("electric-braking", "transients[1].duration='5 s'"),
    ("electric-braking", "transients[2].braking.kind='plugging'"),
    ("electric-braking", "torque.formula='-61'"),
    ("electric-braking", "torque.balanced=true"),
    ("series-braking", "motor.field_resistance='0.31 ohm'"),
    ("series-braking", "transients[2].braking.field=0.9"),
    ("reduced-machine", "torque.reduced_inertia.interpolation='linear'"),
    ("reduced-machine", "torque.inertia=0.2"),
    ("reduced-machine", "transients[0].start_angle='10 deg'"),
    ("rotor", "rotor.unbalances[1].mass='32 g'"),
    ("rotor", "rotor.unbalances[2].position='450 mm'"),
    ("rotor", "rotor.static_plane='300 mm'"),
    ("in-line-engine", "engine.spacing='97 mm'"),
    ("in-line-engine", "engine.rotating_mass='0.49 kg'"),
    ("in-line-engine", "engine.offset='4 mm'"),
    ("in-line-engine", "engine.firing_order=[1, 2, 4, 3]"),
    ("pair-blocking", "pair.meshes[0].strategy='max_contact_ratio'"),
    ("pair-spur", "pair.tip_thickness_min=0.3"),
    ("pair-spur", "pair.measure_over='pins'"),
    ("pair-spur", "pair.undercut='tolerated'"),
    ("gears-double-planets", "train.method='textbook'"),
    ("gears-radial-planets", "train.constraints.adjacency_gap=2"),
    ("gears-coaxial", "strength.on_overload='scale'"),
    ("gears-coaxial", "strength.modules_row=2"),
    ("gears-coaxial", "strength.material.load='two-sided'"),
    ("gears-coaxial", "criteria.choose='mass'"),
    ("gears-coaxial", "criteria.external_efficiency=0.98"),
    ("gears-coaxial", "train.constraints.coprime=true"),
    ("wheel", "wheel.circles=['137 mm', '144 mm']"),
    ("cam-flat", "cam.spring.dead_coils=3"),
    ("cam-translating", "cam.spring.exact=true"),
    ("cam-flat", "cam.rotation='counter-clockwise'"),
    ("cam-own-law", "cam.return_law.points[1][1]=0.11"),
    ("cam-own-law", "cam.limits.allow_concave=false"),
    ("cam-lantern", "indexing.steps=21"),
    ("cam-lantern", "indexing.law='sine'"),
]
QUICK = {
    "electric-braking",
    "rotor",
    "in-line-engine",
    "gears-kinematic",
    "pair-spur",
    "cam-own-law",
    "cam-flat",
    "wheel",
}
SEVERAL = re.compile(r"^(motion|pair|open pair)[^:]*: |: .*$|“.*?”")  # of what a quantity is, where several have it
TEACHING = [name for name in SPECS if not name.startswith(("extra", "synth", "best", "manipulator", "rules", "feasib"))]


@cache
def told(name: str, *changed: str) -> dict[str, tuple[str, str]]:
    """Designation and value of what is given, by what it is."""
    done = run(load_spec(CONFIGS / f"{name}.toml", changed))
    rows = [row_of(each) for each in task_of(done.spec, done.results) if isinstance(each, Datum)]
    return {what: (keys.replace("$", ""), value.replace("$", "").replace("-", "−")) for what, keys, value in rows}


def marked(cases: list[tuple[str, ...]]) -> list[object]:
    """The cases of quick scenes as they are, the others as slow."""
    return [pytest.param(*each, marks=() if each[0] in QUICK else pytest.mark.slow) for each in cases]


@pytest.mark.parametrize(("name", "what", "value"), marked(NUMBERS))
def test_what_a_spec_writes_is_told_with_its_number(name: str, what: str, value: str) -> None:
    assert told(name)[what][1].startswith(value)


@pytest.mark.parametrize(("name", "change"), marked(CHANGES))
def test_what_makes_another_solution_makes_another_table(name: str, change: str) -> None:
    """As a student would find it: another number, another word."""
    assert told(name) != told(name, change)


@pytest.mark.parametrize("name", marked([(name,) for name in TEACHING]))
def test_one_letter_is_one_thing(name: str) -> None:
    """Of several motions, pairs, joints and loads each has its own value of one thing; gravity is one for all.

    So is what is counted along the motion; a long list of values has several rows.
    """
    done = run(load_spec(CONFIGS / f"{name}.toml"))
    found = ambiguous(data_of(task_of(done.spec, done.results)), lambda what: SEVERAL.sub("", what))
    assert {key: things for key, things in found.items() if key != "g"} == {}


@pytest.mark.slow
def test_the_overload_and_the_planets_have_letters_of_their_own() -> None:
    found = told("geared-press")
    assert found["overload factor of the motor"][0] == "lambda_M"
    assert found["number of planets"][0] == "K"


@pytest.mark.parametrize("name", ["electric-braking", "rotor", "in-line-engine", "gears-kinematic", "cam-flat"])
def test_the_table_is_told_in_ukrainian_row_by_row(name: str) -> None:
    """No text of the program is left in English: what the spec names stands in quotes."""
    done = run(load_spec(CONFIGS / f"{name}.toml"))
    with speaking("uk"):
        rows = [row_of(each) for each in task_of(done.spec, done.results) if isinstance(each, Datum)]
    assert len(rows) == len(told(name))
    for what, _, value in rows:
        plain = re.sub(r"\$.*?\$|«.*?»|\S+\.csv", "", f"{what} {value}")
        assert not re.search(r"[a-z]{3}", plain), plain
