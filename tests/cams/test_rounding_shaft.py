"""Estimates of what a cam asks of a shaft against the follower at 50 digits, for random phases, ratios, loads."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import atan2, cos, mp, mpf, pi, sin

from cams.shaft_scene import GIVEN, LOADS, results, spec_of

mp.dps = 50
RISE, HIGH, BACK = (mpf(angle) * pi / 180 for angle in (80, 20, 90))
STROKE, START, ROLLER, TOP = mpf("0.024"), mpf("0.04"), mpf("0.01"), mpf("0.19")


def lifted(phi: mpf) -> tuple[mpf, mpf, mpf, int]:
    """y, y', y'' of the 3-4-5 polynomial and the sense of its motion."""

    def law(k: mpf, angle: mpf) -> tuple[mpf, mpf, mpf]:
        second = 60 * k * (1 - 3 * k + 2 * k**2) / angle**2
        return STROKE * k**3 * (10 - 15 * k + 6 * k**2), STROKE * 30 * k**2 * (1 - k) ** 2 / angle, STROKE * second

    phi %= 2 * pi
    if phi < RISE:
        return (*law(phi / RISE, RISE), 1)
    if phi < RISE + HIGH:
        return STROKE, mpf(0), mpf(0), 1
    if phi < RISE + HIGH + BACK:
        y, slope, second = law((RISE + HIGH + BACK - phi) / BACK, BACK)
        return y, -slope, second, -1
    return mpf(0), mpf(0), mpf(0), -1


def asked(theta: mpf, begin: mpf, ratio: mpf, mass: mpf) -> tuple[mpf, mpf, mpf]:
    """J, dJ/dtheta and the sum of all moments at the input shaft."""
    y, slope, second, sense = lifted(ratio * (theta - begin))
    static = (mpf(-120) if sense > 0 else mpf(0)) - mass * mpf("9.81") - 300 - 30000 * y
    load = static - mass * (100 * ratio) ** 2 * second
    angle = atan2(slope, START + y)
    mu = mpf("0.1") * abs(sin(angle)) * (1 + 2 * (STROKE + ROLLER - y) / (TOP - START - STROKE - ROLLER))
    lifting = sense if load <= 0 else -sense
    push = -load / (cos(angle) - lifting * mu)
    moment = (static * slope - mu * abs(push * slope)) * ratio
    return mass * (slope * ratio) ** 2, 2 * mass * slope * second * ratio**3, moment


@pytest.mark.parametrize("seed", range(6))
def test_estimates_hold(seed: int) -> None:
    random = np.random.default_rng(seed)
    ratio, turns = [("1", 1), ("0.5", 2), ('"2/3"', 3), ("2", 1), ("1.5", 2), ('"1/12"', 12)][seed]
    phase, mass = round(float(random.uniform(0, 360)), 3), round(float(random.uniform(0.1, 3)), 3)
    torque = f'period = "{360 * turns} deg"'
    loads = LOADS.replace("1.2 kg", f"{mass} kg") + GIVEN
    more = {"cam": f'shaft = "crank"\nratio = {ratio}', "torque": torque, "loads": loads}
    spec = spec_of(**more, phase=phase)
    found = results(spec, "reduction")
    own, reduction = found["cam_load"], found["reduction"]
    exact_ratio = mpf(own.ratio) if seed not in (2, 5) else mpf(round(own.ratio * 12)) / 12
    begin = mpf(str(phase)) * pi / 180
    on = reduction.cycle.panels
    points = np.sort(random.choice(on.x.ravel(), 60, replace=False))
    true = np.array([asked(mpf(float(x)), begin, exact_ratio, mpf(str(mass))) for x in points]).astype(float)
    moments = own.moments().sum(axis=0)
    errors = (own.error.inertia, own.error.slope, own.error.moment)
    for values, exact, error in zip((own.inertia, own.slope, moments), true.T, errors, strict=True):
        size = float(np.max(np.abs(values)))
        there = own.panels.at(values, points)
        assert float(np.max(np.abs(there - exact))) <= error * size
    assert own.error.moment < 1e-10
    assert own.error.functions == max(errors)
