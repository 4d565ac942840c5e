"""The chapter on unsteady motion: the time-optimal law of the input by its phases, and what it moves."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.timelaw import TimeLaw, phase_of
from tmmcalc.linkage.pictures.unsteady import piece_of
from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady
from tmmcalc.linkage.unsteady.results import Unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask
from tmmcalc.report.drawing.lettering import point_name
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.optimal import PHASES, by_duration, by_travel, phase_named, quantities
from tmmcalc.report.telling import column_of, lines, named, pictured, tabulated, titled


def blocks(order: Order) -> Iterator[Block]:
    """The largest speed and the times of the phases, the law in each, the table and the extremes."""
    result: Unsteady = order.results["unsteady"]
    law = result.law
    if not law.speed:
        yield Paragraph(tr("The input stays where it is."))
        return
    yield Heading(tr("Time-optimal law of the input"), 2)
    yield from _law(result, to_unsteady(order.spec))
    yield Heading(tr("Motion in the phases"), 2)
    yield from _phases(result, order)
    yield Heading(tr("Motion of the mechanism"), 2)
    yield from _moved(result)
    yield pictured(piece_of(order), key="unsteady")


def _quantities(result: Unsteady, task: UnsteadyTask) -> Lexicon:
    """The law, by its letters, with the ends of the motion."""
    unit = "rad" if result.turns else "m"
    found = {
        **quantities(
            result.law,
            unit,
            travel=tr("travel of the input"),
            peak=tr("largest speed of the input that is reached"),
            allowed=tr("allowed acceleration of the input"),
        ),
        "x_0": Given(result.start, unit, tr("coordinate of the input at the beginning")),
        "x_e": Given(result.end, unit, tr("coordinate of the input at the end")),
    }
    if task.speed is not None:
        found["v_m"] = Given(task.speed, f"{unit}/s", tr("allowed speed of the input"))
    return named(found)


def _law(result: Unsteady, task: UnsteadyTask) -> Iterator[Block]:
    """Speed and times, in the order in which what is given settles them."""
    law = result.law
    yield Paragraph(
        tr(
            "The input moves from rest to rest in the shortest time that the limits of its speed and acceleration "
            "allow: with the largest acceleration, at constant speed, with the largest deceleration."
        )
        if task.duration is None
        else tr(
            "The input moves from rest to rest in the given time: with the largest acceleration, at constant speed, "
            "with the largest deceleration."
        )
    )
    known = _quantities(result, task)
    yield from lines(_texts(law, task), [Place("", known)])
    yield Result("T", known["T"])
    if not law.uniform:
        yield Paragraph(tr("There is no uniform motion: the allowed speed is not reached."))


def _texts(law: TimeLaw, task: UnsteadyTask) -> tuple[str, ...]:
    """The formulas of the law: by the time alone, by travel and time, by the travel alone."""
    sign, way = ("+", "x_e - x_0") if law.sense > 0 else ("-", "x_0 - x_e")
    if task.end is None and task.travel is None:
        return (*by_duration(law), f"x_e = x_0 {sign} S_m")
    return (f"S_m = {way}", *by_travel(law, timed=task.duration is not None))


def _phases(result: Unsteady, order: Order) -> Iterator[Block]:
    """The law in every phase with one instant by the numbers."""
    phases = phase_of(result.law, result.t, result.side)
    task = to_unsteady(order.spec)
    for phase, texts in PHASES.items():
        rows = np.flatnonzero(phases == phase).tolist()
        if rows:
            middle = rows[len(rows) // 2]
            place = Place(tr("in row {label}", label=result.labels[middle]), _at(result, task, middle))
            yield Paragraph(phase_named(phase))
            yield from lines(texts, [place], {"t": "t"})


def _at(result: Unsteady, task: UnsteadyTask, row: int) -> Lexicon:
    """The law at a row: travel and speed of the input."""
    unit = "rad" if result.turns else "m"
    sense = result.law.sense
    x, v, _ = result.drive[:, row].tolist()
    moved = {
        "t": Given(float(result.t[row]), "s", tr("time")),
        "s": Given(sense * (x - result.start), unit, tr("travel of the input from its start")),
        "v": Given(sense * v, f"{unit}/s", tr("speed of the input")),
    }
    return {**_quantities(result, task), **named(moved)}


def _moved(result: Unsteady) -> Iterator[Block]:
    """The transfer functions in time, the table, the extremes."""
    yield Paragraph(
        tr(
            "What moves with the input has the velocity and the acceleration that follow from its first and second "
            "transfer functions $S'$ and $S''$:"
        )
    )
    yield Display(read("v_S = S'*v"))
    yield Display(read("a_S = S''*v**2 + S'*a"))
    yield Paragraph(
        tr(
            "Table {tab:unsteady_rows} and figure {fig:unsteady} have the input coordinate $x$, its speed and "
            "acceleration, and those of the outputs; a minus after the number of a row marks the limit before a jump "
            "of the acceleration."
        )
    )
    columns = {"$t$, s": result.t, **_triple(("x", "v", "a"), result.turns, result.drive)}
    caption, key = tr("Unsteady motion of the input"), "unsteady_rows"
    for k, (name, angular) in enumerate(zip(result.outputs, result.angular, strict=True)):
        first, second, third = ("phi", "omega", "eps") if angular else ("S", "v", "a")
        output = titled(point_name(name))
        letters = f"{first}_{{{name}}}", f"{second}_{{{name}}}", f"{third}_{{{name}}}"
        moved = _triple(letters, angular, result.coordinate[:, k])
        if k:
            yield tabulated(caption, columns, result.labels, head=tr("Row"), key=key)
            columns, caption = {"$t$, s": result.t, **moved}, tr("Motion of output {name}", name=output)
            key = f"unsteady_output_{k}"
            yield Paragraph(tr("The motion of output {name} is in table {table}.", name=output, table=f"{{tab:{key}}}"))
        else:
            columns, caption = (
                {**columns, **moved},
                tr("Unsteady motion of the input and of output {name}", name=output),
            )
    yield tabulated(caption, columns, result.labels, head=tr("Row"), key=key)
    yield from _extremes(result)


def _triple(letters: tuple[str, str, str], angular: bool, rows: Real) -> dict[str, Real]:
    """Heads and columns of a coordinate and its derivatives, rows (3, n)."""
    units = ("deg", "rad/s", "rad/s^2") if angular else ("m", "m/s", "m/s^2")
    values = (np.degrees(rows[0]) if angular else rows[0], rows[1], rows[2])
    return {f"${letter}$, {unit}": row for letter, unit, row in zip(letters, units, values, strict=True)}


def _extremes(result: Unsteady) -> Iterator[Block]:
    """Extreme angular velocities and accelerations of the links."""
    links = [
        each for each in result.extremes if each.name.startswith(("omega_", "eps_")) and each.least != each.largest
    ]
    if not links:
        return
    yield Paragraph(tr("Table {tab:unsteady_extremes} has the extremes of the links, between the rows too."))
    head = (tr("Quantity"), tr("least"), f"$t$, {tr_unit('s')}", tr("largest"), f"$t$, {tr_unit('s')}")
    rows = []
    for each in links:
        numbers = (each.least, each.least_at, each.largest, each.largest_at)
        rows.append((f"${each.name}$, {tr_unit(each.unit)}", *(column_of([number])[0] for number in numbers)))
    yield Table(tr("Extremes of the motion of the links"), head, tuple(rows), "unsteady_extremes")
