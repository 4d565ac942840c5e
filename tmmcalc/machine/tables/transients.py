"""``[[transients]]``: motions in time: starts, run-downs, changes of the load."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.identifiers import Words
from tmmcalc.spec.quantities import Number, Quantity
from tmmcalc.spec.table import Table

TransientName = Annotated[str, Words("transient motion")]
Time = Annotated[float, Quantity("time", at_least_zero=True)]
Duration = Annotated[float, Quantity("time", at_least_zero=True, nonzero=True)]
Interval = Annotated[list[Time], Field(min_length=2, max_length=2)]
Speed = Annotated[float, Quantity("angular speed")]
Advance = Annotated[float, Quantity("angle", at_least_zero=True)]
Turned = Annotated[float, Quantity("angle", at_least_zero=True, nonzero=True)]
Factor = Annotated[float, Number("a load factor", "0.5", at_least=0)]
Tolerance = Annotated[float, Number("a tolerance", "1e-9", at_least=1e-13, at_most=1e-2)]
BrakeMoment = Annotated[float, Quantity("moment", at_least_zero=True)]
BrakingResistance = Annotated[float, Quantity("resistance", at_least_zero=True)]
SourceVoltage = Annotated[float, Quantity("voltage", at_least_zero=True, nonzero=True)]
FieldCurrent = Annotated[float, Number("a field current over the rated one", "1", above=0)]
BrakeViscous = Annotated[float, Quantity("torsional damping", at_least_zero=True)]


class LoadStepTable(Table):
    """A load factor and when it comes; the steps come one after the other."""

    factor: Factor = Field(description="Load factor from then on.")
    time: Time | None = Field(default=None, description="The step waits for this time.")
    speed: Speed | None = Field(default=None, description="Or until the crank first exceeds this speed.")
    quiet: bool = Field(
        default=False,
        description="Whether the step waits besides for a part of the cycle without load (a warning if there is none).",
    )


class BrakeTable(Table):
    """A braking moment on one mass of the drive: a constant part against the motion, and a viscous part."""

    moment: BrakeMoment = Field(default=0.0, description="Constant part against the motion, on the shaft of the mass.")
    viscous: BrakeViscous = Field(default=0.0, description="Part in proportion to the speed, N*m*s/rad.")
    start: Time = Field(default=0.0, alias="from", description="Time from which it acts; 0: from the beginning.")
    end: Time | None = Field(default=None, alias="to", description="Time until which it acts (default: the end).")
    mass: int | None = Field(
        default=None,
        ge=0,
        description="Number of the mass that it acts on: 0 the rotor, 1 the mass behind the first shaft, and so on "
        "(default: the crank).",
    )


class BrakingTable(Table):
    """How a direct-current motor is connected so that it brakes."""

    kind: Literal["regenerative", "dynamic", "plugging"] = Field(
        description='`"regenerative"`: on a source of a voltage below that of the armature; `"dynamic"`: the armature '
        'on a resistor; `"plugging"`: the voltage turned round.'
    )
    resistance: BrakingResistance = Field(default=0.0, description="Resistance added to the armature circuit, ohm.")
    voltage: SourceVoltage | None = Field(
        default=None, description="Voltage of the source of regenerative braking (default: that of the motor)."
    )
    field: FieldCurrent | None = Field(
        default=None,
        description="Current of the field of a series motor from a source of its own, over the rated one, `1` "
        "(default: the field carries the current of the armature, turned round against it).",
    )


class TransientTable(Table):
    """One motion in time: how it begins, what is switched, what ends it, how it is integrated."""

    name: TransientName | None = Field(
        default=None, description="Unique name (default: `transient`, `transient 2` ...)."
    )
    duration: Duration | None = Field(
        default=None,
        description="The motion ends here at the latest (default: when it repeats itself from cycle to cycle, stands "
        "still, or runs away).",
    )
    start_speed: Speed = Field(default=0.0, description="Speed of the crank at the beginning.")
    begin: Literal["steady"] | None = Field(
        default=None,
        alias="from",
        description='`"steady"`: begin in the steady motion, at position 0, in place of a speed and an angle.',
    )
    start_angle: Advance = Field(default=0.0, description="Crank angle at the beginning, along the motion.")
    motor: Literal["on", "off"] | None = Field(
        default=None, description='Whether the motor is `"on"` or `"off"` (default: `"on"`).'
    )
    motor_on: list[Interval] | None = Field(
        default=None,
        min_length=1,
        description="Times `[on, off]` between which the motor is on, in place of `motor`: "
        '`[["0 s", "2 s"], ["5 s", "9 s"]]`.',
    )
    braking: BrakingTable | None = Field(
        default=None,
        description='The motor brakes while it is on: `{ kind = "dynamic", resistance = "2 ohm" }`. '
        "A shunt motor with `voltage`, `resistance` and `constant` does, and a series motor with `voltage` and "
        "`resistance`.",
    )
    load: Factor = Field(default=1.0, description="Load factor at the beginning.")
    load_steps: list[LoadStepTable] = Field(
        default=[],
        description='Changes of the load factor, one after the other: `[{ factor = 1, speed = "950 rpm", quiet = '
        'true }, { factor = 0.5, time = "3 s" }]`.',
    )
    brake: BrakeTable | None = Field(
        default=None, description='A brake: `{ moment = "200 N*m", from = "2 s", to = "4 s" }`.'
    )
    targets: list[Speed] = Field(
        default=[], description='Speeds of the crank whose first passage is noted: `["500 rpm"]`.'
    )
    end_speed: Speed | None = Field(default=None, description="The motion ends when the crank reaches this speed.")
    end_angle: Turned | None = Field(
        default=None, description="The motion ends when the crank has turned by this angle."
    )
    standstill: Literal["stop", "pass"] = Field(
        default="stop",
        description='`"stop"`: at rest the load only resists; `"pass"`: it may drive the crank backwards, as a '
        "weight does.",
    )
    method: Literal["auto", "merson", "rk4", "collocation", "RK45", "DOP853", "LSODA", "Radau", "BDF"] = Field(
        default="auto",
        description='Method of integration: `"merson"`, `"rk4"`, `"collocation"` (Radau IIA of order 13), `"RK45"`, '
        '`"DOP853"`, `"LSODA"`, `"Radau"`, `"BDF"`; `"auto"` picks by stiffness.',
    )
    step: Duration | None = Field(default=None, description='Fixed step of `"rk4"`, or of `"merson"`.')
    tolerance: Tolerance | None = Field(
        default=None, description="Relative tolerance of one step (default: of the method)."
    )
