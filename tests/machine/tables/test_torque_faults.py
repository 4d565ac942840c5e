"""What a spec is about, and every kind of fault in [torque]: its place, its line, its words."""

from __future__ import annotations

import pytest
from faults import HOSTILE, Faults, check_lines, check_only_fault
from project.scenes import ENGINE, ROTOR, TORQUE

from tmmcalc.core.errors import UsageError
from tmmcalc.project import parse_spec
from tmmcalc.project.checks import SUBJECTS

HEAD = '[torque]\nspeed = "180 rpm"\n'
FORMULA = HEAD + 'formula = "500*sin(theta)"\n'
HARMONICS = HEAD + "harmonics = {{ terms = [{{ {} }}] }}\n"
PIECES = HEAD + "pieces = [[0, 100], {}]\n"
TABLE = HEAD + "table = {{ {} }}\n"
INERTIA = FORMULA + "reduced_inertia = {{ {} }}\n"
POINTS = HEAD + 'table = {{ theta = [{}], moment = [{}], interpolation = "pchip" }}\n'

# a whole spec; then the path, the message and the remedy of the one fault
FAULTS = [
    (
        '[torque]\nformula = "5"\n',
        "torque.speed",
        "missing key: a torque diagram is that of a shaft with its mean speed",
        'add speed = "180 rpm"',
    ),
    (
        '[torque]\nformula = "5"\nspeed = 1500\n',
        "torque.speed",
        "1500 without a unit is in rad/s, which is 14324 rpm",
        'write "1500 rpm" or "1500 rad/s"',
    ),
    (
        HEAD,
        "torque",
        "missing key: a torque diagram has one law: formula, harmonics, pieces or table",
        'add formula = "500*sin(theta)^2 - 120", for example',
    ),
    (
        FORMULA + "pieces = [[0, 1], [1, 2]]\n",
        "torque.pieces",
        "formula and pieces together: a torque diagram has one law",
        "keep one of them",
    ),
    (
        PIECES.format("[1, 100]") + "constants = { M0 = 500 }\n",
        "torque.constants",
        "constants without formula: nothing names them",
        "remove them",
    ),
    (
        FORMULA + 'delays = ["0 deg", "180 deg"]\ncount = 2\n',
        "torque.count",
        "delays and count together: the delays tell how many there are",
        "remove count, or remove delays for even ones",
    ),
    (
        FORMULA + "count = 0\n",
        "torque.count",
        "0 is less than 1, the least allowed",
        "write 1 or more",
    ),
    (
        FORMULA + "delays = 90\n",
        "torque.delays",
        "90 is not a list of angles",
        'write delays = ["0 deg", "180 deg"]',
    ),
    (
        FORMULA + "delays = []\n",
        "torque.delays",
        "[] has no values; a list of angles",
        'write delays = ["0 deg", "180 deg"]',
    ),
    (
        FORMULA + "period = 720\n",
        "torque.period",
        "720 without a unit is in radians, more than a full turn",
        'write "720 deg" or "720 rad"',
    ),
    (
        FORMULA + "inertia = -1\n",
        "torque.inertia",
        "-1 is negative; a moment of inertia is at least 0",
        "write it without the minus",
    ),
    (
        FORMULA + 'name = "Motor M"\n',
        "torque.name",
        "'Motor M' cannot name a torque diagram",
        "a name is a Latin letter, then letters, digits, _ or '",
    ),
    (
        FORMULA + "balanced = 1\n",
        "torque.balanced",
        "1 is neither true nor false",
        "write true or false, without quotes",
    ),
    (
        HEAD + "formula = 500\n",
        "torque.formula",
        "500 is not a text",
        "write a text in quotes",
    ),
    (
        HEAD + 'formula = "500*sin(theta"\n',
        "torque.formula",
        "formula '500*sin(theta': not a formula at column 8",
        "write it as in M0 * (1 + 0.3*sin(2*theta))",
    ),
    (
        HEAD + 'formula = "5*sin(theta)^2 + M1"\nconstants = { M0 = 500 }\n',
        "torque.formula",
        "formula '5*sin(theta)**2 + M1': unknown name 'M1' at column 19",
        "known: M0, e, phi, pi, theta",
    ),
    (
        HEAD + 'formula = "sqrt(cos(theta))"\n',
        "torque.formula",
        "formula 'sqrt(cos(theta))': no finite value at theta = 1.57952 rad (90.5 deg)",
        "keep roots, logarithms and quotients inside their domain, e.g. with max(0, ...) or a condition",
    ),
    (
        FORMULA + "constants = { theta = 5 }\n",
        "torque.constants.theta",
        "theta is the angle itself",
        "give the constant another name",
    ),
    (
        FORMULA + 'constants = { M0 = "5 N*m" }\n',
        "torque.constants.M0",
        "'5 N*m' is not a constant",
        "write a number, such as 500; it has no quotes and no unit",
    ),
    (
        FORMULA + "constants = 5\n",
        "torque.constants",
        "5 is not a table",
        "write constants = { M0 = 500 }",
    ),
    (
        HEAD + "harmonics = { constant = 5 }\n",
        "torque.harmonics.terms",
        "missing key: a sum of harmonics has terms",
        'add terms = [{ order = 2, sin = "100 N*m" }]',
    ),
    (
        HEAD + "harmonics = { terms = [] }\n",
        "torque.harmonics.terms",
        "no terms: a sum of harmonics has terms",
        'add terms = [{ order = 2, sin = "100 N*m" }]',
    ),
    (
        HARMONICS.format("sin = 5"),
        "torque.harmonics.terms[0].order",
        "missing key: every harmonic has its order",
        "add order = 1 (2, 3, ...)",
    ),
    (
        HARMONICS.format("order = 0, sin = 5"),
        "torque.harmonics.terms[0].order",
        "0 is out of range; an order is above 0",
        "write a number, such as 2",
    ),
    (
        HARMONICS.format("order = 1.5, sin = 5"),
        "torque.harmonics.terms[0].order",
        "the harmonic of order 1.5 does not close in a cycle of 360 deg",
        'write whole orders; in period = "720 deg", of a four-stroke engine, there are halves as well',
    ),
    (
        HARMONICS.format('order = 1, sin = "5 N"'),
        "torque.harmonics.terms[0].sin",
        "'5 N' is a force, a moment is needed",
        'write a number and its unit in quotes, such as "40 N*m"',
    ),
    (
        HARMONICS.format("order = 1, tan = 5"),
        "torque.harmonics.terms[0].tan",
        "unknown key 'tan' in [[torque.harmonics.terms]]",
        "the keys here are: order, cos, sin",
    ),
    (
        HEAD + "harmonics = [1]\n",
        "torque.harmonics",
        "[1] is not a table",
        'write harmonics = { constant = "20 N*m", terms = [{ order = 2, sin = "100 N*m" }] }',
    ),
    (
        HEAD + "pieces = [[0, 100]]\n",
        "torque.pieces",
        "[[0, 100]] has 1 value; a list of two points or more",
        'write pieces = [["0 deg", "100 N*m"], ["90 deg", "-50 N*m"]]',
    ),
    (
        PIECES.format("[1]"),
        "torque.pieces[1]",
        "[1] has 1 value; an angle and a moment",
        'write ["90 deg", "100 N*m"]',
    ),
    (
        PIECES.format("5"),
        "torque.pieces[1]",
        "5 is not an angle and a moment",
        'write ["90 deg", "100 N*m"]',
    ),
    (
        PIECES.format('["5 N*m", 5]'),
        "torque.pieces[1][0]",
        "'5 N*m' is a moment; a point is an angle, then a moment",
        'write ["90 deg", "100 N*m"], for example',
    ),
    (
        PIECES.format('[1, "90 deg"]'),
        "torque.pieces[1][1]",
        "'90 deg' is an angle; a point is an angle, then a moment",
        'write ["90 deg", "100 N*m"], for example',
    ),
    (
        PIECES.format('[1, "5 mm"]'),
        "torque.pieces[1][1]",
        "'5 mm' is a length, an angle or a moment is needed",
        'write a number and its unit in quotes, such as "30 deg" or "40 N*m"',
    ),
    (
        PIECES.format("[2, 5], [1, 5]"),
        "torque.pieces[2]",
        "1 does not come after 2; the angles ascend",
        "put the points in order",
    ),
    (
        PIECES.format("[2, 5], [2, 1], [2, 3]"),
        "torque.pieces[3]",
        "2 does not come after 2; at most two points at one angle",
        "put the points in order",
    ),
    (
        PIECES.format("[90, 5]"),
        "torque.pieces[1]",
        "90 without a unit is in radians, more than the period",
        'write "90 deg"',
    ),
    (
        PIECES.format('["361 deg", 5]'),
        "torque.pieces[1]",
        "'361 deg' lies outside the period, 0 to 360 deg",
        "count from the beginning of the cycle, or give its period",
    ),
    (
        PIECES.format('["150 deg", 5]') + 'period = "120 deg"\n',
        "torque.pieces[1]",
        "'150 deg' lies outside the period, 0 to 120 deg",
        "count from the beginning of the cycle, or give its period",
    ),
    (
        TABLE.format("theta = [0, 1]"),
        "torque.table",
        "missing key: a torque diagram in a table has its moments",
        'add moment = [0, "40 N*m", 0], or file = "m.csv"',
    ),
    (
        TABLE.format('moment = [0, 1], file = "m.csv"'),
        "torque.table.file",
        "file together with moment: the file holds all values",
        "remove file, or remove moment",
    ),
    (
        TABLE.format("theta = [0, 1], moment = [0, 1, 2]"),
        "torque.table.moment",
        "3 moments for 2 angles",
        "write one moment for each angle",
    ),
    (
        TABLE.format("theta = [0], moment = [0, 1]"),
        "torque.table.theta",
        "[0] has 1 value; a list of two angles or more",
        'write theta = ["0 deg", "90 deg", "270 deg"]',
    ),
    (
        TABLE.format("theta = [0, -1], moment = [0, 1]"),
        "torque.table.theta[1]",
        "-1 is negative; an angle is at least 0",
        "write it without the minus",
    ),
    (
        TABLE.format("theta = [0, 1, 0.5], moment = [0, 1, 5]"),
        "torque.table.theta[2]",
        "0.5 does not come after 1; the angles ascend",
        "put the points in order",
    ),
    (
        TABLE.format('theta = ["0 deg", "400 deg"], moment = [0, 1]'),
        "torque.table.theta[1]",
        "'400 deg' lies outside the period, 0 to 360 deg",
        "count from the beginning of the cycle, or give its period",
    ),
    (
        POINTS.format("0, 1, 1", "0, 1, 5"),
        "torque.table.theta[2]",
        "1 does not come after 1; the angles ascend",
        'put them in order; a jump needs interpolation = "linear"',
    ),
    (
        POINTS.format('0, 1, "360 deg"', "0, 1, 5"),
        "torque.table.moment[2]",
        "the curve ends with 5 and begins with 0 at the same position of the shaft",
        'make the two equal; a jump needs interpolation = "linear"',
    ),
    (
        POINTS.format('0, "360 deg"', "5, 5"),
        "torque.table.theta",
        "one point of the cycle alone makes no curve",
        "give points between the ends of the period",
    ),
    (
        TABLE.format('moment = [0, 1], interpolation = "spline"'),
        "torque.table.moment",
        "two points of the period make no cubic spline",
        'give three points or more, or interpolation = "linear"',
    ),
    (
        INERTIA.format("theta = [0, 1]"),
        "torque.reduced_inertia",
        "missing key: a reduced inertia in a table has its moments of inertia",
        'add inertia = ["4 kg*m^2", "5 kg*m^2", "4.5 kg*m^2"], or file = "j.csv"',
    ),
    (
        INERTIA.format("theta = [0, 1, 2], inertia = [1, 2]"),
        "torque.reduced_inertia.inertia",
        "2 moments of inertia for 3 angles",
        "write one moment of inertia for each angle",
    ),
    (
        INERTIA.format("inertia = [1, -2, 3]"),
        "torque.reduced_inertia.inertia[1]",
        "-2 is negative; a moment of inertia is at least 0",
        "write it without the minus",
    ),
    (
        INERTIA.format('theta = [0, 1, 1, 2], inertia = [1, 2, 3, 4], interpolation = "linear"'),
        "torque.reduced_inertia.theta[2]",
        "1 does not come after 1; the angles ascend",
        "put them in order; an inertia does not jump",
    ),
    (
        INERTIA.format('theta = [0, 1, 2, "360 deg"], inertia = [1, 2, 3, 4]'),
        "torque.reduced_inertia.inertia[3]",
        "the curve ends with 4 and begins with 1 at the same position of the shaft",
        "make the two equal; an inertia does not jump",
    ),
    (
        INERTIA.format("theta = [0, 1], inertia = [1, 2]"),
        "torque.reduced_inertia.theta",
        "two points of the period make no cubic spline",
        'give three points or more, or interpolation = "linear"',
    ),
    (
        INERTIA.format('inertia = [1, 2, 3], period = "270 deg"'),
        "torque.reduced_inertia.period",
        "a period of 270 deg does not divide the cycle of 360 deg",
        "write the cycle or a whole part of it",
    ),
    (
        FORMULA + "reduced_inertia = 4\n",
        "torque.reduced_inertia",
        "4 is not a table",
        'write reduced_inertia = { file = "reduction.csv", columns = "phi,J_red" }',
    ),
    (
        TABLE.format("p = [0, 1], moment = [0, 1]"),
        "torque.table.p",
        "unknown key 'p' in [torque.table]",
        "p belongs in [[loads.indicator.strokes]]",
    ),
    (
        HEAD + 'table = { file = "none.csv" }\n',
        "torque.table.file",
        "there is no file 'none.csv'",
        "its path counts from the folder of the spec",
    ),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS)
