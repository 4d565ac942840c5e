"""Reduced moments of all forces, works over the cycle, the reduced moment of inertia.

A driven slider has forces and masses in place of moments and inertias.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from tmmcalc.core.numerics.simpson import simpson_weights
from tmmcalc.core.plane import Real
from tmmcalc.machine.notes.reducing import Names, Reducing, friction_by_pairs, inertia_lines, moment_lines, reducing
from tmmcalc.machine.pictures.reduction import draw_course
from tmmcalc.machine.pictures.words import cause_name
from tmmcalc.machine.reduction.columns import contribution_name
from tmmcalc.machine.reduction.jumps import jumps
from tmmcalc.machine.reduction.ordinates import Ordinates, ordinates
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place, Table
from tmmcalc.report.numbers import NOISE
from tmmcalc.report.telling import cell, column_of, drawn, lines, named, tabulated, two_sides

POWER = "<M>*<w> = sum(F_i*v_i*cos(alpha_i), i) + sum(M_i*omega_i, i)"
ENERGY = "<J>*<w>**2/2 = sum(m_i*v_{Si}**2/2 + J_{Si}*omega_i**2/2, i)"
HIGH = 155.0  # of the picture [mm]
CANCELLED = 1e-4  # of the largest sum of ordinates: a work that is nothing but what Simpson's rule leaves
SIMPSON = "A^S = h/3*(Y_0 + 4*Y_1 + 2*Y_2)"


def blocks(order: Order) -> Iterator[Block]:
    """Moments with their lines and table, works with the ordinates of Simpson's rule, inertia, the diagrams."""
    result, names = order.results["reduction"], Names.of(order.results["reduction"])
    told = None if order.spec.torque is not None else reducing(order)
    yield Heading(tr("Reduced moments of forces") if result.turns else tr("Reduced forces"))
    if told is None:
        yield Paragraph(tr("The moment on the input shaft is given by its diagram, table {tab:reduction_moments}."))
    else:
        yield Paragraph(_equal_powers(result))
        yield Display(read(POWER.replace("<M>", names.total).replace("<w>", told.moving.rate)), "reduction_power")
        yield from moment_lines(told)
        yield from _still(told)
        yield Paragraph(tr("Reduced values in all positions are in table {tab:reduction_moments}."))
    yield from _jumps(result)
    yield from _moments_table(result, names)
    yield from _by_pairs(result, names, {} if told is None else friction_by_pairs(told))
    yield from _works(result, names)
    if np.any(result.inertia):
        yield Heading(tr("Reduced moment of inertia") if result.turns else tr("Reduced mass"))
        if told is not None:
            yield Paragraph(_equal_energies(result))
            energy = ENERGY.replace("<J>", names.inertia).replace("<w>", told.moving.rate)
            yield Display(read(energy), "reduction_energy")
            yield from inertia_lines(told)
        yield from _inertia_table(result, names, {} if told is None else told.columns)
    yield Paragraph(tr("Diagrams of the reduced values and of the works are in figure {fig:reduction_course}."))
    draw = partial(draw_course, result=result, flywheel=order.results.get("flywheel"))
    caption = tr("Reduced moments, works, excess energy, reduced inertia")
    yield drawn(caption, draw, HIGH if result.whole else HIGH / 2, "reduction_course")


def _still(told: Reducing) -> Iterator[Paragraph]:
    """What is zero in all positions that are shown, and so has no line."""
    causes = [
        f"${told.names.cause(each)}$ ({cause_name(each.name)})"
        for each, moment in zip(told.result.contributions, told.result.moment, strict=True)
        if np.max(np.abs(moment[[*told.rows]])) <= NOISE * np.max(np.abs(moment))
    ]
    if causes:
        yield Paragraph(tr("In the positions shown these are zero: {names}.", names=", ".join(causes)))


def _equal_powers(result: Reduction) -> str:
    if result.turns:
        return tr(
            "The moment reduced to the input link has the same power as all given forces, which act at the angles "
            "$alpha_i$ to the velocities of their points, and moments; forces of inertia are not among them."
        )
    return tr(
        "The force reduced to the input link has the same power as all given forces, which act at the angles "
        "$alpha_i$ to the velocities of their points, and moments; forces of inertia are not among them."
    )


def _equal_energies(result: Reduction) -> str:
    if result.turns:
        return tr("The reduced moment of inertia has the same kinetic energy as all links together.")
    return tr("The reduced mass has the same kinetic energy as all links together.")


