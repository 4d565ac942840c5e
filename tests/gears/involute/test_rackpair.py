"""A pinion on a rack: the limit of an external pair with an infinite wheel."""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from gears.involute.cases import wheel
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.pair import pair_of_shifts
from tmmcalc.gears.involute.quality.sliding import sliding
from tmmcalc.gears.involute.rackpair import rack_pair, rack_sliding
from tmmcalc.gears.involute.wheel import Wheel


@pytest.mark.parametrize(("z", "x", "beta"), [(20, 0.0, 0), (14, 0.4, 15), (40, -0.3, 30)])
def test_limit_of_a_large_wheel(z, x, beta):
    rack, teeth = rack_pair(wheel(z, x, beta)), 10_000_000
    pair = pair_of_shifts(wheel(z, x, beta), wheel(teeth, 0.0, beta))
    assert rack.contact_ratio == pytest.approx(float(pair.contact_ratio), abs=1e-4)
    assert rack.segment[0] == pytest.approx(float(pair.starts[0]), abs=1e-4)
    rho = np.linspace(max(rack.segment[0], 0.5), rack.segment[1], 5)
    found, large = rack_sliding(rack, rho), sliding(pair, rho)
    assert found.theta1 == pytest.approx(large.theta1, abs=1e-4)
    assert found.theta2 == pytest.approx(large.theta2, abs=1e-5)
    assert found.pressure == pytest.approx(large.pressure, abs=1e-5)
    assert found.along == pytest.approx(large.along, abs=1e-4)


def test_geometry_by_hand():
    pair = rack_pair(wheel(25, 0.2))
    assert (pair.distance, pair.travel) == (12.7, pytest.approx(25 * pi))
    assert pair.clearances == pytest.approx((0.25, 0.25))
    assert pair.margin == pytest.approx(0.0, abs=1e-14)  # the rack's tip meets the limit point
    assert pair.shortened == pytest.approx(pair.contact_ratio)
    assert pair.overlap(10.0) == 0.0
    assert rack_pair(wheel(25, 0.2, 20)).overlap(10.0) == pytest.approx(10 * sin(radians(20)) / pi)
    theta = rack_sliding(pair, np.array([pair.pitch_curvature]))
    assert abs(theta.theta1[0]) < 1e-15
    assert theta.active[0]


def test_undercut_shortens_the_contact():
    pair = rack_pair(wheel(10))
    assert pair.segment[0] < 0
    assert pair.margin < 0
    assert pair.shortened < pair.contact_ratio


def test_refusals():
    with pytest.raises(NoSolutionError, match="within the base circle"):
        rack_pair(Wheel(80, -1.0), tip=40 * cos(radians(20)) - 0.1)
    with pytest.raises(UsageError):
        rack_sliding(rack_pair(wheel(20)), np.array([-0.1]))
