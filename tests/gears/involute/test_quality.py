"""Contact ratios, sliding, verdicts and existence of external pairs."""

import re
from dataclasses import replace
from math import cos, degrees, pi, radians, sin, tan

import numpy as np
import pytest
from scipy.optimize import brentq
from sparing import sparing

from gears.involute.cases import case, wheel
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.measure.angles import sexagesimal
from tmmcalc.gears.involute.pair import Pair, pair_at, pair_of_shifts, sum_of_shifts
from tmmcalc.gears.involute.quality.contact import contact
from tmmcalc.gears.involute.quality.existence import (
    form_over_shifts,
    least_margin,
    least_sum,
    nearest_shifts,
    require_least_sum,
    require_pair,
)
from tmmcalc.gears.involute.quality.sliding import sliding, sliding_extremes, whole_segment
from tmmcalc.gears.involute.quality.verdicts import QualityLimits, checks, worst
from tmmcalc.gears.involute.rack import RACKS, Rack, section
from tmmcalc.gears.involute.wheel import Wheel

M = 5.0  # mm, of the worked cases
CUTTING = {name: rack for name, rack in RACKS.items() if rack.tip_flat > 0}


def book_pair() -> Pair:
    return pair_of_distance(wheel(14, 0.0, 15), wheel(17, 0.0, 15), 85 / M, 0.6)


def pair_of_distance(first: Wheel, second: Wheel, distance: float, x1: float) -> Pair:
    total, angle = sum_of_shifts(first, second, distance)
    return pair_at(replace(first, shift=x1), replace(second, shift=float(total) - x1), float(angle), distance)


def test_ig_s01_rounding_of_the_rack():
    given = case("IG-S01")
    found = [section(Rack(), radians(beta)).radius for beta in given["inputs"]["beta_deg"]]
    assert found == pytest.approx(given["expected"]["rho_t_star"], abs=1e-6)


def pair_values(pair: Pair) -> dict[str, float]:
    found = {
        "alpha_t_deg": degrees(pair.first.section.angle),
        "inv_alpha_t": float(involute(pair.first.section.angle)),
        "inv_alpha_tw": float(involute(pair.angle)),
        "alpha_tw_rad": float(pair.angle),
        "eta": float(pair.stretch),
        "a": M * pair.reference_distance,
        "a_w": M * float(pair.distance),
        "y": float(pair.modification),
        "delta_y": float(pair.shortening),
        "x_sum": float(pair.first.shift + pair.second.shift),
    }
    for i, gear in enumerate(pair.wheels):
        found |= {
            f"r{i + 1}": M * gear.reference,
            f"r_w{i + 1}": M * float(pair.operating[i]),
            f"r_a{i + 1}": M * float(pair.tips[i]),
            f"r_f{i + 1}": M * float(gear.root),
            f"r_b{i + 1}": M * gear.base,
        }
    return found


@pytest.mark.parametrize(
    ("name", "pair"),
    [("IG-S02", pair_of_shifts(wheel(14, 0.52, 15), wheel(27, 0.31, 15))), ("IG-S04", book_pair())],
)
def test_worked_pairs(name, pair):
    expected = case(name)["expected"]
    for key, value in pair_values(pair).items():
        assert value == pytest.approx(expected[key], abs=2e-6 if key[0] in "ar" else 2e-8 if "inv" in key else 1e-6), (
            key
        )
    sign, whole, minutes, seconds = sexagesimal(float(pair.angle))
    assert (sign, whole, minutes) == (1, *expected["alpha_tw_dms"][:2])
    assert seconds == pytest.approx(expected["alpha_tw_dms"][2], abs=0.011)


