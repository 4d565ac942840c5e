"""``[[constraints]]``: what the results of stages, or given values, must keep."""

import re
from keyword import iskeyword
from typing import Annotated, Any

from pydantic import Field, model_validator

from tmmcalc.core.errors import UsageError
from tmmcalc.naming.language import ANY, OF, ROWS, is_name, parse
from tmmcalc.spec.choices import Known
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Bound, Limit, Number
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


ConstraintName = Annotated[str, RuleName()]
What = Annotated[str, Known("what of a column", tuple(of for of in OF if of != "chosen"))]
Value = Annotated[float | str, Bound("a value", '0.35, or "35 deg"')]
Function = Annotated[float, Number("a signed value", "0.3")]


class ConstraintTable(Table):
    """A named inequality on a result or on a given value, or a truth that is given."""

    name: ConstraintName = Field(description="Its name in the rule and in messages: letters, digits, `_`.")
    stage: str | None = Field(
        default=None,
        description='Stage whose result it is on: `"kinematics"`, `"forces"`, `"cam_optimum"`, ...; without one '
        "`value` is a name with its stage, or `value`, `function` or `holds` is given.",
    )
    value: Value | None = Field(
        default=None,
        description='A result by its name ("Names of results"): `"stroke_D"` of the stage, `"forces.max(R_A)@2..12"` '
        "without `stage`, whose name begins it or is the only one that tells it. Or, without `stage`, the value "
        'itself: a number, or one with a unit, `"35 deg"`.',
    )
    column: str | None = Field(
        default=None, description='Or a column of the stage\'s table, without the unit: `"R_A"` (docs/files.md).'
    )
    of: What = Field(
        default="max",
        description='What of the column: `"max"`, `"min"`, `"range"`, `"mean"`, `"size"` (largest magnitude), '
        '`"first"`, `"last"`, `"rms"`, `"integral"`, or where: `"at_max"`, `"at_min"`, `"at_size"`.',
    )
    at_least: Limit | None = Field(
        default=None,
        description="Lower limit: a number in the unit of the quantity, or one with a unit; "
        "one of the two limits, or both.",
    )
    at_most: Limit | None = Field(
        default=None, description="Upper limit: a number in the unit of the quantity, or one with a unit."
    )
    function: Function | None = Field(
        default=None,
        description="Without `stage`: a given number that is not negative where the constraint holds, in place of a "
        "value and its limits.",
    )
    holds: bool | None = Field(
        default=None,
        description="Without `stage`: whether the constraint holds, `true` or `false`; its function is 1 or -1.",
    )

    @model_validator(mode="before")
    @classmethod
    def _named(cls, data: Any) -> Any:
        """A name taken apart: its stage, and the column if no more is named; one that is none is told by the checks."""
        if not isinstance(data, dict) or not is_name(data.get("value")) or "column" in data:
            return data
        try:
            name = parse(data["value"] if "stage" not in data else f"{data['stage']}.{data['value']}")
        except UsageError:
            return data
        rest = {**data, "stage": data.get("stage", name.stage or ANY)}
        if name.place is None and name.of and (name.of == "chosen" or rest["stage"] not in ROWS):
            return {**{key: value for key, value in rest.items() if key != "value"}, "column": name.what, "of": name.of}
        return {**rest, "value": name._replace(stage="", unit=None).text}
