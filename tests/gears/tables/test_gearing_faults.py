"""Every kind of fault in [gearing]: its place, its words, what to write instead."""

from __future__ import annotations

import pytest
from faults import HOSTILE, Faults, check_fault

from tmmcalc.core.errors import Fault, SpecError
from tmmcalc.project import parse_spec

PLANET = '[[gearing.members]]\nname = "planet"\ncarrier = "H"\n'
SUN = '[[gearing.meshes]]\nfirst = "sun"\nfirst_teeth = 18\nsecond = "planet"\nsecond_teeth = 48\n'
RING = '[[gearing.meshes]]\nfirst = "planet"\nfirst_teeth = 48\nsecond = "ring"\nsecond_teeth = 114\ninternal = true\n'
BEVEL = PLANET + "tilted = true\n"
LEFT = '[[gearing.meshes]]\nfirst = "left"\nfirst_teeth = 16\nsecond = "planet"\nsecond_teeth = 10\n'
RIGHT = LEFT.replace("left", "right")


def train(lines: str = "speeds = { sun = 22, ring = 0 }\n", rest: str = PLANET + SUN + RING) -> str:
    return f"[gearing]\n{lines}{rest}"


def layout(lines: str) -> str:
    return f'[gearing]\nlayout = "AIbar"\n{lines}'


