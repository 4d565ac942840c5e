"""Shifts of a pinion in a ring: margins against the verdicts of single pairs, intervals against scans, splits."""

from dataclasses import replace
from math import cos, degrees, radians, tan

import numpy as np
import pytest
from scipy.optimize import brentq
from sparing import sparing

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.internal.contact import internal_contact, internal_extremes
from tmmcalc.gears.involute.internal.line import internal_line, intervals
from tmmcalc.gears.involute.internal.margins import CONDITIONS, internal_margins, nearest_internal
from tmmcalc.gears.involute.internal.pair import internal_of_shifts
from tmmcalc.gears.involute.internal.ring import Cutter, Ring, angle_of_distance
from tmmcalc.gears.involute.internal.shifts import INTERNAL_STRATEGIES, choose_internal
from tmmcalc.gears.involute.internal.verdicts import internal_checks, require_internal
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.wheel import Wheel

PAIRS = [  # z1, z2, x1 + x2, helix, teeth of the cutter
    (20, 60, 0.0, 0.0, None),
    (48, 114, -1.0, 0.0, None),
    (30, 36, 0.0, 0.0, None),
    (8, 30, 0.0, 0.0, None),
    (24, 80, 0.2, 25.0, None),
    (100, 300, 0.0, 0.0, 20),
    (18, 60, -0.5, 15.0, 25),
]


def failing(pinion, ring, x1, x2, tips="clear", limits=None):
    """Whether the verdict on the single pair is a failure, and that verdict's checks."""
    try:
        pair = internal_of_shifts(replace(pinion, shift=x1), replace(ring, shift=x2), tips)
    except NoSolutionError:
        return True, ()
    found = internal_checks(pair, limits)
    return any(check.verdict == "fail" for check in found), found


@pytest.mark.slow
def test_margins_are_those_of_single_pairs():
    names = {
        "involute": "involute interference0",
        "fillet1": "fillet 1 interference0",
        "fillet2": "fillet 2 interference0",
        "trochoid": "trochoid interference0",
        "thickness1": "tip thickness1",
        "thickness2": "tip thickness2",
        "clearance1": "clearance1",
        "clearance2": "clearance2",
    }
    random, compared = np.random.default_rng(7), 0
    for _ in range(250):
        z1 = int(random.integers(8, 60))
        z2 = z1 + int(random.integers(5, 60))
        helix = radians(float(random.choice([0.0, 15.0, 30.0])))
        cutter = Cutter(int(random.integers(12, z2 - 12)), rounding=0.1) if z2 > 30 and random.random() < 0.3 else None
        x1, x2 = (float(x) for x in random.uniform(-1, 1.2, 2))
        tips = str(random.choice(["clearance", "plain", "clear"]))
        pinion, ring = Wheel(z1, x1, helix), Ring(z2, x2, helix, cutter=cutter)
        found = internal_margins(pinion, ring, np.array([x1]), np.array([x2]), tips=tips)
        wrong, checks = failing(pinion, ring, x1, x2, tips)
        assert bool(found.broken()) == wrong
        single = {f"{check.name}{check.wheel}": check.value for check in checks}
        if "contact ratio0" not in single:
            continue
        compared += 1
        assert found.ratio[0] == pytest.approx(single["contact ratio0"], abs=1e-11)
        rows = dict(zip(CONDITIONS, found.rows[:, 0], strict=True))
        for key, name in names.items():
            assert rows[key] == pytest.approx(single[name], abs=1e-11)
    assert compared > 100


@sparing(("z1", "z2", "total", "beta", "tool"), PAIRS, every=4)
def test_intervals_against_single_pairs(z1, z2, total, beta, tool):
    pinion = Wheel(z1, 0.0, radians(beta))
    ring = Ring(z2, 0.0, radians(beta), cutter=Cutter(tool) if tool else None)
    spans = intervals(internal_line(pinion, ring, total))
    assert spans
    for low, high in spans:
        assert not failing(pinion, ring, low, total - low)[0]
        assert not failing(pinion, ring, high, total - high)[0]
        assert failing(pinion, ring, low - 1e-10, total - low + 1e-10)[0]
        assert failing(pinion, ring, high + 1e-10, total - high - 1e-10)[0]
    for x1 in np.arange(-4.0, 4.0, 0.083):
        inside = any(low <= x1 <= high for low, high in spans)
        assert inside != failing(pinion, ring, float(x1), total - float(x1))[0]


