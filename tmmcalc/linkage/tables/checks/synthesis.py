"""Checks of ``[synthesis]``: one kind, as many independent sizes as the linkage has, points that go together."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmmcalc.linkage.tables.synthesis import KINDS
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, word
from tmmcalc.spec.phrases import either, listing, show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.values import amount, amounts, check_bare_speed, first_disorder

_SLIDER_LENGTHS = ("stroke", "crank", "rod", "offset")
_SLIDER_RATIOS = ("pressure_working", "pressure_idle", "time_ratio", "crank_ratio", "offset_ratio", "offset_part")
_FOUR = ("crank", "coupler", "rocker", "frame")
_TO_AND_FRO, _IN_ORDER = "the crank goes to and fro", "write its angles in ascending or descending order"
_OUTPUTS = {"four_bar": "angle", "slider_crank": "length"}
_INDEPENDENT = 3
_TRIPLES = {
    frozenset(keys)
    for keys in (
        ("crank", "rod", "crank_ratio"),
        ("crank", "offset", "offset_ratio"),
        ("stroke", "offset", "offset_part"),
    )
}


def check_kind(outline: Outline) -> Iterator[Finding]:
    """There is one kind; the speed is given once."""
    table = subtable(outline.document, "synthesis")
    there = [kind for kind in KINDS if kind in table]
    if not there and isinstance(outline.document.get("synthesis"), dict):
        rule = "missing key: a synthesis has a kind"
        yield Finding(("synthesis",), rule, f"add [synthesis.{KINDS[0]}], or one of: {listing(KINDS[1:])}")
    for kind in there[1:]:
        yield Finding(("synthesis", kind), f"{kind} together with {there[0]}: a synthesis has one kind", "remove one")
    yield from check_bare_speed(table.get("crank_speed"), ("synthesis", "crank_speed"))
    for kind in there:
        if "crank_speed" in table and "working_speed" in subtable(table, kind):
            rule = "working_speed together with crank_speed: one follows from the other"
            yield Finding(("synthesis", kind, "working_speed"), rule, "keep one of them")


def check_slider_crank(outline: Outline) -> Iterator[Finding]:
    """Three independent sizes, one of them a length other than zero."""
    asked = _asked(outline, "slider_crank")
    if asked is None:
        return
    lengths = [key for key in _SLIDER_LENGTHS if key in asked]
    given = [*lengths, *(key for key in _SLIDER_RATIOS if key in asked)]
    scales = [key for key in lengths if amount(asked.get(key), "length") != 0]
    path = ("synthesis", "slider_crank")
    if not scales:
        yield Finding(path, "no length gives the scale", 'add stroke = "200 mm"')
    elif len(given) != _INDEPENDENT:
        few = "too few" if len(given) < _INDEPENDENT else "too many"
        rule = f"{few} sizes: {listing(given)}; a slider-crank has {_INDEPENDENT} that are independent"
        yield Finding(path, rule, f"give {_INDEPENDENT}, such as stroke, pressure_working and pressure_idle")
    else:
        yield from _dependent(path, asked, given)


def _dependent(path: tuple[str, ...], asked: Raw, given: Sequence[str]) -> Iterator[Finding]:
    """Three sizes of which two settle the third, or two that say that the slider-crank is central."""
    if frozenset(given) in _TRIPLES:
        rule = f"{given[2]} together with {given[0]} and {given[1]}: it follows from them"
        yield Finding((*path, given[2]), rule, "give another size in its place, such as time_ratio")
        return
    central = [key for key in given if _central(asked, key)]
    if len(central) > 1:
        rule = f"{show(asked[central[1]])} together with {central[0]}: both say that the guide passes the crank's pivot"
        yield Finding((*path, central[1]), rule, "give another size in its place, such as crank_ratio")


def _central(asked: Raw, key: str) -> bool:
    """Whether a size says that the offset is zero."""
    if key == "time_ratio":
        return amount(asked[key]) == 1
    return key.startswith("offset") and amount(asked[key], *(("length",) if key == "offset" else ())) == 0


def check_slotted_links(outline: Outline) -> Iterator[Finding]:
    """The rod is found once, the layout is settled, and the strokes differ."""
    for kind, layout, needed in (
        ("slotted_link", ("crank", "centres"), ("guide", "crank", "centres")),
        ("rotating_slotted_link", ("crank", "centres"), ("crank", "centres")),
    ):
        asked = _asked(outline, kind)
        if asked is None:
            continue
        path = ("synthesis", kind)
        yield from _one_of(path, asked, ("pressure_angle", "rod"))
        if all(key in asked for key in layout):
            rule = f"{layout[1]} together with {layout[0]}: one follows from the other and the time ratio"
            yield Finding((*path, layout[1]), rule, "keep one of them")
        if not any(key in asked for key in needed):
            yield Finding(path, f"nothing settles the size of the crank: {either(needed)}", 'add crank = "80 mm"')
        if amount(asked.get("time_ratio")) == 1:
            rule = "time_ratio = 1: a slotted link makes the strokes differ"
            yield Finding((*path, "time_ratio"), rule, "write a ratio above 1, such as 1.4")


def check_crank_rocker(outline: Outline) -> Iterator[Finding]:
    """One length, and at most one second size."""
    asked = _asked(outline, "crank_rocker")
    if asked is None:
        return
    path = ("synthesis", "crank_rocker")
    lengths = [key for key in _FOUR if key in asked]
    if not lengths:
        yield Finding(path, "no length gives the scale", 'add rocker = "300 mm"')
    elif len(lengths) + ("transmission_angle" in asked) > 2:
        second = [*lengths, *(["transmission_angle"] if "transmission_angle" in asked else [])]
        rule = f"too many sizes: {listing(second)}; swing and time_ratio leave the scale and one size free"
        yield Finding(path, rule, "keep two of them, or one for the best transmission")


def check_trailing_rod(outline: Outline) -> Iterator[Finding]:
    """The master rod is longer than crank and lug."""
    asked = _asked(outline, "trailing_rod")
    rod = None if asked is None else amount(asked.get("rod"), "length")
    if asked is None or rod is None or rod <= 0:
        return
    for key, why in (
        ("crank", "the crank does not turn round"),
        ("lug", "nothing is left for the trailing rod, l - l_C"),
    ):
        length = amount(asked.get(key), "length")
        if length is not None and length >= rod:
            rule = f"{show(asked[key])} is not shorter than the master rod, {show(asked['rod'])}: {why}"
            yield Finding(("synthesis", "trailing_rod", key), rule, f"write a {key} below {show(asked['rod'])}")


def check_function(outline: Outline) -> Iterator[Finding]:
    """One source of the function, with its ranges, in the units of the output."""
    asked = _asked(outline, "function")
    if asked is None:
        return
    path = ("synthesis", "function")
    there = [key for key in ("expression", "table", "inputs") if key in asked]
    if len(there) != 1:
        rule = "no function" if not there else f"{' and '.join(there)} together: a function has one source"
        yield Finding(path, rule, 'give expression = "log(x)" with range, or table, or inputs with outputs')
        return
    yield from _function_ranges(path, asked, there[0])
    yield from _function_points(path, asked)
    kind = word(asked, "mechanism", "four_bar")
    needed = _OUTPUTS.get(kind)
    outputs = asked.get("outputs")
    values = [("output_range", asked.get("output_range")), ("output_start", asked.get("output_start"))]
    values += [("outputs", value) for value in outputs] if isinstance(outputs, list) else []
    for key, value in values:
        found = dimension_of(value)
        if needed and found and found in _OUTPUTS.values() and found != needed:
            noun = DIMENSIONS[needed].noun
            rule = f"{show(value)} is {DIMENSIONS[found].noun}; the output of a {kind} is {noun}"
            yield Finding((*path, key), rule, f'write {noun}, such as "{DIMENSIONS[needed].example}"')
            return
    if there[0] == "expression" and isinstance(asked["expression"], str):
        yield from _expression(path, asked)


def _function_ranges(path: tuple[str, ...], asked: Raw, source: str) -> Iterator[Finding]:
    pairs = {"expression": ("range", "input_range", "output_range"), "table": ("input_range", "output_range")}
    for key in pairs.get(source, ("outputs",)):
        if key not in asked:
            example = {"range": "range = [1, 2]", "outputs": 'outputs = ["0 deg", ...]'}.get(key, f'{key} = "90 deg"')
            yield Finding(path, f"missing key: {source} needs {key}", f"add {example}")
    for key, dimensions in (("input_range", ("angle",)), ("output_range", ("angle", "length"))):
        if amount(asked.get(key), *dimensions) == 0 and key in asked:
            yield Finding((*path, key), f"{key} is zero: nothing would move", "write a range other than 0")
    ends = amounts(asked.get("range"))
    if ends is not None and len(ends) == 2 and ends[0] >= ends[1]:
        yield Finding((*path, "range"), f"{show(asked['range'])} runs backwards", "write the smaller end first")


def _function_points(path: tuple[str, ...], asked: Raw) -> Iterator[Finding]:
    table, inputs, outputs = asked.get("table"), asked.get("inputs"), asked.get("outputs")
    if isinstance(inputs, list) and isinstance(outputs, list) and len(inputs) != len(outputs):
        rule = f"{len(inputs)} inputs and {len(outputs)} outputs: each has one"
        yield Finding((*path, "outputs"), rule, "write as many of both")
    pairs = [amounts(pair) for pair in table] if isinstance(table, list) else []
    rows = [pair for pair in pairs if pair is not None and len(pair) == 2]
    if len(rows) == len(pairs) > 1:
        late = first_disorder([x for x, _ in rows])
        if late is not None:
            yield Finding((*path, "table", late), "the abscissae do not ascend", "write the pairs by ascending x")
        if rows[0][1] == rows[-1][1]:
            yield Finding((*path, "table"), "the first and the last value are equal: the output has no range", _OWN)
    angles = amounts(inputs, "angle")
    if isinstance(inputs, list) and len(inputs) < _INDEPENDENT:
        yield Finding((*path, "inputs"), f"{len(inputs)} points are fewer than 3", "write three points or more")
    elif angles is not None and first_disorder(angles) is not None and first_disorder(angles[::-1]) is not None:
        yield Finding((*path, "inputs"), _TO_AND_FRO, _IN_ORDER)


_OWN = "give inputs and outputs themselves"


def _expression(path: tuple[str, ...], asked: Raw) -> Iterator[Finding]:
    """The formula can be read and differs at the ends of its interval."""
    import numpy as np  # late: only expressions need it

    from tmmcalc.core.errors import UsageError
    from tmmcalc.linkage.tables.tasks.synthesis import FINE, formula_of

    ends = amounts(asked.get("range"))
    low, high = ends if ends is not None and len(ends) == 2 and ends[0] < ends[1] else (0.0, 1.0)
    try:
        formula = formula_of(asked["expression"])
        values = formula(np.linspace(low, high, FINE)) if ends is not None else None
    except UsageError as fault:
        yield Finding((*path, "expression"), fault.message, fault.remedy)
        return
    if values is not None and abs(values[-1] - values[0]) <= 1e-12 * np.max(np.abs(values)):
        rule = "y is the same at both ends of the range: the output has no range"
        yield Finding((*path, "expression"), rule, _OWN)


def check_poses(outline: Outline) -> Iterator[Finding]:
    """As many angles as points, in the order of the crank; points that differ; corners of a rectangle."""
    for kind, key in (("path", "timing"), ("motion", "angles")):
        asked = _asked(outline, kind)
        if asked is None:
            continue
        path = ("synthesis", kind)
        points, angles = asked.get("points"), asked.get(key)
        if isinstance(points, list) and isinstance(angles, list) and len(points) != len(angles):
            rule = f"{len(angles)} angles for {len(points)} points"
            yield Finding((*path, key), rule, "write one angle for every point")
        places = [_place(point) for point in points] if isinstance(points, list) else []
        same = next((k for k in range(1, len(places)) if places[k] and places[k] == places[k - 1]), None)
        turns = amounts(angles, "angle") if kind == "motion" else None
        if same is not None and (kind == "path" or (turns and same < len(turns) and turns[same] == turns[same - 1])):
            what = "point" if kind == "path" else "pose"
            yield Finding((*path, "points", same), f"{what} {same + 1} is the one before it", "remove one of them")
        if kind == "path":
            yield from _timing(path, amounts(angles, "angle"))
        corners = [_place(corner) for corner in asked["region"]] if isinstance(asked.get("region"), list) else []
        if (
            len(corners) == 2
            and corners[0]
            and corners[1]
            and not (corners[0][0] < corners[1][0] and corners[0][1] < corners[1][1])
        ):
            rule = "the corners of the region are not the lower left and the upper right one"
            yield Finding((*path, "region"), rule, "write [[x_low, y_low], [x_high, y_high]]")


def _timing(path: tuple[str, ...], angles: list[float] | None) -> Iterator[Finding]:
    if angles is None or len(angles) < 2:
        return
    if first_disorder(angles) is not None and first_disorder([-angle for angle in angles]) is not None:
        yield Finding((*path, "timing"), _TO_AND_FRO, _IN_ORDER)
    elif abs(angles[-1] - angles[0]) >= 2 * math.pi:
        yield Finding((*path, "timing"), "the timing is a turn or more", "write angles within a turn")


def _place(point: object) -> tuple[float, float] | None:
    found = amounts(point, "length")
    return (found[0], found[1]) if found is not None and len(found) == 2 else None


def _asked(outline: Outline, kind: str) -> Raw | None:
    """The sub-table of a kind, None if it is not there."""
    asked = subtable(outline.document, "synthesis").get(kind)
    return asked if isinstance(asked, dict) else None


def _one_of(path: tuple[str, ...], asked: Raw, keys: Sequence[str]) -> Iterator[Finding]:
    there = [key for key in keys if key in asked]
    if not there:
        yield Finding(path, f"missing key: {either(keys)}", f'add {keys[0]} = "10 deg"')
    elif len(there) > 1:
        rule = f"{there[1]} together with {there[0]}: one follows from the other"
        yield Finding((*path, there[1]), rule, "keep one of them")


CHECKS = (
    check_kind,
    check_slider_crank,
    check_slotted_links,
    check_crank_rocker,
    check_trailing_rod,
    check_function,
    check_poses,
)
