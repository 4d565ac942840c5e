"""Error estimates of balancing against true errors in random linkages.

The truth are the harmonics of the inertia loads in extended precision, and the smallest circle around their sum by
Newton's method there; that no other circle is smaller shows at thousands of places of the curve.
"""

from __future__ import annotations

from collections import defaultdict
from typing import Any, NamedTuple

import numpy as np
import pytest
from bounding import assert_bounds, part

from machine.balance.balanced import chain_of
from machine.reduction.drawn import TURN, closed
from tmmcalc import TmmError
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loading import Body
from tmmcalc.machine.balance.schemes import (
    Balance,
    lanchester,
    least_squares_counterweight,
    minimax_counterweight,
    per_moment,
)
from tmmcalc.machine.balance.shaking import Shaking, crank_angle, inertia_loads, shaking

pytestmark = pytest.mark.skipif(not WIDER, reason="no wider float here: the estimate has no reference")

Array = np.ndarray[Any, Any]
Bodies = tuple[Body, ...]
HIGHEST = 200  # orders of the scenes that are looked at: a linkage nearer to a dead point takes too long here
STRIDE = 16  # orders whose exponentials are products of those of two of them
PLACES = 400  # of the turn where forces are compared
AROUND = 1e-6  # a curve may not lie farther outside of its circle, where only samples of it are seen


class Harmonics(NamedTuple):
    """A periodic function by its coefficients and their orders, in extended precision."""

    c: Array
    k: Array

    def at(self, t: Array, order: int = 0) -> Array:
        """Values at t (m,), or those of a derivative."""
        # an exponential of extended precision costs a hundred products: those of few orders make up all
        parts = (STRIDE * np.floor(self.k / STRIDE), np.mod(self.k, STRIDE))
        few, which = zip(*(np.unique(part, return_inverse=True) for part in parts), strict=True)
        tens, units = (np.exp(1j * np.multiply.outer(t, each)) for each in few)
        return (tens[:, which[0]] * units[:, which[1]]) @ (self.c * (1j * self.k) ** order)

    def coefficient(self, order: int) -> complex:
        return complex(self.c[self.k == order][0])

    def turned(self) -> Harmonics:
        """The same in the frame of the crank."""
        return Harmonics(self.c, self.k - 1)

    @property
    def rms(self) -> float:
        return float(np.sqrt(np.sum(np.abs(self.c) ** 2)))


class Scene(NamedTuple):
    """What was solved, and the truth: harmonics of force and moment."""

    found: Shaking
    force: Harmonics
    moment: Harmonics
    sizes: tuple[float, float]  # that forces and moments are measured against


def drawn(seed: int) -> tuple[Chain, Bodies, Shaking]:
    """A random linkage with masses that turns fully at any speed, half of them with an acceleration."""
    rng = np.random.default_rng(seed)
    size, mass = 10 ** rng.uniform(-3, 3, 2)
    mechanism = closed(rng, size, -1, 4)

    def body(link: int) -> Body:
        center = complex(*(size * rng.uniform(-1, 1, 2))) * rng.integers(2)
        return Body(link, mass * rng.uniform(0.1, 3), mass * size**2 * rng.uniform(0, 0.5) * rng.integers(2), center)

    bodies = tuple(body(link.id) for link in mechanism.links if rng.random() < 0.85) or (body(3),)
    speed = float(rng.choice([-1, 1]) * 10 ** rng.uniform(-2, 3))
    acceleration = float(speed**2 * rng.normal() * rng.integers(2))
    about = None if rng.random() < 0.5 else complex(*(size * rng.normal(size=2)))
    chain = chain_of(mechanism)
    x = rng.uniform(-3, 3) + np.linspace(0, TURN, 13)
    return chain, bodies, shaking(chain, bodies, x, speed, acceleration, about=about)


