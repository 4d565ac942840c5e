"""Every kind of fault that a student can write into the shaper: its place, its line, its words."""

from __future__ import annotations

import pytest
from faults import HOSTILE, Faults, check_lines

from tmmcalc.core.errors import Fault
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.project import parse_spec

ASSEMBLY = "\n[mechanism.assembly]\n"

# what is replaced, by what; then path, a fragment of the message and one of the remedy
TABLE_FAULTS = [
    (
        "mass = 12",
        'mass = "-12 kg"',
        "mechanism.links[3].mass",
        "'-12 kg' is negative; a mass is at least 0 (link 4)",
        "without the minus",
    ),
    (
        "inertia = 4.5",
        "inertia = -1",
        "mechanism.links[2].inertia",
        "-1 is negative; a moment of inertia is at least 0",
        "",
    ),
    (
        '"1020 mm"',
        '"5 kW"',
        "mechanism.links[2].points.C[0]",
        "'5 kW' is a power, a length is needed (link 3)",
        "200 mm",
    ),
    ("mass = 12", "mass = nan", "mechanism.links[3].mass", "nan is not a finite number", "55 kg"),
    ("mass = 12", "mass = [1]", "mechanism.links[3].mass", "[1] is not a mass", "55 kg"),
    (
        "positions = 24",
        "postions = 24",
        "mechanism.grid.postions",
        "unknown key 'postions'",
        'did you mean "positions"?',
    ),
    (
        'center = ["500 mm", 0]',
        'centre = ["500 mm", 0]',
        "mechanism.links[2].centre",
        "unknown key 'centre' in [[mechanism.links]]",
        'did you mean "center"?',
    ),
    (
        'gravity = "9.81 m/s^2"',
        "positions = 24",
        "mechanism.positions",
        "unknown key 'positions' in [mechanism]",
        "positions belongs in [mechanism.grid]",
    ),
    ('title = "Shaper"', "colour = 1", "project.colour", "unknown key 'colour'", "the keys here are: title"),
    ('title = "Shaper"', "title = 5", "project.title", "5 is not a text", "quotes"),
    (
        "positions = 24",
        'positions = "24"',
        "mechanism.grid.positions",
        "'24' is not a whole number",
        "write 24",
    ),
    (
        "positions = 24",
        "positions = 24.0",
        "mechanism.grid.positions",
        "24.0 is not a whole number",
        "write 24",
    ),
    ("positions = 24", "positions = true", "mechanism.grid.positions", "true is not a whole number", "whole"),
    ("positions = 24", "positions = 2", "mechanism.grid.positions", "2 is less than 4", "4 or more"),
    (
        "positions = 24",
        'extremes = "yes"',
        "mechanism.grid.extremes",
        "'yes' is neither true nor false",
        "true or false",
    ),
    (
        "positions = 24",
        "extra = 5",
        "mechanism.grid.extra",
        "5 is not a list of input coordinates",
        "extra = [",
    ),
    ("positions = 24", "span = 0", "mechanism.grid.span", "0 is zero", "30 deg"),
    ("positions = 24", 'span = "-30 deg"', "mechanism.grid.span", "'-30 deg' is negative", "without the minus"),
    ("positions = 24", "positions = 4_000_001", "mechanism.grid.positions", "more than 4000000", "or less"),
    ("positions = 24", "span = 90", "mechanism.grid.span", "90 without a unit is in radians", '"90 deg"'),
    ("positions = 24", "extra = [45.5]", "mechanism.grid.extra[0]", "45.5 without a unit is in radians", "45.5 deg"),
    ("positions = 24", 'span = "361 deg"', "mechanism.grid.span", "more than one turn", "360 deg"),
    ("positions = 24", 'extra = ["-1 deg"]', "mechanism.grid.extra[0]", "negative", "without the minus"),
    ("positions = 24", 'extra = [1, "370 deg"]', "mechanism.grid.extra[1]", "beyond the span of '360 deg'", "within"),
    (
        "positions = 24",
        'span = "90 deg"\nextra = ["91 deg"]',
        "mechanism.grid.extra[0]",
        "beyond the span of '90 deg'",
        "within",
    ),
    ('"55 rpm"', '"0 rpm"', "mechanism.input.speed", "'0 rpm' is zero", "55 rpm"),
    (
        'speed = "55 rpm"',
        "",
        "mechanism.input.speed",
        "missing key: the input needs its mean speed",
        "add speed",
    ),
    (
        'start = "extreme"',
        'start = "extrem"',
        "mechanism.input.start",
        "'extrem' is not an angle or a length",
        'did you mean "extreme"?',
    ),
    ('start = "extreme"', "start = true", "mechanism.input.start", "true is not an angle", 'or "extreme"'),
    ("id = 1", "id = 0", "mechanism.links[0].id", "0 is the frame", "[mechanism.fixed]"),
    ("id = 1\n", "", "mechanism.links[0].id", "missing key: every link needs its number", "add id"),
    ("id = 1", "id = -1", "mechanism.links[0].id", "-1 is less than 1", "1 or more"),
    (
        'O = [0, "620 mm"]',
        "O = [0, 1, 2]",
        "mechanism.fixed.O",
        "[0, 1, 2] has 3 values; a point is two coordinates",
        "[x, y]",
    ),
    ('O = [0, "620 mm"]', "O = []", "mechanism.fixed.O", "[] has no values", "[x, y]"),
    ('O = [0, "620 mm"]', "O = 1", "mechanism.fixed.O", "1 is not a point", "two coordinates"),
    (
        "points = { A = [0, 0] }",
        'points = ["A"]',
        "mechanism.links[1].points",
        "['A'] is not a table",
        "A = [x, y]",
    ),
    (
        "points = { A = [0, 0] }",
        'points = { A = [0, 0], "1A" = [0, 0] }',
        "mechanism.links[1].points.1A",
        "'1A' cannot name a point",
        "Latin letter",
    ),
    (
        'name = "A"\n',
        'name = "А"\n',
        "mechanism.joints[1].name",
        "it holds Cyrillic capital letter a",
        "Latin letter",
    ),
    ('name = "A"\n', "name = 1\n", "mechanism.joints[1].name", "1 is not a name", "in quotes"),
    ('name = "A"\n', "", "mechanism.joints[1].name", "missing key: every joint needs a name", "add name"),
    (
        'name = "C"\nkind = "revolute"',
        'name = "C"',
        "mechanism.joints[4].kind",
        "missing key: every joint needs a kind",
        "add kind",
    ),
    (
        'name = "C"\nkind = "revolute"',
        'name = "C"\nkind = "R"',
        "mechanism.joints[4].kind",
        "'R' is not a kind of joint",
        "prismatic",
    ),
    (
        "links = [4, 5]",
        "",
        "mechanism.joints[5].links",
        "missing key: every joint needs its two links",
        "links = [0, 1]",
    ),
    (
        "links = [4, 5]",
        "links = 4",
        "mechanism.joints[5].links",
        "4 is not two link numbers",
        "links = [0, 1]",
    ),
    (
        "links = [4, 5]",
        "links = [4, 5, 0]",
        "mechanism.joints[5].links",
        "has 3 values; a joint connects two links",
        "links = [0, 1]",
    ),
    ("links = [4, 5]", "links = [4, -5]", "mechanism.joints[5].links[1]", "-5 is less than 0", "0 or more"),
    (
        'guide = { through = "B", angle = "0 deg" }',
        'guide = "B"',
        "mechanism.joints[2].guide",
        "'B' is not a table",
        "guide = { through",
    ),
    (
        'guide = { through = "B", angle = "0 deg" }',
        "",
        "mechanism.joints[2].guide",
        "missing key: every prismatic joint",
        "second of links",
    ),
    (
        'guide = { through = "B", ',
        "guide = { ",
        "mechanism.joints[2].guide.through",
        "missing key: the line runs",
        "through",
    ),
    ('through = "B"', "through = [1]", "mechanism.joints[2].guide.through", "[1] has 1 value", "[x, y]"),
    (
        'through = "B"',
        "through = 1",
        "mechanism.joints[2].guide.through",
        "1 is not a point",
        "name of a point",
    ),
    (
        'name = "C"\nkind = "revolute"',
        'name = "C"\nkind = "revolute"\nguide = { through = "B" }',
        "mechanism.joints[4].guide",
        "a revolute joint has no guide",
        'kind = "prismatic"',
    ),
    (
        'guide = { through = "B"',
        'point = "A"\nguide = { through = "B"',
        "mechanism.joints[2].point",
        "a prismatic joint has no point",
        "its lines are",
    ),
    (
        "[[mechanism.outputs]]",
        "[mechanism.outputs]",
        "mechanism.outputs",
        "a single table, where a list",
        "two brackets",
    ),
    (
        'point = "D"\n',
        'point = "D"\nresistance = "left"\n',
        "mechanism.outputs[0].resistance",
        "'left' is not allowed here",
        '"positive" or "negative"',
    ),
    (
        'point = "D"\ndirection = "0 deg"',
        "link = 0",
        "mechanism.outputs[0].link",
        "link 0 is the frame",
        "moving link",
    ),
]

