"""Every kind of fault in [balance], [engine] and [rotor]: its place, its line, its words."""

from __future__ import annotations

from typing import get_args

import pytest
from faults import HOSTILE, Faults, check_lines, check_only_fault
from project.scenes import CONFIGS, ENGINE, ROTOR
from sparing import sparing

from tmmcalc.machine.balance.arrangements import FIRING, THROWS
from tmmcalc.machine.balance.solve import SCHEMES
from tmmcalc.machine.flywheel.materials import MATERIALS
from tmmcalc.machine.tables.balance import BalanceTable
from tmmcalc.machine.tables.flywheel import FlywheelTable
from tmmcalc.project import parse_spec

SIZES = 'speed = "3000 rpm"\ncrank_radius = "40 mm"\nrod_length = "140 mm"\nreciprocating_mass = 0.6\n'
BARE = "[engine]\n" + SIZES
LINE = BARE + 'arrangement = "in-line"\nspacing = "90 mm"\n'
FOUR = LINE + "cylinders = 4\n"
VEE = BARE + 'arrangement = "vee"\nspacing = "90 mm"\n'
LISTED = BARE + '[[engine.cylinders]]\ncrank_angle = "90 deg"\nposition = 0\n'
HEAD = "[rotor]\nmass = 40\ncenter = 0.2\nbearings = [0, 0.4]\nspeed = 300\nplanes = [0.1, 0.3]\n"
PLAIN = HEAD + "[[rotor.unbalances]]\nmoment = 0.001\nposition = 0\n"
ADD = "[balance]\nadd = [{{ order = {}, mass = 2, radius = 0.1{} }}]\n"

# what is added to the shaper; then the path, the message and the remedy of the one fault
BALANCE = [
    (
        "[balance]\nmass = 2\nradius = 0.1\n",
        "balance.radius",
        "mass and radius together: one is chosen, the other follows from the balance",
        "remove one of them",
    ),
    (
        "[balance]\nradius = 0\n",
        "balance.radius",
        "0 is zero; a length other than 0 is needed here",
        'write "200 mm", for example',
    ),
    (
        '[balance]\npoint = "C"\n',
        "balance.point",
        "the frame has no point 'C'",
        "the points of the frame are: O, B; or add C = [x, y] to [mechanism.fixed]",
    ),
    (
        "[balance]\npoint = 5\n",
        "balance.point",
        "5 is not a point",
        'write the name of a point, such as "B", or two coordinates [x, y]',
    ),
    (
        '[balance]\nschemes = "minimax"\n',
        "balance.schemes",
        "'minimax' is not a list of schemes",
        'write schemes = ["least squares", "minimax"]',
    ),
    (
        '[balance]\nschemes = ["minimax", "best"]\n',
        "balance.schemes[1]",
        '\'best\' is not allowed here; the value is "least squares", "minimax", "lanchester" or "lanchester 2"',
        'write "least squares", "minimax", "lanchester" or "lanchester 2"',
    ),
    (
        '[balance]\nschemes = ["minimax", "minimax"]\n',
        "balance.schemes[1]",
        "'minimax' is named twice",
        "remove one of them",
    ),
    (
        "[balance]\ncounterweights = [{ mass = 2 }]\n",
        "balance.counterweights[0].link",
        "missing key: a counterweight is on a link",
        "add link = 1",
    ),
    (
        "[balance]\ncounterweights = [{ link = 0, mass = 2 }]\n",
        "balance.counterweights[0].link",
        "link 0 is the frame and does not move",
        "name a moving link",
    ),
    (
        "[balance]\ncounterweights = [{ link = 8, mass = 2 }]\n",
        "balance.counterweights[0].link",
        "there is no link 8",
        "the links are: 0 (the frame), 1, 2, 3, 4, 5",
    ),
    (
        "[balance]\ncounterweights = [{ link = 3, mass = 2 }, { link = 3, mass = 2 }]\n",
        "balance.counterweights[1].link",
        "link 3 has a counterweight already (line 107)",
        "one link has one",
    ),
    (
        "[balance]\ncounterweights = [{ link = 3 }]\n",
        "balance.counterweights[0]",
        "missing key: a counterweight has its mass or its radius",
        'add radius = "60 mm"',
    ),
    (
        "[balance]\ncounterweights = [{ link = 3, mass = 2, radius = 1 }]\n",
        "balance.counterweights[0].radius",
        "mass and radius together: one is chosen, the other follows from the balance",
        "remove one of them",
    ),
    (
        "[balance]\ncounterweights = { link = 3, mass = 2 }\n",
        "balance.counterweights",
        "a single table, where a list of tables is needed",
        "begin each with [[balance.counterweights]], two brackets",
    ),
    (
        "[balance]\nadd = [{ mass = 2, radius = 0.1 }]\n",
        "balance.add[0].order",
        "missing key: a rotating weight turns with some multiple of the crank's speed",
        "add order = -1",
    ),
    (
        "[balance]\nadd = [{ order = -1, radius = 0.1 }]\n",
        "balance.add[0].mass",
        "missing key: a rotating weight has its mass",
        'add mass = "2 kg"',
    ),
    (
        "[balance]\nadd = [{ order = -1, mass = 2 }]\n",
        "balance.add[0].radius",
        "missing key: a rotating weight has its radius",
        'add radius = "60 mm"',
    ),
    (
        ADD.format(0, ""),
        "balance.add[0].order",
        "0 is no order: a weight that stands still balances nothing",
        "write 1 for the crank itself, -1 for a shaft that turns against it",
    ),
    (
        ADD.format(1.5, ""),
        "balance.add[0].order",
        "1.5 is not a whole number",
        "write a whole number",
    ),
    (
        ADD.format(1, ", axis = [0, 0]"),
        "balance.add[0].axis",
        "a weight of order 1 sits on the crank and has no axis of its own",
        "remove axis",
    ),
    (
        ADD.format(-1, ", axis = [0]"),
        "balance.add[0].axis",
        "[0] has 1 value; a point is two coordinates",
        'write [x, y], such as [0, "620 mm"]',
    ),
    (
        "[balance]\nadd = 5\n",
        "balance.add",
        "5, where a list of tables is needed",
        "begin each with [[balance.add]], two brackets",
    ),
]