def test_one_slip_is_one_fault_at_its_line(faults_of: Faults, text: str, path: str, message: str, remedy: str) -> None:
    check_only_fault(text, faults_of(text), path, message, remedy)


@pytest.mark.parametrize(
    "text",
    [
        TORQUE,
        FORMULA,
        FORMULA + 'delays = ["0 deg", "-90 deg"]\nperiod = "720 deg"\n',
        HEAD + 'formula = "sin(theta)/theta"\n',
        HEAD + 'formula = "Md if theta < pi else e"\nconstants = { Md = 10, e = 5 }\n',
        HARMONICS.format("order = 0.5, cos = 5") + 'period = "720 deg"\n',
        PIECES.format('["90 deg", "100 N*m"], ["90 deg", -50], ["360 deg", -50]'),
        TABLE.format("moment = [0, 1, 5]"),
        TABLE.format("theta = [0, 1, 1], moment = [0, 1, 5]"),
        POINTS.format('0, 1, 2, "360 deg"', "0, 1, 5, 0"),
        POINTS.format("0, 1", "0, 1"),
    ],
)
def test_what_is_allowed(text: str) -> None:
    spec = parse_spec(text)
    assert spec.mechanism is None
    assert spec.torque is not None


def test_a_misspelt_key_is_not_missing_as_well(faults_of: Faults) -> None:
    (fault,) = faults_of(HEAD + 'formulae = "5"\n')
    assert (fault.path, fault.remedy) == ("torque.formulae", 'did you mean "formula"?')


