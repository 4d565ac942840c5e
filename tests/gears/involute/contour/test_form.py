"""The lowest point of the involute against the tooth profile's own search."""

from __future__ import annotations

from math import radians

import numpy as np
import pytest

from tmmcalc.gears.involute.contour.form import form_curvature, form_of
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.wheel import Wheel


@pytest.mark.parametrize(("teeth", "helix"), [(5, 0), (8, 30), (14, 0), (17, 15), (30, 40)])
def test_form_curvature_and_its_polynomial(teeth, helix):
    wheel = Wheel(teeth, 0.0, radians(helix))
    x = np.linspace(-1.0, wheel.least_shift, 40)[:-1]
    exact = form_curvature(Wheel(teeth, x, radians(helix)))
    assert exact == pytest.approx(junction(Wheel(teeth, x, radians(helix))).curvature_radius, abs=1e-8)
    value, slope = form_of(wheel, -1.0)(x)
    assert np.max(np.abs(value - exact)) < 2e-11
    h = 1e-6
    shifted = [form_of(wheel, -1.0)(x[1:-1] + d)[0] for d in (-h, h)]
    assert slope[1:-1] == pytest.approx((shifted[1] - shifted[0]) / (2 * h), abs=1e-6)


def test_half_of_the_lack_remains_at_the_limit_of_undercut():
    wheel = Wheel(12)
    x = wheel.least_shift - np.array([1e-3, 1e-5, 1e-7])
    ratio = form_curvature(Wheel(12, x)) / -Wheel(12, x).limit
    assert np.all(np.abs(ratio - 0.5) < [1e-3, 1e-5, 1e-7])
