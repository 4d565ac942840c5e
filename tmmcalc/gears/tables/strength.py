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

    steel: str | None = Field(default=None, description='Designation, in Cyrillic or Latin letters, such as "40Kh".')
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
    ) = Field(default=None, description="Heat treatment of the teeth.")
    hardness: HardnessText | None = Field(default=None, description='Hardness of the tooth surface, such as "300 HB".')
    core: HardnessText | None = Field(default=None, description="Hardness of the core of nitrided teeth in HRC.")
    protected: bool = Field(default=False, description="Measures are taken against decarburisation of the surface.")
    structure: Literal["homogeneous", "surface-strengthened"] | None = Field(
        default=None, description="Structure of the tooth (default: that of the treatment)."
    )
    failure: Literal["ordinary", "severe"] = Field(default="ordinary", description="Consequences of a failure.")
    blank: Literal["forging", "rolled", "casting"] = Field(default="forging", description="Blank of the wheel.")
    wear: Literal["none", "abrasive"] = Field(default="none", description="Wear of the teeth.")
    load: Literal["one-sided", "two-sided"] | None = Field(
        default=None,
        description="Sides of the teeth that bear load (default: both of planets of a planetary train, else one).",
    )
    row: str | None = Field(
        default=None, description='Row of Table D.4.3 for a steel similar to those that it names, such as "h2".'
    )
    contact_limit: Stress | None = Field(default=None, description="Contact endurance limit in place of the table's.")
    bending_limit: Stress | None = Field(default=None, description="Bending endurance limit in place of the table's.")


class StrengthTable(Table):
    """Modules and face widths of a train by the endurance of its teeth, or the stresses at given ones."""

    torque: Torque | None = Field(default=None, description="Torque on wheel 1, total of all branches.")
    moment: LargestMoment | None = Field(
        default=None, description="Largest reduced moment, in place of torque (default: that of the reduction)."
    )
    moment_ratio: Ratio | None = Field(
        default=None,
        description="Speed of wheel 1 over that of the shaft to which the moment is reduced (default: that of the "
        "train, whose output is this shaft).",
    )
    material: MaterialTable | None = Field(default=None, description="Material of all wheels.")
    pinion: MaterialTable | None = Field(default=None, description="Material of the pinions, in place of material.")
    wheel: MaterialTable | None = Field(default=None, description="Material of the other wheels (default: as pinions).")
    permissible_contact: Stresses | None = Field(
        default=None, description="Permissible contact stress sigma_HP of each stage, in place of the materials'."
    )
    permissible_bending: Stresses | None = Field(
        default=None, description="Permissible bending stress sigma_FP of each stage, in place of the materials'."
    )
    face_width: WidthCoefficients | None = Field(
        default=None, description="Face width over pinion diameter psi_bd of each stage (default: Table D.4.2)."
    )
    arrangement: Rows | None = Field(
        default=None, description="Row of Table D.4.1 of each stage (default: that of the layout)."
    )
    module: Sizes | None = Field(default=None, description="Modules of the stages, to be checked.")
    width: Sizes | None = Field(default=None, description="Face widths of the given modules.")
    modules_row: Literal[1, 2] | None = Field(
        default=None, description="Standard modules: 1 the preferred row only, 2 (default) both rows."
    )
    underrun: Underrun | None = Field(
        default=None, description="Relative amount by which a standard module may be too small (default: 0)."
    )
    face_width_rule: Literal["consistent", "book1992"] | None = Field(
        default=None, description="Width that keeps the strength (default: consistent), or as the textbook printed it."
    )
    rounding: Literal["ceil", "floor1"] | None = Field(
        default=None, description="Rounding of widths to whole millimetres (default: ceil)."
    )
    on_overload: Literal["reject", "scale"] | None = Field(
        default=None,
        description="Modules tied by coaxiality: larger ones for all stages (default: scale), or no such train.",
    )
    iterate: bool | None = Field(
        default=None, description="Take K_beta at the face width that results (default: at face_width)."
    )
