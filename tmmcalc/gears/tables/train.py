"""``[train]``: the gear train whose tooth numbers are asked for."""

import math
from fractions import Fraction
from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.spec.choices import Exact, Known, Listed, OneOrMore, OrFalse, Whole
from tmmcalc.spec.quantities import Angle, Number, Quantity, Size
from tmmcalc.spec.table import Table

TEETH = (6, 1000)  # of external wheels, the least and the most that can be asked for
RING_TEETH = (6, 2000)
PLANETS = (1, 12)
_LENGTH = Quantity("length", at_least_zero=True, nonzero=True)
_MODULE_RATIO = Exact("a part of a ratio of modules", "2", above=0)

Layouts = Annotated[list[str], OneOrMore(Known("layout", tuple(LAYOUTS)))]
Ratio = Annotated[Fraction, Exact("a ratio", '8.15 or "163/20"', nonzero=True)]
ShaftSpeed = Annotated[float, Quantity("angular speed", nonzero=True)]
Tolerance = Annotated[Fraction, Exact("a tolerance", '0.01 or "1 %"', at_least=0, percent=True)]
Planets = Annotated[list[int], OneOrMore(Whole("a number of planets", *PLANETS))]
ModuleRatios = Annotated[list[list[Fraction]], Listed(Listed(_MODULE_RATIO, "[2, 3]", 2), "[[2, 3], [4, 7]]")]
ModuleRange = Annotated[list[Fraction], Listed(_MODULE_RATIO, "[1.0, 2.5]", 2)]
Teeth = Annotated[int, Field(ge=TEETH[0], le=TEETH[1])]
RingTeeth = Annotated[int, Field(ge=RING_TEETH[0], le=RING_TEETH[1])]
Addendum = Annotated[Fraction, Exact("an addendum", "1", above=0, below=2)]
MeshAngle = Annotated[float | Literal[False], OrFalse(Quantity("angle", at_least_zero=True, nonzero=True))]
Gap = Annotated[Fraction | Literal[False], OrFalse(Exact("a gap in modules", "1", at_least=0))]
Difference = Annotated[int | Literal[False], OrFalse(Whole("a difference of tooth numbers", 0, 100))]
StageRatio = Annotated[Fraction | Literal[False], OrFalse(Exact("the largest ratio of one stage", "6", above=1))]
Band = Annotated[Fraction | Literal[False], OrFalse(Exact("a relative difference", "0.05", above=0, below=1))]
Distances = Annotated[list[float] | Literal[False], OrFalse(Listed(_LENGTH, '["80 mm", "120 mm"]', 2))]
Envelope = Annotated[float | Literal[False], OrFalse(_LENGTH)]
RadialRatio = Annotated[float, Number("a ratio", "1.2", above=0, at_most=100)]
RadialAngles = Annotated[list[float], Listed(Quantity("angle"), '["22 deg", "21 deg", "20 deg"]', 3)]
AssemblyNumber = Annotated[int, Field(ge=1, le=RING_TEETH[1])]


class RadialTable(Table):
    """The train 2A-AA before its teeth are rounded: what its equations leave free."""

    y: RadialRatio = Field(default=1.0, description="Z3/Z2: teeth of planet 3 over those of planet 2.")
    t1: RadialRatio = Field(
        default=1.0, description="cos a_w12/cos a_w23 of the operating pressure angles; 0.8 to 1.2 is usual."
    )
    t2: RadialRatio = Field(
        default=1.0, description="cos a_w12/cos a_w34 of the operating pressure angles; 0.8 to 1.2 is usual."
    )
    mesh_angles: RadialAngles | None = Field(
        default=None,
        description='Or the operating pressure angles of the meshes 1-2, 2-3, 3-4: `["22 deg", "21 deg", "20 deg"]`.',
    )
    assembly_number: AssemblyNumber | None = Field(
        default=None,
        description="N = (Z1 + Z4)/k, k pairs of planets (default: the least with `z_min` teeth of sun 1 or more).",
    )


class ConstraintsTable(Table):
    """What else the tooth numbers have to keep; each constraint is switched off by false."""

    mesh_angle_max: MeshAngle | None = Field(
        default=None,
        description="Stages whose centre distances differ are closed by raising operating pressure angles up to this "
        "one (default: off, 2A-AA 26 deg).",
    )
    assembly: bool = Field(default=True, description="Whether equally spaced planets have to fit in.")
    adjacency_gap: Gap = Field(
        default=Fraction(1), description="Least gap between the tips of neighbouring planets, in modules."
    )
    ring_difference: Difference = Field(
        default=7, description="Least number of teeth that a ring has more than the wheel within."
    )
    undercut: bool | None = Field(
        default=None,
        description="Whether external wheels are free of undercut: 2 h_a/sin^2(alpha) teeth or more (default: "
        "`true`, `false` where a lower `z_min` is given, with a warning).",
    )
    stage_ratio_max: StageRatio | None = Field(
        default=None, description="Largest ratio of one stage (default: 6 of an unfolded train)."
    )
    diameter_band: Band | None = Field(
        default=None,
        description="Largest relative difference of the wheels' diameters; of unfolded trains with m2/m1 = cbrt(U1) "
        "(default: 0.05 of an unfolded train).",
    )
    equal_pinions: bool = Field(
        default=False, description="Whether all pinions of an unfolded train have the same number of teeth."
    )
    coprime: bool = Field(default=False, description="Whether the wheels of every mesh are without common factor.")
    centre_distance: Distances = Field(
        default=False,
        description='Least and largest centre distance of wheels 1 and 2, `["80 mm", "120 mm"]`; needs a module.',
    )
    envelope: Envelope = Field(default=False, description="Largest diameter around the train; needs a module.")


