"""From the table ``[cam]`` to what is asked of a cam: its motion, its sizes, limits, loads and requirements."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from tmmcalc.cams.program import SAME, TURN, Phase, Program
from tmmcalc.cams.tables.cam import closed_ratio
from tmmcalc.cams.tables.cam_spring import spring_method
from tmmcalc.cams.tables.tasks.own_law import to_law
from tmmcalc.cams.task import (
    PRESSURE_ANGLES,
    AngleLimits,
    Asked,
    CamTask,
    Elastic,
    Force,
    Guide,
    Loads,
    Optimum,
    Requirements,
    Spring,
)
from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import names_of
from tmmcalc.linkage.wanted import slides

if TYPE_CHECKING:
    from tmmcalc.cams.laws.law import Law
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.tables.cam import CamTable
    from tmmcalc.cams.tables.cam_parts import CamLoadsTable, ForceTable
    from tmmcalc.linkage.tables.input import InputTable
    from tmmcalc.spec.table import Table

CLOSED = 1e-9  # of the largest force: values at both ends of a turn that are the same
T = TypeVar("T")
RIGHT_WAY = {"clockwise": 1, "with": 1, "counter-clockwise": -1, "against": -1}


def to_cam(spec: CamTables) -> CamTask:
    """The cam of the spec; raises `UsageError` if it has none, or a law that cannot move a follower."""
    table = spec.cam
    if table is None:
        remedy = "add [cam] with follower, stroke, rise, return_angle and law"
        raise UsageError("the spec has no [cam]", remedy=remedy)
    ratio, turns = shaft_ratio(spec, table)
    speed, remarks = _speed(spec, table, ratio)
    return CamTask(
        program=_program(table),
        asked=_asked(table, _sense(spec, table)),
        limits=_limits(table),
        steps=table.steps,
        step=table.step,
        loads=None if speed is None else _loads(table, speed),
        guide=_plain(Guide, table.guide, stem="stem_radius"),
        requirements=_requirements(table),
        optimum=_optimum(table),
        elastic=None if table.elastic is None else _plain(Elastic, table.elastic),
        begin=table.crank_angle,
        ratio=ratio,
        turns=turns,
        remarks=remarks,
    )


def _requirements(table: CamTable) -> Requirements:
    """What is judged; the contact stress is given, or that of the steel."""
    given = table.requirements
    if given is None:
        return Requirements()
    names = [name for name in names_of(Requirements) or () if name != "contact_source"]
    needs = Requirements(**{name: getattr(given, name) for name in names})
    if given.material is None:
        return needs
    from tmmcalc.cams.strength.material import allowed_contact  # late: few cams are told by their steel

    steel = given.material
    contact, source = allowed_contact(steel.treatment, steel.hardness, steel.failure)
    return replace(needs, contact=contact, contact_source=source)


def _plain(record: type[T], table: Table, **renamed: str) -> T:
    """A record whose fields are keys of the table, some under another name."""
    return record(**{name: getattr(table, renamed.get(name, name)) for name in names_of(record) or ()})


def shaft_ratio(spec: CamTables, table: CamTable) -> tuple[float, int]:
    """Speed of the cam over that of the crank, and after how many turns of the crank a cam that loads it repeats.

    On the motor's shaft the ratio of the gears, which the checks ask for, comes to that of the cam.
    """
    if table.shaft is None:
        return 1.0, 0
    gears = None
    if table.shaft == "motor":
        from tmmcalc.machine.tables.tasks.machine import to_gears  # a cam alone is asked for without the machine

        gears = to_gears(spec).ratio
    exact = closed_ratio(table.ratio, 1.0 if gears is None else gears)
    return float(exact), exact.denominator


def _speed(spec: CamTables, table: CamTable, ratio: float) -> tuple[float | None, tuple[str, ...]]:
    """The cam's own speed, or that of the shaft that the spec is about, which is told."""
    if table.speed is not None:
        return table.speed, ()
    shaft, speed = "", 0.0
    if (crank := _crank(spec)) is not None:
        shaft, speed = "crank", abs(crank.speed)
    elif spec.torque is not None:
        shaft, speed = "shaft", spec.torque.speed
    if not shaft:
        return None, ()
    speed *= ratio
    how = (
        Phrase("as the {shaft} does", shaft=shaft)
        if ratio == 1
        else Phrase("at {ratio:.6g} of the speed of the {shaft}", ratio=ratio, shaft=shaft)
    )
    why = "[cam] has no speed" if table.shaft is None else Phrase('[cam] shaft = "{shaft}"', shaft=table.shaft)
    return speed, (Phrase("{why}: the cam turns {how}, at {speed:.6g} rpm", why=why, how=how, speed=speed * 30 / pi),)


def _crank(spec: CamTables) -> InputTable | None:
    """The input of a mechanism that a crank drives; None: there is none, or a slider does."""
    return None if spec.mechanism is None or slides(spec) else spec.mechanism.input


