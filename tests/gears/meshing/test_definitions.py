"""Quantities of pairs by the formulas of the textbook, written out again: whole flanks, spans, sliding, strength."""

from __future__ import annotations

from dataclasses import replace
from math import acos, cos, floor, hypot, pi, radians, sin, sqrt, tan

import numpy as np
import pytest

from gears.involute.cases import case
from gears.meshing.pairs import MM, M, book, given
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.meshing.blocking import solve_blocking
from tmmcalc.gears.meshing.remeasure import remeasured
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.sliding import sliding_at, sliding_steps
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import Measuring, PairTask

ALPHA = radians(20)
SHORT = given(10, 20, 0.15, 0.3, 12, face_width=30 * MM, refuse=False)  # N1A2 < rho_F of an undercut pinion
HELICAL = given(14, 27, 0.52, 0.31, 15, face_width=40 * MM)


def inv(angle: float) -> float:
    return tan(angle) - angle


def span_of(z: int, x: float, beta: float, teeth: int) -> float:
    """W [m] (4.58), closed form."""
    inner = pi * (teeth - 0.5) + 2 * x * tan(ALPHA) + z * inv(tan_t(beta))
    return M * cos(ALPHA) * inner


def tan_t(beta: float) -> float:
    """alpha_t."""
    return float(np.arctan(tan(ALPHA) / cos(radians(beta))))


def most(found: MeshPair, wheel: int, beta: float, width: float) -> int:
    """z_w,max (4.65) with a limit of the face width."""
    size, task = found.sizes[wheel - 1], found.task
    least = min(2 * sqrt(size.tip**2 - size.base**2), width)
    base = span_of(size.teeth, task.shifts[wheel - 1] or 0.0, beta, 1)
    return floor((least - base) / (pi * M * cos(ALPHA)) + 1 + 1e-9)


class TestWholeFlanks:
    """Where A2 lies on the line of action the values are those at A2, whatever undercut leaves."""

    found = solve_pair(SHORT)

    def test_values_of_the_formulas(self) -> None:
        found, (one, two) = self.found, self.found.sizes
        start = found.distance * sin(found.angle_w) - sqrt(two.tip**2 - two.base**2)
        g = found.distance * sin(found.angle_w)
        assert 0 < start < sqrt(one.form**2 - one.base**2)
        assert found.peaks is not None
        assert found.peaks.theta1 == pytest.approx(1 - (g - start) / (2 * start), rel=1e-12)
        assert found.peaks.pressure_start == pytest.approx(M * g / (start * (g - start)), rel=1e-12)
        assert one.active == pytest.approx(hypot(one.base, start), rel=1e-14)
        assert (found.peaks.theta1, found.peaks.pressure_start) == pytest.approx((-29.93941, 9.92566), abs=1e-5)
        assert one.active / MM == pytest.approx(23.95940, abs=1e-5)
        beta = 30 * MM * sin(radians(12)) / (pi * M)
        assert found.total == pytest.approx(found.contact_ratio + beta, rel=1e-14)
        assert found.total == pytest.approx(1.683407, abs=1e-6)

    def test_what_is_left_stands_beside(self) -> None:
        found, one = self.found, self.found.sizes[0]
        low = sqrt(one.form**2 - one.base**2)
        g = found.distance * sin(found.angle_w)
        assert found.peaks_left is not None
        assert found.peaks_left.theta1 == pytest.approx(1 - (g - low) / (2 * low), rel=1e-11)
        assert one.active_left == pytest.approx(one.form, rel=1e-14)
        assert found.total_left == pytest.approx(found.shortened + found.overlap, rel=1e-14)
        assert found.total_left < found.total

    def test_no_difference_without_undercut(self) -> None:
        found = solve_pair(HELICAL)
        assert found.peaks == found.peaks_left
        for size in found.sizes:
            assert size.active == pytest.approx(size.active_left, rel=1e-14)

    def test_beyond_the_line_there_is_only_what_is_left(self) -> None:
        found = solve_pair(given(8, 60, 0.0, 0.0, refuse=False))
        assert found.line.start < 0
        assert found.peaks is not None
        assert found.peaks == found.peaks_left
        assert found.sizes[0].active == found.sizes[0].active_left