CROSS_FAULTS = [
    (
        "id = 5",
        "id = 4",
        "mechanism.links[4].id",
        "id 4 is already the number of another link (line 56)",
        "write id = 5",
    ),
    (
        'C = ["1020 mm", 0] }',
        'C = ["1020 mm", 0], S4 = [0, 0] }',
        "mechanism.links[2].points.S4",
        "'S4' is a reserved name",
        "center",
    ),
    ("B = [0, 0]\n", "B = [0, 0]\nS0 = [0, 0]\n", "mechanism.fixed.S0", "'S0' is a reserved name", "center"),
    ("mass = 12\n", "", "mechanism.links[3].inertia", "inertia without mass", "add mass"),
    (
        'D = ["290 mm", 0]',
        'D = ["0 mm", 0]',
        "mechanism.links[3].points",
        "the pins C and D of link 4 are at one place",
        "distance",
    ),
    (
        "points = { D = [0, 0] }",
        "points = { D = [0, 0], A = [1, 0] }",
        "mechanism.links[4].points.A",
        "'A' is a point of link 1 and of link 5",
        "links = [1, 5]",
    ),
    (
        'name = "C"\nkind',
        'point = "C"\nname = "A"\nkind',
        "mechanism.joints[4].name",
        "'A' is already the name of another joint (line 75)",
        "a name of its own",
    ),
    (
        "links = [4, 5]",
        "links = [4, 6]",
        "mechanism.joints[5].links[1]",
        'there is no link 6 (joint "D")',
        "0 (the frame), 1, 2",
    ),
    (
        "links = [4, 5]",
        "links = [4, 4]",
        "mechanism.joints[5].links",
        "[4, 4] is one link twice",
        "the links are",
    ),
    (
        'name = "C"\n',
        'name = "E"\n',
        "mechanism.joints[4].name",
        "neither link 3 nor link 4 has a point 'E'",
        'point = "C"',
    ),
    (
        "points = { C = [0, 0], D",
        "points = { C1 = [0, 0], D",
        "mechanism.joints[4].name",
        "link 4 has no point 'C'",
        'did you mean "C1"?',
    ),
    (
        'name = "C"\n',
        'name = "C"\npoint = "D"\n',
        "mechanism.joints[4].point",
        "link 3 has no point 'D'",
        "add D = [x, y] to the points of link 3",
    ),
    (
        'name = "C"\n',
        'name = "C"\npoints = ["C", "F"]\n',
        "mechanism.joints[4].points[1]",
        "link 4 has no point 'F'",
        "C, D, S4",
    ),
    (
        'name = "C"\n',
        'name = "C"\npoint = "C"\npoints = ["C", "C"]\n',
        "mechanism.joints[4].points",
        "point and points together",
        "keep point",
    ),
    ("B = [0, 0]\n", "", "mechanism.joints[3].name", "the frame has no point 'B'", "[mechanism.fixed]"),
    (
        "links = [2, 3] ",
        "links = [3, 2] ",
        "mechanism.joints[2].guide.through",
        "link 2, the guide of this joint, has no point 'B'",
        "links = [2, 3], slider first",
    ),
    (
        "links = [2, 3] ",
        'slider = { through = "Q" }\nlinks = [2, 3] ',
        "mechanism.joints[2].slider.through",
        "link 2, the slider of this joint, has no point 'Q'",
        "A",
    ),
    ('joint = "O" ', 'joint = "o" ', "mechanism.input.joint", "there is no joint 'o'", 'did you mean "O"?'),
    (
        'joint = "O" ',
        'joint = "C" ',
        "mechanism.input.joint",
        "joint 'C' is a pin of links 3 and 4, neither is the frame",
        "O, A3, B, D0",
    ),
    (
        '"55 rpm"',
        '"5 m/s"',
        "mechanism.input.speed",
        "'5 m/s' is a speed; the input joint \"O\" is revolute",
        "55 rpm",
    ),
    (
        '"55 rpm"',
        '"5 1/s"\nacceleration = "1 m/s^2"',
        "mechanism.input.acceleration",
        "is an acceleration",
        "rad/s^2",
    ),
    ('start = "extreme"', 'start = "1 mm"', "mechanism.input.start", "'1 mm' is a length", "30 deg"),
    ("positions = 24", 'span = "1 mm"', "mechanism.grid.span", "'1 mm' is a length", "30 deg"),
    ("positions = 24", 'extra = [0, "1 mm"]', "mechanism.grid.extra[1]", "'1 mm' is a length", "30 deg"),
    ("positions = 24", "working = 12", "mechanism.grid.working", "working without idle", "add idle"),
    ("positions = 24", "idle = 12", "mechanism.grid.idle", "idle without working", "add working"),
    (
        "positions = 24",
        "positions = 24\nworking = 9\nidle = 3",
        "mechanism.grid.positions",
        "positions together with working and idle",
        "remove positions",
    ),
    (
        "positions = 24",
        "span = 1\nworking = 9\nidle = 3",
        "mechanism.grid.span",
        "span together with working and idle",
        "remove span",
    ),
    (
        'point = "D"\n',
        'point = "F"\n',
        "mechanism.outputs[0].point",
        "there is no point 'F'",
        "the points are: A, B, C, D",
    ),
    (
        'point = "D"\n',
        'point = "S5"\n',
        "mechanism.outputs[0].point",
        "the centre of mass of a link needs its center",
        "S3",
    ),
    (
        'point = "D"\n',
        'point = "O"\n',
        "mechanism.outputs[0].point",
        "'O' is a point of the frame and does not move",
        "A, B",
    ),
    (
        'point = "D"\ndirection = "0 deg"',
        "link = 7",
        "mechanism.outputs[0].link",
        "there is no link 7",
        "1, 2, 3, 4, 5",
    ),
    (
        'point = "D"\ndirection = "0 deg"',
        'joint = "D"',
        "mechanism.outputs[0].joint",
        "joint 'D' is revolute; an output joint is prismatic",
        "A3, D0",
    ),
    (
        'point = "D"\ndirection = "0 deg"',
        'joint = "D1"',
        "mechanism.outputs[0].joint",
        "there is no joint 'D1'",
        "D0",
    ),
    (
        'point = "D"\ndirection = "0 deg"',
        'link = 3\ndirection = "0 deg"',
        "mechanism.outputs[0].direction",
        "a link has no direction",
        "remove",
    ),
    (
        'point = "D"\ndirection = "0 deg"',
        "",
        "mechanism.outputs[0]",
        "an output is a point, a link or a joint",
        "add point",
    ),
    (
        'point = "D"\n',
        'point = "D"\nlink = 3\n',
        "mechanism.outputs[0].link",
        "point and link together",
        "for each",
    ),
    (
        'point = "D"\n',
        'poin = "D"\n',
        "mechanism.outputs[0].poin",
        "unknown key 'poin' in [[mechanism.outputs]]",
        'did you mean "point"?',
    ),
    (
        'name = "C"\n',
        'name = "C"\nfriction = 0.1\n',
        "mechanism.joints[4].friction",
        "friction without radius: the moment of friction in a pin is f R r",
        "add radius",
    ),
    (
        'name = "C"\n',
        'name = "C"\nradius = "20 mm"\nfriction = 6\n',
        "mechanism.joints[4].friction",
        "6 is out of range; a coefficient of friction is at least 0 and at most 5",
        "0.1",
    ),
    (
        'name = "C"\n',
        'name = "C"\nradius = "-20 mm"\n',
        "mechanism.joints[4].radius",
        "'-20 mm' is negative; a length is at least 0",
        "without the minus",
    ),
    (
        'name = "C"\n',
        'name = "C"\nlength = "20 mm"\n',
        "mechanism.joints[4].length",
        "a revolute joint has no length",
        "radius",
    ),
    (
        'name = "D0"\n',
        'name = "D0"\nradius = "20 mm"\n',
        "mechanism.joints[6].radius",
        "a prismatic joint has no radius",
        "length",
    ),
    (
        'name = "D0"\n',
        'name = "D0"\nlength = 0\n',
        "mechanism.joints[6].length",
        "0 is zero; a length other than 0 is needed here",
        "200 mm",
    ),
]

