"""Shaking force and moment against momentum, Newton-Euler reactions, closed forms, and changes that must not matter."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
import pytest
from linkage.scenes import crank_slider, driven_rod, four_bar, slotted, trammel
from sparing import sparing
from transforms import moved, scaled, with_axes

from machine.balance.balanced import PRESS, SCENES, TURN, Array, Scene, chain_of, derivative, momenta, scene
from tmmcalc import AccuracyError, AssemblyError, NoSolutionError, UsageError
from tmmcalc.linkage.loading import Body
from tmmcalc.machine.balance.schemes import lanchester, least_squares_counterweight
from tmmcalc.machine.balance.shaking import Shaking, inertia_loads, shaking

SPEED, ACCELERATION = 7.0, -11.0
X24 = np.arange(24) * TURN / 24


def full(n: int) -> Array:
    return np.arange(n) * TURN / n


def solved(case: Scene, x: Array = X24, speed: float = SPEED, acceleration: float = 0.0) -> Shaking:
    return shaking(case.chain, case.bodies, x, speed, acceleration)


@pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)
@pytest.mark.parametrize("speed", [SPEED, -SPEED])
def test_force_and_moment_are_the_rates_of_momentum(make: Callable[[], Scene], speed: float) -> None:
    case = make()
    x, about = full(1024), 0.3 - 0.2j
    p, k = momenta(case, x, about)
    w2 = speed * speed
    force = -(derivative(p) * w2 + p * ACCELERATION)
    moment = -(derivative(k) * w2 + k * ACCELERATION).real
    found = shaking(case.chain, case.bodies, x, speed, ACCELERATION, about=about)
    assert np.max(np.abs(found.force - force)) < 1e-10 * np.max(np.abs(force))
    assert np.max(np.abs(found.moment - moment)) < 1e-10 * np.max(np.abs(moment))
    assert found.error < 1e-13


@pytest.mark.parametrize("variant", [1, -1])
def test_the_frame_of_a_four_bar_feels_what_newton_and_euler_say(variant: int) -> None:
    """All reactions and the drive's moment from the nine equations of the three links, as forces on the frame."""
    case = scene(four_bar(0.1, 0.3, 0.25, 0.3 + 0.12j, variant))
    n = 512
    x = full(n)
    motions = case.chain.evaluate(x, order=0).motions
    pins = {"O": np.zeros(n, complex), "C": np.full(n, 0.3 + 0.12j)}
    pins |= {"A": motions[1].point(0.1).r, "B": motions[3].point(0.25).r}
    ends = {1: (("O", 1), ("A", -1)), 2: (("A", 1), ("B", -1)), 3: (("B", 1), ("C", 1))}
    columns = {name: 2 * i for i, name in enumerate("OABC")}
    matrix, right = np.zeros((n, 9, 9)), np.zeros((n, 9))
    for row, body in zip((0, 3, 6), case.bodies, strict=True):
        S, u = motions[body.link].point(body.center).r, motions[body.link].u
        a = derivative(derivative(S)) * SPEED**2
        eps = derivative((derivative(u) / u).imag).real * SPEED**2
        right[:, row : row + 3] = np.stack([body.mass * a.real, body.mass * a.imag, body.inertia * eps], axis=1)
        for pin, sign in ends[body.link]:
            j, arm = columns[pin], pins[pin] - S
            matrix[:, row, j] = matrix[:, row + 1, j + 1] = sign
            matrix[:, row + 2, j], matrix[:, row + 2, j + 1] = -sign * arm.imag, sign * arm.real
    matrix[:, 2, 8] = 1  # the drive's moment on the crank
    reactions = np.linalg.solve(matrix, right[..., None])[..., 0]
    at_o, at_c = (reactions[:, j] + 1j * reactions[:, j + 1] for j in (columns["O"], columns["C"]))
    found = solved(case, x)
    assert np.max(np.abs(found.force + at_o + at_c)) < 1e-10 * found.size.largest
    moment = -(np.conj(pins["C"]) * at_c).imag - reactions[:, 8]
    assert np.max(np.abs(found.moment - moment)) < 1e-10 * found.moment_size.largest


