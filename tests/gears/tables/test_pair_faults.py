"""Every kind of fault in [pair]: its place, its words, what to write instead."""

from __future__ import annotations

import math
from typing import get_args

import pytest
from faults import HOSTILE, Faults, check_fault

from tmmcalc.core.errors import Fault, SpecError
from tmmcalc.gears.involute.internal.shifts import INTERNAL_STRATEGIES
from tmmcalc.gears.involute.strategies import STRATEGIES as CHOICES
from tmmcalc.gears.involute.strategies import Split
from tmmcalc.gears.tables.shifting import OF_KIND, SPLITS, STRATEGIES
from tmmcalc.project import parse_spec

PAIR = '[pair]\nteeth = [14, 17]\nmodule = "5 mm"\n'
RING = '[pair]\nkind = "internal"\nteeth = [18, 57]\nmodule = "5 mm"\n'
RACK = '[pair]\nkind = "rack"\nteeth = [14]\nmodule = "5 mm"\n'
STEEL = 'material = { steel = "40Kh", treatment = "improved", hardness = "300 HB" }\n'
STRENGTH = f'[strength]\ntorque = "75 N*m"\n{STEEL}'
TEETH = '[train]\nlayout = "AI"\nratio = "31.29"\n'
TRAIN = f"{TEETH}{STRENGTH}[pair]\n"
FREE = TRAIN.replace("AI", "unfolded2").replace("31.29", "8.15")
RINGS = TRAIN.replace('"AI"\nratio = "31.29"', '"II"\nratio = -30')
ENTRY = "[[pair.meshes]]\n"


def entries(*each: str) -> str:
    return "".join(f"{ENTRY}{lines}\n" for lines in each)


