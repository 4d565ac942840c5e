"""Stage ``train``: the tooth numbers of the gear train, one variant a layout and number of planets."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.records import record
from tmmcalc.core.stage import Record, Table
from tmmcalc.feasibility.tables.tasks.kept_rows import kept_rows
from tmmcalc.gears.train import Request, Trains

if TYPE_CHECKING:
    from tmmcalc.feasibility.judge import FeasibilityTask
    from tmmcalc.project import Spec


@record
class Asked:
    """What is asked of every layout, and the user's constraints on tooth sets, if there are any."""

    requests: tuple[Request, ...]
    kept: FeasibilityTask | None = None


def inputs(spec: Spec) -> Asked:
    """What is asked of every layout: ratios, limits and tolerances as exact fractions; constraints on tooth sets."""
    from tmmcalc.gears.tables.tasks.train import to_train

    return Asked(to_train(spec), kept_rows(spec, "train"))


def solve(given: Asked, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Trains:
    """All tooth sets of every variant that keep the user's constraints."""
    from tmmcalc.core.progress import tell
    from tmmcalc.gears.train import solve_train

    found = solve_train(given.requests, tell)
    if given.kept is None:
        return found
    from tmmcalc.gears.kept import kept_sets

    return kept_sets(found, given.kept)


def dump(result: Trains) -> Record:
    """Arrays by the names of the fields, those of the first variant under ``variants.0.``; ratios are exact."""
    return to_record(result, {"ratio": 0.0, "angles": max(variant.error for variant in result.variants)})


def load(record: Record) -> Trains:
    """Build the result from its record."""
    result: Trains = from_record(Trains, record)
    return result


def table(result: Trains) -> Table:
    """All sets that are held, one row a set, one variant after the other."""
    from tmmcalc.gears.columns import stacked

    columns = stacked(result)
    return Table(list(columns), list(columns.values()))
