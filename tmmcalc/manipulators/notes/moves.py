"""The given motion of the joints: each by its time-optimal law, or by a smooth curve through the rows of a table."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.timelaw import TimeLaw, by_travel, phase_of
from tmmcalc.manipulators.motions import motion_of
from tmmcalc.manipulators.notes.told import Told, joint_quantities
from tmmcalc.manipulators.task import Joint, JointMove, LawTask, TableTask
from tmmcalc.report import optimal
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import GREEK
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Table
from tmmcalc.report.telling import column_of, lines, named

SAME = 1e-9  # of the duration: a law that takes this time settles it
KNOTS = 3  # of the table at which the equations are worked out


class Moved(NamedTuple):
    """A joint that moves by its law."""

    joint: Joint
    move: JointMove
    law: TimeLaw
    own: TimeLaw  # as quick as it can

    @property
    def unit(self) -> str:
        """Of the law."""
        return "rad" if self.joint.turns else "m"


def by_laws(told: Told, asked: LawTask) -> Iterator[Block]:
    """Times and speeds of the laws, then way, speed and coordinate of each joint at the shown rows."""
    yield Heading(tr("Motion of the joints"), 2)
    moved = list(_moved(told, asked))
    still = [joint.name for joint in told.arm.joints if joint.name not in {each.joint.name for each in moved}]
    yield Paragraph(
        tr(
            "Each joint moves from rest to rest with its largest acceleration, at constant speed, with its largest "
            "deceleration."
        )
    )
    if still:
        names = ", ".join(f"${each}$" for each in still)
        yield Paragraph(tr("These coordinates stay as they are: {names}.", names=names))
    if not moved:
        return
    yield from _travels(told, moved)
    duration = told.result.duration
    slow = [each for each in moved if each.own.duration >= duration * (1 - SAME) or not asked.together]
    quick = [each for each in moved if each not in slow]
    for turns in (True, False):
        yield from _settled([each for each in slow if each.joint.turns == turns], timed=False)
    if quick:
        yield Paragraph(
            tr("The other joints take the same time with their accelerations, at the least speed that does it:")
        )
    for turns in (True, False):
        yield from _settled([each for each in quick if each.joint.turns == turns], timed=True)
    yield from _phases(told, moved)


def _moved(told: Told, asked: LawTask) -> Iterator[Moved]:
    moves = {move.name: move for move in asked.moves}
    for joint, law in zip(told.arm.joints, told.result.laws, strict=True):
        move = moves[joint.name]
        if law.speed and move.speed is not None and move.acceleration is not None:
            yield Moved(joint, move, law, by_travel(law.travel, move.speed, move.acceleration))


def _law(each: Moved) -> Lexicon:
    """The law of a joint with its limits and the ends of its coordinate."""
    unit, move = each.unit, each.move
    factor, shown = (180 / math.pi, "deg") if each.joint.turns else (1.0, "m")
    found = optimal.quantities(
        each.law,
        unit,
        travel=tr("travel of the joint"),
        peak=tr("largest speed of the joint that is reached"),
        allowed=tr("allowed acceleration of the joint"),
    )
    found |= {
        "v_m": Given(move.speed or 0.0, f"{unit}/s", tr("allowed speed of the joint")),
        "T_{min}": Given(each.own.duration, "s", tr("least time of the joint by its own limits")),
        "p_0": Given(factor * move.start, shown, tr("coordinate of the joint at the beginning")),
        "p_e": Given(factor * move.end, shown, tr("coordinate of the joint at the end")),
    }
    return named(found)


def _travels(told: Told, moved: Sequence[Moved]) -> Iterator[Block]:
    """The travels, and the least times, the largest of which all joints take."""
    for turns in (True, False):
        own = [each for each in moved if each.joint.turns == turns]
        if own:
            yield from lines(["S_m = rad(abs(p_e - p_0))"], [_place(each) for each in own])
        for texts, uniform in ((("T_{min} = S_m/v_m + v_m/a_m",), True), (("T_{min} = 2*sqrt(S_m/a_m)",), False)):
            places = [_place(each) for each in own if bool(each.own.uniform) == uniform]
            if places:
                yield from lines(texts, places)
    if len(moved) < 2:
        return
    slowest = max(moved, key=lambda each: each.own.duration)
    name = f"${slowest.joint.name}$"
    yield Paragraph(
        tr("The coordinate {name} takes the longest time, which all of them take.", name=name)
        if any(each.law.duration > each.own.duration * (1 + SAME) for each in moved)
        else tr("The coordinate {name} takes the longest time.", name=name)
    )


def _place(each: Moved) -> Place:
    return Place(tr("for {quantity}", quantity=_symbol(each.joint)), _law(each))


def _symbol(joint: Joint) -> str:
    """A joint coordinate in a text without formulas."""
    letter, _, index = joint.name.partition("_")
    return GREEK.get(letter, letter) + "".join(chr(ord("₀") + int(digit)) for digit in index)


def _settled(moved: Sequence[Moved], *, timed: bool) -> Iterator[Block]:
    """Speeds and times of the laws, alike ones together."""
    groups: dict[tuple[str, ...], list[Place]] = {}
    for each in moved:
        groups.setdefault(optimal.by_travel(each.law, timed=timed), []).append(_place(each))
    for texts, places in groups.items():
        yield from lines(texts, places)


def _phases(told: Told, moved: Sequence[Moved]) -> Iterator[Block]:
    """Way and speed of the joints in their phases at the shown rows, and their coordinates."""
    result = told.result
    phases = {each: phase_of(each.law, result.t, result.side) for each in moved}
    for phase, texts in optimal.PHASES.items():
        begun = False
        for turns in (True, False):
            own = [each for each in moved if each.joint.turns == turns]
            chosen = [(each, row) for each in own for row in told.rows if phases[each][row] == phase]
            if not chosen:
                continue
            if not begun:
                yield Paragraph(optimal.phase_named(phase))
                begun = True
            yield from lines(texts, [_at(told, each, row) for each, row in chosen], {"t": "t"})
    yield Paragraph(tr("The coordinates of the joints with their rates:"))
    for each in moved:
        rows = [row for row in told.rows if phases[each][row] in optimal.PHASES]
        if not rows:
            continue
        sign = "" if each.law.sense > 0 else "-"
        value, rate, second = each.joint[:3]
        way = "deg(180*s/pi)" if each.joint.turns else "s"
        texts = (f"{value} = p_0 {sign or '+'} {way}", f"{rate} = {sign}v")
        yield from lines(texts, [_at(told, each, row, letters=False) for row in rows])
        for phase, sense in ((optimal.ACCELERATED, 1), (optimal.SLOWED, -1)):
            places = [_at(told, each, row, letters=False) for row in rows if phases[each][row] == phase]
            if places:
                yield from lines([f"{second} = {'' if sense * each.law.sense > 0 else '-'}a_m"], places)


def _at(told: Told, each: Moved, row: int, *, letters: bool = True) -> Place:
    """A joint at a row: what it has gone by its law."""
    k = [joint.name for joint in told.result.arm.joints].index(each.joint.name)
    value, rate, second = told.result.q[:, k, row].tolist()
    sense = each.law.sense
    found = {
        **_law(each),
        **joint_quantities(told.arm, each.joint, (value, rate, second)),
        "t": Given(float(told.result.t[row]), "s", tr("time")),
        "s": Given(sense * (value - each.move.start), each.unit, tr("travel of the joint from its start")),
        "v": Given(sense * rate, f"{each.unit}/s", tr("speed of the joint")),
    }
    name = told.named(row)
    if letters:
        name = tr("for {quantity}", quantity=_symbol(each.joint)) + ", " + name
    return Place(name, named(found))


def by_table(told: Told, asked: TableTask) -> Iterator[Block]:
    """The rates at the rows of the table by a linear system, then the curve between them."""
    yield Heading(tr("Motion of the joints"), 2)
    yield Paragraph(
        tr(
            "Between the rows of the given table each coordinate $p$ is a polynomial of the third degree in the time; "
            "at the rows velocity and acceleration are continuous, at both ends the joint is at rest. The rates "
            "$w_k$ at the rows, between which are the times $b_k$ and the slopes $g_k$ of the chords,"
        )
    )
    yield Display(read("b_k = t_{k+1} - t_k"))
    yield Display(read("g_k = (p_{k+1} - p_k)/b_k"))
    yield Paragraph(tr("follow from the linear system"))
    yield Display(
        read("b_k*w_{k-1} + 2*(b_{k-1} + b_k)*w_k + b_{k-1}*w_{k+1} = 3*(b_k*g_{k-1} + b_{k-1}*g_k)"), "knots"
    )
    t = asked.t - asked.t[0]
    rates = motion_of(told.task).joints(t, 0)[1]
    for joint, values, own in zip(told.arm.joints, asked.q, rates, strict=True):
        yield from _knots(told, joint, (t, values, own))
        yield from _between(told, joint, (t, values, own))


def _knots(told: Told, joint: Joint, curve: tuple[Values, Values, Values]) -> Iterator[Block]:
    """The coefficients of the system with its solution, and the solution put into it."""
    t, values, rates = curve
    unit = "rad" if joint.turns else "m"
    b = np.diff(t)
    g = np.diff(values) / b
    inner = range(1, len(t) - 1)
    yield Heading(tr("Coordinate {name}", name=f"${joint.name}$"), 3)
    caption = tr("The system of the rates of coordinate {name} with its solution", name=f"${joint.name}$")
    blank = [""]
    shown = np.degrees(values) if joint.turns else values
    columns = {
        f"$t_k$, {tr_unit('s')}": column_of(t),
        f"$p_k$, {'°' if joint.turns else tr_unit('m')}": column_of(shown),
        "$b_k$": blank + column_of(b[1:]) + blank if len(t) > 2 else blank * 2,
        "$2*(b_{k-1} + b_k)$": blank + column_of(2 * (b[:-1] + b[1:])) + blank if len(t) > 2 else blank * 2,
        "$b_{k-1}$": blank + column_of(b[:-1]) + blank if len(t) > 2 else blank * 2,
        tr("Right side"): blank + column_of(3 * (b[1:] * g[:-1] + b[:-1] * g[1:])) + blank if len(t) > 2 else blank * 2,
        f"$w_k$, {tr_unit(unit + '/s')}": column_of(rates),
    }
    labels = [str(k) for k in range(len(t))]
    key = f"manipulator_knots_{joint.name}"
    said = tr("Table {tab} has the coefficients of the system with its solution.", tab=f"{{tab:{key}}}")
    if not inner:
        said = tr("Table {tab} has the given values of the coordinate with its rates.", tab=f"{{tab:{key}}}")
    yield Paragraph(said)
    yield Table(caption, ("$k$", *columns), tuple(zip(labels, *columns.values(), strict=True)), key)
    if not inner:
        return
    yield Paragraph(tr("The solution satisfies the equations:"))
    places = []
    for k in sorted({inner[0], inner[len(inner) // 2], inner[-1]})[:KNOTS]:
        found = {
            "b_{k-1}": Given(float(b[k - 1]), "s", tr("time before the row")),
            "b_k": Given(float(b[k]), "s", tr("time after the row")),
            "g_{k-1}": Given(float(g[k - 1]), f"{unit}/s", tr("slopes of the chords before and after the row")),
            "g_k": Given(float(g[k]), f"{unit}/s", tr("slopes of the chords before and after the row")),
        }
        for name, j in (("w_{k-1}", k - 1), ("w_k", k), ("w_{k+1}", k + 1)):
            found[name] = Given(float(rates[j]), f"{unit}/s", tr("rates of the joint at the rows of the table"))
        places.append(Place(tr("at row {number} of the table", number=k), named(found)))
    text = "w_k = (3*(b_k*g_{k-1} + b_{k-1}*g_k) - b_k*w_{k-1} - b_{k-1}*w_{k+1})/(2*(b_{k-1} + b_k))"
    yield from lines([text], places)


def _between(told: Told, joint: Joint, curve: tuple[Values, Values, Values]) -> Iterator[Block]:
    """The curve at the shown rows."""
    places = [_inside(told, joint, row, curve) for row in told.rows]
    yield Paragraph(tr("Between two rows of the table:"))
    value, rate, second = joint[:3]
    parts = ("w_k*xi", "(3*g_k - 2*w_k - w_{k+1})*xi**2", "(w_k + w_{k+1} - 2*g_k)*xi**3")
    rise = " + ".join(f"deg(180*b_k*{part}/pi)" if joint.turns else f"b_k*{part}" for part in parts)
    texts = (
        "xi = (t - t_k)/b_k",
        "g_k = rad(p_{k+1} - p_k)/b_k",
        f"{value} = p_k + {rise}",
        f"{rate} = w_k + 2*xi*(3*g_k - 2*w_k - w_{{k+1}}) + 3*xi**2*(w_k + w_{{k+1}} - 2*g_k)",
        f"{second} = (2*(3*g_k - 2*w_k - w_{{k+1}}) + 6*xi*(w_k + w_{{k+1}} - 2*g_k))/b_k",
    )
    yield from lines(texts, places)


def _inside(told: Told, joint: Joint, row: int, curve: tuple[Values, Values, Values]) -> Place:
    """A row of the result, between two rows of the table."""
    t, values, rates = curve
    at = float(told.result.t[row])
    k = int(np.clip(np.searchsorted(t, at, side="right") - 1, 0, len(t) - 2))
    width = float(t[k + 1] - t[k])
    factor, shown, unit = (180 / math.pi, "deg", "rad") if joint.turns else (1.0, "m", "m")
    index = [each.name for each in told.arm.joints].index(joint.name)
    found: dict[str, Given] = {
        **joint_quantities(told.arm, joint, told.result.q[:, index, row].tolist()),
        "t": Given(at, "s", tr("time")),
        "t_k": Given(float(t[k]), "s", tr("time of the row of the table before")),
        "b_k": Given(width, "s", tr("time after the row")),
        "xi": Given((at - float(t[k])) / width, "", tr("part of the time between both rows")),
        "g_k": Given(float((values[k + 1] - values[k]) / width), f"{unit}/s", tr("slope of the chord")),
    }
    for name, j in (("k", k), ("{k+1}", k + 1)):
        found[f"p_{name}"] = Given(float(factor * values[j]), shown, tr("coordinates of the joint in the table"))
        found[f"w_{name}"] = Given(float(rates[j]), f"{unit}/s", tr("rates of the joint at the rows of the table"))
    return Place(told.named(row), named(found))


def shown(told: Told) -> list[int]:
    """Of the phases of the slowest joint the rows in their middles; of a table rows at its thirds."""
    result = told.result
    if not result.laws:
        return sorted({len(result.t) // 3, 2 * len(result.t) // 3})
    slowest = max(result.laws, key=lambda law: law.duration)
    phases = phase_of(slowest, result.t, result.side)
    rows = [np.flatnonzero(phases == phase).tolist() for phase in optimal.PHASES]
    rows = [[row for row in own[1:-1] if result.labels[row].isdigit()] or own for own in rows]
    return sorted(own[len(own) // 2] for own in rows if own)
