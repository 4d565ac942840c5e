"""Checks of the laws of motion in ``[cam]``: one for each moving phase, each of one kind, able to move a follower."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.cams.tables.checks.written_cam import WrittenCam, place, written_cam
from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.tables.checks.curves import Curve
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.phrases import Path, either, show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.values import amount, first_disorder

_KEYS = ("law", "rise_law", "return_law")
_KINDS = ("points", "acceleration", "polynomial")
_COLUMNS = ("k", "s")


def check_there(outline: Outline) -> Iterator[Finding]:
    """Rise and return have one law each."""
    cam = written_cam(outline)
    own = [key for key in _KEYS[1:] if key in cam.table]
    if "law" in cam.table and len(own) == 2:
        rule = "law together with rise_law and return_law: no phase is left for it"
        yield Finding(place("", "law"), rule, "remove it")
    elif "law" not in cam.table and len(own) < 2:
        absent = next(key for key in _KEYS if key != "law" and key not in own)
        rule = f"missing key: {absent}" if own else "missing key: the follower moves by a law"
        yield Finding(("cam",), rule, f'add {absent if own else "law"} = "sine"')


def check_own(outline: Outline) -> Iterator[Finding]:
    """A law of one's own is given in one way, and can move a follower."""
    cam = written_cam(outline)
    for key in _KEYS:
        if isinstance(cam.table.get(key), dict):
            yield from _check_law(outline, cam, key)


def _check_law(outline: Outline, cam: WrittenCam, key: str) -> Iterator[Finding]:
    curve = Curve(outline, cam.part(key), place(key), "angle")
    read = curve.path in outline.rows
    given = [kind for kind in (*_KINDS, *(() if read else ("file",))) if kind in curve.table]
    if not given:
        rule = f"missing key: a law of one's own has {either((*_KINDS, 'file'))}"
        yield Finding(curve.path, rule, "add points = [[0, 0], [0.5, 0.4], [1, 1]], for example")
    elif len(given) > 1:
        rule = f"{' and '.join(given)} together: a law has one of them"
        yield Finding((*curve.path, given[-1]), rule, "keep one of them")
    elif given[0] == "polynomial":
        numbers = curve.table["polynomial"]
        if isinstance(numbers, list) and 3 <= len(numbers) <= 30:
            yield from _check_moves("polynomial", [amount(number) for number in numbers], curve)
    elif given[0] in _KINDS:
        yield from _check_points(given[0], curve)


def _check_points(kind: str, curve: Curve) -> Iterator[Finding]:
    listed = curve.table[kind]
    if not isinstance(listed, list) or len(listed) < 2:
        return
    points = [point for point in listed if isinstance(point, list) and len(point) == 2]
    if len(points) < len(listed):
        return
    wrong = [*_check_units(kind, curve, points)]
    numbers = [[_number(value) for value in point] for point in points]
    parts = [k for k, _ in numbers if k is not None]
    if not wrong and len(parts) == len(points):
        wrong = [*_check_order(kind, curve, points, parts)]
    yield from wrong
    if not wrong:
        yield from _check_moves(kind, numbers, curve)


def _number(value: object) -> float | None:
    return amount(value, "angle", "length") if isinstance(value, str) else amount(value)


def _check_units(kind: str, curve: Curve, points: list[list[object]]) -> Iterator[Finding]:
    """All values of a column are of one dimension, where they are not zero; accelerations are to any scale."""
    for column, name in enumerate(_COLUMNS):
        found = [(index, point[column], dimension_of(point[column])) for index, point in enumerate(points)]
        first = next((dimension for _, value, dimension in found if _number(value)), None)
        for index, value, dimension in found:
            if dimension not in (None, "angle", "length"):
                break  # the fault is the table's
            path: Path = (*curve.place(kind), index, column)
            if column == 0 and dimension == "length":
                rule = f"{show(value)} is a length; k is a part of the phase, or an angle"
                yield Finding(path, rule, "write k from 0 to 1, or angles of the cam")
                break
            if column == 1 and kind == "acceleration" and dimension is not None:
                rule = f"{show(value)} has a unit; accelerations are to any scale"
                yield Finding(path, rule, "write a number")
                break
            if dimension != first and _number(value):
                noun = DIMENSIONS[first].noun if first else "a number without a unit"
                rule = f"{show(value)} where {name} of the other points is {noun}"
                yield Finding(path, rule, f"write all {name} with one unit, or all without")
                break


def _check_order(kind: str, curve: Curve, points: list[list[object]], parts: list[float]) -> Iterator[Finding]:
    """k ascends from 0; of accelerations one may stand twice, where they jump."""
    if parts[0] != 0:
        rule = f"{curve.at(0)}k begins at {show(points[0][0])}, not at 0"
        yield Finding(_of_point(curve, kind, 0), rule, "count from the beginning of the phase")
        return
    back = first_disorder(parts)
    while back is not None and kind == "acceleration" and parts[back] == parts[back - 1] and _jumps(parts, back):
        further = first_disorder(parts[back:])
        back = None if further is None else back + further
    if back is not None:
        once = "k ascends" if kind == "points" else "k ascends, and stands at most twice"
        rule = f"{curve.at(back)}{show(points[back][0])} does not come after {show(points[back - 1][0])}; {once}"
        yield Finding(_of_point(curve, kind, back), rule, "put the points in order")


def _jumps(parts: list[float], index: int) -> bool:
    return index < 2 or parts[index - 2] < parts[index]


def _of_point(curve: Curve, kind: str, index: int) -> Path:
    """Place of k of a point, or of the file that it comes from."""
    found = curve.place(kind, index)
    return found if found[-1] == "file" else (*found, 0)


def _check_moves(kind: str, values: Sequence[object], curve: Curve) -> Iterator[Finding]:
    """The law begins and ends at rest and lifts."""
    flat = [number for value in values for number in (value if isinstance(value, list) else [value])]
    if any(number is None for number in flat):
        return
    from tmmcalc.cams.tables.tasks.own_law import own_law  # late: only laws of one's own need numpy

    try:
        own_law(kind, [*values], str(curve.table.get("file", kind)))
    except UsageError as fault:
        yield Finding(curve.place(kind), fault.message, f"write {fault.remedy}")


CHECKS = (check_there, check_own)
