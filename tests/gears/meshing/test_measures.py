"""What is measured on the wheels of a pair, against the worked cases and by hand."""

from dataclasses import replace
from math import acos, cos, degrees, hypot, pi, radians, sin, sqrt, tan

import pytest

from gears.involute.cases import case
from gears.meshing.pairs import MM, M, given
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.meshing.results import Measures
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import Measuring, PairTask


def wheel_of_s03(b: float, **more) -> Measures:
    task = given(14, 27, 0.52, 0.32, 15, face_width=b * MM, tips=(None, 76.014 * MM))
    return solve_pair(replace(task, measuring=Measuring(**more))).measures[1]


@pytest.mark.parametrize(("name", "b"), [("b40", 40), ("b10", 10)])
def test_ig_s03_span(name, b):
    expected, found = case("IG-S03")["expected"][name], wheel_of_s03(b)
    values = {
        "s_bn": found.base_thickness,
        "p_bn": found.base_pitch,
        "W_star": found.span_tip,
        "W_star_exact": found.span_tip_exact,
        "W_starstar": found.span_width,
        "W_starstar_exact": found.span_width_exact,
        "W": found.span.length,
        "b_min_exact": found.span.width,
    }
    for key, value in values.items():
        assert value / MM == pytest.approx(expected[key], abs=1e-6), key
    assert found.span_teeth == expected["z_w_max"]
    assert found.span.valid == expected["contact_on_involute"]
    assert any("beneath the usable involute" in text for text in found.remarks) != found.span.valid
    lowest = 2 * expected["form_rho_LN"] / cos(radians(14.076078))  # beta_b, by tan(beta) cos(alpha_t)
    assert found.span_lowest / MM == pytest.approx(lowest, abs=1e-5)


def test_exact_rule_and_asked_teeth():
    assert wheel_of_s03(10, rule="exact").span_teeth == 3
    assert wheel_of_s03(40, rule="exact").span_teeth == 5
    asked = wheel_of_s03(40, span_teeth=(None, 4))
    assert asked.span_teeth == 4
    assert asked.span.valid
    assert asked.remarks == ()
    pitch = pi * M * cos(radians(20))
    beyond = wheel_of_s03(40, span_teeth=(None, 8))
    assert beyond.span.length == pytest.approx(asked.span.length + 4 * pitch, rel=1e-13)
    assert not beyond.span.valid
    assert any("beyond the tip circle" in text for text in beyond.remarks)
    assert [row.teeth for row in beyond.spans] == [2, 3, 4, 5, 8]
    narrow = wheel_of_s03(1)
    assert narrow.span is None or not narrow.span.valid
    assert narrow.remarks


def test_ig_s12_chords_and_balls():
    expected = case("IG-S12")["expected"]
    task = given(14, 27, 0.52, 0.31, 15, face_width=40 * MM, measuring=Measuring(balls=(None, 8.5 * MM)))
    found = solve_pair(task).measures[1]
    rows = {row.name: row for row in found.chords}
    for name, row in zip(("reference", "operating", "tip"), expected["at_radius"][1:], strict=True):
        at = rows[name]
        assert at.radius / MM == pytest.approx(row["r_y"], abs=1e-6)
        assert degrees(at.angle) == pytest.approx(row["alpha_y_deg"], abs=2e-6)
        assert degrees(at.helix) == pytest.approx(row["beta_y_deg"], abs=1e-6)
        assert [at.arc / MM, at.chord / MM] == pytest.approx([row["s_ny"], row["chord_s_y"]], abs=2e-6)
        assert at.height / MM == pytest.approx(row["height_h_ay"], abs=2e-6)
    assert found.constant_chord / MM == pytest.approx(expected["constant_chord"], abs=1e-6)
    assert found.constant_chord_height / MM == pytest.approx(expected["constant_chord_height"], abs=1e-6)
    assert found.constant_chord_valid
    assert found.balls.size / MM == pytest.approx(expected["balls_D_8_5"]["M"], abs=1e-6)
    assert found.balls.on_flank
    assert found.balls.clear
    assert found.span.length / MM == pytest.approx(expected["span"]["W"], abs=1e-6)