def test_ig_s04_line_of_action_and_verdict():
    pair, expected = book_pair(), case("IG-S04")["expected"]
    meeting = contact(pair, face_width=40 / M)
    assert M * pair.length == pytest.approx(expected["N1N2"], abs=1e-6)
    assert [M * rho for rho in meeting.forms] == pytest.approx([expected["N1L1"], expected["N2L2"]], abs=1e-6)
    assert [M * rho for rho in pair.starts] == pytest.approx([expected["N1A2"], expected["N2A1"]], abs=1e-6)
    assert meeting.transverse == pytest.approx(expected["eps_alpha"], abs=1e-6)
    assert meeting.shortened == pytest.approx(expected["eps_alpha"], abs=1e-6)
    assert meeting.overlap == pytest.approx(expected["eps_beta"], abs=1e-6)
    assert meeting.total == pytest.approx(expected["eps_gamma"], abs=1e-6)
    radii = [float(np.hypot(wheel.base, rho)) for wheel, rho in zip(pair.wheels, pair.starts, strict=True)]
    assert M * radii[0] == pytest.approx(float(np.hypot(expected["r_b1"], expected["N1A2"])), abs=2e-6)
    assert M * radii[1] == pytest.approx(float(np.hypot(expected["r_b2"], expected["N2A1"])), abs=2e-6)
    found = checks(pair, face_width=40 / M)
    assert worst(found) == "warn"  # the contact ratio is below the wanted 1.2
    assert {check.name for check in found if check.verdict != "ok"} == {"contact ratio"}
    tips = [check.value for check in found if check.name == "tip thickness"]
    assert [M * s for s in tips] == pytest.approx([expected["s_a1_normal"], expected["s_a2_normal"]], abs=1e-6)


def test_ig_s06_sliding_and_pressure():
    rows = case("IG-S06")["expected"]["rows"]
    pair = book_pair()
    found = sliding(pair, np.array([row["rho1"] for row in rows]) / M)
    assert found.theta1 == pytest.approx([row["theta1"] for row in rows], abs=2e-6)
    assert found.theta2 == pytest.approx([row["theta2"] for row in rows], abs=2e-6)
    assert found.pressure == pytest.approx([row["lambda"] for row in rows], abs=1e-6)
    extremes, expected = sliding_extremes(pair), case("IG-S04")["expected"]
    assert extremes.theta1 == pytest.approx(expected["theta1_at_A2"], abs=1e-6)
    assert extremes.theta2 == pytest.approx(expected["theta2_at_A1"], abs=1e-6)
    assert extremes.pressure_start == pytest.approx(expected["lambda_at_A2"], abs=1e-6)
    assert extremes.pressure_pitch == pytest.approx(expected["lambda_at_P"], abs=1e-6)
    assert extremes.pressure_end == pytest.approx(expected["lambda_at_A1"], abs=1e-6)


def test_sliding_against_velocities_of_the_flanks():
    """theta is the relative excess of the tangential velocity of the point of contact along a flank."""
    pair = book_pair()
    low, high = whole_segment(pair)
    at = sliding(pair, np.append(np.linspace(low, high, 15), float(pair.operating[0] * np.sin(pair.angle))))
    assert np.all(at.active)
    pitch = int(np.argmin(np.abs(at.along)))
    assert abs(at.theta1[pitch]) < 1e-14
    assert abs(at.theta2[pitch]) < 1e-14
    line = -np.exp(-1j * float(pair.angle))  # where the contact moves; centres on the imaginary axis, wheel 1 below P
    point = at.along * line
    one, two = (point + 1j * float(pair.operating[0])), (point - 1j * float(pair.operating[1]))
    v1, v2 = 1j * 1.0 * one, -1j / pair.ratio * two
    tangent = 1j * line
    s1, s2 = ((v * np.conj(tangent)).real for v in (v1, v2))
    assert np.allclose((v1 * np.conj(line)).real, (v2 * np.conj(line)).real, rtol=1e-13)
    assert at.theta1 == pytest.approx((s1 - s2) / s1, rel=1e-11, abs=1e-13)
    assert at.theta2 == pytest.approx((s2 - s1) / s2, rel=1e-11, abs=1e-13)


def test_sliding_refuses_the_ends_of_the_line():
    pair = book_pair()
    with pytest.raises(UsageError, match="ends of the line of action"):
        sliding(pair, np.array([0.0]))
    whole = sliding(pair, np.arange(0.1, float(pair.length), 0.4))  # program 1.15
    assert np.all(np.isfinite(whole.theta1))
    assert 0 < np.count_nonzero(whole.active) < whole.active.size


def test_ig_s13_involute_and_infeasible_pair():
    given = case("IG-S13")
    assert inverse_involute(np.array(given["inputs"]["inv_values"])) == pytest.approx(
        given["expected"]["alpha_rad"], abs=1e-10
    )
    with pytest.raises(NoSolutionError, match="not positive") as error:
        require_least_sum(wheel(14, -0.4), wheel(17, -0.4))
    assert error.value.limit == pytest.approx(-0.63472, abs=1e-5)
    assert error.value.value == -0.8
    assert "nearest admissible shifts" in error.value.remedy


