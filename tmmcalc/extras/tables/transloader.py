"""``[transloader]``: a grab transloader, its speeds, its loads, the stresses of its parts."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.extras.loadcases import DUTIES, MAKINGS, MECHANISMS
from tmmcalc.spec.choices import Known, Listed
from tmmcalc.spec.quantities import Gravity, Number, Quantity, Size
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}
_FORCE = Quantity("force", at_least_zero=True)
_IMPORTANCE = Number("a factor K1", "1.2", at_least=1, at_most=10)

Mass = Annotated[float, Quantity("mass", **_POSITIVE)]
Speed = Annotated[float, Quantity("speed", **_POSITIVE)]
Acceleration = Annotated[float, Quantity("acceleration", **_POSITIVE)]
Time = Annotated[float, Quantity("time", **_POSITIVE)]
Load = Annotated[float, _FORCE]
Weights = Annotated[list[float], Listed(_FORCE, '["160 kN", "90 kN"]')]
Area = Annotated[float, Quantity("area", **_POSITIVE)]
Pressure = Annotated[float, Quantity("pressure", **_POSITIVE)]
Wind = Annotated[float, Quantity("pressure", at_least_zero=True)]
Deflection = Annotated[float, Quantity("length", at_least_zero=True)]
Coefficient = Annotated[float, Number("a coefficient of the wind", "1.2", at_least=0, at_most=100)]
Influence = Annotated[float, Number("a force in the part over the load", "0.8", at_least=-1e6, at_most=1e6)]
Factors = Annotated[Literal["sum", "product"], Known("rule for K_m", ("sum", "product"))]
Blanks = Annotated[Literal["without", "with"], Known("rule for loads left blank", ("without", "with"))]
MechanismName = Annotated[str, Known("mechanism", tuple(MECHANISMS))]
Duty = Annotated[str, Known("duty", tuple(DUTIES))]
Making = Annotated[str, Known("way of making", tuple(MAKINGS))]
Importance = Annotated[list[float], Listed(_IMPORTANCE, "[1.2, 1.1, 1.1]", 3)]


class TrolleyTable(Table):
    """The way of the trolley."""

    path: Size = Field(description="L0: its longest way.")
    acceleration: Acceleration = Field(description="j: its acceleration and deceleration.")
    speed: Speed | None = Field(default=None, description="Its speed (default: half of sqrt(L0 j), 360 m/min at most).")


class HoistTable(Table):
    """The lift of the grab."""

    height: Size = Field(description="H: height of the lift.")
    acceleration: Acceleration = Field(description="j: acceleration and deceleration; usual is 1 to 1.2 m/s^2.")
    speed: Speed | None = Field(
        default=None, description="Speed of hoisting (default: 0.3 of sqrt(H j), 100 m/min at most)."
    )
    lowering: Speed | None = Field(
        default=None, description="Speed of lowering, usual is 1 to 1.4 of that of hoisting."
    )


class StartTable(Table):
    """What a mechanism sets into motion."""

    weights: Weights = Field(description="G: weights that are set into motion.")
    speed: Speed | None = Field(default=None, description="v: speed that they reach (default: that of the trolley).")
    time: Time | None = Field(
        default=None, description="t: time in which they reach it (default: by the acceleration of the trolley)."
    )


class TransloaderWindTable(Table):
    """A wind: w = q0 n c gamma beta on an area."""

    pressure: Wind = Field(description="q0: pressure of the wind.")
    area: Area = Field(description="Area that it acts on.")
    height: Coefficient = Field(default=1.0, description="n: coefficient of the height.")
    shape: Coefficient = Field(default=1.0, description="c: coefficient of the shape.")
    overload: Coefficient = Field(default=1.0, description="gamma: coefficient of overload.")
    dynamic: Coefficient = Field(default=1.0, description="beta: coefficient of the gusts.")


class TransloaderLoadsTable(Table):
    """Loads that are not found from other tables."""

    dead_weight: Load | None = Field(default=None, description="Dead weight (default: that of `mass`).")
    rated_load: Load | None = Field(default=None, description="Rated load (default: weight of `capacity`).")
    inertia: Load | None = Field(default=None, description="Inertia in normal operation; or `[transloader.inertia]`.")
    wind: Load | None = Field(default=None, description="Wind to GOST 1451-65; or `[transloader.wind]`.")
    equivalent_wind: Load | None = Field(
        default=None, description="Equivalent wind; or `[transloader.equivalent_wind]`."
    )
    track: Load | None = Field(default=None, description="From the gradient of the track and the rocking of the crane.")
    drive: Load | None = Field(
        default=None,
        description="Largest of skidding wheels, motors, brakes and slip clutches, with the inertia that it causes.",
    )
    shock: Load | None = Field(default=None, description="From shocks.")
    hurricane: Load | None = Field(default=None, description="Hurricane wind; or `[transloader.hurricane]`.")
    seismic: Load | None = Field(default=None, description="From an earthquake.")


class InfluenceTable(Table):
    """Force in a part over each load."""

    dead_weight: Influence = Field(default=0.0, description="Of the dead weight.")
    rated_load: Influence = Field(default=0.0, description="Of the rated load.")
    inertia: Influence = Field(default=0.0, description="Of the inertia in normal operation.")
    wind: Influence = Field(default=0.0, description="Of the wind.")
    equivalent_wind: Influence = Field(default=0.0, description="Of the equivalent wind.")
    track: Influence = Field(default=0.0, description="Of the track.")
    drive: Influence = Field(default=0.0, description="Of the largest moments of the drives.")
    shock: Influence = Field(default=0.0, description="Of shocks.")
    hurricane: Influence = Field(default=0.0, description="Of the hurricane wind.")
    seismic: Influence = Field(default=0.0, description="Of an earthquake.")


class TransloaderPartTable(Table):
    """A part whose stress is looked at."""

    name: str = Field(min_length=1, description="Name of the part.")
    area: Area = Field(description="Section that carries its force; for bending W/arm.")
    strength: Pressure = Field(description="sigma0 against static stress.")
    endurance: Pressure | None = Field(
        default=None, description="sigma0 against fatigue, looked at in case A (default: not looked at)."
    )
    mechanism: MechanismName = Field(default="hoist", description="Its mechanism, which gives K1 and the duty.")
    duty: Duty | None = Field(
        default=None, description="Duty, which gives K2 (default: the usual one of its mechanism)."
    )
    making: Making = Field(default="rolled", description="How it is made, which gives K_n against fatigue.")
    importance: Importance | None = Field(
        default=None,
        description="K1 in the cases A, B and V (default: that of its mechanism, where the source has one).",
    )
    influence: InfluenceTable = Field(description="Force in the part over each load.")


class TransloaderTable(Table):
    """A grab transloader."""

    capacity: Mass = Field(description="Q: rated capacity.")
    mass: Mass | None = Field(
        default=None, description="Mass of the whole: structure, mechanisms, electrical equipment."
    )
    gravity: Gravity = Field(default=9.81, description="Acceleration of free fall.")
    span: Size | None = Field(default=None, description="Span of the bridge; usual is 30 to 115 m.")
    deflection: Deflection | None = Field(default=None, description="Deflection of the bridge, at most span/700.")
    bridge_speed: Speed | None = Field(default=None, description="Speed of the bridge; usual is 15 to 35 m/min.")
    trolley: TrolleyTable | None = Field(default=None, description="The way of the trolley.")
    hoist: HoistTable | None = Field(default=None, description="The lift of the grab.")
    inertia: StartTable | None = Field(default=None, description="What is set into motion in normal operation.")
    wind: TransloaderWindTable | None = Field(default=None, description="Wind in operation.")
    equivalent_wind: TransloaderWindTable | None = Field(default=None, description="Equivalent wind, for fatigue.")
    hurricane: TransloaderWindTable | None = Field(default=None, description="Wind out of service.")
    loads: TransloaderLoadsTable | None = Field(default=None, description="Loads that are known.")
    factors: Factors = Field(
        default="sum",
        description='K_m is the `"sum"` K1 + K2, as the source prints it, or the `"product"` K1 K2, as cranes are '
        "designed; the output says which.",
    )
    blanks: Blanks = Field(
        default="without",
        description='Loads that the source left blank in a case: cases `"without"` or `"with"` them.',
    )
    parts: list[TransloaderPartTable] = Field(default=[], description="Parts whose stresses are looked at.")
