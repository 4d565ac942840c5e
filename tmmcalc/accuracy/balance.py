"""Methods of balancing a linkage: its shaking force from n positions beside Fourier series and exact extremes.

The counterweight of least squares is the mean of the hodograph in the crank frame (3.74); the force is smooth and
periodic, so that equal steps give its mean beyond every order. That of the least maximum is the centre of the smallest
circle around the hodograph: around n points of it, or around the curve.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.accuracy.measure import Clock, Way, series
from tmmcalc.accuracy.sampled import SECOND
from tmmcalc.accuracy.study import FLOOR, Reference, Study
from tmmcalc.accuracy.subjects import Scene
from tmmcalc.linkage.balance.circle import enclosing_circle, smallest_circle
from tmmcalc.linkage.balance.shaking import Shaking, crank_angle, inertia_loads, shaking
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.plane import Plane, Real
from tmmcalc.linkage.results import Kinematics
from tmmcalc.numerics.extended import WIDER
from tmmcalc.numerics.fourier import TURN, magnitude
from tmmcalc.stages.balance import Balances

COUNTS = (6, 8, 12, 18, 24, 36, 48, 72, 96, 192)  # positions of a turn
POINTS = (8, 12, 24, 48, 96, 192, 384, 768)  # of the hodograph
DENSER = 4  # times the harmonics: positions of the reference
SPECTRAL = "beyond every order: the force is smooth and periodic"


def studies(scene: Scene) -> Iterator[Study]:
    """Of a linkage; engines and rotors have closed forms."""
    found: Balances = scene.results["balance"]
    if found.linkage is None or not WIDER:
        return
    mechanism, bodies, _ = scene.inputs.linkage
    kinematics: Kinematics = scene.results["kinematics"]
    force = found.linkage.shaking
    chain = chain_of(mechanism, kinematics)
    yield _mean(_Hodograph(chain, bodies, force), partial(_stage, chain, bodies, kinematics), scene.clock)
    yield _circle(force, scene.clock)


def _stage(chain: Chain, bodies: tuple[Body, ...], kinematics: Kinematics) -> complex:
    found = shaking(chain, bodies, kinematics.x[:1], kinematics.speed, kinematics.acceleration)
    return found.series.coefficient(1)


class _Hodograph:
    """The shaking force in the crank frame [N]."""

    def __init__(self, chain: Chain, bodies: tuple[Body, ...], force: Shaking) -> None:
        self.chain, self.bodies, self.force = chain, bodies, force

    def at(self, phi: Real) -> Plane:
        """In the precision of phi (n,)."""
        x = phi - phi.dtype.type(crank_angle(self.chain))
        force, _ = inertia_loads(self.chain, self.bodies, x, self.force.speed, self.force.acceleration)
        return force * np.exp(-1j * phi)

    def mean(self, count: int) -> complex:
        """Of n positions at equal steps."""
        return complex(np.mean(self.at(TURN * np.arange(count) / count)))

    def exact(self) -> np.clongdouble:
        """Of many positions, in extended precision."""
        count = DENSER * (2 * self.force.series.highest + 1)
        turn = 8 * np.arctan(np.longdouble(1))
        return np.clongdouble(np.mean(self.at(turn * np.arange(count, dtype=np.longdouble) / count)))


def _mean(hodograph: _Hodograph, stage: partial[complex], clock: Clock) -> Study:
    exact, size = hodograph.exact(), hodograph.force.size.largest

    def error(found: complex) -> float:
        return max(float(np.abs(found - exact)) / size, FLOOR)

    ways = [Way(f"{n} positions", 1 / n, partial(hodograph.mean, n)) for n in COUNTS]
    name = f"the mean of {DENSER} times as many positions in extended precision (64-bit mantissa)"
    return Study(
        "balance",
        "force of the least-squares counterweight",
        Reference(name, float(np.finfo(np.longdouble).eps)),
        (
            series("series until resolved", [Way("", 1.0, stage)], error, clock, note="all harmonics, with extremes"),
            series("mean of n positions (3.74)", ways, error, clock, note=SPECTRAL),
        ),
    )


def _circle(force: Shaking, clock: Clock) -> Study:
    """The largest force left by the centre that a method finds, above the least that is possible."""
    curve = force.series.turned(-1)
    circle = enclosing_circle(curve)
    least, size = circle.radius - circle.gap, circle.radius or 1.0

    def error(center: complex) -> float:
        return max((magnitude(curve.plus({0: -center})).largest - least) / size, FLOOR)

    def pointed(count: int) -> complex:
        return smallest_circle(curve.at(TURN * np.arange(count) / count))[0]

    ways = [Way(f"{n} positions", 1 / n, partial(pointed, n)) for n in POINTS]
    return Study(
        "balance",
        "largest force left by the minimax counterweight",
        Reference(
            "the largest circle that some points of the hodograph ask for, a bound from below", circle.gap / size
        ),
        (
            series("circle around the curve", [Way("", 1.0, lambda: enclosing_circle(curve).center)], error, clock),
            series("circle around n points", ways, error, clock, expected=2.0, note=SECOND),
        ),
    )
