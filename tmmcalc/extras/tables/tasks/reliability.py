"""From ``[reliability]`` to the product, its loads and what is known of its life."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.extras.reliability import ReliabilityTask
    from tmmcalc.extras.room import ExtraTables


def to_reliability(spec: ExtraTables) -> ReliabilityTask:
    """The product of the spec; raises `UsageError` if it has none."""
    from tmmcalc.extras.reliability import LifeTest, ReliabilityTask, load_range

    table = spec.reliability
    if table is None:
        raise UsageError(
            "the spec has no [reliability]",
            remedy="add [reliability] with load, rate, and strength with decay or a test",
        )
    low, high = table.load if table.load is not None else load_range(tuple(table.readings or ()))
    test = None
    if table.items is not None and table.least_life is not None and table.mean_life is not None:
        test = LifeTest(table.items, table.least_life, table.mean_life)
    return ReliabilityTask(
        low=max(low, 0.0),
        high=high,
        rate=table.rate,
        strength=table.strength,
        decay=table.decay,
        test=test,
        times=tuple(table.times),
        until=table.until,
        rows=table.rows,
    )