ASSEMBLY_FAULTS = [
    (
        "sketch = { F = [0, 0] }",
        "mechanism.assembly.sketch.F",
        "there is no point 'F'",
        "the points are: A",
    ),
    ('at = "1 mm"', "mechanism.assembly.at", "'1 mm' is a length", "30 deg"),
    ('variants = { "2-3" = 2 }', "mechanism.assembly.variants.2-3", "2 is not a variant", "1 or -1"),
    ('variants = { "2-3" = true }', "mechanism.assembly.variants.2-3", "true is not a whole number", ""),
    ("variants = { a = 1 }", "mechanism.assembly.variants.a", "'a' names no group", '"2-3" = 1'),
    ('variants = { "4-6" = 1 }', "mechanism.assembly.variants.4-6", "there is no link 6", "1, 2, 3, 4, 5"),
    (
        'variants = { "0-1" = 1 }',
        "mechanism.assembly.variants.0-1",
        "the frame, link 0, belongs to no group",
        "1, 2",
    ),
    (
        'variants = { "2-4" = 1 }',
        "mechanism.assembly.variants.2-4",
        "links 2, 4 are not joined to each other",
        "of one group",
    ),
    ('variants = { "3-3" = 1 }', "mechanism.assembly.variants.3-3", "link 3 is named twice", "of one group"),
    (
        'variants = { "2-3-4-5" = 0 }',
        "mechanism.assembly.variants.2-3-4-5",
        "0 is not the number of an assembly",
        "structure --assemblies",
    ),
    (
        'variants = { "2-4-5" = 1 }',
        "mechanism.assembly.variants.2-4-5",
        "links 2, 4, 5 are not joined to each other",
        "of one group",
    ),
    (
        'variants = { "2-3" = 1, "3-2" = 1 }',
        "mechanism.assembly.variants.3-2",
        "the group of '2-3' again",
        "remove",
    ),
]


