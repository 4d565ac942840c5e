"""The field types of quantities: numbers in SI, points, grades.

Each is ``Annotated`` with a reader that pydantic calls on the raw TOML value and that also describes the
value in JSON Schema: a number, or a string whose pattern lists the units of the dimension.
"""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field
from pydantic_core import core_schema

from tmmcalc.spec.dimensions import DIMENSIONS, UNITS
from tmmcalc.spec.phrases import either, nearest, show
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.units import LARGEST, LONGEST, UnitError, parse, unit_direction

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler

_NUMBER_PATTERN = r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?"
_QUOTIENT = rf"\s*(?P<above>{_NUMBER_PATTERN})\s*/\s*(?P<below>{_NUMBER_PATTERN})\s*"


class Quantity(Reader):
    """A number with a unit of one of ``dimensions``, or one of ``words`` that are allowed in its place."""

    def __init__(
        self, *dimensions: str, at_least_zero: bool = False, nonzero: bool = False, words: tuple[str, ...] = ()
    ) -> None:
        self.dimensions = dimensions
        self.at_least_zero = at_least_zero
        self.nonzero = nonzero
        self.words = words

    def read(self, value: object) -> float | str:
        """Return the value in SI; raise UnitError (a ValueError) with the fault in plain words."""
        if isinstance(value, str) and value in self.words:
            return value
        try:
            number = parse(value, *self.dimensions)
        except UnitError as fault:
            raise self._with_word(fault, value) from None
        if self.at_least_zero and number < 0:
            raise UnitError(f"{show(value)} is negative; {self._noun()} is at least 0", "write it without the minus")
        if self.nonzero and number == 0:
            raise UnitError(f"{show(value)} is zero; {self._noun()} other than 0 is needed here", self._example())
        return number

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number in SI or a string of number and unit."""
        number: dict[str, Any] = {"type": "number"}
        if self.at_least_zero:
            number["minimum"] = 0
        if self.nonzero:
            number["not"] = {"const": 0}
        si = either(DIMENSIONS[dimension].si for dimension in self.dimensions)
        kinds: list[dict[str, Any]] = [number, {"type": "string", "pattern": self._pattern()}]
        kinds += [{"const": word} for word in self.words]
        noun = self._noun().capitalize()
        example = DIMENSIONS[self.dimensions[0]].example
        return {"anyOf": kinds, "description": f'{noun}: a number in {si}, or a string such as "{example}".'}

    def _noun(self) -> str:
        return either(DIMENSIONS[dimension].noun for dimension in self.dimensions)

    def _example(self) -> str:
        examples = either(f'"{DIMENSIONS[dimension].example}"' for dimension in self.dimensions)
        return f"write {examples}, for example"

    def _with_word(self, fault: UnitError, value: object) -> UnitError:
        if not self.words:
            return fault
        close = nearest(value.strip(), self.words) if isinstance(value, str) else None
        if close:
            return UnitError(fault.message, f'did you mean "{close}"?')
        return UnitError(fault.message, f'{fault.remedy}, or "{self.words[0]}"')

    def _pattern(self) -> str:
        units = (unit for dimension in self.dimensions for unit in UNITS[dimension])
        number = _NUMBER_PATTERN.replace("[+-]?", "\\+?", 1) if self.at_least_zero else _NUMBER_PATTERN
        return rf"^\s*{number}\s*({'|'.join(_unit_pattern(unit) for unit in units)})\s*$"


class Number(Reader):
    """A number without a unit, within limits; a quotient in quotes such as ``"1/25"`` is one as well."""

    def __init__(
        self,
        noun: str,
        example: str,
        *,
        above: float = -math.inf,
        at_least: float = -math.inf,
        below: float = math.inf,
        at_most: float = math.inf,
    ) -> None:
        self.noun = noun
        self.example = example
        self.limits = {"above": above, "at least": at_least, "below": below, "at most": at_most}

    def read(self, value: object) -> float:
        """Return the number; raise UnitError with the fault in plain words."""
        number = self._number(value)
        above, at_least, below, at_most = self.limits.values()
        if not (above < number < below and at_least <= number <= at_most):
            limits = " and ".join(f"{word} {limit:g}" for word, limit in self._finite().items())
            raise UnitError(f"{show(value)} is out of range; {self.noun} is {limits}", self._advice())
        return number

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number within its limits, or a quotient."""
        words = {"above": "exclusiveMinimum", "at least": "minimum", "below": "exclusiveMaximum", "at most": "maximum"}
        number = {"type": "number", **{words[word]: limit for word, limit in self._finite().items()}}
        kinds = [number, {"type": "string", "pattern": rf"^\s*{_NUMBER_PATTERN}\s*/\s*{_NUMBER_PATTERN}\s*$"}]
        return {"anyOf": kinds, "description": f'{self.noun.capitalize()}: a number, or a quotient such as "1/25".'}

    def _number(self, value: object) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise UnitError(f"{show(value)} is not {self.noun}", self._advice())
        text = value if isinstance(value, str) and len(value) <= LONGEST else ""
        parts = re.fullmatch(_QUOTIENT, text, re.ASCII)
        if isinstance(value, str) and (parts is None or float(parts["below"]) == 0):
            raise UnitError(f"{show(value)} is not {self.noun}", f"{self._advice()}; it has no quotes and no unit")
        number = float(parts["above"]) / float(parts["below"]) if parts else value
        if isinstance(number, str) or not (number == 0 or 1 / LARGEST <= abs(number) <= LARGEST):
            raise UnitError(f"{show(value)} is not a finite number of ordinary size", self._advice())
        return float(number)

    def _finite(self) -> dict[str, float]:
        return {word: limit for word, limit in self.limits.items() if math.isfinite(limit)}

    def _advice(self) -> str:
        return f"write a number, such as {self.example}"


