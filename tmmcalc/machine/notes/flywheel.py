"""The chapter on motion, its part on the flywheel: excess work, energy-mass curve, all methods, the wheel."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from tmmcalc.machine.flywheel.materials import RECOMMENDED
from tmmcalc.machine.flywheel.results import Flywheel, RequiredInertia, Trial
from tmmcalc.machine.flywheel.worked import Paper, Worked, curve_columns, paper, round_scales
from tmmcalc.machine.notes.motors import of_motor
from tmmcalc.machine.notes.told import inertias, mean_speed, reduced
from tmmcalc.machine.notes.wheel import of_wheel
from tmmcalc.machine.pictures.constructions import draw_ordinates, machine_of
from tmmcalc.machine.pictures.energymass import draw_energy_mass
from tmmcalc.machine.pictures.words import method_name
from tmmcalc.machine.power import Power, moment_at
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.stages.flywheel import mean, methods_of
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import degrees, drawn, held, lines, named, numeral, tabulated

SAME = 1e-4  # of the inertia: trials nearer than this are one
AROUND, ORDINATES = 60.0, 105.0  # above and below the energy-mass curve; height of the ordinates [mm]
DIVISOR = "(delta_0*omega_m**2)"


class Method(NamedTuple):
    """One method by the numbers: its own letters have the upper index ``<i>``."""

    title: str
    said: str  # what it takes
    lines: tuple[str, ...]


class Told(NamedTuple):
    """What the part tells from."""

    result: Flywheel
    reduction: Reduction
    worked: Mapping[str, Worked]  # by their keys
    speed: float  # mean [rad/s]
    on_paper: Paper


def blocks(order: Order) -> Iterator[Block]:
    """The motor, the excess work, the curve with its tangents, the methods side by side, the flywheel and its rim."""
    yield from of_motor(order, "flywheel")
    result: Flywheel = order.results["flywheel"]
    speed, picture = mean(order.spec, order.results), result.picture
    every = {each.key: each for each in methods_of(order.spec, order.results)}
    on_paper = paper(picture, round_scales(picture), result.sense)
    told = Told(result, order.results["reduction"], every, speed, on_paper)
    yield from _excess(told, order.results.get("power"))
    yield from _curve(told)
    yield from _methods(told)
    yield from _inertia(told, order)
    yield from of_wheel(order)


def _excess(told: Told, power: Power | None) -> Iterator[Block]:
    """The moment that closes the cycle, unless it is that of the mean power, and the excess work at the positions."""
    result = told.result
    yield Heading(tr("Excess work"), 2)
    if power is not None and math.isclose(power.mean_moment, result.picture.drive):
        yield Paragraph(
            tr(
                "The flywheel has to keep the coefficient of speed fluctuation $delta_0 = {delta}$ at the mean angular "
                "velocity $omega_m = {speed}$ rad/s. The methods take the drive as constant, with the mean driving "
                "moment $M_dm = {moment}$ N·m.",
                delta=numeral(result.delta),
                speed=numeral(told.speed),
                moment=numeral(result.picture.drive),
            )
        )
    else:
        yield from _closing(told)
    yield Paragraph(tr("The excess work is the work of all moments from position 0, the change of the kinetic energy:"))
    yield Display(read("A = DeltaT = T - T_0"))
    yield from _excess_table(told)


def _closing(told: Told) -> Iterator[Block]:
    """The constant moment that makes the work of the cycle zero."""
    cycle, result = told.reduction.cycle, told.result
    yield Paragraph(
        tr(
            "The flywheel has to keep the coefficient of speed fluctuation $delta_0 = {delta}$ at the mean angular "
            "velocity $omega_m = {speed}$ rad/s. The methods take the drive as a constant moment that makes the work "
            "of the cycle zero:",
            delta=numeral(result.delta),
            speed=numeral(told.speed),
        )
    )
    work = float(cycle.panels.total(moment_at(cycle, told.speed)))
    lexicon = {
        "M_{dm}": Given(result.picture.drive, "N*m", tr("mean driving moment on the input link")),
        "A_Sigma": Given(work, "J", tr("work of the reduced moments of all forces over the cycle")),
        "phi_c": Given(cycle.period, "rad", tr("angle of the cycle")),
    }
    yield from lines(("M_{dm} = -A_Sigma/phi_c",), [Place("", named(lexicon))])


def _excess_table(told: Told) -> Iterator[Block]:
    """The excess work and what the links have of it at the positions; where it is extreme."""
    reduction, result = told.reduction, told.result
    cycle = reduction.cycle
    theta = np.minimum(np.abs(reduction.phi - reduction.phi[0]), cycle.period)
    found = {each.name: each.make() for each in curve_columns(result.picture, cycle, theta, told.speed, (1.0, 1.0))}
    inertia = reduced()["J"]
    columns = {
        "$phi$, deg": np.degrees(reduction.phi),
        "$A$, J": found["A"],
        f"${inertia}$, kg*m^2": found["J_red"],
        "$T_II$, J": found["T_links"],
        "$A - T_II$, J": found["T_rest"],
    }
    yield Paragraph(
        tr(
            "Table {tab:flywheel_work} has the excess work, the reduced moment of inertia ${J}$ of the links and their "
            "kinetic energy at the mean angular velocity, $T_II = {J}*omega_m**2/2$.",
            J=inertia,
        )
    )
    extreme = told.worked["excess_work_by_cycle"]
    values = {
        "high": numeral(extreme.work_max),
        "at_high": degrees(extreme.at_max),
        "low": numeral(extreme.work_min),
        "at_low": degrees(extreme.at_min),
    }
    yield Paragraph(
        tr(
            "Over the cycle the excess work is largest, $A = {high}$ J, at $phi = {at_high}$, and least, "
            "$A = {low}$ J, at $phi = {at_low}$.",
            **values,
        )
    )
    caption = tr("Excess work and kinetic energy of the links")
    yield tabulated(caption, columns, reduction.labels, head=tr("No."), key="flywheel_work")


def _curve(told: Told) -> Iterator[Block]:
    """Wittenbauer's construction: angles of the tangents, the segment, the inertia; then the picture."""
    exact, on_paper = told.worked["exact_by_cycle"], told.on_paper
    yield Heading(tr("Energy-mass curve"), 2)
    yield Paragraph(
        tr(
            "Eliminating the angle $phi$ from $A$ and ${J}$ gives the closed energy-mass curve, figure "
            "{fig:flywheel_curve}. The angular velocity is largest and least where the tangents at the angles "
            "$psi_max$ and $psi_min$ touch it, at $phi = {first}$ and $phi = {second}$:",
            J=reduced()["J"],
            first=degrees(exact.at_max),
            second=degrees(exact.at_min),
        )
    )
    scales = {
        "mu_A": Given(on_paper.energy_scale, "J/mm", tr("scale factor of the energies")),
        "mu_J": Given(on_paper.inertia_scale, "kg*m^2/mm", tr("scale factor of the moments of inertia")),
    }
    angle = tr("angle of the tangent")
    lexicon = _lexicon(told, exact, "") | named(
        {
            **scales,
            "psi_max": Given(math.degrees(on_paper.angle_max), "deg", angle),
            "psi_min": Given(math.degrees(on_paper.angle_min), "deg", angle),
            "l_GH": Given(on_paper.segment, "mm", tr("segment between the tangents on the axis of energies")),
        }
    )
    place = [Place("", lexicon)]
    angles = (
        "psi_max = atan(mu_J*omega_m**2*(1 + delta_0/2)**2/(2*mu_A))",
        "psi_min = atan(mu_J*omega_m**2*(1 - delta_0/2)**2/(2*mu_A))",
    )
    yield from lines(angles, place)
    yield Paragraph(tr("On the axis of energies the tangents cut off"))
    segment = (
        "G = A_1 - J_1*omega_m**2*(1 + delta_0/2)**2/2",
        "H = A_2 - J_2*omega_m**2*(1 - delta_0/2)**2/2",
        "l_GH = (G - H)/mu_A",
    )
    yield from lines(segment, place)
    yield Paragraph(tr("The constant moment of inertia that the machine must have"))
    yield from lines((f"J_F = mu_A*l_GH/{DIVISOR}",), place)
    if told.result.required is None:
        yield Result("J_F", lexicon["J_F"])
    draw = partial(
        draw_energy_mass,
        picture=told.result.picture,
        sense=told.result.sense,
        scales=(on_paper.energy_scale, on_paper.inertia_scale),
    )
    high = float(np.ptp([*told.result.picture.work, *told.result.picture.intercepts])) / on_paper.energy_scale
    yield drawn(tr("Energy-mass curve"), draw, high + AROUND, "flywheel_curve")