def _coordinate(result: Reduction, names: Names) -> dict[str, ArrayLike]:
    """The first column of a table of positions."""
    return {"$phi$, deg": np.degrees(result.phi)} if result.turns else {f"${names.coordinate}$, m": result.phi}


def _jumps(result: Reduction) -> Iterator[Paragraph]:
    """Which side of a jump the table has: of the ends of the cycle, of loads, of friction between them."""
    if not result.whole:
        return
    yield from two_sides(result.labels, result.moment)
    loads, rubbing = jumps(result, loads=True), jumps(result, loads=False)
    if acting := _between(result, loads.larger):
        yield Paragraph(
            tr("Where a load begins or ends in a position (here {labels}), it counts there.", labels=acting)
        )
    if other := _between(result, loads.other):
        yield Paragraph(
            tr(
                "Where the technological load jumps in a position (here {labels}), its value there is that after the "
                "jump.",
                labels=other,
            )
        )
    if friction := _between(result, sorted(rubbing.rows - loads.rows)):
        yield Paragraph(
            tr("Where friction jumps in a position (here {labels}), the table has it after the jump.", labels=friction)
        )


def _between(result: Reduction, rows: Iterable[int]) -> str:
    """The labels of rows, without the ends of the cycle."""
    return ", ".join(result.labels[row] for row in rows if 0 < row < len(result.labels) - 1)


def _moments_table(result: Reduction, names: Names) -> Iterator[Table]:
    """Every cause and the sum at all positions."""
    columns = _coordinate(result, names)
    for contribution, moment in zip(result.contributions, result.moment, strict=True):
        columns[f"${names.cause(contribution)}$, {names.unit}"] = moment
    if len(result.contributions) > 1:
        columns[f"${names.total}$, {names.unit}"] = result.total
    caption = tr("Reduced moments of forces") if result.turns else tr("Reduced forces")
    table = tabulated(caption, columns, result.labels, head=tr("No."), key="reduction_moments")
    yield _with_factors(table, result) if _simple(result) else table


def _by_pairs(result: Reduction, names: Names, friction: Mapping[str, Real]) -> Iterator[Block]:
    """Friction pair by pair at all positions, where there are several that rub."""
    if len(friction) > 1:
        yield Paragraph(tr("The parts of the pairs in the friction are in table {tab:reduction_friction}."))
        columns = {**_coordinate(result, names), **friction}
        caption = tr("Reduced friction by pairs")
        yield tabulated(caption, columns, result.labels, head=tr("No."), key="reduction_friction")


def _simple(result: Reduction) -> bool:
    """Whether the positions are fit for Simpson's rule."""
    return all(each.simpson is not None for each in result.contributions)


def _cleaned(ordinates: Real) -> str:
    """The sum of ordinates as it is printed, nothing where it is but rounding."""
    found = float(np.sum(ordinates))
    return column_of([found if abs(found) > CANCELLED * float(np.sum(np.abs(ordinates))) else 0.0])[0]


def _with_factors(table: Table, result: Reduction) -> Table:
    """The table with the factors of Simpson's rule, and a row of the sums of its ordinates with them."""
    weights = simpson_weights(len(result.phi))
    factors = ("$k_i$", *map(str, weights.astype(int)), "")
    sums = [_cleaned(weights * moment) for moment in result.moment]
    last = (tr("Sum"), "", *sums, *("" for _ in table.head[len(sums) + 2 :]))
    rows = [(*row[:1], factor, *row[1:]) for factor, row in zip(factors, (table.head, *table.rows, last), strict=True)]
    return table._replace(head=rows[0], rows=tuple(rows[1:]))


def _works(result: Reduction, names: Names) -> Iterator[Block]:
    """Works by Simpson's rule where the positions are fit for it, and exactly."""
    yield Heading(tr("Works over a cycle") if result.whole else tr("Works over the range"))
    simple = _simple(result)
    if simple:
        yield from _by_simpson(result, names)
    works = np.array([each.work for each in result.contributions])
    scale = max(abs(e.value) for each in result.contributions for e in (each.least, each.largest)) * result.cycle.period
    some = np.abs(works) > NOISE * scale
    columns: dict[str, ArrayLike] = {}
    if simple:
        found = np.array([each.simpson for each in result.contributions], float)
        columns["$A^S$, J"] = found
    columns["$A$, J"] = np.where(some, works, 0.0)
    if not simple:
        yield Paragraph(tr("The works of the reduced forces are in table {tab:reduction_works}."))
    if simple:
        apart = np.where(some, found / np.where(some, works, 1.0) - 1, np.nan)
        columns["$Delta$, %"] = np.where(np.abs(apart) < NOISE, 0.0, 100 * apart)
        yield Paragraph(
            tr(
                "Table {tab:reduction_works} compares them with the exact works $A$, integrated between all places "
                "where a force begins or ends."
            )
        )
    labels = [f"${names.cause(each)}$" for each in result.contributions]
    yield tabulated(tr("Works of the reduced forces"), columns, labels, head=tr("Cause"), key="reduction_works")


