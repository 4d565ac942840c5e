"""The documents of the law of motion: phases, constants of the laws, extremes, shocks, the table over the turn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, pi
from typing import Any

from tmmcalc.cams.facts.rows import with_further, with_rows
from tmmcalc.cams.follower import along
from tmmcalc.cams.lawresult import (
    POINTS,
    RATE_EXTREMES,
    SHOCKS,
    LawResult,
    MotionExtreme,
    PhaseMotion,
    law_columns,
)
from tmmcalc.cams.laws.catalogue import NAMES, title_of
from tmmcalc.cams.laws.constants import LawConstants
from tmmcalc.core.columns import Column
from tmmcalc.core.quantity import keyed
from tmmcalc.report.document import Document, Fact, angles_in_degrees
from tmmcalc.report.numbers import angle, number

CONSTANTS = (
    *("velocity", "velocity_at", "acceleration", "acceleration_at", "largest_jerk", "least_jerk", "most_jerk"),
    *("braking", "braking_at", "braking_lift", "power", "power_at"),
)
TIMED = ("velocity", "acceleration", "jerk")


def summary(result: LawResult, title: str) -> Document:
    """Phases, extremes and shocks, without the table."""
    return angles_in_degrees(Document(title, tuple(_facts(result, constants=False)), result.remarks))


def document(
    result: LawResult,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """All facts and the table, its columns chosen by ``patterns``, its rows by index; ``everything`` is all in SI.

    ``where`` is the file that has the whole table, ``further`` are columns that are printed by name alone.
    """
    columns = law_columns(result)
    if not everything and not patterns:
        del columns["phase"]
    ends = [degrees(each.begin) for each in result.phases] + [degrees(result.phases[-1].end)]
    told = angles_in_degrees(Document(title, tuple(_facts(result)), result.remarks))
    chosen = with_further(columns, patterns, further)
    return with_rows(told, chosen, patterns, rows, ends=ends, everything=everything, example="phi,d*", where=where)


def _facts(result: LawResult, constants: bool = True) -> Iterator[Fact]:
    if result.speed is not None:
        text = f"{number(result.speed)} rad/s ({number(result.speed * 30 / pi)} rpm)"
        yield Fact("speed of the cam", text, keyed(result, "speed"))
    text = f"{number(degrees(result.stroke))} deg" if result.turns else _plain(result, result.stroke)
    yield Fact("stroke", text, keyed(result, "stroke", **along(result.turns)))
    for phase in result.phases:
        yield _phase_fact(phase)
    if constants:
        for phase in result.phases:
            if phase.constants is not None:
                yield constants_fact(phase.kind, phase.constants)
    for order in (1, 2, 3):
        pair = [each for each in result.extremes if each.order == order]
        if pair:
            yield _extreme_fact(result, order, pair)
    yield _shock_fact(result)


def _plain(result: LawResult, value: float) -> str:
    return number(value, 6) if result.turns else f"{number(1e3 * value, 6)} mm"


def _phase_fact(phase: PhaseMotion) -> Fact:
    begin, end = degrees(phase.begin), degrees(phase.end)
    law = "" if phase.constants is None else _law_name(phase.constants.name)
    text = f"{angle(end - begin)} deg, from {POINTS[phase.kind]} at phi = {angle(begin)} deg{law}"
    name = phase.kind.replace(" ", "_")
    values = keyed(phase, "begin[deg]", "end[deg]", phase=name)
    if phase.constants is not None:
        values |= keyed(phase.constants, "name", phase=name)
    return Fact(phase.kind, text, values)


def _law_name(name: str) -> str:
    return f"; law {name}, {title_of(name)}" if name in NAMES else f"; law of its own, {name}"


def constants_fact(kind: str, found: LawConstants) -> Fact:
    """The constants of the law of one phase."""
    least, largest = found.jerk
    lines = (
        f"Cv = {number(found.velocity, 6)} at k = {number(found.velocity_at, 6)}, "
        f"Ca = max|s''| = {number(found.acceleration, 6)} at k = {number(found.acceleration_at, 6)}",
        f"Cj = {number(found.largest_jerk, 6)} (from {number(least, 6)} to {number(largest, 6)})",
        f"k_M = {number(found.braking_at, 6)}, s_M = {number(found.braking_lift, 6)} where it brakes most",
        f"max s's'' = {number(found.power, 6)} at k = {number(found.power_at, 6)}",
    )
    return Fact(f"constants, {kind}", "\n".join(lines), keyed(found, *CONSTANTS, phase=kind))


def _extreme_fact(result: LawResult, order: int, pair: Sequence[MotionExtreme]) -> Fact:
    """Largest and least of a derivative with their angles, and in time."""
    places = along(result.turns)
    lines: list[str] = []
    values: dict[str, Any] = {}
    for word, each in zip(("max", "min"), pair, strict=True):
        timed = ""
        values |= keyed(each, "value", "phi[deg]", order=order, extreme=word, **places)
        if result.speed is not None:
            told = RATE_EXTREMES[order - 1].of(extreme=word, **places)
            value = each.value * result.speed**order
            values[told.key] = value
            timed = f" ({TIMED[order - 1]} {number(value, 6)} {told.unit})"
        lines.append(f"{word} {_plain(result, each.value)} at phi = {angle(degrees(each.phi))} deg{timed}")
    return Fact(f"{places['coordinate']}{order * chr(39)}", "\n".join(lines), values)


def _shock_fact(result: LawResult) -> Fact:
    told = [shock for shock in result.shocks if shock.order < 3]
    jerks = len(result.shocks) - len(told)
    lines = [
        f"{SHOCKS[shock.order]} at phi = {angle(degrees(shock.phi))} deg: "
        f"{'S' if not result.turns else 'psi'}{shock.order * chr(39)} jumps by {_plain(result, shock.jump)}"
        for shock in told
    ]
    if jerks:
        lines.append(f"the jerk jumps at {jerks} places, the acceleration does not there")
    values = [keyed(shock, "order", "phi[deg]", "jump", **along(result.turns)) for shock in result.shocks]
    return Fact("shocks", "\n".join(lines) or "none", {"shocks": values})
