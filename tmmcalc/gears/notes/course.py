"""The course of the search for a train: what is asked of numbers of teeth and what each demand leaves, how the sets
fall away up to those that criteria compare, and the best of these."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from tmmcalc.gears.advice import called, removals
from tmmcalc.gears.criteria.choice import costs
from tmmcalc.gears.pictures.words import KINDS, variant_word
from tmmcalc.gears.selection.results import Selection, Weighed
from tmmcalc.gears.selection.task import ROW, WEIGHTED
from tmmcalc.gears.sizing import MOST, Sized
from tmmcalc.gears.strength.series import Outcome
from tmmcalc.gears.trains import Request, Variant
from tmmcalc.report.formula.digits import RESULT, significant
from tmmcalc.report.language import tr, tr_name, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Paragraph, Table

DIGITS = 6  # of limits
BEST = 5  # trains of the table of the best
Indices = NDArray[np.intp]


def told_search(variant: Variant, key: str) -> Iterator[Block]:
    """The numbers within which wheels are sought, and what each demand asks and removes."""
    request, synthesis = variant.request, variant.synthesis
    yield Paragraph(_bounds(request))
    counts = {"candidates": grouped(synthesis.candidates), "count": grouped(synthesis.count)}
    found = removals(variant)
    if not found:
        yield Paragraph(tr("The search found {count} sets of numbers of teeth.", count=counts["count"]))
        return
    tab = f"{{tab:{key}_removed}}"
    yield Paragraph(
        tr(
            "The steps of the textbook’s program give {candidates} sets, of which the constraints leave {count}; what "
            "each asks and removes is in table {tab}.",
            tab=tab,
            **counts,
        )
        if request.method == "textbook"
        else tr(
            "Every combination is looked at. Of {candidates} the constraints leave {count}; what each asks and removes "
            "is in table {tab}.",
            tab=tab,
            **counts,
        )
    )
    rows = tuple(
        (tr_name(called(name)), _asked(name, request), grouped(of), grouped(number)) for name, number, of in found
    )
    head = (tr("Constraint"), tr("Demand"), tr("Combinations before it"), tr("Removed"))
    yield Table(tr("What the constraints removed"), head, rows, f"{key}_removed")


def _bounds(request: Request) -> str:
    """The numbers of teeth and the ratios of modules among which the search looks."""
    limits, proportions = request.task.limits, request.task.proportions
    said = tr("Wheels have {low} to {high} teeth", low=limits.least, high=limits.largest)
    if not request.scheme.branched:
        said += tr(", pinions at most {high}", high=limits.largest_pinion)
    if request.scheme.rings:
        said += tr(", rings {low} to {high}", low=limits.least_ring, high=limits.largest_ring)
    if not request.scheme.branched or request.scheme.stages == 1:
        return f"{said}."
    first, last = (":".join(map(str, each)) for each in (proportions[0], proportions[-1]))
    if len(proportions) == 1:
        return f"{said}. " + tr("The modules of the stages are $m_1$:$m_2$ = {ratio}.", ratio=first)
    return f"{said}. " + tr(
        "The ratio $m_1$:$m_2$ of the modules of the stages is one of {count}, from {first} to {last}.",
        count=len(proportions),
        first=first,
        last=last,
    )


def _asked(name: str, request: Request) -> str:
    """What a constraint asks; that of a constraint of the spec stands with its name in the spec."""
    task, scheme, demands = request.task, request.scheme, request.task.demands
    low, high = (significant(float(end), DIGITS) for end in (request.admitted.low, request.admitted.high))
    distance = demands.centre_distance or (None, None)
    near, far = (None if each is None else significant(1e3 * each, DIGITS) for each in distance)
    found = {
        "largest_sum": f"$z_1 + z_2 <= {task.limits.largest_sum}$",
        "coaxiality": tr("equal distances of the axes"),
        "ratio": f"${low} <= {KINDS[request.kind]} <= {high}$",
        "mesh_angles": f"$alpha_w <= deg({significant(math.degrees(demands.largest_angle or 0.0), DIGITS)})$",
        "undercut": f"$z >= {demands.undercut}$",
        "interference": f"$Deltaz >= {demands.ring_difference}$",
        "stage_ratio": f"$u <= {significant(float(demands.stage_ratio or 0), DIGITS)}$",
        "diameter_band": tr("to within {part} %", part=_number(100 * float(demands.diameter_band or 0))),
        "equal_pinions": "$" + " = ".join(f"z_{wheel}" for wheel in scheme.wheels[::2]) + "$",
        "assembly": f"$K = {task.planets}$",
        "adjacency": tr("gap between the tips at least {gap} of the module", gap=_number(float(demands.gap or 0))),
        "coprime": tr("no common factor"),
        "centre_distance": "$" + " <= ".join(each for each in (near, "a", far) if each) + f"$ {tr_unit('mm')}",
        "envelope": f"$D <= {significant(1e3 * (demands.envelope or 0.0), DIGITS)}$ {tr_unit('mm')}",
    }
    return found.get(name, "–")


def _number(value: float) -> str:
    return tr_number(significant(value, DIGITS))


def grouped(count: int) -> str:
    """A whole number, from 10 000 on with thin spaces between its thousands.

    >>> grouped(9999), grouped(12345)
    ('9999', '12\\u202f345')
    """
    return f"{count:,}".replace(",", "\u202f") if count >= 10_000 else str(count)


def told_sieve(selection: Selection, variants: Sequence[Variant], sized: Sequence[Sized]) -> Iterator[Block]:
    """What becomes of the sets of every variant up to those that are compared."""
    counts = [_counts(*each) for each in zip(selection.variants, variants, sized, strict=True)]
    steps = [step for step in counts[0] if any(each[step] for each in counts)]
    heads = (
        [variant_word(each.request.scheme, each.request.task.planets) for each in variants]
        if len(variants) > 1
        else [tr("Sets")]
    )
    rows = tuple((step, *(grouped(each[step]) for each in counts)) for step in steps)
    yield Paragraph(
        tr(
            "Table {tab:criteria_sieve} has what becomes of the sets. Modules and face widths follow from the strength "
            "of the teeth; a train that is too weak or locks itself is left out."
        )
    )
    caption = tr("From the numbers of teeth to the trains that are compared")
    yield Table(caption, (tr("Step of the choice"), *heads), rows, "criteria_sieve")


def _counts(weighed: Weighed, variant: Variant, sized: Sized) -> dict[str, int]:
    """How many sets of a variant there are, fall away for each reason, and are compared."""
    outcomes = sized.strength.outcome
    against = weighed.sized - weighed.weak - weighed.locking - len(weighed.sets)
    return {
        tr("found"): variant.synthesis.count,
        tr("not calculated, as they are beyond the first {most}", most=grouped(MOST)): weighed.unseen,
        tr("no standard module is large enough"): int(np.count_nonzero(outcomes == Outcome.NO_MODULE)),
        tr("no standard modules stand in the proportion"): int(np.count_nonzero(outcomes == Outcome.NO_PAIR)),
        tr("a stage is overloaded"): int(np.count_nonzero(outcomes == Outcome.OVERLOADED)),
        tr("the given modules stand in another proportion"): int(np.count_nonzero(outcomes == Outcome.PROPORTION)),
        tr("self-locking"): weighed.locking,
        tr("against the constraints of the task"): against,
        tr("compared by the criteria"): len(weighed.sets),
    }


def told_best(selection: Selection, sizes: Callable[[int], tuple[str, ...]], heads: tuple[str, ...]) -> Iterator[Block]:
    """The best few trains by what chose; ``sizes`` of a row are the cells under ``heads``."""
    if selection.choose == ROW or len(selection.pool) == 1:
        return
    weighted = selection.choose == WEIGHTED
    order = selection.ranking.order if weighted else _order(selection)
    columns = (*heads, "$S$") if weighted else heads
    rows = []
    for place, row in enumerate(order[:BEST].tolist(), 1):
        score = (tr_number(significant(float(selection.ranking.scores[row]), RESULT)),) if weighted else ()
        rows.append((str(place), *sizes(row), *score))
    yield Paragraph(tr("Table {tab:criteria_best} has the best trains in this order; the first is taken."))
    yield Table(tr("Best trains in the order of the choice"), (tr("Number"), *columns), tuple(rows), "criteria_best")


def _order(selection: Selection) -> Indices:
    """The trains by the criterion that chose, the best first, of equals the first of the list."""
    return np.argsort(costs(selection.pool, [selection.choose])[:, 0], kind="stable")
