"""Laws of a step, limits, what is chosen and refused, rollers, efficiency, remarks."""

from __future__ import annotations

from math import degrees, pi, radians

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq
from sparing import sparing

from cams.indexing_scene import SCENES, law_at, task
from tmmcalc.cams.indexing import solve_indexing
from tmmcalc.cams.indexing.bounds import bounds, largest_step, least_step
from tmmcalc.cams.indexing.choice import choose_ratio
from tmmcalc.cams.indexing.flanks import Drive, Flank
from tmmcalc.cams.indexing.handover import crossing, tip, working_tip
from tmmcalc.cams.indexing.laws import StepLaw, constant_ends, is_symmetric, step_law, stepping, symmetric_laws
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.constants import constants
from tmmcalc.cams.laws.own import of_coefficients
from tmmcalc.core.errors import NoSolutionError, UsageError

RIGHT = radians(90)


def two_humps():
    """A symmetric law with s'(1/2) = 0.4 below its largest s'."""
    u = np.polynomial.Polynomial([-1, 2])  # 2k - 1
    rate = ((1 - u**2) ** 2 * (0.4 + 4 * u**2)).integ()
    whole = rate - rate(0)
    return of_coefficients((whole / whole(1)).coef.tolist(), "two humps")


def test_constant_ends_as_the_law_table_has_them() -> None:
    k = np.linspace(0, 1, 41)
    for part, name in ((0.1, "ends"), (0.5, "constant")):
        assert constant_ends(part).at(k)[0] == pytest.approx(law_at(name, k), abs=1e-14)
    for part in (0.0, 0.03, 0.25, 0.37, 0.5):
        law, rest = constant_ends(part), 0.5 - part
        size = 0.5 / (part**2 / 2 + part * rest + rest**2 / 3)
        assert stepping(law).peak == pytest.approx(size * (0.25 + part / 2), rel=1e-14)
        assert law.at(np.array([part / 2]))[2, 0] == pytest.approx(size, rel=1e-14)
        assert is_symmetric(law)
    assert constant_ends(0.0).at(k) == pytest.approx(LAWS["linear"].at(k), abs=1e-13)
    with pytest.raises(UsageError, match=r"constant ends of 0\.6"):
        constant_ends(0.6)


def test_codes_are_laws_of_the_catalogue_where_it_has_them() -> None:
    assert step_law("0000").name == "linear"
    assert step_law("0050").name == "const"
    assert step_law("0025").peak == pytest.approx(stepping(constant_ends(0.25)).peak)
    for name in symmetric_laws():
        assert step_law(name).peak == pytest.approx(constants(LAWS[name]).velocity, rel=1e-12)
    with pytest.raises(UsageError, match="no law of motion"):
        step_law("9999")


def test_a_law_that_is_not_symmetric() -> None:
    with pytest.raises(UsageError, match="not symmetric"):
        stepping(of_coefficients([0, 0, 6, -8, 3], "skew"))


def test_a_law_that_turns_back() -> None:
    with pytest.raises(UsageError, match="turns back") as caught:
        stepping(overshoot())
    assert caught.value.value is not None
    assert caught.value.value < 0


def overshoot():
    """A symmetric law, s' = (1 - u^2)^2 (1 - 1.6 u^2) to scale, u = 2k - 1: below zero beside the ends."""
    u = np.polynomial.Polynomial([-1, 2])
    rate = ((1 - u**2) ** 2 * (1 - 1.6 * u**2)).integ()
    whole = rate - rate(0)
    return of_coefficients((whole / whole(1)).coef.tolist(), "overshoot")


def test_no_value_is_undefined_with_much_friction() -> None:
    found = solve_indexing(task(friction=3.0, pin_friction=2.0)).cam.efficiency
    assert np.all((found.aiding >= 0) & (found.aiding <= 1))
    assert found.mean_against == pytest.approx(0, abs=1e-12)
    assert found.against_share == pytest.approx(1, abs=1e-12)