# what a spec is about

NO_SUBJECT = (
    "mechanism",
    "missing key: a spec describes a mechanism, or else a linkage to be found, a dyad by itself, a torque diagram, an "
    "engine, a rotor, gears, cams, a vibratory device, a pendulum-rotor, an arm or constraints on given values",
)
MOTOR = '[motor]\nname = "4A132S4"\n'


@pytest.mark.parametrize("text", ["", '[project]\ntitle = "x"\n', MOTOR, "[[loads]]\nlink = 1\nmoment = 5\n"])
def test_a_spec_is_about_something(faults_of: Faults, text: str) -> None:
    (fault,) = faults_of(text)
    assert (fault.path, fault.message) == NO_SUBJECT
    assert fault.remedy.startswith("add [mechanism.input], [[mechanism.links]], [[mechanism.joints]]; [synthesis], ")
    assert [name for name in SUBJECTS[1:] if f"[{name}]" not in fault.remedy] == []
    assert fault.line is None


def test_a_misspelt_mechanism_is_not_missing_as_well(shaper: str, faults_of: Faults) -> None:
    found = faults_of(shaper.replace("[mechanism]", "[mechanizm]").replace("[mechanism.", "[mechanizm."))
    assert {fault.path for fault in found} >= {"mechanizm"}
    assert not [fault for fault in found if fault.message.startswith("missing key: a spec describes")]


