"""``[unsteady]``: a motion of the mechanism from rest to rest by the time-optimal law."""

from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Known, Whole
from tmmcalc.spec.quantities import Quantity
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}
SENSES = {"positive": 1, "negative": -1}

Limit = Annotated[float, Quantity("speed", "angular speed", **_POSITIVE)]
RampLimit = Annotated[float, Quantity("acceleration", "angular acceleration", **_POSITIVE)]
Coordinate = Annotated[float, Quantity("length", "angle")]
Duration = Annotated[float, Quantity("time", **_POSITIVE)]
OutputName = Annotated[str, Field(min_length=1)]
Sense = Annotated[str, Known("sense of the motion", tuple(SENSES))]
Steps = Annotated[int, Whole("a number of steps", 1, 1_000_000)]


class UnsteadyTable(Table):
    """A motion of the input from rest to rest: its ends or its duration, its limits, the rows of its table."""

    speed: Limit | None = Field(
        default=None,
        description="v_m: largest speed of the input; it may be absent where both the duration and the end are "
        "given, which settle it.",
    )
    acceleration: RampLimit = Field(description="a_m: largest acceleration of the input.")
    start: Coordinate | None = Field(
        default=None,
        alias="from",
        description="Where the motion begins: the input coordinate, or the value of `output` (default: position 0).",
    )
    end: Coordinate | None = Field(
        default=None, alias="to", description="Where it ends: the input coordinate, or the value of `output`."
    )
    travel: Coordinate | None = Field(default=None, description="Travel of the input with its sign, in place of `to`.")
    duration: Duration | None = Field(
        default=None,
        description="T: duration of the motion; alone it settles the travel, with `to` or `travel` the largest speed.",
    )
    output: OutputName | None = Field(
        default=None,
        description="Output of the mechanism, by its name, whose values `from` and `to` are: "
        "an outreach, an angle (default: the input coordinate).",
    )
    sense: Sense | None = Field(
        default=None,
        description='`"positive"` or `"negative"`: to which side the input moves (default: '
        "positive, or to the nearer end).",
    )
    steps: Steps = Field(
        default=24, description="Rows of the table: equal steps of the time; the instants of the jumps are added."
    )
