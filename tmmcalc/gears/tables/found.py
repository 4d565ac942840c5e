"""What the stages of gears found as keys of ``[train]``."""

from __future__ import annotations

from itertools import islice
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.report.rows import check_choice
from tmmcalc.spec.rewrite import Change, Found

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tmmcalc.gears.model import ToothSets
    from tmmcalc.gears.room import GearTables
    from tmmcalc.gears.selection.results import Selection
    from tmmcalc.gears.trains import Trains


def of_train(spec: GearTables, result: Trains, choose: int | None = None) -> Found:
    """Row ``choose``, from 1, of all tooth sets; raises `UsageError` if it is not said which of several is meant."""
    count = sum(len(variant.sets) for variant in result.variants)
    if choose is None and count > 1:
        rule = f"there are {count} tooth sets, and none is better by itself"
        raise UsageError(
            rule,
            where="--spec",
            remedy="add --choose N, the row i of the table; gears compare chooses by mass, inertia or size",
        )
    number = choose or 1
    check_choice(number, count, "row")
    rows = ((variant.sets, row) for variant in result.variants for row in range(len(variant.sets)))
    sets, row = next(islice(rows, number - 1, None))
    return _found(spec, sets, row, f"tooth set {number} of {count}")


def of_criteria(spec: GearTables, result: Selection, choose: int | None = None) -> Found:
    """The best train, or row ``choose``, from 1, of all trains; raises `UsageError` if there is no such row."""
    pool = result.pool
    place = result.winner.place if choose is None else choose - 1
    check_choice(place + 1, len(pool), "row")
    sets = result.variants[int(pool.variant[place])].sets
    which = f"by {result.choose}" if choose is None else "by --choose"
    return _found(spec, sets, int(pool.row[place]), f"train {place + 1} of {len(pool)}, {which}")


def _found(spec: GearTables, sets: ToothSets, row: int, which: str) -> Found:
    return Found(tuple(_keys(spec, sets, row)), of=which)


def _keys(spec: GearTables, sets: ToothSets, row: int) -> Iterator[Change]:
    """Layout, teeth, planets and proportion of the modules; what only other layouts or other rows use goes."""
    from tmmcalc.gears.tables.checks.train import useless

    assert spec.train is not None
    scheme = sets.scheme
    yield Change(("train", "layout"), scheme.key)
    yield Change(("train", "teeth"), sets.teeth[row].tolist())
    if scheme.branched:
        yield Change(("train", "planets"), sets.planets)
    if scheme.branched and scheme.stages > 1 and spec.train.modules is None:
        yield Change(("train", "module_ratios"), [sets.modules[row].tolist()])
        yield Change(("train", "module_ratio_range"))
    yield from (Change(("train", *key)) for key in useless(scheme))
    if spec.criteria is not None:
        yield Change(("criteria", "series"))  # what two trains in its place would do is a search of its own
        if isinstance(spec.criteria.choose, int):
            yield Change(("criteria", "choose"))
