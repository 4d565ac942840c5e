"""Laws of motion in ``[cam]``: names of the catalogue, or tables of one's own."""

from typing import Annotated, Any

from pydantic import Field, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import core_schema

from tmmcalc.cams.laws.catalogue import NAMES
from tmmcalc.spec.choices import Known
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Number, Quantity
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError, parse


class Scaled(Reader):
    """A number to any scale, or a quantity of one of ``dimensions``."""

    def __init__(self, *dimensions: str) -> None:
        self.dimensions = dimensions

    def read(self, value: object) -> float:
        """Return the number, a quantity in SI; raise UnitError with the fault in plain words."""
        return parse(value, *self.dimensions) if isinstance(value, str) else Number("a number", "0.5").read(value)

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number, or a string of number and unit."""
        example = DIMENSIONS[self.dimensions[0]].example
        text = f'A number to any scale, or a string such as "{example}".'
        return {**Quantity(*self.dimensions).describe(), "description": text}


_PointOfMotion = Annotated[list[Annotated[float, Scaled("angle", "length")]], Field(min_length=2, max_length=2)]
_Coefficient = Annotated[float, Number("a coefficient", "10")]


class LawTable(Table):
    """A law of motion of one's own: by exactly one of these; only its shape counts, whatever its scale."""

    points: list[_PointOfMotion] | None = Field(
        default=None,
        min_length=2,
        description="Points `[k, s]` of the displacement, from 0 to the end of the phase: "
        "a smooth curve through them, at rest and without acceleration at both ends.",
    )
    acceleration: list[_PointOfMotion] | None = Field(
        default=None,
        min_length=2,
        description="Points `[k, a]` of the acceleration, straight lines between; a k that stands twice is a jump; "
        "the areas above and below zero are equal.",
    )
    polynomial: list[_Coefficient] | None = Field(
        default=None,
        min_length=3,
        max_length=30,
        description="Coefficients `[c0, c1, c2, ...]` of s = c0 + c1 k + c2 k^2 + ...",
    )
    file: str | None = Field(
        default=None,
        description="CSV file of points in two columns that go by their names, such as `k,s` or `phi[deg],s[mm]`, or "
        "accelerations `k,a`; without a header `k,s`. Its path counts from the folder of the spec.",
    )


class LawForm:
    """A law is a name of the catalogue, or a table."""

    KNOWN = Known("law of motion", NAMES)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_wrap_validator_function(self.read, handler(LawTable))

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {"anyOf": [self.KNOWN.describe(), handler(schema)]}

    def read(self, value: object, table: core_schema.ValidatorFunctionWrapHandler) -> Any:
        """Return the name, or the table of a law; raise UnitError for what is neither."""
        if isinstance(value, str):
            return self.KNOWN.read(value)
        if not isinstance(value, dict):
            raise UnitError(f"{show(value)} is no law of motion", 'write law = "sine", or { points = [[k, s], ...] }')
        return table(value)


Law = Annotated[str | LawTable, LawForm()]
