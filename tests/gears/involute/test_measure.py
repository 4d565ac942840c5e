"""Thickness, chords, spans and balls; angles as printed."""

from math import atan, cos, degrees, pi, radians, sin, tan

import mpmath
import numpy as np
import pytest

from gears.involute.cases import case, wheel
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.measure.angles import dms, sexagesimal
from tmmcalc.gears.involute.measure.balls import ball_diameter, over_balls, usual_diameter
from tmmcalc.gears.involute.measure.chords import base_pitch_normal, constant_chord, thickness
from tmmcalc.gears.involute.measure.span import mid_flank_teeth, span_length, spans
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.involute.wheel import Wheel

M = 5.0  # mm, of the worked cases


@pytest.mark.parametrize("name", ["b40", "b10"])
def test_ig_s03_span(name):
    given = case("IG-S03")
    expected, gear = given["expected"][name], wheel(27, 0.32, 15)
    found = spans(gear, 76.014 / M, float(gear.limit), {"b40": 40, "b10": 10}[name] / M)
    span = found.over(found.book_teeth)
    pairs = {
        "s_n": found.thickness,
        "s_bn": found.base_thickness,
        "p_bn": found.base_pitch,
        "W_star": found.limits.tip,
        "W_star_exact": found.limits.tip_exact,
        "W_starstar": found.limits.width,
        "W_starstar_exact": found.limits.width_exact,
        "W": span.length,
        "contact_rho": span.curvature,
        "form_rho_LN": found.limits.lowest * cos(gear.section.base_helix) / 2,
        "b_min_exact": span.width,
    }
    for key, value in pairs.items():
        assert value * M == pytest.approx(expected[key], abs=1e-6), key
    assert found.book_teeth == expected["z_w_max"]
    assert span.valid == expected["contact_on_involute"]
    assert [each.teeth for each in found.table] == list(range(2, {"b40": 5, "b10": 4}[name] + 1))
    assert found.over(found.recommended).valid


def test_ig_s12_thickness_chords_balls_span():
    given = case("IG-S12")
    expected, gear, tip = given["expected"], wheel(27, 0.31, 15), given["inputs"]["r_a"] / M
    rows = expected["at_radius"]
    at = thickness(gear, np.array([row["r_y"] for row in rows]) / M, tip)
    names = {"s_ty": at.transverse, "s_ny": at.normal, "chord_s_y": at.chord, "height_h_ay": at.height}
    for key, values in names.items():
        assert values * M == pytest.approx([row[key] for row in rows], abs=2e-6), key
    assert np.degrees(at.pressure_angle) == pytest.approx([row["alpha_y_deg"] for row in rows], abs=2e-6)
    assert np.degrees(at.helix) == pytest.approx([row["beta_y_deg"] for row in rows], abs=1e-6)
    chord = constant_chord(gear, tip, float(gear.limit))
    assert chord.chord * M == pytest.approx(expected["constant_chord"], abs=1e-6)
    assert chord.height * M == pytest.approx(expected["constant_chord_height"], abs=1e-6)
    assert chord.valid
    ball, balls = over_balls(gear, 8.5 / M, tip, float(gear.limit)), expected["balls_D_8_5"]
    assert degrees(ball.angle) == pytest.approx(balls["alpha_D_deg"], abs=1e-6)
    assert [ball.centres * M, ball.size * M] == pytest.approx([balls["d_D"], balls["M"]], abs=1e-6)
    assert ball.on_flank
    assert ball.clear
    found = spans(gear, tip, float(gear.limit), 40 / M)
    assert found.book_teeth == expected["span"]["z_w_max"]
    assert found.over(5).length * M == pytest.approx(expected["span"]["W"], abs=1e-6)


@pytest.mark.parametrize("alpha", [14.5, 20.0, 30.0])
@pytest.mark.parametrize("beta", [0.0, 20.0, 45.0])
@pytest.mark.parametrize("z", [5, 30, 1000])
def test_span_against_high_precision(z, beta, alpha):
    mpmath.mp.dps = 40
    a, b = mpmath.radians(mpmath.mpf(alpha)), mpmath.radians(mpmath.mpf(beta))
    at = mpmath.atan(mpmath.tan(a) / mpmath.cos(b))
    for x in (-1.0, 0.0, 2.0):
        gear = Wheel(z, x, radians(beta), Rack(radians(alpha)))
        for k in (2, 7):
            exact = mpmath.cos(a) * (mpmath.pi * (k - 0.5) + 2 * x * mpmath.tan(a) + z * (mpmath.tan(at) - at))
            assert span_length(gear, k) == pytest.approx(float(exact), rel=2e-14, abs=1e-14)


