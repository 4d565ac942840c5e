"""A pinion in a ring: geometry, interferences against directly rolled teeth, sliding, verdicts."""

from dataclasses import replace
from math import cos, degrees, pi, radians, sin, tan

import numpy as np
import pytest
from sparing import sparing

from gears.involute.cases import wheel
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.internal.contact import internal_contact, internal_extremes, internal_sliding
from tmmcalc.gears.involute.internal.interference import interferences, trimming_margin, trochoid_margin
from tmmcalc.gears.involute.internal.pair import InternalPair, internal_of_distance, internal_of_shifts
from tmmcalc.gears.involute.internal.ring import Cutter, Ring
from tmmcalc.gears.involute.internal.verdicts import internal_checks, require_internal
from tmmcalc.gears.involute.measure.chords import thickness
from tmmcalc.gears.involute.quality.verdicts import worst

PAIRS = [
    (20, 80, 0.0, 0.0),
    (30, 36, 0.0, 0.0),
    (30, 38, 0.0, 0.0),
    (30, 40, 0.0, 0.0),
    (24, 32, 0.5, -0.5),
    (20, 27, 0.5, -0.9),
    (40, 42, 0.0, 0.0),
    (40, 42, 0.0, -1.0),
    (50, 53, 0.3, -0.8),
    (18, 30, 0.4, -0.4),
]


def pair_of(z1: int, z2: int, x1: float, x2: float, beta: float = 0.0) -> InternalPair:
    return internal_of_shifts(wheel(z1, x1, beta), Ring(z2, x2, radians(beta)))


def margins(pair: InternalPair) -> dict[str, float]:
    return {each.kind: each.margin for each in interferences(pair)}


def unrolled(radius, base):
    return involute(np.arccos(np.minimum(base / radius, 1.0)))


def least_gap(pair: InternalPair, phases: int = 3001, points: int = 160) -> float:
    """The least arc from a flank of the pinion to the ring's over all phases, both flanks being true involutes.

    Every point of the flank from the base circle to the tip is rolled into the ring's axes, and where it stands
    beyond the ring's tip circle its angle is compared with that of the ring's flank.
    """
    radius = np.linspace(pair.pinion.base, pair.tips[0], points)[None]
    phase = np.linspace(-pi, pi, phases)[:, None]
    start = involute(pair.angle)
    place = pair.distance + radius * np.exp(1j * (phase - unrolled(radius, pair.pinion.base) + start))
    far, angle = np.abs(place), np.angle(place)
    flank = phase / pair.ratio - unrolled(np.maximum(far, pair.ring.base), pair.ring.base) + start
    gap = np.where((far >= pair.tips[1]) & (np.abs(phase) < 3), (flank - angle) * far, np.inf)
    return float(gap.min())


@pytest.mark.parametrize("beta", [0.0, 20.0])
@sparing("case", PAIRS, every=3)
def test_trochoid_interference_against_rolled_teeth(case, beta):
    pair = pair_of(*case, beta)
    found = margins(pair)
    assert found["involute"] > 0
    gap = least_gap(pair)
    if found["trochoid"] < 0:
        assert gap < -1e-3
    else:
        assert gap > -1e-5  # of the sampled line of contact
    if -0.2 < found["trochoid"] < 0:  # the corners of the tips are the deepest points while the overlap is small
        assert gap == pytest.approx(found["trochoid"], abs=2e-3)


@pytest.mark.slow
def test_trochoid_margin_vanishes_where_teeth_begin_to_collide():
    shifts = np.linspace(-0.6, 0.0, 13)
    by_formula = [trochoid_margin(pair_of(30, 36, 0.0, float(x))) > 0 for x in shifts]
    by_teeth = [least_gap(pair_of(30, 36, 0.0, float(x))) > -1e-5 for x in shifts]
    assert by_formula == by_teeth
    assert {True, False} == set(by_formula)