class TestSpans:
    def test_the_exact_rule_relaxes_the_face_width_alone(self) -> None:
        """15/40: W*/cos(beta_b) would admit a tooth more than W*."""
        task = given(15, 40, 0.3, 0.2, 15, face_width=60 * MM)
        for rule in ("book", "exact"):
            found = solve_pair(replace(task, measuring=Measuring(rule=rule)))
            beta = radians(15) if rule == "book" else float(np.arcsin(sin(radians(15)) * cos(ALPHA)))
            assert found.measures[0].span_teeth == most(found, 1, 15, 60 * MM / sin(beta)) == 3
            assert found.measures[1].span_teeth == most(found, 2, 15, 60 * MM / sin(beta))
            assert (found.measures[0].span_most, found.measures[0].span_most_exact) == (3, 3)

    def test_one_tooth_is_no_span(self) -> None:
        found = solve_pair(given(5, 80, 0.6, 0.1, 12, face_width=4 * MM, refuse=False))
        for number, measured in enumerate(found.measures, 1):
            assert measured.span_most == max(most(found, number, 12, 4 * MM / sin(radians(12))), 0)
            assert measured.span_most < 2
            assert measured.span_teeth is None
            assert [row.teeth for row in measured.spans][:3] == [2, 3, 4]
            assert any("admits no span: z_w,max" in remark for remark in measured.remarks)
        with pytest.raises(UsageError, match="not measured over 1"):
            remeasured(Pairs((found,), "", ()), teeth=1)

    def test_what_the_rule_does_not_admit_is_listed(self) -> None:
        found = solve_pair(given(14, 27, 0.51, 0.32, 15, face_width=5 * MM))
        measured = found.measures[1]
        assert measured.span_most == most(found, 2, 15, 5 * MM / sin(radians(15))) == 1
        assert [row.teeth for row in measured.spans] == [2, 3, 4]
        for row in measured.spans:
            assert row.length == pytest.approx(span_of(27, 0.32, 15, row.teeth), rel=1e-13)
            assert not row.book
        asked = remeasured(Pairs((found,), "", ()), teeth=4).pairs[0].measures[1]
        assert (asked.span_teeth, asked.span_most) == (4, 1)

    def test_the_lowest_active_point_bounds_them(self) -> None:
        found = solve_pair(book())
        wheel, measured, g = found.sizes[1], found.measures[1], found.line.length
        helix = float(np.arcsin(sin(radians(15)) * cos(ALPHA)))
        low = g - sqrt(found.sizes[0].tip ** 2 - found.sizes[0].base ** 2)  # N2A1
        assert measured.usable == "active"
        assert measured.span_lowest_active == pytest.approx(2 * low / cos(helix), rel=1e-12)
        assert measured.span_lowest < measured.spans[0].length < measured.span_lowest_active
        assert [row.valid for row in measured.spans] == [False, True, True]
        assert measured.spans[0].curvature == pytest.approx(measured.spans[0].length * cos(helix) / 2, rel=1e-13)
        assert measured.spans[0].radius == pytest.approx(hypot(wheel.base, measured.spans[0].curvature), rel=1e-13)
        assert solve_pair(SHORT).measures[0].usable == "form"


def test_ig_s12_circles_balls_and_constant_chord() -> None:
    expected = case("IG-S12")["expected"]
    pairs = Pairs((solve_pair(HELICAL),), "", ())
    measured = remeasured(pairs, ball=8.5 * MM, radii=[67 * MM]).pairs[0].measures[1]
    row, at = measured.chords[-1], expected["at_radius"][0]
    values = (row.transverse, row.arc, row.chord, row.height)
    wanted = [at[key] for key in ("s_ty", "s_ny", "chord_s_y", "height_h_ay")]
    assert [value / MM for value in values] == pytest.approx(wanted, abs=2e-6)
    psi = (pi / 2 + 0.62 * tan(ALPHA)) / 27
    theta = psi + inv(tan_t(15)) - inv(acos(measured_base() / (67 * MM)))
    assert (row.name, row.half_angle) == ("asked", pytest.approx(theta, rel=1e-12))
    balls = expected["balls_D_8_5"]
    assert np.degrees(measured.balls.angle) == pytest.approx(balls["alpha_D_deg"], abs=1e-5)
    assert measured.balls.centres / MM == pytest.approx(balls["d_D"], abs=1e-5)
    helix = float(np.arcsin(sin(radians(15)) * cos(ALPHA)))
    reach = measured_base() * tan(measured.balls.angle) - 8.5 * MM * cos(helix) / 2
    assert measured.balls.curvature == pytest.approx(reach, rel=1e-12)
    foot = measured_base() * tan(tan_t(15)) + measured.constant_chord * cos(helix) / (2 * cos(ALPHA))
    assert measured.constant_chord_curvature == pytest.approx(foot, rel=1e-12)
    assert measured.span.curvature / MM == pytest.approx(expected["span"]["contact_rho"], abs=1e-6)