def test_the_interval_without_undercut_begins_at_the_least_shift():
    pinion, ring = Wheel(12), Ring(50)
    ((low, _),) = intervals(internal_line(pinion, ring, 0.0, QualityLimits(undercut=False)))
    assert low == pytest.approx(pinion.least_shift, abs=1e-10)
    ((tolerated, _),) = intervals(internal_line(pinion, ring, 0.0))
    assert tolerated < low - 0.1


def test_a_short_interval_between_two_points_of_the_scan_is_found():
    pinion, ring = Wheel(20), Ring(60)
    ratio = internal_line(pinion, ring, 0.0).at(np.linspace(-0.5, 1.0, 30001)).ratio
    limits = QualityLimits(contact_ratio=float(ratio.max()) - 1e-6)
    ((low, high),) = intervals(internal_line(pinion, ring, 0.0, limits))
    assert 0 < high - low < 1e-3


@pytest.mark.parametrize(("z1", "z2", "total", "beta", "tool"), [PAIRS[k] for k in (0, 1, 4, 5, 6)])
def test_equal_sliding(z1, z2, total, beta, tool):
    pinion = Wheel(z1, 0.0, radians(beta))
    ring = Ring(z2, 0.0, radians(beta), cutter=Cutter(tool) if tool else None)
    distance = internal_of_shifts(pinion, replace(ring, shift=total)).distance
    found = choose_internal(pinion, ring, "given_aw", distance=distance)
    assert found.note == ""
    assert found.x1 + found.x2 == pytest.approx(total, abs=1e-12)
    pair = internal_of_shifts(replace(pinion, shift=found.x1), replace(ring, shift=found.x2), "clear")
    at = internal_extremes(pair, internal_contact(pair).segment)
    assert at.theta1 == pytest.approx(at.theta2, abs=1e-9)
    assert found.low < found.x1 < found.high


def test_equal_sliding_out_of_reach_ends_nearest_to_it():
    found = choose_internal(Wheel(8), Ring(30), "equal_shift")
    assert "out of reach" in found.note
    assert found.x1 in (found.low, found.high)

    def unequal(x1):
        pair = internal_of_shifts(Wheel(8, x1), Ring(30, -x1), "clear")
        at = internal_extremes(pair)
        return abs(at.theta1 - at.theta2)

    inside = np.linspace(found.low + 0.01, found.high - 0.01, 40)
    assert all(unequal(found.x1) < unequal(float(x)) for x in inside)


@pytest.mark.slow
def test_largest_contact_ratio_and_middle():
    pinion, ring = Wheel(48), Ring(114)
    distance = internal_of_shifts(pinion, replace(ring, shift=-1.0)).distance
    best = choose_internal(pinion, ring, "given_aw", distance=distance, split="max_contact_ratio")

    def ratio(x1):
        pair = internal_of_shifts(replace(pinion, shift=x1), replace(ring, shift=-1.0 - x1), "clear")
        return internal_contact(pair).shortened

    scanned = max(ratio(float(x)) for x in np.linspace(best.low, best.high, 800))
    assert ratio(best.x1) >= scanned
    middle = choose_internal(pinion, ring, "given_aw", distance=distance, split="middle")
    assert middle.x1 == pytest.approx((middle.low + middle.high) / 2, abs=1e-12)
    same = choose_internal(pinion, ring, "balanced")
    assert same.x1 == -same.x2 == pytest.approx((same.low + same.high) / 2, abs=1e-12)
    told = choose_internal(pinion, ring, "equal_shift", split="equal_strength")
    assert "no tooth form factor" in told.note


@pytest.mark.parametrize("beta", [0.0, 20.0])
@pytest.mark.parametrize("stretch", [0.98, 1.0, 1.03])
def test_the_sum_of_a_centre_distance(beta, stretch):
    helix = radians(beta)
    slope = tan(radians(20))
    start = np.arctan(slope / cos(helix))
    wanted = stretch * 20 / cos(helix)

    def distance(total):
        def residual(a):
            return np.tan(a) - a - (np.tan(start) - start) + 2 * total * slope / 40

        return 20 / cos(helix) * np.cos(start) / np.cos(brentq(residual, 1e-6, 1.4, xtol=1e-15))

    expected = brentq(lambda total: distance(total) - wanted, -5.0, 0.7, xtol=1e-14)
    found = choose_internal(Wheel(20, 0.0, helix), Ring(60, 0.0, helix), "given_aw", distance=wanted)
    assert found.x1 + found.x2 == pytest.approx(expected, abs=1e-11)


