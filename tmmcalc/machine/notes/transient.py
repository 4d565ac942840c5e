"""The chapter on motion, its part on motions in time: start-up, run-down, braking, changes of the load."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.facts.timed import equal_times, within
from tmmcalc.machine.model import TransientTask
from tmmcalc.machine.notes.motors import driven, of_braking, of_form, of_motor
from tmmcalc.machine.notes.told import reduced
from tmmcalc.machine.pictures.transient import draw_course
from tmmcalc.machine.pictures.words import end_text, event_text, mass_name
from tmmcalc.machine.stages.transient import inputs, machine_of
from tmmcalc.machine.tables.tasks.machine import to_scenarios
from tmmcalc.machine.transient.solve import Machine, drive_of
from tmmcalc.machine.transient.timed import TURN, TimedMotion
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Paragraph, Place, Result, Table
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import column_of, degrees, drawn, filled, lines, named, numeral, plainly, row_of, tabulated

EQUATION = "eps = (M_d + M_c - M_b - 0.5*<dJ>*omega**2)/(J_c + <J>)"
PANEL = 60.0  # height of a diagram [mm]
NOTHING = 1e-10  # of the largest energy: less is none
CLOSED = 5e-10  # of the balance of energy: what a line of it may leave open
APART = 0.02  # of the time: how far from all events the worked row stands


def blocks(order: Order) -> Iterator[Block]:
    """The equations of motion in time, then every motion: one row by the numbers, its course, events, energy."""
    yield from of_motor(order, "transient")
    motions: tuple[TimedMotion, ...] = order.results["transient"].motions
    tasks = to_scenarios(order.spec)
    machine = machine_of(inputs(order.spec), order.results)
    yield Heading(tr("Motions in time"), 2)
    yield from _curve(order)
    yield from _equations(motions[0], machine)
    for k, (motion, task) in enumerate(zip(motions, tasks, strict=True)):
        yield Heading(tr("Motion “{name}”", name=motion.name), 3)
        if task.braking is not None and machine.data is not None:
            yield from of_braking(machine.data, task.braking)
        yield from _motion(motion, task, machine, f"transient_{k}")


def _curve(order: Order) -> Iterator[Block]:
    """The whole curve of a motor whose steady motion takes the working part alone."""
    found = driven(order)
    if found is None or found[0].characteristic not in ("parabolic", "linear") or found[1].overload is None:
        return
    yield Paragraph(tr("Motions in time need the whole characteristic of the motor."))
    yield from of_form("kloss", found[1], order.results["power"])


def _equations(motion: TimedMotion, machine: Machine) -> Iterator[Block]:
    """The equations of motion, of one mass or of a chain of masses."""
    if len(motion.masses) == 1:
        yield Paragraph(
            tr(
                "The angular acceleration of the input link follows from the theorem of the change of the kinetic "
                "energy, with the moments $M_d$ of the drive, $M_c$ of the loads and $M_b$ of the brake; it is "
                "integrated in time by steps:"
            )
        )
        yield Display(read(filled(EQUATION, reduced())), key="transient_equation")
        return
    yield Paragraph(
        tr(
            "The drive is a chain of masses on elastic shafts. With moments of inertia $J_{d,i}$, stiffnesses $c_i$ "
            "and dampings $d_i$ reduced to the crank"
        )
    )
    yield Display(read("J_{d,i}*eps_i = M_{i−1,i} - M_{i,i+1}"))
    yield Display(read("M_{i,i+1} = c_i*(phi_i - phi_{i+1}) + d_i*(omega_i - omega_{i+1})"))
    yield Display(read(filled("(J_{d,n} + <J>)*eps_n = M_{n−1,n} + M_c - M_b - 0.5*<dJ>*omega_n**2", reduced())))
    yield Paragraph(
        tr("where $M_{i,i+1}$ is the moment of the shaft between two masses; on the first one acts the motor.")
    )
    drive, names = drive_of(machine)
    yield Paragraph(
        tr(
            "Table {tab:transient_masses} has the masses and shafts as they are, and the speeds $u_i$ of the masses "
            "over that of the crank."
        )
    )
    columns = {
        "$u_i$": motion.ratios,
        "$J_{d,i}$, kg*m^2": [mass.inertia for mass in drive.masses],
        "$c_i$, N*m/rad": [*(shaft.stiffness for shaft in drive.shafts), math.nan],
        "$d_i$, N*m*s/rad": [*(shaft.damping for shaft in drive.shafts), math.nan],
    }
    caption = tr("Masses of the drive and the shafts behind them")
    yield tabulated(caption, columns, [mass_name(name) for name in names], head=tr("Mass"), key="transient_masses")


def _motion(motion: TimedMotion, task: TransientTask, machine: Machine, key: str) -> Iterator[Block]:
    """One motion in time."""
    steps = motion.counters["steps"]
    method = tr("The motion is integrated by {method} in {steps} steps.", method=_method(motion.method), steps=steps)
    ended = tr(
        "It ends at $t = {time}$ s after {turns} turns of the crank at the angular velocity {speed} rad/s: {why}.",
        time=numeral(motion.end_time),
        turns=plainly(motion.turns),
        speed=plainly(motion.end_speed),
        why=end_text(motion.end),
    )
    yield Paragraph(f"{method} {ended}")
    if motion.end != "time":  # which is given
        yield Result("t", Given(motion.end_time, "s", tr("time of the motion")), place=motion.name)
    if len(motion.masses) == 1:
        yield from _row(motion, task, machine.cycle, machine.inertia.total)
    yield from _course(motion, key)
    if len(motion.events) == 1:
        what = event_text(motion.events[0])
        yield Paragraph(tr("The line with the number 1 in the figure marks this event: {what}.", what=what))
    elif motion.events:
        table = f"{{tab:{key}_events}}"
        yield Paragraph(tr("What happens on the way is in table {table}, by the numbers in the figure.", table=table))
        yield _events(motion, key)
    if len(motion.masses) > 1:
        table = f"{{tab:{key}_shafts}}"
        yield Paragraph(tr("The largest moments of the shafts are in table {table}.", table=table))
        yield _shafts(motion, key)
    yield from _motor(motion)
    yield from _energy(motion, f"{key}_energy")


def _method(name: str) -> str:
    return {
        "merson": tr("the method of Kutta and Merson"),
        "rk4": tr("the method of Runge and Kutta of the fourth order"),
        "collocation": tr("implicit collocation"),
    }.get(name, tr("the method {name}", name=name))


def _row(motion: TimedMotion, task: TransientTask, cycle: Cycle, constant: float) -> Iterator[Block]:
    """One row of the motion by the numbers, away from what is switched."""
    chosen = _worked_row(motion)
    if chosen is None:
        return
    theta, omega = float(motion.theta[-1, chosen]), float(motion.omega[-1, chosen])
    at = np.array([theta % cycle.period])
    links, slope = cycle.panels.at(np.stack((cycle.inertia, cycle.slope)), at)[:, 0].tolist()
    brake, time = task.scenario.brake, float(motion.t[chosen])
    braked = 0.0
    if brake is not None and task.scenario.brake_on(time):
        braked = math.copysign(brake.moment, omega) + brake.viscous * omega
    letters = reduced()
    lexicon = {
        "eps": Given(float(motion.alpha[-1, chosen]), "rad/s^2", tr("angular acceleration of the input link")),
        "omega": Given(omega, "rad/s", tr("angular velocity of the input link")),
        "M_d": Given(float(motion.motor_moment[chosen]), "N*m", tr("moment of the drive")),
        "M_c": Given(float(motion.load_moment[chosen]), "N*m", tr("reduced moment of the loads")),
        "M_b": Given(braked, "N*m", tr("moment of the brake")),
        "J_c": Given(constant, "kg*m^2", tr("constant moment of inertia of the machine")),
        letters["J"]: Given(links, "kg*m^2", tr("reduced moment of inertia of the links")),
        letters["dJ"]: Given(slope, "kg*m^2/rad", tr("derivative of the reduced moment of inertia")),
    }
    said = tr(
        "At $t = {time}$ s, at the angle $phi = {angle}$ of the turn,",
        time=numeral(time),
        angle=degrees(math.radians(within(theta))),
    )
    yield Paragraph(said)
    yield from lines((EQUATION,), [Place("", named(lexicon))], letters)


def _worked_row(motion: TimedMotion) -> int | None:
    """A row at about a quarter of the motion, away from all events."""
    t, end = motion.t, motion.end_time
    events = np.array([0.0, end, *(event.time for event in motion.events)])
    free = np.min(np.abs(t[:, None] - events), axis=1) > APART * end
    rows = np.flatnonzero(free)
    return int(rows[np.argmin(np.abs(t[rows] - end / 4))]) if len(rows) else None


def _course(motion: TimedMotion, key: str) -> Iterator[Block]:
    """The table of the course, and its diagrams."""
    rows = equal_times(motion.t)
    columns = {
        "$t$, s": motion.t[rows],
        "$phi$, rad": motion.theta[-1, rows],
        "$omega$, rad/s": motion.omega[-1, rows],
        "$eps$, rad/s^2": motion.alpha[-1, rows],
    }
    moments = {"$M_d$, N*m": motion.motor_moment[rows], "$M_c$, N*m": motion.load_moment[rows]}
    columns |= {head: values for head, values in moments.items() if values.any()}
    for k in range(len(motion.masses) - 1):
        columns[f"$M_{{{k + 1},{k + 2}}}$, N*m"] = motion.shaft_moment[k, rows]
    yield Paragraph(
        tr(
            "The course of the motion is in table {place} and in figure {figure}.",
            place=f"{{tab:{key}}}",
            figure=f"{{fig:{key}}}",
        )
    )
    caption = tr("Course of the motion: {name}", name=motion.name)
    yield tabulated(caption, columns, [str(k) for k in range(len(rows))], head=tr("Row"), key=key)
    high = PANEL * (2 + (len(motion.masses) > 1))
    draw = partial(draw_course, motion=motion)
    yield drawn(tr("Angular velocity and moments over the time: {name}", name=motion.name), draw, high, key)


def _events(motion: TimedMotion, key: str) -> Block:
    """What happened, by the numbers that stand in the figure."""
    events = motion.events
    began = float(motion.theta[-1, 0])
    unit, factor = printed_as("rad/s")
    cells = (
        [str(k) for k in range(1, len(events) + 1)],
        column_of([event.time for event in events]),
        column_of([(event.angle - began) / TURN for event in events]),
        column_of([factor * event.speed for event in events]),
        [event_text(event) for event in events],
    )
    head = (tr("Event"), f"$t$, {tr_unit('s')}", tr("Turns"), f"$omega$, {tr_unit(unit)}", tr("What happens"))
    return Table(tr("Events: {name}", name=motion.name), head, tuple(zip(*cells, strict=True)), f"{key}_events")


def _shafts(motion: TimedMotion, key: str) -> Block:
    """The largest moment of every shaft, and how many times that with rigid shafts it is."""
    largest = np.abs(motion.largest_moment[0, :-1])
    columns = {"$M_max$, N*m": largest, "$t$, s": motion.largest_moment[1, :-1]}
    if motion.rigid_moment:
        rigid = np.array(motion.rigid_moment)
        columns |= {
            tr("with rigid shafts, N*m"): rigid,
            tr("dynamic factor"): largest / np.where(rigid > 0, rigid, np.nan),
        }
    labels = [f"{mass_name(a)} – {mass_name(b)}" for a, b in zip(motion.masses[:-1], motion.masses[1:], strict=True)]
    caption = tr("Largest moments of the shafts: {name}", name=motion.name)
    return tabulated(caption, columns, labels, head=tr("Shaft"), key=f"{key}_shafts")


def _motor(motion: TimedMotion) -> Iterator[Block]:
    """The largest moment of the motor."""
    if motion.largest_motor:
        yield Paragraph(
            tr(
                "The largest moment of the motor is {moment} N·m at $t = {time}$ s.",
                moment=plainly(motion.largest_motor),
                time=numeral(motion.largest_motor_at),
            )
        )


def _energy(motion: TimedMotion, key: str) -> Iterator[Block]:
    """The energy at both ends and the works between."""
    work = {
        "A_d": (motion.motor_work, tr("work of the drive")),
        "A_c": (motion.load_work, tr("work of the loads")),
        "A_b": (motion.brake_work, tr("work of the brake")),
        "A_s": (motion.shaft_loss, tr("work of the damping in the shafts")),
    }
    lexicon = named(
        {
            "T_0": Given(motion.begin_energy, "J", tr("energy of the machine at the beginning")),
            "T_e": Given(motion.end_energy, "J", tr("energy of the machine at the end")),
            **{key: Given(float(values[-1]), "J", said) for key, (values, said) in work.items()},
        }
    )
    peak = max(abs(given.value) for given in lexicon.values() if isinstance(given.value, float))
    lexicon = {key: given._replace(value=0.0) if _nothing(given, peak) else given for key, given in lexicon.items()}
    if motion.imbalance <= CLOSED:
        yield Paragraph(tr("The works change the energy of the machine from $T_0$ to $T_e$:"))
        yield from lines(("T_e = T_0 + A_d + A_c + A_b + A_s",), [Place("", lexicon)])
        return
    open_part = tr(
        "The works of the steps change the energy from $T_0$ to $T_e$, table {table}; the balance is open by {part} % "
        "of the largest.",
        table=f"{{tab:{key}}}",
        part=plainly(100 * motion.imbalance, 2),
    )
    yield Paragraph(open_part)
    rows = [row_of(f"${key}$", "J", [given.value]) for key, given in lexicon.items() if isinstance(given.value, float)]
    head = (tr("Quantity"), tr("Value"))
    yield Table(tr("Energy and works: {name}", name=motion.name), head, tuple(rows), key)


def _nothing(given: Given, peak: float) -> bool:
    """Whether an energy is no more than rounding."""
    return isinstance(given.value, float) and abs(given.value) <= NOTHING * peak
