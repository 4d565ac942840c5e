"""The facts of the kinematics stage: start, domain, strokes, extremes, transmission, error.

People read angles with five decimals and other numbers with seven digits; programs get every digit. A place is
given by the input coordinate under the name of its column, such as ``angle_1``.
"""

from __future__ import annotations

import math

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, keyed, quantity_of
from tmmcalc.linkage.columns import OMEGA_1
from tmmcalc.linkage.facts.structure import named_links
from tmmcalc.linkage.results import Extreme, GroupQuality, Kinematics, OutputSummary
from tmmcalc.report.document import Fact
from tmmcalc.report.errors import digit_facts
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


def _key(result: Kinematics) -> Quantity:
    """What the input coordinate is for programs."""
    return quantity_of(Kinematics, "x", input=input_column(result), unit="deg" if result.turns else "m")


def _at(result: Kinematics, x: float, of: str) -> dict[str, float]:
    """An input coordinate for programs; ``of`` is what its key begins with."""
    return {f"{of}_{_key(result).key}": math.degrees(x) if result.turns else x}


def facts_of(result: Kinematics) -> list[Fact]:
    """All facts of the summary, in the order of a course project."""
    start = float(result.x[0])
    unit = "rad" if result.turns else "m"
    rpm = f" ({number(result.speed * 30 / math.pi)} rpm)" if result.turns else ""
    signs = ", ".join(
        f"{name} assembly {sign}" if name in result.branches else f"{name} {'+1' if sign > 0 else '-1'}"
        for name, sign in result.variants.items()
    )
    formula = result.structure.formula
    facts = [
        Fact("structural formula", formula, keyed(result.structure, "formula")),
        *named_links(result.structure),
        *_frame(result),
        Fact("position 0", _place(result, start), _at(result, start, "start")),
        Fact("speed of the input", f"{number(result.speed)} {unit}/s{rpm}", keyed(result, "speed", unit=unit)),
    ]
    if result.acceleration:
        text = f"{number(result.acceleration)} {unit}/s^2"
        facts.append(Fact("its acceleration", text, keyed(result, "acceleration", unit=unit)))
    facts.append(Fact("assembly variants", signs, keyed(result, "variants")))
    facts.append(_domain_fact(result))
    facts += _method_facts(result)
    for summary in result.summaries:
        facts += _output_facts(result, summary)
    facts += [_quality_fact(result, quality) for quality in result.qualities]
    digit = result.error.last_digit
    return [*facts, _error_fact(result), *digit_facts({} if digit is None else keyed(digit))]


def _frame(result: Kinematics) -> list[Fact]:
    """The fixed points, which no column of the table has."""
    if not result.frame_points:
        return []
    size = max(abs(coordinate) for at in result.frame_points.values() for coordinate in at)
    places = (
        f"{name} ({', '.join(number(coordinate, peak=size) for coordinate in at)})"
        for name, at in result.frame_points.items()
    )
    return [Fact("fixed points", f"{', '.join(places)} m", keyed(result, "frame_points"))]


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
    return [Fact("method of the table", f"{text}\n(dead centres and extremes are exact)", keyed(method, "name"))]


def _error_fact(result: Kinematics) -> Fact:
    """Estimates are orders of magnitude: one digit is enough for people."""
    e = result.error
    text = f"position {e.position:.0e}, velocity {e.velocity:.0e}, acceleration {e.acceleration:.0e}"
    return Fact("error estimate", text, {"error": keyed(e, "position", "velocity", "acceleration")})


def unit_fact(result: Kinematics) -> Fact:
    """The units of dimensionless results."""
    length = result.crank_length or math.nan
    text = f"l_1 = {number(length)} m, omega_1 = {number(result.speed)} rad/s"
    return Fact("units of the table", text, keyed(result, "crank_length") | {OMEGA_1.key: result.speed})


def _domain_fact(result: Kinematics) -> Fact:
    domain = result.domain
    if domain.full:
        text = "everywhere: the crank turns fully" if result.turns else "wherever the slider stands"
        return Fact("assembles", text, keyed(domain, "full"))
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
    values = keyed(domain, "full") | {quantity_of(Kinematics, "domain", unit=unit).key: ranges}
    return Fact("assembles", f"for {input_column(result)} in {' and '.join(texts)} {unit}", values)


