"""From ``[vibrator]`` and ``[pendulum]`` to what is asked of them."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.vibration.pendulum.task import Disc, Mesh, PendulumTask, Speeds, Swing
from tmmcalc.vibration.pendulum.task import Rod as PendulumRod
from tmmcalc.vibration.vibrator.task import (
    COORDINATES,
    Damping,
    Drive,
    Exciter,
    Flats,
    Gripper,
    Range,
    Ring,
    Rods,
    RunUp,
    Unbalance,
    VibratorTask,
)

if TYPE_CHECKING:
    from tmmcalc.vibration.room import VibrationTables
    from tmmcalc.vibration.tables.pendulum import DiscTable, PendulumRodTable, SwingTable
    from tmmcalc.vibration.tables.vibrator import ExciterTable, FlatsTable, VibratorDampingTable, VibratorTable

CLAMPED = "clamped"


def to_vibrator(spec: VibrationTables) -> VibratorTask:
    """The device of the spec; raises `UsageError` if it has none, or asks for a start by a motor that it has not."""
    table = spec.vibrator
    if table is None:
        raise UsageError("the spec has no [vibrator]", remedy="add [vibrator] with its bodies and springs")
    ring, gripper, rods = table.ring, table.gripper, table.rods
    curve, start = table.curve, table.start
    return VibratorTask(
        ring=Ring(ring.mass, ring.inertia),
        gripper=Gripper(gripper.mass, gripper.drop, gripper.inertia_x, gripper.inertia_y, gripper.inertia_z),
        exciter=_exciter(table.exciter),
        rods=Rods(rods.radius, rods.stiffness, rods.diameter or 0.0, rods.length or 0.0, rods.young),
        flats=_flats(table.flats),
        plate=table.exciter.stiffness,
        gravity=table.gravity,
        damping=_damping(table.damping),
        unbalance=_unbalance(spec, table),
        speed=table.speed,
        curve=None if curve is None else Range(curve.low, curve.high, curve.points),
        run_up=None if start is None else RunUp(start.acceleration, start.duration, start.rows, start.tangential),
        drive=_drive(spec, table),
        points=tuple((name, (at[0], at[1], at[2])) for name, at in table.points.items()),
    )


def _exciter(table: ExciterTable) -> Exciter:
    if table.inertia_vertical is not None:
        vertical = table.inertia_vertical
    else:  # the motor's axis is inclined by 45 deg
        vertical = ((table.inertia_axis or 0.0) + (table.inertia_cross or 0.0)) / 2
    return Exciter(table.mass, table.radius, table.arm, table.arm_angle, table.inertia_hinge, vertical)


def _flats(table: FlatsTable) -> Flats:
    return Flats(
        vertical=table.vertical,
        tilt=table.tilt,
        width=table.width or 0.0,
        thickness=table.thickness or 0.0,
        length=table.length or 0.0,
        offset=table.offset,
        young=table.young,
        shear=table.shear_modulus,
        torsion=table.torsion,
    )


def _damping(table: VibratorDampingTable) -> Damping:
    if table.ratio is not None:
        return Damping(table.ratio)
    return Damping(0.0, tuple(getattr(table, name) for name in COORDINATES))


def _unbalance(spec: VibrationTables, table: VibratorTable) -> Unbalance | None:
    """The unbalance; by default it turns about the exciter's centre of mass."""
    given, exciter = table.unbalance, table.exciter
    if given is None:
        return None
    rotor = given.rotor_inertia
    if rotor is None:
        rotor = _motor_inertia(spec)
    return Unbalance(
        moment=given.moment if given.moment is not None else (given.mass or 0.0) * (given.radius or 0.0),
        radius=exciter.radius if given.distance is None else given.distance,
        arm=exciter.arm if given.arm is None else given.arm,
        arm_angle=exciter.arm_angle if given.arm_angle is None else given.arm_angle,
        rotor=rotor,
    )


def _motor_inertia(spec: VibrationTables) -> float:
    if spec.motor is None or spec.mechanism is not None or spec.torque is not None:
        return 0.0
    from tmmcalc.machine.tables.tasks.machine import to_motor

    choice = to_motor(spec)
    return 0.0 if choice is None or choice.motor is None else choice.motor.inertia or 0.0