@pytest.mark.parametrize(("l1", "l2"), [(0.0375, 0.168), (0.1, 0.13)])
def test_harmonics_of_an_in_line_crank_slider(l1: float, l2: float) -> None:
    """c_1 = c_-1 + rotating part, even harmonics of the rod's cosine alone, by quadrature in 30 digits."""
    m2, m3, s2 = 12.0, 24.0, 0.3 * l2
    case = scene(crank_slider(l1, l2), Body(2, m2, 0.0, complex(s2)), Body(3, m3, 0.0, 0j))
    found = solved(case).series
    along, across = m2 * (1 - s2 / l2), m2 * s2 / l2  # the rod's mass at A and at B
    w2 = SPEED**2
    assert found.coefficient(1) == pytest.approx(w2 * l1 * (along + (across + m3) / 2), rel=1e-13)
    assert found.coefficient(-1) == pytest.approx(w2 * l1 * (across + m3) / 2, rel=1e-13)
    mpmath.mp.dps = 30
    for k in (2, 4, 6):
        cosine = mpmath.quad(
            lambda t, k=k: mpmath.sqrt(mpmath.mpf(l2) ** 2 - (mpmath.mpf(l1) * mpmath.sin(t)) ** 2) * mpmath.cos(k * t),
            mpmath.linspace(0, 2 * mpmath.pi, 9),
        ) / (2 * mpmath.pi)
        expected = (m3 + across) * k * k * w2 * float(cosine)
        for sign in (1, -1):
            assert found.coefficient(sign * k) == pytest.approx(expected, rel=1e-11, abs=1e-13 * w2 * l1 * m3)
    for k in (0, 3, -3, 5):
        assert abs(found.coefficient(k)) < 1e-15 * w2 * (m2 + m3) * l1


def test_the_press_of_the_worked_case() -> None:
    cases = json.loads((Path(__file__).parents[2] / "cases" / "dynamics.json").read_text())
    (worked,) = [c for c in cases if c["id"] == "dyn-balance-press"]
    given, expected = worked["inputs"], worked["expected"]
    bodies = (
        Body(2, given["m2"], given["J_S2"], complex(given["l_AS2"])),
        Body(3, given["m3"], 0.0, 0j),
    )
    found = shaking(chain_of(crank_slider(given["l1"], given["l2"])), bodies, full(given["n"]), given["omega1"])
    single, pair = least_squares_counterweight(found), lanchester(found)
    tolerance = worked["tolerance"]["rel"]
    (weight,) = single.weights
    centroid = found.series.coefficient(1)
    assert centroid.real == pytest.approx(expected["centroid_X1"], rel=tolerance)
    assert centroid.imag == pytest.approx(expected["centroid_Y1"], abs=1e-10)
    assert abs(weight.moment) == pytest.approx(expected["counterweight_static_moment_kg_m"], rel=tolerance)
    assert abs(np.degrees(np.angle(weight.moment))) == pytest.approx(expected["counterweight_angle_deg_from_crank"])
    assert found.size.rms == pytest.approx(expected["rms_before"], rel=tolerance)
    assert single.after.rms == pytest.approx(expected["rms_after"], rel=tolerance)
    assert single.ratio == pytest.approx(expected["ratio"], rel=tolerance)
    assert found.size.largest == pytest.approx(expected["max_before"], rel=tolerance)
    assert single.after.largest == pytest.approx(expected["max_after"], rel=tolerance)
    assert pair.after.rms == pytest.approx(expected["rms_after_counterrotating_pair"], rel=tolerance)
    np.testing.assert_allclose(np.abs(found.force), expected["R_modulus"], rtol=tolerance)
    np.testing.assert_allclose(np.abs(single.force), expected["D_modulus"], rtol=tolerance)
    np.testing.assert_allclose(np.abs(single.turned), expected["D_modulus"], rtol=tolerance)