def _output_facts(result: Kinematics, summary: OutputSummary) -> list[Fact]:
    unit = "rad" if summary.angular else "m"
    places = {"output": summary.name, "unit": unit}
    called = _called(summary)
    facts = []
    if summary.stroke is not None:
        text = f"{angle(math.degrees(summary.stroke))} deg" if summary.angular else f"{number(summary.stroke)} m"
        values = keyed(summary, "stroke[deg]" if summary.angular else "stroke", **places)
        facts.append(Fact(f"stroke of {called}", text, values))
    if summary.dead_centres:
        at = [centre.x for centre in summary.dead_centres]
        told = quantity_of(OutputSummary, "dead_centres", output=summary.name, per=_key(result).unit)
        shown = [math.degrees(x) if result.turns else x for x in at]
        facts.append(Fact(f"dead centres of {called}", _place(result, *at), {told.key: shown}))
    facts += _stroke_facts(summary)
    velocity, acceleration = (quantity_of(OutputSummary, name, **places) for name in ("velocity", "acceleration"))
    facts.append(_extreme_fact(result, Phrase("velocity of {output}", output=called), velocity, summary.velocity))
    label = Phrase("acceleration of {output}", output=called)
    facts.append(_extreme_fact(result, label, acceleration, summary.acceleration))
    return facts


def _called(summary: OutputSummary) -> str:
    """The output for people: ``D``, ``link 3``."""
    return Phrase("link {number}", number=summary.name) if summary.name.isdigit() else summary.name


def _stroke_facts(summary: OutputSummary) -> list[Fact]:
    """Working and idle stroke in crank angle, and their ratio, where there are two dead centres."""
    if summary.working_angle is None or summary.idle_angle is None:
        return []
    called = _called(summary)
    facts = [
        Fact(
            f"{name} stroke of {called}",
            f"{angle(math.degrees(part))} deg of the crank",
            keyed(summary, f"{name}_angle[deg]", output=summary.name),
        )
        for name, part in (("working", summary.working_angle), ("idle", summary.idle_angle))
    ]
    if summary.time_ratio is not None:
        values = keyed(summary, "time_ratio", output=summary.name)
        facts.append(Fact(f"time ratio K of {called}", number(summary.time_ratio), values))
    return facts


def _extreme_fact(result: Kinematics, label: str, told: Quantity, pair: tuple[Extreme, Extreme]) -> Fact:
    peak = max(abs(extreme.value) for extreme in pair)
    if pair[0] == pair[1]:
        value = pair[0].value
        values = {told.marked(word).key: value for word in ("min", "max")}
        return Fact(label, f"{number(value)} {told.unit} everywhere", values)
    parts, values = [], {}
    for word, extreme in zip(("min", "max"), pair, strict=True):
        own = told.marked(word)
        parts.append(f"{word} {number(extreme.value, peak=peak)} {told.unit} at {_place(result, extreme.x)}")
        values |= {own.key: extreme.value} | _at(result, extreme.x, f"{own.name}_at")
    return Fact(label, "\n".join(parts), values)


def _quality_fact(result: Kinematics, quality: GroupQuality) -> Fact:
    group = quality.group
    if quality.transmission is None or quality.pressure is None:
        return _regularity_fact(result, quality)
    transmission, pressure = math.degrees(quality.transmission), math.degrees(quality.pressure)
    values = keyed(quality, "transmission[deg]", "pressure[deg]", "amplification", group=group)
    values |= _quality_at(result, quality, "amplification", quality.regularity_at)
    values |= _quality_at(result, quality, "transmission", quality.transmission_at)
    if quality.transmission_at is None:
        text = f"angle {number(transmission, 5)} deg everywhere (pressure angle {number(pressure, 5)} deg)"
        return Fact(f"transmission of {group}", text, values)
    text = f"min angle {number(transmission, 5)} deg at {_place(result, quality.transmission_at)}"
    return Fact(f"transmission of {group}", f"{text}\n(max pressure angle {number(pressure, 5)} deg)", values)


def _quality_at(result: Kinematics, quality: GroupQuality, name: str, x: float | None) -> dict[str, float]:
    """Where a measure of a group is the worst; nothing where it is the same everywhere."""
    if x is None:
        return {}
    return _at(result, x, f"{quantity_of(GroupQuality, name, group=quality.group).name}_at")


def _regularity_fact(result: Kinematics, quality: GroupQuality) -> Fact:
    """How near a higher group comes to a singular position."""
    values = keyed(quality, "amplification", group=quality.group)
    values |= _quality_at(result, quality, "amplification", quality.regularity_at)
    text = f"{number(quality.regularity, 4)} everywhere"
    if quality.regularity_at is not None:
        text = f"min {number(quality.regularity, 4)} at {_place(result, quality.regularity_at)}"
    return Fact(f"regularity of {quality.group}", f"{text} (1 the best, 0 singular)", values)
