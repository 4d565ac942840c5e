"""Chains of masses: two and three masses against exact solutions, gear ratios, dampers, rigid shafts, stiffness."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from sparing import sparing

from machine.transient.scenes import PERIOD, at, case, constant, cycle, kloss, line, run, upsetter
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.scenario import Brake, LoadStep, Scenario

METHODS = ["auto", "merson", "collocation", "RK45", "DOP853", "LSODA", "Radau", "BDF"]


def two_mass(stiffness: float, damping: float = 0.0) -> Drive:
    return Drive((Mass(0.5), Mass(2.0)), (Shaft(stiffness, damping),), characteristic=constant(50.0))


def exact(c: float, k: float, t: np.ndarray) -> np.ndarray:
    """Shaft moment and both speeds of `two_mass` from rest: phi'' + k m phi' + c m phi = M/J_1, m = 1/J_1 + 1/J_2."""
    m, total = 1 / 0.5 + 1 / 2.0, 2.5
    roots = np.array([complex(r) for r in _roots(k * m, c * m)])
    level = 50 / 0.5 / (c * m)
    ratio = roots[::-1] / (roots[::-1] - roots)
    fades = np.exp(np.outer(roots, t))
    phi = level * (1 - (ratio @ fades).real)
    rate = -level * ((ratio * roots) @ fades).real
    drift = 50 / total * t
    return np.array([c * phi + k * rate, drift + 2.0 / total * rate, drift - 0.5 / total * rate])


def _roots(p: float, q: float) -> tuple[complex, complex]:
    """Roots of x^2 + p x + q without cancellation."""
    d = complex(p * p / 4 - q) ** 0.5
    far = -p / 2 - d
    return (q / far, far)


@sparing("method", METHODS, every=3)
def test_two_masses(method: str) -> None:
    expected = case("dyn-ext-two-mass")["expected"]
    result = run(two_mass(2e4), Scenario("start", 0.05), method, expected["t"])
    rows = at(result, expected["t"])
    bound = 1e-5 if method == "BDF" else 1e-6
    np.testing.assert_allclose(result.shaft_moment[0, rows], expected["M12"], rtol=bound)
    np.testing.assert_allclose(result.omega[:, rows], [expected["omega1"], expected["omega2"]], rtol=bound)
    moment, first, second = exact(2e4, 0.0, result.t)
    assert float(np.max(np.abs(result.omega - [first, second]))) < 10 * result.error
    np.testing.assert_allclose(result.shaft_moment[0], moment, atol=80 * bound)
    assert result.shaft_moment.max() == pytest.approx(expected["M12_max"], rel=2e-3)
    assert result.imbalance < 1e-7


@pytest.mark.parametrize("damping_ratio", [0.5, 5.0])
@sparing("stiffness", [1e3, 1e5, 1e6, 1e8, 1e10, 1e12], every=3)
def test_damped_shafts_from_soft_to_stiff(stiffness: float, damping_ratio: float) -> None:
    k = 2 * damping_ratio * math.sqrt(stiffness * 2.5) / 2.5
    times = np.array([0.1, 0.2, 0.35, 0.5])
    result = run(two_mass(stiffness, k), Scenario("start", 0.5), instants=times)
    moment, *speeds = exact(stiffness, k, times)
    np.testing.assert_allclose(result.omega[:, at(result, times)], speeds, atol=1e-9)
    np.testing.assert_allclose(result.shaft_moment[0, at(result, times)], moment, atol=40 * 1e-7)
    assert result.imbalance < 1e-8
    assert result.rigid == ()
    assert result.method == ("merson" if stiffness < 1e4 else "collocation" if stiffness > 1e7 else result.method)


