"""The lowest point of the involute: the polynomial of a contour against the exact crossing, and its limit."""

from __future__ import annotations

from math import atan2, cos, pi, radians, sin, tan

import numpy as np
import pytest

from tmmcalc.gears.involute.contour.side import form_of
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.rack import RACKS
from tmmcalc.gears.involute.wheel import Wheel


@pytest.mark.parametrize(("teeth", "helix"), [(5, 0), (8, 30), (14, 0), (17, 15), (30, 40)])
def test_polynomial_against_the_exact_crossing(teeth, helix):
    wheel = Wheel(teeth, 0.0, radians(helix))
    x = np.linspace(-1.0, wheel.least_shift, 40)[:-1]
    exact = np.asarray(junction(Wheel(teeth, x, radians(helix))).curvature_radius)
    value, slope = form_of(wheel, -1.0)(x)
    assert np.max(np.abs(value - exact)) < 2e-11
    h = 1e-6
    shifted = [form_of(wheel, -1.0)(x[1:-1] + d)[0] for d in (-h, h)]
    assert slope[1:-1] == pytest.approx((shifted[1] - shifted[0]) / (2 * h), abs=1e-6)


@pytest.mark.parametrize("rack", ["GOST 13755", "ISO 53 D", "stub 20", "AGMA 14.5"])
@pytest.mark.parametrize(("teeth", "helix", "x"), [(8, 0, 0.0), (10, 15, -0.2), (25, 30, -1.5), (6, 0, 0.3)])
def test_the_crossing_lies_on_fillet_and_involute(rack, teeth, helix, x):
    """The envelope of the tip rounding by scipy's root finder, from its points in the rack's axes."""
    from scipy.optimize import brentq

    wheel = Wheel(teeth, x, radians(helix), RACKS[rack])
    if wheel.limit >= 0:
        pytest.skip("not undercut")
    tool, beta, alpha, alpha_t = RACKS[rack], radians(helix), RACKS[rack].angle, wheel.section.angle
    depth, rho, r, base = tool.addendum + tool.clearance, tool.radius, wheel.reference, wheel.base
    low = tool.straight - x  # depth of b below the pitch line
    x_s, y_s = -low * tan(alpha) - rho * cos(alpha), x - depth + rho

    def gap(t):
        """Angle from the involute to the fillet at the point t of the rounding."""
        along, up = (x_s + rho * cos(t)) / cos(beta), y_s + rho * sin(t)
        phi = (along - up * cos(beta) / tan(t)) / r
        px = (along - r * phi) * cos(phi) + (up + r) * sin(phi)
        py = -(along - r * phi) * sin(phi) + (up + r) * cos(phi)
        tangent = np.sqrt(max((px**2 + py**2) / base**2 - 1, 0.0))
        return atan2(px, py) - (tangent - np.arctan(tangent) - tan(alpha_t) + alpha_t), base * tangent

    t = -alpha - np.linspace(1e-4, 1 - 1e-9, 4000) * (pi / 2 - alpha)
    values = [gap(v) for v in t]
    k = next(k for k in range(1, t.size) if values[k - 1][0] < 0 <= values[k][0] and values[k][1] > 0)
    root = brentq(lambda v: gap(v)[0], t[k - 1], t[k], xtol=1e-15)
    assert float(junction(wheel).curvature_radius) == pytest.approx(gap(root)[1], abs=1e-9)


def test_half_of_the_lack_remains_at_the_limit_of_undercut():
    wheel = Wheel(12)
    x = wheel.least_shift - np.array([1e-3, 1e-5, 1e-7])
    ratio = np.asarray(junction(Wheel(12, x)).curvature_radius) / -Wheel(12, x).limit
    assert np.all(np.abs(ratio - 0.5) < [1e-3, 1e-5, 1e-7])
