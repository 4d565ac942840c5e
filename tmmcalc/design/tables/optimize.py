"""``[optimize]``: what is sought, and what may be changed for it."""

from typing import Annotated, Any

from pydantic import Field

from tmmcalc.design.tables.key import Keys, Results
from tmmcalc.spec.choices import Listed, Whole
from tmmcalc.spec.quantities import Bound, Limit
from tmmcalc.spec.table import Table

Values = Annotated[list[Any], Listed(Bound("a value", '"2.5 mm"'), '["2 mm", "2.5 mm", "3 mm"]')]
Seed = Annotated[int, Whole("a seed", 0, 2**31 - 1)]
Count = Annotated[int, Whole("a number of evaluations", 100, 10_000_000)]
Designs = Annotated[int, Whole("a number of designs", 3, 1000)]


class VariableTable(Table):
    """A number that may be changed: between two limits, in steps or not, or among values."""

    of: Keys = Field(
        description='Its key as in `--set`, `"mechanism.links[id=1].points.A[0]"`; several keys get the same value.'
    )
    at_least: Limit | None = Field(default=None, description="The least value, in the unit of the key or in its own.")
    at_most: Limit | None = Field(default=None, description="The greatest value.")
    step: Limit | None = Field(
        default=None,
        description='Steps from `at_least` in which it goes: `"5 mm"`, or `1` for whole numbers (default: any value; '
        "of a key that takes whole numbers alone, 1).",
    )
    among: Values | None = Field(
        default=None, description='Or the values that there are, such as those of a catalogue: `["2 mm", "2.5 mm"]`.'
    )


class OptimizeTable(Table):
    """The search for the best design: its variables, and the results that are to be least or greatest.

    Designs keep all `[[constraints]]` by the rule of `[feasibility]`. Several results give the front of designs of
    which none is better in all (Pareto).
    """

    least: Results = Field(default=[], description='Results that are to be least, by name: `"paths.deviation_sum_C"`.')
    greatest: Results = Field(default=[], description="Results that are to be greatest.")
    variables: list[VariableTable] = Field(min_length=1, max_length=60, description="What may be changed.")
    seed: Seed = Field(default=1, description="Of the search: the same seed finds the same.")
    evaluations: Count | None = Field(
        default=None,
        description="Designs that the evolution may solve (default: 2000 a variable); local searches after it, and the "
        "second method, take up to as many each.",
    )
    designs: Designs = Field(default=25, description="Designs of the front that are told.")
