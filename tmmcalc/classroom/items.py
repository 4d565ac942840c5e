"""What is asked of a class, with the units in which a run of the assignment tells it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.classroom.model import Item
from tmmcalc.classroom.rounding import Floors
from tmmcalc.classroom.tables.class_ import followed
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.naming.language import ANY, parse
from tmmcalc.naming.rows import in_unit
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.project.loader import refused
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.units import UnitError, kind_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from tmmcalc.classroom.tables.class_ import AskedTable, ClassTable
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.spec.phrases import Path

_AGAIN = "make the keys again: tmmcalc class keys"


class _AmissError(Exception):
    """One fault of what is asked: the key that it is of, empty for the table; what is wrong, what to write."""

    def __init__(self, key: str, message: str, remedy: str) -> None:
        self.key, self.message, self.remedy = key, message, remedy
        super().__init__(message)

    def at(self, index: int) -> Finding:
        """With its place."""
        path: Path = ("class", "asked", index)
        return Finding((*path, self.key) if self.key else path, self.message, self.remedy)


def class_of(spec: Spec) -> ClassTable:
    """The table ``[class]`` of a spec; raises UsageError without one."""
    if spec.class_ is None:
        where = spec._written.file if spec._written is not None else ""
        remedy = "add [class] with [[class.asked]], and [[class.drawn]] for what each has its own of"
        raise UsageError("the spec has no [class]: nothing is asked", where=where, remedy=remedy)
    return spec.class_


def items_of(spec: Spec, result: RunResult | None = None) -> tuple[Item, ...]:
    """The asked results of a spec; ``result`` is a run of it, by default one of the stages that they are of.

    Raises UsageError where nothing is asked; SpecError with all names that no result has, units of another kind, and
    results that are zero here without ``within``; and the error of a stage without a solution.
    """
    table = class_of(spec)
    if result is None:
        from tmmcalc.naming.language import stages_of
        from tmmcalc.pipeline.runner import run
        from tmmcalc.rooms import STAGES

        stages = stages_of([each.result for each in table.asked], STAGES)
        result = run(spec, target=stages or None, by_name=True)
    scene, floors = Scene(result.spec, result.results), Floors(result.results)
    places, items, faults = _places(table), list[Item](), list[Finding]()
    for at, each in enumerate(table.asked):
        try:
            items.append(_item(each, table, places, result, scene, floors))
        except _AmissError as error:
            faults.append(error.at(at))
    if faults:
        raise refused(spec, faults)
    return tuple(items)


def _item(
    asked: AskedTable, table: ClassTable, places: Mapping[str, int], result: RunResult, scene: Scene, floors: Floors
) -> Item:
    try:
        found = one(parse(asked.result), result.results, scene)
    except TmmError as error:
        raise _AmissError("result", error.message, error.remedy) from None
    unit = found.unit if asked.unit is None else asked.unit
    if unit != found.unit and (kind_of(unit) is None or kind_of(unit) != kind_of(found.unit)):
        rule = f"{asked.result} is in {found.unit or 'no unit'}, which is no {unit}"
        raise _AmissError("unit", rule, f"write one like {found.unit}, or leave it out")
    within = _within(asked, unit)
    if not within and floors.of(found) >= abs(found.value) and floors.of(found) > 0:
        rule = f"{asked.result} is 0 here but for rounding: of a relative tolerance of it nothing is left"
        remedy = f"add within, how far from 0 an answer may be{f', in {unit}' if unit else ''}"
        raise _AmissError("", rule, f"{remedy}; or ask it at another place")
    return _judged(f"{found.stage}.{found.quantity}", unit, within, asked, table, places)


def _within(asked: AskedTable, unit: str) -> float:
    try:
        return 0.0 if asked.within is None else in_unit(asked.within, unit)
    except UnitError as error:
        raise _AmissError("within", str(error), f"write it in {unit}" if unit else "write a number") from None


def _judged(
    result: str, unit: str, within: float, asked: AskedTable, table: ClassTable, places: Mapping[str, int]
) -> Item:
    """An item of this result, with names and tolerances as they stand in the spec."""
    tolerance, plans = float(asked.tolerance or table.tolerance), float(asked.plans or table.plans)
    after = dict(sorted((places[name.casefold()], power) for name, power in map(followed, asked.after)))
    return Item(
        asked.name or asked.result,
        tuple(asked.also),
        result,
        unit,
        tolerance,
        within,
        max(plans, tolerance),
        float(asked.weight),
        asked.digits or table.digits,
        tuple(after),
        asked.either_sense,
        tuple(after.values()),
        asked.meaning or "",
    )


def asked_now(spec: Spec, items: Sequence[Item]) -> tuple[Item, ...]:
    """Items of keys with the names, tolerances and weights that the assignment has now; nothing is run.

    Raises UsageError where it asks for more or fewer results than the keys tell, SpecError with all that are others, or
    in other units.
    """
    table = class_of(spec)
    if len(table.asked) != len(items):
        raise UsageError(f"{len(table.asked)} results are asked, the keys have {len(items)}", remedy=_AGAIN)
    places, found, faults = _places(table), list[Item](), list[Finding]()
    for at, (asked, item) in enumerate(zip(table.asked, items, strict=True)):
        try:
            _check_same(asked, item)
            found.append(_judged(item.result, item.unit, _within(asked, item.unit), asked, table, places))
        except _AmissError as error:
            faults.append(error.at(at))
    if faults:
        raise refused(spec, faults)
    return tuple(found)


def _check_same(asked: AskedTable, item: Item) -> None:
    own, known = parse(asked.result), parse(item.result)
    same = own.quantity == known.quantity and own.stage in ("", ANY, known.stage)
    if not same or asked.unit not in (None, item.unit):
        rule = f"{asked.result} in {asked.unit or item.unit or 'no unit'} is asked"
        keys = f"the keys have {item.result} in {item.unit or 'no unit'}"
        raise _AmissError("" if same else "result", f"{rule}, {keys}", _AGAIN)


def _places(table: ClassTable) -> dict[str, int]:
    """The places of asked results by all their names."""
    return {
        name.casefold(): at for at, each in enumerate(table.asked) for name in (each.name or each.result, *each.also)
    }