def test_limits_of_the_step_undo_those_of_lambda() -> None:
    for peak, z2, ratio in ((2.0, 6, 2.4), (1.5, 12, 1.51), (1.76, 8, 1.9)):
        step = least_step(peak, z2, ratio)
        assert bounds(peak, z2, step, 0.8).ratio_min == pytest.approx(ratio, rel=1e-14)
        # in a step of phi_p,max lobe and groove take half a turn each
        assert largest_step(z2, ratio) == pytest.approx(pi - 2 * np.angle(ratio - np.exp(-1j * pi / z2)), rel=1e-14)


@sparing("name", symmetric_laws(), every=4)
def test_the_groove_crosses_itself_below_lambda_min_alone(name: str) -> None:
    peak = step_law(name).peak
    least = bounds(peak, 6, RIGHT, 0.8).ratio_min
    for part, crosses in ((0.97, True), (0.999, True), (1.001, False), (1.05, False)):
        drive = Drive(LAWS[name], 6, RIGHT, part * least, 1.0)
        at = crossing(drive)
        assert (at is not None) == crosses
        assert crosses == crossed(drive)
        if at is not None:
            ends = Flank(drive, "B").points(np.array([at, 1 - at]))
            assert abs(ends[0] - ends[1]) < 1e-12


def crossed(drive: Drive) -> bool:
    """Whether the chords of a fine polygon of the groove cross, by brute force."""
    k = (1 - np.cos(np.linspace(0, pi, 401))) / 2
    k = np.concatenate((k / 2, (2 - k[::-1])[1:] / 2))  # dense about the middle
    points = Flank(drive, "B").points(k)
    a, b = points[:-1, None], points[1:, None]
    c, d = points[None, :-1], points[None, 1:]

    def area(p, q, r):
        return (np.conj(q - p) * (r - p)).imag

    meets = (area(a, b, c) * area(a, b, d) < 0) & (area(c, d, a) * area(c, d, b) < 0)
    return bool(meets.any())


def test_a_law_of_two_humps_is_judged_by_its_middle() -> None:
    law = two_humps()
    assert constants(law).velocity > 1.5 * stepping(law).peak
    found = solve_indexing(task(law=stepping(law), ratio=2.6, roller=None))
    assert found.cam is not None
    assert found.bounds.ratio_min == pytest.approx(1 + 2 * pi * stepping(law).peak / (6 * RIGHT))
    below = task(law=stepping(law), ratio=found.bounds.ratio_min * 0.99)
    with pytest.raises(NoSolutionError, match="crosses itself"):
        solve_indexing(below)


def test_the_tip_against_another_root_finder() -> None:
    for name, given in SCENES.items():
        drive = drive_of(given, given.ratio)
        beta, a = 2 * pi / given.rollers, given.ratio

        def gap(k, name=name, beta=beta, a=a, given=given):
            theta = beta / 2 + beta * float(law_at(name, k))
            return np.arctan2(np.sin(theta), a - np.cos(theta)) - given.step * (k - 0.5)

        assert tip(drive) == pytest.approx(brentq(gap, 0.5, 1.0, xtol=1e-15), abs=1e-13)


def test_lambda_is_chosen_between_its_limits() -> None:
    near = solve_indexing(task(ratio=None, roller=None))
    assert near.ratio == pytest.approx(1.1 * 2.25)
    middle = solve_indexing(task(rollers=8, ratio=None, roller=None))
    assert middle.ratio == pytest.approx((middle.bounds.ratio_min + middle.bounds.ratio_max) / 2)
    narrow = solve_indexing(task(law=step_law("linear"), rollers=12, ratio=None, roller=None))
    assert narrow.ratio == narrow.bounds.ratio_max
    none = solve_indexing(task(law=step_law("linear"), rollers=14, ratio=None, roller=None))
    assert none.bounds.excess > 1  # 1.4 % beyond, which the method tolerates
    assert none.ratio == pytest.approx(1.01 * none.bounds.ratio_min)
    assert any("above lambda_max" in note for note in none.notes)
    free = solve_indexing(task(limit=radians(65), ratio=None, roller=None))
    assert free.bounds.ratio_max is None


