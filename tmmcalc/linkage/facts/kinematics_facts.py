"""The facts of the kinematics stage: start, domain, strokes, extremes, transmission, error.

People read angles with five decimals and other numbers with seven digits; programs get every digit. A place is
given by the input coordinate under the name of its column, such as ``angle_1``.
"""

from __future__ import annotations

import math
from typing import Any

from tmmcalc.linkage.results import Extreme, GroupQuality, Kinematics, OutputSummary
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import angle, number


def input_column(result: Kinematics) -> str:
    """The column of the input coordinate itself, beside ``phi`` that counts it from position 0."""
    return f"angle_{result.structure.input_link}" if result.turns else f"s_{result.input_joint}"


def _place(result: Kinematics, *at: float) -> str:
    """One or several input coordinates for people, under the name of their column."""
    if result.turns:
        return f"{input_column(result)} = {' and '.join(angle(math.degrees(x)) for x in at)} deg"
    size = float(abs(result.x).max())
    return f"{input_column(result)} = {' and '.join(number(x, peak=size) for x in at)} m"


def _at(result: Kinematics, x: float) -> dict[str, float]:
    """An input coordinate for programs."""
    name = input_column(result)
    return {f"{name}[deg]": math.degrees(x)} if result.turns else {f"{name}[m]": x}


def facts_of(result: Kinematics) -> list[Fact]:
    """All facts of the summary, in the order of a course project."""
    start = float(result.x[0])
    unit = "rad/s" if result.turns else "m/s"
    rpm = f" ({number(result.speed * 30 / math.pi)} rpm)" if result.turns else ""
    signs = ", ".join(
        f"{name} assembly {sign}" if name in result.branches else f"{name} {'+1' if sign > 0 else '-1'}"
        for name, sign in result.variants.items()
    )
    formula = result.structure.formula
    facts = [
        Fact("structural formula", formula, {"formula": formula}),
        Fact("position 0", _place(result, start), {f"start_{k}": v for k, v in _at(result, start).items()}),
        Fact("speed of the input", f"{number(result.speed)} {unit}{rpm}", {f"speed[{unit}]": result.speed}),
    ]
    if result.acceleration:
        text = f"{number(result.acceleration)} {unit}^2"
        facts.append(Fact("its acceleration", text, {f"acceleration[{unit}^2]": result.acceleration}))
    facts.append(Fact("assembly variants", signs, {"variants": result.variants}))
    facts.append(_domain_fact(result))
    facts += _method_facts(result)
    for summary in result.summaries:
        facts += _output_facts(result, summary)
    facts += [_quality_fact(result, quality) for quality in result.qualities]
    return [*facts, _error_fact(result)]


def _method_facts(result: Kinematics) -> list[Fact]:
    """The method of the table, if it is not the default; the summary is exact whatever the method."""
    method = result.method
    if method.name == "closed":
        return []
    text: str = method.name
    if method.step is not None:
        text += f", step {angle(math.degrees(method.step))} deg" if result.turns else f", step {number(method.step)} m"
    if method.decimals is not None:
        text += f", positions rounded to {method.decimals} decimals"
    return [Fact("method of the table", f"{text}\n(dead centres and extremes are exact)", {"method": method.name})]


def _error_fact(result: Kinematics) -> Fact:
    """Estimates are orders of magnitude: one digit is enough for people."""
    e = result.error
    text = f"position {e.position:.0e}, velocity {e.velocity:.0e}, acceleration {e.acceleration:.0e}"
    values = {"error": {"position": e.position, "velocity": e.velocity, "acceleration": e.acceleration}}
    return Fact("error estimate", text, values)


def unit_fact(result: Kinematics) -> Fact:
    """The units of dimensionless results."""
    length = result.crank_length or math.nan
    text = f"l_1 = {number(length)} m, omega_1 = {number(result.speed)} rad/s"
    return Fact("units of the table", text, {"l_1[m]": length, "omega_1[rad/s]": result.speed})


def _domain_fact(result: Kinematics) -> Fact:
    domain = result.domain
    if domain.full:
        text = "everywhere: the crank turns fully" if result.turns else "wherever the slider stands"
        return Fact("assembles", text, {"assembles_everywhere": True})
    factor, unit = (math.degrees(1.0), "deg") if result.turns else (1.0, "m")
    write = angle if result.turns else number
    ranges, texts = [], []
    for interval in domain.intervals:
        ends = {limit.x for limit in interval.limits}
        places = {"from": interval.low, "to": interval.high}
        limits = {key: x * factor for key, x in places.items() if x in ends}
        low, high = (write(limits[key]) if key in limits else "..." for key in places)
        ranges.append(limits)
        texts.append(f"[{low}, {high}]")
    values = {"assembles_everywhere": False, f"assembles_for[{unit}]": ranges}
    return Fact("assembles", f"for {input_column(result)} in {' and '.join(texts)} {unit}", values)