def scene(seed: int) -> Scene | None:
    """A drawn linkage with its truth; None if it is refused, or balanced but for rounding."""
    try:
        chain, bodies, found = drawn(seed)
    except TmmError:
        return None
    if found.series.highest > HIGHEST or found.size.rms <= 1e-9 * found.scale:
        return None
    count = max(256, 4 * found.series.highest + 4)
    t = np.arange(count) * (8 * np.arctan(np.longdouble(1)) / count)
    motion = found.speed, found.acceleration, found.about
    loads = inertia_loads(chain, bodies, t - np.longdouble(crank_angle(chain)), *motion)
    k = np.where(np.arange(count) < count // 2, np.arange(count), np.arange(count) - count)
    kept = np.abs(k) <= found.series.highest + 3
    force, moment = (Harmonics(np.fft.fft(each)[kept] / count, k[kept].astype(np.longdouble)) for each in loads)
    return Scene(found, force, moment, (found.scale, moment_scale(chain, bodies, found)))


def moment_scale(chain: Chain, bodies: Bodies, found: Shaking) -> float:
    """Largest sum of the magnitudes that the moment is made from."""
    x = np.linspace(0, TURN, PLACES)
    total = np.zeros(PLACES)
    for body in bodies:
        force, _ = inertia_loads(chain, (body,), x, found.speed, found.acceleration, found.about)
        couple = inertia_loads(chain, (Body(body.link, 0.0, body.inertia, 0j),), x, found.speed, found.acceleration)[1]
        arm = chain.evaluate(x).motions[body.link].point(body.center).r - found.about
        total += np.abs(arm) * np.abs(force) + np.abs(couple)
    return float(np.max(total))


def places(found: Shaking) -> Array:
    """Angles at random and about the peaks."""
    rng = np.random.default_rng(1)
    near = np.concatenate([at + rng.normal(size=20) / 50 for at in (found.size.at, found.moment_size.at)])
    return np.concatenate((rng.uniform(0, TURN, PLACES), near))


def of_shaking(case: Scene) -> list[tuple[float, float]]:
    """Rows, series, their sizes."""
    found, (force, moment) = case.found, case.sizes
    t, phi = places(found), found.x.astype(np.longdouble) + (found.phi - found.x)[0].astype(np.longdouble)
    errors = [
        np.max(np.abs(found.force - case.force.at(phi))) / force,
        np.max(np.abs(found.turned - case.force.turned().at(phi))) / force,
        np.max(np.abs(found.moment - case.moment.at(phi).real)) / moment,
        np.max(np.abs(found.series.at(t) - case.force.at(t))) / force,
        np.max(np.abs(found.moment_series.at(t) - case.moment.at(t))) / moment,
        abs(found.size.rms - case.force.rms) / force,
        abs(found.moment_size.rms - case.moment.rms) / moment,
        max(float(np.max(np.abs(case.force.at(t)))) - found.size.largest, 0.0) / force,
    ]
    return [(found.error, float(max(errors)))]


def of_harmonics(case: Scene, balance: Balance) -> tuple[list[tuple[float, float]], list[tuple[float, float]]]:
    """Static moments and what is left by weights that take harmonics away; the ratio of the sizes."""
    found, scale = case.found, case.sizes[0]
    orders = [weight.order for weight in balance.weights]
    left = Harmonics(np.where(np.isin(case.force.k, orders), 0, case.force.c), case.force.k)
    errors = [abs(balance.after.rms - left.rms) / scale]
    for weight in balance.weights:
        factor = per_moment(weight.order, found.speed, found.acceleration)
        errors.append(abs(weight.moment * factor + case.force.coefficient(weight.order)) / scale)
    phi = found.x.astype(np.longdouble) + (found.phi - found.x)[0].astype(np.longdouble)
    errors.append(float(np.max(np.abs(balance.force - left.at(phi)))) / scale)
    ratios = []
    if balance.ratio is not None:
        exact = case.force.rms / left.rms
        ratios.append((balance.ratio_error, abs(balance.ratio / exact - 1)))
    return [(balance.error, max(errors))], ratios


def smallest(curve: Harmonics, start: Array) -> tuple[complex, float]:
    """Centre and radius of the circle that contacts near ``start`` (m,) hold, by Newton's method."""
    t = start.astype(np.longdouble)
    for _ in range(8):
        z, z1, z2 = (curve.at(t, order) for order in range(3))
        center = middle(z)
        g, h = (np.conj(z - center) * z1).real, np.longdouble(1e-8)
        jacobian = np.diag(np.abs(z1) ** 2 + (np.conj(z - center) * z2).real)
        for j in range(len(t)):
            shift = np.where(np.arange(len(t)) == j, h, 0) * z1
            change = (middle(z + shift) - middle(z - shift)) / (2 * h)
            jacobian[:, j] -= (np.conj(change) * z1).real
        t = t - np.linalg.lstsq(jacobian.astype(float), g.astype(float), rcond=1e-14)[0]
    z = curve.at(t)
    return complex(middle(z)), float(np.max(np.abs(z - middle(z))))


def middle(z: Array) -> Any:
    """Centre of the circle on two points as diameter, or through three."""
    if len(z) == 2:
        return (z[0] + z[1]) / 2
    a, u, v = z[0], z[1] - z[0], z[2] - z[0]
    area = u.real * v.imag - u.imag * v.real
    return a + (abs(u) ** 2 * v - abs(v) ** 2 * u) / (2j * area)


def of_minimax(case: Scene) -> list[tuple[float, float]]:
    """The counterweight and what it leaves; the contacts are looked for on a thousand points of the curve."""
    found, (scale, _) = case.found, case.sizes
    balance = minimax_counterweight(found)
    (weight,) = balance.weights
    told = -weight.moment * per_moment(1, found.speed, found.acceleration)
    curve = Harmonics(case.force.turned().c / scale, case.force.turned().k)
    dense = np.linspace(0, TURN, 4 * len(curve.k) + 1000, endpoint=False)
    reach = np.abs(curve.at(dense) - told / scale)
    if np.min(reach) > (1 - AROUND) * np.max(reach) or np.max(reach) < 1e-6:  # a circle is held by no contacts
        center, radius = curve.coefficient(0), np.max(np.abs(curve.at(dense) - curve.coefficient(0)))
    else:
        held = (reach >= np.roll(reach, 1)) & (reach > np.roll(reach, -1)) & (reach > np.max(reach) - 1e-4)
        center, radius = best(curve, dense[held])
    assert np.max(np.abs(curve.at(dense) - center)) <= radius * (1 + 1e-12)
    phi = found.x.astype(np.longdouble) + (found.phi - found.x)[0].astype(np.longdouble)
    left = np.abs(case.force.turned().at(phi) / scale - center)
    errors = [
        abs(told / scale - center),
        abs(balance.after.largest / scale - radius),
        np.max(np.abs(np.abs(balance.force) / scale - left)),
    ]
    return [(balance.error, float(max(errors)))]


def best(curve: Harmonics, near: Array) -> tuple[complex, float]:
    """The smallest circle that two or three places out of ``near`` hold and that leaves none of them out."""
    from itertools import combinations

    found = []
    for size in (2, 3):
        for some in combinations(range(len(near)), size):
            center, radius = smallest(curve, near[list(some)])
            if np.max(np.abs(curve.at(near) - center)) <= radius * (1 + 1e-11):
                found.append((radius, center))
        if found:
            break
    radius, center = min(found, key=lambda each: each[0])
    return center, radius


def check(seeds: range, scenes: int) -> None:
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)
    for seed in seeds:
        case = scene(seed)
        if case is None:
            continue
        pairs["linkage"] += of_shaking(case)
        for balance in (least_squares_counterweight(case.found), lanchester(case.found), lanchester(case.found, 2)):
            left, ratio = of_harmonics(case, balance)
            pairs["linkage"] += left
            pairs["ratio"] += ratio
        pairs["minimax"] += of_minimax(case)
    for key, values in pairs.items():
        assert_bounds(values, key, scenes=scenes)


def test_estimates_of_some_linkages() -> None:
    check(range(184, 188), 3)


@pytest.mark.slow
def test_estimates_of_many_linkages() -> None:
    check(range(part(330, 6)), part(200, 6))
