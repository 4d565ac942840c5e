"""The pitch curve of all followers by vectors and differences; base circles; senses."""

from math import radians

import numpy as np
import pytest

from cams.turns import turn
from tmmcalc.cams.follower import Follower, contact_path, curvature

PHI = np.radians([0.0, 11.0, 35.0, 58.0, 75.0, 101.0, 133.0, 200.0, 301.0])
SIZES = {"centres": 0.1, "rocker": 0.08}
FOLLOWERS = [
    Follower("translating", 0.05),
    Follower("translating", 0.05, 0.01),
    Follower("translating", 0.05, -0.02),
    Follower("oscillating", radians(30), **SIZES),
    Follower("oscillating", radians(30), **SIZES, assembly=-1),
    Follower("flat", 0.12),
]


def path_of(follower, phi):
    program = turn("sine", "shun", stroke=radians(25) if follower.kind == "oscillating" else 0.02)
    return contact_path(follower, phi, program.at(np.mod(phi, 2 * np.pi)))


@pytest.mark.parametrize("follower", FOLLOWERS)
def test_derivatives_by_differences(follower):
    phi, h = np.radians([11.0, 35.0, 52.0, 75.0, 101.0, 133.0, 200.0]), 1e-5
    before, here, after = (path_of(follower, phi + k * h) for k in (-1, 0, 1))
    np.testing.assert_allclose(here[1:], (after - before)[:2] / (2 * h), rtol=1e-7, atol=1e-8)


@pytest.mark.parametrize("follower", FOLLOWERS[:3])
def test_a_stem_by_the_textbooks_coordinates(follower):
    """(5.14), (5.15)."""
    program = turn("sine", "shun")
    s, e = follower.start + program.at(PHI)[0], follower.offset
    found = path_of(follower, PHI)[0]
    np.testing.assert_allclose(found.real, e * np.cos(PHI) - s * np.sin(PHI), atol=1e-16)
    np.testing.assert_allclose(found.imag, e * np.sin(PHI) + s * np.cos(PHI), atol=1e-16)


@pytest.mark.parametrize("follower", FOLLOWERS[3:5])
def test_a_rocker_keeps_its_lengths_and_its_angle(follower):
    program = turn("sine", "shun", stroke=radians(25))
    found = path_of(follower, PHI)[0]
    pivot = 0.1 * np.exp(1j * PHI)
    np.testing.assert_allclose(np.abs(found - pivot), 0.08, rtol=1e-14)
    # the angle between the line of centres A to O and the rocker A to C
    angle = np.angle((found - pivot) / -pivot)
    np.testing.assert_allclose(angle, -follower.assembly * (follower.start + program.at(PHI)[0]), atol=1e-14)


def test_the_envelope_of_the_flat_face():
    """Each point lies on its face line, and no face line cuts the profile."""
    follower = FOLLOWERS[5]
    phi = np.linspace(0, 2 * np.pi, 400)
    program = turn("sine", "shun")
    s = follower.start + program.at(phi)[0]
    points = path_of(follower, phi)[0]
    height = (np.conj(1j * np.exp(1j * phi))[:, None] * points[None]).real
    np.testing.assert_allclose(np.diag(height), s, atol=1e-16)
    assert np.all(height <= s[:, None] + 1e-15)


def test_curvature_of_an_offset_stem_in_closed_form():
    """(5.35) with the closed form for an offset."""
    follower, program = FOLLOWERS[1], turn("sine", "shun")
    y, y1, y2, _ = program.at(PHI)
    s, e = follower.start + y, follower.offset
    rho = (s**2 + (y1 + e) ** 2) ** 1.5 / (s**2 + (y1 + e) * (2 * y1 + e) - s * y2)
    np.testing.assert_allclose(1 / curvature(path_of(follower, PHI)), rho, rtol=1e-12)


def test_radius_under_a_flat_face_is_s_plus_its_second_derivative():
    follower, program = FOLLOWERS[5], turn("sine", "shun")
    y = program.at(PHI)
    np.testing.assert_allclose(1 / curvature(path_of(follower, PHI)), follower.start + y[0] + y[2], rtol=1e-12)


@pytest.mark.parametrize("follower", FOLLOWERS)
def test_the_base_circle_is_where_the_low_dwell_runs(follower):
    found = path_of(follower, np.radians([160.0, 200.0, 300.0]))
    np.testing.assert_allclose(np.abs(found[0]), follower.base, rtol=1e-14)
    np.testing.assert_allclose(curvature(found), 1 / follower.base, rtol=1e-12)


def test_placing_mirrors_a_cam_that_turns_the_other_way():
    points = np.array([1 + 2j, -3 + 0.5j])
    stem, rocker = (Follower(kind, 1.0, sense=-1) for kind in ("translating", "oscillating"))
    np.testing.assert_array_equal(stem.placed(points), [-1 + 2j, 3 + 0.5j])
    np.testing.assert_array_equal(rocker.placed(points), [1 - 2j, -3 - 0.5j])
    np.testing.assert_array_equal(Follower("flat", 1.0).placed(points), points)
