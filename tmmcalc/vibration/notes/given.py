"""What is given of a vibratory device: its bodies and springs, what excites it, its starts, the points of the part."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.machine.notes.motors import called, plate, points_of
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Paragraph
from tmmcalc.report.telling import data_of
from tmmcalc.vibration.vibrator.task import Drive, RunUp, VibratorTask


def whole(task: VibratorTask) -> Iterator[Block]:
    """All that is given: the bodies with their coordinates, the axes, then the numbers."""
    yield Paragraph(
        tr(
            "The device has a ring on four rods, a gripper with the part that hangs in the ring on four crossed flat "
            "springs, and an exciter, whose motor with the unbalance sits on an elastic plate; the axis of the motor "
            "is inclined by 45°. Its seven coordinates are the displacements $q_1 = x$, $q_2 = y$ of the ring and its "
            "turn $q_3 = phi$ about the vertical, the tilts $q_4 = theta_x$, $q_5 = theta_y$ of the gripper about the "
            "horizontal axes and its vertical displacement $q_6 = z$, the turn $q_7 = gamma$ of the exciter about its "
            "hinge."
        )
    )
    yield Paragraph(
        tr(
            "The axes $x$, $y$ run along the flat springs, $z$ upwards. The hinge is a horizontal line across the "
            "bisector of $x$ and $y$, along which is the projection of the axis of the motor."
        )
    )
    yield from _bodies(task)
    if task.curve is not None:
        said = tr("speeds between which the resonance curve is sought")
        yield Datum(said, ("Omega_{min}", "Omega_{max}"), (task.curve.low, task.curve.high), "rad/s")
    if task.run_up is not None:
        yield from _run_up(task.run_up)
    if task.drive is not None:
        yield from _drive(task.drive)
    for name, at in task.points:
        said = tr("point {point} of the part at rest, from the axis in the plane of the flat springs", point=name)
        yield Datum(said, (f"x_{{{name}}}", f"y_{{{name}}}", f"z_{{{name}}}"), at, "m")


def _run_up(asked: RunUp) -> Iterator[Datum]:
    said = tr("start with a given angle: constant angular acceleration of the rotor up to its speed")
    yield Datum(said, ("eps",), (asked.acceleration,), "rad/s^2")
    yield Datum(tr("time of this start"), ("t_e",), (asked.duration,), "s")
    pull = tr("centrifugal force and pull along its path") if asked.tangential else tr("centrifugal force alone")
    yield Datum(tr("what of the unbalance is counted while the rotor speeds up"), text=pull)


def _drive(asked: Drive) -> Iterator[Datum]:
    """The start by the motor, with what the plate of the motor says."""
    yield Datum(tr("start by the motor: what drives the rotor"), text=called(asked.kind))
    known = plate(asked.motor)
    yield from data_of(known, known)
    yield from points_of(asked.motor)
    yield Datum(tr("speed of the rotor at the beginning of this start"), ("omega_0",), (asked.initial,), "rad/s")
    yield Datum(tr("drag of bearings and air over the speed"), ("d_r",), (asked.drag,), "N*m*s/rad")
    yield Datum(tr("time of the start by the motor"), ("t_d",), (asked.duration,), "s")


def _bodies(task: VibratorTask) -> Iterator[Datum]:
    """The bodies and what joins them, damping, the unbalance and its speed."""
    ring, gripper, exciter, rods = task.ring, task.gripper, task.exciter, task.rods
    inertia = "kg*m^2"
    yield Datum(tr("mass of the ring"), ("m_1",), (ring.mass,), "kg")
    yield Datum(tr("moment of inertia of the ring about the vertical"), ("J_z1",), (ring.inertia,), inertia)
    yield Datum(tr("mass of the gripper with the part"), ("m_2",), (gripper.mass,), "kg")
    yield Datum(tr("centre of mass of the gripper below the flat springs"), ("l",), (gripper.drop,), "m")
    yield Datum(tr("moment of inertia of the gripper about the axis along x"), ("J_ξ",), (gripper.inertia_x,), inertia)
    yield Datum(tr("moment of inertia of the gripper about the axis along y"), ("J_η",), (gripper.inertia_y,), inertia)
    yield Datum(tr("moment of inertia of the gripper about the vertical"), ("J_ζ",), (gripper.inertia_z,), inertia)
    yield Datum(tr("mass of the exciter"), ("m_3",), (exciter.mass,), "kg")
    yield Datum(tr("centre of mass of the exciter from the vertical axis"), ("R_0",), (exciter.radius,), "m")
    yield Datum(tr("centre of mass of the exciter from the hinge"), ("R^{*}",), (exciter.arm,), "m")
    yield Datum(
        tr("angle of the arm of the exciter above the horizontal"), ("beta",), (math.degrees(exciter.arm_angle),), "deg"
    )
    yield Datum(
        tr("moment of inertia of the exciter about the line along the hinge"),
        ("J_x3",),
        (exciter.inertia_hinge,),
        inertia,
    )
    yield Datum(tr("moment of inertia of the exciter about the vertical"), ("J_z3",), (exciter.inertia_z,), inertia)
    yield Datum(tr("stiffness of the plate against a turn"), ("c_2",), (task.plate,), "N*m/rad")
    yield Datum(tr("ends of the rods from the vertical axis"), ("R_2",), (rods.radius,), "m")
    if rods.stiffness is not None:
        yield Datum(tr("stiffness across one rod"), ("c",), (rods.stiffness,), "N/m")
    else:
        yield Datum(tr("diameter of a rod"), ("d_c",), (rods.diameter,), "m")
        yield Datum(tr("length of a rod"), ("l_c",), (rods.length,), "m")
        yield Datum(tr("modulus of elasticity of the rods"), ("E_c",), (rods.young,), "Pa")
    yield from _of_flats(task)
    yield Datum(tr("acceleration of gravity"), ("g",), (task.gravity,), "m/s^2")
    if task.damping.direct:
        units = ["N*s/m", "N*s/m", *["N*m*s/rad"] * 3, "N*s/m", "N*m*s/rad"]
        for k, (value, unit) in enumerate(zip(task.damping.direct, units, strict=True), 1):
            if value:
                yield Datum(tr("damping coefficient of coordinate {k}", k=k), (f"b_{k}",), (value,), unit)
    else:
        yield Datum(tr("part of critical damping of every mode"), ("zeta",), (task.damping.ratio,))
    if task.unbalance is not None:
        unbalance = task.unbalance
        yield Datum(tr("static moment of the unbalance"), ("m_r",), (unbalance.moment,), "kg*m")
        yield Datum(tr("centre of the path of the unbalance from the vertical axis"), ("R",), (unbalance.radius,), "m")
        yield Datum(tr("centre of the path of the unbalance from the hinge"), ("R_u",), (unbalance.arm,), "m")
        yield Datum(
            tr("angle of the arm of the unbalance above the horizontal"),
            ("delta",),
            (math.degrees(unbalance.arm_angle),),
            "deg",
        )
        if unbalance.rotor:
            yield Datum(tr("moment of inertia of the rotor"), ("J_r",), (unbalance.rotor,), inertia)
    if task.speed is not None:
        yield Datum(tr("speed of the rotor"), ("Omega",), (task.speed,), "rad/s")


def _of_flats(task: VibratorTask) -> Iterator[Datum]:
    flats = task.flats
    if flats.vertical is not None:
        yield Datum(tr("vertical stiffness of one flat spring"), ("c_1",), (flats.vertical,), "N/m")
    if flats.tilt is not None:
        yield Datum(tr("stiffness of the flat springs against a tilt"), ("c_t",), (flats.tilt,), "N*m/rad")
    if flats.width:
        yield Datum(tr("width of a flat spring"), ("b",), (flats.width,), "m")
        yield Datum(tr("thickness of a flat spring"), ("h",), (flats.thickness,), "m")
        yield Datum(tr("length of a flat spring"), ("l_1",), (flats.length,), "m")
        yield Datum(tr("inner end of a flat spring from the axis"), ("l_2",), (flats.offset,), "m")
        yield Datum(tr("modulus of elasticity of the flat springs"), ("E",), (flats.young,), "Pa")
        yield Datum(tr("shear modulus"), ("G",), (flats.shear,), "Pa")
        if flats.torsion is not None:
            yield Datum(tr("torsion coefficient of the section"), ("alpha_t",), (flats.torsion,))
