"""``[reliability]``: a product whose strength falls while shock loads strike it."""

from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Listed, Whole
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.table import Table

Load = Number("a load", "2.5", at_least=0)
Loads = Annotated[list[float], Listed(Load, "[2, 2.5]", 2)]
Readings = Annotated[list[float], Listed(Load, "[2.1, 2.4, 2.2]")]
Rate = Annotated[float, Number("a rate of shocks", "0.36", above=0)]
Strength = Annotated[float, Number("a strength", "2.56", above=0)]
Decay = Annotated[float, Number("a decay in 1 over the unit of time", "2.6e-4", above=0)]
Items = Annotated[int, Whole("a number of items", 1, 1_000_000)]
Time = Annotated[float, Number("a time", "150", above=0)]
Times = Annotated[list[float], Listed(Number("a time", "150", at_least=0), "[100, 150, 200]")]
Rows = Annotated[int, Whole("a number of rows", 2, 100_000)]


class ReliabilityTable(Table):
    """Loads, shocks, strength or a test; times and loads are numbers in any unit, the same throughout."""

    load: Loads | None = Field(
        default=None, description="a and b: the load of a shock is uniform between them; or `readings`."
    )
    readings: Readings | None = Field(
        default=None, description="Loads that were measured, in place of `load`: both are estimated from them."
    )
    rate: Rate = Field(description="h: shocks in a unit of time.")
    strength: Strength | None = Field(default=None, description="r: strength at the beginning.")
    decay: Decay | None = Field(default=None, description="beta: strength falls as r e^(-beta t).")
    items: Items | None = Field(
        default=None, description="m: number of items of a test, in place of `strength` and `decay`."
    )
    least_life: Time | None = Field(default=None, description="t_(1): the shortest life of the test.")
    mean_life: Time | None = Field(default=None, description="Mean life of the test.")
    times: Times = Field(default=[], description="Times at which the reliability is told.")
    until: Time | None = Field(
        default=None, description="End of the table (default: where the reliability R is 0.001)."
    )
    rows: Rows = Field(default=100, description="Equal steps of the table.")
