"""``[mechanism.grid]``: the positions of the input at which everything is computed."""

from pydantic import Field

from tmmcalc.spec.quantities import InputDistance, InputSpan
from tmmcalc.spec.table import Table


class GridTable(Table):
    """Positions of the input: equal steps over a span, or a working and an idle part."""

    positions: int = Field(
        default=24, ge=4, le=4_000_000, description="Number of equal steps of the input over its span."
    )
    working: int | None = Field(
        default=None,
        ge=2,
        le=4_000_000,
        description="Number of equal steps over the working stroke, with idle in place of positions.",
    )
    idle: int | None = Field(
        default=None, ge=2, le=4_000_000, description="Number of equal steps over the idle stroke; needs working."
    )
    span: InputSpan | None = Field(
        default=None,
        description="Travel from position 0 along the motion, at most a turn (default: one full turn); "
        "a prismatic input needs it.",
    )
    extra: list[InputDistance] = Field(
        default=[], description="Additional positions, counted from position 0 along the motion, within the span."
    )
    extremes: bool = Field(default=False, description="Whether the dead centres of the outputs are added as positions.")
