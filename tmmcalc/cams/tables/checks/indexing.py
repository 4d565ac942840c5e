"""Checks of ``[indexing]``: even rollers, sizes that are given once, a law that moves the wheel from rest to rest."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable
from tmmcalc.spec.phrases import Path, either
from tmmcalc.spec.values import amount, amounts, bare_number

_LONGEST_BARE = 2.0  # m
SAME = 1e-9  # [rad] dwells and steps that are a turn
_TABLE = ("indexing",)
_LAW: Path = (*_TABLE, "law")
_KINDS = ("points", "acceleration", "polynomial", "constant_ends", "peak_velocity")


def check_rollers(outline: Outline) -> Iterator[Finding]:
    """The rollers stand in two equal rows."""
    count = subtable(outline.document, "indexing").get("rollers")
    if isinstance(count, int) and not isinstance(count, bool) and count % 2:
        rule = f"{count} rollers do not fill two rows"
        yield Finding((*_TABLE, "rollers"), rule, f"write an even number, such as {count + 1}")


def check_sizes(outline: Outline) -> Iterator[Finding]:
    """The centre distance is given once, and is above the radius of the wheel."""
    table = subtable(outline.document, "indexing")
    if "ratio" in table and "centre_distance" in table:
        rule = "ratio together with centre_distance: each gives the other"
        yield Finding((*_TABLE, "ratio"), rule, "remove one of them")
    centres, wheel, roller = (_length(table.get(key)) for key in ("centre_distance", "wheel_radius", "roller_radius"))
    if centres is not None and wheel is not None and 0 < centres <= wheel:
        rule = f"centre_distance = {1e3 * centres:.6g} mm is not above wheel_radius = {1e3 * wheel:.6g} mm"
        remedy = "write a larger one: the rollers pass between the two shafts"
        yield Finding((*_TABLE, "centre_distance"), rule, remedy)
    if roller is not None and wheel is not None and roller >= wheel > 0:
        rule = f"a roller of {1e3 * roller:.6g} mm on a wheel of {1e3 * wheel:.6g} mm"
        yield Finding((*_TABLE, "roller_radius"), rule, "write a smaller one")


def check_dwells(outline: Outline) -> Iterator[Finding]:
    """Two steps and two dwells are one turn of the cams."""
    table = subtable(outline.document, "indexing")
    rests, step = amounts(table.get("dwells"), "angle"), amount(table.get("step_angle"), "angle")
    if rests is None or len(rests) != 2 or step is None or min(rests) <= 0:
        return
    over = 2 * step + sum(rests) - 2 * math.pi
    if abs(over) > SAME:
        left = math.degrees(2 * (math.pi - step))
        rule = f"two steps of {math.degrees(step):.6g} deg and dwells of {math.degrees(sum(rests)):.6g} deg are "
        rule += f"{math.degrees(2 * step + sum(rests)):.6g} deg, not a turn"
        remedy = f"write dwells that add up to {left:.6g} deg"
        yield Finding((*_TABLE, "dwells"), rule, remedy)


def check_radii(outline: Outline) -> Iterator[Finding]:
    """Radii of rollers are given once, and are below that of the wheel."""
    table = subtable(outline.document, "indexing")
    if "roller_radii" in table and "roller_radius" in table:
        rule = "roller_radii together with roller_radius: the first gives both rows"
        yield Finding((*_TABLE, "roller_radius"), rule, "remove one of them")
    listed, wheel = table.get("roller_radii"), _length(table.get("wheel_radius"))
    for index, value in enumerate(listed if isinstance(listed, list) else ()):
        radius = _length(value)
        if radius is not None and wheel is not None and radius >= wheel > 0:
            rule = f"a roller of {1e3 * radius:.6g} mm on a wheel of {1e3 * wheel:.6g} mm"
            yield Finding((*_TABLE, "roller_radii", index), rule, "write a smaller one")


def _length(value: object) -> float | None:
    """A length [m]; None for a faulty one, and for a bare number that is meant in mm."""
    bare = bare_number(value)
    return None if bare is not None and bare >= _LONGEST_BARE else amount(value, "length")


def check_law(outline: Outline) -> Iterator[Finding]:
    """A law of one's own is given in one way, begins and ends at rest, and is symmetric."""
    law = subtable(outline.document, "indexing").get("law")
    if not isinstance(law, dict):
        return
    read = _LAW in outline.rows
    given = [kind for kind in (*_KINDS, *(() if read else ("file",))) if kind in law]
    if not given:
        rule = f"missing key: a law of one's own has {either((*_KINDS, 'file'))}"
        yield Finding(_LAW, rule, "add constant_ends = 0.1, for example")
    elif len(given) > 1:
        rule = f"{' and '.join(given)} together: a law has one of them"
        yield Finding((*_LAW, given[-1]), rule, "keep one of them")
    elif given[0] in _KINDS[:3]:
        yield from _check_moves(given[0], law, (*_LAW, "file" if read else given[0]))


def _check_moves(kind: str, law: Raw, path: Path) -> Iterator[Finding]:
    values = law[kind]
    if not isinstance(values, list) or not values:
        return
    numbers = [_numbers(value) for value in values]
    wide = 1 if kind == "polynomial" else 2
    if any(len(each) != wide or None in each for each in numbers):
        return  # the fault is the table's
    from tmmcalc.cams.indexing.laws import stepping  # late: only laws of one's own need numpy
    from tmmcalc.cams.tables.tasks.own_law import own_law

    try:
        stepping(own_law(kind, [each[0] if wide == 1 else each for each in numbers], str(law.get("file", kind))))
    except UsageError as fault:
        yield Finding(path, fault.message, f"write {fault.remedy}")


def _numbers(value: object) -> list[float | None]:
    parts = value if isinstance(value, list) else [value]
    return [amount(part, "angle", "length") if isinstance(part, str) else amount(part) for part in parts]


CHECKS = (check_rollers, check_sizes, check_dwells, check_radii, check_law)