# the whole spec; then the path of its one fault, a piece of its message and of its remedy
FAULTS = [
    ("[gearing]\n", "gearing", "missing key: a gearing has its meshes", "[[gearing.meshes]]"),
    (train("speeds = { sun = 22 }\n"), "gearing.speeds", "planet, ring, H are not determined: 1 more", "hold it (0)"),
    (train(""), "gearing", "2 more must be given", "hold it (0)"),
    (train("speeds = { sun = 22, ring = 0, H = 4 }\n"), "gearing.speeds", "ring = 0, sun = 22 make it 3", "leave the"),
    (train("speeds = { sn = 22, ring = 0 }\n"), "gearing.speeds.sn", "no member 'sn'", 'did you mean "sun"?'),
    (train("speeds = { sun = 3000, ring = 0 }\n"), "gearing.speeds.sun", "28648 rpm", '"3000 rpm"'),
    (train('speeds = { sun = "3 m", ring = 0 }\n'), "gearing.speeds.sun", "is a length", '"55 rpm"'),
    (train("speeds = 3\n"), "gearing.speeds", "3 is not a table", "speeds = { sun"),
    (
        train("speeds = { sun = 22, ring = 0 }\ntorques = { sun = 1, H = -3 }\n"),
        "gearing.torques",
        "nothing bal",
        "leave out",
    ),
    (train("speeds = { sun = 22, ring = 0 }\nload = { ring = 3 }\n"), "gearing.load", "'ring', which stands", "torque"),
    (train("speeds = { sun = 22, ring = 0 }\nload = { H = -3 }\n"), "gearing.load.H", "negative", "without the minus"),
    (
        train("speeds = { sun = 22, ring = 0 }\nload = { H = 3 }\npowers = { H = -3 }\n"),
        "gearing.powers.H",
        "powers of 'H' together with its load",
        "remove one",
    ),
    (train('speeds = { sun = 22, ring = 0 }\noutput = "ring"\n'), "gearing.output", "held by speeds", "that turns"),
    (train('speeds = { sun = 22, ring = "0 rpm" }\ninput = "ring"\n'), "gearing.input", "held by speeds", "that turns"),
    (train('speeds = { sun = 22, ring = 0 }\ninput = "sun"\noutput = "sun"\n'), "gearing.output", "input and", "two"),
    (train('speeds = { sun = 22, ring = 0 }\noutput = "G"\n'), "gearing.output", "no member 'G'", "H, planet, ring"),
    (train('speeds = { sun = 22, ring = 0 }\noutput = "frame"\n'), "gearing.output", "stands still", "that turns"),
    (train('speeds = { sun = 22 }\nlocked = [["sun", "sun"]]\n'), "gearing.locked[0]", "locked to itself", "two"),
    (train('speeds = { sun = 22 }\nlocked = [["sun", "G"]]\n'), "gearing.locked[0]", "no member 'G'", "members: H"),
    (train('speeds = { sun = 22 }\nlocked = ["sun"]\n'), "gearing.locked[0]", "not a list of 2 values", '["sun", "H"]'),
    (train("speeds = { sun = 22, ring = 0 }\nteeth = [18, 48]\n"), "gearing.teeth", "belongs to a layout", "move it"),
    (
        train("speeds = { sun = 22, ring = 0 }\nefficiency = [0.9]\n"),
        "gearing.efficiency",
        "to a layout",
        "one for all",
    ),
    (train("speeds = { sun = 22, ring = 0 }\nefficiency = 0\n"), "gearing.efficiency", "above 0 and at most 1", "0.98"),
    (
        train("speeds = { sun = 22, ring = 0 }\nefficiency = 0.9\nfriction = 0.1\n"),
        "gearing.friction",
        "friction together with efficiency",
        "remove one",
    ),
    (train(rest=PLANET + SUN + RING.replace("114", "48")), "gearing.meshes[1].internal", "both wheels have 48", "ring"),
    (
        train(rest=SUN + RING + PLANET.replace("H", "planet")),
        "gearing.members[0].carrier",
        "cannot bear itself",
        "name",
    ),
    (train(rest=SUN + RING + PLANET + PLANET), "gearing.members[1].name", "described twice", "keep one"),
    (
        train(rest=SUN + RING + PLANET + PLANET.replace("planet", "plante")),
        "gearing.members[1].name",
        "'plante' is in no mesh and bears nothing",
        'did you mean "planet"?',
    ),
    (train(rest=SUN + RING + PLANET + "sharing = 1.2\n"), "gearing.members[0].sharing", "there is one", "add count"),
    (train(rest=SUN + RING + PLANET + "count = 0\n"), "gearing.members[0].count", "0 is less than 1", "1 or more"),
    (train(rest=SUN + RING + PLANET.replace('"planet"', '"a b"')), "gearing.members[0].name", "cannot name", "sun"),
    (train(rest=SUN.replace('"planet"', '"sun"') + RING + PLANET), "gearing.meshes[0].second", "with itself", "other"),
    (
        train(rest=PLANET + '[[gearing.members]]\nname = "sun"\ncarrier = "G"\n' + SUN + RING),
        "gearing.meshes[0]",
        "no member keeps the axes of this mesh apart: 'sun' is borne by 'G', 'planet' is borne by 'H'",
        "on one carrier",
    ),
    (
        train(rest=PLANET + SUN + RING + "opposite = true\n"),
        "gearing.meshes[1].opposite",
        "tilted member",
        "tilted = true",
    ),
    (train(rest=PLANET + SUN + RING.replace("= 114", "= 0")), "gearing.meshes[1].second_teeth", "less than 1", "1 or"),
    (train(rest=PLANET + SUN + RING.replace("= 114", "= 1.5")), "gearing.meshes[1].second_teeth", "whole", "whole"),
    (
        train(rest=PLANET + SUN + RING.replace("second_teeth = 114\n", "")),
        "gearing.meshes[1].second_teeth",
        "missing key: every wheel has its number of teeth",
        "second_teeth = 48",
    ),
    (
        train("speeds = { left = 1, H = 2 }\n", BEVEL + LEFT + RIGHT),
        "gearing.meshes[1]",
        "on the same side",
        "opposite",
    ),
    (
        train("speeds = { left = 1, H = 2 }\n", BEVEL + LEFT + RIGHT + "internal = true\nopposite = true\n"),
        "gearing.meshes[1].internal",
        "a bevel planet has no ring",
        "opposite = true",
    ),
    (
        train('speeds = { left = 1 }\nlocked = [["planet", "left"]]\n', BEVEL + LEFT + RIGHT + "opposite = true\n"),
        "gearing.speeds",
        "the tilted member 'planet' cannot be locked to 'left'",
        "lock it to its carrier",
    ),
    (layout(""), "gearing", "missing key: a layout has its numbers of teeth", "of 1, 2, 3"),
    (layout("teeth = [18, 48]\n"), "gearing.teeth", "2 numbers of teeth, layout AIbar has 3 wheels", "1, 2, 3"),
    (layout("teeth = [18, 114, 48]\n"), "gearing.teeth", "ring 3 has 48 teeth, wheel 2 within it 114", "1, 2, 3"),
    (layout("teeth = [18, 48, 114]\nefficiency = [0.9]\n"), "gearing.efficiency", "1 efficiencies", "1-2, 2-3"),
    (layout("teeth = [18, 48, 114]\nsharing = 1.2\n"), "gearing.sharing", "one planet", "add planets"),
    (layout("teeth = [18, 48, 114]\nspeeds = { 4 = 1 }\n"), "gearing.speeds.4", "no member '4'", "1, 2, 3, H"),
    (layout("teeth = [18, 48, 114]\n" + SUN), "gearing.meshes", "meshes together with layout", "remove meshes"),
    (
        '[gearing]\nlayout = "unfolded2"\nteeth = [17, 59, 17, 40]\nplanets = 3\n',
        "gearing.planets",
        "neither",
        "remove",
    ),
    ('[gearing]\nlayout = "Al"\nteeth = [17, 59, 17, 40]\n', "gearing.layout", "is no layout", "there are: unfolded2"),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS, ids=[str(k) for k in range(len(FAULTS))])