@pytest.mark.slow
def test_radau_on_a_stiff_shaft() -> None:
    k = math.sqrt(1e12 * 2.5) / 2.5
    times = np.array([0.1, 0.5])
    result = run(two_mass(1e12, k), Scenario("start", 0.5), "Radau", times)
    moment, *speeds = exact(1e12, k, times)
    np.testing.assert_allclose(result.omega[:, at(result, times)], speeds, atol=1e-12)
    np.testing.assert_allclose(result.shaft_moment[0, at(result, times)], moment, atol=1e-8)


@pytest.mark.parametrize("stiffness", [1e9, 1e10, 1e12])
def test_stiff_undamped_shafts_are_taken_as_rigid(stiffness: float) -> None:
    """What is left out is named: the ripple of the speeds is that of the exact solution."""
    result = run(two_mass(stiffness), Scenario("start", 0.5))
    assert result.rigid == (0,)
    assert any("taken as rigid" in str(verdict) for verdict in result.verdicts)
    np.testing.assert_allclose(result.omega, np.tile(20 * result.t, (2, 1)), rtol=1e-9)
    np.testing.assert_allclose(result.shaft_moment[0], 40.0, rtol=1e-12)
    ripple = 80 / 100 * 50 / 0.5 / math.sqrt(stiffness * 2.5) / 10  # speed of the first mass over the largest
    assert ripple < result.error < 2 * ripple


@pytest.mark.slow
def test_oscillation_is_followed_where_it_can_be() -> None:
    times = np.array([0.1, 0.2])
    result = run(two_mass(1e6), Scenario("start", 0.2), instants=times)
    assert result.method == "collocation"
    moment, *speeds = exact(1e6, 0.0, times)
    np.testing.assert_allclose(result.omega[:, at(result, times)], speeds, atol=1e-8)
    np.testing.assert_allclose(result.shaft_moment[0, at(result, times)], moment, atol=80 * 1e-7)


def three_mass(own: bool) -> Drive:
    """Motor, gearbox and crank with the ratios 4 and 2.5, given on their own shafts or all on the crank's."""
    if own:
        masses = (Mass(0.02), Mass(0.3), Mass(4.0))
        shafts = (Shaft(900.0, 0.4, 4.0), Shaft(2e4, 9.0, 2.5, behind_gear=True))
        return Drive(masses, shafts, characteristic=line(0.9, 80.0), cycle=cycle(-30.0, speed=8.0))
    masses = (Mass(0.02 * 100), Mass(0.3 * 6.25), Mass(4.0))
    shafts = (Shaft(900.0 * 100, 0.4 * 100), Shaft(2e4, 9.0))
    return Drive(masses, shafts, characteristic=line(90.0, 8.0), cycle=cycle(-30.0, speed=8.0))


@sparing("method", ["auto", "DOP853", "Radau"], every=3)
def test_three_masses_with_gears_against_the_matrix_exponential(method: str) -> None:
    times = np.array([0.05, 0.3, 1.0])
    drive = three_mass(True)
    result = run(drive, Scenario("run-up", 1.0, speed=3.0), method, times)
    j1, j2, j3, c1, c2, k1, k2, b = 2.0, 1.875, 4.0, 9e4, 2e4, 40.0, 9.0, 90.0
    a = np.zeros((6, 6))  # twists, speeds, 1
    a[0, 2:4] = a[1, 3:5] = 1, -1
    a[2, [0, 2, 3, 5]] = np.array([-c1, -b - k1, k1, b * 8.0]) / j1
    a[3, [0, 1, 2, 3, 4]] = np.array([c1, -c2, k1, -k1 - k2, k2]) / j2
    a[4, [1, 3, 4, 5]] = np.array([c2, k2, -k2, -30.0]) / j3
    for row, time in zip(at(result, times), times, strict=True):
        y = expm(a * time) @ [0, 0, 3, 3, 3, 1]
        np.testing.assert_allclose(result.omega[:, row] / [10, 2.5, 1], y[2:5], atol=1e-8)
        shafts = [(c1 * y[0] + k1 * (y[2] - y[3])) / 10, c2 * y[1] + k2 * (y[3] - y[4])]
        np.testing.assert_allclose(result.shaft_moment[:, row], shafts, atol=1e-5)
        speeds = np.array([10, 2.5, 1]) * (a @ y)[2:5]
        np.testing.assert_allclose(result.alpha[:, row], speeds, atol=2e-5)
        angles = result.theta[:, row] / [10, 2.5, 1]
        np.testing.assert_allclose(-np.diff(angles), y[:2], atol=1e-9)
    assert result.imbalance < 1e-9


