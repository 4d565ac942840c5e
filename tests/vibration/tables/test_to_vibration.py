"""From [vibrator] and [pendulum] to what is asked: every key, defaults, the ready specs."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable
from typing import Any

import pytest
from project.scenes import CONFIGS
from project.test_schema import accepts
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project import load_spec, parse_spec
from tmmcalc.vibration.pendulum.task import Disc, Mesh, PendulumTask
from tmmcalc.vibration.tables import pendulum as pendulum_tables
from tmmcalc.vibration.tables import vibrator as vibrator_tables
from tmmcalc.vibration.tables.tasks.vibration import to_pendulum, to_vibrator
from tmmcalc.vibration.vibrator.task import Damping, VibratorTask
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

DEGREE = math.pi / 180
RPM = math.pi / 30
START = '[vibrator.start]\nacceleration = "300 rad/s^2"\nduration = "1.5 s"\n'
DRIVE = '[vibrator.drive]\nduration = "4 s"\n'
CURVE = '[vibrator.curve]\nfrom = "600 rpm"\nto = "3000 rpm"\n'


def device(text: str = "", base: str = DEVICE, head: str = HEAD) -> VibratorTask:
    return to_vibrator(parse_spec(head + base + text))


def rotor(text: str = "", rod: str = ROD, head: str = "[pendulum]\n") -> PendulumTask:
    return to_pendulum(parse_spec(head + rod + text))


def given(**keys: str) -> Callable[[], VibratorTask]:
    """The device with parts replaced, such as ``rods='stiffness = 1'``."""
    parts = {"ring": RING, "gripper": GRIPPER, "exciter": EXCITER, "rods": RODS, "flats": FLATS}
    head, rest = keys.pop("head", HEAD), keys.pop("rest", "")
    for name, text in keys.items():
        parts[name] = text if text.startswith("[") else parts[name] + text
    return lambda: device(rest, "".join(parts.values()), head)


RODS_BY_C = '[vibrator.rods]\nradius = "70 mm"\nstiffness = "19 N/mm"\n'
FLATS_BY_C = '[vibrator.flats]\nvertical = "47 N/mm"\ntilt = "130 N*m/rad"\n'
TENSOR = EXCITER.replace("inertia_vertical", 'inertia_axis = "2e-4 kg*m^2"\ninertia_cross')
SMALL = '[vibrator.unbalance]\nmass = "20 g"\nradius = "10 mm"\n'

# key: how it is written, what is read, the value
DEVICES: dict[str, tuple[Callable[[], VibratorTask], Callable[[VibratorTask], Any], Any]] = {
    "gravity": (given(head=HEAD + 'gravity = "9.8 m/s^2"\n'), lambda t: t.gravity, 9.8),
    "speed": (device, lambda t: t.speed, 1450 * RPM),
    "points": (given(rest='[vibrator.points]\nA = ["20 mm", 0, "-80 mm"]\n'), lambda t: t.points[0][1][2], -0.08),
    "ring.mass": (device, lambda t: t.ring.mass, 1.2),
    "ring.inertia": (device, lambda t: t.ring.inertia, 2e-3),
    "gripper.mass": (device, lambda t: t.gripper.mass, 0.9),
    "gripper.drop": (device, lambda t: t.gripper.drop, 0.04),
    "gripper.inertia_x": (device, lambda t: t.gripper.inertia_x, 8e-4),
    "gripper.inertia_y": (device, lambda t: t.gripper.inertia_y, 7e-4),
    "gripper.inertia_z": (device, lambda t: t.gripper.inertia_z, 4e-4),
    "exciter.mass": (device, lambda t: t.exciter.mass, 0.5),
    "exciter.radius": (device, lambda t: t.exciter.radius, 0.06),
    "exciter.arm": (device, lambda t: t.exciter.arm, 0.05),
    "exciter.arm_angle": (device, lambda t: t.exciter.arm_angle, 30 * DEGREE),
    "exciter.inertia_hinge": (device, lambda t: t.exciter.inertia_hinge, 2.5e-4),
    "exciter.inertia_vertical": (device, lambda t: t.exciter.inertia_z, 3e-4),
    "exciter.inertia_axis": (given(exciter=TENSOR), lambda t: t.exciter.inertia_z, 2.5e-4),
    "exciter.inertia_cross": (given(exciter=TENSOR.replace("3e-4", "4e-4")), lambda t: t.exciter.inertia_z, 3e-4),
    "exciter.stiffness": (device, lambda t: t.plate, 60.0),
    "rods.radius": (device, lambda t: t.rods.radius, 0.07),
    "rods.stiffness": (given(rods=RODS_BY_C), lambda t: t.rods.stiffness, 19e3),
    "rods.diameter": (device, lambda t: t.rods.diameter, 0.003),
    "rods.length": (device, lambda t: t.rods.length, 0.08),
    "rods.young": (given(rods='young = "200000 MPa"\n'), lambda t: t.rods.young, 2e11),
    "flats.vertical": (given(flats=FLATS_BY_C), lambda t: t.flats.vertical, 47e3),
    "flats.tilt": (given(flats=FLATS_BY_C), lambda t: t.flats.tilt, 130.0),
    "flats.width": (device, lambda t: t.flats.width, 0.012),
    "flats.thickness": (device, lambda t: t.flats.thickness, 8e-4),
    "flats.length": (device, lambda t: t.flats.length, 0.03),
    "flats.offset": (given(flats='offset = "20 mm"\n'), lambda t: t.flats.offset, 0.02),
    "flats.young": (given(flats='young = "200000 MPa"\n'), lambda t: t.flats.young, 2e11),
    "flats.shear_modulus": (given(flats='shear_modulus = "80000 MPa"\n'), lambda t: t.flats.shear, 8e10),
    "flats.torsion": (given(flats="torsion = 0.333\n"), lambda t: t.flats.torsion, 0.333),
    "damping.ratio": (given(rest="[vibrator.damping]\nratio = 0.02\n"), lambda t: t.damping, Damping(0.02)),
    **{
        f"damping.{name}": (
            given(rest=f"[vibrator.damping]\n{name} = 0.5\n"),
            lambda t, k=k: t.damping.direct[k],
            0.5,
        )
        for k, name in enumerate(("x", "y", "phi", "tilt_x", "tilt_y", "z", "gamma"))
    },
    "unbalance.moment": (given(rest=UNBALANCE), lambda t: t.unbalance.moment, 2e-4),
    "unbalance.mass": (given(rest=SMALL), lambda t: t.unbalance.moment, 0.02 * 0.01),
    "unbalance.radius": (given(rest=SMALL.replace("10 mm", "20 mm")), lambda t: t.unbalance.moment, 0.02 * 0.02),
    "unbalance.distance": (given(rest=UNBALANCE + 'distance = "75 mm"\n'), lambda t: t.unbalance.radius, 0.075),
    "unbalance.arm": (given(rest=UNBALANCE + 'arm = "45 mm"\n'), lambda t: t.unbalance.arm, 0.045),
    "unbalance.arm_angle": (
        given(rest=UNBALANCE + 'arm_angle = "-20 deg"\n'),
        lambda t: t.unbalance.arm_angle,
        -20 * DEGREE,
    ),
    "unbalance.rotor_inertia": (given(rest=UNBALANCE), lambda t: t.unbalance.rotor, 2e-4),
    "curve.low": (given(rest=UNBALANCE + CURVE), lambda t: t.curve.low, 600 * RPM),
    "curve.high": (given(rest=UNBALANCE + CURVE), lambda t: t.curve.high, 3000 * RPM),
    "curve.points": (given(rest=UNBALANCE + CURVE + "points = 50\n"), lambda t: t.curve.points, 50),
    "start.acceleration": (given(rest=UNBALANCE + START), lambda t: t.run_up.acceleration, 300.0),
    "start.duration": (given(rest=UNBALANCE + START), lambda t: t.run_up.duration, 1.5),
    "start.rows": (given(rest=UNBALANCE + START + "rows = 200\n"), lambda t: t.run_up.rows, 200),
    "start.tangential": (given(rest=UNBALANCE + START + "tangential = false\n"), lambda t: t.run_up.tangential, False),
    "drive.duration": (given(rest=UNBALANCE + MOTOR + DRIVE), lambda t: t.drive.duration, 4.0),
    "drive.drag": (given(rest=UNBALANCE + MOTOR + DRIVE + "drag = 1e-5\n"), lambda t: t.drive.drag, 1e-5),
    "drive.initial_speed": (
        given(rest=UNBALANCE + MOTOR + DRIVE + 'initial_speed = "300 rpm"\n'),
        lambda t: t.drive.initial,
        300 * RPM,
    ),
    "drive.rows": (given(rest=UNBALANCE + MOTOR + DRIVE + "rows = 300\n"), lambda t: t.drive.rows, 300),
}

SWING = '[pendulum.swing]\nduration = "8 s"\ntilt = "1 deg"\n'
DISC = '[pendulum.disc]\nmass = "4 kg"\n'
MOVED = SWING + 'carrier = { time = [0, "2 s"], x = [0, "0.5 m/s"], y = [0, 0.1], up = [0.2, 0] }\n'
AREA, SECOND = math.pi * 0.012**2 / 4, math.pi * 0.012**4 / 64
FLAT = '[pendulum.rod]\nlength = "1 m"\nwidth = "20 mm"\nthickness = "5 mm"\n'


def hung(text: str = "", rod: str = ROD, head: str = "") -> Callable[[], PendulumTask]:
    return lambda: rotor(text, rod, f"[pendulum]\n{head}")


PENDULUMS: dict[str, tuple[Callable[[], PendulumTask], Callable[[PendulumTask], Any], Any]] = {
    "gravity": (hung(head="gravity = 9.8\n"), lambda t: t.gravity, 9.8),
    "stiffness": (hung(head='stiffness = "clamped"\n'), lambda t: t.pivot, None),
    "spin": (hung(head='spin = "-900 rpm"\n'), lambda t: t.spin, -900 * RPM),
    "modes": (hung(head="modes = 6\n"), lambda t: t.modes, 6),
    "elements": (hung(head="elements = 20\n"), lambda t: t.mesh, Mesh(20, 3)),
    "degree": (hung(head="elements = 2\ndegree = 7\n"), lambda t: t.mesh, Mesh(2, 7)),
    "rod.length": (rotor, lambda t: t.rod.length, 0.8),
    "rod.mass": (hung(rod=ROD + 'mass = "2 kg"\n'), lambda t: t.rod.density, 2.5),
    "rod.diameter": (rotor, lambda t: t.rod.bending, (206e9 * SECOND,) * 2),
    "rod.bore": (hung(rod=ROD + 'bore = "6 mm"\n'), lambda t: t.rod.density, 7850 * AREA * 0.75),
    "rod.width": (hung(rod=FLAT), lambda t: t.rod.bending[0], 206e9 * 5e-3 * 0.02**3 / 12),
    "rod.thickness": (hung(rod=FLAT), lambda t: t.rod.radius[1], 0.005 / math.sqrt(12)),
    "rod.bending_stiffness": (
        hung(rod=PLAIN.replace("200", "[200, 30]")),
        lambda t: (t.rod.bending, t.rod.radius, t.rod.torsion),
        ((200.0, 30.0), (0.0, 0.0), None),
    ),
    "rod.torsion_stiffness": (hung(rod=PLAIN + "torsion_stiffness = 90\n"), lambda t: t.rod.torsion, 90.0),
    "rod.section_radius": (hung(rod=PLAIN + 'section_radius = "4 mm"\n'), lambda t: t.rod.radius, (0.004,) * 2),
    "rod.density": (hung(rod=ROD + "density = 2700\n"), lambda t: t.rod.density, 2700 * AREA),
    "rod.young": (hung(rod=ROD + "young = 7e10\n"), lambda t: t.rod.bending, (7e10 * SECOND,) * 2),
    "rod.shear_modulus": (hung(rod=ROD + "shear_modulus = 3e10\n"), lambda t: t.rod.torsion, 6e10 * SECOND),
    "disc.mass": (hung(DISC), lambda t: t.disc, Disc(4.0)),
    "disc.gyration": (hung(DISC + 'gyration = "50 mm"\n'), lambda t: t.disc.diametral, (0.01, 0.01)),
    "disc.diametral_inertia": (hung(DISC + "diametral_inertia = 0.3\n"), lambda t: t.disc, Disc(4.0, (0.3, 0.3), 0.6)),
    "disc.polar_inertia": (
        hung(DISC + "diametral_inertia = 0.3\npolar_inertia = 0.1\n"),
        lambda t: t.disc.polar,
        0.1,
    ),
    "disc.eccentricity": (hung(DISC + 'eccentricity = "0.2 mm"\n'), lambda t: t.disc.eccentricity, 2e-4),
    "speeds.low": (hung('[pendulum.speeds]\nfrom = "60 rpm"\nto = "900 rpm"\n'), lambda t: t.speeds.low, 60 * RPM),
    "speeds.high": (hung('[pendulum.speeds]\nto = "900 rpm"\n'), lambda t: t.speeds.high, 900 * RPM),
    "speeds.points": (hung('[pendulum.speeds]\nto = "900 rpm"\npoints = 9\n'), lambda t: t.speeds.points, 9),
    "swing.duration": (hung(SWING), lambda t: t.swing.duration, 8.0),
    "swing.rows": (hung(SWING + "rows = 99\n"), lambda t: t.swing.rows, 99),
    "swing.tilt": (hung(SWING), lambda t: t.swing.tilt, DEGREE),
    "swing.deflection": (hung(SWING + 'deflection = "-5 mm"\n'), lambda t: t.swing.deflection, -0.005),
    "swing.push": (hung(SWING + 'push = "0.2 m/s"\n'), lambda t: t.swing.push, 0.2),
    "swing.carrier": (hung(MOVED), lambda t: len(t.swing.times), 2),
    "swing.carrier.time": (hung(MOVED), lambda t: t.swing.times, (0.0, 2.0)),
    "swing.carrier.x": (hung(MOVED), lambda t: t.swing.x, (0.0, 0.5)),
    "swing.carrier.y": (hung(MOVED), lambda t: t.swing.y, (0.0, 0.1)),
    "swing.carrier.up": (hung(MOVED), lambda t: t.swing.up, (0.2, 0.0)),
}
PARTS = ("ring", "gripper", "exciter", "rods", "flats", "damping", "unbalance", "curve", "start", "drive", "points")


@pytest.mark.parametrize("key", DEVICES)
def test_every_key_of_a_device(key: str) -> None:
    make, read, value = DEVICES[key]
    assert read(make()) == (value if not isinstance(value, float) else pytest.approx(value, rel=1e-14))


@pytest.mark.parametrize("key", PENDULUMS)
def test_every_key_of_a_pendulum(key: str) -> None:
    make, read, value = PENDULUMS[key]
    if isinstance(value, float) or (isinstance(value, tuple) and isinstance(value[0], float)):
        value = pytest.approx(value, rel=1e-14)
    assert read(make()) == value


def test_no_key_is_left_out() -> None:
    tables = {
        "ring": vibrator_tables.RingTable,
        "gripper": vibrator_tables.GripperTable,
        "exciter": vibrator_tables.ExciterTable,
        "rods": vibrator_tables.RodsTable,
        "flats": vibrator_tables.FlatsTable,
        "damping": vibrator_tables.VibratorDampingTable,
        "unbalance": vibrator_tables.VibratorUnbalanceTable,
        "curve": vibrator_tables.VibratorCurveTable,
        "start": vibrator_tables.VibratorStartTable,
        "drive": vibrator_tables.VibratorDriveTable,
    }
    own = {f"{name}.{key}" for name, table in tables.items() for key in table.model_fields}
    top = {key for key in vibrator_tables.VibratorTable.model_fields if key not in tables}
    assert own | top == set(DEVICES)
    parts = {
        "rod": pendulum_tables.PendulumRodTable,
        "disc": pendulum_tables.DiscTable,
        "speeds": pendulum_tables.PendulumSpeedsTable,
        "swing": pendulum_tables.SwingTable,
        "swing.carrier": pendulum_tables.CarrierTable,
    }
    own = {f"{name}.{key}" for name, table in parts.items() for key in table.model_fields}
    top = {key for key in pendulum_tables.PendulumTable.model_fields if key not in parts}
    assert own | top == set(PENDULUMS)


def test_defaults_of_the_unbalance_are_the_exciters_own() -> None:
    task = device(UNBALANCE)
    assert (task.unbalance.radius, task.unbalance.arm, task.unbalance.arm_angle) == (0.06, 0.05, task.exciter.arm_angle)
    assert device(UNBALANCE.replace("rotor_inertia", "#")).unbalance.rotor == 0.0
    motor = MOTOR + 'inertia = "3e-4 kg*m^2"\n'
    assert device(UNBALANCE.replace("rotor_inertia", "#") + motor).unbalance.rotor == 3e-4


def test_a_motor_that_is_to_be_chosen_drives_nothing() -> None:
    with pytest.raises(UsageError, match="needs one that is known"):
        device(UNBALANCE + DRIVE + '[motor]\nname = "choose"\n')


def test_a_spec_without_the_tables() -> None:
    bare = parse_spec(f"[pendulum]\n{ROD}")
    with pytest.raises(UsageError, match=r"no \[vibrator\]"):
        to_vibrator(bare)
    with pytest.raises(UsageError, match=r"no \[pendulum\]"):
        to_pendulum(parse_spec(HEAD + DEVICE))


@sparing("name", ["vibratory-device", "pendulum-rotor"], every=2)
def test_the_ready_specs(name: str, schema: dict[str, Any]) -> None:
    spec = load_spec(CONFIGS / f"{name}.toml")
    task = to_vibrator(spec) if spec.vibrator is not None else to_pendulum(spec)
    assert content_hash(task) == content_hash(task)
    assert accepts(schema, tomllib.loads((CONFIGS / f"{name}.toml").read_text()), schema)