# the whole spec; then the path of its one fault, a piece of its message and of its remedy
FAULTS = [
    # what is missing
    ('[pair]\nmodule = "5 mm"\n', "pair", "missing key: a pair of gears has its numbers of teeth", "teeth = [14, 17]"),
    ("[pair]\nteeth = [14, 17]\n", "pair", "missing key: a pair of gears has its module", 'module = "5 mm"'),
    (
        "[pair]\nteeth = [14, 17]\n" + entries("module = 0.005", "x1 = 1 \nx2 = 0"),
        "pair.meshes[1]",
        "missing key: a pair of gears has its module",
        'module = "5 mm"',
    ),
    (f"{RING}cutter = {{ shift = 1 }}\n", "pair.cutter.teeth", "a cutter has its number of teeth", "teeth = 20"),
    # teeth
    (PAIR.replace("[14, 17]", "14"), "pair.teeth", "14 is not a list of one value or two", "[14, 17]"),
    (PAIR.replace("[14, 17]", "[14, 17, 19]"), "pair.teeth", "not a list of one value or two", "[14, 17]"),
    (PAIR.replace("14,", "2,"), "pair.teeth", "2 is out of range; a number of teeth is between 3 and 10000", "between"),
    (PAIR.replace("17]", "17.5]"), "pair.teeth", "17.5 is not a number of teeth", "whole number"),
    (PAIR.replace("14, ", ""), "pair.teeth", "[17] has 1 value; two external wheels", 'kind = "rack"'),
    (RACK.replace("14", "14, 17"), "pair.teeth", "a rack has no number of teeth", "teeth = [14]"),
    (RING.replace("57", "18"), "pair.teeth", "a pinion of 18 teeth does not fit into a ring of 18", "pinion first"),
    (
        f"{RING}cutter = {{ teeth = 60 }}\n",
        "pair.cutter.teeth",
        "a cutter of 60 teeth does not fit into a ring of 57",
        "smaller cutter",
    ),
    (f'{PAIR}kind = "ring"\n', "pair.kind", "'ring' is no kind of pair", "external, internal, rack"),
    # sizes
    (PAIR.replace('"5 mm"', "5"), "pair.module", "5 without a unit is in m", 'write "5 mm"'),
    (PAIR.replace("5 mm", "0 mm"), "pair.module", "it is between 0.001 and 1000 mm", "between them"),
    (PAIR.replace("5 mm", "-5 mm"), "pair.module", "it is between 0.001 and 1000 mm", "between them"),
    (PAIR.replace("5 mm", "5 deg"), "pair.module", "'5 deg' is an angle", "mm"),
    (f"{PAIR}centre_distance = 85\n", "pair.centre_distance", "85 without a unit is in m", '"85 mm" or "85 m"'),
    (f'{PAIR}face_width = "1e9 mm"\n', "pair.face_width", "out of range", "between them"),
    (f"{PAIR}helix_angle = 15\n", "pair.helix_angle", "15 without a unit is in radians", '"15 deg"'),
    (f'{PAIR}helix_angle = "61 deg"\n', "pair.helix_angle", "between -60 and 60 deg", "between them"),
    (f'{PAIR}pressure_angle = "8 deg"\n', "pair.pressure_angle", "between 10 and 35 deg", "between them"),
    (f"{PAIR}x1 = 6\nx2 = 0\n", "pair.x1", "a shift in modules is at least -5 and at most 5", "0.5"),
    (f'{PAIR}x1 = "2 mm"\nx2 = 0\n', "pair.x1", "is not a shift in modules", "no unit"),
    (f"{PAIR}sliding_max = 0\n", "pair.sliding_max", "a specific sliding is above 0", "such as 3"),
    (f"{PAIR}points = 1\n", "pair.points", "a number of points is between 2 and 10000", "between"),
    (f'{PAIR}refuse = "no"\n', "pair.refuse", "neither true nor false", "without quotes"),
    (f'{PAIR}name = "1/2"\n', "pair.name", "cannot name a pair", "words of Latin letters"),
    # words
    (f'{PAIR}rack = "GOST"\n', "pair.rack", "'GOST' is no basic rack", "GOST 13755"),
    (f'{PAIR}strategy = "equal"\n', "pair.strategy", "'equal' is no way to choose", "equal_sliding"),
    (
        f'{PAIR}centre_distance = "85 mm"\nsplit = "midle"\n',
        "pair.split",
        "'midle' is no way to split",
        'did you mean "middle"?',
    ),
    (f'{PAIR}undercut = "slight"\n', "pair.undercut", "is no rule for undercut", "none, tolerated"),
    (f'{PAIR}fillet = "arc"\n', "pair.fillet", "is no section of the fillet", "ellipse, circle"),
    (f'{PAIR}measure_over = "wires"\n', "pair.measure_over", "no body to measure over", "balls, pins"),
    (f'{PAIR}face_width_rule = "iso"\n', "pair.face_width_rule", "no rule of the face width", "book, exact"),
    (f"{PAIR}teath = [1, 2]\n", "pair.teath", "unknown key 'teath' in [pair]", 'did you mean "teeth"?'),
    (PAIR + entries("refuse = false"), "pair.meshes[0].refuse", "unknown key", "refuse belongs in [pair]"),
    # shifts
    (f"{PAIR}x1 = 0.3\n", "pair.x1", "x1 without x2", "add x2, or centre_distance"),
    (f"{PAIR}x2 = 0.3\n", "pair.x2", "x2 without x1", "add x1, or centre_distance"),
    (f"{RING}x1 = 0.3\n", "pair.x1", "x1 without x2", "add x2, or centre_distance"),
    (
        f'{PAIR}x1 = 0.3\nx2 = 0\ncentre_distance = "85 mm"\n',
        "pair.centre_distance",
        "two of the three give the third",
        "remove one",
    ),
    (f'{PAIR}strategy = "given"\n', "pair.strategy", '"given" without x1 and x2', "add x1 = 0.5, x2 = 0.5"),
    (f'{PAIR}strategy = "given"\nx1 = 0\n', "pair.strategy", '"given" without x2', "add x2 = 0.5"),
    (f'{RACK}strategy = "given"\n', "pair.strategy", '"given" without x1', "add x1 = 0.5"),
    (
        f'{PAIR}strategy = "given"\ncentre_distance = "85 mm"\n',
        "pair.strategy",
        "together with centre_distance",
        '"given_aw"',
    ),
    (f'{PAIR}strategy = "given_aw"\n', "pair.strategy", '"given_aw" without centre_distance', '"85 mm"'),
    (
        f'{PAIR}strategy = "given_aw"\nx1 = 0\nx2 = 1\n',
        "pair.x2",
        "the centre distance gives their sum",
        'strategy = "given"',
    ),
    (f'{PAIR}strategy = "zero"\nx1 = 0.1\n', "pair.x1", 'x1 together with strategy = "zero"', "remove one"),
    (
        f'{PAIR}strategy = "balanced"\ncentre_distance = "85 mm"\n',
        "pair.centre_distance",
        "from which it follows",
        '"given_aw"',
    ),
    (f'{PAIR}strategy = "equal_shift"\nx1 = 0.1\nx2 = 0.1\n', "pair.x2", "it is -x1", "remove it"),
    (
        f'{RING}strategy = "equal_strength"\n',
        "pair.strategy",
        "a pinion in a ring cannot have",
        '"given", "given_aw", "zero", "equal_shift"',
    ),
    (f'{RACK}strategy = "equal_shift"\n', "pair.strategy", "a pinion on a rack cannot have", '"given", "zero"'),
    (
        f"{PAIR}strategy = 'max_contact_ratio'\n" + entries('name = "a"', 'kind = "internal"\nteeth = [14, 50]'),
        "pair.strategy",
        "a pinion in a ring cannot have",
        '"zero"',
    ),
    # keys of no use
    (f'{PAIR}split = "middle"\n', "pair.split", "nothing is left to be split", "equal_shift"),
    (
        f'{PAIR}centre_distance = "85 mm"\nx1 = 0.5\nsplit = "middle"\n',
        "pair.split",
        "nothing is left to be split",
        "without x1 and x2",
    ),
    (f"{PAIR}desired_contact_ratio = 1.3\n", "pair.desired_contact_ratio", "not chosen for it", "equal_sliding"),
    (f"{PAIR}cutter = {{ teeth = 20 }}\n", "pair.cutter", "it cuts a ring, and there is none", "internal"),
    (f"{RACK}x1 = 0.1\nx2 = 0.1\n", "pair.x2", "a rack has no shift", "remove it"),
    (f'{RACK}centre_distance = "40 mm"\n', "pair.centre_distance", "a rack has no centre", "x1 sets"),
    (
        PAIR + entries('name = "a"', 'name = "b"\ndesired_contact_ratio = 1.1'),
        "pair.meshes[1].desired_contact_ratio",
        "not chosen for it",
        "equal_sliding",
    ),
    # counts
    (f'{PAIR}tip_diameters = ["80 mm"]\n', "pair.tip_diameters", "has 1 value, two external wheels need 2", "one for"),
    (f"{RACK}ball_diameters = [0.008, 0.008]\n", "pair.ball_diameters", "has 2 values", "that of the pinion"),
    (f"{RING}span_teeth = [3, 5]\n", "pair.span_teeth", "has 2 values, a pinion in a ring need 1", "of the pinion"),
    (f"{PAIR}span_teeth = [0, 5]\n", "pair.span_teeth", "0 is out of range", "between"),
    (f"{PAIR}tip_diameters = [86.8, 0.1]\n", "pair.tip_diameters", "86.8 without a unit is in m", '"86.8 mm"'),
    # limits
    (f"{PAIR}contact_ratio_wanted = 0.9\n", "pair.contact_ratio_wanted", "below contact_ratio_min = 1", "1 or more"),
    (
        f"{PAIR}tip_thickness_min = 0.4\ntip_thickness_wanted = 0.3\n",
        "pair.tip_thickness_wanted",
        "0.3 is below tip_thickness_min = 0.4",
        "0.4 or more",
    ),
    (
        f'{PAIR}strategy = "equal_sliding"\ncontact_ratio_min = 1.3\ndesired_contact_ratio = 1.2\n',
        "pair.desired_contact_ratio",
        "1.2 is below contact_ratio_min = 1.3",
        "lower contact_ratio_min",
    ),
    (f'{PAIR}angle_range = ["30 deg", "15 deg"]\n', "pair.angle_range", "runs backwards", "smaller angle first"),
    (f'{PAIR}angle_range = ["30 deg"]\n', "pair.angle_range", "not a list of 2 values", '["15 deg", "30 deg"]'),
    # tools
    (
        f"{PAIR}addendum = 1.95\n",
        "pair.addendum",
        "no tool has this rack: the tip is wider",
        "addendum of at most 1.9078",
    ),
    (f'{PAIR}pressure_angle = "33 deg"\n', "pair.pressure_angle", "no tool has this rack", "angle of at most 32.14"),
    (
        f'{PAIR}pressure_angle = "33 deg"\nhelix_angle = "45 deg"\n',
        "pair.pressure_angle",
        "wider than the tooth of the rack by",
        "clearance of at most",
    ),
    (
        PAIR + entries("tip_radius = 0.9"),
        "pair.meshes[0].tip_radius",
        "no tool has this rack",
        "radius of at most 0.47",
    ),
    # several pairs
    (f'{PAIR}name = "a"\n' + entries("x1 = 0.1\nx2 = 0.1"), "pair.name", "each of them is a pair", "[[pair.meshes]]"),
    (PAIR + entries('name = "a"', 'name = "a"'), "pair.meshes[1].name", "the name of two pairs", "rename"),
    (PAIR + entries('mesh = "1-2"'), "pair.meshes[0].mesh", "names a mesh of the train", "remove it"),
    ("[pair]\n" + entries('mesh = "1-2"'), "pair.meshes[0].mesh", "there is no [train]", "add [train]"),
    (f"{TRAIN}teeth = [14, 17]\nmodule = 0.005\n" + entries('mesh = "1-2"'), "pair.meshes[0].mesh", "teeth are", "add"),
    (f"{PAIR}meshes = 3\n", "pair.meshes", "where a list of tables is needed", "[[pair.meshes]]"),
    # a train
    (f"{TEETH}[pair]\n", "pair", "[pair] without [strength]: the pairs of a train have the modules", "add [strength]"),
    (f'{TRAIN}module = "5 mm"\n', "pair.module", "strength gives the modules", "remove it"),
    (f'{TRAIN}kind = "internal"\n', "pair.kind", "which wheels are rings", "remove it"),
    (f'{TRAIN}name = "a"\n', "pair.name", "called by their meshes", "remove it"),
    (
        TRAIN + entries('mesh = "1-2"\nteeth = [20, 40]'),
        "pair.meshes[0].teeth",
        "the train gives the numbers of teeth",
        "remove it",
    ),
    (f"{TRAIN}x1 = 0.3\n", "pair.x1", "that of one mesh", '[[pair.meshes]] with mesh = "1-2"'),
    (f"{TRAIN}span_teeth = [3, 5]\n", "pair.span_teeth", "that of one mesh", "[[pair.meshes]]"),
    (f'{FREE}centre_distance = "85 mm"\n', "pair.centre_distance", "unfolded2 has no common centre", "mesh = "),
    (
        f"{TRAIN}cutter = {{ teeth = 25, tip_diameter = 0.08 }}\n",
        "pair.cutter.tip_diameter",
        "modules are not known yet",
        "remove it",
    ),
    (f"{FREE}cutter = {{ teeth = 25 }}\n", "pair.cutter", "it cuts a ring, and there is none", "remove it"),
    (TRAIN + entries("x1 = 0.3"), "pair.meshes[0]", "missing key: an entry says which mesh", 'mesh = "1-2"'),
    (TRAIN + entries('mesh = "2-3"'), "pair.meshes[0].mesh", "no mesh '2-3'", 'did you mean "2\'-3"?'),
    (TRAIN + entries('mesh = "1-9"'), "pair.meshes[0].mesh", "no mesh '1-9'", "meshes: 1-2, 2'-3"),
    (TRAIN + entries("mesh = 3"), "pair.meshes[0].mesh", "not a text", "in quotes"),
    (TRAIN + entries('mesh = "1-2"', 'mesh = "1-2"'), "pair.meshes[1].mesh", "an entry already", "in one"),
    (
        f"{TRAIN.replace('AI', 'coaxial').replace('31.29', '9')}" + entries('mesh = "2\'-3"\nstrategy = "balanced"'),
        "pair.meshes[0].strategy",
        '"balanced" would choose another centre distance',
        "in the mesh 1-2",
    ),
    (
        f'{TRAIN.replace("AI", "2A-AA").replace("31.29", "5")}strategy = "balanced"\n',
        "pair.strategy",
        '"balanced" would choose another centre distance',
        'strategy = "given_aw"',
    ),
    (f'{RINGS}strategy = "max_contact_ratio"\n', "pair.strategy", "a pinion in a ring cannot have", '"zero"'),
    (f'{TRAIN}pressure_angle = "15 deg"\n', "pair.pressure_angle", "sought for 20 deg", '"15 deg" in [train]'),
    (f"{TRAIN}addendum = 0.8\n", "pair.addendum", "an addendum of 0.8", "addendum = 0.8 in [train]"),
    (f'{TRAIN}rack = "AGMA 14.5"\n', "pair.rack", "14.5 deg, the teeth of the train", '"14.5 deg" in [train]'),
    (f'{TRAIN}rack = "stub 20"\n', "pair.rack", "an addendum of 0.8, the teeth of the train", "in [train]"),
    (f"{TRAIN}clearance = 1\ntip_radius = 0.5\n", "pair.tip_radius", "no tool has this rack", "tip radius of at most"),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS, ids=[str(k) for k in range(len(FAULTS))])