@pytest.mark.parametrize("case", PAIRS)
def test_involutes_touch_on_the_line_of_action(case):
    """Points of both flanks at the radii of one point of contact coincide in the frame."""
    pair = pair_of(*case)
    start = involute(pair.angle)
    for rho1 in np.linspace(*pair.segment, 7):
        phase = rho1 / pair.pinion.base - tan(pair.angle)
        first, second = np.hypot(pair.pinion.base, rho1), np.hypot(pair.ring.base, rho1 + pair.length)
        one = pair.distance + first * np.exp(1j * (phase - unrolled(first, pair.pinion.base) + start))
        two = second * np.exp(1j * (phase / pair.ratio - unrolled(second, pair.ring.base) + start))
        assert abs(one - two) < 1e-11 * pair.ring.base


@pytest.mark.parametrize("case", [*PAIRS, (40, 100, 0.8, 0.4)])
def test_trimming_against_a_pinion_drawn_out(case):
    """Corners of all phases, drawn out along the line of centres past the corner of the ring's space."""
    pair = pair_of(*case)
    (tip1, tip2), n, start = pair.tips, 1 / pair.ratio, float(involute(pair.angle))
    phase = np.linspace(-0.5, pi / 2 + 0.5, 200001)
    one = pair.distance + tip1 * np.exp(1j * (phase - float(unrolled(tip1, pair.pinion.base)) + start))
    two = tip2 * np.exp(1j * (n * phase - float(unrolled(tip2, pair.ring.base)) + start))
    turned = np.angle(one - pair.distance)
    deep = (one.real >= two.real) & (turned >= 0) & (turned <= pi / 2)
    assert trimming_margin(pair) == pytest.approx(float((two.imag - one.imag)[deep].min()), abs=1e-4)


@pytest.mark.parametrize(("z1", "z2", "x1", "x2"), PAIRS)
@pytest.mark.parametrize("beta", [0.0, 15.0, 45.0])
def test_identities(z1, z2, x1, x2, beta):
    pair = pair_of(z1, z2, x1, x2, beta)
    assert pair.operating[1] - pair.operating[0] == pytest.approx(pair.distance, rel=1e-12)
    inv = float(involute(pair.angle)) - float(involute(pair.pinion.section.angle))
    assert inv == pytest.approx(-2 * (x1 + x2) * tan(radians(20)) / (z2 - z1), abs=1e-14)
    thick = float(pair.pinion.thickness_at(pair.operating[0])) + pair.ring.thickness_at(pair.operating[1])
    around = 2 * pi * pair.operating[0] / z1 * cos(float(pair.pinion.helix_at(pair.operating[0])))
    assert thick == pytest.approx(around, rel=1e-11)
    back = internal_of_distance(pair.pinion, replace(pair.ring, shift=9.0), pair.distance)
    assert back.ring.shift == pytest.approx(x2, abs=1e-10)
    t1, t2 = (np.sqrt((r / b) ** 2 - 1) for r, b in zip(pair.tips, (pair.pinion.base, pair.ring.base), strict=True))
    other = (z1 * t1 - z2 * t2 + (z2 - z1) * tan(pair.angle)) / (2 * pi)
    assert pair.contact_ratio == pytest.approx(float(other), rel=1e-9)
    assert min(pair.clearances) >= 0.25 - 1e-12
    meeting = internal_contact(pair, 10.0)
    assert meeting.total == pytest.approx(pair.contact_ratio + 10 * sin(radians(beta)) / pi)
    assert meeting.shortened <= meeting.transverse


def test_known_pair_of_equal_shifts():
    """Textbook numbers of a zero pair: all radii by hand."""
    pair = internal_of_shifts(wheel(24), Ring(80), tips="plain")
    assert pair.distance == pytest.approx(28.0)
    assert degrees(pair.angle) == pytest.approx(20.0)
    assert pair.tips == (13.0, 39.0)
    assert (pair.ring.root, pair.ring.form) == (41.25, 41.0)
    assert pair.clearances == pytest.approx((0.25, 0.25))
    start = np.sqrt(39**2 - (40 * cos(radians(20))) ** 2) - 28 * sin(radians(20))
    assert pair.starts[0] == pytest.approx(start)