def _lexicon(told: Told, found: Worked, index: str) -> Lexicon:
    """The numbers of a method, its own ones with an upper index."""
    mark = f"^{{({index})}}" if index else ""
    cut = tr("what the tangent cuts off on the axis of energies")
    needed = tr("constant moment of inertia that is needed, reduced to the input link")
    if index not in ("", "2"):  # told with the first of the methods
        cut = needed = ""
    work = links = ""
    if not index:
        work, links = tr("excess work where the tangent touches"), tr("reduced moment of inertia of the links there")
    return named(
        {
            "delta_0": Given(told.result.delta, "", tr("allowed coefficient of speed fluctuation")),
            "omega_m": mean_speed(told.speed),
            f"A_1{mark}": Given(found.work_max, "J", work),
            f"A_2{mark}": Given(found.work_min, "J", work),
            f"J_1{mark}": Given(found.links_max, "kg*m^2", links),
            f"J_2{mark}": Given(found.links_min, "kg*m^2", links),
            f"G{mark}": Given(found.intercept_max, "J", cut),
            f"H{mark}": Given(found.intercept_min, "J", cut),
            f"J_F{mark}": Given(found.inertia, "kg*m^2", needed),
        }
    )


def _methods(told: Told) -> Iterator[Block]:
    """The approximate methods, each by its formulas, and all of them in a table."""
    yield Heading(tr("Approximate methods"), 2)
    names = ("book", "mertsalov", "artobolevsky", "excess work")
    for k, name in enumerate(names, 2):
        found = told.worked[f"{name.replace(' ', '_')}_by_cycle"]
        method = _method(name)
        yield Heading(method.title, 3)
        at = {
            "first": degrees(found.at_max),
            "second": degrees(found.at_min),
        }
        where = tr("The extremes stand at $phi = {first}$ and $phi = {second}$.", **at)
        yield Paragraph(f"{method.said} {where}")
        place = [Place("", _lexicon(told, found, str(k)))]
        yield from lines(method.lines, place, {"i": f"^{{({k})}}"})
    picture, reduction = told.result.picture, told.reduction
    machine = machine_of(picture, reduction.cycle, reduction.phi, told.result.delta)
    draw = partial(draw_ordinates, machine=machine)
    yield drawn(tr("Excess work by Mertsalov and Artobolevsky"), draw, ORDINATES, "flywheel_ordinates")
    yield from _compared(told)