def test_faults(text: str, path: str, message: str, remedy: str) -> None:
    check_fault(text, path, message, remedy)


def test_all_faults_come_at_once(faults_of: Faults) -> None:
    text = '[pair]\nteeth = [14]\nmodule = 5\nhelix_angle = "70 deg"\nx1 = 0.3\n' + entries(
        'name = "a"\nsplit = "middle"', 'name = "a"\nstrategy = "equal"'
    )
    found = [fault.path for fault in faults_of(text)]
    assert sorted(found) == [
        "pair.helix_angle",
        "pair.meshes[0].split",
        "pair.meshes[1].name",
        "pair.meshes[1].strategy",
        "pair.module",
        "pair.teeth",
        "pair.x1",
    ]


GOOD = [
    PAIR,
    RING,
    RACK,
    f"{PAIR}x1 = 0\nx2 = 0\n",
    f"{RACK}x1 = -0.5\n",
    f'{RING}strategy = "balanced"\ncutter = {{ teeth = 20 }}\n',
    f'{PAIR}centre_distance = 0.085\nsplit = "equal_strength"\n',
    f'{PAIR}strategy = "equal_shift"\nx1 = 0.3\n',
    f"{PAIR}contact_ratio_min = 1.5\n",
    f'{PAIR}pressure_angle = "30 deg"\naddendum = 0.8\nclearance = 0.15\n',
    # a key of [pair] that one of several pairs uses
    f"{PAIR}cutter = {{ teeth = 20 }}\n" + entries('name = "a"', 'kind = "internal"\nteeth = [14, 60]'),
    # the extremes that can be asked for
    '[pair]\nteeth = [5, 10000]\nmodule = "0.05 mm"\nhelix_angle = "-45 deg"\n',
    '[pair]\nteeth = [3, 4]\nmodule = "50 mm"\nrack = "stub 20"\npressure_angle = "14.5 deg"\n',
    TRAIN,
    f"{TRAIN}centre_distance = 0.085\nclearance = 0.2\n",
    TRAIN + entries('mesh = "1-2"\nstrategy = "balanced"\nface_width = 0.02', 'mesh = "2\'-3"\nx1 = 0.1'),
    f'{TRAIN}rack = "ISO 53 C"\n',
    TRAIN.replace("[pair]", '[pair]\nrack = "AGMA 14.5"').replace("ratio =", 'pressure_angle = "14.5 deg"\nratio ='),
    f'{FREE}strategy = "balanced"\n' + entries('mesh = "1-2"\ncentre_distance = 0.1\nstrategy = "given_aw"'),
    # pairs by themselves beside a train
    f"{TEETH}{PAIR}",
    f"{TEETH}[pair]\nmodule = 0.005\n" + entries("teeth = [14, 17]"),
]


