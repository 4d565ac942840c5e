"""``[strength]``: the torque on a gear train, the materials of its wheels, and how modules and widths are rounded."""

from typing import Annotated, Any, Literal

from pydantic import Field

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Number, Quantity, Ratio
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError

MOST_STAGES = 3
ROWS = 7  # of Table D.4.1


class HardnessForm(Reader):
    """A hardness: ``"300 HB"``, or ``{ value = 300, scale = "HB" }``."""

    PATTERN = r"^\s*(([0-9.]+\s*(HB|HRC|HV))|((HB|HRC|HV)\s*[0-9.]+))\s*$"

    def read(self, value: object) -> str:
        """Return the hardness as "300 HB"; raise UnitError with the fault in plain words."""
        from tmmcalc.gears.strength.material import Hardness, parse_hardness

        example = 'write "300 HB", "52 HRC" or "750 HV"'
        try:
            if isinstance(value, str):
                return str(parse_hardness(value))
            if isinstance(value, dict) and value.keys() == {"value", "scale"}:
                number = Number("a hardness", "300").read(value["value"])
                return str(Hardness(number, value["scale"]))
        except UsageError as error:
            raise UnitError(error.message, error.remedy) from None
        raise UnitError(f"{show(value)} is not a hardness: it has a number and a scale", example)

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a text of number and scale, or both in a table."""
        table = {
            "type": "object",
            "properties": {
                "value": {"type": "number", "description": "The number."},
                "scale": {"enum": ["HB", "HRC", "HV"], "description": "Its scale."},
            },
            "required": ["value", "scale"],
            "additionalProperties": False,
        }
        kinds = [{"type": "string", "pattern": self.PATTERN}, table]
        return {"anyOf": kinds, "description": 'Hardness: a number and its scale, such as "300 HB" or "52 HRC".'}


class RowForm(Reader):
    """A row of Table D.4.1."""

    def read(self, value: object) -> int:
        """Return the number of the row; raise UnitError with the fault in plain words."""
        if isinstance(value, int) and not isinstance(value, bool) and 1 <= value <= ROWS:
            return value
        raise UnitError(f"{show(value)} is not a row of Table D.4.1", f"write a row from 1 to {ROWS}, such as 3")

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a whole number."""
        return {"type": "integer", "minimum": 1, "maximum": ROWS}


