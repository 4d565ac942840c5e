"""The document of the recurrence: a row a position with every term of (3.57), the turns from the rated speed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tmmcalc.core.columns import Column
from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import in_degrees, keyed
from tmmcalc.machine.columns import motion_columns
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.reduction.columns import columns as reduction_columns
from tmmcalc.machine.reduction.columns import reduced
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.stepwise import (
    DIVISOR,
    GAINED,
    INERTIA,
    KEPT,
    MOMENT,
    Run,
    idle_run_of,
    run_of,
    stepwise_columns,
)
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number
from tmmcalc.report.positions import with_positions

FLAG = "--recurrence"
WIDE = 6  # turns that the table shows unless they are named


def recurrence_document(
    result: Motion,
    reduction: Reduction,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
) -> Document:
    """The recurrence of a motion; ``patterns`` choose among its columns, those of the motion and of the reduction.

    Raises `UsageError` where the recurrence is not done.
    """
    run = run_of(result, reduction)
    if run is None:
        raise UsageError(
            "the recurrence (3.57) is not done here: it takes a parabola without gear losses or lag, equal steps, and "
            "a speed that settles",
            where=FLAG,
            remedy='write characteristic = "parabolic" in [motor], or leave the flag out',
        )
    idle = idle_run_of(result, reduction)
    own, motion = list(stepwise_columns(result, reduction)), motion_columns(result)
    return with_positions(
        Document(title, tuple(_facts(run, idle, keyed(result.textbook, "a", "b")))),
        result.labels,
        _once([*motion, *own, *reduction_columns(reduction)]),
        patterns,
        rows,
        usual=_once([*motion[:1], *own]) if everything else _usual(motion, own),
        everything=everything,
        example=f"phi,{reduced(reduction).moment.name}_*,J_red,omega_textbook,omega_idle_textbook",
        where="",
    )


def _once(columns: Sequence[Column]) -> list[Column]:
    """The first column of every name."""
    return list({column.name: column for column in reversed(columns)}.values())[::-1]


def _usual(motion: Sequence[Column], own: Sequence[Column]) -> list[Column]:
    """phi, the terms, the speed that comes of them and the turns of the iteration."""
    terms = {told.name for told in (MOMENT, INERTIA, KEPT, GAINED, DIVISOR)}
    speeds = [column for column in motion if column.name == "omega_textbook"]
    after = [column for column in own if column.name.startswith("omega_turn_")][:WIDE]
    return [motion[0], *(column for column in own if column.name in terms), *speeds, *after]


def _facts(run: Run, idle: Run | None, book: Mapping[str, float]) -> list[Fact]:
    """The formula with its constants, A and B of the ``book``, then how the speeds settle, loaded and idle."""
    told, nodes = run.told(), run.nodes
    formula = (
        "omega_i^2 = (kept + gained)/divisor",
        "kept = (J_(i-1) - B dphi) omega_(i-1)^2",
        "gained = (M_(i-1) + M_i + 2 A) dphi",
        "divisor = J_i + B dphi",
    )
    constants = (
        f"A = {number(nodes.a)} N*m, B = {number(nodes.b)} N*m*s^2, dphi = {number(nodes.step)} rad",
        f"B dphi = {number(told.damping)} kg*m^2, 2 A dphi = {number(told.driving)} J",
    )
    facts = [Fact("recurrence (3.57)", "\n".join(formula)), Fact("its constants", "\n".join(constants), book)]
    for label, key, each in (("settled", "recurrence", run), ("settled when idle", "recurrence_idle", idle)):
        if each is not None:
            facts.append(Fact(label, _settled(each), {key: in_degrees(keyed(each.told()))}))
    return facts


def _settled(run: Run) -> str:
    """The speed that comes back, and what the turns from the rated speed end with."""
    told = run.told()
    lines = [
        f"omega_0 = {number(told.start)} rad/s comes back after a cycle, delta = {number(told.delta, peak=1.0)}",
        f"a deviation of omega_0^2 is multiplied by {number(told.multiplier, 4)} in a cycle",
    ]
    for k, turn in enumerate(run.history[:WIDE]):
        lines.append(
            f"turn {k + 1}: {number(turn.first)} -> {number(turn.last)} rad/s, "
            f"difference {number(abs(turn.last - turn.first), 3, peak=turn.last)}"
        )
    if len(run.history) > WIDE:
        lines.append(f"... {len(run.history)} turns in all")
    return "\n".join(lines)
