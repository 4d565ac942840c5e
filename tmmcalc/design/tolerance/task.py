"""From ``[[tolerances]]`` and the numbers of a spec to what varies, in the units of the keys."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path as File
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from tmmcalc.core.errors import UsageError
from tmmcalc.design.tables.fits import deviations, is_class
from tmmcalc.design.tables.general import class_of, of_angle, of_length
from tmmcalc.design.tolerance.measured import column_of
from tmmcalc.design.tolerance.sources import Clearance, Dimension, Kind, Sources
from tmmcalc.naming.keys import chosen
from tmmcalc.naming.language import WILD
from tmmcalc.naming.rows import in_unit
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.outline import Raw
from tmmcalc.spec.override import apply
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.units import UnitError, conversion, kind_of, parse

if TYPE_CHECKING:
    from tmmcalc.design.tables.tolerances import ToleranceTable
    from tmmcalc.spec.variants import Axis

METRE, RADIAN = "m", "rad"
Pressed = Callable[[str, int], complex]  # name of a joint, a link of it -> unit vector in the axes of the link


def varying(tolerances: Sequence[ToleranceTable], document: Raw) -> tuple[str, ...]:
    """The keys that vary, each number once however it is written; raises UsageError where nothing does, or a key is
    none.
    """
    keys: list[str] = []
    for table in tolerances:
        keys += (
            [*_pin(table, document).keys]
            if table.joint
            else [one for key in table.of for one in _meant(table, key, document)]
        )
    if not keys:
        raise UsageError("nothing varies", where="tolerances", remedy='add [[tolerances]] with of = "..." to the spec')
    found: dict[Path, str] = {}
    for key in keys:
        found.setdefault(_path(key, document), key)
    return tuple(found.values())


def sources_of(
    tolerances: Sequence[ToleranceTable], document: Raw, axes: Sequence[Axis], pressed: Pressed | None = None
) -> Sources:
    """All that varies; the axes are those of `varying`, each with its nominal value and unit.

    ``pressed`` tells where forces press joints whose clearance is told to be there. Raises UsageError where a tolerance
    does not fit its size or its unit, or a key has two.
    """
    at = {_path(axis.key, document): number for number, axis in enumerate(axes)}
    seen: dict[Path, str] = {}
    dimensions: list[Dimension] = []
    clearances: list[Clearance] = []
    for number, table in enumerate(tolerances, 1):
        where = f"tolerances, {number}"
        if table.joint:
            clearances.append(_clearance(table, document, axes, at, where, pressed))
            continue
        for key in table.of:
            for one in _meant(table, key, document):
                path = _path(one, document)
                if path in seen:
                    also = "" if seen[path] == one else f", as {seen[path]} too"
                    rule = f"{one} has two tolerances{also}"
                    raise UsageError(rule, where=where, remedy="leave it out of one of them")
                seen[path] = one
                dimensions.append(_dimension(table, axes[at[path]], at[path], where))
    return Sources(len(axes), tuple(dimensions), tuple(clearances))


def _path(key: str, document: Raw) -> Path:
    """Where a key is in the document, whichever way it names elements of lists."""
    return apply(document, [f"{key}=0"])[1][0]


def _meant(table: ToleranceTable, key: str, document: Raw) -> list[str]:
    """The keys that one of a table stands for; wildcards pass over zeros where the tolerance is that of a size."""
    from tmmcalc.spec.variants import given

    found = chosen(document, [key], "tolerances")
    sized = _of_size(table) and not WILD.isdisjoint(key)
    return [each for each in found if not (sized and given(each, document)[0] == 0.0)]


def _of_size(table: ToleranceTable) -> bool:
    """Whether a tolerance is that of a magnitude, and not of the number as it is written."""
    width = table.tolerance
    if table.measurements is not None:
        return table.measured_as == "sizes"
    return isinstance(width, str) and (is_class(width) or bool(class_of(width)) or width.rstrip().endswith("%"))


def _dimension(table: ToleranceTable, axis: Axis, at: int, where: str) -> Dimension:
    unit = axis.unit or axis.si
    try:
        if table.measured is not None:
            measured = tuple(_in(unit, each) for each in table.measured)
            ends, kind = (min(measured), max(measured)), "measured"
        elif table.measurements is not None:
            measured = _pieces(table, axis, unit, where)
            ends, kind = (min(measured), max(measured)), "measured"
        else:
            measured, kind = (), table.distribution
            ends = _ends(table, axis.values[0], unit)
    except UnitError as error:
        raise UsageError(f"{axis.key}: {error.message}", where=where, remedy=error.remedy) from None
    sense = -1.0 if _of_size(table) and axis.values[0] < 0 else 1.0
    return Dimension(axis.key, at, *ends, cast(Kind, kind), measured, table.alike, table.correlation, sense)


def _pieces(table: ToleranceTable, axis: Axis, unit: str, where: str) -> tuple[float, ...]:
    """Deviations of the pieces of a file in the unit of the key."""
    told, values = column_of(File(str(table.measurements)), table.column, where)
    if (kind_of(told) if told else None) != (kind_of(unit) if unit else None):
        rule = f"{table.measurements} is in {told or 'bare numbers'}, and this {f'in {unit}' if unit else 'is one'}"
        raise UnitError(rule, "name another column, or write its unit in the header: A[mm]")
    found, nominal = [_in(unit, value) for value in values], axis.values[0]
    if table.measured_as == "deviations":
        return tuple(found)
    # the size of a coordinate that is negative is its magnitude, unless the file has its sign too
    return tuple((-size if nominal < 0 < size else size) - nominal for size in found)


def _ends(table: ToleranceTable, size: float, unit: str) -> tuple[float, float]:
    """Lower and upper deviation in the unit of the key."""
    width: Any = table.tolerance
    if isinstance(width, list):
        low, high = (_in(unit, each) for each in width)
        return low, high
    if isinstance(width, str) and width.rstrip().endswith("%"):
        part = float(width.rstrip().removesuffix("%")) / 100
        if size == 0:
            raise UnitError(f"{width} of a size of 0 is nothing", 'write the tolerance itself: "0.1 mm"')
        return -part * abs(size), part * abs(size)
    if isinstance(width, str) and class_of(width):
        return _general(table, size, unit)
    if isinstance(width, str) and is_class(width):
        scale = _scale(unit, METRE, width)
        low, high = (each / scale for each in deviations(width, size * scale))
        return (low, high) if size >= 0 else (-high, -low)
    half = _in(unit, width)
    return -half, half


def _general(table: ToleranceTable, size: float, unit: str) -> tuple[float, float]:
    """By ISO 2768: of a length by itself, of an angle by its shorter side."""
    letter = class_of(str(table.tolerance))
    if kind_of(unit) == kind_of(RADIAN):
        if table.side is None:
            raise UnitError("an angle has its general tolerance by its shorter side", 'add side = "80 mm"')
        half = of_angle(letter, table.side) / _scale(unit, RADIAN, letter)
    else:
        scale = _scale(unit, METRE, letter)
        half = of_length(letter, size * scale) / scale
    return -half, half


def _scale(unit: str, si: str, width: str) -> float:
    """What a value in the unit is multiplied by for SI; raises UnitError for a unit of another kind."""
    if kind_of(unit) != kind_of(si):
        told = f"is in {unit}" if unit else "has no unit"
        raise UnitError(f"{width} is a tolerance of {kind_of(si)}s, and this {told}", 'write it itself, such as "1 %"')
    return conversion(unit, si)


def _in(unit: str, value: float | str) -> float:
    """A deviation in the unit of its key; a bare number is in SI."""
    if isinstance(value, str):
        try:
            return in_unit(value, unit)
        except UnitError:
            told = f"in {unit}" if unit else "a bare number"
            raise UnitError(f"{value!r} is no tolerance of it: it is {told}", f"write a number {told}") from None
    kind = kind_of(unit) if unit else None
    return float(value) if kind is None else float(value) * conversion(DIMENSIONS[kind].si, unit)


def _clearance(
    table: ToleranceTable,
    document: Raw,
    axes: Sequence[Axis],
    at: dict[Path, int],
    where: str,
    pressed: Pressed | None,
) -> Clearance:
    pin = _pin(table, document)
    x, y = (at[_path(key, document)] for key in pin.keys)
    units = [axes[one].unit or axes[one].si for one in (x, y)]
    scale = [_scale(unit, METRE, "clearance") for unit in units]
    name = f"clearance of {table.joint}"
    assert table.clearance is not None  # the checks of the table ask for it
    low, high = (end / 2 for end in table.clearance)
    along, sides = pin.across, pin.across is not None and table.direction == "any"
    if table.direction == "force":
        if pressed is None:
            raise UsageError(f"no force is known in {table.joint}", where=where, remedy='write direction = "any"')
        towards = pressed(str(table.joint), pin.link)
        along = (towards.real, towards.imag)
        if pin.across is not None:
            side = math.copysign(1.0, along[0] * pin.across[0] + along[1] * pin.across[1])
            along = (side * pin.across[0], side * pin.across[1])
    elif isinstance(table.direction, float):
        along = (math.cos(table.direction), math.sin(table.direction))
    radius = Dimension(name, x, low, high, cast(Kind, table.distribution))
    return Clearance(name, (x, y), radius, along, sides, (1 / scale[0], 1 / scale[1]))


class _Pin(NamedTuple):
    """What a clearance moves: keys of two coordinates in the axes of a link, of a guide its normal there."""

    keys: tuple[str, str]
    link: int
    across: tuple[float, float] | None = None


def _pin(table: ToleranceTable, document: Raw) -> _Pin:
    """Raises UsageError where there are no such coordinates."""
    joint = next(each for each in document["mechanism"]["joints"] if each["name"] == table.joint)
    if joint["kind"] == "prismatic":
        angle = parse(joint["guide"].get("angle", 0.0), "angle")
        stem, across = f"mechanism.joints[name={table.joint}].guide.through", (-math.sin(angle), math.cos(angle))
        return _Pin((f"{stem}[0]", f"{stem}[1]"), joint["links"][1], across)
    links = joint["links"]
    link = table.link if table.link is not None else next(each for each in links if each != 0)
    names = joint.get("points", [joint.get("point", table.joint)] * 2)
    point = names[links.index(link)]
    stem = f"mechanism.fixed.{point}" if link == 0 else f"mechanism.links[id={link}].points.{point}"
    keys = (f"{stem}[0]", f"{stem}[1]")
    chosen(document, keys, "tolerances")  # a point given by length and angle has none
    return _Pin(keys, link)