@sparing("rack", CUTTING.values(), ids=CUTTING, every=4)
@pytest.mark.parametrize("beta", [0.0, 15.0, 45.0])
@pytest.mark.parametrize(("z1", "z2"), [(12, 17), (30, 30), (20, 1000), (1000, 1000)])
def test_identities(rack, beta, z1, z2):
    helix = radians(beta)
    for x1, x2 in ((0.5, 0.3), (0.6, -0.6), (2.0, 2.0), (0.3, 0.0)):
        pair = pair_of_shifts(Wheel(z1, x1, helix, rack), Wheel(z2, x2, helix, rack))
        scale = float(pair.distance)
        assert pair.clearances == pytest.approx((rack.clearance, rack.clearance), abs=1e-13 * scale)
        thick = sum(float(w.thickness_at(r)) for w, r in zip(pair.wheels, pair.operating, strict=True))
        around = 2 * pi * float(pair.operating[0]) / z1 * float(np.cos(pair.first.helix_at(pair.operating[0])))
        assert thick == pytest.approx(around, abs=1e-12 * scale)
        if abs(x1 + x2) > 1e-9:
            assert float(pair.shortening) > 0
        else:
            assert float(pair.modification) == pytest.approx(0.0, abs=1e-12 * scale)
        tangents = [np.sqrt((tip / w.base) ** 2 - 1) for tip, w in zip(pair.tips, pair.wheels, strict=True)]
        other = (z1 * tangents[0] + z2 * tangents[1] - (z1 + z2) * tan(float(pair.angle))) / (2 * pi)
        assert float(contact(pair).transverse) == pytest.approx(float(other), abs=1e-12 * (z1 + z2))
        back = pair_of_distance(replace(pair.first, shift=0.0), replace(pair.second, shift=0.0), scale, x1)
        assert float(back.second.shift) == pytest.approx(x2, abs=2e-11)
        assert float(back.angle) == pytest.approx(float(pair.angle), abs=1e-12)


def trochoid_crossing(z: int, x: float, beta: float) -> float:
    """rho_F of an undercut wheel by the parametrisation of the ellipse, found by bisection with scipy."""
    gear = wheel(z, x, beta)
    alpha, r, base, k = radians(20), gear.reference, gear.base, cos(radians(beta))
    rho = 0.25 / (1 - sin(alpha))
    xs, ys = (x - 1) * tan(alpha) - rho * cos(alpha), (x - 1) + rho * sin(alpha)

    def point(t):
        y1, x1 = ys + rho * sin(t), (xs + rho * cos(t)) / k
        phi = (x1 - y1 * k / tan(t)) / r
        place = ((x1 - r * phi) + 1j * (y1 + r)) * np.exp(-1j * phi)
        return abs(place), np.arctan2(place.real, place.imag)

    start = brentq(lambda t: point(t)[0] - base, -pi / 2 + 1e-12, -alpha, xtol=1e-15)
    at_t = gear.section.angle

    def gap(t):
        radius, angle = point(t)
        own = np.arccos(min(base / radius, 1.0))
        return angle - (tan(own) - own - tan(at_t) + at_t)

    radius = point(brentq(gap, start, -alpha, xtol=1e-15))[0]
    return float(np.sqrt(radius**2 - base**2))


@pytest.mark.parametrize(("z", "x", "beta"), [(10, 0.0, 0), (8, -0.2, 0), (12, -0.5, 20), (9, 0.1, 40)])
def test_undercut_shortens_the_contact(z, x, beta):
    pair = pair_of_shifts(wheel(z, x, beta), wheel(40, 0.3, beta))
    rho = trochoid_crossing(z, x, beta)
    meeting = contact(pair)
    assert float(meeting.forms[0]) == pytest.approx(rho, abs=1e-9)
    start = max(float(pair.starts[0]), rho)
    shorter = (float(pair.length) - start - float(pair.starts[1])) / pair.first.base_pitch
    assert float(meeting.shortened) == pytest.approx(shorter, abs=1e-9)
    assert float(meeting.shortened) <= float(meeting.transverse)


def named(found, name, gear=None):
    return [check for check in found if check.name == name and gear in (None, check.wheel)]


