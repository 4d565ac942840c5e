"""The chapter on motion, its part on the steady motion: the textbook's recurrence or energy, the exact regime."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.notes.shown import rows_shown
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.machine.motion import Motion, sided
from tmmcalc.machine.nodes import nodal_tables, nodal_work
from tmmcalc.machine.notes.motors import driven, of_motor
from tmmcalc.machine.notes.told import inertias, mean_speed, reduced
from tmmcalc.machine.pictures.motion import draw_speed
from tmmcalc.machine.reduction.jumps import nodal_jumps
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.stepwise import Run, idle_run_of, run_of
from tmmcalc.machine.verdicts import SLACK
from tmmcalc.report.drawing.order import POSITIONS, Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_count
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import (
    SAME,
    degrees,
    drawn,
    filled,
    held,
    lines,
    named,
    numeral,
    plainly,
    tabulated,
    two_sides,
)

SPEED = 78.0  # height of the picture [mm]
TURNS = 5  # of the iteration that are shown in the table of turns
NOTHING = 1e-6  # of a deviation after a cycle: less is nothing
EVEN = 1e-9  # coefficient of speed fluctuation below which the speed is constant
ALIKE = 1e-6  # relative difference of angular velocities: less is none
REACHED = 1e-6  # of the allowed coefficient: what it may be above
SOUND = 1.0  # B dphi/J up to which the recurrence does not swing


def blocks(order: Order) -> Iterator[Block]:
    """What drives, the constant inertia, the textbook's way step by step, the exact regime with its checks."""
    yield from of_motor(order, "motion")
    result: Motion = order.results["motion"]
    yield from _machine(result, order)
    if result.regime.delta > EVEN:
        yield from _recurrence(result, order)
        yield from _by_energy(result, order)
        yield from _exact(result, order)
        yield from _unevenness(result, order)
    else:
        yield from _even(result)
    yield from _regulation(result, order)
    yield from _results(result, order)


def _results(result: Motion, order: Order) -> Iterator[Block]:
    """The coefficient of speed fluctuation against what is allowed."""
    table, found = order.spec.flywheel, result.regime.delta
    given = Given(found, "", tr("coefficient of speed fluctuation"))
    if table is None or table.delta is None:
        yield Result("delta", given)
    else:
        limit = max(table.delta, found) if found <= table.delta * (1 + REACHED) else table.delta
        yield Result("delta", given, limit, "<=")


def _machine(result: Motion, order: Order) -> Iterator[Block]:
    """The equation, and the constant inertia."""
    yield Heading(tr("Steady motion of the machine"), 2)
    if result.kind == "positional":
        yield Paragraph(
            tr(
                "A constant moment makes the work of the cycle zero; the motion is steady. With the kinetic energy $T$ "
                "of the machine"
            )
        )
    elif result.kind == "none":
        yield Paragraph(
            tr("Nothing drives but the loads, which set the speed. With the kinetic energy $T$ of the machine")
        )
    else:
        yield Paragraph(
            tr("The steady motion repeats itself from cycle to cycle. With the kinetic energy $T$ of the machine")
        )
    yield Display(read(filled("T = (J_c + <J>)*omega**2/2 = T_0 + A", reduced())), key="motion_energy")
    yield Paragraph(
        tr(
            "where $A$ is the work of all moments from position 0, ${J}$ the reduced moment of inertia of the links "
            "and $J_c$ the constant moment of inertia:",
            J=reduced()["J"],
        )
    )
    found, own = order.results.get("flywheel"), result.inertia.flywheel
    designed = found is not None and not found.existing
    wheel = "J_M" if designed else "J_f"  # the letter that the wheel has where it was found
    lexicon = {
        **inertias(result.inertia, order),
        wheel: Given(own, "kg*m^2", tr("moment of inertia of the flywheel")),
        "J_c": Given(result.inertia.total, "kg*m^2", tr("constant moment of inertia of the machine")),
    }
    yield from lines((f"J_c = J_R*u**2 + J_g + J_e + {wheel}",), [Place("", named(lexicon))])


def _even(result: Motion) -> Iterator[Block]:
    """A machine whose moments and inertia are constant."""
    speed = numeral(result.regime.mean)
    yield Paragraph(
        tr(
            "The moments and the moment of inertia do not change over the cycle, nor does the angular velocity: "
            "$omega_m = {speed}$ rad/s.",
            speed=speed,
        )
    )