# a whole spec; then the same
ALONE = [
    (
        LINE,
        "engine.cylinders",
        "missing key: an engine has cylinders",
        "add cylinders = 4 with an arrangement, or [[engine.cylinders]], one for each",
    ),
    (
        FOUR.replace('speed = "3000 rpm"\n', ""),
        "engine.speed",
        "missing key: inertia forces depend on the speed of the shaft",
        'add speed = "3000 rpm"',
    ),
    (
        FOUR.replace('"3000 rpm"', "3000"),
        "engine.speed",
        "3000 without a unit is in rad/s, which is 28648 rpm",
        'write "3000 rpm" or "3000 rad/s"',
    ),
    (
        BARE + "cylinders = 1\n",
        "engine",
        "missing key: a number of cylinders needs their arrangement",
        'add arrangement = "in-line" or arrangement = "vee"',
    ),
    (
        FOUR.replace("in-line", "star"),
        "engine.arrangement",
        '\'star\' is not allowed here; the value is "in-line" or "vee"',
        'write "in-line" or "vee"',
    ),
    (
        LINE + 'cylinders = "four"\n',
        "engine.cylinders",
        "'four' is not a whole number",
        "write a whole number",
    ),
    (
        LINE + "cylinders = 0\n",
        "engine.cylinders",
        "0 is less than 1, the least allowed",
        "write 1 or more",
    ),
    (
        BARE + "[engine.cylinders]\nposition = 0\n",
        "engine.cylinders",
        "a single table, where a list of tables is needed",
        "begin each with [[engine.cylinders]], two brackets",
    ),
    (
        BARE + "cylinders = []\n",
        "engine.cylinders",
        "no cylinders: an engine has cylinders",
        "add cylinders = 4 with an arrangement, or [[engine.cylinders]], one for each",
    ),
    (
        LISTED.replace("[[", 'spacing = "90 mm"\n[[', 1),
        "engine.spacing",
        "spacing together with [[engine.cylinders]]: each cylinder tells its own place and crank",
        "remove spacing, or write cylinders = 1",
    ),
    (
        FOUR.replace('spacing = "90 mm"\n', ""),
        "engine",
        "missing key: the throws stand at a distance along the shaft",
        'add spacing = "90 mm"',
    ),
    (
        FOUR + 'angle = "90 deg"\n',
        "engine.angle",
        "cylinders in line have no angle",
        'remove it, or write arrangement = "vee"',
    ),
    (
        VEE + "cylinders = 4\n",
        "engine",
        "missing key: a vee has its angle",
        'add angle = "90 deg"',
    ),
    (
        VEE + 'angle = "60 deg"\ncylinders = 5\n',
        "engine.cylinders",
        "5 cylinders: two stand on every throw of a vee",
        "write 6, or list them: [[engine.cylinders]]",
    ),
    (
        VEE + 'angle = "60 deg"\ncylinders = 14\n',
        "engine.cylinders",
        "there are no customary cranks of 14 cylinders in a vee",
        "add throws; they are known for 2, 4, 6, 8, 10, 12 cylinders",
    ),
    (
        LINE + "cylinders = 7\n",
        "engine.cylinders",
        "there are no customary cranks of 7 cylinders in line",
        "add firing_order, or throws; they are known for 1, 2, 3, 4, 5, 6, 8 cylinders",
    ),
    (
        FOUR + "throws = [0, 1, 2]\n",
        "engine.throws",
        "3 throws for 4 cylinders",
        "write 4 angles",
    ),
    (
        VEE + 'angle = "60 deg"\ncylinders = 4\nthrows = [0, 1, 2]\n',
        "engine.throws",
        "3 throws for 4 cylinders, two on each",
        "write 2 angles",
    ),
    (
        FOUR + 'throws = "0 deg"\n',
        "engine.throws",
        "'0 deg' is not a list of angles",
        'write throws = ["0 deg", "180 deg", "180 deg", "0 deg"]',
    ),
    (
        FOUR + "firing_order = [1, 3, 4]\n",
        "engine.firing_order",
        "[1, 3, 4] does not name every cylinder from 1 to 4 once",
        "write each number once, such as [1, 3, 4, 2]",
    ),
    (
        LINE + "cylinders = 1000000000\nfiring_order = [1]\n",
        "engine.cylinders",
        "1000000000 is more than 100, the most allowed",
        "write 100 or less",
    ),
    (
        FOUR + 'firing_order = "1342"\n',
        "engine.firing_order",
        "'1342' is not a list of cylinder numbers",
        "write firing_order = [1, 3, 4, 2]",
    ),
    (
        FOUR + "strokes = 3\n",
        "engine.strokes",
        "3 is not allowed here; the value is 2 or 4",
        "write 2 or 4",
    ),
    (
        FOUR + "orders = [1, 2, 1]\n",
        "engine.orders[2]",
        "1 is named twice",
        "remove one of them",
    ),
    (
        FOUR + "orders = [0]\n",
        "engine.orders[0]",
        "0 is less than 1, the least allowed",
        "write 1 or more",
    ),
    (
        FOUR.replace("reciprocating_mass = 0.6\n", ""),
        "engine",
        "missing key: every cylinder has a reciprocating mass",
        'add reciprocating_mass = "0.6 kg"',
    ),
    (
        LISTED.replace("reciprocating_mass = 0.6\n", ""),
        "engine",
        "missing key: every cylinder has a reciprocating mass",
        'add reciprocating_mass = "0.6 kg"',
    ),
    (
        LISTED.replace("reciprocating_mass = 0.6\n", "")
        + "[[engine.cylinders]]\ncrank_angle = 0\nposition = 1\nreciprocating_mass = 1\n",
        "engine.cylinders[0]",
        "missing key: every cylinder has a reciprocating mass",
        'add reciprocating_mass = "0.6 kg"',
    ),
    (
        FOUR.replace('"140 mm"', '"40 mm"'),
        "engine.rod_length",
        "the rod, '40 mm', is not longer than the crank: the crank cannot turn",
        "change the lengths",
    ),
    (
        FOUR + "offset = -0.11\n",
        "engine.rod_length",
        "the rod, '140 mm', is not longer than the crank and offset: the crank cannot turn",
        "change the lengths",
    ),
    (
        LISTED + 'crank_radius = "150 mm"\n',
        "engine.cylinders[0].crank_radius",
        "the rod, '140 mm', is not longer than the crank: the crank cannot turn",
        "change the lengths",
    ),
    (
        LISTED.replace("position = 0\n", ""),
        "engine.cylinders[0].position",
        "missing key: every cylinder has its place along the shaft",
        'add position = "90 mm"',
    ),
    (
        LISTED.replace('crank_angle = "90 deg"\n', ""),
        "engine.cylinders[0].crank_angle",
        "missing key: the crank of every cylinder has its direction",
        'add crank_angle = "180 deg"',
    ),
    (
        LISTED + 'axis_angel = "90 deg"\n',
        "engine.cylinders[0].axis_angel",
        "unknown key 'axis_angel' in [[engine.cylinders]]",
        'did you mean "axis_angle"?',
    ),
    (
        LISTED + "rotating_mass = -1\n",
        "engine.cylinders[0].rotating_mass",
        "-1 is negative; a mass is at least 0",
        "write it without the minus",
    ),
    (
        PLAIN.replace("mass = 40\n", ""),
        "rotor.mass",
        "missing key: a rotor has its mass",
        'add mass = "40 kg"',
    ),
    (
        PLAIN.replace("mass = 40", "mass = 0"),
        "rotor.mass",
        "0 is zero; a mass other than 0 is needed here",
        'write "55 kg", for example',
    ),
    (
        PLAIN.replace("center = 0.2\n", ""),
        "rotor.center",
        "missing key: the centre of mass has its place along the axis",
        'add center = "200 mm"',
    ),
    (
        PLAIN.replace("bearings = [0, 0.4]\n", ""),
        "rotor.bearings",
        "missing key: a rotor runs in two bearings",
        'add bearings = [0, "400 mm"], their places along the axis',
    ),
    (
        PLAIN.replace("[0, 0.4]", "[0.4]"),
        "rotor.bearings",
        "[0.4] has 1 value; the places of the two bearings",
        'write bearings = [0, "400 mm"]',
    ),
    (
        PLAIN.replace("[0, 0.4]", '[0.4, "400 mm"]'),
        "rotor.bearings",
        "both bearings are at one place; a rotor runs in two bearings",
        "write two different places",
    ),
    (
        PLAIN.replace("[0.1, 0.3]", "[0.1, 0.1]"),
        "rotor.planes",
        "both planes are at one place; a couple is balanced by weights at a distance",
        "write two different places",
    ),
    (
        PLAIN.replace("planes = [0.1, 0.3]\n", ""),
        "rotor.planes",
        "missing key: a rotor is balanced in two planes",
        'add planes = ["50 mm", "350 mm"], their places along the axis',
    ),
    (
        PLAIN.replace("speed = 300\n", ""),
        "rotor.speed",
        "missing key: bearing loads and tolerances depend on the speed",
        'add speed = "3000 rpm"',
    ),
    (
        PLAIN.replace("speed = 300", "speed = 3000"),
        "rotor.speed",
        "3000 without a unit is in rad/s, which is 28648 rpm",
        'write "3000 rpm" or "3000 rad/s"',
    ),
    (
        PLAIN.replace("[[", 'grade = "6.3 G"\n[[', 1),
        "rotor.grade",
        "'6.3 G' is not a balance quality grade",
        'write "G6.3", or 6.3',
    ),
    (
        PLAIN.replace("[[", "grade = 0\n[[", 1),
        "rotor.grade",
        "0 is no grade: the usual ones are from G0.4 to G4000",
        'write "G6.3", or 6.3',
    ),
    (
        HEAD,
        "rotor.unbalances",
        "missing key: a rotor has unbalances",
        "add [[rotor.unbalances]], one for each",
    ),
    (
        HEAD + "unbalances = []\n",
        "rotor.unbalances",
        "no unbalances: a rotor has unbalances",
        "add [[rotor.unbalances]], one for each",
    ),
    (
        PLAIN.replace("position = 0\n", ""),
        "rotor.unbalances[0].position",
        "missing key: every unbalance has its place along the axis",
        'add position = "120 mm"',
    ),
    (
        PLAIN + "mass = 1\nradius = 1\n",
        "rotor.unbalances[0].moment",
        "moment together with mass and radius: the moment is mass times radius",
        "remove it, or remove mass and radius",
    ),
    (
        PLAIN.replace("moment = 0.001", "mass = 1"),
        "rotor.unbalances[0]",
        "missing key: an unbalance is a mass at a radius, or a static moment",
        'add mass = "5 g" and radius = "80 mm", or moment = "400 g*mm"',
    ),
    (
        PLAIN.replace("0.001", '"12 kg"'),
        "rotor.unbalances[0].moment",
        "'12 kg' is a mass, a static moment is needed",
        'write a number and its unit in quotes, such as "12 g*mm"',
    ),
    (
        PLAIN.replace("0.001", "-0.001"),
        "rotor.unbalances[0].moment",
        "-0.001 is negative; a static moment is at least 0",
        "write it without the minus",
    ),
]


