"""Every kind of fault in [[shafts]] and [[transients]]: its place, its line, its words."""

from __future__ import annotations

from typing import get_args

import pytest
from faults import HOSTILE, Faults, check_lines, check_only_fault
from project.scenes import CONFIGS, TORQUE
from sparing import sparing

from tmmcalc.machine.tables.transients import TransientTable
from tmmcalc.machine.transient.methods import METHODS
from tmmcalc.project import parse_spec

MOTOR = '[motor]\npower = "7.5 kW"\nspeed = "1455 rpm"\nsynchronous_speed = "1500 rpm"\n'
ROTOR = MOTOR + "inertia = 0.03\n"
SHAFT = '[[shafts]]\nstiffness = "5000 N*m/rad"\n'
FIRST = SHAFT + "inertia = 0.5\nratio = 4\n"
START = ROTOR + '[[transients]]\nduration = "5 s"\n'
FREE = '[[transients]]\nduration = "5 s"\nmotor = "off"\n'

# what is added to the shaper; then the path, the message and the remedy of the one fault
FAULTS = [
    (
        SHAFT,
        "shafts",
        "[[shafts]] without [motor]: the first mass of the drive is its rotor",
        'add [motor] with inertia = "0.03 kg*m^2"',
    ),
    (
        MOTOR + SHAFT + FREE,
        "motor",
        "missing key: the rotor is the first mass of [[shafts]]",
        'add inertia = "0.03 kg*m^2"',
    ),
    (
        MOTOR + "flywheel_moment = 0\n" + SHAFT,
        "motor.flywheel_moment",
        "0 is no inertia of a rotor that [[shafts]] begin with",
        'write "0.03 kg*m^2", for example',
    ),
    (
        ROTOR + SHAFT + SHAFT + FREE,
        "shafts[0]",
        "missing key: the mass between this shaft and the next has its moment of inertia",
        'add inertia = "0.5 kg*m^2"; join two shafts in series into one',
    ),
    (
        ROTOR + SHAFT + "inertia = 0\n" + SHAFT,
        "shafts[0].inertia",
        "0 is no inertia of a mass between two shafts",
        'write "0.5 kg*m^2", for example; join shafts in series into one',
    ),
    (
        ROTOR + "[[shafts]]\ndamping = 5\n",
        "shafts[0].damping",
        "damping without stiffness: a rigid shaft is not twisted",
        'add stiffness = "5000 N*m/rad"; stiffness = 0 is a fluid coupling',
    ),
    (
        ROTOR + "[[shafts]]\nstiffness = 0\n",
        "shafts[0].stiffness",
        "0 without damping: the shaft carries no moment",
        'write "5000 N*m/rad", for example; add damping for a fluid coupling; remove it for a rigid shaft',
    ),
    (
        ROTOR + '[[shafts]]\nstiffness = "5000 N/m"\n',
        "shafts[0].stiffness",
        "'5000 N/m' is a stiffness, a torsional stiffness is needed",
        'write a number and its unit in quotes, such as "5000 N*m/rad"',
    ),
    (
        ROTOR + SHAFT + "ratio = 0\n",
        "shafts[0].ratio",
        "0 is out of range; a ratio is above 0",
        "write a number, such as 26.4",
    ),
    (
        ROTOR + 2 * (FIRST + 'name = "a"\n'),
        "shafts[1].name",
        "'a' is already the name of another shaft (line 115)",
        "give each shaft a name of its own",
    ),
    (
        ROTOR + FIRST + SHAFT + "ratio = 2\n[transmission]\nratio = 8.001\n",
        "transmission.ratio",
        "8.001 is not the product of the ratios of [[shafts]], which is 8",
        "remove it, or give the shafts their ratios: speed of the mass before over that of the mass behind",
    ),
    (
        ROTOR + SHAFT + "behind_gear = 1\n",
        "shafts[0].behind_gear",
        "1 is neither true nor false",
        "write true or false, without quotes",
    ),
    (
        ROTOR + SHAFT + 'name = "n"\nstifness = 5\n',
        "shafts[0].stifness",
        "unknown key 'stifness' in [[shafts]] (shaft \"n\")",
        'did you mean "stiffness"?',
    ),
    (
        ROTOR + "[shafts]\nstiffness = 5\n",
        "shafts",
        "a single table, where a list of tables is needed",
        "begin each with [[shafts]], two brackets",
    ),
    (
        ROTOR + "[[transients]]\nduration = 0\n",
        "transients[0].duration",
        "0 is zero; a time other than 0 is needed here",
        'write "0.5 s", for example',
    ),
    (
        START + 'start_speed = "-50 rpm"\n',
        "transients[0].start_speed",
        "'-50 rpm' is backwards, where standstill = \"stop\" lets no crank turn",
        'write it without the minus, or standstill = "pass"',
    ),
    (
        START + "start_speed = 900\n",
        "transients[0].start_speed",
        "900 without a unit is in rad/s, which is 8594 rpm",
        'write "900 rpm" or "900 rad/s"',
    ),
    (
        START + 'start_speed = "50 rpm"\nfrom = "steady"\n',
        "transients[0].start_speed",
        'start_speed together with from = "steady": the steady motion gives speed and angle',
        "remove it, or remove from",
    ),
    (
        START + 'from = "rest"\n',
        "transients[0].from",
        "'rest' is not allowed here; the value is \"steady\"",
        'write "steady"',
    ),
    (
        START + 'begin = "steady"\n',
        "transients[0].begin",
        "unknown key 'begin' in [[transients]]",
        "the keys here are: name, duration, start_speed, from, start_angle, motor, motor_on, braking, load, "
        "load_steps, brake, targets, end_speed, end_angle, standstill, method, step, tolerance",
    ),
    (
        START + 'start_angle = "-5 deg"\n',
        "transients[0].start_angle",
        "'-5 deg' is negative; an angle is at least 0",
        "write it without the minus",
    ),
    (
        FREE.replace('motor = "off"\n', ""),
        "transients[0]",
        "missing motor: it is on in this motion, but the spec has no [motor]",
        'add [motor], or motor = "off"',
    ),
    (
        FREE.replace("off", "on"),
        "transients[0].motor",
        "missing motor: it is on in this motion, but the spec has no [motor]",
        'add [motor], or motor = "off"',
    ),
    (
        FREE.replace('motor = "off"', "motor_on = [[0, 1]]"),
        "transients[0].motor_on",
        "missing motor: it is on in this motion, but the spec has no [motor]",
        'add [motor], or motor = "off"',
    ),
    (
        START + 'motor = "on"\nmotor_on = [[0, 1]]\n',
        "transients[0].motor",
        "motor together with motor_on: the times tell when it is on",
        "remove one of them",
    ),
    (
        START + 'motor = "half"\n',
        "transients[0].motor",
        '\'half\' is not allowed here; the value is "on" or "off"',
        'write "on" or "off"',
    ),
    (
        START + "motor_on = []\n",
        "transients[0].motor_on",
        "[] has no values; a list of intervals of time",
        'write motor_on = [["0 s", "2 s"]]',
    ),
    (
        START + "motor_on = [0]\n",
        "transients[0].motor_on[0]",
        "0 is not two times, on and off",
        'write ["0 s", "2 s"]',
    ),
    (
        START + "motor_on = [[0, 1, 2]]\n",
        "transients[0].motor_on[0]",
        "[0, 1, 2] has 3 values; two times, on and off",
        'write ["0 s", "2 s"]',
    ),
    (
        START + "motor_on = [[0, 1], [3, 2]]\n",
        "transients[0].motor_on[1]",
        "[3, 2] ends before it begins",
        'write [on, off], such as ["0 s", "2 s"]',
    ),
    (
        START + 'motor_on = [["6 s", "8 s"]]\n',
        "transients[0].motor_on[0][0]",
        "'6 s' is not before the end of the motion, '5 s'",
        "write an earlier time, or a longer duration",
    ),
    (
        START + "load = -1\n",
        "transients[0].load",
        "-1 is out of range; a load factor is at least 0",
        "write a number, such as 0.5",
    ),
    (
        START + 'load_steps = [{ time = "1 s" }]\n',
        "transients[0].load_steps[0].factor",
        "missing key: a load step has its load factor",
        "add factor = 1",
    ),
    (
        START + "load_steps = [{ factor = 1 }]\n",
        "transients[0].load_steps[0]",
        "missing key: a load step waits for a time or for a speed of the crank",
        'add time = "3 s" or speed = "950 rpm"; load is the factor at the beginning',
    ),
    (
        START + 'load_steps = [{ factor = 1, time = "1 s", speed = "50 rpm" }]\n',
        "transients[0].load_steps[0].speed",
        "time and speed together: a load step waits for one of them",
        "remove one of them, or write two steps",
    ),
    (
        START + 'load_steps = [{ factor = 1, time = "2 s" }, { factor = 2, time = "1 s" }]\n',
        "transients[0].load_steps[1].time",
        "'1 s' does not come after '2 s'; load steps come in order",
        "put the steps in order",
    ),
    (
        START + 'load_steps = [{ factor = 1, time = "5 s" }]\n',
        "transients[0].load_steps[0].time",
        "'5 s' is not before the end of the motion, '5 s'",
        "write an earlier time, or a longer duration",
    ),
    (
        START + "load_steps = [{ factor = 1, speed = 950 }]\n",
        "transients[0].load_steps[0].speed",
        "950 without a unit is in rad/s, which is 9072 rpm",
        'write "950 rpm" or "950 rad/s"',
    ),
    (
        START + "load_steps = [5]\n",
        "transients[0].load_steps[0]",
        "5 is not a table",
        'write load_steps = [{ factor = 0.5, time = "3 s" }]',
    ),
    (
        START + "brake = {}\n",
        "transients[0].brake",
        "missing key: a brake has its moment",
        'add moment = "200 N*m", or viscous',
    ),
    (
        START + "brake = 200\n",
        "transients[0].brake",
        "200 is not a table",
        'write brake = { moment = "200 N*m", from = "2 s" }',
    ),
    (
        START + "brake = { moment = 0, viscous = 0 }\n",
        "transients[0].brake.moment",
        "0: this brake does not brake",
        'write "200 N*m", for example',
    ),
    (
        START + "brake = { moment = -5 }\n",
        "transients[0].brake.moment",
        "-5 is negative; a moment is at least 0",
        "write it without the minus",
    ),
    (
        START + 'brake = { moment = 5, from = "3 s", to = "2 s" }\n',
        "transients[0].brake.to",
        "'2 s' is not after the time from which it acts",
        "write a later time",
    ),
    (
        START + 'brake = { moment = 5, from = "1 min" }\n',
        "transients[0].brake.from",
        "'1 min' is not before the end of the motion, '5 s'",
        "write an earlier time, or a longer duration",
    ),
    (
        START + "brake = { moment = 5, mass = 1 }\n",
        "transients[0].brake.mass",
        "there is no mass 1",
        "without [[shafts]] it is 0",
    ),
    (
        START + "brake = { moment = 5, mass = 3 }\n" + FIRST + SHAFT,
        "transients[0].brake.mass",
        "there is no mass 3",
        "the masses are 0 (the rotor) to 2 (the crank)",
    ),
    (
        START + "brake = { moment = 5, ends = 3 }\n",
        "transients[0].brake.ends",
        "unknown key 'ends' in [transients.brake]",
        "the keys here are: moment, viscous, from, to, mass",
    ),
    (
        START + 'targets = "500 rpm"\n',
        "transients[0].targets",
        "'500 rpm' is not a list of speeds",
        'write targets = ["500 rpm"]',
    ),
    (
        START + 'targets = ["50 rpm", 500]\n',
        "transients[0].targets[1]",
        "500 without a unit is in rad/s, which is 4775 rpm",
        'write "500 rpm" or "500 rad/s"',
    ),
    (
        START + "end_angle = 3600\n",
        "transients[0].end_angle",
        "3600 without a unit is in radians, more than a full turn",
        'write "3600 deg" or "3600 rad"',
    ),
    (
        START + 'standstill = "hold"\n',
        "transients[0].standstill",
        '\'hold\' is not allowed here; the value is "stop" or "pass"',
        'write "stop" or "pass"',
    ),
    (
        START + 'method = "rk4"\n',
        "transients[0].method",
        "rk4 takes fixed steps; there is no step",
        'add step = "0.01 s"',
    ),
    (
        START + 'method = "BDF"\nstep = "1 ms"\n',
        "transients[0].step",
        "BDF controls its steps itself, it takes no step",
        'remove it, or write method = "merson" or "rk4"',
    ),
    (
        START + 'step = "1 ms"\n',
        "transients[0].step",
        "auto controls its steps itself, it takes no step",
        'remove it, or write method = "merson" or "rk4"',
    ),
    (
        START + "tolerance = 0.1\n",
        "transients[0].tolerance",
        "0.1 is out of range; a tolerance is at least 1e-13 and at most 0.01",
        "write a number, such as 1e-9",
    ),
    (
        START + 'name = "run"\n[[transients]]\nname = "run"\nduration = 5\n',
        "transients[1].name",
        "'run' is already the name of another transient motion (line 113)",
        "give each transient motion a name of its own",
    ),
    (
        START + 'name = "run -down"\n',
        "transients[0].name",
        "'run -down' cannot name a transient motion",
        "a name is words of Latin letters, digits, _ or ', with single spaces or hyphens between them",
    ),
]