@pytest.mark.slow
def test_own_shafts_and_reduced_ones_are_the_same_drive() -> None:
    own, all_reduced = (run(three_mass(o), Scenario("run-up", 0.6, speed=3.0)) for o in (True, False))
    assert own.omega[2, -1] == pytest.approx(all_reduced.omega[2, -1], rel=1e-12)
    assert own.omega[0, -1] == pytest.approx(10 * all_reduced.omega[0, -1], rel=1e-12)
    assert own.shaft_moment[0, -1] == pytest.approx(all_reduced.shaft_moment[0, -1] / 10, rel=1e-9)
    assert own.motor_moment[-1] == pytest.approx(all_reduced.motor_moment[-1] / 10, rel=1e-9)
    assert own.kinetic[-1] == pytest.approx(all_reduced.kinetic[-1], rel=1e-12)


def test_a_rigid_shaft_joins_its_masses() -> None:
    """Two masses on a rigid geared shaft are one, and the shaft carries what accelerates the mass behind it."""
    motor = line(0.9, 80.0)
    chain = Drive((Mass(0.02), Mass(4.0)), (Shaft(math.inf, ratio=10.0),), characteristic=motor, cycle=cycle(-30.0))
    one = Drive((Mass(6.0),), characteristic=line(90.0, 8.0), cycle=cycle(-30.0))
    scenario = Scenario("run-up", 1.0, speed=1.0)
    joined, single = run(chain, scenario), run(one, scenario)
    np.testing.assert_allclose(joined.omega[:, -1], np.array([10, 1]) * single.omega[0, -1], rtol=1e-9)
    np.testing.assert_allclose(joined.omega[0], 10 * joined.omega[1], rtol=1e-15)
    np.testing.assert_allclose(joined.shaft_moment[0], (4.0 * joined.alpha[1] + 30.0) / 10, rtol=1e-10)
    assert joined.imbalance < 1e-9


def test_a_rigid_shaft_under_the_brake() -> None:
    """The brake sits before the shaft: the shaft brakes the mass behind it."""
    chain = Drive((Mass(1.0), Mass(3.0)), (Shaft(math.inf),))
    result = run(chain, Scenario("braking", 9.0, speed=6.0, brake=Brake(8.0, mass=0)))
    assert result.t[-1] == pytest.approx(3.0, abs=1e-12)
    np.testing.assert_allclose(result.shaft_moment[0, :-1], -6.0, rtol=1e-12)


def press(stiffness: float, damping: float) -> Drive:
    """Motor at 15 times the crank's speed, elastic shaft, press."""
    motor = kloss(242.0 / 15, 0.2773061196, 160.7142857, 150.0)
    return Drive((Mass(20 / 225), Mass(10.6)), (Shaft(stiffness, damping, 15.0),), motor, upsetter(1.0), upsetter(0.0))


SCENARIO = Scenario("start", 2.5, load=(LoadStep(0.0), LoadStep(1.0, speed=10.0)))


