"""Contact ratios, sliding and pressure of a pinion in a ring.

theta1 = 1 - rho2/(u rho1),  theta2 = 1 - u rho1/rho2,  lambda = 1/rho1 - 1/rho2,  rho2 = rho1 + N1N2
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.internal.pair import InternalPair
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.contact import overlap_ratio
from tmmcalc.gears.involute.quality.sliding import Sliding, SlidingExtremes, slide
from tmmcalc.gears.model import Values


@record
class InternalContact:
    """The active segment of an internal pair; lengths in normal modules."""

    segment: tuple[float, float]  # rho1 where the contact begins and ends on the involutes that there are
    transverse: float  # eps_alpha of the whole flanks
    shortened: float  # eps_alpha of the involutes that there are
    overlap: float  # eps_beta

    @property
    def total(self) -> float:
        """eps_gamma of the whole flanks."""
        return self.transverse + self.overlap


def internal_contact(pair: InternalPair, face_width: float = 0.0, fillet: Shape = "ellipse") -> InternalContact:
    """Contact ratios with the whole flanks, and with what fillets and undercut leave of them."""
    start, end = pair.segment
    form = float(junction(pair.pinion, fillet).curvature_radius)
    low, high = max(start, form), min(end, pair.ring.curvature_at(pair.ring.form) - pair.length)
    pitch, overlap = pair.pinion.base_pitch, overlap_ratio(pair.pinion.helix, face_width)
    return InternalContact((low, high), (end - start) / pitch, (high - low) / pitch, overlap)


def internal_sliding(pair: InternalPair, rho1: Values, segment: tuple[float, float] | None = None) -> Sliding:
    """theta and lambda at radii of curvature of the pinion (n,), all positive.

    ``segment`` is rho1 at both ends of the active segment, by default A2 and A1. Raises `UsageError` at N1 and beyond.
    """
    rho1 = np.atleast_1d(np.asarray(rho1, dtype=float))
    if not np.all(rho1 > 0):
        raise UsageError(
            "sliding is not defined at the base point of the pinion and beyond",
            where="sliding",
            limit=0.0,
            remedy="points beyond N1",
        )
    g, (low, high) = pair.length, segment if segment is not None else pair.segment
    rho2 = rho1 + g
    theta1, theta2 = slide(rho1, rho2, pair.ratio)
    pitch = float(pair.operating[0] * np.sin(pair.angle))
    inside = (rho1 >= low - 1e-12 * high) & (rho1 <= high * (1 + 1e-12))
    return Sliding(rho1, rho1 - pitch, theta1, theta2, g / (rho1 * rho2), inside)


def internal_extremes(pair: InternalPair, segment: tuple[float, float] | None = None) -> SlidingExtremes:
    """The largest sliding and pressure; both begin with their largest values of the pinion at A2.

    Raises `UsageError` if the segment reaches N1.
    """
    low, high = segment if segment is not None else pair.segment
    pitch = float(pair.operating[0] * np.sin(pair.angle))
    at = internal_sliding(pair, np.array([low, pitch, high]), (low, high))
    first, middle, last = (float(value) for value in at.pressure)
    return SlidingExtremes(float(at.theta1[0]), float(at.theta2[2]), first, middle, last, first)
