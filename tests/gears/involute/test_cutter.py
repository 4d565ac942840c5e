"""The cutter of a ring: its tip, and where it cuts the ring's tips away, against the motion itself."""

from math import cos, pi, radians

import numpy as np
import pytest

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.internal.cutter import cutter_margins, largest_tip, tip_lead
from tmmcalc.gears.involute.internal.ring import Cutter, Ring, cutting
from tmmcalc.gears.involute.wheel import Wheel

TIP = 29.0 + 0.3  # of the ring


def ring_cut_by(z0: int, **more: float) -> Ring:
    return Ring(60, -0.3, cutter=Cutter(z0, **more))


def inside(ring: Ring, points: np.ndarray, roll: np.ndarray, centre: np.ndarray) -> bool:
    """Whether points of the ring's axes lie within teeth of the cutter, turned by ``roll`` about ``centre`` on +Y."""
    z0 = ring.cutter.teeth
    tool = Wheel(z0, ring.cutter.shift)
    *_, top = cutting(ring, ring.cutter)
    away = points - 1j * centre
    radius, angle = np.abs(away), np.angle(away) - pi / 2 - roll
    beside = np.abs((angle + pi / z0) % (2 * pi / z0) - pi / z0)
    within = (radius > tool.base) & (radius < top)
    half = np.asarray(tool.half_angle_at(np.maximum(radius, tool.base)))
    return bool(np.any(within & (beside < half - 1e-9)))


def corners(ring: Ring) -> np.ndarray:
    """The tips' corners of all teeth of the ring, with a space on +Y."""
    half = pi / 60 - ring.half_angle_at(TIP)
    axes = pi / 2 + 2 * pi / 60 * np.arange(60)
    return TIP * np.exp(1j * np.concatenate([axes - half, axes + half]))


def collides(ring: Ring) -> bool:
    """Whether a corner enters a tooth of the cutter as both turn at the generating distance."""
    _, a, _ = cutting(ring, ring.cutter)
    turn = np.linspace(0, 2 * pi / 60, 2001)[:, None]
    return inside(ring, corners(ring) * np.exp(1j * turn), turn * 60 / ring.cutter.teeth, np.full_like(turn, a))


def trims(ring: Ring) -> bool:
    """Whether a corner enters a tooth as the cutter moves in along Y, in any position of the teeth."""
    _, a, _ = cutting(ring, ring.cutter)
    for turn in np.linspace(0, 2 * pi / 60, 41):
        depth = np.linspace(a - 4, a, 401)[:, None]
        if inside(ring, corners(ring) * np.exp(1j * turn), turn * 60 / ring.cutter.teeth, depth):
            return True
    return False


@pytest.mark.parametrize("z0", [25, 46, 52, 56, 57, 59])
def test_margins_tell_what_the_motion_does(z0):
    ring = ring_cut_by(z0)
    trochoid, feed = cutter_margins(ring, ring.cutter, TIP)
    assert (trochoid < 0) == collides(ring)
    assert (feed < 0) == trims(ring)


def test_a_rounded_tip_is_no_worse_than_its_points():
    ring = ring_cut_by(50, rounding=0.2)
    sharp = ring_cut_by(50)
    assert cutter_margins(ring, ring.cutter, TIP)[1] > cutter_margins(sharp, sharp.cutter, TIP)[1]


def test_largest_tip():
    tool = Wheel(25, 0.1)
    assert largest_tip(tool, 0.0) == pytest.approx(float(tool.pointing), rel=1e-12)
    top = largest_tip(tool, 0.2)
    # the rounding then has its centre on the axis of the tooth and touches both involutes
    orbit = top - 0.2
    arm = np.sqrt(orbit**2 - tool.base**2)
    half = float(tool.half_angle) + float(involute(radians(20)))
    assert half - (arm + 0.2) / tool.base + np.arctan2(arm, tool.base) == pytest.approx(0, abs=1e-12)
    assert tip_lead(tool, top + 0.01, 0.2) < 0 < tip_lead(tool, top - 0.01, 0.2)
    assert tip_lead(tool, 12.5 * cos(radians(20)), 0.1) is None


@pytest.mark.parametrize(("cutter", "text"), [(Cutter(60), "does not fit"), (Cutter(59, 0.5), "its shift x0 = 0.5")])
def test_cutters_that_cannot_make_the_ring(cutter, text):
    with pytest.raises(NoSolutionError, match=text) as told:
        cutting(Ring(60, -0.3), cutter)
    assert "pinion" not in str(told.value)
    assert "cutter" in told.value.remedy or "shift" in told.value.remedy or "teeth" in told.value.remedy
