"""``[bearing]``: a rolling bearing, its speeds and the frequencies of its defects."""

import math
from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Listed, Whole, Within
from tmmcalc.spec.quantities import AngularSpeed, Number, Quantity
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}

Size = Annotated[float, Quantity("length", **_POSITIVE)]
Speed = Annotated[float, Quantity("speed", **_POSITIVE)]
Count = Annotated[int, Whole("a number of rolling bodies", 3, 1000)]
Angle = Annotated[float, Within("angle", "deg", math.pi / 180, 0, 89)]
Readings = Annotated[list[float], Listed(Number("a reading", "4.2", above=0), "[4.2, 5.6]")]


class BearingTable(Table):
    """The bearing of a wheel, or of a shaft by its speed."""

    speed: AngularSpeed | None = Field(
        default=None, description="omega: speed of the shaft; or `wheel_speed` and `wheel_diameter`."
    )
    wheel_speed: Speed | None = Field(default=None, description="v: speed of the wheel's rim, in place of `speed`.")
    wheel_diameter: Size | None = Field(default=None, description="D: diameter of that wheel.")
    inner: Size = Field(description="Diameter of the inner ring.")
    outer: Size = Field(description="Diameter of the outer ring; the rolling bodies are halfway between the rings.")
    roller: Size = Field(description="d: diameter of the rolling bodies.")
    count: Count = Field(description="z: rolling bodies in a row.")
    contact_angle: Angle = Field(default=0.0, description="phi: contact angle.")
    peak: Readings | None = Field(
        default=None, description="Peaks of the vibration, one reading after the other, in any unit."
    )
    rms: Readings | None = Field(default=None, description="RMS of the vibration of these readings.")
