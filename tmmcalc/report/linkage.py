"""Documents of the linkage stages: structure and kinematics."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from tmmcalc.linkage.columns import Column, columns, select
from tmmcalc.linkage.kinematics import solve_kinematics, step_study
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.outputs import Extreme, OutputSummary
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.structure import ROMAN, Structure
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number


def structure_document(result: Structure, title: str) -> Document:
    """Mobility, structural formula, and one row a group."""
    n, p = result.links, result.joints
    roman = ROMAN.get(result.class_number, str(result.class_number))
    facts = (
        Fact(
            "mobility",
            f"W = 3n - 2p = 3*{n} - 2*{p} = {result.mobility}",
            {"mobility": result.mobility, "links": n, "joints": p},
        ),
        Fact("structural formula", result.formula, {"formula": result.formula}),
        Fact("class of the mechanism", roman, {"class_number": result.class_number}),
    )
    groups = result.groups
    view = View(
        ["group", "class", "order", "inner joints", "attachment points", "source chain"],
        [
            [g.name for g in groups],
            [ROMAN.get(g.class_number, str(g.class_number)) for g in groups],
            [g.order for g in groups],
            [" ".join(g.inner) for g in groups],
            [" ".join(g.outer) for g in groups],
            [" ".join(map(str, g.source)) for g in groups],
        ],
    )
    return Document(title, facts, (), view)


def kinematics_document(
    result: Kinematics,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    dimensionless: bool = False,
    everything: bool = False,
    where: str = "",
) -> Document:
    """Summary and table of positions.

    ``patterns`` choose columns, ``rows`` positions by index; ``everything`` takes all columns (for csv, json,
    toml). Without either the columns that a reader looks at first come first and the terminal cuts the rest.
    """
    available = columns(result, dimensionless=dimensionless)
    chosen = select(available, patterns) if patterns else available if everything else _first(result, available)
    keep = range(len(result.labels)) if rows is None else rows
    view = View(
        ["i", *(c.header for c in chosen)],
        [[result.labels[k] for k in keep], *(_picked(c, keep) for c in chosen)],
    )
    more = f"choose with --columns, e.g. --columns 'phi,x_*'{f', or see {where}' if where else ''}"
    facts = tuple(_facts(result))
    return Document(title, facts, tuple(str(g) for g in result.grades), view, wide=not patterns, more=more)


def _picked(column: Column, rows: Sequence[int]) -> list[float]:
    values = column.make()
    return [float(values[k]) for k in rows]


def _first(result: Kinematics, available: list[Column]) -> list[Column]:
    """The input coordinate, outputs, links and the rest; no transfer functions, and not the given input link."""
    given = {f"{kind}_{result.structure.input_link}" for kind in ("angle", "omega", "eps")}
    shown = [c for c in available if not c.name.startswith("d") and c.name not in given]
    return sorted(shown, key=lambda c: (c.name != "phi", not c.name.startswith(("S_", "vS_", "aS_"))))


def _angle(result: Kinematics, x: float) -> tuple[str, dict[str, float]]:
    """An input coordinate for people and for programs."""
    if result.turns:
        name = f"angle_{result.structure.input_link}"
        return f"{name} = {number(math.degrees(x), 9)} deg", {f"{name}[deg]": math.degrees(x)}
    name = f"s_{result.input_joint}"
    return f"{name} = {number(x, 9)} m", {f"{name}[m]": x}


def _facts(result: Kinematics) -> list[Fact]:
    start, start_values = _angle(result, float(result.x[0]))
    unit = "rad/s" if result.turns else "m/s"
    speed = number(result.speed)
    rpm = f" ({number(result.speed * 30 / math.pi)} rpm)" if result.turns else ""
    facts = [
        Fact("structural formula", result.structure.formula, {"formula": result.structure.formula}),
        Fact("position 0", start, {f"start_{k}": v for k, v in start_values.items()}),
        Fact("speed of the input", f"{speed} {unit}{rpm}", {f"speed[{unit}]": result.speed}),
    ]
    signs = ", ".join(f"{name} {'+1' if sign > 0 else '-1'}" for name, sign in result.variants.items())
    facts.append(Fact("assembly variants", signs, {"variants": result.variants}))
    facts.append(_domain_fact(result))
    for summary in result.summaries:
        facts += _output_facts(result, summary)
    facts += [_quality_fact(result, k) for k in range(len(result.qualities))]
    e = result.error
    text = f"{e.position:.1e} position, {e.velocity:.1e} velocity, {e.acceleration:.1e} acceleration"
    error = {"error": {"position": e.position, "velocity": e.velocity, "acceleration": e.acceleration}}
    facts.append(Fact("estimated error (rel.)", text, error))
    return facts


def _domain_fact(result: Kinematics) -> Fact:
    domain = result.domain
    if domain.full:
        text = "the crank turns fully" if result.turns else "over the whole range"
        return Fact("assembles", text, {"full": True})
    factor, unit = (math.degrees(1.0), "deg") if result.turns else (1.0, "m")
    ranges = [[i.low * factor, i.high * factor] for i in domain.intervals]
    name = f"angle_{result.structure.input_link}" if result.turns else f"s_{result.input_joint}"
    text = " and ".join(f"{name} in [{number(a, 9)}, {number(b, 9)}] {unit}" for a, b in ranges)
    return Fact("assembles for", text, {"full": False, f"intervals[{unit}]": ranges})


def _output_facts(result: Kinematics, summary: OutputSummary) -> list[Fact]:
    unit, factor = ("deg", math.degrees(1.0)) if summary.angular else ("m", 1.0)
    rate = "rad/s" if summary.angular else "m/s"
    name = summary.name
    facts = []
    if summary.stroke is not None:
        stroke = summary.stroke * factor
        facts.append(Fact(f"stroke of {name}", f"{number(stroke, 9)} {unit}", {f"stroke_{name}[{unit}]": stroke}))
    if summary.dead_centres:
        places = [_angle(result, c.x) for c in summary.dead_centres]
        text = "; ".join(place for place, _ in places)
        values = [next(iter(v.values())) for _, v in places]
        facts.append(
            Fact(f"dead centres of {name}", text, {f"dead_centres_{name}[{'deg' if result.turns else 'm'}]": values})
        )
    if summary.working_angle is not None and summary.idle_angle is not None:
        working, idle = math.degrees(summary.working_angle), math.degrees(summary.idle_angle)
        ratio = summary.time_ratio
        text = f"working {number(working, 9)} deg, idle {number(idle, 9)} deg, K = {number(ratio or math.nan)}"
        values_ = {f"working_{name}[deg]": working, f"idle_{name}[deg]": idle, f"K_{name}": ratio}
        facts.append(Fact(f"strokes of {name}", text, values_))
    facts.append(_extreme_fact(result, f"velocity of {name}", f"vS_{name}", rate, summary.velocity))
    facts.append(_extreme_fact(result, f"acceleration of {name}", f"aS_{name}", f"{rate}^2", summary.acceleration))
    return facts


def _extreme_fact(result: Kinematics, label: str, key: str, unit: str, pair: tuple[Extreme, Extreme]) -> Fact:
    parts, values = [], {}
    for word, extreme in zip(("min", "max"), pair, strict=True):
        place, at = _angle(result, extreme.x)
        parts.append(f"{number(extreme.value)} {unit} at {place}")
        values[f"{key}_{word}[{unit}]"] = extreme.value
        values |= {f"{key}_{word}_at_{k}": v for k, v in at.items()}
    return Fact(label, "\n".join(parts), values)


def _quality_fact(result: Kinematics, k: int) -> Fact:
    quality = result.qualities[k]
    place, at = _angle(result, quality.transmission_at)
    transmission, pressure = math.degrees(quality.transmission), math.degrees(quality.pressure)
    text = f"transmission angle >= {number(transmission, 5)} deg ({place}), pressure angle <= {number(pressure, 5)} deg"
    values: dict[str, Any] = {
        f"transmission_min_{quality.group}[deg]": transmission,
        f"pressure_max_{quality.group}[deg]": pressure,
        f"amplification_max_{quality.group}": quality.amplification,
        **{f"transmission_min_{quality.group}_at_{key}": v for key, v in at.items()},
    }
    return Fact(f"group {quality.group}", text, values)


def comparison_document(mechanism: Mechanism, result: Kinematics, title: str) -> Document:
    """Each output's v and a by the result's method beside the exact ones; differences against the largest value.

    Relative differences refer to the maximum over the cycle: near a zero of v a pointwise one means nothing.
    """
    exact = solve_kinematics(mechanism, result.structure)
    headers: list[str] = ["i"]
    columns_: list[list[Any]] = [list(result.labels)]
    facts = [Fact("method", result.method.name, {"method": result.method.name})]
    wanted = [f"{kind}S_{name}" for name in result.outputs for kind in ("v", "a")]
    for theirs, ours in zip(select(columns(exact), wanted), select(columns(result), wanted), strict=True):
        a, b = theirs.make(), ours.make()
        difference, largest = b - a, float(abs(a).max())
        headers += [f"{theirs.name}[{theirs.unit}]", f"{ours.name}_{result.method.name}[{ours.unit}]", "diff[%]"]
        share = 100 * difference / largest if largest else difference
        columns_ += [a.tolist(), b.tolist(), share.tolist()]
        worst, mean = float(abs(difference).max()), float(abs(difference).mean())
        text = (
            f"max {number(worst)} {ours.unit} ({number(float(abs(share).max()), 3)} %), mean {number(mean)} {ours.unit}"
        )
        values = {f"difference_{ours.name}_max[{ours.unit}]": worst, f"difference_{ours.name}_mean[{ours.unit}]": mean}
        facts.append(Fact(f"difference of {ours.name}", text, values))
    return Document(title, tuple(facts), (), View(_distinct(headers), columns_))


def _distinct(headers: list[str]) -> list[str]:
    """Headers made unique by the name of the column before."""
    return [f"{headers[k - 2].partition('[')[0]}_{h}" if h == "diff[%]" else h for k, h in enumerate(headers)]


def study_document(mechanism: Mechanism, result: Kinematics, title: str, decimals: int | None) -> Document:
    """Error of central differences of the first output against their step, exact and rounded positions."""
    decimals = 6 if decimals is None else decimals
    rows = step_study(mechanism, result, decimals)
    unit, factor = ("deg", math.degrees(1.0)) if result.turns else ("m", 1.0)
    best = min(rows, key=lambda row: row.rounded.max_second)
    facts = (
        Fact("output", result.outputs[0], {"output": result.outputs[0]}),
        Fact("errors", "largest over the positions, of the transfer functions in units of l_1"),
        Fact(
            "best step for S''",
            f"{number(best.step * factor, 4)} {unit} with positions rounded to {decimals} decimals",
            {f"best_step[{unit}]": best.step * factor},
        ),
    )
    view = View(
        [f"step[{unit}]", f"dS[{decimals} decimals]", f"ddS[{decimals} decimals]", "dS[double]", "ddS[double]"],
        [
            [row.step * factor for row in rows],
            [row.rounded.max_first for row in rows],
            [row.rounded.max_second for row in rows],
            [row.double.max_first for row in rows],
            [row.double.max_second for row in rows],
        ],
    )
    return Document(title, facts, (), view)