@pytest.mark.parametrize(("added", "path", "message", "remedy"), BALANCE)
def test_one_slip_of_the_balance_is_one_fault(
    shaper: str, faults_of: Faults, added: str, path: str, message: str, remedy: str
) -> None:
    text = f"{shaper}\n{added}"
    check_only_fault(text, faults_of(text), path, message, remedy)


@pytest.mark.parametrize(("text", "path", "message", "remedy"), ALONE)
def test_one_slip_of_an_engine_or_a_rotor_is_one_fault(
    shaper: str, faults_of: Faults, text: str, path: str, message: str, remedy: str
) -> None:
    check_only_fault(text, faults_of(text), path, message, remedy)
    check_only_fault(f"{shaper}\n{text}", faults_of(f"{shaper}\n{text}"), path, message, remedy)


@pytest.mark.parametrize(
    "text",
    [
        *(LINE + f"cylinders = {count}\n" for count in FIRING),
        *(VEE + f'angle = "60 deg"\ncylinders = {2 * throws}\n' for throws in THROWS),
        LINE + "cylinders = 7\nfiring_order = [1, 3, 5, 7, 2, 4, 6]\n",
        LINE + "cylinders = 7\nthrows = [0, 1, 2, 3, 4, 5, 6]\n",
        VEE + 'angle = "180 deg"\ncylinders = 2\nsplit = "180 deg"\nstagger = "50 mm"\n',
        VEE + 'angle = "60 deg"\ncylinders = 4\nthrows = [0, 1]\nfiring_order = [1, 2, 3, 4]\nstrokes = 2\n',
        LINE.replace('spacing = "90 mm"\n', "") + "cylinders = 1\n",
        LISTED,
        LISTED + 'offset = "-50 mm"\nrod_length = 0.2\n',
        LISTED.replace(SIZES, 'speed = "3000 rpm"\n') + "crank_radius = 1\nrod_length = 2\nreciprocating_mass = 0\n",
        PLAIN,
        PLAIN.replace("[[", 'grade = "G 2.5"\nstatic_plane = 0\nradius = 0.1\n[[', 1),
        PLAIN.replace("moment = 0.001", "mass = -1\nradius = 0.1"),
        ENGINE + ROTOR,
    ],
)
def test_what_is_allowed(text: str) -> None:
    assert parse_spec(text)


