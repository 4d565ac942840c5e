"""Methods of balancing a linkage: its shaking force from n positions beside Fourier series and exact extremes.

The counterweight of least squares is the mean of the hodograph in the crank frame (3.74); the force is smooth and
periodic, so that equal steps give its mean beyond every order. That of the least maximum is the centre of the smallest
circle around the hodograph: around n points of it, or around the curve. A centre is judged by the farthest place of
the curve from it, which brute force finds; no centre does better than the circle on the two or three places that hold
the curve, in closed form.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.numerics.fourier import TURN, resolved
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.sampled import COUNTS as POINTS
from tmmcalc.core.studies.sampled import NODES, closed_in, of_positions
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import FLOOR, Reference, Study
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.results import Kinematics
from tmmcalc.machine.balance.circle import enclosing_circle, smallest_circle
from tmmcalc.machine.balance.shaking import Shaking, crank_angle, inertia_loads
from tmmcalc.machine.stages.balance import Balances

COUNTS = (6, 8, 12, 18, 24, 36, 48, 72, 96, 192)  # positions of a turn
ROUNDED = 1e-9  # of the force: a smaller circle is a hodograph that is a point
DENSER = 4  # times the harmonics: positions of the reference
SPECTRAL = "beyond every order: the force is smooth and periodic"


def studies(scene: Scene) -> Iterator[Study]:
    """Of a linkage that shakes at all; engines and rotors have closed forms."""
    found: Balances = scene.results["balance"]
    if found.linkage is None or not WIDER or not found.linkage.shaking.size.largest:
        return
    mechanism, bodies, _ = scene.inputs.linkage
    kinematics: Kinematics = scene.results["kinematics"]
    force = found.linkage.shaking
    chain = chain_of(mechanism, kinematics)
    yield _mean(_Hodograph(chain, bodies, force), scene.clock)
    yield _circle(force, scene.clock)


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

    def series(self) -> complex:
        """Of so many positions that all harmonics are resolved."""
        found, _ = resolved(lambda phi: self.at(phi)[None], np.array([self.force.scale]), where="balance")
        return found[0].coefficient(0)

    def exact(self) -> np.clongdouble:
        """Of many positions, in extended precision."""
        count = DENSER * (2 * self.force.series.highest + 1)
        turn = 8 * np.arctan(np.longdouble(1))
        return np.clongdouble(np.mean(self.at(turn * np.arange(count, dtype=np.longdouble) / count)))


def _mean(hodograph: _Hodograph, clock: Clock) -> Study:
    exact, size = hodograph.exact(), hodograph.force.size.largest

    def error(found: complex) -> float:
        return relative(found, exact, size)

    ways = [Way(f"{n} positions", 1 / n, partial(hodograph.mean, n)) for n in COUNTS]
    name = f"the mean of {DENSER} times as many positions in extended precision (64-bit mantissa)"
    return Study(
        "balance",
        "force of the least-squares counterweight",
        Reference(name, float(np.finfo(np.longdouble).eps)),
        (
            series("series until resolved", [Way("", None, hodograph.series)], error, clock, note="all harmonics"),
            series("mean of n positions (3.74)", ways, error, clock, note=SPECTRAL, stepwise=False),
        ),
    )


def _circle(force: Shaking, clock: Clock) -> Study:
    """The largest force left by the centre that a method finds, above the least that is possible."""
    curve = force.series.turned(-1)
    circle = enclosing_circle(curve)
    least = _least(curve.at(np.array(circle.contacts)))
    size = least if least > ROUNDED * force.size.largest else force.size.largest

    count = max(NODES, DENSER * (2 * curve.highest + 1))
    nodes = curve.even(count)

    def left(center: complex) -> float:
        """The largest force [N] that the counterweight of a centre leaves."""

        def apart(phi: Real) -> Real:
            return np.abs(curve.at(phi.astype(float)) - center)[None]

        farthest = TURN / count * np.argmax(np.abs(nodes - center), keepdims=True)
        return float(closed_in(apart, farthest, TURN / count)[0])

    def error(center: complex) -> float:
        return max((left(center) - least) / size, FLOOR)

    def pointed(count: int) -> complex:
        return smallest_circle(curve.at(TURN * np.arange(count) / count))[0]

    ways = [Way(f"{n} positions", 1 / n, partial(pointed, n)) for n in POINTS]
    return Study(
        "balance",
        "largest force left by the minimax counterweight",
        Reference("the circle on the places of the hodograph that hold it, a bound from below", error(circle.center)),
        (
            series("circle around the curve", [Way("", None, lambda: enclosing_circle(curve).center)], error, clock),
            of_positions("circle around n points", ways, error, clock),
        ),
    )


def _least(held: Plane) -> float:
    """Radius of the least circle around two or three points, (n,): the longest side, or a b c/(4 A) where it is acute.

    No circle around a curve through these points is smaller.
    """
    sides = np.sort(np.abs(held - np.roll(held, 1)))
    if len(held) < 3 or sides[2] ** 2 >= sides[0] ** 2 + sides[1] ** 2:
        return float(sides[-1]) / 2
    area = abs(((held[1] - held[0]) * np.conj(held[2] - held[0])).imag) / 2
    return float(np.prod(sides) / (4 * area))
