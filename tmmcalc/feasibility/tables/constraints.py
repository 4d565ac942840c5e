"""``[[constraints]]``: what the results of stages must keep."""

import re
from keyword import iskeyword
from typing import Annotated, Any

from pydantic import Field

from tmmcalc.spec.choices import Known
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError


class RuleName(Reader):
    """A name that a rule can call: a Latin letter or ``_``, then letters, digits, ``_``; no word of its grammar."""

    PATTERN = "[A-Za-z_][A-Za-z0-9_]*"

    def read(self, value: object) -> str:
        """Return the name; raise UnitError with the fault in plain words."""
        if not isinstance(value, str) or not re.fullmatch(self.PATTERN, value):
            rule = "a name is a Latin letter or _, then letters, digits or _"
            raise UnitError(f"{show(value)} cannot name a constraint", f'{rule}: "calm"')
        if iskeyword(value):
            raise UnitError(f"{show(value)} cannot name a constraint: rules keep this word", "choose another name")
        return value

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema of a name."""
        return {"type": "string", "pattern": f"^{self.PATTERN}$", "description": "Name of a constraint."}


class Bound(Number):
    """A number in the unit of its quantity; a text, which has a unit of its own, is read with the quantity."""

    def read(self, value: object) -> Any:
        """Return the number, or the text; raise UnitError with the fault in plain words."""
        return value if isinstance(value, str) else super().read(value)

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number or a text."""
        return {"anyOf": [{"type": "number"}, {"type": "string"}], "description": "A limit."}


ConstraintName = Annotated[str, RuleName()]
What = Annotated[str, Known("what of a column", ("max", "min", "range", "mean", "size", "first", "last"))]
Limit = Annotated[float | str, Bound("a limit", '350, or "350 mm"')]


class ConstraintTable(Table):
    """A named inequality on a result."""

    name: ConstraintName = Field(description="Its name in the rule and in messages: letters, digits, `_`.")
    stage: str = Field(description='Stage whose result it is on: `"kinematics"`, `"forces"`, `"cam_optimum"`, ...')
    value: str | None = Field(
        default=None,
        description='A fact of the stage\'s summary by its name in `--format json`, without the unit: `"stroke_D"`; '
        "a nested one with a dot.",
    )
    column: str | None = Field(
        default=None, description='Or a column of the stage\'s table, without the unit: `"R_A"` (docs/files.md).'
    )
    of: What = Field(
        default="max",
        description='What of the column: `"max"`, `"min"`, `"range"`, `"mean"`, `"size"` (largest magnitude), '
        '`"first"`, `"last"`.',
    )
    at_least: Limit | None = Field(
        default=None,
        description="Lower limit: a number in the unit of the quantity, or one with a unit; "
        "one of the two limits, or both.",
    )
    at_most: Limit | None = Field(
        default=None, description="Upper limit: a number in the unit of the quantity, or one with a unit."
    )