def only_fault(faults: list[Fault], path: str, fragment: str, remedy: str) -> Fault:
    assert [fault.path for fault in faults] == [path]
    assert fragment in faults[0].message
    assert remedy in faults[0].remedy
    return faults[0]


@pytest.mark.parametrize(("old", "new", "path", "fragment", "remedy"), TABLE_FAULTS + CROSS_FAULTS)
def test_one_slip_is_one_fault_at_its_line(
    shaper: str, faults_of: Faults, old: str, new: str, path: str, fragment: str, remedy: str
) -> None:
    assert old in shaper
    text = shaper.replace(old, new, 1)
    fault = only_fault(faults_of(text), path, fragment, remedy)
    key = path.replace("]", "").split(".")[-1].split("[")[0]
    line = text.splitlines()[(fault.line or 0) - 1]
    if "missing key" in fault.message:
        assert line.startswith(("[", "guide"))
    else:
        assert key in line


@pytest.mark.parametrize(("new", "path", "fragment", "remedy"), ASSEMBLY_FAULTS)
def test_faults_of_the_assembly(
    shaper: str, faults_of: Faults, new: str, path: str, fragment: str, remedy: str
) -> None:
    text = shaper + ASSEMBLY + new
    fault = only_fault(faults_of(text), path, fragment, remedy)
    assert fault.line == len(text.splitlines())


