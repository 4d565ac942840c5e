"""Ties of a load: their forces by the source and by equilibrium, from which inertia on something begins."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

from tmmcalc.extras.notes.told import course, given
from tmmcalc.extras.pictures.tie_down import draw_tie_down
from tmmcalc.extras.tables.tasks.tie_down import to_tie_down
from tmmcalc.extras.tie_down import TieDown, TieDownTask, unheld
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import data_of, drawn, held, lines, named, number_of, numeral

KILO, MEGA = 1e-3, 1e6
PRELOAD = "P_0 = M/(d_2*tan(gamma + rho'))"
FREE = ("F = k*G_2", "G = G_2 + V")
HELD = ("F = k*G_2 - mu_s*(G_o + G_2*b/L + k*G_2*D/(2*L))", "G = G_2*a/L - k*G_2*D/(2*L) + V")
SOURCE = "R = (F - mu*G)/(2*(mu*sin(alpha) + cos(alpha)*cos(beta)))"
ALL_TIES = "R_b = P_0 + (F - mu*G)/(4*cos(alpha)*cos(beta))"
TWO_TIES = "R_b = (F - mu*(G - V))/(2*(mu*sin(alpha) + cos(alpha)*cos(beta)))"
GROWTH = {  # of what friction does not hold, with and without a support
    False: ("F_0 = mu*(G_2 + V)", "F_1 = G_2"),
    True: ("F_0 = mu_s*(G_o + G_2*b/L) + mu*(G_2*a/L + V)", "F_1 = G_2*(1 + (mu - mu_s)*D/(2*L))"),
}
BEGINS = {
    "k_1": "k_1 = F_0/F_1",
    "k_2": "k_2 = (4*P_0*cos(alpha)*cos(beta) + F_0)/F_1",
    "k_3": "k_3 = (2*P_0*(mu*sin(alpha) + cos(alpha)*cos(beta)) + F_0)/F_1",
    "k_4": "k_4 = (4*P_0*(mu*sin(alpha) + cos(alpha)*cos(beta)) + F_0)/F_1",
}
TIGHT = "k_5 = (4*(A*sigma_y - P_0)*cos(alpha)*cos(beta) + F_0)/F_1"
SLACK = "k_5 = (2*A*sigma_y*(mu*sin(alpha) + cos(alpha)*cos(beta)) - mu*V + F_0)/F_1"
TIPS = "k_6 = 2*(G_2*a + V*L)/(G_2*D)"
FIGURE = 110.0  # height [mm]


def blocks(order: Order) -> Iterator[Block]:
    """Loads, forces of the ties by both ways, their stress, the thresholds, the course over the inertia."""
    result: TieDown = order.results["tie_down"]
    task = to_tie_down(order.spec)
    known = _known(task)
    place = Place("", named(known | _quantities(result, task)))
    yield Heading(tr("Ties of a load"))
    yield _ties()
    yield from given(data_of(known), "tie_down")
    yield Heading(tr("Forces on the load"), 3)
    if task.thread is not None:
        yield Paragraph(tr("The thread, right-handed at one end and left-handed at the other, tightens a tie to"))
        yield from lines([PRELOAD], [place])
    if result.preload:
        yield Paragraph(tr("The preload of the four ties presses the load on its cradle:"))
        yield from lines(["V = 4*P_0*sin(alpha)"], [place])
    yield Paragraph(
        tr("The force that moves the load, less the friction of the sliding support, and the force on the cradle:")
        if task.support is not None
        else tr("The force that moves the load, and the force on the cradle:")
    )
    yield from lines(HELD if task.support is not None else FREE, [place])
    yield Heading(tr("Forces of the ties"), 3)
    yield from _by_source(result, task, place)
    yield from _by_equilibrium(result, task, place)
    yield Paragraph(tr("The force of a tie is least at this elevation:"))
    yield from lines(["alpha_0 = atan(mu/cos(beta))"], [place])
    if result.stress is not None:
        yield from _stress(result, place)
    yield from _thresholds(result, task, place)
    yield from _course(result)


def data(order: Order) -> Iterator[Block]:
    """How the load is held, the load, its ties and its support."""
    task = to_tie_down(order.spec)
    yield _ties()
    if task.thread is not None:
        yield Paragraph(tr("The thread of a tie is right-handed at one end and left-handed at the other."))
    if task.support is not None:
        yield Paragraph(
            tr(
                "The load stands on a fixed cradle, which carries $G_2*a/L$ of its weight, and on a sliding support, "
                "which carries $G_2*b/L$; the inertia force acts by $D/2$ above them and presses the support by "
                "$k*G_2*D/(2*L)$ more. The ties press the load on the cradle alone."
            )
        )
    yield from data_of(_known(task))


def _ties() -> Paragraph:
    return Paragraph(
        tr(
            "Four ties hold the load, two along each direction of the way. The inertia force of the vehicle stretches "
            "two of them and slackens the others."
        )
    )


def _known(task: TieDownTask) -> Lexicon:
    angle, thread, support = math.degrees, task.thread, task.support
    found = {
        "G_2": Given(task.weight, "N", tr("weight of the load")),
        "k": Given(task.factor, "", tr("inertia force over the weight")),
        "mu": Given(task.friction, "", tr("coefficient of friction of the load on its cradle")),
        "alpha": Given(angle(task.elevation), "deg", tr("angle of the ties above the floor")),
        "beta": Given(angle(task.plan), "deg", tr("angle of the ties in plan from the way")),
    }
    if thread is None:
        found["P_0"] = Given(task.preload, "N", tr("preload of a tie"))
    else:
        found["M"] = Given(thread.moment, "N*m", tr("moment by which the thread is tightened"))
        found["d_2"] = Given(thread.diameter, "m", tr("mean diameter of the thread"))
        found["gamma"] = Given(angle(thread.lead), "deg", tr("lead angle of the thread"))
        found["rho'"] = Given(angle(thread.friction_angle), "deg", tr("reduced angle of friction of the thread"))
    if task.section is not None:
        found["A"] = Given(1e6 * task.section, "mm^2", tr("section of a tie"))
    if task.strength is not None:
        found["sigma_y"] = Given(task.strength / MEGA, "MPa", tr("yield stress of a tie"))
    if support is not None:
        found["G_o"] = Given(support.weight, "N", tr("weight of the sliding support"))
        found["mu_s"] = Given(support.friction, "", tr("coefficient of friction of the sliding support"))
        found["L"] = Given(support.base, "m", tr("distance of cradle and support"))
        found["a"] = Given(support.cradle_arm, "m", tr("arm of the load that the cradle carries"))
        found["b"] = Given(support.arm, "m", tr("arm of the load that the support carries"))
        found["D"] = Given(support.diameter, "m", tr("twice the height of the inertia force above the supports"))
    return found


def _quantities(result: TieDown, task: TieDownTask) -> Lexicon:
    at, angle = result.thresholds, math.degrees
    found = {
        "P_0": Given(result.preload, "N", tr("preload of a tie")),
        "V": Given(result.vertical, "N", tr("vertical load of the ties")),
        "F": Given(result.push, "N", tr("force that moves the load")),
        "G": Given(result.press, "N", tr("force that presses the load on the cradle")),
        "R": Given(result.force, "N", tr("approximate force of a stretched tie")),
        "DeltaR": Given(result.change, "N", tr("change of the force of a tie")),
        "R'": Given(result.opposite, "N", tr("force of an opposite tie")),
        "R_b": Given(result.balanced, "N", tr("force of a stretched tie by equilibrium")),
        "alpha_0": Given(angle(result.best_elevation), "deg", tr("best angle of the ties above the floor")),
    }
    begins = {"k_1": at.slip, "k_2": at.slack, "k_3": at.source_slip, "k_4": at.source_slack, "k_5": at.yielding}
    for name, value in {**begins, "k_6": at.tipping}.items():
        if value is not None:
            found[name] = Given(value, "", tr("inertia force over the weight when {what}", what=_begins()[name]))
    held, rise = unheld(task)
    found["F_0"] = Given(float(held), "N", tr("force that friction holds"))
    found["F_1"] = Given(float(rise), "N", tr("growth of the force that friction does not hold"))
    if result.stress is not None:
        found["sigma"] = Given(result.stress / MEGA, "MPa", tr("stress of a stretched tie"))
    if result.safety is not None:
        found["n_y"] = Given(result.safety, "", tr("safety factor against yielding"))
    return found


def _begins() -> dict[str, str]:
    """What begins at each of these values of k."""
    return {
        "k_1": tr("friction alone no longer holds the load"),
        "k_2": tr("the opposite ties are slack, by equilibrium"),
        "k_3": tr("the approximate force of a stretched tie exceeds the preload"),
        "k_4": tr("the opposite ties are slack, by the approximate force"),
        "k_5": tr("a stretched tie yields, by equilibrium"),
        "k_6": tr("the load leaves its cradle"),
    }


def _by_source(result: TieDown, task: TieDownTask, place: Place) -> Iterator[Block]:
    """R by (3), and where that holds."""
    spare = result.push - task.friction * result.press
    sides = (result.push, task.friction * result.press)
    yield Paragraph(tr("The ties are strained more than by the preload if friction alone does not hold the load:"))
    yield held("F > mu*G", sides, "N", holds=spare > 0)
    if result.change > 0:
        yield Paragraph(
            tr(
                "With the vertical load of the preload, approximately, a stretched tie has this force, an opposite "
                "one the rest:"
            )
        )
        yield from lines([SOURCE], [place])
        slack = result.preload <= result.change
        yield from lines(["DeltaR = R - P_0", *([] if slack else ["R' = P_0 - DeltaR"])], [place])
        if result.preload:
            yield Paragraph(tr("This holds while the opposite ties are tight:"))
            yield held("R < 2*P_0", (result.force, 2 * result.preload), "N", holds=result.force < 2 * result.preload)
    else:
        yield Paragraph(tr("Approximately no tie is strained by more than its preload, $R = P_0$."))


def _by_equilibrium(result: TieDown, task: TieDownTask, place: Place) -> Iterator[Block]:
    """R by the equilibrium of all ties."""
    if result.held == "friction":
        yield Paragraph(tr("Friction alone holds the load, so that in equilibrium too each tie keeps its preload."))
    elif result.held == "all ties":
        yield Paragraph(
            tr(
                "In equilibrium all four ties hold the load: two are stretched by as much as the others slacken, so "
                "their vertical load stays that of the preload:"
            )
        )
        yield from lines([ALL_TIES], [place])
    else:
        yield Paragraph(
            tr(
                "In equilibrium two ties hold the load, the opposite ones are slack. The vertical load is that of "
                "the two alone, not that of the preload beside them:"
            )
        )
        yield from lines([TWO_TIES], [place])
    yield Result("R_b", place.lexicon["R_b"])


def _stress(result: TieDown, place: Place) -> Iterator[Block]:
    """The stress of a tie, and its safety."""
    yield Paragraph(tr("Stress of a stretched tie by equilibrium:"))
    yield from lines(["sigma = R_b/A"], [place])
    if result.safety is not None:
        yield Paragraph(tr("Safety factor against yielding:"))
        yield from lines(["n_y = sigma_y/sigma"], [place])
        yield held("n_y >= 1", (result.safety, 1.0), "", holds=result.safety >= 1)
        yield Result("n_y", place.lexicon["n_y"], 1.0, ">=")


def _thresholds(result: TieDown, task: TieDownTask, place: Place) -> Iterator[Block]:
    """From which k on something begins: each formula, then all in their order."""
    yield Heading(tr("From which inertia on something begins"), 3)
    yield Paragraph(tr("What friction does not hold grows linearly with the inertia, $F - mu*G = k*F_1 - F_0$, with"))
    yield from lines(GROWTH[task.support is not None], [place])
    yield Paragraph(tr("From this follow the values of $k$ at which something begins:"))
    lexicon = place.lexicon
    texts = dict(BEGINS) if result.preload else {"k_1": BEGINS["k_1"]}
    if task.section is not None and task.strength is not None:
        texts["k_5"] = TIGHT if task.section * task.strength <= 2 * result.preload else SLACK
    texts["k_6"] = TIPS
    shown = [name for name in texts if name in lexicon and number_of(lexicon, name)]
    yield from lines([texts[name] for name in shown], [place])
    said = _begins()
    shown.sort(key=partial(number_of, lexicon))
    rows = tuple((f"${name}$", f"${numeral(number_of(lexicon, name), 4)}$", said[name]) for name in shown)
    yield Paragraph(tr("In the order in which they begin they are in table {tab:tie_down_begins}."))
    head = tr("Designation"), tr("Value"), tr("What begins")
    yield Table(tr("Inertia over the weight at which something begins"), head, rows, "tie_down_begins")
    if result.thresholds.yielding == 0:
        yield Paragraph(tr("The ties yield under their preload alone."))


def _course(result: TieDown) -> Iterator[Block]:
    """The forces over k."""
    yield Paragraph(
        tr(
            "Forces over the inertia are in table {tab:tie_down_course}, and in figure {fig:tie_down} with these "
            "values."
        )
    )
    columns = {
        "$k$": result.k,
        "$R$, N": result.forces,
        "$R_b$, N": result.balance,
        "$R'_b$, N": result.slackening,
    }
    yield drawn(tr("Forces of the ties"), partial(draw_tie_down, result=result), FIGURE, "tie_down")
    yield course(tr("Forces of the ties over the inertia"), columns, "tie_down_course")