def test_faults(text: str, path: str, message: str, remedy: str) -> None:
    check_fault(text, path, message, remedy)


def check_places(text: str) -> None:
    """A spec is read, or refused with faults of the gearing alone."""
    faults: list[Fault] = []
    try:
        parse_spec(text)
    except SpecError as error:
        faults = error.faults
    assert all(fault.path.startswith("gearing") for fault in faults)


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize(
    "key", ["speeds", "torques", "load", "powers", "input", "output", "locked", "efficiency", "friction"]
)
def test_hostile_values_are_faults_and_nothing_else(key: str, value: str) -> None:
    speeds = "" if key == "speeds" else "speeds = { sun = 22, ring = 0 }\n"
    check_places(train(f"{speeds}{key} = {value}\n"))


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", ["layout", "teeth", "planets", "sharing", "speeds", "efficiency"])
def test_hostile_layouts_are_faults_and_nothing_else(key: str, value: str) -> None:
    lines = {"layout": '"AIbar"', "teeth": "[18, 48, 114]", key: value}
    check_places("[gearing]\n" + "".join(f"{name} = {each}\n" for name, each in lines.items()))


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", ["first", "first_teeth", "internal", "opposite", "efficiency", "members", "carrier"])
def test_hostile_meshes_are_faults_and_nothing_else(key: str, value: str) -> None:
    speeds = "speeds = { sun = 22, ring = 0 }\n"
    if key == "members":
        check_places(train(f"{speeds}members = {value}\n", SUN + RING))
    elif key == "carrier":
        check_places(train(speeds, SUN + RING + f'[[gearing.members]]\nname = "planet"\ncarrier = {value}\n'))
    else:
        mesh = {"first": '"sun"', "first_teeth": "18", "second": '"planet"', "second_teeth": "48", key: value}
        text = "[[gearing.meshes]]\n" + "".join(f"{name} = {each}\n" for name, each in mesh.items())
        check_places(train(speeds, PLANET + RING + text))


def test_members_that_bear_each_other(faults_of: Faults) -> None:
    carrier = '[[gearing.members]]\nname = "H"\ncarrier = "planet"\n'
    found = faults_of(train(rest=PLANET + carrier + SUN + RING))
    assert {fault.path for fault in found} == {f"gearing.members[{k}].carrier" for k in range(2)}
    assert all("bear each other in a ring" in fault.message for fault in found)


def test_members_may_be_numbers() -> None:
    text = """
[gearing]
speeds = { 1 = "1450 rpm", 3 = 0 }
[[gearing.members]]
name = 2
carrier = "H"
[[gearing.meshes]]
first = 1
first_teeth = 18
second = 2
second_teeth = 48
[[gearing.meshes]]
first = 2
first_teeth = 48
second = 3
second_teeth = 114
internal = true
"""
    table = parse_spec(text).gearing
    assert table is not None
    assert [(mesh.first, mesh.second) for mesh in table.meshes] == [("1", "2"), ("2", "3")]
    assert set(table.speeds) == {"1", "3"}


def test_what_cannot_turn_is_no_fault_of_the_spec() -> None:
    """It has an exit code of its own, when it is asked to turn."""
    assert parse_spec('[gearing]\nlayout = "AA"\nteeth = [20, 40, 40, 20]\n').gearing is not None
