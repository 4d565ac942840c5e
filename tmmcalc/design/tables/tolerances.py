"""``[[tolerances]]``: how far dimensions may be from what the spec says, and the play of pairs."""

from typing import Annotated, Any

from pydantic import Field

from tmmcalc.design.tables.fits import is_class
from tmmcalc.design.tables.general import class_of
from tmmcalc.design.tables.key import Keys
from tmmcalc.spec.choices import Known, Listed
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Number, Quantity, Size
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError, dimension_of

MEASURED = ("sizes", "deviations")
DIRECTIONS = ("any", "force")
KINDS = ("normal", "uniform", "triangular", "measured")
EXAMPLES = '"0.1 mm", ["-0.02 mm", "0.05 mm"], "1 %", "h7", "IT7" or "ISO 2768-m"'


class Deviation(Reader):
    """A deviation from the nominal size: a number in SI, or one with a unit."""

    def read(self, value: object) -> float | str:
        """Return it as it is written; raise UnitError with the fault in plain words."""
        if isinstance(value, str) and dimension_of(value) is not None:
            return value
        if isinstance(value, int | float) and not isinstance(value, bool):
            return Number("a deviation", "1e-4").read(value)
        raise UnitError(f"{show(value)} is no deviation", 'write a number with its unit, such as "0.05 mm"')

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number or a text."""
        return {"anyOf": [{"type": "number"}, {"type": "string"}], "description": "A deviation."}


class Play(Reader):
    """A clearance, or the least and the largest of one."""

    def read(self, value: object) -> tuple[float, float]:
        """Return both ends [m]; raise UnitError with the fault in plain words."""
        size = Quantity("length", at_least_zero=True)
        low, high = value if isinstance(value, list) and len(value) == 2 else (value, value)
        least, largest = float(size.read(low)), float(size.read(high))
        if largest == 0 or least > largest:
            raise UnitError(
                f"{show(value)} is no clearance", 'write one above 0, "0.05 mm", or two: ["0.02 mm", "0.06 mm"]'
            )
        return least, largest

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a length, or two."""
        one = Quantity("length", at_least_zero=True).describe()
        both = {"type": "array", "items": one, "minItems": 2, "maxItems": 2}
        return {"anyOf": [one, both], "description": "A clearance, or the least and the largest."}


class Towards(Reader):
    """Where a pin rests: anywhere, where the force presses, or at an angle."""

    def read(self, value: object) -> float | str:
        """Return the word, or the angle [rad]; raise UnitError with the fault in plain words."""
        if value in DIRECTIONS:
            return str(value)
        try:
            return Quantity("angle").read(value)
        except UnitError:
            raise UnitError(f"{show(value)} is no direction", 'write "any", "force" or an angle, "90 deg"') from None

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a word or an angle."""
        return {"anyOf": [{"enum": [*DIRECTIONS]}, Quantity("angle").describe()], "description": "A direction."}


class Width(Reader):
    """A tolerance: to both sides, two deviations, a part of the size, or a class."""

    def read(self, value: object) -> Any:
        """Return it as it is written; raise UnitError with the fault in plain words."""
        if isinstance(value, list):
            if len(value) != 2:
                raise UnitError(f"{show(value)} is not two deviations", 'write ["-0.02 mm", "0.05 mm"]')
            return [Deviation().read(each) for each in value]
        if isinstance(value, str):
            if is_class(value) or class_of(value):
                return value
            if value.rstrip().endswith("%"):
                Number("a part of the size", '"1 %"', above=0).read(_percent(value))
                return value
        try:
            found = Deviation().read(value)
        except UnitError:
            raise UnitError(f"{show(value)} is no tolerance", f"write {EXAMPLES}") from None
        if str(found).lstrip().startswith("-") or found == 0:
            raise UnitError(f"{show(value)} to both sides is above 0", 'or write two deviations: ["-0.1 mm", 0]')
        return found

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number, a text, or two."""
        one = Deviation().describe()
        both = {"type": "array", "items": one, "minItems": 2, "maxItems": 2}
        return {"anyOf": [*one["anyOf"], both], "description": f"A tolerance: {EXAMPLES}."}


def _percent(text: str) -> object:
    """The number of a text in percent, or the text if it is none."""
    try:
        return float(text.rstrip().removesuffix("%"))
    except ValueError:
        return text


Tolerance = Annotated[Any, Width()]
Measured = Annotated[list[Any], Listed(Deviation(), '["-0.01 mm", "0.02 mm"]')]
Kind = Annotated[str, Known("distribution", KINDS)]
MeasuredAs = Annotated[str, Known("kind of measured values", MEASURED)]
Clearance = Annotated[Any, Play()]
Direction = Annotated[float | str, Towards()]
Correlation = Annotated[float, Number("a coefficient of correlation", "0.8", above=0, at_most=1)]


class ToleranceTable(Table):
    """The tolerance of one dimension or of several, or the clearance of a joint."""

    of: Keys = Field(
        default=[],
        description='Keys of the spec as in `--set`, `"mechanism.links[id=1].points.A[0]"`; `*` and `?` stand for any '
        'letters: `"mechanism.links[*].points.*"`. Keys are numbers of the spec: the length of a link that is given by '
        "coordinates is one of these.",
    )
    tolerance: Tolerance | None = Field(
        default=None,
        description='To both sides, `"0.1 mm"`; two deviations, `["-0.02 mm", "0.05 mm"]`; of the size, `"1 %"`; a '
        'class of ISO 286, `"h7"`, `"H8"`, `"IT7"` (evenly about the size); of ISO 2768, `"f"`, `"m"`, `"c"`, `"v"` or '
        '`"ISO 2768-m"`.',
    )
    side: Size | None = Field(
        default=None, description="Of an angle with a class of ISO 2768: the length of its shorter side."
    )
    distribution: Kind = Field(
        default="normal",
        description='`"normal"` (3 sigma at the ends of the tolerance), `"uniform"`, `"triangular"` or `"measured"`.',
    )
    measured: Measured | None = Field(
        default=None,
        description='Deviations that were measured, in place of a tolerance: `["-0.01 mm", "0.02 mm"]`.',
    )
    measurements: str | None = Field(
        default=None, description="CSV file of pieces that were measured, in place of a tolerance."
    )
    column: str = Field(default="", description="Its column, as its header has it, with or without `[unit]`.")
    measured_as: MeasuredAs = Field(
        default="sizes", description='Whether the file has `"sizes"` or `"deviations"` from what the spec says.'
    )
    alike: str = Field(
        default="",
        description="Name of a group of dimensions that are made alike, in one go: they vary together.",
    )
    correlation: Correlation = Field(
        default=1.0, description="Coefficient of correlation within the group `alike`; 1: entirely alike."
    )
    joint: str | None = Field(default=None, description="Joint that has play, in place of `of`.")
    clearance: Clearance | None = Field(
        default=None,
        description="Play of the joint: its pin or slider is half of it off. Of two, the least and the largest, it is "
        "between them by the distribution.",
    )
    direction: Direction = Field(
        default="any",
        description='Where a pin rests: `"any"`, all directions alike (of a slider: either side, each as often); '
        '`"force"`, where the reaction of the spec as it is presses when it is largest; or an angle in the axes of the '
        "link.",
    )
    link: int | None = Field(
        default=None, description="Link in whose axes the pin is moved (default: the first moving one of the joint)."
    )
