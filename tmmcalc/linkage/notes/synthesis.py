"""The chapter on the synthesis: what is asked, how the dimensions follow, the linkages found, the check of the one."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from importlib import import_module
from typing import Any

from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.notes.syntheses import strokes
from tmmcalc.linkage.notes.syntheses.told import NOISE, Told, called, letter_of, quantity_of, told_of
from tmmcalc.linkage.pictures.synthesis import draw_solution, proportion
from tmmcalc.linkage.synthesis.results import Design, Size
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Figure, Heading, Paragraph, Result, Table
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import WIDE, cell, data_of, quantities

HOME = "tmmcalc.linkage.notes.syntheses"
KINDS = {  # modules that tell of them
    "slider_crank": "slider",
    "slotted_link": "slotted",
    "rotating_slotted_link": "rotating",
    "crank_rocker": "rocker",
    "trailing_rod": "trailing",
    "function": "function",
    "path": "places",
    "motion": "places",
    "dwell": "dwell",
}
LOW, HIGH, AROUND = 75.0, 115.0, 35.0  # heights of the picture, and what is above and below the linkage [mm]
SHOWN = 6  # linkages side by side
FIGURES = 6  # digits of a size
DEFECTS = ("order", "branch", "circuit", "rotatability", "transmission", "sizes")  # as the ratings name them
WORDED = ("grashof",)  # sizes that are told by their meaning


def blocks(order: Order) -> Iterator[Block]:
    """The task, the dimensions, all linkages found, times and speeds, conditions and checks, the picture."""
    told = told_of(order)
    kind: Any = import_module(f"{HOME}.{KINDS[told.found.kind]}")
    yield Heading(tr("Task of the synthesis"))
    yield Paragraph(kind.task(told))
    asked = _asked(told, kind)
    told.give(asked)
    yield Paragraph(tr("Table {tab:synthesis_asked} has what is asked."))
    yield quantities(tr("What is asked of the linkage"), asked, "synthesis_asked", FIGURES)
    yield Heading(tr("Dimensions of the linkage"))
    yield from kind.blocks(told)
    yield from _listed(told)
    yield from strokes.blocks(told)
    yield Heading(tr("Check of the linkage"))
    yield from kind.conditions(told)
    yield from _checked(told)
    yield from _pictured(told)
    for size in told.design.sizes:
        if size.unit == "m" and size.symbol not in WORDED and (told.design.dwell is None or size.symbol[:2] == "l_"):
            yield Result(letter_of(size.symbol), told.lexicon[letter_of(size.symbol)])


def data(order: Order) -> Iterator[Block]:
    """What is sought, and what is asked of it."""
    told = told_of(order)
    kind: Any = import_module(f"{HOME}.{KINDS[told.found.kind]}")
    yield Paragraph(kind.task(told))
    yield from data_of(_asked(told, kind))
    yield from kind.further(told)


def _asked(told: Told, kind: Any) -> dict[str, Given]:
    """What is asked, by its letters."""
    task = told.task
    given: dict[str, Given] = kind.given(told)
    if task.crank_speed is not None:
        given["n_1"] = Given(task.crank_speed * 30 / math.pi, "rpm", tr("speed of the crank"))
    if task.working_speed is not None:
        given["v_p"] = Given(task.working_speed, "m/s", tr("mean speed on the working stroke"))
    return given


def _listed(told: Told) -> Iterator[Block]:
    """All linkages that were found, with their figures of merit, and which one is taken."""
    if len(told.listed) < 2:
        return
    yield Heading(tr("Choice of the linkage"))
    rule = "" if told.design.dwell is not None else tr_name(told.found.rule)
    yield Paragraph(
        tr("The linkages that were found are in table {tab:synthesis_listed}, the best first.")
        + (" " + tr("They are ordered by: {rule}.", rule=rule) if rule else "")
    )
    rows = {*range(SHOWN - 1), told.number - 1} if len(told.listed) > SHOWN else {*range(len(told.listed))}
    yield _side_by_side(told.listed, sorted(rows))
    if passed := told.found.counters.get("passed over"):
        yield Paragraph(
            tr(
                "Linkages that fail the constraints of the spec stand after the others; there are {count}.",
                count=passed,
            )
        )
    taken = tr("Linkage {number} is taken; its dimensions are worked out above.", number=told.number)
    spec = told.order.spec
    if told.number > 1 and spec.constraints and not spec.synthesis.choose:
        taken += " " + tr("It is the first with which the constraints are kept.")
    yield Paragraph(taken)


def _side_by_side(designs: Sequence[Design], rows: Sequence[int]) -> Table:
    """Sizes, figures of merit and defects of linkages in columns."""
    shown, first = [designs[k] for k in rows], designs[0]
    cells = [
        (_called(size), *_row([design.sizes[k].value for design in shown], size.unit))
        for k, size in enumerate(first.sizes)
    ]
    for key in first.merits:
        if all(abs(design.merits[key]) < NOISE for design in shown):
            continue
        said = Quantity(key, "")
        cells.append((_merit(said.name), *_row([design.merits[key] for design in shown], said.unit)))
    defects = ["; ".join(_defects(design)) for design in shown]
    if any(defects):
        cells.append((tr("defects"), "", *(each or "–" for each in defects)))
    head = tr("Quantity"), tr("Unit"), *(str(k + 1) for k in rows)
    return Table(tr("Linkages that were found"), head, tuple(cells), "synthesis_listed")


def _called(size: Size) -> str:
    return tr_name(size.meaning) if size.symbol in WORDED else f"${letter_of(size.symbol)}$"


def _merit(name: str) -> str:
    """A figure of merit in words, a ratio or a criterion by its letters."""
    if "/" in name and len(name) == 3:
        return f"${name[0]}$/${name[2]}$"
    return f"$f_{name[1]}$" if len(name) == 2 else tr_name(name.replace("_", " "))


def _row(values: Sequence[float], unit: str) -> list[str]:
    """The unit and the values of one quantity."""
    found = [quantity_of(value, unit, "") for value in values]
    printed, factor = printed_as(found[0].unit)
    numbers = [cell(factor * each.value, FIGURES) for each in found if isinstance(each.value, float)]
    return ["°" if printed == "deg" else tr_unit(printed), *numbers]


def _defects(design: Design) -> list[str]:
    """The defects of a linkage of a search, each in a few words."""
    heads = [words.partition(":")[0] for words in design.defects]
    return [tr_name(head) for head in heads if head in DEFECTS]


def _checked(told: Told) -> Iterator[Block]:
    """What the simulated linkage has beside what was asked."""
    rows = []
    for check in told.design.checks:
        unit, found = _row([check.achieved if abs(check.achieved) > NOISE else 0.0], check.unit)
        wanted = "–" if check.target is None else _row([check.target], check.unit)[1]
        missed = "–" if check.residual is None else cell(check.residual, 1)
        rows.append((called(check), unit, wanted, found, missed))
    yield Paragraph(
        tr(
            "The linkage that was found is computed over a turn of the crank as in the kinematic analysis, extremes as "
            "roots of the rates; table {tab:synthesis_checks} compares it with what was asked."
        )
    )
    head = tr("Quantity"), tr("Unit"), tr("Asked"), tr("Computed"), tr("Relative difference")
    yield Table(tr("Check of the linkage"), head, tuple(rows), "synthesis_checks")
    if defects := _defects(told.design):
        yield Paragraph(tr("The linkage has defects: {defects}.", defects="; ".join(defects)))


def _pictured(told: Told) -> Iterator[Block]:
    """The linkage to scale; further pictures are those of the kinds."""
    if told.design.dwell is not None:
        return
    mechanism = to_linkage(told.order.read(told.design.spec).linkage)
    draw = partial(draw_solution, mechanism=mechanism, kind=told.found.kind, design=told.design)
    precision = told.design.precision
    if precision is None:
        yield Paragraph(
            tr("Figure {fig:synthesis} shows the linkage in its extreme positions, with its dimensions in mm.")
        )
    else:
        yield Paragraph(tr("Figure {fig:synthesis} shows the linkage in the positions that were asked for."))
    high = min(max(proportion(mechanism) * WIDE + AROUND, LOW), HIGH)
    yield Figure(tr("The linkage that was found"), draw, (WIDE, high), "synthesis")