@cache
def elastic_reference() -> np.ndarray:
    """Angles and speeds of both masses after 1 s at full load, by DOP853 with no twist, a half turn at a time."""
    drive, c, k = press(20.0, 0.05), 20.0 * 225, 0.05 * 225
    crank, motor = upsetter(1.0), drive.characteristic
    functions: Any = (crank.inertia, crank.panels.slope(crank.inertia), crank.moment)

    def f(_: float, y: np.ndarray) -> list[float]:
        p, q, w, v = y
        x = np.array([min(q, stop) - stop + (math.pi if half % 2 else PERIOD)])
        inertia, slope, moment = (crank.panels.at(g, x, before=True)[0] for g in functions)
        shaft = c * (p - q) + k * (w - v)
        drive_moment = 15 * float(motor.moment(15 * w))
        return [w, v, (drive_moment - shaft) / 20, (shaft + moment - slope * v * v / 2) / (10.6 + inertia)]

    t, y, half = 0.0, np.array([0.0, 0.0, 10.0, 10.0]), 0
    while t < 1.0:
        half += 1
        stop = half * math.pi

        def edge(_: float, y: np.ndarray, stop: float = stop) -> float:
            return float(y[1] - stop)

        edge.terminal = True
        piece = solve_ivp(f, (t, 1.0), y, method="DOP853", events=edge, rtol=1e-12, atol=1e-13, max_step=0.01)
        t, y = float(piece.t[-1]), piece.y[:, -1]
    return y


@sparing(("method", "bound"), [("auto", 1e-8), ("merson", 1e-8), ("LSODA", 1e-6), ("Radau", 1e-8)], every=4)
def test_a_press_on_an_elastic_shaft_against_an_independent_integration(method: str, bound: float) -> None:
    result = run(press(20.0, 0.05), Scenario("loaded", 1.0, speed=10.0), method)
    y = elastic_reference()
    np.testing.assert_allclose(result.omega[:, -1] / [15, 1], y[2:], atol=10 * bound)
    np.testing.assert_allclose(result.theta[:, -1] / [15, 1], y[:2], atol=10 * bound)
    assert result.imbalance < bound


@sparing("stiffness", [1e2, 1e4, 1e6, 1e9], every=4)
def test_a_press_on_ever_stiffer_shafts_becomes_one_mass(stiffness: float) -> None:
    """With critical damping; the shaft's twist, and with it the difference, falls like 1/c."""
    c = stiffness * 225
    k = 2 * math.sqrt(c * 20 * 10.6 / 30.6) / 225
    elastic = run(press(stiffness, k), SCENARIO)
    rigid = run(press(math.inf, 0.0), SCENARIO)
    assert elastic.omega[1, -1] == pytest.approx(rigid.omega[1, -1], abs=max(3e5 / c, 2e-8))
    assert elastic.imbalance < 1e-8
    assert elastic.counters["evaluations"] < 50_000


@pytest.mark.slow
def test_lag_and_gears_together() -> None:
    """The sum of the works is the gained energy, with every part in play."""
    drive = Drive(
        (Mass(0.02), Mass(0.3), Mass(4.0)),
        (Shaft(900.0, 0.4, 4.0), Shaft(2e4, 9.0, 2.5)),
        characteristic=line(0.9, 80.0),
        cycle=cycle(lambda p: -30 - 20 * np.cos(p), lambda p: 0.5 * np.sin(p) ** 2, viscous=-1.5),
        time_constant=0.02,
    )
    result = run(drive, Scenario("run-up", 1.5, brake=Brake(0.5, 0.1, mass=1, start=0.7, end=1.1)))
    assert result.imbalance < 1e-9
    energy = result.kinetic[-1] + result.elastic[-1]
    works = result.motor_work[-1] + result.load_work[-1] + result.brake_work[-1] + result.shaft_loss[-1]
    assert energy == pytest.approx(works, rel=1e-8)
    assert result.brake_work[-1] < 0
    assert result.shaft_loss[-1] < 0
    assert [e.kind for e in result.events][:2] == ["brake on", "brake off"]


def test_a_settled_start_does_not_swing() -> None:
    drive = two_mass(2e4)
    settled = run(drive, Scenario("going on", 0.1, speed=1.0, settled=True))
    np.testing.assert_allclose(settled.shaft_moment[0], 40.0, rtol=1e-9)
    swinging = run(drive, Scenario("going on", 0.1, speed=1.0))
    assert swinging.shaft_moment.max() > 79
