"""The textbook's methods for the steady motion, position by position: the recurrence, the kinetic energy."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.nodes import nodal_tables, nodal_work
from tmmcalc.machine.notes.told import mean_speed, reduced, shown
from tmmcalc.machine.reduction.jumps import nodal_jumps
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.stepwise import Run, idle_run_of, run_of
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_count
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place
from tmmcalc.report.telling import held, lines, named, tabulated

TURNS = 5  # of the iteration that are shown in the table of turns
SOUND = 1.0  # B dphi/J up to which the recurrence does not swing


def by_recurrence(result: Motion, order: Order) -> Iterator[Block]:
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
    rows = shown(result, order)
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


def by_energy(result: Motion, order: Order) -> Iterator[Block]:
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
    rows = shown(result, order)
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