def test_a_prismatic_input_needs_span_and_start(shaper: str, faults_of: Faults) -> None:
    text = shaper.replace('joint = "O" ', 'joint = "D0" ', 1)
    found = {fault.path: fault.message for fault in faults_of(text)}
    assert found.keys() == {"mechanism.grid.span", "mechanism.input.speed", "mechanism.input.start"}
    assert 'the input joint "D0" is prismatic' in found["mechanism.grid.span"]
    mended = text.replace("positions = 24", 'span = "200 mm"\nextra = ["5 mm"]')
    mended = mended.replace('"55 rpm"', '"0.2 m/s"').replace('start = "extreme"', "start = 0.1")
    assert parse_spec(mended).mechanism.grid.span == 0.2
    strokes = mended.replace('span = "200 mm"', "working = 6\nidle = 6")
    assert {fault.path for fault in faults_of(strokes)} == {"mechanism.grid.working", "mechanism.grid.idle"}


def test_bare_degrees(shaper: str, faults_of: Faults) -> None:
    text = shaper.replace('start = "extreme"', "start = 30").replace('angle = "0 deg" }\n', "angle = 90 }\n", 1)
    found = {fault.path: fault for fault in faults_of(text)}
    assert found.keys() == {"mechanism.input.start", "mechanism.joints[6].guide.angle"}
    assert all("without a unit is in radians" in fault.message for fault in found.values())
    assert '"90 deg"' in found["mechanism.joints[6].guide.angle"].remedy