def test_a_torque_diagram_stands_in_place_of_a_mechanism(shaper: str, faults_of: Faults) -> None:
    (fault,) = faults_of(shaper + TORQUE)
    assert (fault.path, fault.message) == (
        "torque",
        "torque together with mechanism: a torque diagram stands in place of a mechanism",
    )


def test_an_engine_and_a_rotor_stand_beside_anything(shaper: str) -> None:
    for text in (ENGINE, ROTOR, ENGINE + ROTOR, shaper + ENGINE + ROTOR, TORQUE + ENGINE + ROTOR):
        assert parse_spec(text).engine is not None or "[engine]" not in text


OF_A_MECHANISM = {
    "[[loads]]\nlink = 1\nmoment = 5\noutput = 3\n": "loads act on the links of a mechanism",
    '[[springs]]\nkind = "torsion"\nlinks = [3, 4]\ndamping = 1\n': "springs join the links of a mechanism",
    "[drive]\n": "it drives the crank of a mechanism",
    "[reduction]\n": "forces and masses are those of a mechanism",
    '[balance]\npoint = "B"\n': "the masses are those of a mechanism",
}
OF_A_MACHINE = {
    MOTOR: "there is nothing that it drives",
    "[transmission]\n": "there is nothing that it drives",
    "[motion]\n": "there is nothing that moves",
    '[[transients]]\nduration = 1\nmotor = "off"\n': "there is nothing that moves",
    "[flywheel]\ndelta = 0.04\n": "there is nothing whose speed it evens out",
}


