"""The kinds of ``[synthesis]`` with closed forms: slider-crank, slotted links, crank-rocker, trailing rod."""

import math
from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Within
from tmmcalc.spec.quantities import Length, Number, Size
from tmmcalc.spec.table import Table

_ANGLE = ("angle", "deg", math.pi / 180)

WorkingSpeed = Annotated[float, Within("speed", "m/min", 1 / 60, 1e-6, 60_000, bare=20.0)]
Pressure = Annotated[float, Within(*_ANGLE, 1e-3, 89.999)]
Swing = Annotated[float, Within(*_ANGLE, 1e-2, 179.99)]
TimeRatio = Annotated[float, Number("a time ratio", "1.4", at_least=1, at_most=100)]
Part = Annotated[float, Number("a ratio", "0.25", above=0, below=1)]
Signed = Annotated[float, Number("a ratio", "0.3", above=-1e3, below=1e3)]
Clearance = Annotated[float, Number("a clearance factor", "1.5", at_least=0, at_most=100)]
VAngle = Annotated[float, Within(*_ANGLE, 1e-2, 180)]
LugAngle = Annotated[float, Within(*_ANGLE, -360, 360)]
LinkRatio = Annotated[float, Number("a ratio of lengths", "6", above=1, at_most=1e4)]


class SliderCrankTable(Table):
    """A slider-crank: three independent sizes, at least one of them a length; any further one is found."""

    stroke: Size | None = Field(default=None, description="S: stroke of the slider.")
    working_speed: WorkingSpeed | None = Field(
        default=None,
        description='v_p: mean speed of the slider on the working stroke, `"3.28 m/s"` or `"72 m/min"`; '
        "it gives the speed of the crank.",
    )
    pressure_working: Pressure | None = Field(
        default=None, description="nu_p: pressure angle on the working stroke where the crank stands across the guide."
    )
    pressure_idle: Pressure | None = Field(
        default=None, description="nu_x: pressure angle on the idle stroke where the crank stands across the guide."
    )
    time_ratio: TimeRatio | None = Field(default=None, description="K: working to idle time.")
    crank_ratio: Part | None = Field(default=None, description="lambda = r/l: crank over rod.")
    offset_ratio: Signed | None = Field(default=None, description="eps = e/r: offset over crank.")
    offset_part: Signed | None = Field(default=None, description="e/S: offset over stroke.")
    crank: Size | None = Field(default=None, description="r: length of the crank.")
    rod: Size | None = Field(default=None, description="l: length of the connecting rod.")
    offset: Length | None = Field(
        default=None, description="e: distance of the guide from the crank's pivot, towards the pin's working side."
    )


class SlottedLinkTable(Table):
    """An oscillating slotted link: stroke and time ratio, the pressure angle or the rod, one size of the layout."""

    stroke: Size = Field(description="S: stroke of the slider.")
    working_speed: WorkingSpeed | None = Field(
        default=None,
        description="v_p: mean speed of the slider on the working stroke; it gives the speed of the crank.",
    )
    time_ratio: TimeRatio = Field(description="K: working to idle time, above 1.")
    pressure_angle: Pressure | None = Field(
        default=None, description="nu_max: largest pressure angle of the rod; or `rod`."
    )
    rod: Size | None = Field(default=None, description="l: length of the rod, in place of the pressure angle.")
    guide: Size | None = Field(
        default=None, description="e: distance of the guide from the slotted link's pivot (default: L + k r)."
    )
    clearance: Clearance = Field(
        default=1.5, description="k of the layout e = L + k r, which finds what is not given of guide and crank."
    )
    crank: Size | None = Field(
        default=None, description="r: length of the crank; or `centres`, and both are found of `guide` too."
    )
    centres: Size | None = Field(
        default=None, description="L: distance of the pivots of crank and slotted link, in place of the crank."
    )


class RotatingSlottedLinkTable(Table):
    """A rotating slotted link: stroke and time ratio, the pressure angle or the rod, the crank or the centres."""

    stroke: Size = Field(description="S: stroke of the slider.")
    working_speed: WorkingSpeed | None = Field(
        default=None,
        description="v_p: mean speed of the slider on the working stroke; it gives the speed of the crank.",
    )
    time_ratio: TimeRatio = Field(description="K: working to idle time, above 1.")
    pressure_angle: Pressure | None = Field(
        default=None, description="nu_max: largest pressure angle of the rod; or `rod`."
    )
    rod: Size | None = Field(default=None, description="l: length of the rod, in place of the pressure angle.")
    crank: Size | None = Field(default=None, description="r: length of the crank; or `centres`.")
    centres: Size | None = Field(
        default=None, description="L: distance of the pivots of crank and slotted link, in place of the crank."
    )
    guide: Length = Field(default=0.0, description="e': distance of the guide from the slotted link's pivot, signed.")


class CrankRockerTable(Table):
    """A crank-rocker: swing and time ratio, one length for the scale; a second size, or the best transmission."""

    swing: Swing = Field(description="2 phi: swing of the rocker.")
    time_ratio: TimeRatio = Field(default=1.0, description="K: longer to shorter time of the swing.")
    crank: Size | None = Field(default=None, description="r: length of the crank.")
    coupler: Size | None = Field(default=None, description="l: length of the coupler.")
    rocker: Size | None = Field(default=None, description="R: length of the rocker.")
    frame: Size | None = Field(default=None, description="L: distance of the pivots.")
    transmission_angle: Pressure | None = Field(
        default=None, description="Least transmission angle, as the second size; without one the best is found."
    )
    largest_ratio: LinkRatio = Field(
        default=6.0,
        description="Largest ratio of the longest link to the crank, where the best transmission is sought.",
    )


class TrailingRodTable(Table):
    """The trailing rod of a V-engine on its master rod: both pistons have equally high top dead centres."""

    v_angle: VAngle = Field(description="beta: angle from the axis of the right cylinder to that of the left one.")
    crank: Size = Field(description="r: length of the crank.")
    rod: Size = Field(description="l: length of the master rod, which drives the right piston.")
    lug: Size = Field(description="l_C: distance of the trailing rod's pin from the crank pin.")
    lug_angle: LugAngle | None = Field(
        default=None, description="alpha: angle of the lug from the master rod; found, or compared where it is given."
    )
    length: Size | None = Field(
        default=None, description="l_4: length of the trailing rod; found, or compared where it is given."
    )