def _program(table: CamTable) -> Program:
    """Rise, high dwell, return, and the low dwell that fills the turn; dwells of no angle are left out."""
    rise, back = (to_law(law) for law in _laws(table))
    moves: list[tuple[Any, float, float, float, Law | None]] = [
        ("rise", table.rise, 0.0, table.stroke, rise),
        ("high dwell", table.high_dwell, table.stroke, table.stroke, None),
        ("return", table.return_angle, table.stroke, 0.0, back),
        ("low dwell", TURN - table.rise - table.high_dwell - table.return_angle, 0.0, 0.0, None),
    ]
    return Program(tuple(Phase(*move) for move in moves if move[1] > SAME * TURN))


def _laws(table: CamTable) -> tuple[Any, Any]:
    return table.rise_law or table.law, table.return_law or table.law


def _sense(spec: CamTables, table: CamTable) -> int:
    """Sense of the cam: as it is given, or that of the crank with which it turns."""
    crank = _crank(spec)
    if table.rotation is None and crank is not None and table.speed is None and table.shaft in (None, "crank"):
        return RIGHT_WAY["counter-clockwise" if crank.speed > 0 else "clockwise"]
    return RIGHT_WAY[table.rotation or "clockwise"]


def _asked(table: CamTable, sense: int) -> Asked:
    return Asked(
        kind=table.follower,
        sense=sense,
        closure=table.closure,
        start=table.start_angle if table.follower == "oscillating" else table.start_distance,
        base=table.base_radius,
        offset=_offset(table),
        roller=0.0 if table.follower == "flat" else table.roller_radius,
        centres=table.centre_distance,
        rocker=table.rocker_length,
        assembly=RIGHT_WAY[table.rocker_turn],
        tool=table.tool_radius,
        tolerance=table.tolerance,
        margin=table.face_margin,
        report_faults=not table.refuse,
    )


def _offset(table: CamTable) -> float | None:
    """The offset, None if it is found together with the start distance, or follows from it and the base radius."""
    free = table.follower == "translating" and (table.start_distance is None) == (table.base_radius is None)
    return table.offset if table.offset is not None or free else 0.0


def _limits(table: CamTable) -> AngleLimits:
    given = table.limits
    usual = PRESSURE_ANGLES[table.follower]
    rise = usual if given.pressure_angle is None else given.pressure_angle
    back = given.pressure_angle_return
    if back is None and table.closure == "groove":
        back = rise
    return AngleLimits(
        rise=rise,
        back=None if back is False else back,
        convex=given.convex_radius,
        concave=given.concave_radius,
        allow_concave=given.allow_concave,
        shaft=given.shaft_radius,
    )


def _loads(table: CamTable, speed: float) -> Loads:
    """Loads at this speed; without [cam.loads] the speed alone."""
    given = table.loads
    if given is None:
        return Loads(speed=speed, spring=Spring("none"))
    mass = given.inertia if table.follower == "oscillating" else given.mass
    return Loads(
        speed=speed,
        mass=mass or 0.0,
        force=_force(given),
        gravity=given.gravity,
        spring=_spring(table, mass),
        friction=given.friction,
        pivot_friction=given.pivot_friction,
        pivot_radius=given.pivot_radius or 0.0,
    )


def _force(given: CamLoadsTable) -> Force:
    if given.force_table is None:
        return Force(given.force, given.force_return)
    phi, values = _curve(given.force_table)
    return Force(phi=phi, values=values)


def _curve(table: ForceTable) -> tuple[Any, Any]:
    """Angles and values over a turn; without angles they are equal steps, and the end of the turn is its begin.

    Where the values there differ they jump, and both are kept.
    """
    values = np.array(table.force or table.moment, float)
    if table.phi is None:
        return np.arange(len(values)) * (TURN / len(values)), values
    phi = np.array(table.phi, float)
    closed = phi[-1] - phi[0] > TURN * (1 - SAME) and abs(values[-1] - values[0]) <= CLOSED * np.max(np.abs(values))
    return (phi[:-1], values[:-1]) if closed else (phi, values)


def _spring(table: CamTable, mass: float | None) -> Spring:
    """The spring as it is asked for; without [cam.spring] what presses an inertia on the cam."""
    given = table.spring
    if given is None:
        return Spring("safety" if table.closure == "force" and mass else "none")
    written = given.model_fields_set
    return Spring(
        method=given.method or spring_method(written),
        safety=given.safety,
        stiffness=given.stiffness or 0.0,
        preload=given.preload,
        deflection=given.deflection,
        least=given.least_contact,
        exact=given.exact,
        wire=given.wire,
        coil=given.coil,
        shear=given.shear_modulus,
        allowed=given.shear_stress,
        dead=given.dead_coils,
    )


def _optimum(table: CamTable) -> Optimum | None:
    given = table.optimum
    if given is None:
        return None
    heights, centres, rockers = (
        None if ends is None else (ends[0], ends[1])
        for ends in (given.heights, given.centre_distances, given.rocker_lengths)
    )
    return Optimum(
        step=given.step,
        height_step=given.height_step,
        heights=heights,
        centre_distances=centres,
        rocker_lengths=rockers,
        phases=given.phases,
        laws=tuple(given.laws or ()),
        safeties=tuple(given.safeties or ()),
        contacts=tuple(given.contacts or ()),
        roller_ratios=tuple(given.roller_ratios or ()),
        combine=given.combine,
    )