def test_shift_of_the_ring_follows_iso():
    """A positive shift thickens the teeth of the ring and makes its circles smaller; its pair then stands nearer."""
    plain, shifted = Ring(60), Ring(60, 0.4)
    assert shifted.thickness_at(30.0) - plain.thickness_at(30.0) == pytest.approx(0.8 * tan(radians(20)))
    assert (shifted.plain_tip, shifted.root) == (28.6, 30.85)
    assert pair_of(20, 60, 0.0, 0.4).distance < 20 < pair_of(20, 60, 0.0, -0.4).distance
    assert pair_of(20, 60, 0.0, 0.4).modification < 0


def test_tips_that_clear_the_fillet():
    pinion, ring = wheel(20), Ring(60)
    assert margins(internal_of_shifts(pinion, ring))["fillet 1"] < -0.3
    clear = internal_of_shifts(pinion, ring, "clear")
    assert margins(clear)["fillet 1"] == pytest.approx(0.0, abs=1e-12)
    assert clear.tips[1] > ring.plain_tip
    whole, left = (internal_contact(pair) for pair in (internal_of_shifts(pinion, ring), clear))
    assert whole.shortened == pytest.approx(left.transverse) == pytest.approx(left.shortened)
    assert whole.shortened < whole.transverse
    shallow = Ring(60, cutter=Cutter(20, -0.2, tip=10.85))
    cut = internal_of_shifts(wheel(24, 0.1), shallow), internal_of_shifts(wheel(24, 0.1), shallow, "plain")
    assert cut[0].clearances[1] == pytest.approx(0.25)
    assert cut[1].clearances[1] < 0.2
    own = internal_of_shifts(pinion, ring, (10.9, 29.3))
    assert own.tips == (10.9, 29.3)


def test_ring_cut_by_a_shaper():
    """Root and form circles follow from the mesh of cutter and ring."""
    ring = Ring(60, 0.2, cutter=Cutter(25, 0.1))
    mesh = internal_of_shifts(wheel(25, 0.1), Ring(60, 0.2))
    assert ring.root == pytest.approx(mesh.distance + 12.5 + 1.35)
    rounded = Ring(60, 0.2, cutter=Cutter(25, 0.1, rounding=0.2))
    assert rounded.root == ring.root
    assert rounded.form < ring.form < ring.root
    touch = ring.curvature_at(ring.form) - mesh.length
    assert np.hypot(mesh.pinion.base, touch) == pytest.approx(12.5 + 1.35)
    # the circle of the rounding touches the involute of the cutter where it ends
    end = rounded.curvature_at(rounded.form) - mesh.length
    assert np.hypot(mesh.pinion.base, end - 0.2) == pytest.approx(12.5 + 1.35 - 0.2)
    fillet = [margins(internal_of_shifts(wheel(20, 0.2), r))["fillet 2"] for r in (rounded, ring)]
    assert fillet[0] < fillet[1]


def test_sliding_against_velocities_of_the_flanks():
    pair = pair_of(24, 70, 0.3, -0.4)
    at = internal_sliding(pair, np.linspace(*pair.segment, 9))
    line = -np.exp(-1j * pair.angle)
    point = at.along * line
    v1 = 1j * (point + 1j * pair.operating[0])
    v2 = 1j / pair.ratio * (point + 1j * pair.operating[1])  # both turn the same way
    s1, s2 = ((v * np.conj(1j * line)).real for v in (v1, v2))
    assert np.allclose((v1 * np.conj(line)).real, (v2 * np.conj(line)).real, rtol=1e-12)
    assert at.theta1 == pytest.approx((s1 - s2) / s1, rel=1e-10, abs=1e-12)
    assert at.theta2 == pytest.approx((s2 - s1) / s2, rel=1e-10, abs=1e-12)
    assert at.pressure == pytest.approx(1 / at.rho1 - 1 / (at.rho1 + pair.length))
    found = internal_extremes(pair)
    assert found.theta1 == pytest.approx(at.theta1.min())
    assert found.theta2 == pytest.approx(at.theta2.min())
    assert found.pressure_largest == pytest.approx(at.pressure.max())
    with pytest.raises(UsageError):
        internal_sliding(pair, np.array([0.0]))