@pytest.mark.parametrize(("added", "path", "message", "remedy"), FAULTS)
def test_one_slip_is_one_fault_at_its_line(
    shaper: str, faults_of: Faults, added: str, path: str, message: str, remedy: str
) -> None:
    text = f"{shaper}\n{added}"
    check_only_fault(text, faults_of(text), path, message, remedy)


@pytest.mark.parametrize(
    "added",
    [
        ROTOR + FIRST + SHAFT + "ratio = 6.6\n[transmission]\nratio = 26.4\n",
        ROTOR + "[[shafts]]\n",
        ROTOR + "[[shafts]]\nstiffness = 0\ndamping = 5\n",
        '[motor]\nname = "4A132S4"\n' + SHAFT,
        '[motor]\nname = "choose"\n' + SHAFT,
        FREE,
        FREE + 'start_speed = "-50 rpm"\nstandstill = "pass"\nend_speed = 0\n',
        FREE + 'from = "steady"\nbrake = { viscous = 5 }\n',
        START + "load_steps = [{ factor = 1, quiet = true }]\n",
        START + 'load_steps = [{ factor = 1, speed = "50 rpm" }, { factor = 2, time = "1 s" }]\n',
        START + 'method = "rk4"\nstep = "0.02 s"\n',
        START + 'method = "merson"\n',
        START + 'brake = { moment = 5, mass = 0, to = "9 s" }\n',
        START + "[[transients]]\nduration = 5\n",
    ],
)
def test_what_is_allowed(shaper: str, added: str) -> None:
    assert parse_spec(f"{shaper}\n{added}")
    assert parse_spec(TORQUE + added)


