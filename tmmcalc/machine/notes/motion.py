"""The chapter on motion, its part on the steady motion: what drives, the exact regime, how it regulates itself."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.motion import Motion, sided
from tmmcalc.machine.notes.motors import driven, of_motor
from tmmcalc.machine.notes.textbook import by_energy, by_recurrence
from tmmcalc.machine.notes.told import inertias, mean_speed, reduced, shown
from tmmcalc.machine.pictures.motion import draw_speed
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.verdicts import SLACK
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
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
NOTHING = 1e-6  # of a deviation after a cycle: less is nothing
EVEN = 1e-9  # coefficient of speed fluctuation below which the speed is constant
ALIKE = 1e-6  # relative difference of angular velocities: less is none
REACHED = 1e-6  # of the allowed coefficient: what it may be above


def blocks(order: Order) -> Iterator[Block]:
    """What drives, the constant inertia, the textbook's way step by step, the exact regime with its checks."""
    yield from of_motor(order, "motion")
    result: Motion = order.results["motion"]
    yield from _machine(result, order)
    if result.regime.delta > EVEN:
        yield from by_recurrence(result, order)
        yield from by_energy(result, order)
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
    for row in shown(result, order):
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
