"""The law of one step in ``[indexing]``: a name of the catalogue, a code 00ee, or a table."""

import re
from typing import Annotated, Any

from pydantic import Field, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import core_schema

from tmmcalc.cams.laws.catalogue import NAMES
from tmmcalc.cams.tables.cam_law import LawForm, LawTable
from tmmcalc.spec.choices import Known
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.units import UnitError

CODE = re.compile("00([0-4][0-9]|50)")

Part = Annotated[float, Number("a part of the step", "0.1", at_least=0, at_most=0.5)]
Peak = Annotated[float, Number("the largest s' of a law", "1.625", at_least=1, at_most=100)]


class StepLawTable(LawTable):
    """A law of one's own, by exactly one of these; only its shape counts, whatever its scale."""

    constant_ends: Part | None = Field(
        default=None,
        description="Part e of the time, 0 to 0.5, at each end over which the acceleration is constant, a straight "
        "line between: `law = { constant_ends = 0.125 }`.",
    )
    peak_velocity: Peak | None = Field(
        default=None,
        description="B = s'(1/2) alone, the largest s', of a law that is not known: limits and sizes without profiles.",
    )


class LawName(Known):
    """A name of the catalogue, or a code 00ee."""

    def read(self, value: object) -> str:
        """Return the name; raise UnitError with the nearest known one."""
        if isinstance(value, str) and CODE.fullmatch(value):
            return value
        try:
            return super().read(value)
        except UnitError as fault:
            raise UnitError(fault.message, f"{fault.remedy}; or a code 0000 to 0050, such as 0010") from None

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: one of the words, or a code."""
        found = super().describe()
        return {"anyOf": [found, {"type": "string", "pattern": f"^{CODE.pattern}$"}], "description": "A law of motion."}


class StepLawForm(LawForm):
    """A law is a name, a code, or a table."""

    KNOWN = LawName("law of motion", NAMES)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_wrap_validator_function(self.read, handler(StepLawTable))

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {"anyOf": [self.KNOWN.describe(), handler(schema)]}


StepLaw = Annotated[str | StepLawTable, StepLawForm()]