def test_verdicts_name_the_fault():
    undercut = checks(pair_of_shifts(wheel(10, 0.0), wheel(40, 0.0)))
    assert named(undercut, "undercut", 1)[0].margin == pytest.approx(-0.415111, abs=1e-6)
    assert named(undercut, "undercut", 2)[0].verdict == "ok"
    pointed = named(checks(pair_of_shifts(wheel(12, 1.3), wheel(40, 0.0))), "tip thickness", 1)[0]
    assert pointed.verdict == "fail"
    assert pointed.value < 0
    cut = checks(pair_of_shifts(wheel(14, 1.3), wheel(17, 0.1)))
    assert named(cut, "interference", 1)[0].verdict == "fail"
    assert "the tip of gear 2 cuts into the fillet of gear 1" in named(cut, "interference", 1)[0].text
    both = checks(pair_of_shifts(wheel(8), wheel(8)))
    assert [check.verdict for check in named(both, "undercut")] == ["fail", "fail"]
    strict = checks(pair_of_shifts(wheel(16, 0.0), wheel(40, 0.5)), QualityLimits(undercut=False))
    assert named(strict, "undercut", 1)[0].verdict == "fail"
    tolerated = checks(pair_of_shifts(wheel(16, 0.0), wheel(16, 0.5)))
    assert named(tolerated, "undercut", 1)[0].verdict == "warn"


def test_tips_of_ones_own_lose_the_clearance():
    pair = book_pair()
    longer = replace(pair, tips=(pair.tips[0] + 0.3, pair.tips[1]))
    check = named(checks(longer), "clearance", 2)[0]
    assert (check.value, check.verdict) == (pytest.approx(-0.05, abs=1e-12), "fail")
    assert named(checks(longer), "clearance", 1)[0].verdict == "ok"


def test_nearest_shifts_are_on_the_border_and_nearest():
    """The corner of the strict contour of 14/17 is the known nearest point of the origin."""
    corner = nearest_shifts(wheel(14), wheel(17), QualityLimits(undercut=False))
    assert corner.shifts == pytest.approx(
        (1 - 14 * sin(radians(20)) ** 2 / 2, 1 - 17 * sin(radians(20)) ** 2 / 2), abs=2e-6
    )
    limits = QualityLimits()
    far = nearest_shifts(wheel(14, 0.0), wheel(17, 2.0))
    x1, x2 = (np.array([x]) for x in far.shifts)
    assert 0 <= least_margin(wheel(14), wheel(17), x1, x2, limits)[0] < 1e-6
    rng = np.random.default_rng(3)
    angle, size = rng.uniform(0, 2 * pi, 3000), far.distance * np.sqrt(rng.uniform(0, 0.999, 3000))
    inside = least_margin(wheel(14), wheel(17), size * np.cos(angle), 2.0 + size * np.sin(angle), limits)
    assert np.all(inside < 0)
    assert nearest_shifts(wheel(14, 0.6), wheel(17, 0.5)).distance == 0.0
    assert nearest_shifts(wheel(5, -1.0), wheel(5, -1.0)) is None


@pytest.mark.parametrize("gear", [wheel(5), wheel(14), wheel(30, 0.0, 40), Wheel(16, 0.0, 0.0, RACKS["ISO 53 D"])])
def test_polynomial_of_the_form_radius(gear):
    form = form_over_shifts(gear)
    shifts = np.linspace(max(-1.2, 0.01 - float(gear.root)), 2.0, 501)
    exact = contact(pair_of_shifts(replace(gear, shift=shifts), replace(gear, shift=2.0))).forms[0]
    assert form(shifts) == pytest.approx(exact, abs=1e-10)


def test_nearest_shifts_at_one_centre_distance():
    """The admissible interval of x1 on the line of 1.12219392 begins at 0.09897 (undercut of the pinion)."""
    total = 1.12219392
    at = nearest_shifts(wheel(14, -0.2, 15), wheel(17, total + 0.2, 15), QualityLimits(undercut=False), -pi / 4)
    assert sum(at.shifts) == pytest.approx(total, abs=1e-11)
    assert at.shifts[0] == pytest.approx(0.09897, abs=1e-5)
    thick = QualityLimits(contact_ratio=1.1, tip_thickness=0.4)
    for given, border in ((-0.2, 0.11841), (1.5, 0.81149)):
        near = nearest_shifts(wheel(14, given, 15), wheel(17, total - given, 15), thick, -pi / 4)
        assert near.shifts[0] == pytest.approx(border, abs=1e-5)
    end = nearest_shifts(wheel(14, 1.5, 15), wheel(17, total - 1.5, 15), QualityLimits(undercut=False), -pi / 4)
    assert end.shifts[0] == pytest.approx(1.2052, abs=1e-4)


