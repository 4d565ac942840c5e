"""The textbook's tables 4.18 and of the fillet, and the table of a whole flank."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from gears.involute.profile.envelope import CASES
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.pair import Pair, pair_of_shifts
from tmmcalc.gears.involute.profile.flank import flank_of
from tmmcalc.gears.involute.profile.tables import axis_turn, fillet_table, main_profile
from tmmcalc.gears.involute.wheel import Wheel


@pytest.fixture
def pair() -> Pair:
    return pair_of_shifts(Wheel(13, 0.25), Wheel(30, 0.15))


def columns(name: str, *keys: str) -> np.ndarray:
    return np.array([[row[key] for key in keys] for row in CASES[name]["expected"]["table"]]).T


def test_main_profile(pair: Pair) -> None:
    flank = flank_of(pair.first, float(pair.tips[0]))
    turn = axis_turn(pair.first, "pitch", float(pair.angle))
    assert turn == pytest.approx(CASES["IG-S05"]["expected"]["gamma_rad"], abs=6e-10)
    phi, x, y, radius = columns("IG-S05", "phi", "X_T", "Y_T", "R_T")
    table = main_profile(flank, turn, rolls=phi[1:-1])
    assert table.roll == pytest.approx(phi, abs=1e-7)
    for found, expected in ((table.x, x), (table.y, y), (table.radius, radius)):
        assert 5 * found == pytest.approx(expected, abs=2e-6)


def test_main_profile_of_an_undercut_wheel_begins_at_the_form_radius() -> None:
    flank = flank_of(Wheel(10))
    table = main_profile(flank, 0.0, 8)
    assert len(table.roll) == 9
    assert table.roll[-1] == flank.rolls.form > flank.rolls.limit
    assert np.hypot(table.x[-1], table.y[-1] + flank.wheel.base) == pytest.approx(flank.form, rel=1e-14)
    assert np.diff(table.roll) == pytest.approx((flank.rolls.form - flank.rolls.tip) / 8)


def test_fillet(pair: Pair) -> None:
    flank = flank_of(pair.second, float(pair.tips[1]), "circle")
    turn = axis_turn(pair.second, "pitch", float(pair.angle))
    names = ("phi", "X_S", "Y_S", "X", "Y", "R_S", "R")
    phi, *expected = columns("IG-S07", *names)
    outside = np.array([-0.5, 0.1])
    table = fillet_table(flank, turn, np.concatenate([outside, phi[1:-1]]))
    inner = [table.centre_x, table.centre_y, table.x, table.y, table.centre_radius, table.radius]
    for found, column in zip(inner, expected, strict=True):
        assert 5 * found[2:-2] == pytest.approx(column[1:-1], abs=1e-5)
        assert 5 * found[-1] == pytest.approx(column[0], abs=1e-5)  # D
        assert 5 * found[-2] == pytest.approx(column[-1], abs=1e-5)  # L
    assert table.cut.tolist() == [False, False] + [True] * 6
    assert np.all(table.x[:2] == 0)
    assert np.all(table.radius[:2] == 0)
    # the path of S goes on outside
    assert np.all(table.centre_radius > 0)


@pytest.mark.parametrize("x", [0.95, 1 - 0.25 * np.sin(np.radians(20)) / (1 - np.sin(np.radians(20)))])
def test_fillet_with_the_centre_beyond_the_rolling_line(x: float) -> None:
    flank = flank_of(Wheel(30, float(x)), shape="circle")
    ends = flank.rolls
    middle = np.linspace(ends.root, ends.limit, 7)[1:-1]
    table = fillet_table(flank, axis_turn(flank.wheel, "tooth"), middle)
    assert all(np.all(np.isfinite(column)) for column in (table.x, table.y, table.centre_radius, table.radius))
    points = (table.x + 1j * (table.y + flank.wheel.base))[table.cut]
    assert np.angle(points[:-1]) - pi / 2 == pytest.approx(flank.half_angle_at(np.abs(points[:-1])), abs=1e-9)
    assert table.cut.sum() == (7 if x == 0.95 else 2)  # S on the line: the whole fillet is cut at one roll


def test_axes() -> None:
    wheel = Wheel(20, 0.3)
    assert axis_turn(wheel, "reference") == 0
    assert axis_turn(wheel, "tooth") - axis_turn(wheel, "space") == pytest.approx(pi / 20)
    with pytest.raises(UsageError):
        axis_turn(wheel, "pitch")


def test_book_table_needs_the_circle() -> None:
    with pytest.raises(UsageError, match="circular"):
        fillet_table(flank_of(Wheel(20, 0.1, 0.3)), 0.0, np.zeros(1))