@pytest.mark.parametrize("table", OF_A_MECHANISM)
@pytest.mark.parametrize("alone", [TORQUE, ROTOR])
def test_tables_that_belong_to_a_mechanism(faults_of: Faults, alone: str, table: str) -> None:
    head = table.split("\n")[0]
    fault = next(fault for fault in faults_of(alone + table) if fault.line and "without" in fault.message)
    assert fault.message == f"{head} without [mechanism]: {OF_A_MECHANISM[table]}"
    assert fault.path == head.strip("[]")
    assert (alone + table).splitlines()[(fault.line or 0) - 1] == head


@pytest.mark.parametrize("table", OF_A_MACHINE)
def test_tables_that_belong_to_a_machine(faults_of: Faults, table: str) -> None:
    head = table.split("\n")[0]
    (fault,) = faults_of(ENGINE + table)
    assert fault.message == f"{head} without [mechanism] or [torque]: {OF_A_MACHINE[table]}"
    assert parse_spec(TORQUE + table)


def test_the_linkage_of_a_spec_that_has_none(shaper: str) -> None:
    spec = parse_spec(shaper)
    assert spec.linkage is spec.mechanism
    with pytest.raises(UsageError, match=r"the spec has no \[mechanism\]"):
        _ = parse_spec(ROTOR).linkage


def test_only_what_a_mechanism_lacks_is_told_of_a_mechanism(faults_of: Faults) -> None:
    """A spec whose mechanism is no table is no spec without mechanism."""
    assert [fault.path for fault in faults_of("mechanism = 5\n")] == ["mechanism"]


KEYS = {
    "torque": "name speed period formula constants harmonics pieces table delays count inertia balanced",
    "torque.harmonics": "constant terms",
    "torque.table": "theta moment file interpolation",
}


@pytest.mark.parametrize(("table", "key"), [(table, key) for table, keys in KEYS.items() for key in keys.split()])
def test_no_value_breaks_the_checks(table: str, key: str) -> None:
    for value in (*HOSTILE, "[[0, {}], [1, 2]]", '[["x", 1], [nan, 2]]', '"1 deg"'):
        check_lines(f"[{table}]\n{key} = {value}\n")


def test_no_table_of_another_type_breaks_the_checks(faults_of: Faults) -> None:
    for value in HOSTILE:
        assert faults_of(f"torque = {value}\n")
