"""Every kind of fault in [vibrator] and [pendulum]: its place, its words, what to write instead."""

from __future__ import annotations

import pytest
from faults import Faults, check_fault

from tmmcalc.core.errors import SpecError
from tmmcalc.project import parse_spec
from vibration.tables.vibrationscenes import (
    DEVICE,
    EXCITER,
    FLATS,
    GRIPPER,
    HEAD,
    MOTOR,
    PLAIN,
    RING,
    ROD,
    RODS,
    UNBALANCE,
)

CURVE = '[vibrator.curve]\nfrom = "600 rpm"\nto = "3000 rpm"\n'
START = '[vibrator.start]\nacceleration = "300 rad/s^2"\nduration = "1.5 s"\n'
DRIVE = '[vibrator.drive]\nduration = "4 s"\n'
WHOLE = HEAD + DEVICE
HUNG = f"[pendulum]\n{ROD}"
SWING = '[pendulum.swing]\nduration = "2 s"\n'
CARRIER = f"{HUNG}{SWING}carrier = "

# the whole spec; then the path of its one fault, a piece of its message and of its remedy
FAULTS = [
    (WHOLE.replace(RING, ""), "vibrator.ring", "missing key: a device has its ring", "[vibrator.ring]"),
    (WHOLE.replace('drop = "40 mm"\n', ""), "vibrator.gripper.drop", "missing key", '"40 mm"'),
    (WHOLE.replace('"40 mm"', "40"), "vibrator.gripper.drop", "40 without a unit is in m", '"40 mm"'),
    (WHOLE.replace('mass = "1.2 kg"', "mass = 0"), "vibrator.ring.mass", "0 is zero", "for example"),
    (WHOLE + "[vibrator.rod]\n", "vibrator.rod", "unknown key 'rod'", "did you mean"),
    (
        HEAD + RING + GRIPPER + EXCITER.replace('inertia_vertical = "3e-4 kg*m^2"\n', "") + RODS + FLATS,
        "vibrator.exciter",
        "missing key: inertia_vertical, or inertia_axis and inertia_cross",
        "inertia_vertical =",
    ),
    (
        WHOLE.replace("inertia_vertical", 'inertia_axis = "2e-4 kg*m^2"\ninertia_vertical'),
        "vibrator.exciter.inertia_axis",
        "together with inertia_vertical",
        "remove",
    ),
    (WHOLE.replace('diameter = "3 mm"\n', ""), "vibrator.rods", "missing key: stiffness, or diameter", "diameter ="),
    (
        WHOLE.replace('diameter = "3 mm"\n', 'stiffness = "19 N/mm"\n'),
        "vibrator.rods.length",
        "together with stiffness",
        "remove length, or stiffness",
    ),
    (WHOLE.replace('width = "12 mm"\n', ""), "vibrator.flats", "missing key: vertical and tilt, or width", "width ="),
    (
        WHOLE.replace(FLATS, '[vibrator.flats]\nvertical = "47 N/mm"\n'),
        "vibrator.flats",
        "vertical alone; tilt is not known without",
        "add tilt, or width",
    ),
    (
        WHOLE.replace(FLATS, FLATS + 'vertical = "47 N/mm"\ntilt = "130 N*m/rad"\n'),
        "vibrator.flats.width",
        "width together with vertical and tilt",
        "remove",
    ),
    (WHOLE + "[vibrator.damping]\nratio = 1.2\n", "vibrator.damping.ratio", "out of range", "0.02"),
    (WHOLE + "[vibrator.damping]\nratio = 0.1\nz = 2\n", "vibrator.damping.ratio", "ratio together with z", "remove"),
    (WHOLE + "[vibrator.unbalance]\n", "vibrator.unbalance", "missing key: an unbalance is a mass", "200 g*mm"),
    (
        WHOLE + UNBALANCE + 'mass = "3 g"\n',
        "vibrator.unbalance.moment",
        "moment together with mass",
        "remove it, or remove mass",
    ),
    (WHOLE + CURVE, "vibrator.curve", "without [vibrator.unbalance]: nothing excites", "add [vibrator.unbalance]"),
    (
        WHOLE + UNBALANCE + CURVE.replace("3000", "300"),
        "vibrator.curve.to",
        "the curve ends before it begins",
        "above from",
    ),
    (WHOLE.replace(HEAD, "") + UNBALANCE + START, "vibrator", "missing key: [vibrator.start] runs up", "1450 rpm"),
    (WHOLE.replace('"1450 rpm"', "1450"), "vibrator.speed", "1450 without a unit is in rad/s", '"1450 rpm"'),
    (WHOLE + UNBALANCE + DRIVE, "vibrator.drive", "without [motor]: nothing turns the rotor", "add [motor]"),
    (
        WHOLE + UNBALANCE.replace("rotor_inertia", "#") + DRIVE + MOTOR,
        "vibrator.unbalance",
        "missing key: a rotor that speeds up",
        "rotor_inertia",
    ),
    (WHOLE + '[vibrator.points]\nA = ["1 mm", 0]\n', "vibrator.points.A", "is not a list of 3 values", "-80 mm"),
    # the pendulum
    ("[pendulum]\nspin = 3\n", "pendulum.rod", "missing key: a pendulum hangs on a rod", "[pendulum.rod]"),
    (HUNG.replace('diameter = "12 mm"\n', ""), "pendulum.rod", "missing key: a rod has a section", "diameter"),
    (
        HUNG + "bending_stiffness = 20\n",
        "pendulum.rod.bending_stiffness",
        "a round section together with a stiffness",
        "remove one",
    ),
    (HUNG.replace("diameter", "width"), "pendulum.rod", "missing key: width without thickness", "thickness ="),
    (
        f"[pendulum]\n{PLAIN}".replace('mass = "0.8 kg"\n', ""),
        "pendulum.rod",
        "missing key: a rod without a section has its mass",
        '"0.7 kg"',
    ),
    (HUNG + 'bore = "12 mm"\n', "pendulum.rod.bore", "leaves nothing", "smaller"),
    (f"[pendulum]\n{PLAIN}bore = 0.001\n", "pendulum.rod.bore", "bore without diameter", "add diameter"),
    (
        f"[pendulum]\n{PLAIN}".replace("200", "[1, 2, 3]"),
        "pendulum.rod.bending_stiffness",
        "3 values: there are two planes",
        "one for each plane",
    ),
    (
        f"[pendulum]\nspin = 30\n{PLAIN}".replace("200", "[20, 30]"),
        "pendulum.spin",
        "differs in its two planes",
        "round",
    ),
    (
        HUNG + '[pendulum.disc]\nmass = 1\ngyration = "30 mm"\npolar_inertia = 0.1\n',
        "pendulum.disc.gyration",
        "gyration together with polar_inertia",
        "remove it",
    ),
    (
        HUNG + "[pendulum.disc]\nmass = 1\npolar_inertia = 0.1\n",
        "pendulum.disc",
        "polar_inertia without diametral_inertia",
        "diametral_inertia =",
    ),
    (HUNG.replace("[pendulum]\n", "[pendulum]\ngravity = 0\n"), "pendulum.gravity", "turns freely", "clamped"),
    (
        HUNG.replace("[pendulum]\n", '[pendulum]\nstiffness = "clampd"\n'),
        "pendulum.stiffness",
        "'clampd'",
        'did you mean "clamped"',
    ),
    (
        HUNG.replace("[pendulum]\n", '[pendulum]\nstiffness = "clamped"\n') + SWING + 'tilt = "1 deg"\n',
        "pendulum.swing.tilt",
        "a clamped rod does not turn",
        "deflection",
    ),
    (HUNG.replace("[pendulum]\n", "[pendulum]\ndegree = 5\n"), "pendulum.degree", "without elements", "elements = 20"),
    (
        HUNG.replace("[pendulum]\n", "[pendulum]\nelements = 50\ndegree = 5\n"),
        "pendulum.elements",
        "200 functions, more than 120",
        "write fewer",
    ),
    (
        HUNG + '[pendulum.speeds]\nfrom = "90 rpm"\nto = "80 rpm"\n',
        "pendulum.speeds.to",
        "ends before it begins",
        "above from",
    ),
    (HUNG.replace("[pendulum]\n", "[pendulum]\nspin = 1500\n"), "pendulum.spin", "is in rad/s", '"1500 rpm"'),
    (HUNG + SWING, "pendulum.swing", "missing key: nothing sets the pendulum in motion", "tilt"),
    (HUNG + SWING + "tilt = 3\n", "pendulum.swing.tilt", "3 without a unit is in rad", '"3 deg"'),
    (CARRIER + "{ time = [0, 1] }\n", "pendulum.swing.carrier", "missing key: a carrier that moves", "x ="),
    (CARRIER + "{ time = [1, 2], x = [0, 1] }\n", "pendulum.swing.carrier.time[0]", "begin at 0", "write 0"),
    (CARRIER + "{ time = [0, 2, 1], x = [0, 1, 1] }\n", "pendulum.swing.carrier.time[2]", "times ascend", "order"),
    (
        CARRIER + "{ time = [0, 2], x = [0, 1, 1] }\n",
        "pendulum.swing.carrier.x",
        "3 speeds for 2 times",
        "one for each",
    ),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS, ids=[f[1] + " " + f[2] for f in FAULTS])
def test_one_fault_each(text: str, path: str, message: str, remedy: str) -> None:
    check_fault(text, path, message, remedy)


def test_faults_come_all_at_once(faults_of: Faults) -> None:
    found = faults_of(WHOLE.replace('"40 mm"', "40").replace('diameter = "3 mm"\n', "") + CURVE)
    assert [fault.path for fault in found] == ["vibrator.gripper.drop", "vibrator.rods", "vibrator.curve"]


def test_a_motor_belongs_to_a_device_as_well(faults_of: Faults) -> None:
    (fault,) = faults_of(f"{HUNG}{MOTOR}")
    assert fault.path == "motor"


def test_an_unbalance_that_spins_sets_the_pendulum_in_motion() -> None:
    spun = HUNG.replace("[pendulum]\n", "[pendulum]\nspin = 30\n")
    disc = '[pendulum.disc]\nmass = 1\neccentricity = "1 mm"\n'
    assert parse_spec(spun + disc + SWING).pendulum is not None
    with pytest.raises(SpecError):
        parse_spec(HUNG + disc + SWING)