def test_span_is_the_distance_of_the_flanks():
    """Spur: the plates touch where a tangent of the base circle cuts the outer flanks; its length between them is W."""
    gear = wheel(23, 0.4)
    base, alpha = gear.base, gear.section.angle
    start = gear.half_angle + float(involute(alpha))  # half the angle of a tooth on the base circle
    for k in (2, 3, 4):
        turned = (k - 1) * pi / 23 + start  # from the middle of the k teeth to the foot of the outer involute
        rho = base * turned  # the involute unwound down to the middle
        assert span_length(gear, k) == pytest.approx(2 * rho, rel=1e-14)
    found = spans(gear, float(gear.plain_tip), float(gear.limit))
    for span in found.table:
        assert span.valid == (float(gear.limit) <= span.curvature <= float(gear.curvature_at(gear.plain_tip)))
    assert found.limits.width is None


def test_recommended_span_touches_near_the_middle():
    for z in (12, 30, 80, 200):
        for x in (-0.2, 0.0, 0.5):
            gear = wheel(z, x, 10)
            found = spans(gear, float(gear.plain_tip), max(float(gear.limit), 0.0))
            middle = gear.reference + x
            nearest = min(found.table, key=lambda span: abs(span.radius - middle))
            assert abs(found.recommended - nearest.teeth) <= 1
            assert found.over(found.recommended).valid
    assert mid_flank_teeth(wheel(30)) == 4


def test_relief_and_face_width_bound_the_span():
    gear = wheel(40, 0.0, 30)
    whole = spans(gear, float(gear.plain_tip), float(gear.limit))
    relieved = spans(gear, float(gear.plain_tip), float(gear.limit), relief=float(gear.plain_tip) - 0.5)
    assert relieved.limits.tip < whole.limits.tip
    narrow = spans(gear, float(gear.plain_tip), float(gear.limit), face_width=0.5)
    assert narrow.recommended is None
    assert not any(span.valid for span in narrow.table)


def test_constant_chord_does_not_depend_on_the_number_of_teeth():
    chords = [float(constant_chord(wheel(z, 0.2), z / 2 + 1.2, 0.0).chord) for z in (10, 50, 1000)]
    assert chords == pytest.approx([chords[0]] * 3)
    # where it ends the normal makes the angle alpha with the chord, on the tooth's own symmetric rack
    gear = wheel(30, 0.2)
    end = constant_chord(gear, 16.2, 0.0)
    radius = float(np.hypot(gear.base, end.curvature))
    half = float(gear.half_angle_at(radius))
    assert 2 * radius * sin(half) == pytest.approx(float(end.chord), rel=1e-13)
    assert 16.2 - radius * cos(half) == pytest.approx(float(end.height), rel=1e-13)
    assert not constant_chord(wheel(10, -0.6), 5.4, 2.3).valid
    assert not constant_chord(wheel(10, -0.6), 5.1, 1.5).valid


@pytest.mark.parametrize("beta", [0.0, 25.0])
def test_chords_of_spur_teeth_are_plain_trigonometry(beta):
    gear = wheel(19, 0.3, beta)
    at = thickness(gear, gear.reference, gear.plain_tip)
    assert at.normal + at.space == pytest.approx(pi, rel=1e-14)
    if not beta:
        half = at.normal / 2 / gear.reference
        assert at.chord == pytest.approx(2 * gear.reference * sin(half), rel=1e-14)
        assert at.height == pytest.approx(gear.plain_tip - gear.reference * cos(half), rel=1e-13)
    assert base_pitch_normal(gear) == pytest.approx(gear.base_pitch * cos(gear.section.base_helix), rel=1e-14)


def test_pointing_radius():
    for z, x, beta in ((5, 0.7, 0), (30, 0.0, 20), (1000, 2.0, 45)):
        gear = wheel(z, x, beta)
        assert float(gear.thickness_at(gear.pointing)) == pytest.approx(0.0, abs=1e-12 * gear.reference)


