"""What limits the motion: extremes beside their limits, ranges of the joints, singular places, obstacles."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.core.timerows import TimedExtreme
from tmmcalc.manipulators.notes.along import largest
from tmmcalc.manipulators.notes.told import Told, joint_words, letter
from tmmcalc.manipulators.results import Contact, SingularPlace
from tmmcalc.manipulators.task import Joint
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.language import tr, tr_name, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Listing, Paragraph, Result, Table
from tmmcalc.report.telling import column_of

SLACK = 1e-9  # of a limit: what is beyond it by less, keeps it
FIGURES = 4  # of an instant


def verdicts(told: Told) -> Iterator[Block]:
    """Extremes, ranges, singular places, obstacles."""
    yield Heading(tr("Extremes and limits"), 2)
    yield from _extremes(told)
    yield from _ranges(told)
    yield from _singular(told)
    yield from _obstacles(told)


def _extremes(told: Told) -> Iterator[Block]:
    """Extremes of the gripper and of the joints, between the rows too."""
    result = told.result
    yield Result("T", Given(result.duration, "s", tr("time of the whole motion")))
    for key, given, limit in largest(told):
        assert isinstance(given.value, float)
        edge = None if limit is None else _edge(given.value, limit)
        yield Result(key, given, edge, "" if edge is None else "<=")
    yield Paragraph(
        tr("Table {table} has the extremes of the motion, between the rows too.", table="{tab:manipulator_extremes}")
    )
    letters = {
        "speed": tr("speed of the gripper"),
        "acceleration": tr("total acceleration of the gripper"),
        "a_tangential": tr("tangential acceleration of the gripper"),
        "a_normal": tr("normal acceleration of the gripper"),
    }
    joints = {
        name: f"${letter(joint) if not k else name}$" for joint in told.arm.joints for k, name in enumerate(joint[:3])
    }
    letters |= joints | {"elbow": "$gamma$"}
    found = [each for each in result.extremes if each.name in letters and each.least != each.largest]
    rows = tuple(_extreme(each, letters[each.name]) for each in found)
    head = (tr("Quantity"), tr("least"), f"$t$, {tr_unit('s')}", tr("largest"), f"$t$, {tr_unit('s')}")
    yield Table(tr("Extremes of gripper and joints"), head, rows, "manipulator_extremes")


def _extreme(each: TimedExtreme, name: str) -> tuple[str, ...]:
    factor, unit = (180 / math.pi, "°") if each.unit == "rad" else (1.0, tr_unit(each.unit))
    numbers = (factor * each.least, each.least_at, factor * each.largest, each.largest_at)
    return (f"{name}, {unit}", *(column_of([number])[0] for number in numbers))


def _ranges(told: Told) -> Iterator[Block]:
    """The coordinates that have a range, held against it."""
    if not told.task.limits:
        return
    found = {each.name: each for each in told.result.extremes}
    failed = [_excess(told, each.joint, each.first) for each in told.result.excesses]
    yield Paragraph(
        tr("All joints stay within their ranges.") if not failed else tr("These joints leave their ranges:")
    )
    if failed:
        yield Listing(tuple(failed))
    for limit in told.task.limits:
        joint = next(each for each in told.arm.ranged if each.name == limit.name)
        factor, unit = (180 / math.pi, "deg") if joint.turns else (1.0, "m")
        what, own = joint_words(told.arm, joint)[0], found[limit.name]
        ends = (("min", own.least, limit.low, ">="), ("max", own.largest, limit.high, "<="))
        for end, value, edge, sense in ends:
            if edge is not None:
                said = tr("least value: {what}", what=what) if end == "min" else tr("largest value: {what}", what=what)
                shown = Given(factor * value, unit, said)
                yield Result(_ending(joint, end), shown, factor * _edge(value, edge), sense)


def _edge(value: float, limit: float) -> float:
    """A limit; what is beyond it by rounding alone is at it."""
    return value if abs(value - limit) <= SLACK * max(abs(value), abs(limit)) else limit


def _ending(joint: Joint, end: str) -> str:
    """``phi_{2,min}``."""
    base, _, index = letter(joint).partition("_")
    return f"{base}_{{{index},{end}}}" if index else f"{base}_{{{end}}}"


def _excess(told: Told, name: str, first: float) -> str:
    joint = next(each for each in told.arm.ranged if each.name == name)
    return tr("{name} first at $t$ = {time} s", name=f"${letter(joint)}$", time=_time(first))


def _time(t: float) -> str:
    return tr_number(significant(t, FIGURES))


def _singular(told: Told) -> Iterator[Block]:
    """Where the joints lose a degree of freedom, or come near to it."""
    kinds = {
        "r": tr("the gripper on the axis of the base, $r$ = 0"),
        "l_3": tr("the gripper at the shoulder, $l_3$ = 0"),
        "elbow": tr("both arms in line, $sin(gamma)$ = 0"),
    }
    own = [*(["r"] * told.arm.spatial), *{"spherical": ["l_3"], "angular": ["elbow"]}.get(told.arm.kind, [])]
    if not own:
        return
    yield Paragraph(
        tr(
            "The joints are singular, their rates without bound, where the denominators of their formulas vanish: "
            "{places}.",
            places="; ".join(kinds[each] for each in own),
        )
    )
    if not told.result.singular:
        yield Paragraph(tr("The motion does not come near to such a place."))
        return
    yield Paragraph(tr("The motion comes near to such places:"))
    yield Listing(tuple(_place(each) for each in told.result.singular))


def _place(each: SingularPlace) -> str:
    name = "sin(gamma)" if each.what == "elbow" else each.what
    unit = f" {tr_unit(each.unit)}" if each.unit else ""
    value = tr_number(significant(each.value, RESULT)) + unit
    return tr("${name}$ = {value} at $t$ = {time} s", name=name, value=value, time=_time(each.t))


def _obstacles(told: Told) -> Iterator[Block]:
    """What crosses an obstacle, and when."""
    contacts = told.result.contacts
    if not contacts:
        return
    yield Paragraph(
        tr(
            "Table {table} has what crosses the obstacles; a straight line from start to end is there to compare.",
            table="{tab:manipulator_obstacles}",
        )
        if told.result.inverse
        else tr("Table {table} has what crosses the obstacles.", table="{tab:manipulator_obstacles}")
    )
    rows = tuple((each.obstacle, tr_name(each.what), _contact(each)) for each in contacts)
    head = (tr("Obstacle"), tr("Of what"), tr("Verdict"))
    yield Table(tr("Motion past the obstacles"), head, rows, "manipulator_obstacles")


def _contact(each: Contact) -> str:
    if not each.intervals:
        return tr("clear")
    parts = "; ".join(f"{_time(a)} … {_time(b)}" if a < b else _time(a) for a, b in each.intervals)
    if each.what == "straight line":
        return tr("crosses it, in parts of the length: {parts}", parts=parts)
    return tr("crosses it, $t$, s: {parts}", parts=parts)