def test_a_driven_slider_has_no_motions_in_time(faults_of: Faults) -> None:
    (fault,) = faults_of((CONFIGS / "hydraulic-lift.toml").read_text(encoding="utf-8") + FREE)
    assert (fault.path, fault.message) == (
        "transients",
        'the input joint "A0" is prismatic; motions in time are those of a machine with a crank',
    )


def test_methods_are_those_of_the_machine_room() -> None:
    assert {*get_args(TransientTable.model_fields["method"].annotation)} == {*METHODS}


KEYS = {
    "shafts": "name stiffness damping ratio behind_gear inertia",
    "transients": "name duration start_speed from start_angle motor motor_on load load_steps brake targets end_speed "
    "end_angle standstill method step tolerance",
    "transients.load_steps": "factor time speed quiet",
    "transients.brake": "moment viscous from to mass",
}


@sparing(("table", "key"), [(table, key) for table, keys in KEYS.items() for key in keys.split()], every=6)
def test_no_value_breaks_the_checks(shaper: str, table: str, key: str) -> None:
    head = "[transients.brake]" if table.endswith("brake") else f"[[{table}]]"
    above = "[[transients]]\nduration = 5\n" if "." in table else ""
    for value in (*HOSTILE, '[["x", 1], [2]]', "[{ time = 1 }, 5]", "-0.0"):
        check_lines(f"{shaper}\n{ROTOR}{above}{head}\n{key} = {value}\n")


@pytest.mark.parametrize("table", ["shafts", "transients"])
def test_no_table_of_another_type_breaks_the_checks(faults_of: Faults, table: str) -> None:
    for value in (*HOSTILE, "[[], 5, {}]"):
        assert faults_of(f"{table} = {value}\nmotor = {value}\nmechanism = {value}\n")
