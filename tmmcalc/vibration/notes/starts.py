"""Starts of the device: with a given angle of the rotor, and by the motor, where the rotor may stay at a resonance."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column_of, lines, named
from tmmcalc.vibration.notes.device import COUNT
from tmmcalc.vibration.vibrator.energies import excitation_of
from tmmcalc.vibration.vibrator.forced import load_moment
from tmmcalc.vibration.vibrator.modes import modes_of
from tmmcalc.vibration.vibrator.results import MotorStart, Start, VibratorResult
from tmmcalc.vibration.vibrator.runup import DeviceMotion
from tmmcalc.vibration.vibrator.task import Drive, RunUp, VibratorTask

ROWS = 20  # of the tables
SHIFTS, TURNS = (0, 1, 5), (2, 3, 4, 6)  # coordinates in m, in rad
LETTERS = ("x", "y", "phi", "theta_x", "theta_y", "z", "gamma")
RPM = 30 / np.pi


def given_angle(task: VibratorTask, start: Start) -> Iterator[Block]:
    """The rotor speeds up evenly to its speed and keeps it."""
    asked, course = task.run_up, start.course
    assert asked is not None
    assert task.speed is not None
    yield Heading(tr("Start with a given angle of the rotor"), 2)
    yield Paragraph(
        tr(
            "The rotor speeds up from rest with the constant angular acceleration $eps$ to the speed $Omega$ and "
            "keeps it. While it speeds up the unbalance pulls along its path too, and the moment of momentum of the "
            "rotor resists the turn $phi$. The equations of motion are linear; their solution is exact at every time "
            "of table {table}.",
            table="{tab:vibrator_start_rows}",
        )
        if asked.tangential
        else tr(
            "The rotor speeds up from rest with the constant angular acceleration $eps$ to the speed $Omega$ and "
            "keeps it; of the unbalance only the centrifugal force is counted. The equations of motion are linear; "
            "their solution is exact at every time of table {table}.",
            table="{tab:vibrator_start_rows}",
        )
    )
    settled = task.speed / asked.acceleration
    quick = np.flatnonzero(course.t < settled)
    even = np.flatnonzero(course.t > settled)
    for texts, rows in ((("omega = eps*t", "psi = eps*t**2/2"), quick), (("psi = Omega*t - Omega**2/(2*eps)",), even)):
        if len(rows):
            yield from lines(texts, [_rotor(task, asked, course, int(rows[len(rows) // 2]))])
    yield from _rows(start.course, "vibrator_start_rows", tr("Start with a given angle of the rotor"))
    yield Paragraph(
        tr("At the end the energy of the device is what the work of the unbalance exceeds that of the dampers:")
    )
    yield from lines(["E = W - D_r"], [Place("", named(_energies(course)))])
    yield from _largest(start.largest)


def _rotor(task: VibratorTask, asked: RunUp, course: DeviceMotion, row: int) -> Place:
    """Angle and speed of the rotor at a row."""
    found = {
        "eps": Given(asked.acceleration, "rad/s^2", tr("angular acceleration of the rotor")),
        "Omega": Given(task.speed or 0.0, "rad/s", tr("speed of the rotor")),
        "t": Given(float(course.t[row]), "s", tr("time")),
        "omega": Given(float(course.omega[row]), "rad/s", tr("angular velocity of the rotor")),
        "psi": Given(float(course.psi[row]), "rad", tr("angle of the unbalance")),
    }
    time = tr_number(significant(float(course.t[row]), RESULT))
    return Place(tr("at t = {time} s", time=time), named(found))


def _energies(course: DeviceMotion) -> dict[str, Given]:
    return {
        "E": Given(float(course.energy[-1]), "J", tr("kinetic and potential energy")),
        "W": Given(float(course.work[-1]), "J", tr("work that was put in")),
        "D_r": Given(float(course.lost[-1]), "J", tr("work that the dampers took")),
    }


def _rows(course: DeviceMotion, key: str, caption: str) -> Iterator[Block]:
    """Some rows of the course."""
    rows = np.unique(np.linspace(0, len(course.t) - 1, ROWS + 1).round().astype(int))
    columns: dict[str, Values] = {
        f"$t$, {tr_unit('s')}": course.t[rows],
        f"$omega$, {tr_unit('rad/s')}": course.omega[rows],
    }
    for k in range(COUNT):
        if np.max(np.abs(course.q[k])) > 1e-12 * np.max(np.abs(course.q)):
            unit, factor = (tr_unit("mm"), 1e3) if k in SHIFTS else ("°", 180 / np.pi)
            columns[f"${LETTERS[k]}$, {unit}"] = factor * course.q[k][rows]
    yield Table(caption, tuple(columns), tuple(zip(*map(column_of, columns.values()), strict=True)), key)


def _largest(sizes: Values) -> Iterator[Block]:
    """The largest sizes of the coordinates."""
    yield Paragraph(
        tr(
            "The coordinates come at most to {values}.",
            values="; ".join(_size(k, v) for k, v in enumerate(sizes.tolist()) if v > 1e-12 * float(np.max(sizes))),
        )
    )


def _size(k: int, value: float) -> str:
    factor, unit = (1e3, f" {tr_unit('mm')}") if k in SHIFTS else (180 / np.pi, "°")
    return f"${LETTERS[k]}$ = {tr_number(significant(factor * value, RESULT))}{unit}"


def driven(task: VibratorTask, result: VibratorResult, start: MotorStart) -> Iterator[Block]:
    """The rotor as a degree of freedom of its own: its equation, its regimes, its course."""
    asked = task.drive
    assert asked is not None
    yield Heading(tr("Start by the motor"), 2)
    yield Paragraph(
        tr(
            "Here the angle $psi$ of the rotor is the eighth coordinate, which the moment $M_d$ of the motor drives "
            "and the drag $d_r*psi'$ of bearings and air resists; with the vector $k$ of the coupling the equations "
            "are"
        )
    )
    yield Display(read("M*q'' + k*psi'' + B*q' + C*q = m_r*(psi')**2*V"))
    yield Display(read("k*q'' + J_r*psi'' = M_d - d_r*psi' + m_r*g*sin(psi)/sqrt(2)"))
    yield Paragraph(
        tr(
            "They are integrated numerically from rest. Table {table} has the course; the balance of energy and work "
            "stays open by {part} of the largest energy.",
            table="{tab:vibrator_drive_rows}",
            part=f"${significant(start.course.error, 2)}$",
        )
    )
    yield from _rows(start.course, "vibrator_drive_rows", tr("Start by the motor"))
    yield from _largest(start.largest)
    yield from _regimes(task, result, start, asked)


def _regimes(task: VibratorTask, result: VibratorResult, start: MotorStart, asked: Drive) -> Iterator[Block]:
    """Steady regimes with the balance of moments, resonances with what they ask of the motor."""
    assert task.unbalance is not None
    yield Heading(tr("Steady regimes of the rotor"), 3)
    yield Paragraph(
        tr(
            "The rotor runs evenly where the moment of the motor is what the vibration and the drag take. Such a "
            "regime is stable if the moment of the motor falls faster with the speed than that of the load."
        )
    )
    modes = modes_of(result.mass, result.stiffness, task.damping, task.rods.radius)
    excitation = excitation_of(task.unbalance)
    places = []
    for k, regime in enumerate(start.regimes, 1):
        load = float(load_moment(modes, excitation, np.array([regime.speed]))[0])
        found = {
            "M_d": Given(regime.moment, "N*m", tr("moment of the motor")),
            "L": Given(load, "N*m", tr("mean moment that the vibration takes")),
            "d_r": Given(asked.drag, "N*m*s/rad", tr("drag of bearings and air")),
            "omega": Given(regime.speed, "rad/s", tr("angular velocity of the rotor")),
        }
        places.append(Place(tr("in regime {number}", number=k), named(found)))
    if places:
        yield from lines(["M_d = L + d_r*omega"], places)
        rows = tuple(
            (str(k), *column_of([each.speed]), *column_of([each.speed * RPM]), *column_of([each.moment]),
             tr("stable") if each.stable else tr("unstable"))
            for k, each in enumerate(start.regimes, 1)
        )  # fmt: skip
        head = (
            tr("Regime"),
            f"$omega$, {tr_unit('rad/s')}",
            f"$n$, {tr_unit('rpm')}",
            f"$M_d$, {tr_unit('N*m')}",
            tr("Verdict"),
        )
        yield Paragraph(tr("All steady regimes are listed in table {tab:vibrator_regimes}."))
        yield Table(tr("Steady regimes of the rotor"), head, rows, "vibrator_regimes")
    else:
        yield Paragraph(tr("The motor has no steady regime up to its no-load speed."))
    yield from _barriers(start)
    yield from _end(result, start)


def _barriers(start: MotorStart) -> Iterator[Block]:
    """What resonances ask of the motor."""
    if not start.barriers:
        return
    yield Paragraph(
        tr(
            "At resonance the vibration takes a moment that the motor has to give; table {tab:vibrator_barriers} has "
            "both."
        )
    )
    rows = tuple(
        (str(each.mode), *column_of([each.speed * RPM]), *column_of([each.load]), *column_of([each.motor]))
        for each in start.barriers
    )
    head = (
        tr("Mode"),
        f"$n$, {tr_unit('rpm')}",
        f"{tr('Moment of the load')}, {tr_unit('N*m')}",
        f"{tr('Moment of the motor')}, {tr_unit('N*m')}",
    )
    yield Table(tr("Moments at the resonances"), head, rows, "vibrator_barriers")


def _end(result: VibratorResult, start: MotorStart) -> Iterator[Block]:
    """The speed that the rotor reached, and whether a resonance holds it."""
    mean = Given(start.mean, "rad/s", tr("mean speed of the rotor at the end of the start"))
    value = tr_number(significant(start.mean, RESULT))
    yield Paragraph(tr("Over the last tenth of the time the rotor runs at {value} rad/s on average.", value=value))
    top = max((each.speed for each in start.regimes if each.stable), default=None)
    if start.stuck:
        hertz = tr_number(significant(float(result.hertz[start.stuck - 1]), RESULT))
        yield Paragraph(
            tr(
                "The rotor is stuck at the resonance of mode {mode} ({hertz} Hz): the vibration takes all that the "
                "motor gives (Sommerfeld's effect). A stronger motor, more damping or less unbalance is needed.",
                mode=start.stuck,
                hertz=hertz,
            )
        )
        yield Result("omega_m", mean, None if top is None else 0.97 * top, ">=" if top is not None else "")
        return
    yield Result("omega_m", mean)
