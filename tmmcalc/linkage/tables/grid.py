"""``[mechanism.grid]``: the positions of the input at which everything is computed."""

from pydantic import Field

from tmmcalc.spec.quantities import InputDistance, InputSpan
from tmmcalc.spec.table import Table


class GridTable(Table):
    """Positions of the input: equal steps over a span, or a working and an idle part."""

    positions: int = Field(
        default=24,
        ge=4,
        le=4_000_000,
        description="Number of equal steps over the span; there is one more position than steps, the last closes the "
        "cycle.",
    )
    working: int | None = Field(
        default=None,
        ge=2,
        le=4_000_000,
        description="Equal steps of the working stroke; with `idle` in place of `positions`, so that both dead "
        "centres are positions.",
    )
    idle: int | None = Field(
        default=None, ge=2, le=4_000_000, description="Equal steps of the idle stroke; needs `working`."
    )
    span: InputSpan | None = Field(
        default=None,
        description="Travel of the input that is analysed, from position 0 along the motion, at most a turn "
        "(default: one turn); a driven slider needs it.",
    )
    extra: list[InputDistance] = Field(
        default=[],
        description="Further positions, counted from position 0 along the motion, within the span; "
        "labelled 6', 6'' after position 6.",
    )
    extremes: bool = Field(
        default=False,
        description="Whether the dead centres of all outputs are added as positions if they are not among them.",
    )