def _output_facts(result: Kinematics, summary: OutputSummary) -> list[Fact]:
    unit, factor = ("deg", math.degrees(1.0)) if summary.angular else ("m", 1.0)
    rate = "rad/s" if summary.angular else "m/s"
    name, called = summary.name, _called(summary)
    facts = []
    if summary.stroke is not None:
        stroke = summary.stroke * factor
        text = angle(stroke) if summary.angular else number(stroke)
        facts.append(Fact(f"stroke of {called}", f"{text} {unit}", {f"stroke_{name}[{unit}]": stroke}))
    if summary.dead_centres:
        at = [centre.x for centre in summary.dead_centres]
        values = [value for x in at for value in _at(result, x).values()]
        key = f"dead_centres_{name}[{'deg' if result.turns else 'm'}]"
        facts.append(Fact(f"dead centres of {called}", _place(result, *at), {key: values}))
    facts += _stroke_facts(summary)
    facts.append(_extreme_fact(result, f"velocity of {called}", f"vS_{name}", rate, summary.velocity))
    facts.append(_extreme_fact(result, f"acceleration of {called}", f"aS_{name}", f"{rate}^2", summary.acceleration))
    return facts


def _called(summary: OutputSummary) -> str:
    """The output for people: ``D``, ``link 3``."""
    return f"link {summary.name}" if summary.name.isdigit() else summary.name


def _stroke_facts(summary: OutputSummary) -> list[Fact]:
    """Working and idle stroke in crank angle, and their ratio, where there are two dead centres."""
    if summary.working_angle is None or summary.idle_angle is None:
        return []
    name, called, ratio = summary.name, _called(summary), summary.time_ratio
    working, idle = math.degrees(summary.working_angle), math.degrees(summary.idle_angle)
    facts = [
        Fact(f"working stroke of {called}", f"{angle(working)} deg of the crank", {f"working_{name}[deg]": working}),
        Fact(f"idle stroke of {called}", f"{angle(idle)} deg of the crank", {f"idle_{name}[deg]": idle}),
    ]
    if ratio is not None:
        facts.append(Fact(f"time ratio K of {called}", number(ratio), {f"K_{name}": ratio}))
    return facts


def _extreme_fact(result: Kinematics, label: str, key: str, unit: str, pair: tuple[Extreme, Extreme]) -> Fact:
    peak = max(abs(extreme.value) for extreme in pair)
    if pair[0] == pair[1]:
        value = pair[0].value
        return Fact(label, f"{number(value)} {unit} everywhere", {f"{key}_{w}[{unit}]": value for w in ("min", "max")})
    parts, values = [], {}
    for word, extreme in zip(("min", "max"), pair, strict=True):
        parts.append(f"{word} {number(extreme.value, peak=peak)} {unit} at {_place(result, extreme.x)}")
        values[f"{key}_{word}[{unit}]"] = extreme.value
        values |= {f"{key}_{word}_at_{k}": v for k, v in _at(result, extreme.x).items()}
    return Fact(label, "\n".join(parts), values)


def _quality_fact(result: Kinematics, quality: GroupQuality) -> Fact:
    group = quality.group
    if quality.transmission is None or quality.pressure is None:
        return _regularity_fact(result, quality)
    transmission, pressure = math.degrees(quality.transmission), math.degrees(quality.pressure)
    values: dict[str, Any] = {
        f"transmission_min_{group}[deg]": transmission,
        f"pressure_max_{group}[deg]": pressure,
        f"amplification_max_{group}": quality.amplification,
    }
    if quality.regularity_at is not None:
        values |= {f"amplification_max_{group}_at_{k}": v for k, v in _at(result, quality.regularity_at).items()}
    if quality.transmission_at is None:
        text = f"angle {number(transmission, 5)} deg everywhere (pressure angle {number(pressure, 5)} deg)"
        return Fact(f"transmission of {group}", text, values)
    values |= {f"transmission_min_{group}_at_{k}": v for k, v in _at(result, quality.transmission_at).items()}
    text = f"min angle {number(transmission, 5)} deg at {_place(result, quality.transmission_at)}"
    return Fact(f"transmission of {group}", f"{text}\n(max pressure angle {number(pressure, 5)} deg)", values)


def _regularity_fact(result: Kinematics, quality: GroupQuality) -> Fact:
    """How near a higher group comes to a singular position."""
    values: dict[str, Any] = {f"amplification_max_{quality.group}": quality.amplification}
    text = f"{number(quality.regularity, 4)} everywhere"
    if quality.regularity_at is not None:
        text = f"min {number(quality.regularity, 4)} at {_place(result, quality.regularity_at)}"
        values |= {
            f"amplification_max_{quality.group}_at_{k}": v for k, v in _at(result, quality.regularity_at).items()
        }
    return Fact(f"regularity of {quality.group}", f"{text} (1 the best, 0 singular)", values)
