"""Traps of the arithmetic that need no whole scene: whole numbers that are met but for rounding, cosines of one."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tmmcalc.gears.involute.measure.angles import sexagesimal
from tmmcalc.gears.involute.measure.chords import thickness
from tmmcalc.gears.involute.measure.span import span_length, spans
from tmmcalc.gears.involute.wheel import Wheel

ROUNDING = 2.0**-50


@pytest.mark.parametrize("teeth", [4, 5, 6])
@pytest.mark.parametrize(("off", "admitted"), [(-ROUNDING, 0), (0.0, 0), (ROUNDING, 0), (-1e-6, -1), (1e-6, 0)])
def test_a_span_that_the_face_just_bears(teeth: int, off: float, admitted: int) -> None:
    """The number of teeth is the integer part of a quotient that is whole here: rounding must not take a tooth away."""
    wheel = Wheel(40, 0.3, math.radians(20))
    face = span_length(wheel, teeth) * math.sin(wheel.helix) * (1 + off)  # b = W sin(beta), the rule of the textbook
    found = spans(wheel, float(wheel.plain_tip), 1.0, face_width=face)
    assert found.book_teeth == teeth + admitted


@pytest.mark.parametrize("off", [-ROUNDING, -(2.0**-53), 0.0, 2.0**-52, ROUNDING])
def test_a_tooth_measured_at_its_base_circle(off: float) -> None:
    """arccos(r_b/r) has an argument beyond 1 by rounding: the pressure angle there is 0."""
    wheel = Wheel(20, 0.2)
    found = thickness(wheel, wheel.base * (1 + off), float(wheel.plain_tip))
    psi = (math.pi / 2 + 2 * 0.2 * math.tan(math.radians(20))) / 20
    half = psi + math.tan(math.radians(20)) - math.radians(20)
    assert np.isfinite(found.transverse)
    assert found.transverse == pytest.approx(2 * half * wheel.base, rel=1e-9)


@pytest.mark.parametrize("seconds", [59.994, 59.9949, 59.995, 59.9951, 59.99999999, 60.0])
@pytest.mark.parametrize("minutes", [0, 29, 59])
def test_seconds_that_round_up_carry(minutes: int, seconds: float) -> None:
    angle = math.radians(25 + minutes / 60 + seconds / 3600)
    _, whole, parts, rest = sexagesimal(angle)
    assert 0 <= rest < 60
    assert 0 <= parts < 60
    assert 3600 * whole + 60 * parts + rest == pytest.approx(3600 * 25 + 60 * minutes + seconds, abs=0.0051)
