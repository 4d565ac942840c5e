"""The documents of the cam's requirements: every margin with its formula, what it is made of, the table of rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees

from tmmcalc.cams.facts.rows import with_further, with_rows
from tmmcalc.cams.strength.columns import margin_rows, strength_columns
from tmmcalc.cams.strength.results import CamStrength, Margin
from tmmcalc.core.columns import Column
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import keyed, quantity_of
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.sizes import quantity

FAR = -9.0  # margin from which on it is told as a ratio
VERDICTS = {
    "ok": "ok",
    "not judged": "not judged",
    "slip": "slips",
    "undercut": "undercut",
    "tool_interference": "tool too large",
    "exceeded": "exceeded",
}


def summary(result: CamStrength, title: str) -> Document:
    """Verdict, the least margin and warnings, and the margins as a table."""
    return Document(title, (_verdict_fact(result),), result.notes, _margins_view(result))


def document(result: CamStrength, title: str, *, everything: bool = False) -> Document:
    """All margins with their formulas and what they are made of; ``everything`` is for programs, in SI."""
    facts = (_verdict_fact(result), *_made_facts(result))
    if everything:
        return Document(title, (*facts, Fact("margins", "", {"margins": margin_rows(result)})), result.notes)
    return Document(title, (*facts, _formulas_fact(result)), result.notes, _margins_view(result))


def turn_document(
    result: CamStrength,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """Slip, stresses and moments over the turn, as the tables of the other stages."""
    told, ends = Document(title, (_verdict_fact(result),), result.notes), [degrees(end) for end in result.ends]
    columns = strength_columns(result)
    chosen = with_further(columns, patterns, further)
    return with_rows(told, chosen, patterns, rows, ends=ends, everything=everything, example="phi,D*", where=where)


def _verdict_fact(result: CamStrength) -> Fact:
    least = result.governing
    values = keyed(result, "verdict", "judged_count")
    text = "all that is judged is kept" if result.verdict == "ok" else VERDICTS[result.verdict]
    if not result.judged:
        text = "nothing is judged"
    if least is not None and least.margin is not None:
        text += f"; least margin {_passed(least) or f'{number(100 * least.margin, 4)} %'}: {least.name}"
        values |= keyed(result, "least_margin", "least_margin_of")
    return Fact("verdict", text, values)


def _margins_view(result: CamStrength) -> View:
    """One row a requirement."""
    rows = [_cells(each) for each in result.margins]
    units = {"margin": "%", "phi": "deg"}
    told = {name: quantity_of(Margin, name) for name in ("name", "value", "limit", "margin", "phi", "verdict")}
    headers = [each.shown(units[name])[0] if name in units else each.name for name, each in told.items()]
    return View(headers, [list(column) for column in zip(*rows, strict=True)])


def _cells(each: Margin) -> tuple[str, ...]:
    def shown(value: float | None) -> str:
        return "" if value is None else quantity(value, each.unit or "-", 5)

    value = f"{each.symbol} = {shown(each.value)}" if each.value is not None else ""
    margin = "" if each.margin is None else _passed(each) or f"{100 * each.margin:.2f}"
    phi = "" if each.phi is None else f"{degrees(each.phi):.3f}"
    verdict: str = VERDICTS[each.verdict]
    if each.advice:
        verdict = Phrase("{verdict} (advice)", verdict=verdict)
    return each.name, value, shown(each.limit), margin, phi, verdict


def _passed(each: Margin) -> str:
    """How many times a limit is passed that is far behind; empty where per cent are told."""
    return f"{1 - each.margin:.0f} times over" if each.limit and (each.margin or 0.0) < FAR and each.margin else ""


def _formulas_fact(result: CamStrength) -> Fact:
    lines = [f"{each.name}: {each.formula}" + (f"; {each.why}" if each.why else "") for each in result.margins]
    return Fact("formulas", "\n".join(lines))


def _made_facts(result: CamStrength) -> Iterator[Fact]:
    yield from _radius_facts(result)
    unit, rolling, shaft = result.unit, result.rolling, result.shaft
    if unit is not None:
        source = "given" if unit.given else "by the pressure on it (5.83)"
        text = f"r0 = {quantity(unit.pin, 'm')}, {source}; least roller r2* = {quantity(unit.least, 'm')}"
        yield Fact("pin of the roller", text, keyed(unit, "pin", "given", "least"))
    if rolling is not None:
        text = (
            f"C1 = {number(rolling.resisting)}, C2 = {number(rolling.driving)} N/m (J = {rolling.inertia:.5g} kg*m^2)"
        )
        for a, b in rolling.slipping:
            text += f"\nslips for phi from {angle(degrees(a))} to {angle(degrees(b))} deg"
        yield Fact("slip function", text, keyed(rolling, "resisting", "driving", "inertia", "slipping[deg]"))
    if shaft is not None:
        parts = [f"r1* = {quantity(shaft.radius, 'm')}, rounded up to a whole mm"]
        values = keyed(shaft, "radius")
        if shaft.strength is not None and shaft.moment is not None:
            parts.append(f"strength r1' = {quantity(shaft.strength, 'm')} from M_E = {number(shaft.moment)} N*m")
            values |= keyed(shaft, "strength", "moment", "moment_with_friction")
        if shaft.stiffness is not None:
            parts.append(f"stiffness r1'' = {quantity(shaft.stiffness, 'm')}")
            values |= keyed(shaft, "stiffness")
        yield Fact("camshaft", "\n".join(parts), values)


def _radius_facts(result: CamStrength) -> Iterator[Fact]:
    """rho2 and rho1, or the least radius under a flat face."""
    flat = result.follower.kind == "flat"
    for label, name, radius, phi in (
        ("least radius" if flat else "convex parts", "convex", result.convex, result.convex_phi),
        ("concave parts", "concave", result.concave, result.concave_phi),
    ):
        values = keyed(result, name, f"{name}_phi[deg]", radius="rho_min" if flat else "rho2")
        key = next(iter(values))
        if radius is not None:
            text = f"{key.partition('[')[0]} = {quantity(radius, 'm')} at phi = {angle(degrees(phi))} deg"
            yield Fact(label, text, values)
        elif not flat:
            yield Fact(label, "none", {key: None})