def _shown(result: Motion, order: Order) -> list[int]:
    """The positions whose step is worked out: those that are asked for, or one.

    It is that of the working stroke that other chapters show, or without a linkage one at a quarter of the cycle.
    """
    asked = order.rows(POSITIONS, result.labels)
    rows = asked if asked is not None else _first(result, order)
    return [row for row in rows if row > 0] or [1]


def _first(result: Motion, order: Order) -> list[int]:
    """The position that is shown where none is asked for."""
    if order.spec.torque is not None:
        return [max(1, (len(result.labels) - 1) // 4)]
    kinematics = order.results["kinematics"]
    chain = chain_of(to_linkage(order.spec.linkage), kinematics)
    return [result.labels.index(kinematics.labels[rows_shown(order, chain, kinematics)[0]])]


def _recurrence(result: Motion, order: Order) -> Iterator[Block]:
    """The textbook's recurrence: numbers that are the same at every step, one step, the turns."""
    reduction: Reduction = order.results["reduction"]
    run = run_of(result, reduction)
    if run is None:
        return
    yield Heading(tr("Angular velocity by the recurrence"), 3)
    yield Paragraph(
        tr(
            "The moment $M_c$ of the loads and $J = J_c + {J}$ are known at the positions, with the step $Deltaphi$. "
            "The trapezoid rule for the work of the motor and of the loads gives the angular velocity in a position "
            "from that in the one before:",
            J=reduced()["J"],
        )
    )
    rows = _shown(result, order)
    places = [Place(tr("pos. {label}", label=result.labels[row]), _step(run, row)) for row in rows]
    before, gained = "(J_{i−1} - B_M*Deltaphi)*omega_{i−1}**2", "(M_{c,i−1} + M_{c,i} + 2*A_M)*Deltaphi"
    yield Display(read(f"omega_i**2 = ({before} + {gained})/(J_i + B_M*Deltaphi)"), key="motion_recurrence")
    yield Paragraph(tr("Part by part:"))
    yield from lines((f"E_i = {before}", f"W_i = {gained}", "omega_i = sqrt((E_i + W_i)/(J_i + B_M*Deltaphi))"), places)
    yield from _turns(result, run, idle_run_of(result, reduction), nodal_jumps(reduction, reduction.cycle.speed))
    lexicon = {
        "omega_max^r": Given(float(np.max(run.regime.omega)), "rad/s", tr("largest angular velocity")),
        "omega_min^r": Given(float(np.min(run.regime.omega)), "rad/s", tr("least angular velocity")),
        "delta^r": Given(run.regime.delta, "", tr("coefficient of speed fluctuation by the positions")),
    }
    high, low = result.labels[run.regime.node_max], result.labels[run.regime.node_min]
    said = tr("The angular velocity is largest in position {high} and least in position {low}:", high=high, low=low)
    yield Paragraph(said)
    text = "delta^r = 2*(omega_max^r - omega_min^r)/(omega_max^r + omega_min^r)"
    yield from lines((text,), [Place("", named(lexicon))])
    widest = Given(run.regime.warning, "", tr("largest share of the motor in the step"))
    least = Given(float(np.min(run.nodes.inertia)), "kg*m^2", tr("least moment of inertia of the machine"))
    known = {**places[0].lexicon, **named({"q": widest, "J_min": least})}
    yield Paragraph(tr("The step is small enough where the recurrence does not swing from position to position:"))
    yield from lines(("q = B_M*Deltaphi/J_min",), [Place("", known)])
    yield held("q < 1", (run.regime.warning, SOUND), "", holds=run.regime.warning < SOUND)


def _step(run: Run, row: int) -> Lexicon:
    """The quantities of one step of the recurrence."""
    nodes, omega = run.nodes, run.regime.omega
    moment, inertia = tr("reduced moment of the loads"), tr("moment of inertia of the machine")
    speed = tr("angular velocity of the input link")
    parabola = tr("coefficient of the parabola")
    return named(
        {
            "omega_i": Given(float(omega[row]), "rad/s", speed),
            "omega_{i−1}": Given(float(omega[row - 1]), "rad/s", speed),
            "J_i": Given(float(nodes.inertia[row]), "kg*m^2", inertia),
            "J_{i−1}": Given(float(nodes.inertia[row - 1]), "kg*m^2", inertia),
            "M_{c,i}": Given(float(nodes.moment[row]), "N*m", moment),
            "M_{c,i−1}": Given(float(nodes.moment[row - 1]), "N*m", moment),
            "A_M": Given(nodes.a, "N*m", parabola),
            "B_M": Given(nodes.b, "N*m*s^2/rad^2", parabola),
            "E_i": Given(float(run.kept[row]), "J", tr("what is kept of the position before, doubled")),
            "W_i": Given(float(run.gained[row]), "J", tr("what the moments add on the step, doubled")),
            "Deltaphi": Given(nodes.step, "rad", tr("step of the positions")),
        }
    )


def _larger(result: Motion, jumps: Sequence[int]) -> Iterator[Paragraph]:
    """What the textbook's methods take for a moment that jumps in these positions."""
    if jumps:
        labels = ", ".join(result.labels[row] for row in jumps)
        yield Paragraph(
            tr(
                "Where $M_c$ jumps in a position (here {labels}), the value that is larger in magnitude is taken.",
                labels=labels,
            )
        )


def _turns(result: Motion, run: Run, idle: Run | None, jumps: Sequence[int]) -> Iterator[Block]:
    """The angular velocity turn by turn from the rated one, loaded and idle."""
    if not run.history:
        yield Paragraph(tr("Begun with the rated angular velocity the recurrence does not settle."))
        return
    columns: dict[str, Values] = {"$M_c$, N*m": run.nodes.moment, "$J$, kg*m^2": run.nodes.inertia}
    columns |= {f"$omega^{{({k + 1})}}$, rad/s": run.turn(k) for k in range(min(len(run.history), TURNS))}
    if len(run.history) <= TURNS:
        said = tr(
            "Turn by turn, begun with the rated angular velocity, the angular velocities come to those that repeat "
            "themselves, table {tab:motion_turns}."
        )
    else:
        said = tr(
            "Turn by turn, begun with the rated angular velocity, the angular velocities come to those that repeat "
            "themselves, after {count}; table {tab:motion_turns} has the first turns, and $omega$ that repeats itself.",
            count=tr_count(len(run.history), "turn", "turns"),
        )
        columns["$omega$, rad/s"] = run.regime.omega
    yield Paragraph(said)
    yield from _larger(result, jumps)
    if idle is not None:
        columns["$omega_x$, rad/s"] = idle.regime.omega
        yield Paragraph(tr("In the table $omega_x$ is the angular velocity without technological loads."))
    caption = tr("Angular velocity by the recurrence, turn by turn")
    yield tabulated(caption, columns, result.labels, head=tr("No."), key="motion_turns")


def _by_energy(result: Motion, order: Order) -> Iterator[Block]:
    """The textbook's motion without a motor: the kinetic energy at the positions."""
    found = result.by_energy
    if found is None:
        return
    reduction: Reduction = order.results["reduction"]
    n, speed = len(result.phi) - 1, result.regime.mean
    moment, links = nodal_tables(reduction.cycle, n, speed)
    work, drive = nodal_work(moment, reduction.cycle.period)
    inertia = links + result.inertia.total
    yield Heading(tr("Angular velocity by the kinetic energy"), 3)
    yield Paragraph(
        tr(
            "The kinetic energy in position 0 is taken at the mean angular velocity. The trapezoid rule gives the work "
            "of all moments from position to position; the driving moment $M_dm^t$ makes the work of the cycle zero by "
            "the same rule:"
        )
    )
    rows = _shown(result, order)
    places = []
    for row in rows:
        excess, energy = tr("excess work from position 0"), tr("kinetic energy of the machine")
        lexicon = {
            "T_0": Given(found.energy, "J", energy),
            "J_{(0)}": Given(float(inertia[0]), "kg*m^2", tr("moment of inertia of the machine in position 0")),
            "omega_m": mean_speed(speed),
            "A_i": Given(float(work[row]), "J", excess),
            "A_{i−1}": Given(float(work[row - 1]), "J", excess),
            "M_{c,i}": Given(float(moment[row]), "N*m", tr("reduced moment of the loads")),
            "M_{c,i−1}": Given(float(moment[row - 1]), "N*m", tr("reduced moment of the loads")),
            "M_dm^t": Given(drive, "N*m", tr("mean driving moment on the input link by the trapezoid rule")),
            "Deltaphi": Given(reduction.cycle.period / n, "rad", tr("step of the positions")),
            "T_i": Given(found.energy + float(work[row]), "J", energy),
            "J_i": Given(float(inertia[row]), "kg*m^2", tr("moment of inertia of the machine")),
            "omega_i": Given(float(found.omega[row]), "rad/s", tr("angular velocity of the input link")),
        }
        places.append(Place(tr("pos. {label}", label=result.labels[row]), named(lexicon)))
    yield from lines(("T_0 = J_{(0)}*omega_m**2/2",), [Place("", places[0].lexicon)])
    texts = (
        "A_i = A_{i−1} + (M_{c,i−1} + M_{c,i} + 2*M_dm^t)*Deltaphi/2",
        "T_i = T_0 + A_i",
        "omega_i = sqrt(2*T_i/J_i)",
    )
    yield from lines(texts, places)
    columns = {
        "$M_c$, N*m": moment,
        "$A$, J": work,
        "$T$, J": found.energy + work,
        "$J$, kg*m^2": inertia,
        "$omega$, rad/s": found.omega,
    }
    yield Paragraph(tr("Energies and angular velocities at all positions are in table {tab:motion_energies}."))
    yield from _larger(result, nodal_jumps(reduction, speed))
    caption = tr("Kinetic energy and angular velocity at the positions")
    yield tabulated(caption, columns, result.labels, head=tr("No."), key="motion_energies")


def _exact(result: Motion, order: Order) -> Iterator[Block]:
    """The differential equation, one position by the numbers, the table, the diagram."""
    reduction: Reduction = order.results["reduction"]
    yield Heading(tr("Exact motion"), 3)
    yield Paragraph(
        tr(
            "The derivative of the kinetic energy with respect to the angle gives the equation of motion, which the "
            "program solves for the whole cycle at once; with its solution, table {tab:motion_exact} and figure "
            "{fig:motion_speed},"
        )
    )
    cycle = reduction.cycle
    links, slopes = sided(cycle, cycle.panels, np.stack((cycle.inertia, cycle.slope)), result.theta, result.early)
    places, letters = [], reduced()
    for row in _shown(result, order):
        lexicon = {
            "eps": Given(float(result.eps[row]), "rad/s^2", tr("angular acceleration of the input link")),
            "omega": Given(float(result.omega[row]), "rad/s", tr("angular velocity of the input link")),
            "M_d": Given(float(result.driving[row]), "N*m", tr("moment of the drive")),
            "M_c": Given(float(result.load[row]), "N*m", tr("reduced moment of the loads")),
            "J_c": Given(result.inertia.total, "kg*m^2", tr("constant moment of inertia of the machine")),
            letters["J"]: Given(float(links[row]), "kg*m^2", tr("reduced moment of inertia of the links")),
            letters["dJ"]: Given(
                float(slopes[row]),
                "kg*m^2/rad",
                tr("derivative of the reduced moment of inertia"),
            ),
        }
        places.append(Place(tr("pos. {label}", label=result.labels[row]), named(lexicon)))
    yield from lines(("eps = (M_d + M_c - 0.5*<dJ>*omega**2)/(J_c + <J>)",), places, letters)
    missed = result.regime.errors
    same = max(SAME, missed.speed, missed.acceleration, missed.moment)
    yield from two_sides(result.labels, (result.eps, result.load), same)
    columns: dict[str, Values] = {
        "$phi$, deg": np.degrees(result.phi),
        "$omega$, rad/s": result.omega,
        "$eps$, rad/s^2": result.eps,
        "$t$, s": result.time,
        "$M_d$, N*m": result.driving,
        "$M_c$, N*m": result.load,
    }
    if result.omega_idle is not None:
        columns["$omega_x$, rad/s"] = result.omega_idle
        yield Paragraph(tr("In the table $omega_x$ is the angular velocity without technological loads."))
    caption = tr("Steady motion of the machine")
    yield tabulated(caption, columns, result.labels, head=tr("No."), key="motion_exact")
    draw = partial(draw_speed, result=result, cycle=reduction.cycle)
    yield drawn(tr("Angular speed of the input link"), draw, SPEED, "motion_speed")


def _unevenness(result: Motion, order: Order) -> Iterator[Block]:
    """The coefficient of speed fluctuation, loaded and idle, against what is allowed and by the textbook."""
    regime, sense = result.regime, math.copysign(1.0, result.phi[-1])
    yield Heading(tr("Coefficient of speed fluctuation"), 3)
    first, second = (degrees(sense * at) for at in (regime.theta_max, regime.theta_min))
    yield Paragraph(
        tr(
            "Over the cycle the angular velocity is largest at $phi = {first}$ and least at $phi = {second}$:",
            first=first,
            second=second,
        )
    )
    texts = ("omega_m<x> = (omega_max<x> + omega_min<x>)/2", "delta<x> = (omega_max<x> - omega_min<x>)/omega_m<x>")
    yield from lines(texts, [Place("", _fluctuating(regime, ""))], {"x": ""})
    given = order.results["reduction"].cycle.speed
    if abs(regime.mean / given - 1) > ALIKE:
        said = tr(
            "Loads, inertia forces and friction were found at the given angular velocity of the input link, {given} "
            "rad/s; the mean one of the motion differs from it by {off} %.",
            given=plainly(given),
            off=plainly(100 * (regime.mean / given - 1), 3),
        )
        yield Paragraph(said)
    if result.idle is not None:
        yield Paragraph(tr("Without technological loads:"))
        yield from lines(texts, [Place("", _fluctuating(result.idle, "^x"))], {"x": "^x"})
    yield from _against(result, order)


def _fluctuating(regime: Regime, mark: str) -> Lexicon:
    """Extreme and mean speeds of a regime and their coefficient, with the upper index ``mark``."""
    return named(
        {
            f"omega_max{mark}": Given(regime.omega_max, "rad/s", tr("largest angular velocity")),
            f"omega_min{mark}": Given(regime.omega_min, "rad/s", tr("least angular velocity")),
            f"omega_m{mark}": mean_speed(regime.mean),
            f"delta{mark}": Given(regime.delta, "", tr("coefficient of speed fluctuation")),
        }
    )


def _against(result: Motion, order: Order) -> Iterator[Block]:
    """What the textbook's way is off, and whether what is allowed is kept."""
    nodal = result.textbook.regime.delta if result.textbook is not None else None
    if result.by_energy is not None:
        nodal = result.by_energy.delta
    if nodal is not None and result.regime.delta:
        off = 100 * (nodal / result.regime.delta - 1)
        said = tr(
            "By the positions alone $delta$ = {nodal}, the difference amounts to {off} %.",
            nodal=plainly(nodal),
            off=plainly(off, 3),
        )
        yield Paragraph(said)
    table = order.spec.flywheel
    if table is not None and table.delta is not None:
        delta = result.regime.delta
        kept = delta <= table.delta * (1 + REACHED)
        yield held("delta <= delta_0", (delta, table.delta), "", holds=kept)


def _regulation(result: Motion, order: Order) -> Iterator[Block]:
    """How the speed settles by itself, and how the motor bears the motion."""
    regime, found = result.regime, driven(order)
    yield Heading(tr("Regulation and load of the motor") if result.motor is not None else tr("Regulation"), 3)
    if regime.stable is None:
        yield Paragraph(
            tr(
                "No moment depends on the speed: the machine does not regulate itself, a governor has to hold its mean "
                "speed."
            )
        )
    else:
        yield from _stability(regime)
    if result.motor is None or found is None:
        return
    power = order.results["power"]
    rated = found[1].speed / power.duty.ratio
    yield Paragraph(tr("The least angular velocity against the rated one:"))
    yield held("omega_min >= omega_N", (regime.omega_min, rated), "rad/s", holds=regime.omega_min >= rated)
    yield Result("omega_min", Given(regime.omega_min, "rad/s", tr("least angular velocity")), rated, ">=")
    yield from _heating(result)


def _stability(regime: Regime) -> Iterator[Block]:
    """What of a deviation is left after a cycle."""
    left = abs(regime.multipliers[0])
    if not regime.stable:
        yield Paragraph(tr("A small deviation of the speed grows: the motion is unstable."))
        return
    said = (
        tr(
            "Of a small deviation of the speed {part} % is left after a cycle: the motion is stable.",
            part=plainly(100 * left, 3),
        )
        if left > NOTHING
        else tr("Nothing noticeable of a small deviation of the speed is left after a cycle: the motion is stable.")
    )
    yield Paragraph(said)


def _heating(result: Motion) -> Iterator[Block]:
    """The mean square moment at the motor's shaft against the rated one."""
    motor = result.motor
    assert motor is not None
    rms = tr("root mean square of the moment on the shaft of the motor")
    if motor.heating is None or motor.rated_moment is None:
        return
    lexicon = {
        "M_q": Given(motor.rms_moment, "N*m", rms),
        "M_Nd": Given(motor.rated_moment, "N*m", tr("rated moment on the shaft of the motor")),
        "k_q": Given(motor.heating, "", tr("coefficient of heating")),
    }
    yield Paragraph(tr("The motor warms with the mean square of its moment over the time:"))
    yield from lines(("k_q = M_q/M_Nd",), [Place("", named(lexicon))])
    yield held("k_q <= 1", (motor.heating, 1.0), "", holds=motor.heating <= 1 + SLACK)
    yield Result("k_q", lexicon["k_q"], 1.0, "<=")