def helicoid_distance(gear: Wheel, diameter: float, centre: float) -> float:
    """Least distance from a ball's centre on the middle of a space to a flank, minus its radius; brute force."""
    base, lead = abs(gear.base), abs(gear.reference) / tan(gear.helix) if gear.helix else np.inf
    foot = gear.half_angle + involute(gear.section.angle)

    def space(rho):
        return np.abs(pi / gear.teeth - foot + (rho / base - np.arctan(rho / base)))

    lows, highs = np.array([1e-6, -diameter]), np.array([centre * 1.2, diameter])
    for _ in range(12):
        rho, z = np.meshgrid(np.linspace(lows[0], highs[0], 61), np.linspace(lows[1], highs[1], 61))
        radius = np.hypot(base, rho)
        angle = space(rho) + z / lead
        d = np.sqrt(radius**2 + centre**2 - 2 * radius * centre * np.cos(angle) + z**2)
        k = np.unravel_index(np.argmin(d), d.shape)
        width = (highs - lows) / 10
        middle = np.array([rho[k], z[k]])
        lows, highs = middle - width, middle + width
        lows[0] = max(lows[0], 1e-6)
    return float(d.min()) - diameter / 2


@pytest.mark.parametrize(
    ("z", "x", "beta"), [(27, 0.31, 15), (12, 0.4, 0), (40, 0.0, 30), (-60, 0.2, 0), (-61, -0.3, 20)]
)
def test_balls_touch_the_flanks(z, x, beta):
    """Direct distance from the centre of the ball to the helicoid."""
    gear = wheel(z, x, beta)
    diameter = usual_diameter(gear)
    assert 1.4 < diameter < 2.4
    ball = over_balls(gear, diameter, abs(float(gear.plain_tip)), 1e3 if z < 0 else 0.0)
    assert ball.radius == pytest.approx(abs(gear.reference + x), rel=1e-12)
    assert helicoid_distance(gear, diameter, ball.centres / 2) == pytest.approx(0.0, abs=1e-9)
    assert ball.on_flank
    assert ball.clear
    side = np.sign(z)
    across = ball.centres * (cos(pi / (2 * z)) if z % 2 else 1.0)
    assert ball.size == pytest.approx(across + side * diameter, rel=1e-15)


def test_pins_of_helical_wheels_with_odd_teeth_stand_opposite():
    gear = wheel(27, 0.31, 15)
    balls, pins = (over_balls(gear, 1.7, 15.2, 0.0, body=body) for body in ("balls", "pins"))
    assert pins.size - 1.7 == pytest.approx(balls.centres)
    assert balls.size < pins.size
    assert pins.width == pytest.approx(pi / sin(radians(15)) / 2)
    spur = [over_balls(wheel(27, 0.31), 1.7, 15.2, 0.0, body=body).size for body in ("balls", "pins")]
    assert spur[0] == spur[1]


def test_balls_that_are_too_small_say_so():
    with pytest.raises(NoSolutionError, match="beyond the base circle") as error:
        over_balls(wheel(30), 0.5, 16.0, 0.0)
    least = error.value.limit
    assert over_balls(wheel(30), least * (1 + 1e-9), 16.0, 0.0).angle < 0.01
    assert not over_balls(wheel(30), 3.2, 16.0, 0.0).on_flank
    assert ball_diameter(wheel(30), 15.0) == pytest.approx(usual_diameter(wheel(30)))


def test_degrees_minutes_seconds():
    assert sexagesimal(radians(25 + 18 / 60 + 59.999 / 3600)) == (1, 25, 19, 0.0)
    assert sexagesimal(radians(29 + 59 / 60 + 59.996 / 3600)) == (1, 30, 0, 0.0)
    assert dms(radians(-0.5)) == "-0°30'00.00\""
    assert dms(-1e-12) == "0°00'00.00\""
    assert dms(atan(1), 0) == "45°00'00\""
    for angle in np.random.default_rng(1).uniform(-7, 7, 200):
        sign, whole, minutes, seconds = sexagesimal(float(angle))
        assert 0 <= minutes < 60
        assert 0 <= seconds < 60
        assert sign * (whole + minutes / 60 + seconds / 3600) == pytest.approx(degrees(angle), abs=0.0051 / 3600)
    with pytest.raises(UsageError):
        dms(float("nan"))