def test_what_is_refused_says_what_would_do() -> None:
    with pytest.raises(NoSolutionError, match="loop") as low:
        solve_indexing(task(ratio=2.2))
    assert low.value.limit == pytest.approx(2.25)
    with pytest.raises(NoSolutionError, match="no lambda") as empty:
        choose_ratio(task(rollers=10, ratio=None))
    assert "rollers = 8 or fewer" in empty.value.remedy
    wider = float(empty.value.remedy.split("step_angle of ")[1].split(" deg")[0])
    assert choose_ratio(task(rollers=10, ratio=None, step=radians(wider * 1.001)))[0] > 0
    law = empty.value.remedy.split("law = '")[1].split("'")[0]
    assert choose_ratio(task(rollers=10, ratio=None, law=step_law(law)))[0] > 0
    with pytest.raises(NoSolutionError, match="cut off before its step is over"):
        solve_indexing(task(law=step_law("linear"), rollers=16, ratio=1.38))


def test_the_largest_roller_is_the_limit_that_is_told() -> None:
    found = solve_indexing(task())
    limits = {limit.name: limit.radius for limit in found.cam.roller_limits}
    assert limits["rollers of one row"] == pytest.approx(0.05 * np.sin(pi / 3))
    least = min(limits.values())
    assert solve_indexing(task(roller=least * (1 - 1e-6))).cam is not None
    with pytest.raises(NoSolutionError, match="convex parts of B would be undercut"):
        solve_indexing(task(roller=least * (1 + 1e-6)))
    with pytest.raises(NoSolutionError, match="camshaft"):
        solve_indexing(task(roller=0.02, shaft=0.07))
    with pytest.raises(NoSolutionError, match="neighbours"):
        solve_indexing(task(law=step_law("linear"), step=radians(120), ratio=2.5, roller=0.0434))
    chosen = solve_indexing(task(roller=None))
    assert chosen.roller == pytest.approx(0.7 * least)


def test_the_tip_of_the_lobe_limits_the_roller_where_a_would_end_at_the_middle() -> None:
    for given in SCENES.values():
        drive = drive_of(given, given.ratio)
        end = tip(drive)
        limit = next(each.radius for each in solve_indexing(given).cam.roller_limits if each.name == "tip of the lobe")
        assert working_tip(drive, limit * (1 - 1e-6), end) > 0.5
        assert working_tip(drive, limit * (1 + 1e-6), end) < 0.5
        assert working_tip(drive, 1e-12 * given.wheel, end) == pytest.approx(end, abs=1e-9)


@pytest.mark.slow
def test_means_of_the_efficiency_by_quadrature() -> None:
    """The formulas (12) and (13) as they are printed, with sigma by the pole, integrated by another method."""
    for name in ("3-4-5", "ends"):
        given = SCENES[name]
        found = solve_indexing(given)
        table, (f1, f2) = found.cam.efficiency, found.frictions
        drive = drive_of(given, given.ratio)
        end = found.cam.handover.part

        def both(k, drive=drive, end=end, f1=f1, f2=f2):
            flank = Flank(drive, "A" if k <= end else "B")
            at = np.array([k])
            angle, sigma = abs(float(flank.pressure(at)[0])), float(flank.rise_angle(at)[0])
            against = (1 - f1 * f2 - (f1 + f2) * np.tan(angle)) / (1 + f1 / np.tan(sigma))
            aiding = (1 - f1 / np.tan(sigma)) / (1 - f1 * f2 + (f1 + f2) * np.tan(angle))
            return np.clip(against, 0, 1), np.clip(aiding, 0, 1)

        for i, mean in enumerate((table.mean_against, table.mean_aiding)):
            parts = [
                quad(lambda k, i=i, both=both: float(both(k)[i]), low, high, limit=100, epsabs=1e-7)[0]
                for low, high in ((1e-9, end), (end + 1e-12, 1 - 1e-9))
            ]
            assert mean == pytest.approx(sum(parts), abs=2e-7), name
        dense = np.array([both(k) for k in np.linspace(1e-6, 1 - 1e-6, 801)])
        assert table.against_share == pytest.approx(np.mean(dense[:, 0] <= 0), abs=5e-3)
        assert table.aiding_share == pytest.approx(np.mean(dense[:, 1] <= 0), abs=5e-3)
        inner = slice(1, -1)
        rows = np.array([both(k) for k in found.k[inner]])
        assert table.against[inner] == pytest.approx(rows[:, 0], abs=1e-12)
        assert table.aiding[inner] == pytest.approx(rows[:, 1], abs=1e-12)
        assert np.array_equal(table.aiding_cut[inner], rows[:, 1] <= 0)