def _method(name: str) -> Method:
    """What a method takes, and its formulas."""

    def three(more: str = "", less: str = "") -> tuple[str, ...]:
        upper, lower = f"G<i> = A_1<i> - J_1<i>*omega_m**2{more}/2", f"H<i> = A_2<i> - J_2<i>*omega_m**2{less}/2"
        return upper, lower, f"J_F<i> = (G<i> - H<i>)/{DIVISOR}"

    slopes = three("*(1 + delta_0)", "*(1 - delta_0)")
    return {
        "book": Method(
            tr("Tangents without the square of the coefficient"),
            tr("The small square of $delta_0$ is dropped from the slopes of the tangents."),
            slopes,
        ),
        "mertsalov": Method(
            tr("Method of Mertsalov"),
            tr(
                "The kinetic energy of the links is taken at the mean angular velocity; what is left of the excess "
                "work, $A - T_II$, falls to the flywheel, figure {fig:flywheel_ordinates}. Its ordinates measured in "
                "the figure are $y_max = G^{(3)}/mu_A$ and $y_min = H^{(3)}/mu_A$."
            ),
            three(),
        ),
        "artobolevsky": Method(
            tr("Method of Artobolevsky"),
            tr(
                "The angular velocity is taken as extreme where the excess work is; the energy of the links counts "
                "there with the extreme angular velocities. In the same figure $y_a$ and $y_b$ are the ordinates of "
                "the excess work there, $z_a$ and $z_b$ those of the moment of inertia, in mm."
            ),
            slopes,
        ),
        "excess work": Method(
            tr("By the largest excess work"),
            tr("The kinetic energy of the links is neglected."),
            (f"J_F<i> = (A_1<i> - A_2<i>)/{DIVISOR}",),
        ),
    }[name]


def _compared(told: Told) -> Iterator[Block]:
    """All methods side by side: over the cycle, at the positions alone, and what each really leads to."""
    result = told.result
    names = [row.positional.method for row in result.rows]
    columns: dict[str, list[float | None]] = {
        "$J_F$, kg*m^2": [row.positional.inertia for row in result.rows],
        tr("difference, %"): [100 * row.positional.error for row in result.rows],
    }
    nodal = [told.worked.get(f"{name.replace(' ', '_')}_by_positions") for name in names]
    if all(nodal):
        columns[tr("$J_F$ by positions, kg*m^2")] = [each.inertia for each in nodal if each is not None]
    if result.addition > 0:
        columns[tr("$delta$ by positional forces")] = [row.positional.delta for row in result.rows]
        if result.required is not None:
            columns[tr("$delta$ under the motor")] = [row.delta for row in result.rows]
    said = tr("Table {tab:flywheel_methods} compares the methods with the exact one.")
    if all(nodal):
        said += " " + tr(
            "By the positions alone, with works by the trapezoid rule, jumps and extremes between them are missed."
        )
    yield Paragraph(said)
    shown = {head: [math.nan if each is None else each for each in cells] for head, cells in columns.items()}
    caption = tr("Constant moment of inertia by all methods")
    yield tabulated(caption, shown, list(map(_named, names)), head=tr("Method"), key="flywheel_methods")


def _named(name: str) -> str:
    return tr("without the square of $delta_0$") if name == "book" else method_name(name)


