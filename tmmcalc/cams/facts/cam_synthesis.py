"""The documents of the synthesis: sizes and how each was found, the designs beside it, roller, admissible region."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import degrees
from typing import Any

from tmmcalc.cams.facts.cam_pressure import extreme_values, reached_fact
from tmmcalc.cams.facts.pivot import pivot_fact
from tmmcalc.cams.synthesis.results import Convexity, Design, Region, RollerChoice, Size, Synthesis, region_columns
from tmmcalc.core.quantity import Quantity, keyed, quantity_of
from tmmcalc.report.document import Document, Fact, View, angles_in_degrees
from tmmcalc.report.numbers import angle, number

ROUNDING = 1e-14  # [deg]
KINDS = {
    "translating": "translating roller follower",
    "oscillating": "oscillating roller follower",
    "flat": "flat-faced follower",
}
TITLES = {
    "S0": "start distance S0",
    "e": "offset e",
    "R0": "base circle R0",
    "l0": "centre distance l0",
    "l2": "rocker length l2",
    "psi0": "start angle psi0",
    "r2": "roller r2",
}


def summary(result: Synthesis, title: str) -> Document:
    """Sizes, angles and warnings."""
    facts = (_kind_fact(result), *(_size_fact(size) for size in result.sizes))
    warnings = tuple(note for note in result.notes if note.startswith("warning"))
    return angles_in_degrees(Document(title, facts, warnings))


def document(result: Synthesis, title: str, *, everything: bool = False) -> Document:
    """All of it; the table compares the designs, with ``everything`` it is the corners of the admissible region."""
    told = angles_in_degrees(Document(title, tuple(_facts(result)), result.notes))
    if everything:
        columns = region_columns(result)
        view = View(list(columns), [column.tolist() for column in columns.values()])
        return replace(told, table=view if result.region is not None else None)
    return replace(told, table=_designs_view(result))


def _facts(result: Synthesis) -> Iterator[Fact]:
    yield _kind_fact(result)
    for size in result.sizes:
        yield _size_fact(size)
    designs = [_design_values(result, design) for design in result.designs]
    yield Fact("decided by", result.governs, keyed(result, "governs") | {"designs": designs})
    if result.rise is not None and result.back is not None:
        yield reached_fact("rise", result.rise)
        yield reached_fact("return", result.back)
        if result.governs == "pressure angle":
            text = f"{max(degrees(result.residual), ROUNDING):.0e} deg of the limit that they reach"
            yield Fact("sizes are exact to", text, keyed(result, "residual[deg]"))
    if result.convexity is not None:
        yield from _face_facts(result.convexity)
    if result.pivot is not None:
        yield pivot_fact(result.pivot)
    if result.roller is not None:
        yield from _roller_facts(result.roller)
    if result.rounded is not None:
        yield _rounded_fact(result, result.rounded)
    if result.region is not None:
        yield _region_fact(result, result.region)


def _kind_fact(result: Synthesis) -> Fact:
    follower = result.follower
    text = f"{KINDS[result.kind]}, the cam turns {follower.rotation}"
    values = keyed(result, "kind") | keyed(follower, "rotation")
    if result.kind == "oscillating":
        text += f", the rocker rises {follower.rocker_turn} it"
        values |= keyed(follower, "rocker_turn")
    return Fact("follower", text, values)


def _size_fact(size: Size) -> Fact:
    unit, shown = ("rad", f"{angle(degrees(size.value))} deg") if size.symbol == "psi0" else ("m", _mm(size.value))
    values = keyed(size, "value", "given", symbol=size.symbol, unit=unit)
    return Fact(TITLES[size.symbol], f"{shown}, {size.how}", values)


def _face_facts(found: Convexity) -> Iterator[Fact]:
    at = angle(degrees(found.least.phi))
    values = extreme_values(found, "least") | keyed(found, "limit", "needed", "radius")
    text = f"F_min = min(dS + S'') = {_mm(found.least.value)} at phi = {at} deg\n"
    text += f"S0 >= r_m - F_min = {_mm(found.needed)} with r_m = {_mm(found.limit)}\n"
    text += f"least radius of the profile {_mm(found.radius)}"
    yield Fact("convexity", text, values)
    text = f"{_mm(found.left)} to the left of the axis, {_mm(found.right)} to the right"
    if found.margin:
        text += f"\n(of these {_mm(found.margin)} are margin)"
    yield Fact("reach of the face", text, keyed(found, "left", "right"))


def _roller_facts(found: RollerChoice) -> Iterator[Fact]:
    lines = [f"{rule.name} = {_mm(rule.value)}" for rule in found.rules]
    values: dict[str, Any] = {}
    for rule in found.rules:
        values |= keyed(rule, "value", rule=rule.name)
    yield Fact("roller at most", "\n".join(lines), values | keyed(found, "governs"))
    at = angle(degrees(found.convex.phi))
    lines = [f"rho2 = {_mm(found.convex.value)} at phi = {at} deg, convex"]
    values = extreme_values(found, "convex")
    if found.concave is not None:
        lines.append(f"rho1 = {_mm(found.concave.value)} at phi = {angle(degrees(found.concave.phi))} deg, concave")
        values |= extreme_values(found, "concave")
    yield Fact("least radii, pitch curve", "\n".join(lines), values)


def _rounded_fact(result: Synthesis, design: Design) -> Fact:
    sizes = _sizes(result, design)
    text = ", ".join(f"{name} = {_shown(name, value)}" for name, value in sizes.items())
    if result.kind != "flat":
        largest = degrees(max(map(abs, (*design.rise, *design.back))))
        text += f"\n(pressure angle at most {number(largest, 6)} deg)"
    return Fact("in whole millimetres", text, {"rounded": _design_values(result, design)})


def _region_fact(result: Synthesis, region: Region) -> Fact:
    """The corner, what the coordinates are, how the region is given."""
    columns = region_columns(result)
    names = list(columns)
    low = int(region.y.argmin() if result.kind == "translating" else region.y.argmax())
    at = ", ".join(f"{name.partition('[')[0]} = {_mm(float(columns[name][low]))}" for name in names[:2])
    frame = f"\n({region.frame})" if result.kind == "oscillating" else ""
    values = {name: column.tolist() for name, column in columns.items()}
    text = f"{len(region.x)} corners; the one nearest to the roller: {at}{frame}\n--format json prints all"
    return Fact("region of the cam's axis", text, {"region": values})


def _designs_view(result: Synthesis) -> View | None:
    """The designs in a row each: sizes in mm, angles in deg."""
    if not result.designs:
        return None
    rows = [{"design": each.name, **_row(result, each)} for each in result.designs]
    return View(list(rows[0]), [[row[name] for row in rows] for name in rows[0]])


def _row(result: Synthesis, design: Design) -> dict[str, float]:
    row = {}
    for name, value in _sizes(result, design).items():
        turned = name == "psi0"
        header, factor = _size_quantity(name).shown("deg" if turned else "mm")
        row[header] = factor * value
    worst = (max(map(abs, design.rise)), max(map(abs, design.back)), max(design.excess, 0.0))
    for name, value in zip(("rise", "back", "excess"), worst, strict=True):
        header, factor = quantity_of(Design, name).shown("deg")
        row[header] = factor * value
    return row


def _sizes(result: Synthesis, design: Design) -> dict[str, float]:
    """The sizes that a design of this kind has, e in the user's sense."""
    if result.kind == "flat":
        return {"S0": design.start}
    if result.kind == "translating":
        return {"S0": design.start, "e": result.follower.sense * design.offset, "R0": design.base}
    return {"l0": design.centres, "l2": design.rocker, "psi0": design.start, "R0": design.base}


def _design_values(result: Synthesis, design: Design) -> dict[str, Any]:
    sizes = {_size_quantity(name).key: value for name, value in _sizes(result, design).items()}
    angles = keyed(design, "rise[deg]", "back[deg]", "excess[deg]") if result.kind != "flat" else {}
    return keyed(design, "name") | sizes | angles


def _size_quantity(symbol: str) -> Quantity:
    return quantity_of(Size, "value", symbol=symbol, unit="rad" if symbol == "psi0" else "m")


def _shown(name: str, value: float) -> str:
    return f"{angle(degrees(value))} deg" if name == "psi0" else _mm(value)


def _mm(length: float) -> str:
    return f"{number(1e3 * length)} mm"
