"""The documents of the optimal design: the lowest mechanism, its constraints, the contour, what relaxing buys."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import degrees
from typing import Any

from tmmcalc.cams.facts.design_game import game_document, game_facts, option_values
from tmmcalc.cams.follower import along
from tmmcalc.cams.optimum.results import NAMES, CamOptimum, Check, Choice, Contour, Corner, Relaxation
from tmmcalc.core.quantity import Quantity, in_degrees, keyed, keys, quantity_of, table
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.sizes import quantity

EXAMINED = {"turn": "the whole turn, dwells included", "rise": "the rise alone, as in the textbook"}
SIZES = ("height", "start", "roller", "length")
LEAST_MARGIN = Quantity("margin_least", "margin of the lowest mechanism of any sizes")
FEW = 12  # step points that are listed


def summary(result: CamOptimum, title: str) -> Document:
    """The lowest mechanism with its constraints as a table."""
    return Document(title, tuple(_lowest_facts(result)), result.notes, _checks_view(result))


def document(result: CamOptimum, title: str, *, everything: bool = False) -> Document:
    """All of it; ``everything`` is for programs: corners and borders of the contours as values, in SI."""
    facts = [*_lowest_facts(result), *_searched_facts(result), *_relaxed_facts(result), *game_facts(result)]
    if everything:
        values = {
            "checks": [_check_values(each) for each in result.chosen.checks],
            "checks_least": [_check_values(each) for each in result.least.checks],
            "contours": [_contour_values(result, each) for each in result.contours],
            "options": [option_values(each, result.names) for each in result.options],
        }
        return Document(title, (*facts, Fact("all values", "", values)), result.notes)
    parts = [_contour_part(result, each) for each in result.contours]
    if result.options:
        parts.append(game_document(result))
    return Document(title, tuple(facts), result.notes, _checks_view(result), parts=tuple(parts))


def _sizes(result: CamOptimum, choice: Choice) -> str:
    roller = f", r2 = {quantity(choice.roller, 'm')}" if choice.roller else ""
    height, start, length = (quantity(v, "m") for v in (choice.height, choice.start, choice.length))
    names = result.names
    said = f"{names['height']} = {height} with {names['start']} = {start}{roller}"
    return f"{said}; rocker l2 = {length}" if result.kind == "oscillating" else f"{said}; guide l = {length}"


def _named(numbers: tuple[int, ...]) -> str:
    return ", ".join(f"{key} {NAMES[key]}" for key in numbers)


def _lowest_facts(result: CamOptimum) -> Iterator[Fact]:
    chosen, least, worst = result.chosen, result.least, result.chosen.worst
    if result.refused:
        yield Fact("as asked", f"no solution: {result.refused}", keyed(result, "refused"))
        yield Fact("option shown", ", ".join(result.shown), keyed(result, "shown"))
    text = f"{_sizes(result, chosen)}\nleast margin {number(100 * worst.margin, 4)} %: {worst.number} {worst.name}"
    best = "smallest" if result.kind == "oscillating" else "lowest"
    places = result.names
    yield Fact(f"{best} in whole steps", text, keyed(chosen, *SIZES, "least_margin", kind="steps", **places))
    active = _named(least.active) or "none"
    yield Fact(
        f"{best} of any sizes",
        f"{_sizes(result, least)}\nactive: {active}",
        keyed(least, *SIZES, "active", kind="least", **places),
    )
    if result.offset is not None:
        yield Fact("offset", f"e = {quantity(result.offset, 'm')}, of all these sizes", keyed(result, "offset"))
    if result.theta is not None:
        rise, back = (degrees(value) for value in result.theta)
        text = f"up to {angle(rise)} deg on the rise, {angle(back)} deg on the return, in whole steps"
        yield Fact("pressure angle", text, keyed(result, "theta_rise[deg]", "theta_return[deg]"))
    if result.flat is not None:
        chart = result.flat
        text = (
            f"S0_min = r_m - F_min = {quantity(chart.least_start, 'm')}, F_min = {quantity(chart.convexity, 'm')} at "
            f"phi = {angle(degrees(chart.phi))} deg\nl* = {quantity(chart.least_length, 'm')} by the pressure at "
            f"phi = {angle(degrees(chart.length_phi))} deg\n"
            f"H2_min = S0_min + h + l* = {quantity(chart.least_height, 'm')}"
        )
        values = keyed(chart, "least_start", "convexity", "least_length", "least_height")
        yield Fact("chart of H2 and S0", text, values)
    yield Fact("examined", EXAMINED[result.phases], keyed(result, "phases"))
    spring = f"c = {number(1e-3 * result.stiffness, 6)} N/mm, Q0 = {number(result.preload, 6)} N"
    if result.kind == "oscillating":
        spring = f"c = {number(result.stiffness, 6)} N*m/rad, M0 = {number(result.preload, 6)} N*m"
    yield Fact("spring", spring, keyed(result, "stiffness", "preload", **along(result.kind == "oscillating")))


def _searched_facts(result: CamOptimum) -> Iterator[Fact]:
    """All feasible step points at the least height, and why none is lower."""
    named = {name: getattr(result, name) for name in ("start", "length", "roller", "margin")}
    named = {name: values.tolist() for name, values in named.items() if values is not None}
    rows = list(zip(*named.values(), strict=True))
    lines = [_point(result, dict(zip(named, row, strict=True))) for row in rows[:FEW]]
    if len(rows) > FEW:
        lines.append(f"and {len(rows) - FEW} more")
    names = keys(CamOptimum, *named, **result.names)
    values = [dict(zip(names, row, strict=True)) for row in rows]
    yield Fact("feasible step points", "\n".join(lines), {"step_points": values})
    looked = (
        f"{result.examined} step points of {quantity(result.step, 'm')} looked at, {result.excluded} of them fit no"
    )
    lowest = f"{quantity(result.chosen.height, 'm')} in steps of {quantity(result.height_step, 'm')} has a feasible one"
    told = ("height", "points", "judged", "kept", "margin", "number")
    course = {"course": [keyed(each, *told, **result.names) for each in result.course]}
    if result.kind == "oscillating":
        text = f"{looked} roller\nno l0 below {lowest}"
        yield Fact("search", text, {**keyed(result, "examined", "excluded"), **course})
        return
    text = f"{looked} height\nno height below {lowest}"
    yield Fact("search", text, {**keyed(result, "examined", "excluded", "left_by"), **course})


def _point(result: CamOptimum, sizes: Mapping[str, float]) -> str:
    names = {"start": result.names["start"], "length": "l2", "roller": "r2"}
    said = [f"{symbol} = {quantity(sizes[name], 'm')}" for name, symbol in names.items() if sizes.get(name)]
    return f"{', '.join(said)}: least margin {number(100 * sizes['margin'], 3)} %"


def _relaxed_facts(result: CamOptimum) -> Iterator[Fact]:
    if not result.relaxations:
        return
    lines = [_relaxed(each) for each in result.relaxations]
    told = ("number", "key", "before", "after", "height", "gain")
    values = [in_degrees(keyed(each, *told, unit=each.unit, **result.names)) for each in result.relaxations]
    yield Fact("relaxing would buy", "\n".join(lines), {"relaxations": values})


def _relaxed(each: Relaxation) -> str:
    how = "next preferred number" if each.preferred else "1 %"
    gain = quantity(each.gain, "m", 3) if each.gain > 1e-9 else "nothing"
    return (
        f"{each.number} {NAMES[each.number]}: {each.key} {_shown(each.before, each.unit)} -> "
        f"{_shown(each.after, each.unit)} ({how}): {gain}"
    )


def _shown(value: float, unit: str, digits: int = 6) -> str:
    """A size, stress, number or angle with its unit."""
    return f"{number(degrees(value), digits)} deg" if unit == "rad" else quantity(value, unit, digits)


def _checks_view(result: CamOptimum) -> View:
    """One row a constraint: at the step point, and the margins of the lowest of any sizes beside it."""
    least = {each.number: each for each in result.least.checks}
    rows = [_cells(each, least[each.number]) for each in result.chosen.checks]
    margins = [each.shown("%")[0] for each in (quantity_of(Check, "margin"), LEAST_MARGIN)]
    headers = ["no.", "constraint", "value", "limit", *margins]
    return View(headers, [list(column) for column in zip(*rows, strict=True)])


def _cells(each: Check, least: Check) -> tuple[str, ...]:
    if each.value is None:
        return str(each.number), each.name, "not judged", "", "", ""
    value = f"{each.symbol} = {_shown(each.value, each.unit, 5)}"
    margins = (f"{100 * margin:.2f}".replace("-0.00", "0.00") for margin in (each.margin, least.margin))
    limit = "none" if each.limit is None else f"{each.relation} {_shown(each.limit, each.unit, 5)}"
    return str(each.number), each.name, value, limit, *margins


def _check_values(each: Check) -> dict[str, Any]:
    found = keyed(each, "number", "name", "judged", "margin")
    if each.judged:
        found |= keyed(each, "value", "relation", symbol=each.symbol, unit=each.unit)
    return in_degrees(found | (keyed(each, "limit", unit=each.unit) if each.limit is not None else {}))


def _contour_part(result: CamOptimum, contour: Contour) -> Document:
    """Region and corners at one height."""
    names = result.names
    title = f"blocking contour at {names['height']} = {quantity(contour.height, 'm')}"
    if result.kind == "oscillating":
        title += f", l2 = {quantity(result.chosen.length, 'm')}"
    facts = []
    for outline in contour.outlines:
        s, r = outline.start, outline.roller
        ends = [quantity(float(v), "m", 5) for v in (s.min(), s.max(), r.min(), r.max())]
        text = f"{names['start']} from {ends[0]} to {ends[1]}, r2 from {ends[2]} to {ends[3]}"
        text += f", area {outline.area * 1e6:.5g} mm^2"
        facts.append(Fact("region", text, keyed(outline, "area")))
    corners = [corner for outline in contour.outlines for corner in outline.corners]
    places = table(corners, Corner, "start[mm]", "roller[mm]", **names)
    between = [" and ".join(_named((key,)) for key in corner.numbers) for corner in corners]
    view = View([*places, "between"], [*([round(mm, 6) for mm in row] for row in places.values()), between])
    return Document(title, tuple(facts), (), view if corners else None)


def _contour_values(result: CamOptimum, contour: Contour) -> dict[str, Any]:
    names = result.names
    return {
        **keyed(contour, "height", "area", **names),
        "borders": [keyed(each, "start", "roller", "edge", **names) for each in contour.outlines],
        "corners": [keyed(corner, **names) for each in contour.outlines for corner in each.corners],
        "curves": [keyed(each, "number", "start", "roller", **names) for each in contour.curves],
    }
