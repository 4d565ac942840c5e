"""The table of events: an angle or a speed that is rounding is printed as zero."""

from __future__ import annotations

import math

import pytest

from tmmcalc.machine.facts.timed import within


@pytest.mark.parametrize("turns", [-3, 0, 1, 4000])
@pytest.mark.parametrize("noise", [-1e-12, -1e-15, 0.0, 1e-15, 1e-12])
def test_an_angle_beside_a_whole_turn_is_one(turns: int, noise: float) -> None:
    assert within(2 * math.pi * turns + noise) == 0.0


def test_an_angle_within_the_turn() -> None:
    assert within(math.radians(-30)) == pytest.approx(330, rel=1e-14)
    assert within(math.radians(365)) == pytest.approx(5, rel=1e-12)
