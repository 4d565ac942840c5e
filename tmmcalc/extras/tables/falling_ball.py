"""``[falling_ball]``: a ball that falls while its radius decreases exponentially."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.choices import Known, Listed, Whole
from tmmcalc.spec.quantities import Gravity, Number, Quantity
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}

Radius = Annotated[float, Quantity("length", **_POSITIVE)]
Drag = Annotated[float, Number("a coefficient of drag", "1e-4", above=0)]
Decay = Annotated[float, Number("a decay in 1/s", "0.5", above=0)]
Sense = Annotated[str, Known("sense of the reaction", ("accelerating", "braking"))]
Relative = Annotated[float | Literal["own"], Quantity("speed", at_least_zero=True, words=("own",))]
Speed = Annotated[float, Quantity("speed", at_least_zero=True)]
Times = Annotated[list[float], Listed(Quantity("time", at_least_zero=True), '["0.5 s", "1 s"]')]
Duration = Annotated[float, Quantity("time", **_POSITIVE)]
Rows = Annotated[int, Whole("a number of rows", 2, 100_000)]


class FallingBallTable(Table):
    """The ball, its drag, the reaction of the mass that separates."""

    radius: Radius = Field(description="r0: radius at the beginning.")
    drag: Drag = Field(description="alpha: the drag decelerates by alpha v^2/r.")
    decay: Decay = Field(description="lambda in 1/s: the radius is r0 e^(-lambda t).")
    gravity: Gravity = Field(default=9.81, description="Acceleration of free fall.")
    reaction: Sense = Field(
        default="braking", description='Sense of the reaction: `"braking"` or `"accelerating"`, s = -1 or 1.'
    )
    relative_speed: Relative = Field(
        default=0.0,
        description='V of the separated mass against the ball; `"own"`: V = v, that of the ball itself: '
        "the mass has no speed of its own.",
    )
    initial_speed: Speed = Field(default=0.0, description="v0: downwards.")
    times: Times = Field(default=[], description="Times at which speed and way are told.")
    duration: Duration | None = Field(
        default=None,
        description="Time of the table (default: to the stop or 5/lambda); behind its stop the ball moves upwards.",
    )
    rows: Rows = Field(default=200, description="Equal steps of the table.")
