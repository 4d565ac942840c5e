"""A coefficient of the calculation with the place that it is taken from."""

from __future__ import annotations

from tmmcalc.core.records import record


@record
class Coefficient:
    """A number of the calculation: every one can be shown with its origin."""

    of: str  # what it belongs to, such as "wheel 2'", "stage 1", "mesh 1-2"
    symbol: str  # of the textbook
    value: float
    unit: str  # SI; "-" without dimension
    source: str  # table and row, formula, or "given"