def test_the_working_stroke_begins_at_a_dead_centre(shaper: str, faults_of: Faults) -> None:
    text = shaper.replace("positions = 24", "working = 6\nidle = 4").replace('start = "extreme"', 'start = "15 deg"')
    only_fault(faults_of(text), "mechanism.input.start", "begins at a dead centre", 'start = "extreme"')


POLAR = 'points = { C = [0, 0], D = ["290 mm", 0] }'


@pytest.mark.parametrize(
    ("point", "fragment", "remedy"),
    [
        ('{ length = "290 mm" }', "is not a point", "[x, y]"),
        ('{ length = "290 mm", angel = 0 }', "is not a point", '{ length = "60 mm", angle = "30 deg" }'),
        ('{ length = "290 mm", angle = 30 }', "30 without a unit is in radians", "30 deg"),
        ('{ length = "290 N", angle = 0 }', "'290 N' is a force, a length is needed", "200 mm"),
    ],
)
def test_polar_points(shaper: str, faults_of: Faults, point: str, fragment: str, remedy: str) -> None:
    text = shaper.replace(POLAR, POLAR.replace('["290 mm", 0]', point))
    only_fault(faults_of(text), "mechanism.links[3].points.D", fragment, remedy)


def test_a_polar_point_is_the_same_point(shaper: str) -> None:
    polar = POLAR.replace('["290 mm", 0]', '{ length = "290 mm", angle = "90 deg" }')
    upright = POLAR.replace('["290 mm", 0]', '[0, "290 mm"]')
    same = [to_linkage(parse_spec(shaper.replace(POLAR, points)).mechanism) for points in (polar, upright)]
    assert same[0] == same[1]