def test_usual_balls_touch_near_the_middle_of_the_tooth():
    found = solve_pair(given(30, 41, 0.2, 0.1))
    for wheel, measured in zip(found.sizes, found.measures, strict=True):
        assert measured.balls.radius == pytest.approx(wheel.reference + wheel.shift * M, rel=1e-12)
        assert measured.balls.on_flank
        assert measured.balls.clear
        assert 1.5 < measured.balls.diameter / M < 2.0


def test_balls_that_do_not_fit():
    task = given(30, 41, 0.2, 0.1)
    for diameter, text in ((0.1 * MM, "stand in the space"), (30 * MM, "usable involute"), (6 * MM, "stand proud")):
        found = solve_pair(replace(task, measuring=Measuring(balls=(diameter, None)))).measures[0]
        assert any(text in remark for remark in found.remarks), diameter
        assert found.balls is None or not (found.balls.on_flank and found.balls.clear)


def test_pins_on_odd_helical_wheels():
    task = given(27, 40, 0.31, 0.0, 15)
    sizes = [
        solve_pair(replace(task, measuring=Measuring(balls=(8.5 * MM, None), body=body))).measures[0].balls.size
        for body in ("balls", "pins")
    ]
    across = (sizes[0] - 8.5 * MM) / (sizes[1] - 8.5 * MM)
    assert across == pytest.approx(cos(pi / 54), rel=1e-12)


def test_ring():
    """The tooth of a ring is the space of the wheel that fills it."""
    ring = PairTask((20, 60), M, kind="internal", strategy="given", shifts=(0.3, 0.1))
    found = solve_pair(ring)
    measured, sizes = found.measures[1], found.sizes[1]
    assert measured.spans == ()
    assert (measured.span, measured.span_width) == (None, None)
    rows = {row.name: row for row in measured.chords}
    assert rows["reference"].arc == pytest.approx(M * (pi / 2 + 0.2 * tan(radians(20))), rel=1e-13)
    for row in rows.values():
        assert row.arc + row.space == pytest.approx(2 * pi * row.radius / 60, rel=1e-12)
        assert 0 <= row.chord <= row.arc
        half = row.arc / 2 / row.radius
        assert row.height == pytest.approx(row.radius * cos(half) - sizes.tip, abs=1e-15)
    assert measured.balls.on_flank
    assert measured.balls.clear
    assert measured.balls.radius == pytest.approx(sizes.reference - 0.1 * M, rel=1e-12)
    # the normal of the flank runs on through the middle of the ball to the base circle
    centre = sqrt(measured.balls.radius**2 - sizes.base**2) - measured.balls.diameter / 2
    assert measured.balls.size == pytest.approx(2 * hypot(sizes.base, centre) - measured.balls.diameter, rel=1e-12)
    assert measured.constant_chord == pytest.approx(
        M * (pi / 2 * cos(radians(20)) ** 2 + 0.1 * sin(radians(40))), rel=1e-13
    )
    assert measured.constant_chord_valid


def test_constant_chord_of_a_ring_lies_where_its_thickness_says():
    found = solve_pair(PairTask((20, 70), M, kind="internal", strategy="given", shifts=(0.3, 0.1)))
    measured, ring = found.measures[1], found.sizes[1]
    # the radius of the chord's ends, from the middle of the tooth
    radius = ((ring.tip + measured.constant_chord_height) ** 2 + (measured.constant_chord / 2) ** 2) ** 0.5
    angle = acos(ring.base / radius)
    inv = tan(angle) - angle
    half = (pi / 2 + 0.2 * tan(radians(20))) / 70 - (tan(radians(20)) - radians(20)) + inv
    assert 2 * radius * sin(half) == pytest.approx(measured.constant_chord, rel=1e-12)


def test_undercut_wheels_and_stub_teeth():
    found = solve_pair(given(8, 60, 0.1, 0.0, refuse=False, rack=Rack(radians(20), 0.8, 0.3)))
    assert found.measures[0].span_lowest == pytest.approx(
        2 * (found.sizes[0].form ** 2 - found.sizes[0].base ** 2) ** 0.5, rel=1e-12
    )
    assert {row.name for row in found.measures[0].chords} == {"reference", "operating", "tip"}