def _drive(spec: VibrationTables, table: VibratorTable) -> Drive | None:
    if table.drive is None:
        return None
    from tmmcalc.machine.tables.tasks.machine import to_motor

    choice = to_motor(spec)
    if choice is None or choice.motor is None:
        raise UsageError(
            "the start by a motor needs one that is known",
            where="vibrator.drive",
            remedy='write the data of [motor], or its name in the catalogue, in place of name = "choose"',
        )
    drive = table.drive
    return Drive(choice.motor, choice.characteristic, drive.duration, drive.drag, drive.initial_speed, drive.rows)


def to_pendulum(spec: VibrationTables) -> PendulumTask:
    """The pendulum-rotor of the spec; raises `UsageError` if it has none."""
    table = spec.pendulum
    if table is None:
        raise UsageError("the spec has no [pendulum]", remedy="add [pendulum.rod] with length and diameter")
    speeds = table.speeds
    return PendulumTask(
        rod=_rod(table.rod),
        disc=Disc() if table.disc is None else _disc(table.disc),
        pivot=None if table.stiffness == CLAMPED else float(table.stiffness),
        gravity=table.gravity,
        spin=table.spin,
        modes=table.modes,
        speeds=None if speeds is None else Speeds(speeds.low, speeds.high, speeds.points),
        swing=None if table.swing is None else _swing(table.swing),
        mesh=Mesh(table.elements, table.degree),
    )


def _pair(values: list[float]) -> tuple[float, float]:
    """One value for both planes, or one for each."""
    return values[0], values[-1]


def _rod(table: PendulumRodTable) -> PendulumRod:
    """Stiffness and mass of the rod, given or from its section."""
    area, second, polar = _section(table)
    density = table.mass / table.length if table.mass is not None else table.density * area
    if table.bending_stiffness is not None:
        bending = _pair(table.bending_stiffness)
    else:
        bending = (table.young * second[0], table.young * second[1])
    if table.section_radius is not None:
        radius = _pair(table.section_radius)
    else:
        radius = ((second[0] / area) ** 0.5, (second[1] / area) ** 0.5) if area else (0.0, 0.0)
    torsion = table.torsion_stiffness if table.torsion_stiffness is not None else table.shear_modulus * polar or None
    return PendulumRod(table.length, density, bending, radius, torsion)


def _section(table: PendulumRodTable) -> tuple[float, tuple[float, float], float]:
    """Area [m^2], second moments for bending in xz and in yz, and of torsion [m^4]; zeros without a section."""
    if table.diameter is not None:
        outer, inner = table.diameter, table.bore
        second = pi * (outer**4 - inner**4) / 64
        return pi * (outer**2 - inner**2) / 4, (second, second), 2 * second
    if table.width is not None and table.thickness is not None:
        from tmmcalc.vibration.vibrator.springs import torsion_coefficient

        b, h = table.width, table.thickness
        return b * h, (h * b**3 / 12, b * h**3 / 12), torsion_coefficient(b, h) * b * h**3
    return 0.0, (0.0, 0.0), 0.0


def _disc(table: DiscTable) -> Disc:
    if table.gyration is not None:
        first, second = (table.mass * radius**2 for radius in _pair(table.gyration))
        return Disc(table.mass, (first, second), first + second, table.eccentricity)
    diametral = _pair(table.diametral_inertia) if table.diametral_inertia is not None else (0.0, 0.0)
    polar = sum(diametral) if table.polar_inertia is None else table.polar_inertia
    return Disc(table.mass, diametral, polar, table.eccentricity)


def _swing(table: SwingTable) -> Swing:
    carrier = table.carrier
    moved = {} if carrier is None else {name: tuple(getattr(carrier, name) or ()) for name in ("x", "y", "up")}
    return Swing(
        duration=table.duration,
        rows=table.rows,
        tilt=table.tilt,
        deflection=table.deflection,
        push=table.push,
        times=() if carrier is None else tuple(carrier.time),
        **moved,
    )