def measured_base() -> float:
    return 27 * M / (2 * cos(radians(15))) * cos(tan_t(15))


def test_circles_off_the_flanks_are_told() -> None:
    pairs = Pairs((solve_pair(SHORT),), "", ())
    one = pairs.pairs[0].sizes[0]
    between = (one.base + one.form) / 2
    measured = remeasured(pairs, radii=[90 * MM, between]).pairs[0].measures[0]
    assert [row.name for row in measured.chords] == ["reference", "operating", "tip", "asked"]
    assert any("90 mm does not cut the flanks" in remark for remark in measured.remarks)
    assert any("cuts the fillet" in remark for remark in measured.remarks)
    with pytest.raises(UsageError, match="circle"):
        remeasured(pairs, radii=[0.0])


def test_ig_s06_sliding_at_points() -> None:
    rows = case("IG-S06")["expected"]["rows"]
    found = sliding_at(solve_pair(book()), [row["rho1"] * MM for row in rows])
    assert found.theta1 == pytest.approx([row["theta1"] for row in rows], abs=2e-6)
    assert found.theta2 == pytest.approx([row["theta2"] for row in rows], abs=2e-6)
    assert found.pressure == pytest.approx([row["lambda"] for row in rows], abs=1e-6)
    assert found.active[1:-1].all()


@pytest.mark.parametrize(
    "task", [book(), PairTask((20, 60), M, kind="internal", strategy="zero"), PairTask((20, 0), M, kind="rack")]
)
def test_sliding_in_steps(task: PairTask) -> None:
    """rho1 = 0.5, 2.5, 4.5 mm ...; the curvatures of the mate by its own base circle."""
    found = solve_pair(task)
    table = sliding_steps(found, 2 * MM)
    assert table.rho1 / MM == pytest.approx(np.arange(len(table.rho1)) * 2 + 0.5, rel=1e-12)
    g = found.distance * sin(found.angle_w)
    if task.kind == "external":
        assert g - 2 * MM <= table.rho1[-1] < g
        rho2, u = g - table.rho1, task.teeth[1] / task.teeth[0]
    elif task.kind == "internal":
        rho2, u = g + table.rho1, task.teeth[1] / task.teeth[0]
    else:
        pitch = found.line.pitch
        assert table.theta1 == pytest.approx(1 - pitch / table.rho1, rel=1e-12)
        assert table.pressure == pytest.approx(M / table.rho1, rel=1e-12)
        return
    assert table.theta1 == pytest.approx(1 - rho2 / (u * table.rho1), rel=1e-11)
    assert table.theta2 == pytest.approx(1 - u * table.rho1 / rho2, rel=1e-11)
    assert table.pressure == pytest.approx(M * g / (table.rho1 * rho2), rel=1e-11)


@pytest.mark.parametrize("step", [0.0, -1 * MM, 1.0, 1e-9])
def test_steps_that_make_no_table(step: float) -> None:
    with pytest.raises(UsageError, match="steps"):
        sliding_steps(solve_pair(book()), step)