@pytest.mark.parametrize("text", GOOD, ids=[str(k) for k in range(len(GOOD))])
def test_good_pairs(text: str) -> None:
    assert parse_spec(text).pair is not None


def check_places(text: str) -> None:
    """A spec is read, or refused with faults of the pairs alone."""
    faults: list[Fault] = []
    try:
        parse_spec(text)
    except SpecError as error:
        faults = error.faults
    assert all(fault.path.startswith("pair") for fault in faults)


KEYS = [
    "teeth",
    "module",
    "kind",
    "rack",
    "helix_angle",
    "pressure_angle",
    "addendum",
    "tip_radius",
    "strategy",
    "x1",
    "centre_distance",
    "contact_ratio_min",
    "angle_range",
    "tip_diameters",
    "cutter",
    "span_teeth",
    "meshes",
    "points",
]


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", KEYS)
def test_hostile_values_are_faults_and_nothing_else(key: str, value: str) -> None:
    lines = {"teeth": "[14, 17]", "module": "0.005", key: value}
    check_places("[pair]\n" + "".join(f"{name} = {each}\n" for name, each in lines.items()))


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", ["mesh", "x1", "rack", "strategy", "cutter", "teeth", "name"])
def test_hostile_values_of_meshes(key: str, value: str) -> None:
    check_places(f"{TRAIN}{ENTRY}{key} = {value}\n")
    check_places(f"{PAIR}{ENTRY}{key} = {value}\n")


def test_words_are_those_of_the_gear_room() -> None:
    assert STRATEGIES == OF_KIND["external"] == tuple(CHOICES)
    assert get_args(Split) == SPLITS
    assert set(OF_KIND["internal"]) == set(INTERNAL_STRATEGIES)


def test_any_helix_within_the_limits_is_read() -> None:
    spec = parse_spec(f"{PAIR}helix_angle = {math.radians(59.9)}\n")
    assert spec.pair is not None
    assert spec.pair.helix_angle == pytest.approx(math.radians(59.9))