def test_published_example_of_an_internal_pair():
    """KHK, gear technical reference: z = 16/24, x2 = 0.5 outward, a_w = 13.1683 mm at module 3 mm."""
    total, angle = angle_of_distance(Wheel(16), Ring(24), 13.1683 / 3)
    assert total == pytest.approx(-0.5, abs=2e-4)
    assert degrees(angle) == pytest.approx(31.0937, abs=1e-3)
    given = choose_internal(Wheel(16), Ring(24), "given_aw", distance=13.1683 / 3, x1=0.0)
    assert given.x2 == pytest.approx(-0.5, abs=2e-4)


def test_given_shifts_are_told_where_they_stand():
    good = choose_internal(Wheel(20), Ring(60), "given", x1=0.5, x2=-0.5)
    assert (good.inside, good.broken) == (True, ())
    bad = choose_internal(Wheel(20), Ring(60), "given", x1=1.5, x2=-1.5)
    assert not bad.inside
    assert bad.broken == (CONDITIONS["thickness1"],)
    assert bad.low < bad.high < 1.5
    zero = choose_internal(Wheel(40), Ring(42), "zero")
    assert CONDITIONS["trochoid"] in zero.broken


def test_what_is_asked_wrongly():
    with pytest.raises(UsageError) as error:
        choose_internal(Wheel(20), Ring(60), "max_contact_strength")
    assert all(strategy in error.value.remedy for strategy in INTERNAL_STRATEGIES)
    with pytest.raises(UsageError, match="both shifts"):
        choose_internal(Wheel(20), Ring(60), "given", x1=0.0)
    with pytest.raises(UsageError, match="centre distance"):
        choose_internal(Wheel(20), Ring(60), "given_aw")
    with pytest.raises(UsageError, match="split"):
        choose_internal(Wheel(20), Ring(60), "equal_shift", split="halves")
    with pytest.raises(NoSolutionError, match="base radii"):
        choose_internal(Wheel(20), Ring(60), "given_aw", distance=18.0)


def test_nothing_admissible_tells_the_least_bad_and_what_excludes_what():
    limits = QualityLimits(contact_ratio=1.5, undercut=False)
    with pytest.raises(NoSolutionError) as error:
        choose_internal(Wheel(6), Ring(40), "equal_shift", limits=limits)
    message = str(error.value)
    assert CONDITIONS["contact_ratio"] in message
    assert CONDITIONS["thickness1"] in message
    assert "stub" in error.value.remedy
    assert "undercut" in error.value.remedy
    x1 = np.linspace(-2, 2, 4001)
    scanned = internal_margins(Wheel(6), Ring(40), x1, -x1, limits, tips="clear").least
    assert error.value.value == pytest.approx(scanned.max(), abs=1e-3)
    assert error.value.value >= scanned.max() - 1e-9


@sparing(("z1", "z2", "x1", "x2"), [(40, 42, 0.0, 0.0), (30, 36, 0.0, 0.0), (20, 60, 1.6, -1.0)], every=3)
def test_nearest_admissible_shifts_in_the_plane(z1, z2, x1, x2):
    pinion, ring = Wheel(z1, x1), Ring(z2, x2)
    near = nearest_internal(pinion, ring)
    assert near.distance > 0.01
    assert not failing(pinion, ring, *near.shifts)[0]
    angle = np.linspace(0, 2 * np.pi, 721)
    for part in np.linspace(0, 0.999, 40):
        one, two = x1 + part * near.distance * np.cos(angle), x2 + part * near.distance * np.sin(angle)
        assert not np.any(internal_margins(pinion, ring, one, two, tips="clear").least >= 0)


def test_the_remedy_of_a_pair_names_shifts_that_work():
    pair = internal_of_shifts(Wheel(40), Ring(42), "clear")
    with pytest.raises(NoSolutionError) as error:
        require_internal(pair, tips="clear")
    parts = error.value.remedy.split("are ")[1].split("; ")
    assert len(parts) >= 3
    for part in parts:
        x1, x2 = (float(word.split(" = ")[1]) for word in part.split(": ")[-1].split(", "))
        assert not failing(Wheel(40), Ring(42), x1, x2)[0]
