"""The documents of the reduction stage: work of every cause, reduced moment and inertia, the table of positions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import Quantity, keyed
from tmmcalc.linkage.facts.places import span_fact, speed_text
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.reduction.columns import EFFICIENCY, called, cells, columns, contribution_name, reduced
from tmmcalc.machine.reduction.results import Contribution, Reduction
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.errors import digit_facts
from tmmcalc.report.numbers import NOISE, number
from tmmcalc.report.positions import with_positions

WORK = Quantity("work[J]", "work of everything over the cycle")
MEAN_POWER = Quantity("P_red_mean[W]", "mean power of everything")
SIMPSON_OFF = Quantity("work_Simpson_{cause}_off[%]", "how far Simpson's rule is off in the work of {cause}")
LUMPED = Quantity("lumped_rods", "connecting rods")
LUMPING = Quantity("lumping[%]", "largest change by rods as masses in their pins, of the variable part")


def summary(result: Reduction, title: str) -> Document:
    """Facts and notes, without the table of positions."""
    facts = (
        Fact("taken at", f"{speed_text(result)} of the input", reduced(result).speed.value(result.speed)),
        *(_work_fact(result, contribution) for contribution in result.contributions),
        *_sum_facts(result),
        *_moment_facts(result),
        *_rods_facts(result),
        *_inertia_facts(result),
        *_check_facts(result),
    )
    return Document(title, facts, tuple(str(grade) for grade in result.grades))


def _rods_facts(result: Reduction) -> list[Fact]:
    """How the connecting rods are taken, where there are any."""
    if not result.rod_links:
        return []
    rods = ", ".join(map(str, result.rod_links))
    how = "as they are" if result.rods == "exact" else "as masses in their pins: statically lumped"
    return [Fact("rods", f"{rods}, {how}", keyed(result, "rods"))]


def document(
    result: Reduction,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """Summary and table of positions.

    ``patterns`` choose columns by name, header or wildcard, ``rows`` positions by index; all columns are shown
    as far as they fit, so ``everything`` changes nothing here. ``where`` is the file that has them all. ``further``
    columns are there if ``patterns`` name them.
    """
    example = "phi,M_red*,J_red" if result.turns else "phi,F_red*,m_red"
    told = with_positions(
        summary(result, title),
        result.labels,
        columns(result),
        patterns,
        rows,
        example=example,
        everything=everything,
        where=where,
        further=further,
    )
    assert told.table is not None
    return replace(told, table=_blanked(result, told.table, rows))


def _blanked(result: Reduction, view: View, rows: Sequence[int] | None) -> View:
    """The table with blanks where an efficiency has no value."""
    for column in columns(result):
        if column.name == EFFICIENCY.name and column.header in view.headers:
            own = cells(result, column)
            kept = own if rows is None else [own[k] for k in rows]
            at = list(view.headers).index(column.header)
            return replace(view, columns=[*view.columns[:at], kept, *view.columns[at + 1 :]])
    return view


def mean_moment(result: Reduction) -> float:
    """Mean of the whole reduced moment over the cycle, algebraic like its columns [N*m, of a driven slider N]."""
    return math.copysign(1.0, result.speed) * _work(result) / result.cycle.period


def _work(result: Reduction) -> float:
    return math.fsum(contribution.work for contribution in result.contributions)


def _cycle(result: Reduction) -> str:
    """What one pass is called: a cycle if the motion repeats."""
    return "a cycle" if result.whole else "over the range"


def _scale(result: Reduction) -> float:
    """What all moments could do if they never changed sign [J]: what is noise against it is no work."""
    return max((abs(extreme.value) for c in result.contributions for extreme in (c.least, c.largest)), default=0.0) * (
        result.cycle.period
    )


def _work_fact(result: Reduction, contribution: Contribution) -> Fact:
    """Exact work of a contribution, and that of Simpson's rule over the positions beside it."""
    name, work, scale = contribution_name(result, contribution), contribution.work, _scale(result)
    values = keyed(contribution, "work", cause=name)
    text = f"{number(work, peak=scale)} J {_cycle(result)}"
    if contribution.simpson is not None:
        values |= keyed(contribution, "simpson", cause=name)
        text += f"\nby Simpson's rule {number(contribution.simpson, peak=scale)} J"
        if abs(work) > NOISE * scale:
            off = 100 * (contribution.simpson / work - 1)
            values |= SIMPSON_OFF.of(cause=name).value(off)
            size = number(abs(off), 3, peak=100.0)
            text += f", {size} % too {'much' if off > 0 else 'little'}" if size != "0" else ", the same"
    return Fact(Phrase("work of {cause}", cause=called(contribution)), text, values)