def test_two_outputs_of_one_name(shaper: str, faults_of: Faults) -> None:
    second = '\n[[mechanism.outputs]]\npoint = "D"\ndirection = "90 deg"\n'
    only_fault(faults_of(shaper + second), "mechanism.outputs[1]", "a second output is called 'D'", 'name = "Dy"')
    named = second.replace('point = "D"', 'name = "Dy"\npoint = "D"')
    assert [o.name for o in to_linkage(parse_spec(shaper + named).mechanism).outputs] == ["D", "Dy"]


def test_a_link_that_no_joint_names(shaper: str, faults_of: Faults) -> None:
    text = shaper + "\n[[mechanism.links]]\nid = 6\npoints = { A = [0, 0] }\n"
    only_fault(faults_of(text), "mechanism.links[5]", "no joint names link 6", "remove the link")


def test_a_mechanism_without_frame(faults_of: Faults) -> None:
    text = """
    [mechanism]
    input = { joint = "A", speed = 1 }
    links = [{ id = 1, points = { A = [0, 0] } }, { id = 2, points = { A = [0, 0] } }]
    joints = [{ name = "A", kind = "revolute", links = [1, 2] }]
    """
    messages = [fault.message for fault in faults_of(text)]
    assert any("no joint names the frame" in message for message in messages)


def test_a_misspelt_array_is_not_missing_as_well(shaper: str, faults_of: Faults) -> None:
    text = shaper.replace("[[mechanism.links]]", "[[mechanism.link]]")
    only_fault(faults_of(text), "mechanism.link", "unknown key 'link' in [mechanism]", 'did you mean "links"?')


def test_one_pin_of_three_links_is_one_point(shaper: str) -> None:
    text = shaper.replace("points = { D = [0, 0] }", "points = { C = [0, 0] }").replace(
        "links = [4, 5]", "links = [3, 5]"
    )
    text = text.replace('name = "D"\nkind = "revolute"', 'name = "C2"\nkind = "revolute"\npoint = "C"')
    assert len(parse_spec(text).mechanism.joints) == 7


def test_pins_of_other_names(shaper: str) -> None:
    text = shaper.replace("points = { C = [0, 0], D", "points = { C4 = [0, 0], D").replace(
        'name = "C"\n', 'name = "C"\npoints = ["C", "C4"]\n'
    )
    assert parse_spec(text).mechanism.links[3].points.keys() == {"C4", "D"}


def test_ten_faults_come_together_in_the_order_of_lines(shaper: str, faults_of: Faults) -> None:
    slips = [
        ('title = "Shaper"', 'titel = "Shaper"'),
        ("positions = 24", "positions = 3"),
        ('"55 rpm"', '"55 kg"'),
        ('point = "D"\n', 'point = "Q"\n'),
        ('O = [0, "620 mm"]', 'O = [0, "620 m m"]'),
        ('"200 mm"', '"200"'),
        ("mass = 55", "mass = -55"),
        ("mass = 12\n", ""),
        ('name = "C"\n', 'name = "E"\n'),
        ('guide = { through = [0, "1000 mm"]', 'guide = { thru = [0, "1000 mm"]'),
    ]
    for old, new in slips:
        assert old in shaper
        shaper = shaper.replace(old, new, 1)
    faults = faults_of(shaper)
    assert [fault.path for fault in faults] == [
        "project.titel",
        "mechanism.grid.positions",
        "mechanism.input.speed",
        "mechanism.outputs[0].point",
        "mechanism.fixed.O[1]",
        "mechanism.links[0].points.A[0]",
        "mechanism.links[2].mass",
        "mechanism.links[3].inertia",
        "mechanism.joints[4].name",
        "mechanism.joints[6].guide.thru",
    ]
    lines = [fault.line or 0 for fault in faults]
    assert lines == sorted(lines)
    assert min(lines) > 0


