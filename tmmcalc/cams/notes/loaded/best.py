"""The best sizes: what is sought, the constraints with both sides, which of them bind, what looser ones buy."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import degrees
from typing import NamedTuple

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.notes.laws import named_title
from tmmcalc.cams.notes.lexicon import of_follower
from tmmcalc.cams.notes.loaded.margins import concave_margin_said
from tmmcalc.cams.optimum.results import CamOptimum, Check, Option, Relaxation
from tmmcalc.cams.pictures.wording import constraint_name
from tmmcalc.cams.strength.formulas import BAD
from tmmcalc.cams.task import CamTask, Optimum
from tmmcalc.report.formula.digits import significant
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Paragraph, Table
from tmmcalc.report.telling import column_of, plainly, spaced

FIGURES, PERCENT = 5, 100
SAME = 1e-9  # of a size: what changes nothing
CONDITIONS = {  # by the number of the constraint, in table 5.5 and beyond
    1: "K_min >= K_1",
    2: "D <= 1",
    3: "r_2 <= rho_2 - r_m",
    4: "r_2 >= r_i - rho_1",
    5: "r_2 >= r_2^{*}",
    6: "r_2 <= R_0 - r_1^{*}",
    7: "sigma_F <= sigma_FP",
    8: "p_g <= p_gP",
    9: "sigma_H <= sigma_HP",
    10: "theta_max <= theta_P",
    11: "r_max <= l_0 - r_A",
}
CONCAVE, CURVED = 4, (3, 4)
FEW = 5  # step points of the table of the best
FLAT = {3: "S_0 >= r_m - F_min", 6: "S_0 >= r_1^{*}"}
UNITS = {"m": ("mm", 1e3), "Pa": ("MPa", 1e-6), "-": ("", 1.0), "rad": ("°", degrees(1.0))}
NAMES = {"H2": "H_2", "S0": "S_0", "l": "l", "l0": "l_0", "R0": "R_0", "l2": "l_2"}


class Size(NamedTuple):
    """A size that is sought, in three mechanisms."""

    name: str
    meaning: str
    given: float | None  # [m] of the synthesis
    steps: float  # [m]
    least: float  # [m]


def sought(result: CamOptimum, task: CamTask, sizes: Sequence[Size]) -> Iterator[Block]:
    """The objective, the variables with their bounds, what is examined; why another cam than the one asked is shown."""
    if result.kind == "oscillating":
        text = tr(
            "Sought are the distance $l_0$ of the axes, the length $l_2$ of the rocker, the radius $R_0$ of the base "
            "circle and the radius $r_2$ of the roller for which $l_0$ is least within the constraints."
        )
    elif result.kind == "flat":
        text = tr(
            "Sought are the start distance $S_0$ and the length of the guide for which the height $H_2$ of its upper "
            "edge above the axis of the cam is least within the constraints."
        )
    else:
        text = tr(
            "Sought are the start distance $S_0$ and the radius $r_2$ of the roller for which the height $H_2$ of the "
            "upper edge of the guide above the axis of the cam is least within the constraints."
        )
    yield Paragraph(text)
    whole = tr("The whole turn is examined.") if result.phases == "turn" else tr("The rise alone is examined.")
    yield Paragraph(f"{whole} {tr('Table {tab:cam_sought} has the bounds within which the sizes are sought.')}")
    ends = _bounds(result, task)
    rows = tuple((each.meaning, f"${each.name}$", *ends[each.name]) for each in sizes if each.name in ends)
    head = (tr("Size, mm"), tr("Designation"), tr("From"), tr("To"), tr("Step"))
    yield Table(tr("Bounds of the search"), head, rows, "cam_sought")
    if result.refused:
        yield Paragraph(
            tr(
                "As asked there is no such mechanism. What follows is that of the best option: {option}.",
                option=changed(result.options, result.shown),
            )
        )


def _bounds(result: CamOptimum, task: CamTask) -> dict[str, tuple[str, str, str]]:
    """From where, up to where and in which steps each size is sought."""
    step, asked = _mm(result.step), task.optimum or Optimum()
    if result.kind == "oscillating":
        angle = tr("by the pressure angle")
        rocker = (step, "$l_0/cos(theta_P)$") if asked.rocker_lengths is None else _ends(asked.rocker_lengths)
        return {
            "l_0": (*_ends(asked.centre_distances), step),
            "l_2": (*rocker, step),
            "R_0": (angle, angle, step),
            "r_2": (step, "$R_0 - r_1^{*}$", step),
        }
    far = "$H_2 - h - Delta_g$" if task.guide.gap else "$H_2 - h$"
    if result.flat is not None:
        return {"H_2": ("–", "–", _mm(result.height_step)), "S_0": (_mm(result.flat.least_start), far, step)}
    heights = (*_ends(asked.heights), _mm(result.height_step))
    return {"H_2": heights, "S_0": (step, far, step), "r_2": (step, "$R_0$", step)}


def _ends(given: tuple[float, float] | None) -> tuple[str, str]:
    return ("–", "–") if given is None else (_mm(given[0]), _mm(given[1]))


def changed(options: Sequence[Option], changes: Sequence[str]) -> str:
    """What differs in an option, in words."""
    found = next((each for each in options if each.changes == tuple(changes)), None)
    if found is None:
        return tr("as asked")
    told = [tr("law: {law}", law=law_name(found.law))]
    if found.safety is not None:
        told.append(tr("safety $K_1$ = {value}", value=plainly(found.safety)))
    if found.allowed is not None:
        told.append(f"$sigma_HP$ = {plainly(1e-6 * found.allowed)} {tr_unit('MPa')}")
    return ", ".join(told)


def law_name(name: str) -> str:
    """The law of rise and return, or both where they differ."""
    return ", ".join(map(named_title, name.split(", ")))


def sizes_of(result: CamOptimum, follower: Follower, height: float | None, length: float | None) -> list[Size]:
    """The sizes of the synthesis, in whole steps, of any sizes; ``height`` H2 and ``length`` l of the former."""
    chosen, least = result.chosen, result.least
    if result.kind == "oscillating":
        rows = [
            Size("l_0", tr("distance of the axes of cam and rocker"), follower.centres, chosen.height, least.height),
            Size("l_2", tr("length of the rocker"), follower.rocker, chosen.length, least.length),
            Size("R_0", tr("radius of the base circle of the pitch curve"), follower.base, chosen.start, least.start),
        ]
    else:
        said = tr("height of the upper edge of the guide above the axis of the cam")
        start = of_follower(follower)["S_0"].meaning
        rows = [
            Size("H_2", said, height, chosen.height, least.height),
            Size("S_0", start, follower.start, chosen.start, least.start),
            Size("l", tr("length of the guide"), length, chosen.length, least.length),
        ]
    if result.kind != "flat":
        rows.append(Size("r_2", tr("radius of the roller"), follower.roller, chosen.roller, least.roller))
    return rows


def sizes_table(sizes: Sequence[Size]) -> Iterator[Block]:
    """What the search found beside the sizes of the synthesis."""
    rows = [
        (
            each.meaning,
            f"${each.name}$",
            "–" if each.given is None else _mm(each.given),
            _mm(each.steps),
            _mm(each.least),
        )
        for each in sizes
    ]
    head = (tr("Size, mm"), tr("Designation"), tr("By the synthesis"), tr("In whole steps"), tr("Of any sizes"))
    yield Paragraph(tr("Table {tab:cam_best} compares the sizes that were found with those of the synthesis."))
    yield Table(tr("Sizes of the best mechanism"), head, tuple(rows), "cam_best")


def _mm(value: float) -> str:
    return spelt(significant(1e3 * value, 6))


def constraints(result: CamOptimum, *, concave: bool) -> Iterator[Block]:
    """Both sides of each constraint in whole steps, the margins of both mechanisms, and which constraints bind.

    ``concave``: parts of the profile may be concave.
    """
    least = {each.number: each for each in result.least.checks}
    rows = [_row(result, each, least[each.number]) for each in result.chosen.checks if each.judged]
    head = (
        tr("Number"),
        tr("Design constraint"),
        tr("Condition"),
        tr("In whole steps"),
        tr("Margin of the limit, %"),
        tr("Margin of any sizes, %"),
    )
    yield Paragraph(
        tr(
            "Table {tab:cam_constraints} has both sides of every constraint for the sizes in whole steps, found over "
            "the turn by the formulas of the parts before. The margin is what is left of the limit; a constraint "
            "without a margin binds."
        )
    )
    if any(each.number == CONCAVE for each in result.chosen.checks if each.judged):
        yield Paragraph(concave_margin_said(smooth=not concave))
    yield Table(tr("Constraints of the best mechanism"), head, tuple(rows), "cam_constraints")
    active = [constraint_name(number) for number in result.least.active]
    if active:
        yield Paragraph(tr("The mechanism of any sizes is held by: {names}.", names=", ".join(active)))
    worst = result.chosen.worst
    yield Paragraph(
        tr(
            "In whole steps the least margin, {margin} %, is that of the constraint “{name}”.",
            margin=plainly(PERCENT * worst.margin, 4),
            name=constraint_name(worst.number),
        )
    )
    left_out = [constraint_name(each.number) for each in result.chosen.checks if not each.judged and each.number > 1]
    if left_out:
        yield Paragraph(tr("Not judged for want of data: {names}.", names=", ".join(left_out)))


def _row(result: CamOptimum, each: Check, least: Check) -> tuple[str, ...]:
    condition = FLAT.get(each.number) if result.kind == "flat" else None
    condition = condition or CONDITIONS[each.number]
    unit, factor = UNITS[each.unit]
    assert each.value is not None
    if each.limit is None:
        numbers = tr("no limit")
    else:
        sides = [significant(factor * side, FIGURES) for side in (each.value, each.limit)]
        broken = {"<=": ">", ">=": "<"}[each.relation]
        sign = each.relation if each.margin >= -SAME else broken
        gap = "" if unit in ("", "°") else " "
        numbers = f"${sides[0]} {sign} {sides[1]}${gap}{tr_unit(unit)}"
    margins = (column_of([round(PERCENT * margin, 6)], 4)[0] for margin in (each.margin, least.margin))
    return str(each.number), constraint_name(each.number), f"${condition}$", numbers, *margins


def search(result: CamOptimum) -> Iterator[Block]:
    """What each step of the search left; the best of what keeps all constraints, and why the first is taken."""
    if result.kind == "oscillating":
        yield Paragraph(
            tr(
                "The least $l_0$ of any sizes is found first, {least} mm; whole steps are tried from just below it "
                "upwards. At each the pressure angle leaves points $l_2$, $R_0$; with every radius of the roller that "
                "suits them they are judged by all constraints.",
                least=_mm(result.least.height),
            )
        )
    elif result.flat is not None:
        yield Paragraph(
            tr(
                "{examined} start distances in whole steps were looked at. The length of the guide by each constraint "
                "has a closed form, which gives every $S_0$ a range of $H_2$. The heights are tried upwards.",
                examined=result.examined,
            )
        )
    else:
        yield from _left(result)
    yield from _course(result)
    yield from _few(result)


def _left(result: CamOptimum) -> Iterator[Block]:
    """How many step points there are, what the curvature leaves of them, and each other constraint of these."""
    left = dict(result.passed)
    curved = min(left[number] for number in CURVED)
    yield Paragraph(
        tr(
            "{examined} points $S_0$, $r_2$ in whole steps were looked at. The limits of curvature leave {curved} of "
            "them; table {tab} shows how many of these each of the other constraints, taken alone, leaves at some "
            "height. All constraints but that of the slip of the roller leave {suited} points, each with a range of "
            "$H_2$ in closed form. The heights are tried upwards.",
            examined=result.examined,
            curved=curved,
            tab="{tab:cam_left}",
            suited=result.examined - result.excluded,
        )
    )
    rows = tuple(
        (str(number), constraint_name(number), str(count)) for number, count in left.items() if number not in CURVED
    )
    yield Table(
        tr("What each constraint leaves"), (tr("Number"), tr("Design constraint"), tr("Points left")), rows, "cam_left"
    )


def _course(result: CamOptimum) -> Iterator[Block]:
    """The heights that were tried, the last and others before it at growing distances."""
    last, height = result.course[-1], f"${NAMES[result.names['height']]}$"
    if len(result.course) == 1:
        tried = {"size": height, "value": _mm(last.height), "judged": last.judged, "kept": last.kept}
        if result.kind == "oscillating":
            said = tr(
                "The first distance that was tried is {size} = {value} mm. Points that it suits: {judged}; of these "
                "keep all constraints: {kept}.",
                **tried,
            )
        else:
            said = tr(
                "The first height that was tried is {size} = {value} mm. Points that it suits: {judged}; of these "
                "keep all constraints: {kept}.",
                **tried,
            )
        yield Paragraph(said)
        return
    yield Paragraph(
        tr(
            "Table {tab:cam_course} has the course of the search up to the first {size} at which points keep all "
            "constraints, with the least margin of the best point at each.",
            size=height,
        )
    )
    levels = spaced(result.course[::-1])[::-1]
    columns = {f"{height}, {tr_unit('mm')}": [_mm(each.height) for each in levels]}
    if result.kind == "oscillating":
        columns[tr("Points $l_2$, $R_0$")] = [str(each.points) for each in levels]
    columns |= {
        tr("Points judged"): [str(each.judged) for each in levels],
        tr("Points that keep all constraints"): [str(each.kept) for each in levels],
        tr("Least margin, %"): [_margin(each.margin) for each in levels],
        tr("Its constraint"): ["–" if each.number is None else constraint_name(each.number) for each in levels],
    }
    rows = tuple(zip(*columns.values(), strict=True))
    yield Table(tr("Course of the search"), tuple(columns), rows, "cam_course")


def _margin(value: float | None) -> str:
    """A margin in percent; none where nothing was judged, or the mechanism does not work at all."""
    return "–" if value is None or value <= BAD else plainly(PERCENT * value, 4)


def _few(result: CamOptimum) -> Iterator[Block]:
    """The best step points at the least height."""
    count = len(result.start)
    if count == 1:
        yield Paragraph(tr("There is one such point, which is taken."))
        return
    said = tr("Table {tab:cam_few} has these points, those of the largest least margin first.")
    if count > FEW:
        said = tr("Table {tab:cam_few} has the best of these points, those of the largest least margin first.")
    yield Paragraph(f"{said} {tr('The first is taken, as it stays farthest from all limits.')}")
    sizes = {name: getattr(result, name) for name in ("length", "start", "roller")}
    if result.kind == "flat":
        del sizes["roller"]
    heads = {"length": "$l_2$", "start": f"${NAMES[result.names['start']]}$", "roller": "$r_2$"}
    columns = {tr("Number"): [str(k) for k in range(1, min(count, FEW) + 1)]}
    for name, values in sizes.items():
        if values is not None:
            columns[f"{heads[name]}, {tr_unit('mm')}"] = [_mm(value) for value in values[:FEW].tolist()]
    columns[tr("Least margin, %")] = [_margin(value) for value in result.margin[:FEW].tolist()]
    rows = tuple(zip(*columns.values(), strict=True))
    yield Table(tr("Best points in whole steps"), tuple(columns), rows, "cam_few")


def relaxations(result: CamOptimum) -> Iterator[Block]:
    """What a looser limit of a binding constraint buys."""
    if not result.relaxations:
        return
    yield Paragraph(
        tr(
            "Table {tab:cam_relaxed} shows by how much a looser limit of a binding constraint makes {size} less: by "
            "one percent, and to the next preferred number.",
            size=f"${NAMES[result.names['height']]}$",
        )
    )
    head = (tr("Design constraint"), tr("Limit"), tr("From"), tr("To"), tr("Gain, mm"))
    rows = tuple(_relaxed(each) for each in result.relaxations)
    yield Table(tr("Looser limits"), head, rows, "cam_relaxed")


def _relaxed(each: Relaxation) -> tuple[str, ...]:
    unit, factor = UNITS[each.unit]
    ends = [spelt(significant(factor * value, FIGURES)) for value in (each.before, each.after)]
    gain = spelt(significant(round(1e3 * each.gain, 5) + 0.0, 3))
    limit = f"{_limit_name(each.key)}, {tr_unit(unit)}".removesuffix(", ")
    return constraint_name(each.number), limit, *ends, gain


def _limit_name(key: str) -> str:
    return {
        "roller_friction": tr("coefficient of sliding friction of the roller on the cam"),
        "convex_radius": tr("least radius of convex parts that can be made"),
        "concave_radius": tr("least radius of the tool for concave parts"),
        "pin_pressure": tr("permissible pressure on the pin"),
        "roller_ratio": tr("least radius of the roller over that of the pin"),
        "bending": tr("permissible bending stress"),
        "deflection": tr("permissible deflection of the camshaft"),
        "guide_pressure": tr("permissible pressure in the guide"),
        "contact": tr("permissible contact stress"),
        "pressure_angle": tr("permissible pressure angle of the cam"),
        "pressure_angle_return": tr("permissible pressure angle of the cam on the return"),
        "pivot_radius": tr("radius of the pivot"),
    }[key]


def game(result: CamOptimum) -> Iterator[Block]:
    """The options of the design game with their own best mechanisms, the best first."""
    if not result.options:
        return
    solved = sorted((each for each in result.options if not each.refused), key=lambda each: each.least)
    yield Heading(tr("Comparison of options"), 3)
    yield Paragraph(
        tr(
            "Other laws, springs, materials and rollers are compared in table {tab:cam_options}, the best first: the "
            "least {size} of any sizes, the sizes in whole steps, and which constraints bind.",
            size=f"${NAMES[result.names['height']]}$",
        )
    )
    columns = _option_columns(result, solved)
    rows = tuple(zip(*columns.values(), strict=True))
    yield Table(tr("Options with their best mechanisms"), tuple(columns), rows, "cam_options")
    refused = [each for each in result.options if each.refused and each.changes]
    if refused:
        names = "; ".join(changed(result.options, each.changes) for each in refused)
        yield Paragraph(tr("No sizes keep the constraints with: {names}.", names=names))


def _option_columns(result: CamOptimum, solved: Sequence[Option]) -> Mapping[str, list[str]]:
    """What the options differ in, their sizes and loads."""
    height, start = (f"${NAMES[result.names[key]]}$, {tr_unit('mm')}" for key in ("height", "start"))
    least = f"${NAMES[result.names['height']].replace('_', '_{')},min}}$, {tr_unit('mm')}"
    columns = {tr("Law"): [law_name(each.law) for each in solved]}
    for head, values in (
        ("$K_1$", [each.safety for each in solved]),
        (f"$sigma_HP$, {tr_unit('MPa')}", [None if each.allowed is None else 1e-6 * each.allowed for each in solved]),
        ("$alpha_0$", [each.ratio for each in solved]),
    ):
        if len(set(values)) > 1:
            columns[head] = ["–" if value is None else plainly(value) for value in values]
    columns[least] = [_mm(each.least) for each in solved]
    columns[height] = [_mm(each.height) for each in solved]
    columns[start] = [_mm(each.start) for each in solved]
    if result.kind == "oscillating":
        columns[f"$l_2$, {tr_unit('mm')}"] = [_mm(each.length or 0.0) for each in solved]
    if result.kind != "flat":
        columns[f"$r_2$, {tr_unit('mm')}"] = [_mm(each.roller) for each in solved]
    columns[tr("binding")] = [", ".join(map(str, each.active)) or "–" for each in solved]
    columns[f"$R_max$, {tr_unit('N')}"] = [plainly(each.contact) for each in solved]
    return columns