def _by_simpson(result: Reduction, names: Names) -> Iterator[Block]:
    """The ordinates with their weights, and the work of every cause from their sums."""
    keys = {contribution_name(result, each): names.cause(each) for each in result.contributions}
    found = ordinates(result)
    yield Paragraph(
        tr(
            "The work of a force is the integral of its reduced value over the way of the input link; by Simpson's "
            "rule with the step $h$ it is $A^S = h/3*sum(k_i*Y_i, i)$, where $Y_i$ are the ordinates and $k_i$ = 1, 4, "
            "2, ..., 4, 1 their factors; the last row of table {tab:reduction_moments} has the sums of $k_i*Y_i$."
        )
    )
    some = {
        key: cause_name(each.name)
        for key, each in zip(keys, result.contributions, strict=True)
        if abs(found[key].work) > CANCELLED * found[key].step * _largest(found[key])
    }
    if some:
        yield from lines([SIMPSON], [Place(name, _sums(found[key])) for key, name in some.items()])
    if len(some) < len(keys):
        left = ", ".join(f"${name}$" for key, name in keys.items() if key not in some)
        yield Paragraph(tr("The ordinates of {names} cancel: their work is zero.", names=left))


def _largest(found: Ordinates) -> float:
    return max(abs(found.ends), abs(found.odd), abs(found.even))


def _sums(found: Ordinates) -> Lexicon:
    """The sums of one cause; what is rounding of its ordinates is nothing."""
    noise = NOISE * _largest(found)
    ends, odd, even = (each if abs(each) > noise else 0.0 for each in (found.ends, found.odd, found.even))
    return named(
        {
            "A^S": Given(found.work, "J", tr("work by Simpson's rule")),
            "h": Given(found.step, found.coordinate, tr("step of the positions")),
            "Y_0": Given(ends, found.unit, tr("sum of the first and the last ordinate")),
            "Y_1": Given(odd, found.unit, tr("sum of the ordinates of odd numbers")),
            "Y_2": Given(even, found.unit, tr("sum of the other ordinates of even numbers")),
        }
    )


def _inertia_table(result: Reduction, names: Names, further: Mapping[str, Real]) -> Iterator[Block]:
    """What the links add, the sum, its derivative; with the rods the other way where there are some."""
    if np.ptp(result.inertia) <= NOISE * np.max(result.inertia):
        words = {"name": f"${names.inertia}$", "value": cell(float(result.inertia[0]))}
        yield Paragraph(
            tr("Its value is constant over the cycle: {name} = {value} {unit}.", unit=tr_unit(names.mass_unit), **words)
        )
        return
    yield Paragraph(
        tr("The reduced moment of inertia in all positions is in table {tab:reduction_inertia}.")
        if result.turns
        else tr("The reduced mass in all positions is in table {tab:reduction_inertia}.")
    )
    columns = _coordinate(result, names)
    first = f"{names.letter}_red_"
    for key, values in further.items():
        of = key.removeprefix(first)
        if key.startswith(first) and not of.endswith(("_mass", "_turning")):
            columns[f"${names.part(of)}$, {names.mass_unit}"] = values
    columns[f"${names.inertia}$, {names.mass_unit}"] = result.inertia
    columns[f"${names.slope()}$, {names.slope_unit}"] = result.slope
    if result.other is not None:
        columns[f"${names.part('l')}$, {names.mass_unit}"] = result.other
    caption = tr("Reduced moment of inertia") if result.turns else tr("Reduced mass")
    yield tabulated(caption, columns, result.labels, head=tr("No."), key="reduction_inertia")
    if result.other is not None:
        name, rods = f"${names.part('l')}$", ", ".join(map(str, result.rod_links))
        lumped = (
            tr("In column {name} the masses of the rods ({rods}) are lumped in their pins.", name=name, rods=rods)
            if len(result.rod_links) > 1
            else tr("In column {name} the mass of the rod, link {rods}, is lumped in its pins.", name=name, rods=rods)
        )
        yield Paragraph(
            lumped if result.rods == "exact" else tr("In column {name} the rods are taken exactly.", name=name)
        )
