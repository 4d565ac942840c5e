"""The motion over the cycle: tables of all positions, diagrams, and numerical differentiation beside the formulas."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.columns import units_of
from tmmcalc.linkage.kinematics import default_step, solve_kinematics
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.told import Told
from tmmcalc.linkage.outputs import coordinate_of, default_outputs
from tmmcalc.linkage.pictures.cycle import TURN, along, closed
from tmmcalc.linkage.pictures.diagrams import columns_of
from tmmcalc.linkage.pictures.pieces import of_outputs
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.lettering import point_name
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.numbers import number
from tmmcalc.report.telling import column_of, filled, lines, located, named, pictured, tabulated, titled

ROUND, NOISE = 8, 1e-9  # decimals of a place that are no rounding; a pressure angle that is none [rad]
COLUMNS, DIGITS = 13, 4  # of a table beside the positions, and of the largest number of one

DIFFERENCES = (
    "<S>'_{<D>} = (<S>_{<D>}^{+} - <S>_{<D>}^{−})/(2*theta)",
    "<S>''_{<D>} = (<S>_{<D>}^{+} - 2*<S>_{<D>}^{0} + <S>_{<D>}^{−})/theta**2",
)

Columns = dict[str, Real]


def blocks(told: Told) -> Iterator[Block]:
    """Tables, diagrams, the comparison."""
    yield Heading(tr("Motion over the cycle"), 2)
    yield from _tables(told)
    figures = [
        pictured(piece, key=f"course_{k}")
        for k, piece in enumerate(of_outputs(told.result, told.cycle, columns_of(told.result, told.cycle)))
    ]
    if figures:
        yield Paragraph(tr("The diagrams of the motion are {where}.", where=located(figures)))
    yield from figures
    yield from _extremes(told)
    yield from _pressure(told)
    if told.result.outputs:
        yield Heading(tr("Numerical differentiation"), 2)
        yield from _differences(told)


def _tables(told: Told) -> Iterator[Block]:
    """All positions, dimensionless where there is a crank, and with units."""
    caption = tr("Positions, velocities and accelerations over the cycle")
    if told.result.crank_length is None:
        tables = [*_split(told, caption, _columns(told, False), "course")]
        said = tr("Positions, velocities and accelerations over the cycle are {where}.", where=located(tables))
        yield Paragraph(said)
        yield from tables
        return
    bare = [*_split(told, f"{caption}, {tr('dimensionless')}", _columns(told, True), "course")]
    tables = [*_split(told, caption, _columns(told, False), "course_si")]
    said = tr(
        "Dimensionless values of all positions are {bare}: lengths in units of the crank $l_1$, velocities in those of "
        "$l_1*omega_1$, accelerations in those of $l_1*omega_1**2$; values with units are {where}. At constant speed "
        "the dimensionless values are the analogues of velocity and acceleration, derivatives with respect to the "
        "angle of the crank that do not depend on its speed: $v/(l_1*omega_1) = S'/l_1$, "
        "$a/(l_1*omega_1**2) = S''/l_1$.",
        bare=located(bare),
        where=located(tables),
    )
    yield Paragraph(said)
    yield from (*bare, *tables)


def _extremes(told: Told) -> Iterator[Block]:
    """Largest and least velocities and accelerations of the outputs, between the positions too."""
    summaries = told.result.summaries
    if not summaries:
        return
    yield Paragraph(
        tr(
            "The extreme velocities and accelerations of the outputs, between the positions too, are in table "
            "{tab:course_extremes}."
        )
    )
    place = "phi" if told.result.turns else "Deltas"
    at = f"${place}$, {tr_unit('deg' if told.result.turns else 'm')}"
    rows: list[tuple[str, ...]] = []
    for summary in summaries:
        name = plain_name(summary.name)
        letters = ("omega", "rad/s"), ("eps", "rad/s^2")
        if not summary.angular:
            letters = ("v", "m/s"), ("a", "m/s^2")
        for (letter, unit), ends in zip(letters, (summary.velocity, summary.acceleration), strict=True):
            symbol = f"{letter}_{{{name}}}"
            cells = [cell for end in ends for cell in (column_of([end.value])[0], _place(told, end.x))]
            rows.append((f"${symbol}$, {tr_unit(unit)}", *cells))
            largest = max(abs(end.value) for end in ends)
            if largest:
                said = tr("largest magnitude of {quantity}", quantity=f"${symbol}$")
                yield Result(symbol, Given(largest, unit, said))
    head = (tr("Quantity"), tr("least"), at, tr("largest"), at)
    yield Table(tr("Extreme velocities and accelerations of the outputs"), head, tuple(rows), "course_extremes")


def _place(told: Told, x: float) -> str:
    """An input coordinate as it is counted from position 0 [deg or m]."""
    counted = along(told.result, x, closed(told.chain))
    return spelt(number(round(math.degrees(counted) if told.result.turns else counted, ROUND) + 0.0, 5))


def _pressure(told: Told) -> Iterator[Block]:
    """The largest pressure angle of every group that has one."""
    for quality in told.result.qualities:
        if quality.pressure is None or quality.pressure < NOISE:
            continue
        said = tr("largest pressure angle of group {group}", group=quality.group)
        given = Given(math.degrees(quality.pressure), "deg", said)
        words = {"group": quality.group, "angle": spelt(f"{number(math.degrees(quality.pressure), 5)}°")}
        if quality.transmission_at is None:
            yield Paragraph(tr("The pressure angle of group {group} is {angle} in all positions.", **words))
        else:
            where = f"{_place(told, quality.transmission_at)}{'°' if told.result.turns else ' ' + tr_unit('m')}"
            place = f"${'phi' if told.result.turns else 'Deltas'}$ = {where}"
            text = tr("The pressure angle of group {group} is largest, {angle}, at {place}.", place=place, **words)
            yield Paragraph(text)
        yield Result("", given)


def _split(told: Told, caption: str, columns: Mapping[str, Real], key: str) -> Iterator[Table]:
    """The columns over the positions, in as many tables as keep them narrow enough."""
    parts = math.ceil(len(columns) / COLUMNS)
    for k, names in enumerate(np.array_split([*columns], parts)):
        shown = {name: columns[name] for name in names.tolist()}
        own = key if not k else f"{key}_{k}"
        yield tabulated(caption, shown, told.result.labels, head=tr("No."), key=own, digits=DIGITS)


def _columns(told: Told, dimensionless: bool) -> Columns:
    """Coordinates, velocities and accelerations of the outputs, the links that turn, the sliders."""
    result = told.result
    units = units_of(result, dimensionless)
    found: Columns = {"$phi$, deg": np.degrees(result.phi)} if result.turns else {"$Deltas$, m": result.phi}
    for k, output in enumerate(result.outputs):
        if result.angular[k]:
            continue
        name = plain_name(output)
        first, second = result.in_time(result.ds[k], result.dds[k])
        found[_headed(f"S_{{{name}}}", units.length[0])] = result.s[k] * units.length[1]
        found[_headed(f"v_{{{name}}}", units.velocity[0])] = first * units.velocity[1]
        found[_headed(f"a_{{{name}}}", units.acceleration[0])] = second * units.acceleration[1]
    trace = result.trace
    for k, link in enumerate(trace.link_ids):
        if link in told.turning:
            omega, eps = result.in_time(trace.dangle[k], trace.ddangle[k])
            found[f"$phi_{link}$, deg"] = np.degrees(trace.angle[k]) + _line(told, k, link)
            found[_headed(f"omega_{link}", units.omega[0])] = omega * units.omega[1]
            found[_headed(f"eps_{link}", units.eps[0])] = eps * units.eps[1]
    for k, joint in enumerate(trace.joint_names):
        slider, guide = told.chain.mechanism.joint(joint).links
        if guide == 0 or joint == result.input_joint:
            continue
        first, second = result.in_time(trace.ds[k], trace.dds[k])
        found[_headed(f"s_{slider}", units.length[0])] = trace.s[k] * units.length[1]
        found[_headed(f"v_{{{slider}{guide}}}", units.velocity[0])] = first * units.velocity[1]
        found[_headed(f"a_{{{slider}{guide}}}", units.acceleration[0])] = second * units.acceleration[1]
    return found


def _line(told: Told, k: int, link: int) -> float:
    """The angle [deg] of the line of a link that the formulas use against its axis, with their whole turns."""
    given = told.lexicons[0].get(f"phi_{link}")
    if given is None or not isinstance(given.value, float):
        return 0.0
    return given.value - math.degrees(told.result.trace.angle[k][told.rows[0]])


def _headed(name: str, unit: str) -> str:
    """A quantity with its unit, or over the one that is made of the crank."""
    if unit.startswith(("l_1", "omega_1")):
        below = f"${unit.replace('^', '**')}$"
        return f"${name}$/({below})" if "*" in unit else f"${name}$/{below}"
    return f"${name}$, {unit}"


def _differences(told: Told) -> Iterator[Block]:
    """Central differences of the position function of every output, at the shown positions and in a table."""
    result, step = told.result, default_step(told.chain)
    found = solve_kinematics(told.chain.mechanism, result.structure, "differences", step)
    written = f"{number(math.degrees(step), 4)}°" if result.turns else f"{number(step, 4)} {tr_unit('m')}"
    yield Paragraph(
        tr(
            "As a check the position functions are differentiated numerically, with the step $theta$ = {step} to both "
            "sides of a position:",
            step=spelt(written),
        )
    )
    for k, output in enumerate(default_outputs(told.chain)):
        name = plain_name(result.outputs[k])
        words = {"D": name, "S": "Deltaphi" if result.angular[k] else "S"}
        places = []
        for place, row in zip(told.places, told.rows, strict=True):
            rates = float(found.ds[k][row]), float(found.dds[k][row])
            values = _around(told, output, k, row, step)
            places.append(Place(place.name, place.lexicon | named(_stencil(told, k, words, values, rates, step))))
        yield from lines(DIFFERENCES, places, words)
        yield from _compared(told, found, k, name)


def _around(told: Told, output: Output, k: int, row: int, step: float) -> tuple[float, float, float]:
    """The displacement of an output a step before a position, in it, and a step after it [m or rad]."""
    x = float(told.result.x[row]) + step * np.array([-1.0, 0.0, 1.0])
    start = told.chain.evaluate(told.result.x[:1], order=0)
    first = np.ravel(coordinate_of(told.chain, output, start)[0])[0]
    there = coordinate_of(told.chain, output, told.chain.evaluate(x, order=0))[0]
    found = np.broadcast_to(there, x.shape) - first
    if output.link is not None:
        found = found + TURN * np.rint((told.result.s[k][row] - found) / TURN)
    return float(found[0]), float(found[1]), float(found[2])


def _stencil(
    told: Told,
    k: int,
    words: Mapping[str, str],
    values: tuple[float, float, float],
    rates: tuple[float, float],
    step: float,
) -> Lexicon:
    """The quantities of a central difference."""
    angular, turns = told.result.angular[k], told.result.turns
    unit = "rad" if angular else "m"
    per = "rad" if turns else "m"
    own, own2 = ("", "") if unit == per else (f"{unit}/{per}", f"{unit}/{per}^2")
    name = {"output": words["D"]}
    if angular:
        there = tr("turn of link {output} in the position", **name)
        aside = tr("turn of link {output} a step after the position and a step before it", **name)
    else:
        there = tr("displacement of {output} in the position", **name)
        aside = tr("displacement of {output} a step after the position and a step before it", **name)
    found: Lexicon = {
        f"<S>_{{<D>}}^{{{mark}}}": Given(value, unit, there if mark == "0" else aside)
        for mark, value in zip("−0+", values, strict=True)
    }
    found |= {
        "<S>'_{<D>}": Given(rates[0], own, tr("analogue of the velocity by differences")),
        "<S>''_{<D>}": Given(rates[1], own2, tr("analogue of the acceleration by differences")),
        "theta": Given(step, "rad" if turns else "m", tr("step of differentiation")),
    }
    return {filled(key, words): given for key, given in found.items()}


def _compared(told: Told, found: Kinematics, k: int, name: str) -> Iterator[Block]:
    """Velocity and acceleration of an output by the formulas and by differences, in all positions."""
    result = told.result
    letters = (("omega", "rad/s"), ("eps", "rad/s^2")) if result.angular[k] else (("v", "m/s"), ("a", "m/s^2"))
    exact = result.in_time(result.ds[k], result.dds[k])
    near = found.in_time(found.ds[k], found.dds[k])
    heads, columns, worst = [tr("No.")], [list(result.labels)], []
    for (letter, unit), one, other in zip(letters, exact, near, strict=True):
        share = 100 * np.abs(other - one) / (float(np.max(np.abs(one))) or 1.0)
        worst.append(float(np.max(share)))
        symbol = f"${letter}_{{{name}}}$"
        by = tr("{quantity} by differences", quantity=symbol)
        heads += [f"{symbol}, {tr_unit(unit)}", f"{by}, {tr_unit(unit)}", f"{tr('Difference')}, %"]
        columns += [column_of(one), column_of(other), [spelt(f"{each:.2f}") for each in share]]
    key = f"differences_{k}"
    yield Paragraph(
        tr(
            "Table {table} compares all positions: the largest difference is {first} % of the largest velocity and "
            "{second} % of the largest acceleration.",
            table=f"{{tab:{key}}}",
            first=spelt(f"{worst[0]:.2g}"),
            second=spelt(f"{worst[1]:.2g}"),
        )
    )
    apart = Given(max(worst), "%", tr("largest difference of numerical differentiation"))
    shown = titled(point_name(name))
    if result.angular[k]:
        yield Result("Delta", apart, place=tr("link {link}", link=name))
        caption = tr("Numerical differentiation of the motion of link {output}", output=name)
    else:
        yield Result("Delta", apart, place=shown)
        caption = tr("Numerical differentiation of the motion of {output}", output=shown)
    yield Table(caption, tuple(heads), tuple(zip(*columns, strict=True)), key)
