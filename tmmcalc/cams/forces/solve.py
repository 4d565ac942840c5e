"""The stage of the forces: spring, reactions at the rows, extremes over the turn, jamming, loss of contact, work."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.errors import force_errors
from tmmcalc.cams.forces.results import CamForces, CamWork, ForceExtreme
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.state import pivot_force, state
from tmmcalc.cams.forces.turn import at_rows, loads_of, spans
from tmmcalc.cams.forces.turnforces import NOTHING, TurnForces, reserve_of, turn_forces
from tmmcalc.cams.forces.verdicts import force_notes, several_turns
from tmmcalc.cams.task import CamTask, Loads

if TYPE_CHECKING:
    from tmmcalc.machine.motion import Motion


def solve_forces(task: CamTask, follower: Follower, motion: Motion | None = None) -> CamForces:
    """Forces on the follower at the positions and over the whole turn, at the speed of the machine if it is known.

    Raises `UsageError` without a speed, or without the guide that friction needs; `NoSolutionError` for a guide
    without length or a spring that there is not; `SingularityError` where the follower jams or comes to the axis.
    """
    task = task.at_speed(motion)
    loads = loads_of(task)
    spring = solve_spring(task, loads)
    course = turn_forces(task, follower, loads, spring)
    rows = task.positions
    points = at_rows(task, loads, rows)
    found = state(course.carried, points)
    guide, turns = course.carried.guide, follower.kind == "oscillating"
    lost, reversals = _lost(task, course), _reversals(task, course)
    reserve, work, extremes = reserve_of(course), _work(task, course, loads), tuple(_extremes(course))
    side = float(follower.sense)
    return CamForces(
        follower=follower,
        closure=task.asked.closure,
        positions=rows,
        ends=tuple(task.program.starts.tolist()),
        speed=loads.speed,
        stroke=task.program.stroke,
        lift=points.motion[0],
        inertia=-course.carried.inertia * points.acceleration,
        elastic=-(spring.preload + spring.stiffness * points.motion[0]),
        force=points.force,
        load=found.load,
        theta=np.arctan2(found.sine, found.cosine),
        ratio=found.ratio,
        contact=found.contact,
        protrusion=found.protrusion if follower.kind == "translating" and guide else None,
        lower=side * found.lower if guide else None,
        upper=side * found.upper if guide else None,
        pivot=pivot_force(follower, points.motion, found.contact, found.sine, found.cosine) if turns else None,
        torque=-found.torque,
        driving=found.driving,
        guide=guide,
        spring=spring,
        extremes=extremes,
        lost=lost,
        reversals=reversals,
        reserve=reserve,
        work=work,
        verdict="loss_of_contact" if lost else "ok",
        notes=(*force_notes(task, spring, lost, reversals, reserve), *several_turns(task, motion)),
        error=force_errors(task, loads, course, spring, points, found, extremes, work),
    )


def _extremes(course: TurnForces) -> Iterator[ForceExtreme]:
    now, of = course.state, course.carried
    turns = of.follower.kind == "oscillating"
    yield course.extreme("M_c" if turns else "P_c", "N*m" if turns else "N", now.load)
    yield course.extreme("R", "N", now.contact)
    if of.guide:
        side = of.follower.sense
        yield course.extreme("N1", "N", side * now.lower)
        yield course.extreme("N2", "N", side * now.upper)
    yield course.extreme("T", "N*m", -now.torque)
    yield course.extreme("M_drive", "N*m", now.driving)


def _lost(task: CamTask, course: TurnForces) -> tuple[tuple[float, float], ...]:
    """Intervals where no force presses the follower on the cam; a groove holds it."""
    if task.asked.closure == "groove":
        return ()
    load = course.shaped(course.state.load)
    open_ = np.max(load, axis=1) >= -NOTHING * np.max(np.abs(load))
    touched = np.min(load, axis=1) < -NOTHING * np.max(np.abs(load))
    return spans(course.on.edges, open_ & ~touched)


def _reversals(task: CamTask, course: TurnForces) -> tuple[float, ...]:
    """Angles where R changes its sign in a groove; where it rests at zero, the begin of that."""
    if task.asked.closure != "groove":
        return ()
    load = course.shaped(course.state.load)
    sign = np.sign(np.where(np.abs(load) > NOTHING * np.max(np.abs(load)), load, 0.0).sum(axis=1))
    held = np.flatnonzero(sign)
    if not held.size:
        return ()
    before = np.concatenate((held[-1:], held[:-1]))
    changed = sign[held] != sign[before]
    return tuple(float(course.on.edges[k]) for k in held[changed])


def _work(task: CamTask, course: TurnForces, loads: Loads) -> CamWork:
    """Energies by integrals over the panels; inertia, spring and weight give none in a turn."""
    of, on, now = course.carried, course.on, course.state
    motion, force = course.points.motion, course.points.force
    weight = 0.0 if of.follower.kind == "oscillating" else loads.mass * loads.gravity
    given = float(on.total(course.shaped(np.maximum(now.driving, 0.0))))
    driving = float(on.total(course.shaped(now.driving)))
    rubbed = float(on.total(course.shaped(now.rubbed)))
    own = float(on.total(course.shaped((force - weight) * motion[1])))
    turned = float(on.total(course.shaped(np.abs(now.driving))))
    error = abs(driving + own - rubbed) / turned if turned else 0.0
    speed = loads.speed if task.turning is None else task.turning.mean
    energies = (driving, given, driving - given, rubbed, own)
    driving, given, back, rubbed, own = (each if abs(each) > NOTHING * turned else 0.0 for each in energies)
    mean = driving / (2 * pi)
    return CamWork(driving, given, back, rubbed, own, mean, mean * speed, error)
