"""Values and tables about teeth and the tools that cut them, of pairs and of wheels by themselves."""

import math
from typing import Annotated

from pydantic import Field

from tmmcalc.gears.involute.rack import RACKS
from tmmcalc.spec.choices import Known, Whole, Within
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.table import Table

TEETH = (3, 10_000)
SHIFTS = (-5, 5)
POINTS = 50  # of each curve of a profile, if nothing else is asked
LENGTH = Within("length", "mm", 1e-3, 1e-3, 1e5, bare=2.0)
ANGLE = ("angle", "deg", math.pi / 180)

Module = Annotated[float, Within("length", "mm", 1e-3, 1e-3, 1e3, bare=0.2)]
Helix = Annotated[float, Within(*ANGLE, -60, 60)]
RackName = Annotated[str, Known("basic rack", tuple(RACKS))]
RackAngle = Annotated[float, Within(*ANGLE, 10, 35)]
Addendum = Annotated[float, Number("an addendum in modules", "1", above=0, below=2)]
Clearance = Annotated[float, Number("a clearance in modules", "0.25", at_least=0, at_most=1)]
TipRadius = Annotated[float, Number("a radius of the rack's tip in modules", "0.38", at_least=0, at_most=1)]
Shift = Annotated[float, Number("a shift in modules", "0.5", at_least=SHIFTS[0], at_most=SHIFTS[1])]
Length = Annotated[float, LENGTH]
Thickness = Annotated[float, Number("a tip thickness in modules", "0.25", at_least=0, at_most=1)]
Undercut = Annotated[str, Known("rule for undercut", ("none", "tolerated"))]
Fillet = Annotated[str, Known("section of the fillet", ("ellipse", "circle"))]
Body = Annotated[str, Known("body to measure over", ("balls", "pins"))]
WidthRule = Annotated[str, Known("rule of the face width", ("book", "exact"))]
CutterTeeth = Annotated[int, Whole("a number of teeth", *TEETH)]
CutterShift = Annotated[float, Number("a shift in modules", "0.1", at_least=SHIFTS[0], at_most=SHIFTS[1])]
Rounding = Annotated[float, Number("a rounding in modules", "0.2", at_least=0, at_most=1)]
Points = Annotated[int, Whole("a number of points", 2, 10_000)]


class CutterTable(Table):
    """The pinion-type shaper that cuts a ring."""

    teeth: CutterTeeth = Field(description="Number of teeth of the cutter.")
    shift: CutterShift = Field(default=0.0, description="Shift of the cutter in modules; it falls as it is ground.")
    rounding: Rounding = Field(default=0.0, description="Radius of the rounding of its tips, in modules.")
    tip_diameter: Length | None = Field(
        default=None, description="Diameter of its tip circle (default: by the rack and its shift)."
    )
