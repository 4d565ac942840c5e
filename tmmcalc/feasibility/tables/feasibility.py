"""``[feasibility]``: how the constraints are combined."""

from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Known, Whole
from tmmcalc.spec.table import Table

FormName = Annotated[str, Known("form of the function", ("minmax", "R0", "Rm"))]
Smoothness = Annotated[int, Whole("an order of smoothness", 1, 9)]


class FeasibilityTable(Table):
    """How the constraints are combined."""

    rule: str = Field(
        default="",
        description='Names of constraints with `and`, `or`, `not` and brackets: `"stroke and (light or not swift)"` '
        "(default: all must hold).",
    )
    form: FormName = Field(
        default="minmax",
        description='Function of the rule for searches, f >= 0 where it holds: `"minmax"`, or a smooth one, `"R0"` '
        'or `"Rm"`.',
    )
    smoothness: Smoothness = Field(default=1, description='Order m of `"Rm"`.')
