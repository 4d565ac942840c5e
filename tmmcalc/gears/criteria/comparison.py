"""Comparison of several solutions of one task: numbers of planets, layouts, one train against two in series.

Every option is a list of variants with their criteria; each is represented by its best variant.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.choice import least
from tmmcalc.gears.criteria.objectives import OBJECTIVES, Measured

Option = TypeVar("Option", int, str)


@record
class Best:
    """The best variant of an option."""

    option: int | str  # number of planets, or name
    count: int  # variants
    index: int | None  # of the best one; None: there is no variant
    values: dict[str, float]  # of all criteria


@record
class Comparison:
    """Options by one criterion."""

    criterion: str
    options: tuple[Best, ...]  # in the order given
    winner: int | str
    value: float
    runner_up: int | str | None  # None: no other option has a variant
    runner_up_value: float | None


def compare(options: Mapping[Option, Measured], criterion: str) -> Comparison:
    """The best of several options by a criterion, each by its own best variant.

    Raises `NoSolutionError` if no option has a variant.
    """
    found = tuple(_best(name, measured, criterion) for name, measured in options.items())
    sign = -1 if OBJECTIVES[criterion].largest else 1
    able = sorted((each for each in found if each.index is not None), key=lambda each: sign * each.values[criterion])
    if not able:
        raise NoSolutionError("no option has a variant", where="comparison", value=0.0, remedy="widen the synthesis")
    second = able[1] if len(able) > 1 else None
    return Comparison(
        criterion,
        found,
        able[0].option,
        able[0].values[criterion],
        None if second is None else second.option,
        None if second is None else second.values[criterion],
    )


def _best(option: int | str, measured: Measured, criterion: str) -> Best:
    count = len(measured.mass)
    if not count:
        return Best(option, 0, None, {})
    index = least(measured, criterion).winner
    return Best(option, count, index, {key: float(getattr(measured, key)[index]) for key in OBJECTIVES})
