"""What is asked of a class, with the units in which a run of the assignment tells it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.classroom.model import Item
from tmmcalc.classroom.tables.class_ import followed
from tmmcalc.core.errors import UsageError
from tmmcalc.naming.language import ANY, parse
from tmmcalc.naming.rows import in_unit
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.spec.units import UnitError, kind_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from tmmcalc.classroom.tables.class_ import AskedTable, ClassTable
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec

_AGAIN = "make the keys again: tmmcalc class keys"


def items_of(spec: Spec, result: RunResult | None = None) -> tuple[Item, ...]:
    """The asked results of a spec; ``result`` is a run of it, by default one of the stages that they are of.

    Raises UsageError where nothing is asked, for a name that no result has, and for a unit of another kind; and the
    error of a stage without a solution.
    """
    table = spec.class_
    if table is None:
        raise UsageError("nothing is asked", remedy="add [class] with [[class.asked]] to the spec")
    if result is None:
        from tmmcalc.naming.language import stages_of
        from tmmcalc.pipeline.runner import run
        from tmmcalc.rooms import STAGES

        stages = stages_of([each.result for each in table.asked], STAGES)
        result = run(spec, target=stages or None, by_name=True)
    scene = Scene(result.spec, result.results)
    places = _places(table)
    return tuple(_item(each, table, f"class.asked[{at}]", places, result, scene) for at, each in enumerate(table.asked))


def _item(
    asked: AskedTable, table: ClassTable, where: str, places: Mapping[str, int], result: RunResult, scene: Scene
) -> Item:
    try:
        found = one(parse(asked.result), result.results, scene)
    except UsageError as error:
        raise UsageError(error.message, where=where, remedy=error.remedy) from None
    unit = found.unit if asked.unit is None else asked.unit
    if unit != found.unit and (kind_of(unit) is None or kind_of(unit) != kind_of(found.unit)):
        rule = f"{asked.result} is in {found.unit or 'no unit'}, which is no {unit}"
        raise UsageError(rule, where=f"{where}.unit", remedy=f"write one like {found.unit}, or leave it out")
    within = _within(asked, unit, where)
    return _judged(f"{found.stage}.{found.quantity}", unit, within, asked, table, places)


def _within(asked: AskedTable, unit: str, where: str) -> float:
    try:
        return 0.0 if asked.within is None else in_unit(asked.within, unit)
    except UnitError as error:
        raise UsageError(str(error), where=f"{where}.within", remedy=f"write it in {unit}") from None


def _judged(
    result: str, unit: str, within: float, asked: AskedTable, table: ClassTable, places: Mapping[str, int]
) -> Item:
    """An item of this result, with names and tolerances as they stand in the spec."""
    after = dict(sorted((places[name.casefold()], power) for name, power in map(followed, asked.after)))
    return Item(
        asked.name or asked.result,
        tuple(asked.also),
        result,
        unit,
        float(asked.tolerance or table.tolerance),
        within,
        float(asked.plans or table.plans),
        float(asked.weight),
        asked.digits or table.digits,
        tuple(after),
        asked.either_sense,
        tuple(after.values()),
    )


def asked_now(table: ClassTable, items: Sequence[Item]) -> tuple[Item, ...]:
    """Items of keys with the names, tolerances and weights that the assignment has now; nothing is run.

    Raises UsageError where it asks for other results than the keys tell, or in other units.
    """
    if len(table.asked) != len(items):
        raise UsageError(f"{len(table.asked)} results are asked, the keys have {len(items)}", remedy=_AGAIN)
    places = _places(table)
    found = []
    for at, (asked, item) in enumerate(zip(table.asked, items, strict=True)):
        where, own, known = f"class.asked[{at}]", parse(asked.result), parse(item.result)
        same = own.quantity == known.quantity and own.stage in ("", ANY, known.stage)
        if not same or asked.unit not in (None, item.unit):
            rule = f"{asked.result} in {asked.unit or item.unit or 'no unit'} is asked"
            raise UsageError(
                f"{rule}, the keys have {item.result} in {item.unit or 'no unit'}", where=where, remedy=_AGAIN
            )
        found.append(_judged(item.result, item.unit, _within(asked, item.unit, where), asked, table, places))
    return tuple(found)


def _places(table: ClassTable) -> dict[str, int]:
    """The places of asked results by all their names."""
    return {
        name.casefold(): at for at, each in enumerate(table.asked) for name in (each.name or each.result, *each.also)
    }