def test_ig_s09_margins_at_points():
    for row in case("IG-S09")["expected"]["points"]:
        pair = pair_of_shifts(wheel(14, row["x1"]), wheel(17, row["x2"]))
        meeting, found = contact(pair), sliding_extremes(pair)
        assert float(pair.distance) == pytest.approx(row["a_w_over_m"], abs=1e-6)
        to_limit_points = [float(rho - gear.limit) for rho, gear in zip(pair.starts, pair.wheels, strict=True)]
        assert to_limit_points == pytest.approx([row["int1"], row["int2"]], abs=1e-6)
        if row["uc1"] > 0 and row["uc2"] > 0:
            assert meeting.margins == pytest.approx((row["int1"], row["int2"]), abs=1e-6)
        assert meeting.transverse == pytest.approx(row["eps_alpha"], abs=1e-6)
        assert (found.theta1, found.theta2) == pytest.approx((row["theta1_A2"], row["theta2_A1"]), abs=1e-6)
        named_values = {(c.name, c.wheel): c for c in checks(pair)}
        for i in (1, 2):
            assert named_values["tip thickness", i].value == pytest.approx(row[f"s_a{i}"], abs=1e-6)
            assert named_values["undercut", i].value - pair.wheels[i - 1].least_shift == pytest.approx(
                row[f"uc{i}"], abs=1e-6
            )


@pytest.mark.parametrize(("first", "second"), [((14, 1.2), (17, 1.2)), ((8, 0.0), (8, 0.0)), ((14, 1.3), (17, 0.1))])
def test_every_offered_shift_works(first, second):
    """The numbers that the message prints are admissible as they are printed, and not much farther than need be."""
    with pytest.raises(NoSolutionError) as error:
        require_pair(pair_of_shifts(wheel(*first), wheel(*second)))
    offers = re.findall(r"x1 = ([-\d.e]+), x2 = ([-\d.e]+)", error.value.remedy)
    assert offers
    for x1, x2 in offers:
        require_pair(pair_of_shifts(wheel(first[0], float(x1)), wheel(second[0], float(x2))))
    nearest = nearest_shifts(wheel(*first), wheel(*second))
    assert np.hypot(float(offers[0][0]) - first[1], float(offers[0][1]) - second[1]) < nearest.distance + 1e-3


def test_pairs_that_cannot_exist_say_why():
    with pytest.raises(NoSolutionError, match="contact ratio") as error:
        require_pair(pair_of_shifts(wheel(14, 1.2), wheel(17, 1.2)))
    assert "nearest admissible shifts" in error.value.remedy
    with pytest.raises(NoSolutionError, match="pointed"):
        require_pair(pair_of_shifts(wheel(10, 1.2), wheel(60, 0.0)))
    with pytest.raises(NoSolutionError, match="cuts into the fillet of gear 1"):
        require_pair(pair_of_shifts(wheel(14, 1.3), wheel(17, 0.1)))
    with pytest.raises(NoSolutionError, match="undercut"):
        require_pair(pair_of_shifts(wheel(14, 0.1), wheel(40, 0.5)), QualityLimits(undercut=False))
    require_pair(book_pair())


def test_least_sum_is_where_the_angle_vanishes():
    first, second = wheel(14, 0.0, 25), wheel(30, 0.0, 25)
    least = least_sum(first, second)
    assert float(pair_of_shifts(first, replace(second, shift=least + 1e-9)).angle) < 0.01
    assert np.isnan(pair_of_shifts(first, replace(second, shift=least - 1e-9)).angle)


def test_extremes_stay_finite():
    """Every pair of the extremes either is judged with finite numbers or raises with a reason."""
    judged = refused = 0
    for z1 in (5, 17, 1000):
        for z2 in (5, 30, 1000):
            for x1, x2 in ((-1.0, 0.0), (0.0, 0.0), (2.0, -1.0), (2.0, 2.0), (0.7, 0.7)):
                for alpha, beta in ((14.5, 0.0), (30.0, 0.0), (20.0, 45.0), (14.5, 45.0)):
                    rack = Rack(radians(alpha), 1.0, 0.25 if alpha < 25 else 0.1)
                    first, second = (Wheel(z, x, radians(beta), rack) for z, x in ((z1, x1), (z2, x2)))
                    if float(first.shift + second.shift) <= least_sum(first, second):
                        refused += 1
                        continue
                    found = checks(pair_of_shifts(first, second), face_width=10.0)
                    assert all(np.isfinite([check.value, check.margin]).all() for check in found)
                    judged += 1
    assert judged > 100
    assert refused > 5
