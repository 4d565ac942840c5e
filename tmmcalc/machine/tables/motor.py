"""``[motor]``: the motor, by its name in a catalogue or by its data."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.quantities import AngularSpeed, Inertia, Moment, Number, Quantity
from tmmcalc.spec.table import Table

Power = Annotated[float, Quantity("power", at_least_zero=True, nonzero=True)]
TimeConstant = Annotated[float | Literal["auto"], Quantity("time", at_least_zero=True, words=("auto",))]
FlywheelMoment = Annotated[float, Quantity("flywheel moment", at_least_zero=True)]
CurveSpeed = Annotated[float, Quantity("angular speed", at_least_zero=True)]
Overload = Annotated[float, Number("an overload ratio", "2.2", above=1)]
Efficiency = Annotated[float, Number("the efficiency of a motor", "0.88", above=0, below=1)]
Voltage = Annotated[float, Quantity("voltage", at_least_zero=True, nonzero=True)]
Resistance = Annotated[float, Quantity("resistance", at_least_zero=True, nonzero=True)]
MotorConstant = Annotated[float, Quantity("motor constant", at_least_zero=True, nonzero=True)]
Saturation = Annotated[float, Number("a saturation", "0.3", at_least=0, below=1)]
FieldResistance = Annotated[float, Quantity("resistance", at_least_zero=True)]
Reserve = Annotated[float, Number("a reserve", "0.2", at_least=0, at_most=5)]
Start = Annotated[float, Number("a starting ratio", "1.8", above=0)]


class CurveTable(Table):
    """A characteristic by points, in the table itself or in a file: moments of the motor at its speeds."""

    speed: list[CurveSpeed] | None = Field(default=None, min_length=2, description="Speeds of the motor, ascending.")
    moment: list[Moment] | None = Field(default=None, min_length=2, description="Moment of the motor at each speed.")
    file: str | None = Field(
        default=None,
        description="CSV file in place of the values: two columns under a header such as `n[rpm],M[N*m]`; "
        "its path counts from the folder of the spec.",
    )
    columns: str | None = Field(
        default=None,
        description="Columns of a file that has more than two: of the values, or of both, as `--columns` names them, "
        '`"omega,M_d"`.',
    )
    interpolation: Literal["linear", "pchip"] = Field(
        default="pchip", description='`"pchip"`: a smooth monotone curve, or `"linear"`, straight lines.'
    )


class MotorTable(Table):
    """A motor; data beside a name stand in place of those of the catalogue."""

    name: str | None = Field(
        default=None,
        description='Name of a motor of the catalogue; `"choose"` takes the least that does, among those of '
        "`synchronous_speed` if it is given.",
    )
    catalogue: str | None = Field(
        default=None,
        description="CSV file of motors (default: built in); its path counts from the folder of the spec.",
    )
    reserve: Reserve | None = Field(
        default=None,
        description='Beside `name = "choose"`: the part by which rated power and rated moment exceed the mean power '
        "and the rms moment, `0.2` (default: 0).",
    )
    kind: Literal["induction", "shunt", "series"] | None = Field(
        default=None,
        description='Kind of the motor, `"induction"`, or of direct current `"shunt"` or `"series"` (default: '
        '`"induction"`, or that of the catalogue).',
    )
    power: Power | None = Field(default=None, description="Rated power.")
    speed: AngularSpeed | None = Field(default=None, description="Rated speed.")
    synchronous_speed: AngularSpeed | None = Field(default=None, description="Synchronous speed of an induction motor.")
    no_load_speed: AngularSpeed | None = Field(default=None, description="No-load speed of a shunt motor.")
    overload: Overload | None = Field(default=None, description="Largest moment over the rated one.")
    start: Start | None = Field(default=None, description="Starting moment over the rated one.")
    inertia: Inertia | None = Field(default=None, description="Moment of inertia of the rotor; or `flywheel_moment`.")
    flywheel_moment: FlywheelMoment | None = Field(
        default=None,
        description="Flywheel moment GD^2 of the rotor in kgf*m^2, four times its moment of inertia in kg*m^2; "
        "in place of `inertia`.",
    )
    time_constant: TimeConstant | None = Field(
        default=None,
        description='Electromagnetic time constant (default: 0, without lag); `"auto"`: '
        "that of an induction motor by its critical slip, 1/(2 pi f s_K) at f = 50 Hz, for which it "
        "needs `synchronous_speed` and `overload`.",
    )
    efficiency: Efficiency | None = Field(
        default=None, description="Rated efficiency of a series motor, which needs it."
    )
    voltage: Voltage | None = Field(default=None, description="Voltage of a direct-current motor, V.")
    resistance: Resistance | None = Field(
        default=None, description="Resistance of the armature circuit of a direct-current motor, ohm."
    )
    constant: MotorConstant | None = Field(default=None, description="Motor constant of a shunt motor, V*s/rad.")
    saturation: Saturation | None = Field(
        default=None,
        description="Part of the flux of a series motor that its iron lacks at the rated current, `0.3` (default: 0, "
        "the flux is in proportion to the current).",
    )
    field_resistance: FieldResistance | None = Field(
        default=None,
        description="Part of the `resistance` of a series motor that is its field winding, out of the circuit of the "
        "armature while the motor brakes with `field` (default: 0).",
    )
    characteristic: Literal["parabolic", "linear", "kloss", "shunt", "series", "table", "constant"] | None = Field(
        default=None,
        description='Moment against speed: `"parabolic"`, `"linear"`, `"kloss"`, `"shunt"`, `"series"`, `"table"` or '
        '`"constant"` (default: by the kind).',
    )
    table: CurveTable | None = Field(
        default=None,
        description='Characteristic by points, on the motor\'s shaft: `{ speed = ["0 rpm", "1500 rpm"], moment = '
        '["15 N*m", 0] }`.',
    )