@pytest.mark.parametrize(
    ("old", "new", "line", "fragment", "remedy"),
    [
        ("mass = 55", "mass = 55 kg", 51, "expected newline", '"55 kg"'),
        ('"55 rpm"', "55 rpm", 26, "not valid TOML", '"55 rpm"'),
        ("mass = 55", "mass = 55,5", 51, "not valid TOML", "55.5"),
        ("mass = 55", "mass = .5", 51, "not valid TOML", "0.5"),
        ("mass = 55", "mass = 5.", 51, "not valid TOML", "5.0"),
        ("mass = 55", "mass: 55", 51, "expected '='", "mass = ..."),
        ("mass = 55", "mass = 55\nmass = 5", 52, "overwrite", "each key stands once"),
        ("[[mechanism.links]]", "[mechanism.links]", 42, "overwrite", "two brackets"),
        ('"Shaper"', "“Shaper”", 16, "invalid value", "quotes are the plain ones"),
        ('"55 rpm"', '"55 rpm', 26, "illegal character", "close the quotes"),
        ("B = [0, 0]\n", "B' = [0, 0]\n", 35, "expected '='", '"B\'" = [0, 0]'),
        ("positions = 24", "extremes = True", 22, "invalid value", "true or false"),
        ('kind = "revolute"', "kind = revolute", 71, "invalid value", '"revolute"'),
        ("links = [4, 5]", "links = [4, 5", 100, "unclosed array", "close the list"),
    ],
)
def test_syntax_fault_has_line_and_remedy(
    shaper: str, faults_of: Faults, old: str, new: str, line: int, fragment: str, remedy: str
) -> None:
    assert old in shaper
    (fault,) = faults_of(shaper.replace(old, new, 1))
    assert fault.line == line
    assert fault.column is not None
    assert fragment in fault.message
    assert remedy in fault.remedy


@pytest.mark.parametrize("text", ["", "# nothing\n", "mechanism = 1\n", "mechanism = []\n", "[mechanism]\n"])
def test_hardly_anything(faults_of: Faults, text: str) -> None:
    assert faults_of(text)


KEYS = ["gravity", "grid", "input", "outputs", "fixed", "links", "joints", "assembly"]


@pytest.mark.parametrize("key", KEYS)
def test_no_value_breaks_the_checks(faults_of: Faults, key: str) -> None:
    for value in HOSTILE:
        assert faults_of(f"[mechanism]\n{key} = {value}\n")


NESTED = {
    "links": ["id", "points", "mass", "center", "name"],
    "joints": ["name", "kind", "links", "point", "points", "guide", "slider", "friction", "radius", "length"],
    "outputs": ["point", "link", "joint", "direction", "resistance"],
}


@pytest.mark.parametrize(("array", "key"), [(array, key) for array, keys in NESTED.items() for key in keys])
def test_no_value_in_an_array_breaks_the_checks(shaper: str, array: str, key: str) -> None:
    kind = "prismatic" if key in ("guide", "slider") else "revolute"
    more = f'kind = "{kind}"\n' if array == "joints" and key != "kind" else ""
    for value in HOSTILE:
        check_lines(f"{shaper}\n[[mechanism.{array}]]\n{key} = {value}\n{more}")