class TrainTable(Table):
    """A gear train: its layout, its ratio, and within what limits tooth numbers are sought."""

    layout: Layouts = Field(
        description='Layout of the train, or a list of several that are compared: `["AI", "AIbar"]`.'
    )
    ratio: Ratio | None = Field(
        default=None,
        description='Ratio of the train, `"8.15"`, `8.15` or `"163/20"`, exact as written (default: of the speeds of '
        "its shafts; beside `[motor]` and `[mechanism]`, or `[torque]`, that of the drive: given in `[transmission]`, "
        "that of `[[shafts]]`, or the rated speed of the motor over the mean speed of the crank, each "
        "without that of `[open_pair]`).",
    )
    ratio_kind: Literal["u", "i_1H", "i_H1", "i_14"] | None = Field(
        default=None,
        description='Which ratio that is. `"u"`: of teeth, U = Z2 Z3/(Z1 Z2\') (fixed axes); `"i_1H"`: '
        'wheel 1 over the carrier (planetary; below 1 for AA and II); `"i_H1"`: the carrier drives; '
        '`"i_14"`: wheel 1 over ring 4 (AII) (default: by the layout).',
    )
    input_speed: ShaftSpeed | None = Field(
        default=None, description="Speed of the input shaft; with `output_speed` in place of `ratio`."
    )
    output_speed: ShaftSpeed | None = Field(
        default=None, description="Speed of the output shaft; a negative one turns the other way."
    )
    tolerance: Tolerance | None = Field(
        default=None,
        description='Admitted deviation of the ratio: `0.01`, `"1 %"`, `"1e-9"`; limits included, exactly (default: '
        "1 %, of unfolded3 2 %).",
    )
    tolerance_kind: Literal["relative", "absolute"] = Field(
        default="relative",
        description='Whether the tolerance is `"relative"`, a part of the ratio, or `"absolute"`; '
        "of the ratio as given by its kind.",
    )
    planets: Planets | None = Field(
        default=None, description="Number of planets or layshafts, or a list: `[2, 3, 4]` (default: 3, coaxial 1)."
    )
    module_ratios: ModuleRatios | None = Field(
        default=None,
        description="Proportions m1 : m2 of the modules of the stages, `[[2, 3], [4, 7]]` (coaxial, AI, AA, II, AII).",
    )
    modules: list[Size] | None = Field(
        default=None, min_length=2, max_length=2, description='Or the modules themselves, `["2 mm", "3.5 mm"]`.'
    )
    module_ratio_range: ModuleRange | None = Field(
        default=None,
        description="Or all ratios m2/m1 that standard modules have between these (default: `[1.0, 2.5]`).",
    )
    teeth: list[RingTeeth] | None = Field(
        default=None,
        min_length=2,
        description="Given numbers of teeth, in the order of the wheels of the one layout, `[18, 48, 114]`: they are "
        "tested, and no others are sought (default: all that keep the constraints).",
    )
    z_min: Teeth | None = Field(default=None, description="Least number of teeth of external wheels (default: 17).")
    z_max: Teeth = Field(default=150, description="Largest number of teeth of external wheels.")
    z_pinion_max: Teeth | None = Field(
        default=None, description="Largest number of teeth of the pinions of an unfolded train (default: 25)."
    )
    ring_min: RingTeeth | None = Field(default=None, description="Least number of teeth of a ring (default: 40).")
    ring_max: RingTeeth | None = Field(default=None, description="Largest number of teeth of a ring (default: 350).")
    sum_max: int | None = Field(
        default=None, ge=12, le=3000, description="Largest Z1 + Z2, the sum of teeth of wheels 1 and 2."
    )
    method: Literal["complete", "textbook"] = Field(
        default="complete",
        description='`"complete"`: every tooth set; or `"textbook"`: the sets that the textbook\'s programs find '
        "by stepping.",
    )
    keep: int = Field(
        default=100_000,
        ge=1,
        le=5_000_000,
        description="Most tooth sets that are held, those with the least Z1 + Z2; the count is exact whatever it is.",
    )
    pressure_angle: Angle = Field(default=math.pi / 9, description="Pressure angle of the rack.")
    addendum: Addendum = Field(default=Fraction(1), description="Addendum of the rack, in modules.")
    module: Size | None = Field(default=None, description="Module of stage 1, for centre distances and sizes.")
    radial: RadialTable | None = Field(
        default=None, description='What the equations of `"2A-AA"` leave free, for its real-valued teeth and limits.'
    )
    constraints: ConstraintsTable = Field(
        default_factory=ConstraintsTable, description="What else the tooth numbers have to keep."
    )