@sparing("make", SCENES.values(), ids=SCENES, every=4)
def test_harmonics_and_extremes_do_not_depend_on_the_positions(make: Callable[[], Scene]) -> None:
    case = make()
    one, other = solved(case, full(7)), solved(case, np.array([0.3, 5.0]))
    np.testing.assert_array_equal(one.series.coefficients, other.series.coefficients)
    assert (one.size, one.moment_size) == (other.size, other.moment_size)
    dense = solved(case, full(3600))
    assert np.max(np.abs(dense.series.at(dense.phi) - dense.force)) < 1e-12 * dense.scale
    assert np.max(np.abs(dense.moment_series.at(dense.phi) - dense.moment)) < 1e-12 * dense.moment_size.largest
    for size, values in ((dense.size, np.abs(dense.force)), (dense.moment_size, np.abs(dense.moment))):
        assert size.rms == pytest.approx(np.sqrt(np.mean(values**2)), rel=1e-13)
        assert values.max() * (1 - 1e-14) <= size.largest <= values.max() * (1 + 1e-4)


def test_the_crank_frame() -> None:
    """A lone mass on the crank stands still in it, whatever the crank's axes and the sense of turning."""
    plain = crank_slider(0.1, 0.35)
    body = Body(1, 2.0, 0.1, 0.05 + 0.02j)
    for speed in (SPEED, -SPEED):
        found = shaking(chain_of(plain), (body,), X24, speed)
        np.testing.assert_allclose(found.turned, 2.0 * (0.05 + 0.02j) * SPEED**2, rtol=1e-14)
        assert found.series.coefficient(1) == pytest.approx(2.0 * (0.05 + 0.02j) * SPEED**2, rel=1e-14)
    laid = with_axes(plain, 1, 0.03 - 0.01j, 0.7)
    center = (0.05 + 0.02j - (0.03 - 0.01j)) * np.exp(-0.7j)
    found = shaking(chain_of(laid), (replace(body, center=complex(center)),), X24 + 0.7, SPEED)
    np.testing.assert_allclose(found.phi, X24, atol=1e-14)
    np.testing.assert_allclose(found.turned, 2.0 * (0.05 + 0.02j) * SPEED**2, rtol=1e-13)


@pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)
def test_the_sense_of_turning_changes_nothing_and_the_speed_goes_with_its_square(make: Callable[[], Scene]) -> None:
    case = make()
    one, back, fast = solved(case), solved(case, speed=-SPEED), solved(case, speed=3 * SPEED)
    np.testing.assert_array_equal(one.force, back.force)
    np.testing.assert_allclose(fast.force, 9 * one.force, rtol=1e-12, atol=1e-12 * fast.scale)
    assert fast.size.largest == pytest.approx(9 * one.size.largest, rel=1e-13)


@pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)
def test_moved_and_scaled_mechanisms(make: Callable[[], Scene]) -> None:
    case = make()
    one = solved(case, acceleration=ACCELERATION)
    turn, shift, factor = 0.83, 2.0 - 1.5j, 2.5
    there = shaking(chain_of(moved(case.mechanism, turn, shift)), case.bodies, X24 + turn, SPEED, ACCELERATION)
    bound = 1e-12 * one.scale
    assert np.max(np.abs(there.force - one.force * np.exp(1j * turn))) < bound
    assert np.max(np.abs(there.moment - one.moment)) < 1e-11 * one.moment_size.largest
    for k in (1, -1, 2, -2):
        turned = one.series.coefficient(k) * np.exp(1j * turn * (1 - k))
        assert abs(there.series.coefficient(k) - turned) < bound
    large = tuple(replace(b, center=b.center * factor, inertia=b.inertia * factor**2) for b in case.bodies)
    big = shaking(chain_of(scaled(case.mechanism, factor)), large, X24, SPEED, ACCELERATION)
    assert np.max(np.abs(big.force - factor * one.force)) < factor * bound
    assert np.max(np.abs(big.moment - factor**2 * one.moment)) < 1e-12 * big.moment_size.largest


