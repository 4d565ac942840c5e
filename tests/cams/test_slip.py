"""The slip function where R is small, and at a speed that varies: largest value, verdict and intervals agree."""

from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest

from cams.turns import turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.forces.turn import at_angles
from tmmcalc.cams.program import Positions
from tmmcalc.cams.speed import Speed
from tmmcalc.cams.strength.case import roller_acceleration
from tmmcalc.cams.strength.solve import solve_strength
from tmmcalc.cams.task import AngleLimits, Asked, CamTask, Loads, Requirements, Spring
from tmmcalc.core.numerics.panels import panels

FOLLOWER = Follower("translating", 0.06, roller=0.008)


def task(laws, speed, least, inertia):
    """Barely pressed by the spring where the follower brakes most."""
    needs = Requirements(
        width=0.008, rolling_arm=1e-5, roller_friction=0.15, pin_friction=0.05, pin=0.003, roller_inertia=inertia
    )
    loads = Loads(speed, 0.2, spring=Spring("preload", least=least))
    program = turn(*laws, high=20.0)
    return CamTask(program, Asked("translating"), AngleLimits(1.0, None), 60, loads=loads, requirements=needs)


def slipping(found):
    return next(each for each in found.margins if each.name == "no slip")


BARELY = {
    "jump": (("const", "const"), 600.0, 5.0, 1e-7),
    "slow": (("const", "const"), 100.0, 0.1, 1e-8),
    "kink": (("sine", "linear"), 100.0, 0.01, 4e-8),
    "smooth": (("cosine", "linear"), 100.0, 0.2, 4e-8),
}


@pytest.mark.parametrize("name", BARELY)
def test_largest_slip_of_a_roller_that_is_barely_pressed(name):
    """D of a dense grid that closes in on its largest value, by its formula."""
    asked = task(*BARELY[name])
    forces = solve_forces(asked, FOLLOWER)
    found = solve_strength(asked, FOLLOWER, forces)
    judged, rolling = slipping(found), found.rolling

    def scan(phi):
        piece = np.clip(np.searchsorted(asked.program.edges, phi) - 1, 0, len(asked.program.edges) - 2)
        dense = Positions(phi, piece, ("",) * len(phi))
        rows = solve_strength(asked, FOLLOWER, replace(forces, positions=dense))
        return np.where(rows.touching, rows.slip, 0.0)

    low, high, best = 0.0, 2 * pi, 0.0
    for _ in range(4):
        phi = np.linspace(low, high, 20_001)
        values = scan(phi)
        k = int(np.argmax(values))
        best, step = max(best, float(values[k])), phi[1] - phi[0]
        low, high = max(phi[k] - 3 * step, 0.0), min(phi[k] + 3 * step, 2 * pi)
    best = max(best, float(np.max(found.slip)))  # the rows have both sides of a jump
    assert judged.value == pytest.approx(best, rel=1e-8)
    assert judged.value >= best * (1 - 1e-11)
    assert (judged.verdict == "slip") == bool(rolling.slipping)
    assert (judged.value > 1) == bool(rolling.slipping)


def test_roller_of_a_cam_whose_speed_varies():
    """A is r2/omega_m^2 times the angular acceleration, by differences of the roller's speed in time."""
    asked, step = task(("cosine", "sine"), 100.0, 5.0, 1e-7), 1e-4
    on = panels(0.0, 2 * pi, asked.program.edges.tolist())
    omega = 100 * (1 + 0.1 * np.cos(on.x))
    speed = Speed(on, omega, -omega * 10 * np.sin(on.x))
    asked = replace(asked, turning=speed)
    phi = np.radians([20.0, 47.0, 95.0, 120.0, 250.0])

    def spin(phi):
        """omega (v/r2 - 1) with the roller's centre i S e^(i phi) on the cam."""
        ahead, behind = (1j * (0.06 + asked.program.at(x)[0]) * np.exp(1j * x) for x in (phi + step, phi - step))
        return speed.at(phi)[0] * (np.abs(ahead - behind) / (2 * step) / 0.008 - 1)

    grown = (spin(phi + step) - spin(phi - step)) / (2 * step) * speed.at(phi)[0]
    at = at_angles(asked, asked.loads, phi)
    pressed = roller_acceleration(asked, asked.loads, FOLLOWER, at, np.ones(5))
    assert pressed == pytest.approx(0.008 * grown / 100**2, rel=1e-5, abs=1e-8)
    on_outer = roller_acceleration(asked, asked.loads, FOLLOWER, at, -np.ones(5))
    assert on_outer - pressed == pytest.approx(2 * 0.008 * speed.at(phi)[1] / 100**2, rel=1e-9)
    found, steady = (solve_strength(each, FOLLOWER) for each in (asked, replace(asked, turning=None)))
    assert any("eps (v - r2)" in note for note in found.notes)
    assert not any("eps" in note for note in steady.notes)
    end = int(np.argmin(np.abs(found.positions.phi - radians(140))))
    assert found.slip[end] != pytest.approx(steady.slip[end], rel=1e-3)