def test_measured_sizes_of_a_ring():
    """Chords of the ring's teeth by plain trigonometry: the chord bulges towards the tip."""
    ring = Ring(60, 0.2)
    at = thickness(ring.signed, -30.3, -ring.plain_tip)
    half = ring.half_angle_at(30.3)
    assert at.normal == pytest.approx(2 * 30.3 * half, rel=1e-14)
    assert at.chord == pytest.approx(2 * 30.3 * sin(half), rel=1e-14)
    assert at.height == pytest.approx(30.3 * cos(half) - ring.plain_tip, rel=1e-13)
    assert at.normal + at.space == pytest.approx(2 * pi * 30.3 / 60, rel=1e-14)


def test_verdict_and_remedy():
    good = internal_of_shifts(wheel(24, 0.2), Ring(80, -0.2), "clear")
    assert worst(internal_checks(good)) in {"ok", "warn"}
    require_internal(good, tips="clear")
    collide = internal_of_shifts(wheel(30), Ring(36), "clear")
    with pytest.raises(NoSolutionError, match="collide outside the line of action") as error:
        require_internal(collide, tips="clear")
    assert error.value.value == pytest.approx(trochoid_margin(collide))
    assert "x2 alone: x1 = 0, x2 = -" in error.value.remedy
    x2 = float(error.value.remedy.split("x2 alone: x1 = 0, x2 = ")[1].split(";")[0])
    require_internal(internal_of_shifts(wheel(30), Ring(36, x2), "clear"))
    with pytest.raises(NoSolutionError):
        require_internal(internal_of_shifts(wheel(30), Ring(36, x2 + 1e-3), "clear"))
    tight = internal_checks(internal_of_shifts(wheel(30), Ring(40), "clear"))
    trimming = next(check for check in tight if check.name == "trimming interference")
    assert trimming.verdict == "warn"
    within = internal_checks(internal_of_shifts(wheel(12), Ring(25)))
    assert [check.name for check in within] == ["tip circle"]


def test_pairs_that_cannot_exist():
    with pytest.raises(NoSolutionError, match="does not fit into a ring"):
        internal_of_shifts(wheel(30), Ring(30))
    with pytest.raises(NoSolutionError, match="difference of the base radii") as error:
        internal_of_distance(wheel(20), Ring(60), 18.0)
    assert error.value.limit == pytest.approx(20 * cos(radians(20)))
    with pytest.raises(NoSolutionError, match="has to stay below") as error:
        internal_of_shifts(wheel(20, 0.9), Ring(60, 0.9))
    limit = error.value.limit
    assert internal_of_shifts(wheel(20), Ring(60, limit - 1e-9)).angle < 0.01


def test_extremes_are_finite_or_refused():
    judged = refused = 0
    for z1, z2 in ((5, 30), (17, 1000), (900, 1000), (999, 1000), (40, 45)):
        for x1 in (-1.0, 0.0, 0.7, 2.0):
            for x2 in (-2.0, -0.5, 0.0, 1.0):
                for beta in (0.0, 45.0):
                    try:
                        found = internal_checks(pair_of(z1, z2, x1, x2, beta))
                    except NoSolutionError:
                        refused += 1
                        continue
                    assert all(np.isfinite([check.value, check.margin]).all() for check in found)
                    judged += 1
    assert judged > 60
    assert refused > 3