@pytest.mark.parametrize("make", SCENES.values(), ids=SCENES)
def test_a_body_in_two_halves_shakes_as_the_whole(make: Callable[[], Scene]) -> None:
    case = make()
    one, apart = solved(case, acceleration=ACCELERATION), 0.02 - 0.01j
    halves = [
        Body(b.link, b.mass / 2, b.inertia / 2 - b.mass / 2 * abs(apart) ** 2, b.center + sign * apart)
        for b in reversed(case.bodies)
        for sign in (1, -1)
    ]
    other = shaking(case.chain, halves, X24, SPEED, ACCELERATION)
    assert np.max(np.abs(other.force - one.force)) < 1e-13 * one.scale
    assert np.max(np.abs(other.moment - one.moment)) < 1e-12 * one.moment_size.largest


def test_the_moment_about_another_point() -> None:
    case = SCENES["shaper"]()
    one, point = solved(case), 0.4 + 1.1j
    assert one.about == one.pivot != 0
    there = shaking(case.chain, case.bodies, X24, SPEED, about=point)
    lever = (np.conj(point - one.pivot) * one.force).imag
    assert np.max(np.abs(there.moment - one.moment + lever)) < 1e-12 * there.moment_size.largest


@sparing("excess", [1.0, 1e-2, 1e-4, 1e-5], every=4)
def test_the_error_estimate_near_a_dead_point(excess: float) -> None:
    """The series against extended precision where its errors are largest, around the stretched rod."""
    case = scene(crank_slider(0.1, 0.1 * (1 + excess)), Body(2, 1.0, 0.01, 0.05 + 0j), Body(3, 2.0, 0.0, 0j))
    found = solved(case)
    near = np.pi / 2 + np.sqrt(excess) * np.linspace(-3, 3, 61)
    x = np.concatenate((near, full(40))).astype(np.longdouble)
    exact, _ = inertia_loads(case.chain, case.bodies, x, SPEED)
    error = np.max(np.abs(found.series.at(x.astype(float)) - exact)) / found.scale
    assert error < found.error < max(1e-13, 1e-15 / excess)


def test_nothing_shakes_without_masses() -> None:
    found = shaking(chain_of(crank_slider(0.1, 0.3)), (), X24, SPEED)
    assert found.size.largest == found.moment_size.largest == found.scale == 0.0
    assert not found.force.any()
    assert least_squares_counterweight(found).ratio is None


def test_what_cannot_be_balanced_is_refused() -> None:
    with pytest.raises(NoSolutionError, match="driven slider"):
        shaking(chain_of(driven_rod(0.3, 0.1, 0.1)), PRESS, X24, SPEED)
    with pytest.raises(AssemblyError, match="cannot make a full turn"):
        shaking(chain_of(crank_slider(0.1, 0.09)), PRESS, X24, SPEED)
    with pytest.raises(AccuracyError, match="do not die out"):
        shaking(chain_of(trammel(0.1, 1.0)), PRESS, X24, SPEED)
    with pytest.raises(UsageError, match="no link 5"):
        shaking(chain_of(crank_slider(0.1, 0.3)), (Body(5, 1.0, 0.0, 0j),), X24, SPEED)
    with pytest.raises(UsageError, match="stands still"):
        shaking(chain_of(crank_slider(0.1, 0.3)), PRESS, X24, 0.0)


def test_loads_of_a_driven_slider() -> None:
    """x_A = x, so that the pin's link of mass m shakes with -m a along the guide."""
    force, moment = inertia_loads(chain_of(driven_rod(0.3, 0.1, 0.1)), (Body(1, 2.0, 0.5, 0.1j),), X24[:3], 1.0, 4.0)
    np.testing.assert_allclose(force, -8.0)
    np.testing.assert_allclose(moment, 0.8)


def test_a_moment_through_a_rotating_slot_is_that_of_its_inertia() -> None:
    """A bare moment of inertia on the slotted link shakes by -J theta'' omega^2 and no force."""
    case = scene(slotted(0.1, 0.3), Body(3, 0.0, 0.2, 0j))
    found = solved(case)
    angle = np.unwrap(np.angle(case.chain.evaluate(full(512), order=0).motions[3].u)) - full(512)
    expected = -0.2 * SPEED**2 * derivative(derivative(angle)).real
    assert found.size.largest == 0.0
    np.testing.assert_allclose(solved(case, full(512)).moment, expected, atol=1e-10 * found.moment_size.largest)
