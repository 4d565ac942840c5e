"""Stage ``train``: the tooth numbers of the gear train, one variant a layout and number of planets."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.gears.train import Request, Trains
from tmmcalc.pipeline.stage import Record, Table
from tmmcalc.stages.conversion import from_record, to_record

if TYPE_CHECKING:
    from tmmcalc.spec import Spec


def inputs(spec: Spec) -> tuple[Request, ...]:
    """What is asked of every layout: ratios, limits and tolerances as exact fractions."""
    from tmmcalc.spec.synthesis import to_train

    return to_train(spec)


def solve(given: tuple[Request, ...], upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Trains:
    """All tooth sets of every variant."""
    from tmmcalc.gears.train import solve_train
    from tmmcalc.progress import tell

    return solve_train(given, tell)


def dump(result: Trains) -> Record:
    """Arrays by the names of the fields, those of the first variant under ``variants.0.``."""
    return to_record(result)


def load(record: Record) -> Trains:
    """Build the result from its record."""
    result: Trains = from_record(Trains, record)
    return result


def table(result: Trains) -> Table:
    """All sets that are held, one row a set, one variant after the other."""
    from tmmcalc.gears.columns import stacked

    columns = stacked(result)
    return Table(list(columns), list(columns.values()))
