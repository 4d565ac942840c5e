"""Estimated errors of tooth outlines: distances of their points from fillets and involutes in 50 digits."""

from __future__ import annotations

from math import radians
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.meshing.members import Member
from tmmcalc.gears.meshing.profiles import WheelProfile
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.meshing.tooth import solve_profiles

pytestmark = pytest.mark.slow

SCENES = 110  # pairs, of two wheels each
POINTS = 6


def _tooth(member: Member) -> tuple[Any, Any]:
    """Fillet by the slope of the rack's normal and involute by its roll (4.75), as curves in high precision."""
    wheel, rack = member.wheel, member.wheel.rack
    beta, alpha, x = mp.mpf(wheel.helix), mp.mpf(rack.angle), mp.mpf(float(wheel.shift))
    a_t = mp.atan(mp.tan(alpha) / mp.cos(beta))
    r = wheel.teeth / (2 * mp.cos(beta))
    rho = mp.mpf(rack.clearance) / (1 - mp.sin(alpha))
    height, width = rho, rho / mp.cos(beta)
    end = mp.mpf(rack.addendum)
    slant = mp.sqrt((width * mp.cos(a_t)) ** 2 + (height * mp.sin(a_t)) ** 2)
    x_s = (x - end) * mp.tan(a_t) - width**2 * mp.cos(a_t) / slant
    y_s = x - end - mp.mpf(rack.clearance) + height
    psi = (mp.pi / 2 + 2 * x * mp.tan(alpha)) / wheel.teeth

    def fillet(theta: Any) -> Any:
        across = mp.sqrt((width * mp.cos(theta)) ** 2 + (height * mp.sin(theta)) ** 2)
        place = mp.mpc(x_s + width**2 * mp.cos(theta) / across, y_s - height**2 * mp.sin(theta) / across)
        roll = (x_s + y_s * mp.cot(theta) + (width**2 - height**2) * mp.cos(theta) / across) / r
        return (place - r * roll + mp.mpc(0, r)) * mp.expjpi((psi - roll) / mp.pi)

    def involute(xi: Any) -> Any:
        turned = psi + mp.tan(a_t) - a_t - xi
        return r * mp.cos(a_t) * mp.mpc(-xi, 1) * mp.expjpi(turned / mp.pi)

    return fillet, involute


def _off(curve: Any, at: float, told: complex) -> float:
    """Distance of a point from a curve, across its direction."""
    exact, rate = curve(mp.mpf(at)), mp.diff(curve, mp.mpf(at))
    missed = mp.mpc(told.real, told.imag) - exact
    return float(abs(mp.im(missed * mp.conj(rate))) / abs(rate))


def _error(member: Member, profile: WheelProfile) -> float:
    half, (fillet, involute) = half_tooth(member), _tooth(member)
    worst = 0.0
    for part, curve in ((half.fillet, fillet), (half.flank, involute)):
        at = np.linspace(part.curve.start, part.curve.end, POINTS)
        told = (profile.x + 1j * profile.y)[profile.part == part.name] / profile.module
        worst = max(worst, *(_off(curve, float(t), complex(point)) for t, point in zip(at, told, strict=True)))
    return worst / half.tip


def test_estimates_of_outlines_bound_their_errors() -> None:
    rng, pairs = np.random.default_rng(6), []
    with mp.workdps(50):
        while len(pairs) < 2 * SCENES:
            z1, z2 = int(rng.integers(9, 50)), int(rng.integers(12, 150))
            helix = float(rng.choice([0.0, radians(rng.uniform(3, 30))]))
            shifts = (float(rng.uniform(-0.2, 0.7)), float(rng.uniform(-0.3, 0.6)))
            task = PairTask((z1, z2), 0.0035, helix=helix, strategy="given", shifts=shifts, refuse=False)
            try:
                found = solve_pair(task)
                profiles = solve_profiles(Pairs((found,), "", ()), POINTS).wheels
                pairs += [(p.error, _error(Member(found, k), p)) for k, p in enumerate(profiles)]
            except NoSolutionError:
                continue
    assert_bounds(pairs, "outline")
