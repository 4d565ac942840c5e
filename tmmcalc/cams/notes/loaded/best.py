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
from tmmcalc.report.formula.digits import significant
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Paragraph, Table
from tmmcalc.report.telling import column_of, plainly

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
CONCAVE = 4
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


def sought(result: CamOptimum) -> Iterator[Block]:
    """The objective, the variables, what is examined; why another cam than the one asked for is shown."""
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
    step = tr("The sizes are sought in steps of {step} mm.", step=plainly(1e3 * result.step))
    yield Paragraph(f"{whole} {step}")
    if result.refused:
        yield Paragraph(
            tr(
                "As asked there is no such mechanism. What follows is that of the best option: {option}.",
                option=changed(result.options, result.shown),
            )
        )


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
    """How many step points there are, how many each constraint alone leaves, all that are as low."""
    yield Paragraph(
        tr(
            "{examined} points in whole steps were looked at. None with a smaller {size} keeps all constraints; with "
            "it {count} do.",
            examined=result.examined,
            size=f"${NAMES[result.names['height']]}$",
            count=len(result.start),
        )
    )
    if result.passed:
        left = "; ".join(f"{constraint_name(number)} – {count}" for number, count in result.passed)
        yield Paragraph(tr("Each constraint alone leaves of them: {left}.", left=left))


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