def form_factor(z: float, x: float, tip: float) -> tuple[float, float, float]:
    """Y_F, s_Fn, h_F of a spur wheel with the tip radius, by fixed-point iteration; modules."""
    rho = 0.25 / (1 - sin(ALPHA))
    e = pi / 4 - 1.25 * tan(ALPHA) - (1 - sin(ALPHA)) * rho / cos(ALPHA)
    g, h = rho - 1.25 + x, 2 / z * (pi / 2 - e) - pi / 3
    v = pi / 6
    for _ in range(200):
        v = 2 * g / z * tan(v) - h
    chord = z * sin(pi / 3 - v) + sqrt(3) * (g / cos(v) - rho)
    at = acos(z * cos(ALPHA) / (2 * tip))
    load = at - ((pi / 2 + 2 * x * tan(ALPHA)) / z + inv(ALPHA) - inv(at))
    arm = 0.5 * (z * (cos(ALPHA) / cos(load) - cos(pi / 3 - v)) + rho - g / cos(v))
    return 6 * arm * cos(load) / (chord**2 * cos(ALPHA)), chord, arm


@pytest.mark.parametrize("tips", [(None, None), (42.0 * MM, 49.0 * MM)])
def test_form_factors_of_the_real_tips(tips: tuple[float | None, float | None]) -> None:
    found = solve_pair(given(14, 17, 0.6, 0.522, tips=tips))
    for size in found.sizes:
        factor, chord, arm = form_factor(size.teeth, size.shift, size.tip / M)
        assert size.strength is not None
        assert size.strength.factor == pytest.approx(factor, rel=1e-9)
        assert (size.strength.chord / M, size.strength.arm / M) == pytest.approx((chord, arm), rel=1e-9)
    ring = solve_pair(PairTask((20, 60), M, kind="internal", strategy="zero"))
    assert ring.sizes[0].strength is not None
    assert ring.sizes[1].strength is None


def test_half_angles_and_least_teeth() -> None:
    """Teeth without backlash fill the operating pitch circle; z_min is the number that LN = 0 asks for."""
    for task in (book(), PairTask((20, 60), M, kind="internal", strategy="given", shifts=(0.3, 0.1))):
        found = solve_pair(task)
        one, two = found.sizes
        filled = one.operating_half_angle * one.operating + two.operating_half_angle * two.operating
        assert filled == pytest.approx(pi * one.operating / one.teeth, rel=1e-12)
        assert one.operating_half_angle == pytest.approx(one.half_angle - found.turn, abs=1e-14)
        for size in found.sizes:
            assert size.arc == pytest.approx(2 * size.reference * size.half_angle, rel=1e-12)
    expected, found = case("IG-S04")["expected"], solve_pair(book())
    assert found.turn == pytest.approx(expected["gamma_rad"], abs=1e-9)
    for number, size in enumerate(found.sizes, 1):
        assert size.tip_arc / MM == pytest.approx(expected[f"s_a{number}_transverse"], abs=1e-6)
        cut = (1 - size.shift) * M / sin(tan_t(15))  # r sin(alpha_t) at the limit of undercut
        assert size.least_teeth == pytest.approx(2 * cos(radians(15)) * cut / (M * sin(tan_t(15))), rel=1e-12)


def test_the_chosen_point_has_the_real_tips() -> None:
    """Contact ratio, thickness, sliding and strength of the pair itself; its place in the contour by the rule."""
    tips = 42.5 * MM, 50.0 * MM
    found = solve_pair(given(14, 17, 0.6, 0.522, tips=tips))
    plain = solve_pair(given(14, 17, 0.6, 0.522))
    chosen = solve_blocking(Pairs((found,), "", ())).pairs[0].points[0]
    g = found.distance * sin(found.angle_w)
    rho = [sqrt(tip**2 - size.base**2) for tip, size in zip(tips, found.sizes, strict=True)]
    ratio = (sum(rho) - g) / (pi * M * cos(ALPHA))
    assert chosen.contact_ratio == pytest.approx(ratio, rel=1e-12)
    assert abs(chosen.contact_ratio - plain.contact_ratio) > 0.01
    start = g - rho[1]
    assert chosen.sliding[0] == pytest.approx(1 - (g - start) * 14 / (17 * start), rel=1e-12)
    assert chosen.form_factors[1] == pytest.approx(form_factor(17, 0.522, tips[1] / M)[0], rel=1e-9)
    assert chosen.tip_thickness[0] == pytest.approx(found.sizes[0].tip_thickness / M, rel=1e-14)
    own = solve_blocking(Pairs((plain,), "", ())).pairs[0].points[0]
    assert own.sliding == pytest.approx((plain.peaks.theta1, plain.peaks.theta2), rel=1e-12)