def test_the_means_lie_in_the_range_of_the_method() -> None:
    """With f1 = 0.18 a mean over a whole step is about 0.34 to 0.57."""
    for given in SCENES.values():
        assert 0.3 < solve_indexing(given).cam.efficiency.mean_against < 0.6
    smooth = solve_indexing(task(friction=0.0, pin_friction=0.0)).cam.efficiency
    assert smooth.mean_against == pytest.approx(1, abs=1e-12)
    assert smooth.mean_aiding == pytest.approx(1, abs=1e-12)


@pytest.mark.slow
def test_the_largest_pressure_angles_on_a_fine_grid() -> None:
    for given in SCENES.values():
        found = solve_indexing(given)
        drive, end = drive_of(given, given.ratio), found.cam.handover.part
        for name, low, high, reached in (("A", 0, end, found.cam.run_up), ("B", end, 1, found.cam.run_out)):
            k = np.linspace(low, high, 20001)
            most = np.abs(Flank(drive, name).pressure(k)).max()
            assert reached.largest >= most - 1e-15
            assert reached.largest == pytest.approx(most, abs=1e-7)
        assert found.cam.run_out.largest == pytest.approx(max(found.cam.handover.angle, found.start_pressure))
        assert found.cam.run_out.part in (1.0, found.cam.handover.part)


def test_lambda_min_itself_has_a_point_but_no_undefined_value() -> None:
    """The tables of the method are at lambda_min, which is taken, with a warning."""
    given = task(law=step_law("linear"), ratio=2.0, roller=None)
    with pytest.raises(NoSolutionError, match="undercut"):
        solve_indexing(task(law=step_law("linear"), ratio=2.0, roller=0.02))
    found = solve_indexing(given)
    assert found.cam.bottom == 0
    assert found.roller == 0
    assert np.max(np.abs(found.cam.b.working - found.cam.b.pitch)) < 1e-11
    assert any("ends in a point" in note for note in found.notes)
    for flank in (found.cam.a, found.cam.b):
        for values in (flank.bend, flank.curvature, flank.pressure, flank.pitch, flank.working):
            assert np.all(np.isfinite(values))


def test_a_law_by_its_b_alone_gives_limits() -> None:
    found = solve_indexing(task(law=StepLaw("2.9", 1.625), ratio=None, roller=None))
    assert found.cam is None
    assert found.ratio == pytest.approx(1.1 * (1 + 2 * pi * 1.625 / (6 * RIGHT)))
    assert degrees(found.bounds.step_min) < 90
    assert found.k.size == 0


def test_remarks() -> None:
    few = solve_indexing(task(rollers=4, law=step_law("linear"), ratio=3.2, roller=None))
    assert any("2 pairs of rollers" in note for note in few.notes)
    near = solve_indexing(task(ratio=2.26, roller=0.001))
    assert any("sharp" in note for note in near.notes)
    far = solve_indexing(task(ratio=4.2, roller=0.005))
    assert sum("lambda_max" in note for note in far.notes) == 1
    assert any("run-up on A" in note for note in far.notes)
    long = solve_indexing(task(step=radians(170), ratio=2.6))
    assert any("above the recommended" in note for note in long.notes)
    big = solve_indexing(task(roller=0.025))
    assert any("the usual rule" in note for note in big.notes)
