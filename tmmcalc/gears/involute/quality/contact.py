"""Contact ratios of an external pair: of the whole flanks, and of what undercut and fillets leave (4.66-4.69)."""

from __future__ import annotations

from math import pi, sin

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.pair import Pair
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.wheel import Number


@record
class Contact:
    """The active segment A2A1 of the line of action; lengths in normal modules."""

    starts: tuple[Number, Number]  # radii of curvature of wheels 1 and 2 where their contact really begins
    forms: tuple[Number, Number]  # rho_F1, rho_F2: radii of curvature where their involutes begin
    margins: tuple[Number, Number]  # N1A2 - rho_F1, N2A1 - rho_F2 (4.70); negative: interference on that wheel
    transverse: Number  # eps_alpha of the whole flanks
    shortened: Number  # eps_alpha of the involutes that there are
    overlap: float  # eps_beta

    @property
    def total(self) -> Number:
        """eps_gamma = eps_alpha + eps_beta of the whole flanks (4.69)."""
        return self.transverse + self.overlap


def overlap_ratio(helix: float, face_width: float) -> float:
    """eps_beta of a face width in normal modules (4.68).

    >>> from math import radians
    >>> round(overlap_ratio(radians(15), 40 / 5), 6)
    0.659077
    """
    return face_width * sin(abs(helix)) / pi


def contact(pair: Pair, face_width: float = 0.0, fillet: Shape = "ellipse") -> Contact:
    """Where the contact begins and ends, and the contact ratios; ``face_width`` in normal modules.

    The printed (4.70) compares with the wrong ends: wheel 1 meets the tip of wheel 2 at N1A2.
    """
    forms = junction(pair.first, fillet).curvature_radius, junction(pair.second, fillet).curvature_radius
    first, second = pair.starts
    starts = np.maximum(first, forms[0]), np.maximum(second, forms[1])
    return Contact(
        starts,
        forms,
        (first - forms[0], second - forms[1]),
        pair.contact_ratio,
        (pair.length - starts[0] - starts[1]) / pair.first.base_pitch,
        overlap_ratio(pair.first.helix, face_width),
    )
