"""Independent truths: the wheel driven by the working profile, differences, the envelope by brute force."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline
from scipy.optimize import fsolve
from sparing import sparing

from cams.indexing_scene import SCENES, law_at, roller_at
from tmmcalc.cams.indexing import solve_indexing
from tmmcalc.cams.indexing.flanks import Flank
from tmmcalc.cams.indexing.outline import outline, stretches
from tmmcalc.cams.indexing.solve import drive_of

TURN = 2 * pi
START = {"A": 1.0, "B": -1.0, "back": -3.0}  # angle of a roller at k = 0, in parts of pi/z2


@pytest.fixture(scope="module", params=SCENES)
def scene(request):
    given = SCENES[request.param]
    found = solve_indexing(given)
    return request.param, given, found, drive_of(given, found.ratio)


def pieces(name, found, drive):
    """The parts of the working profile that a flank has: points alone, at dense values of the parameter."""
    called = {"A": "flank A", "B": "groove B", "back": "back of the lobe"}[name]
    for stretch in stretches(drive, found.roller, found.cam.working_part):
        if stretch.name == called:
            t = (1 - np.cos(np.linspace(0, pi, 900))) / 2
            t = stretch.curve.start + (stretch.curve.end - stretch.curve.start) * t
            yield t, stretch.curve.point(t)


@sparing("name", ["A", "B", "back"], every=3)
def test_the_profile_drives_the_wheel_by_the_law(scene, name) -> None:
    """A roller that touches a spline through the points of the working profile stands where the law has it."""
    key, given, found, drive = scene
    beta, side, done = TURN / given.rollers, -1 if name == "B" else 1, 0
    for t, points in pieces(name, found, drive):
        curve = make_interp_spline(t, np.column_stack((points.real, points.imag)), k=7)
        slope = curve.derivative()
        for k in np.linspace(t[0], t[-1], 13)[1:-1]:
            at_phi = side * np.exp(-1j * given.step * k)

            def rest(x, curve=curve, slope=slope, at_phi=at_phi):
                """Roller of radius r on the curve: its centre along the normal at the contact, at distance r."""
                point, rate = curve(x[0]), slope(x[0])
                gap = roller_at(given, x[1]) * at_phi - complex(*point)
                along = gap * np.conj(complex(*rate)) / abs(complex(*rate))
                return [along.real / given.wheel, (along.imag - found.roller) / given.wheel]

            theta = START[name] * beta / 2 + beta * float(law_at(key, k))
            wanted = [k, theta]
            x, _, ok, _ = fsolve(rest, [k + 1e-3, theta - 1e-3], xtol=1e-14, full_output=True)
            if ok != 1:  # no progress below rounding
                assert np.max(np.abs(rest(x))) < 1e-13
            assert x[1] == pytest.approx(wanted[1], abs=1e-9)
            done += 1
    assert done >= 11


def test_both_flanks_follow_the_law_by_hand(scene) -> None:
    key, given, found, _ = scene
    k = found.k
    beta = TURN / given.rollers
    for flank, start in ((found.cam.a, beta / 2), (found.cam.b, -beta / 2)):
        theta = start + beta * law_at(key, k)
        assert flank.theta == pytest.approx(theta, abs=1e-13)
        place = roller_at(given, theta) * np.exp(-1j * given.step * k)
        assert np.max(np.abs(flank.pitch - place)) < 1e-14
        assert np.abs(np.exp(1j * flank.polar) - place / np.abs(place)).max() < 1e-13


@pytest.mark.parametrize("name", ["A", "B", "back"])
def test_curvature_normal_and_pressure_angle_by_differences(scene, name) -> None:
    """Central differences of the pitch curve by hand; the pressure angle is that of its normal and the roller's way."""
    key, given, _, drive = scene
    flank, beta = Flank(drive, name), TURN / given.rollers
    k = np.array([0.07, 0.16, 0.23, 0.31, 0.37, 0.44, 0.56, 0.63, 0.69, 0.77, 0.84, 0.93])
    h = 1e-4

    def place(x):
        theta = START[name] * beta / 2 + beta * law_at(key, x)
        return roller_at(given, theta) * np.exp(-1j * given.step * x), theta

    low, here, high = (place(x)[0] for x in (k - h, k, k + h))
    rate, second = (high - low) / (2 * h), (high - 2 * here + low) / h**2
    bend = -(np.conj(rate) * second).imag / np.abs(rate) ** 3  # clockwise: bulging outwards is positive
    assert flank.curvature(k) * given.wheel == pytest.approx(bend * given.wheel, rel=1e-4, abs=1e-4)
    normal = 1j * rate / np.abs(rate)  # out of the cam
    way = np.exp(-1j * place(k)[1]) * 1j * np.exp(-1j * given.step * k)  # of the roller as the wheel turns
    driven = (np.conj(way) * normal).real
    axis = given.ratio * given.wheel * np.exp(-1j * given.step * k)
    inwards = (np.conj((axis - here) / given.wheel) * normal).real  # towards O2
    angle = np.arctan2(inwards * np.sign(driven), np.abs(driven))
    assert flank.pressure(k) == pytest.approx(angle, abs=1e-6)
    assert np.all(driven > 0) if name == "A" else np.all((driven > 0) == ((k > 0.5) & (name == "B")))
    radial = np.conj(here) * normal
    sigma = np.arctan2(np.abs(radial.imag), np.abs(radial.real))
    assert flank.rise_angle(k) == pytest.approx(sigma, abs=1e-6)