def test_what_is_allowed_of_a_balance(shaper: str) -> None:
    for added in ("[balance]\n", "[balance]\npoint = [0, 1]\nschemes = []\n", ADD.format(1, ""), ADD.format(-2, "")):
        assert parse_spec(shaper + added)


def test_a_driven_slider_is_not_balanced(faults_of: Faults) -> None:
    (fault,) = faults_of((CONFIGS / "hydraulic-lift.toml").read_text(encoding="utf-8") + "[balance]\n")
    assert (fault.path, fault.message) == (
        "balance",
        'the input joint "A0" is prismatic; balancing is that of a mechanism with a crank',
    )


def test_words_are_those_of_the_rooms() -> None:
    schemes = get_args(BalanceTable.model_fields["schemes"].annotation)[0]
    assert get_args(schemes) == SCHEMES == tuple(BalanceTable().schemes)
    assert {*get_args(FlywheelTable.model_fields["material"].annotation)} == {*MATERIALS}


KEYS = {
    "balance": "mass radius point schemes counterweights add",
    "balance.counterweights": "link mass radius",
    "balance.add": "order mass radius angle axis",
    "engine": "speed arrangement cylinders angle spacing crank_radius rod_length reciprocating_mass rotating_mass "
    "offset strokes firing_order throws split stagger orders",
    "engine.cylinders": "axis_angle crank_angle position crank_radius rod_length reciprocating_mass rotating_mass "
    "offset",
    "rotor": "mass center bearings speed planes static_plane radius grade unbalances",
    "rotor.unbalances": "mass radius moment angle position",
}
ARRAYS = ("balance.counterweights", "balance.add", "engine.cylinders", "rotor.unbalances")


@sparing(("table", "key"), [(table, key) for table, keys in KEYS.items() for key in keys.split()], every=6)
def test_no_value_breaks_the_checks(shaper: str, table: str, key: str) -> None:
    head = f"[[{table}]]" if table in ARRAYS else f"[{table}]"
    laid_out = table == "engine" and key not in ("arrangement", "cylinders")
    more = 'arrangement = "vee"\ncylinders = 4\n' if laid_out else ""
    for value in (*HOSTILE, "-1", "0", "100000000", "[1, 2]"):
        check_lines(f"{shaper}\n{head}\n{key} = {value}\n{more}")


@pytest.mark.parametrize("table", ["balance", "engine", "rotor"])
def test_no_table_of_another_type_breaks_the_checks(faults_of: Faults, table: str) -> None:
    for value in HOSTILE:
        assert faults_of(f"{table} = {value}\nmechanism = {value}\n")
