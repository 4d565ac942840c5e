"""Documents of how a flywheel is found: Wittenbauer's tangents on paper, the numbers of every method."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.quantity import in_degrees, keyed, table
from tmmcalc.linkage.columns import phi_column
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.facts.flywheel import CALLED
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.worked import MEAN_ENERGY, REST, Paper, Worked, curve_columns, paper, round_scales
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.positions import positions_view

MORE = "print all of it with --format csv"
OF_LINKS = (MEAN_ENERGY.name, REST.name)  # columns for Mertsalov's method alone
FAST, SLOW = "max", "min"  # labels of the rows where the tangents touch


def tangents_document(
    result: Flywheel,
    cycle: Cycle,
    positions: tuple[Sequence[str], np.ndarray],
    speed: float,
    title: str,
    *,
    everything: bool = False,
) -> Document:
    """The tangents, and the curve at the positions, their labels and phi (n,) [rad], and where they touch.

    People get the curve and how far it is from both tangents; with ``everything`` the energies of the links too.
    """
    picture, sense = result.picture, result.sense
    scales = round_scales(picture)
    labels, phi = [*positions[0], FAST, SLOW], np.append(positions[1], sense * np.array(picture.touching))
    theta = np.clip(np.abs(phi), 0.0, cycle.period)
    columns = [phi_column(phi, turns=True), *curve_columns(picture, cycle, theta, speed, scales)]
    usual = [column for column in columns if everything or column.name not in OF_LINKS]
    facts = tuple(_tangent_facts(result, paper(picture, scales, sense)))
    view = positions_view(labels, columns, usual=usual, everything=everything)
    return Document(title, facts, table=view, wide=True, more=MORE)


def _tangent_facts(result: Flywheel, drawn: Paper) -> list[Fact]:
    picture = result.picture
    (fast, slow), (high, low) = picture.slopes, picture.intercepts
    scale = f"mu_T = {number(drawn.energy_scale)} J/mm, mu_J = {number(drawn.inertia_scale)} kg*m^2/mm"
    upper, lower = (math.degrees(each) for each in (drawn.angle_max, drawn.angle_min))
    touch = (math.degrees(each) for each in (drawn.at_max, drawn.at_min))
    lines = [
        f"{name}: tan psi = {number(k)} mu_J/mu_T = {number(k * drawn.inertia_scale / drawn.energy_scale)}, "
        f"psi = {angle(psi)} deg\ntouches at phi = {angle(at)} deg, intercept {number(b, peak=high - low)} J"
        for name, k, psi, at, b in zip(
            ("largest speed", "least speed"), (fast, slow), (upper, lower), touch, (high, low), strict=True
        )
    ]
    segment = (
        f"{number(drawn.segment)} mm, {number(high - low)} J\nJ_F = GH mu_T/(delta omega^2) = "
        f"{number(picture.inertia)} kg*m^2, all constant inertia"
    )
    origin = f"x = {number(drawn.origin_x)} mm, y = {number(drawn.origin_y)} mm: J = -J_F, A = -T_0"
    values = {"tangents": in_degrees(keyed(drawn))}
    parts = keyed(picture, "slope_max", "slope_min", "upper", "lower", "inertia", "energy")
    return [
        Fact("scale", scale, values),
        Fact("tangents (3.50)", "\n".join(lines), parts),
        Fact("segment GH", segment),
        Fact("they meet in", origin),
    ]


def methods_document(rows: Sequence[Worked], result: Flywheel, speed: float, title: str) -> Document:
    """The numbers of every method, in words and as a table with a row a method."""
    remarks = {row.positional.method: row.positional.remark for row in result.rows}
    facts = (
        Fact("mean speed", f"{number(speed)} rad/s, delta = {number(result.delta)}", keyed(result, "delta")),
        *(_worked_fact(row, remarks[row.method]) for row in rows),
    )
    columns = in_degrees(table(rows, Worked))
    columns["method"] = [_called(row) for row in rows]
    view = View([*columns], [*columns.values()])
    return Document(title, facts, table=view, wide=True, more=MORE)


def _called(row: Worked) -> str:
    return CALLED.get(row.method, row.method)


def _worked_fact(row: Worked, remark: str) -> Fact:
    """A method with its numbers in place."""
    peak = max(abs(row.intercept_max), abs(row.intercept_min))
    lines = [remark] if row.on == "cycle" else []
    for name, k, at, work, links, b in (
        (FAST, row.slope_max, row.at_max, row.work_max, row.links_max, row.intercept_max),
        (SLOW, row.slope_min, row.at_min, row.work_min, row.links_min, row.intercept_min),
    ):
        sum_of = f"{number(work, peak=peak)} - {number(k)} * {number(links)} = {number(b, peak=peak)} J"
        lines.append(f"phi = {angle(math.degrees(at))} deg: b_{name} = A - k_{name} J = {sum_of}")
    above, below = (number(b, peak=peak) for b in (row.intercept_max, row.intercept_min))
    lines.append(
        f"J_F = ({above} - {'(' + below + ')' if below.startswith('-') else below})/{number(row.divisor)} = "
        f"{number(row.inertia)} kg*m^2"
    )
    where = "" if row.on == "cycle" else " by its table"
    return Fact(f"{_called(row)}{where}", "\n".join(lines), {row.key: in_degrees(keyed(row))})
