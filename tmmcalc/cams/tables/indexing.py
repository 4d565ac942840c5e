"""``[indexing]``: two paired cams that turn a wheel of rollers step by step."""

import math
from typing import Annotated

from pydantic import Field

from tmmcalc.cams.tables.cam_parts import Distance, Pressure, Size
from tmmcalc.cams.tables.indexing_law import StepLaw
from tmmcalc.spec.choices import Listed, Whole, Within
from tmmcalc.spec.quantities import Friction, Number
from tmmcalc.spec.table import Table

_ANGLE = ("angle", "deg", math.pi / 180)

Rollers = Annotated[int, Whole("a number of rollers", 4, 100)]
StepAngle = Annotated[float, Within(*_ANGLE, 1, 179.999)]
Lambda = Annotated[float, Number("a ratio of centre distance and wheel radius", "2.6", above=1, at_most=1000)]
Dwells = Annotated[list[float], Listed(Within(*_ANGLE, 0.1, 358), '["60 deg", "120 deg"]', 2)]
Radii = Annotated[list[float], Listed(Within("length", "mm", 1e-3, 1e-6, 1e5, bare=2.0), '["12 mm", "10 mm"]', 2)]
Rows = Annotated[int, Whole("a number of steps", 2, 100_000)]


class IndexingTable(Table):
    """A cam-lantern indexing mechanism: rollers and step, sizes that are given (the others are chosen), friction."""

    rollers: Rollers = Field(
        description="z2: rollers of the wheel, even, half of them in each of its two rows; usual are 6 to 14."
    )
    step_angle: StepAngle = Field(
        description="phi_p: angle of the cams during one step, below 180 deg; each dwell takes 180 deg - phi_p, "
        "unless `dwells` are given."
    )
    law: StepLaw = Field(
        description='Law of motion of a step, symmetric about its middle: a name as in `[cam]`, a code `"00ee"` for '
        "an acceleration that is constant over ee percent of the time at each end, or a table."
    )
    wheel_radius: Size = Field(description="l_k: radius on which the rollers stand.")
    centre_distance: Size | None = Field(
        default=None,
        description="a: distance of the shafts of cams and wheel (default: chosen within its limits); or `ratio`.",
    )
    ratio: Lambda | None = Field(default=None, description="lambda = a/l_k, in place of the centre distance.")
    roller_radius: Size | None = Field(
        default=None,
        description="r_r: radius of the rollers (default: 0.7 of the least of its limits by curvature and pitch).",
    )
    roller_radii: Radii | None = Field(
        default=None,
        description='In place of `roller_radius`: radii of the rollers of the first row and of the second, `["12 mm", '
        '"10 mm"]`; those of one row are equal, for they run on one cam.',
    )
    dwells: Dwells | None = Field(
        default=None,
        description="Angles of the cams of the dwell after the step by the first cam and after that by the second, "
        '`["60 deg", "120 deg"]`; with two steps they are a turn (default: equal, 180 deg - phi_p each).',
    )
    pressure_angle: Pressure = Field(
        default=math.radians(50),
        description="theta_d: largest pressure angle, which decides lambda_max; usual are 45 to 50 deg.",
    )
    friction: Friction = Field(default=0.18, description="f1: coefficient of friction of the rollers on the cams.")
    pin_friction: Friction | None = Field(
        default=None,
        description="f2: coefficient of friction of the rollers on their pins (default: 1.27 of `friction`).",
    )
    shaft_radius: Distance = Field(default=0.0, description="Radius of the camshaft that the groove has to clear.")
    steps: Rows = Field(default=20, description="Rows of tables: equal parts of the step.")
    tolerance: Size = Field(default=1e-6, description="Chord error of exported curves.")
