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
BrakeViscous = Annotated[float, Quantity("torsional damping", at_least_zero=True)]


class LoadStepTable(Table):
    """A load factor and when it comes; the steps come one after the other."""

    factor: Factor = Field(description="Load factor from then on.")
    time: Time | None = Field(default=None, description="Not before this time.")
    speed: Speed | None = Field(default=None, description="Or when the crank first exceeds this speed.")
    quiet: bool = Field(default=False, description="Whether it waits for a part of the cycle without load.")


class BrakeTable(Table):
    """A braking moment on one mass of the drive: a constant part against the motion, and a viscous part."""

    moment: BrakeMoment = Field(default=0.0, description="Constant part, on the shaft of the mass.")
    viscous: BrakeViscous = Field(default=0.0, description="Part in proportion to the speed.")
    start: Time = Field(default=0.0, alias="from", description="Time from which it acts.")
    end: Time | None = Field(default=None, alias="to", description="Time until which it acts (default: the end).")
    mass: int | None = Field(
        default=None,
        ge=0,
        description="Mass that it acts on: 0 the rotor, 1 the one behind the first shaft ... (default: the crank).",
    )


class TransientTable(Table):
    """One motion in time: how it begins, what is switched, what ends it, how it is integrated."""

    name: TransientName | None = Field(default=None, description='Name, unique (default: "transient", "transient 2").')
    duration: Duration | None = Field(
        default=None,
        description="The motion ends here at the latest (default: when it repeats itself from cycle to cycle).",
    )
    start_speed: Speed = Field(default=0.0, description="Speed of the crank at the beginning.")
    begin: Literal["steady"] | None = Field(
        default=None, alias="from", description='"steady": begin in the steady motion, at position 0.'
    )
    start_angle: Advance = Field(default=0.0, description="Crank angle at the beginning, along the motion.")
    motor: Literal["on", "off"] | None = Field(default=None, description="Whether the motor is on (default) or off.")
    motor_on: list[Interval] | None = Field(
        default=None, min_length=1, description="Times [on, off] between which the motor is on, in place of motor."
    )
    load: Factor = Field(default=1.0, description="Load factor at the beginning.")
    load_steps: list[LoadStepTable] = Field(default=[], description="Changes of the load factor.")
    brake: BrakeTable | None = Field(default=None, description="A brake.")
    targets: list[Speed] = Field(default=[], description="Speeds of the crank whose first passage is noted.")
    end_speed: Speed | None = Field(default=None, description="The motion ends when the crank reaches this speed.")
    end_angle: Turned | None = Field(
        default=None, description="The motion ends when the crank has turned by this angle."
    )
    standstill: Literal["stop", "pass"] = Field(
        default="stop", description="At rest the load only resists, or may drive the crank backwards."
    )
    method: Literal["auto", "merson", "rk4", "collocation", "RK45", "DOP853", "LSODA", "Radau", "BDF"] = Field(
        default="auto", description="Method of integration; auto picks by stiffness."
    )
    step: Duration | None = Field(default=None, description="Fixed step of rk4, or of merson.")
    tolerance: Tolerance | None = Field(
        default=None, description="Relative tolerance of one step (default: that of the method)."
    )
