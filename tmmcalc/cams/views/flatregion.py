"""Where the axis of a cam under a flat face may stand, as a page moves it: the radius of curvature seen from there.

S'' is laid off across, the displacement dS up, to M. The line at 45 degrees through M cuts dS + S'' off the ordinate:
from the axis, S0 below its zero, up to that place is the radius of the profile, S0 + dS + S'' (5.96, 5.97).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.synthesis.results import Convexity, Synthesis
from tmmcalc.cams.views.motion import CamInMotion
from tmmcalc.cams.views.region import boxed, shown_region
from tmmcalc.core.plane import Plane
from tmmcalc.report.moving import BLUE, FRAME, GREEN, Body, Mark, Reading, Span, Spot, View

NOTE = (
    "S'' is laid off across, the displacement up; the line at 45° through their point M cuts off the radius of "
    "curvature of the profile, from the axis O up"
)


def region_under_face(made: CamInMotion, result: Synthesis) -> Iterator[View]:
    """The region over the turn of the cam; of other followers none."""
    found = result.convexity
    if found is None or not made.profile.flat:
        return
    start, laid = made.follower.start, made.motion[2] + 1j * made.motion[0]
    cut = laid.real + laid.imag
    content = np.concatenate((laid, 1j * cut, [-1j * start]))
    low, high = boxed(content)
    along, still = abs(high - low) * (1 - 1j), made.still(0.0)
    yield shown_region(made, (low, high))._replace(
        bodies=(
            Body("region", still, still, still, tuple(_static(found, laid, low, high))),
            Body("line", still, made.traced(cut), still, (Mark("line", (-along, along)),)),
            Body("point", made.traced(laid.real), made.traced(laid.imag), still, ()),
        ),
        frame=tuple(_lines(found, low, high)),
        spots=(Spot("O", FRAME, -1j * start, "pin"), Spot("M", "point", 0j, "point")),
        spans=(Span("bar", ((FRAME, -1j * start), ("line", 0j))),),
        note=NOTE,
        readings=(Reading("radius of curvature of the profile", "rho", "mm", made.traced(1e3 * (start + cut))),),
    )


def _static(found: Convexity, laid: Plane, low: complex, high: complex) -> Iterator[Mark]:
    """The region under its line, the curve."""
    top = found.least.value - found.limit
    far = abs(high - low)
    corners = [complex(x, top - x) for x in (-far, far)] + [complex(far, low.imag - far), complex(-far, low.imag - far)]
    yield Mark("gear", tuple(corners), tone=GREEN)
    yield Mark("line", (*laid.tolist(), complex(laid[0])), tone=BLUE)


def _lines(found: Convexity, low: complex, high: complex) -> Iterator[Mark]:
    """Both axes of what is laid off, the tangent of the curve."""
    far = abs(high - low)
    yield Mark("axis", (complex(low.real, 0), complex(high.real, 0)))
    yield Mark("axis", (complex(0, low.imag), complex(0, high.imag)))
    yield Mark("axis", (complex(-far, found.least.value + far), complex(far, found.least.value - far)), tone=BLUE)