def _sum_facts(result: Reduction) -> list[Fact]:
    """Work of everything, the mean moment, and the mean power that the drive must make up for."""
    told = reduced(result)
    work, scale, mean = _work(result), _scale(result), mean_moment(result)
    power = work * abs(result.speed) / result.cycle.period
    text = f"{number(mean, peak=scale / result.cycle.period)} {told.mean.unit} ({number(power, peak=scale)} W)"
    return [
        Fact("work of everything", f"{number(work, peak=scale)} J {_cycle(result)}", WORK.value(work)),
        Fact(f"mean reduced {told.force}", text, told.mean.value(mean) | MEAN_POWER.value(power)),
    ]


def _moment_facts(result: Reduction) -> list[Fact]:
    """Extremes of every contribution and of their sum."""
    told = reduced(result)
    total = math.copysign(1.0, result.speed) * result.parts.sum(axis=0)
    least, largest = result.cycle.panels.extremes(total)
    extremes = Extreme(*least), Extreme(*largest)
    facts = [span_fact(result, f"reduced {told.force}", told.moment.name, told.moment.unit, extremes)]
    if len(result.contributions) < 2:
        return facts
    for c in result.contributions:
        own = told.of_cause.of(cause=contribution_name(result, c))
        cause = called(c)
        label = Phrase("moment of {cause}", cause=cause) if result.turns else Phrase("force of {cause}", cause=cause)
        facts.append(span_fact(result, label, own.name, own.unit, (c.least, c.largest)))
    return facts


def _inertia_facts(result: Reduction) -> list[Fact]:
    """Range of the reduced inertia, and what static lumping of the rods would change."""
    told = reduced(result)
    name, unit = told.inertia.name, told.inertia.unit
    facts = [span_fact(result, f"reduced {told.mass}", name, unit, result.inertia_range)]
    least, largest = (extreme.value for extreme in result.inertia_range)
    if result.other is None or largest - least <= NOISE * largest:
        return facts
    change = _largest(result.other - result.inertia) * (1 if result.rods == "exact" else -1)
    share = 100 * change / (largest - least)
    rods = ", ".join(map(str, result.rod_links))
    label = Phrase("static lumping of {rods}", rods=rods)
    values = {LUMPED.key: list(result.rod_links), **told.lumping.value(change), **LUMPING.value(share)}
    if abs(change) <= NOISE * largest:
        return [*facts, Fact(label, f"the same reduced {told.mass}", values)]
    text = f"up to {number(change, 4)} {unit}, {number(share, 3)} % of the variable part"
    return [*facts, Fact(label, text, values)]


def _largest(values: Real) -> float:
    """The value of the largest size, with its sign."""
    return float(values[int(np.argmax(np.abs(values)))])


def _check_facts(result: Reduction) -> list[Fact]:
    panels, error, digit = result.cycle.panels, result.cycle.error, result.error.last_digit
    return [
        Fact("resolved by", f"{panels.count} panels of {panels.order} points", {"panels": panels.count}),
        Fact("error of functions (est.)", f"{error:.0e} (relative)", {"error": {"functions": error}}),
        *digit_facts({} if digit is None else keyed(digit)),
    ]