class PerStage(Reader):
    """One value for all stages, or a list with one for each."""

    def __init__(self, of: Quantity | Number | RowForm) -> None:
        self.of = of

    def read(self, value: object) -> list[Any]:
        """Return the values; raise UnitError with the first fault."""
        if not isinstance(value, list):
            return [self.of.read(value)]
        if not 1 <= len(value) <= MOST_STAGES:
            what = f"{show(value)} has {len(value)} values; a train has up to {MOST_STAGES} stages"
            raise UnitError(what, "write one value for all stages, or a list with one for each")
        return [self.of.read(item) for item in value]

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a value or a list of them."""
        one = self.of.describe()
        return {"anyOf": [one, {"type": "array", "items": one, "minItems": 1, "maxItems": MOST_STAGES}]}


Torque = Annotated[float, Quantity("moment", at_least_zero=True, nonzero=True)]
LargestMoment = Annotated[float, Quantity("moment", nonzero=True)]
Stress = Annotated[float, Quantity("pressure", at_least_zero=True, nonzero=True)]
HardnessText = Annotated[str, HardnessForm()]
Underrun = Annotated[float, Number("an underrun", "0.005", at_least=0, at_most=0.05)]
_SIZE = Quantity("length", at_least_zero=True, nonzero=True)
Sizes = Annotated[list[float], PerStage(_SIZE)]
Stresses = Annotated[list[float], PerStage(Quantity("pressure", at_least_zero=True, nonzero=True))]
WidthCoefficients = Annotated[
    list[float], PerStage(Number("a face-width coefficient psi_bd", "0.9", above=0, at_most=2))
]
Rows = Annotated[list[int], PerStage(RowForm())]


class MaterialTable(Table):
    """The steel of a wheel, its treatment and its service."""

    steel: str | None = Field(default=None, description='Designation, such as `"40Kh"`, in Latin or Cyrillic letters.')
    treatment: (
        Literal[
            "annealed",
            "normalised",
            "improved",
            "through-hardened",
            "surface-hardened",
            "fillet-hardened",
            "carburised",
            "nitrocarburised",
            "nitrided",
        ]
        | None
    ) = Field(
        default=None,
        description='Heat treatment of the teeth: `"annealed"`, `"normalised"`, `"improved"`, `"through-hardened"`, '
        '`"surface-hardened"`, `"fillet-hardened"`, `"carburised"`, `"nitrocarburised"`, `"nitrided"`.',
    )
    hardness: HardnessText | None = Field(
        default=None,
        description='Hardness of the tooth surface: `"300 HB"`, `"52 HRC"`, or `{ value = 750, scale = "HV" }`.',
    )
    core: HardnessText | None = Field(
        default=None, description='Hardness of the core of nitrided teeth in HRC, such as `"30 HRC"`.'
    )
    protected: bool = Field(
        default=False, description="Whether measures are taken against decarburisation of the surface."
    )
    structure: Literal["homogeneous", "surface-strengthened"] | None = Field(
        default=None,
        description='Structure of the tooth: `"homogeneous"` or `"surface-strengthened"` (default: by the treatment).',
    )
    failure: Literal["ordinary", "severe"] = Field(
        default="ordinary", description='Consequences of a failure: `"ordinary"` or `"severe"`.'
    )
    blank: Literal["forging", "rolled", "casting"] = Field(
        default="forging", description='Blank of the wheel: `"forging"`, `"rolled"` or `"casting"`.'
    )
    wear: Literal["none", "abrasive"] = Field(
        default="none", description='Wear of the teeth: `"none"` or `"abrasive"`.'
    )
    load: Literal["one-sided", "two-sided"] | None = Field(
        default=None,
        description='Sides of the teeth that bear load, `"one-sided"` or `"two-sided"` (default: '
        'planets of a planetary train `"two-sided"`, else `"one-sided"`).',
    )
    row: str | None = Field(
        default=None, description='Row of Table D.4.3, such as `"h2"`, for a steel similar to those that it names.'
    )
    contact_limit: Stress | None = Field(default=None, description="Contact endurance limit (default: of the tables).")
    bending_limit: Stress | None = Field(default=None, description="Bending endurance limit (default: of the tables).")


class StrengthTable(Table):
    """Modules and face widths of a train by the endurance of its teeth, or the stresses at given ones."""

    torque: Torque | None = Field(
        default=None, description="T1: torque on wheel 1, of all planets or layshafts together."
    )
    moment: LargestMoment | None = Field(
        default=None,
        description="Or the largest reduced moment that the train has to overcome; "
        "T1 = `moment` / `moment_ratio` (default: that of `reduction`).",
    )
    moment_ratio: Ratio | None = Field(
        default=None,
        description="Speed of wheel 1 over that of the shaft to which the moment is reduced, the crank; "
        "another one says that a gear stands between the train's output shaft and the crank (default: "
        "that of the train, times that of `[open_pair]`).",
    )
    material: MaterialTable | None = Field(
        default=None, description="Material of all wheels; or `pinion` and `wheel` apart."
    )
    pinion: MaterialTable | None = Field(default=None, description="Material of the pinions, in place of `material`.")
    wheel: MaterialTable | None = Field(
        default=None, description="Material of the other wheels, in place of `material` (default: as pinions)."
    )
    permissible_contact: Stresses | None = Field(
        default=None, description="sigma_HP: permissible contact stress of each stage (default: of the materials)."
    )
    permissible_bending: Stresses | None = Field(
        default=None, description="sigma_FP: permissible bending stress of each stage (default: of the materials)."
    )
    face_width: WidthCoefficients | None = Field(
        default=None,
        description="psi_bd: face width over pinion diameter of each stage (default: middle of Table D.4.2).",
    )
    arrangement: Rows | None = Field(
        default=None, description="Row of Table D.4.1, 1 to 7, of each stage (default: by the layout)."
    )
    module: Sizes | None = Field(default=None, description="Given modules of the stages, which are checked.")
    width: Sizes | None = Field(default=None, description="Face widths of the given modules.")
    modules_row: Literal[1, 2] | None = Field(
        default=None, description="Standard modules: of both rows, 2, or 1: of the preferred row only (default: 2)."
    )
    underrun: Underrun | None = Field(
        default=None, description="Part by which a standard module may be too small (default: 0)."
    )
    face_width_rule: Literal["consistent", "book1992"] | None = Field(
        default=None,
        description='`"consistent"`: the width that keeps the strength; `"book1992"`: '
        'as the textbook\'s program has it (default: `"consistent"`).',
    )
    rounding: Literal["ceil", "floor1"] | None = Field(
        default=None, description='Rounding of widths to whole millimetres: `"ceil"` or `"floor1"` (default: `"ceil"`).'
    )
    on_overload: Literal["reject", "scale"] | None = Field(
        default=None,
        description='`"scale"`: modules tied by a common axis grow together; `"reject"`: '
        'a set whose second stage is too weak is left out (default: `"scale"`).',
    )
    iterate: bool | None = Field(
        default=None,
        description="Whether K_beta is taken at the width that results (default: `false`, at `face_width`).",
    )
