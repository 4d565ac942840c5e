"""The documents of the falling ball: its drive, its maximum, its stop, the fall over the time."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.quantity import keyed
from tmmcalc.extras.columns import ball_columns
from tmmcalc.extras.facts.rows import even, view_of, with_table
from tmmcalc.extras.falling_ball import Ball, Moment
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number


def summary(result: Ball, title: str) -> Document:
    """What drives the ball, its maximum, its stop, what is asked for."""
    facts = [Fact("driven by", f"{number(result.drive)} m/s^2", keyed(result, "drive", "argument"))]
    if result.fastest is not None:
        facts.append(Fact("largest speed", _moment(result.fastest), {"v_max": keyed(result.fastest)}))
    if result.stop is not None:
        values = {"stop": keyed(result.stop), **keyed(result, "stop_argument")}
        facts.append(Fact("stop", f"{_moment(result.stop)}, tau* = {number(result.stop_argument or 0.0)}", values))
    if result.total is not None:
        facts.append(Fact("whole way", f"{number(result.total)} m", keyed(result, "total")))
    if result.asked:
        text = "\n".join(_moment(each) for each in result.asked)
        facts.append(Fact("at", text, {"at": [keyed(each) for each in result.asked]}))
    facts.append(Fact("error of the way", f"{result.error['way']:.0e}, relative", {"S_error": result.error["way"]}))
    return Document(title, tuple(facts), result.notes)


def document(
    result: Ball,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """The summary with the fall over the time."""
    view = view_of(ball_columns(result), patterns, rows, everything, even(len(result.t)))
    return with_table(summary(result, title), view, everything or rows is not None)


def _moment(at: Moment) -> str:
    return f"t = {number(at.t)} s: v = {number(at.v)} m/s, S = {number(at.way)} m"