def test_the_working_profile_is_the_envelope_of_all_rollers(scene) -> None:
    """Brute force: every point keeps the roller's radius from every place of every roller of its row, and meets one."""
    key, given, found, drive = scene
    chain = stretches(drive, found.roller, found.cam.working_part)
    points = outline("", chain, 1e-4 * given.wheel).polygon
    count = 12000
    phi = np.linspace(0, TURN, count)
    beta = TURN / given.rollers
    step, rest = np.divmod(phi, pi)
    turned = beta * (step + law_at(key, np.minimum(rest / given.step, 1.0)))
    nearest = np.full(len(points), np.inf)
    for number in range(given.rollers // 2):
        centres = roller_at(given, beta / 2 + 2 * beta * number + turned) * np.exp(-1j * phi)
        for some in np.array_split(np.arange(len(points)), 8):
            nearest[some] = np.minimum(nearest[some], np.abs(points[some, None] - centres).min(axis=1))
    assert nearest.min() > found.roller * (1 - 1e-7)
    spacing = 2 * given.wheel * TURN / count * 3
    assert nearest.max() < found.roller + spacing**2 / found.roller + 1e-7 * given.wheel


def test_the_profile_is_closed_and_turns_once(scene) -> None:
    _, _, found, drive = scene
    for distance, end in ((0.0, found.cam.handover.part), (found.roller, found.cam.working_part)):
        chain = stretches(drive, distance, end)
        for one, other in zip(chain, (*chain[1:], chain[0]), strict=True):
            last = one.curve.point(np.array([one.curve.end]))[0]
            assert last == pytest.approx(other.curve.point(np.array([other.curve.start]))[0], abs=1e-12)
        closed = outline("", chain, 1e-5).polygon
        turn = np.angle(np.roll(closed, -1) / closed).sum()
        assert turn == pytest.approx(TURN, abs=1e-9)
    front = [stretch for stretch in chain if stretch.name == "flank A"][-1]
    assert abs(front.curve.point(np.array([front.curve.end]))[0]) == pytest.approx(found.cam.working_tip)
    assert found.cam.working_part < found.cam.handover.part
    assert found.wheel_room == pytest.approx(found.centres - np.abs(closed).max(), abs=1e-12)
    assert any("sweeps over O2" in note for note in found.notes) == (found.wheel_room <= 0)