def _inertia(told: Told, order: Order) -> Iterator[Block]:
    """What of the inertia is at hand, and what the flywheel has to add."""
    result = told.result
    yield Heading(tr("Moment of inertia of the flywheel"), 2)
    needed = result.rows[0].positional.inertia
    symbol, said = "J_F", tr("constant moment of inertia that is needed, reduced to the input link")
    if result.required is not None:
        yield from _under_motor(result)
        needed = result.required.inertia
        symbol = "J_c^{*}" if result.existing else "J_c"  # the machine's own one, unless another wheel is there
        said = tr("constant moment of inertia with which the steady motion keeps $delta_0$")
    lexicon = {
        **inertias(result.at_hand, order),
        "J_0": Given(result.without, "kg*m^2", tr("constant moment of inertia at hand without a flywheel")),
        symbol: Given(needed, "kg*m^2", said),
        "J_M": Given(result.addition, "kg*m^2", tr("moment of inertia of the flywheel, reduced to the input link")),
    }
    place = [Place("", named(lexicon))]
    yield from lines(("J_0 = J_R*u**2 + J_g + J_e",), place)
    if result.addition > 0:
        yield from lines((f"J_M = {symbol} - J_0",), place)
        if result.required is not None:
            yield Result(symbol, lexicon[symbol])
        yield Result("J_M", lexicon["J_M"])
    elif result.required is not None:
        delta = result.required.delta
        yield held("delta <= delta_0", (delta, result.delta), "", holds=True)
        yield Paragraph(tr("What is at hand suffices: no flywheel is needed."))
    else:
        yield held("J_0 >= J_F", (result.without, needed), "kg*m^2", holds=True)
        yield Paragraph(tr("What is at hand suffices: no flywheel is needed."))
    yield from _customary(result.delta)


def _under_motor(result: Flywheel) -> Iterator[Block]:
    """The true inertia by trials of the motion, and the textbook's correction."""
    required = result.required
    assert required is not None
    yield Paragraph(
        tr(
            "The motor gives way when it is loaded, and evens the speed by itself. So the constant moment of inertia "
            "is sought for which the steady motion under the characteristic of the motor keeps $delta_0$; table "
            "{tab:flywheel_trials} has the motions that were computed, in the order of $J$."
        )
        if not result.undriven
        else tr(
            "The loads set the speed. So the constant moment of inertia is sought for which the steady motion keeps "
            "$delta_0$; table {tab:flywheel_trials} has the motions that were computed, in the order of $J$."
        )
    )
    yield _trials(list(_apart(required)), tr("Trials of the constant moment of inertia"), "flywheel_trials")
    if len(result.history) < 2:
        return
    first, second = result.history[:2]
    assert first.delta is not None
    yield Paragraph(
        tr(
            "The correction of the textbook multiplies the constant moment of inertia by the fluctuation over the "
            "allowed one until it is reached, table {tab:flywheel_correction}; in the first step"
        )
    )
    said = tr("constant moment of inertia in the step")
    lexicon = {
        "J^{(1)}": Given(second.inertia, "kg*m^2", said),
        "J^{(0)}": Given(first.inertia, "kg*m^2", said),
        "delta^{(0)}": Given(first.delta, "", tr("coefficient of speed fluctuation in the step")),
        "delta_0": Given(result.delta, "", tr("allowed coefficient of speed fluctuation")),
    }
    yield from lines(("J^{(1)} = J^{(0)}*delta^{(0)}/delta_0",), [Place("", named(lexicon))])
    yield _trials(result.history, tr("Correction of the constant moment of inertia"), "flywheel_correction")


def _apart(required: RequiredInertia) -> Iterator[Trial]:
    """The trials that differ as they are printed: of those that do not, that which keeps the coefficient."""
    kept = [trial for trial in required.trials if trial.inertia == required.inertia]
    for trial in required.trials:
        if all(abs(trial.inertia - each.inertia) > SAME * trial.inertia for each in kept):
            kept.append(trial)
    yield from sorted(kept, key=lambda trial: trial.inertia)


def _trials(trials: Sequence[Trial], caption: str, key: str) -> Block:
    columns = {
        "$J$, kg*m^2": [trial.inertia for trial in trials],
        "$delta$": [math.nan if trial.delta is None else trial.delta for trial in trials],
    }
    return tabulated(caption, columns, [str(k) for k in range(len(trials))], head=tr("No."), key=key)


def _customary(delta: float) -> Iterator[Block]:
    """For which machines the coefficient is customary."""
    machines = [tr_name(kind.machine) for kind in RECOMMENDED if kind.smallest * 0.999 <= delta <= kind.largest * 1.001]
    if machines:
        said = tr("This coefficient of speed fluctuation is customary for: {machines}.", machines="; ".join(machines))
        yield Paragraph(said)
