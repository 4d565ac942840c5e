"""``[synthesis]``: a linkage by what it is to do; exactly one sub-table says of which kind."""

import math
from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from tmmcalc.spec.choices import Whole, Within
from tmmcalc.spec.deferred import deferred
from tmmcalc.spec.quantities import AngularSpeed
from tmmcalc.spec.table import Table

if TYPE_CHECKING:
    from tmmcalc.linkage.tables.synthesis_dwell import DwellTable
    from tmmcalc.linkage.tables.synthesis_generation import FunctionTable, MotionSynthesisTable, PathTable
    from tmmcalc.linkage.tables.synthesis_kinds import (
        CrankRockerTable,
        RotatingSlottedLinkTable,
        SliderCrankTable,
        SlottedLinkTable,
        TrailingRodTable,
    )
else:
    SliderCrankTable = deferred("tmmcalc.linkage.tables.synthesis_kinds", "SliderCrankTable")
    SlottedLinkTable = deferred("tmmcalc.linkage.tables.synthesis_kinds", "SlottedLinkTable")
    RotatingSlottedLinkTable = deferred("tmmcalc.linkage.tables.synthesis_kinds", "RotatingSlottedLinkTable")
    CrankRockerTable = deferred("tmmcalc.linkage.tables.synthesis_kinds", "CrankRockerTable")
    TrailingRodTable = deferred("tmmcalc.linkage.tables.synthesis_kinds", "TrailingRodTable")
    PathTable = deferred("tmmcalc.linkage.tables.synthesis_generation", "PathTable")
    FunctionTable = deferred("tmmcalc.linkage.tables.synthesis_generation", "FunctionTable")
    MotionSynthesisTable = deferred("tmmcalc.linkage.tables.synthesis_generation", "MotionSynthesisTable")
    DwellTable = deferred("tmmcalc.linkage.tables.synthesis_dwell", "DwellTable")

# The kinds, of which a spec has one: each is a sub-table; a further one joins here and below.
KINDS = (
    "slider_crank",
    "slotted_link",
    "rotating_slotted_link",
    "crank_rocker",
    "trailing_rod",
    "path",
    "function",
    "motion",
    "dwell",
)

Solutions = Annotated[int, Whole("a number of solutions", 1, 50)]
Choose = Annotated[int, Whole("the number of a solution", 1, 50)]
Seed = Annotated[int, Whole("a seed", 0, 2**31 - 1)]
Positions = Annotated[int, Whole("a number of positions", 4, 100_000)]
Transmission = Annotated[float, Within("angle", "deg", math.pi / 180, 0, 89.9)]


class LinkSynthesisTable(Table):
    """The synthesis of a planar linkage: what all kinds share, and one sub-table, the kind."""

    crank_speed: AngularSpeed | None = Field(
        default=None, description="Speed of the crank in the ready spec (default: 1 rad/s, or by `working_speed`)."
    )
    solutions: Solutions = Field(default=5, description="Solutions that are listed, the best first.")
    choose: Choose | None = Field(
        default=None,
        description="Solution that the other tables of the spec are about, from 1 (default: the best).",
    )
    seed: Seed = Field(default=1, description="Seed of the random starts: equal seeds give equal results.")
    transmission: Transmission | None = Field(
        default=None,
        description="Least transmission angle of path, function and motion; below it a solution has a defect "
        "(default: 20 deg).",
    )
    positions: Positions = Field(default=24, description="Positions of the crank in the ready spec.")
    slider_crank: SliderCrankTable | None = Field(
        default=None, description="A slider-crank from stroke, time ratio, pressure angles, ratios."
    )
    slotted_link: SlottedLinkTable | None = Field(
        default=None, description="An oscillating slotted link that drives a slider."
    )
    rotating_slotted_link: RotatingSlottedLinkTable | None = Field(
        default=None, description="A rotating slotted link that drives a slider."
    )
    crank_rocker: CrankRockerTable | None = Field(default=None, description="A crank-rocker from swing and time ratio.")
    trailing_rod: TrailingRodTable | None = Field(
        default=None, description="The trailing rod of a V-engine from the angle between its cylinders."
    )
    path: PathTable | None = Field(default=None, description="A coupler point that passes through points.")
    function: FunctionTable | None = Field(default=None, description="An output that is a function of the input.")
    motion: MotionSynthesisTable | None = Field(default=None, description="A coupler that passes through poses.")
    dwell: DwellTable | None = Field(default=None, description="A six-bar of class IV whose output dwells.")

    @property
    def kind(self) -> str:
        """The kind: the one sub-table that is there."""
        return next(kind for kind in KINDS if getattr(self, kind, None) is not None)