class Bound(Number):
    """A number in the unit of its quantity; a text, which has a unit of its own, is read with the quantity."""

    def read(self, value: object) -> Any:
        """Return the number, or the text; raise UnitError with the fault in plain words."""
        return value if isinstance(value, str) else super().read(value)

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number or a text."""
        return {"anyOf": [{"type": "number"}, {"type": "string"}], "description": f"{self.noun.capitalize()}."}


class PolarForm:
    """A point may also be a table ``{ length, angle }``: its distance from the origin and its direction."""

    EXAMPLE = '{ length = "60 mm", angle = "30 deg" }'

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_before_validator_function(self.cartesian, handler(source))

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        polar = {
            "type": "object",
            "properties": {"length": Quantity("length").describe(), "angle": Quantity("angle").describe()},
            "required": ["length", "angle"],
            "additionalProperties": False,
        }
        return {"anyOf": [handler(schema), polar]}

    def cartesian(self, value: object) -> object:
        """Return [x, y] of a polar table, any other value as it is; raise UnitError with the fault."""
        if not isinstance(value, dict):
            return value
        if value.keys() != {"length", "angle"}:
            raise UnitError(f"{show(value)} is not a point", f"write [x, y] or {self.EXAMPLE}")
        place = parse(value["length"], "length") * unit_direction(parse(value["angle"], "angle"))
        return [place.real, place.imag]


class QualityGrade(Reader):
    """A balance quality grade in mm/s: ``"G6.3"``, or its number."""

    PATTERN = r"\s*G\s*([0-9]+\.?[0-9]*|\.[0-9]+)\s*"

    def read(self, value: object) -> float:
        """Return the number of the grade; raise UnitError if the value is none."""
        text = value if isinstance(value, str) and len(value) <= LONGEST else ""
        match = re.fullmatch(self.PATTERN, text, re.ASCII)
        number = float(match[1]) if match else value
        if isinstance(number, bool) or not isinstance(number, int | float):
            raise UnitError(f"{show(value)} is not a balance quality grade", 'write "G6.3", or 6.3')
        if not 1e-3 <= number <= 1e6:
            raise UnitError(f"{show(value)} is no grade: the usual ones are from G0.4 to G4000", 'write "G6.3", or 6.3')
        return float(number)

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number, or G and a number."""
        kinds = [{"type": "number", "exclusiveMinimum": 0}, {"type": "string", "pattern": f"^{self.PATTERN}$"}]
        return {"anyOf": kinds, "description": 'Balance quality grade: "G6.3", or its number in mm/s.'}


def _unit_pattern(unit: str) -> str:
    """Return a regex of one unit that takes ``·`` and the raised digits as well."""
    # A unit that begins with a digit (1/s) keeps its distance from the number.
    gap = r"\s" if unit[0].isdigit() else ""
    return gap + re.escape(unit).replace(r"\*", "[*·]").replace(r"\^2", "(\\^2|²)").replace(r"\^3", "(\\^3|³)")


Length = Annotated[float, Quantity("length")]
Angle = Annotated[float, Quantity("angle")]
Gravity = Annotated[float, Quantity("acceleration", at_least_zero=True)]
Distance = Annotated[float, Quantity("length", at_least_zero=True)]
Size = Annotated[float, Quantity("length", at_least_zero=True, nonzero=True)]
AngularSpeed = Annotated[float, Quantity("angular speed", at_least_zero=True, nonzero=True)]
Mass = Annotated[float, Quantity("mass", at_least_zero=True)]
Inertia = Annotated[float, Quantity("inertia", at_least_zero=True)]

InputCoordinate = Annotated[float, Quantity("angle", "length")]
InputDistance = Annotated[float, Quantity("angle", "length", at_least_zero=True)]
InputSpan = Annotated[float, Quantity("angle", "length", at_least_zero=True, nonzero=True)]
InputStart = Annotated[float | Literal["extreme"], Quantity("angle", "length", words=("extreme",))]
# words for a mean speed that is found when the spec is loaded, the second for a crank that turns clockwise
BY_MOTOR, CLOCKWISE = "by the motor", "by the motor, clockwise"
InputSpeed = Annotated[float, Quantity("angular speed", "speed", nonzero=True, words=(BY_MOTOR, CLOCKWISE))]
ShaftSpeed = Annotated[float, Quantity("angular speed", at_least_zero=True, nonzero=True, words=(BY_MOTOR,))]
InputAcceleration = Annotated[float, Quantity("angular acceleration", "acceleration")]

Ratio = Annotated[float, Number("a ratio", "26.4", above=0)]
Friction = Annotated[float, Number("a coefficient of friction", "0.1", at_least=0, at_most=5)]
Force = Annotated[float, Quantity("force")]
Moment = Annotated[float, Quantity("moment")]

Limit = Annotated[float | str, Bound("a limit", '350, or "350 mm"')]  # of a quantity that is known elsewhere
Grade = Annotated[float, QualityGrade()]

# Lists of fixed length, not tuples: tuples become prefixItems, which common TOML editors do not follow.
Point = Annotated[list[Length], Field(min_length=2, max_length=2), PolarForm()]
LinkPair = Annotated[list[Annotated[int, Field(ge=0)]], Field(min_length=2, max_length=2)]
