"""Methods of inverting the involute, by what they make of the centre distance and of the contact ratio.

    inv(alpha_w) = q        alpha_w = (3 q)^(1/3) (1 - c1 (3 q)^(2/3) + c2 (3 q)^(4/3) - ...)

Terms of the series, halvings, steps of the fixed point alpha = arctan(q + alpha) and of Newton's method (4.57) are the
settings; a method works on all pairs of the scene at once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import pi

import numpy as np

from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import FLOOR, Reference, Series, Study
from tmmcalc.gears.involute.function import inverse_extended, inverse_involute, involute
from tmmcalc.gears.involute.pair import Pair
from tmmcalc.gears.meshing.geometry import external_pair
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.model import Values

# of powers of (3 q)^(2/3) in alpha_w/(3 q)^(1/3)
TERMS = (1.0, -2 / 15, 3 / 175, -2 / 1575, -16 / 202125, 362 / 9384375, -49711 / 12415528125)
ALL_TERMS = tuple(range(1, len(TERMS) + 1))
HALVINGS = (6, 10, 14, 18, 24, 30, 40, 52)
FIXED = (5, 10, 20, 40, 80, 160)
NEWTON = (2, 3, 4, 5, 6, 7, 8)
START = 1.0  # [rad] from which the textbook starts, right of every usual root

Inverse = Callable[[Values, int], Values]


def studies(scene: Scene) -> Iterator[Study]:
    """Centre distance and contact ratio of all external pairs; nothing without one."""
    found = [pair for pair in scene.results["pair"].pairs if pair.task.kind == "external"]
    if not found:
        return
    pairs = [external_pair(pair) for pair in found]
    targets = np.array([float(involute(float(pair.angle))) for pair in pairs])
    exact = inverse_extended(targets)
    reference = Reference("Newton in extended precision (64-bit mantissa)", float(np.finfo(np.longdouble).eps))
    for quantity, measure in (
        ("centre distance", partial(_distances, pairs)),
        ("contact ratio", partial(_ratios, found, pairs)),
    ):
        truth = measure(exact)

        def error(angle: Values, measure: Callable[[Values], Values] = measure, truth: Values = truth) -> float:
            return relative(measure(np.asarray(angle, np.longdouble)), truth)

        yield Study("pair", quantity, reference, tuple(_series(scene, targets, error)))


def _told(count: int) -> Callable[[Values], int]:
    """What a way costs, whatever it finds."""
    return lambda found: count


def _series(scene: Scene, q: Values, error: Callable[[Values], float]) -> Iterator[Series]:
    methods: tuple[tuple[str, Inverse, tuple[int, ...], str], ...] = (
        ("series", _by_series, ALL_TERMS, "terms"),
        ("bisection", _by_halving, HALVINGS, "halvings"),
        ("fixed point", _by_fixed_point, FIXED, "steps"),
        ("Newton (4.57)", _by_newton, NEWTON, "steps"),
    )
    for name, inverse, counts, unit in methods:
        halves = inverse is _by_halving  # the bracket, its step; the others have none, and no order by it
        sizes = [pi / 2 / 2**n if halves else None for n in counts]
        ways = [
            Way(f"{n} {unit}", size, partial(inverse, q, n), _told(n)) for n, size in zip(counts, sizes, strict=True)
        ]
        yield series(name, ways, error, scene.clock, expected=1.0 if halves else None)
    own = Way("to rounding", None, lambda: inverse_involute(q))
    yield series("Newton from the right", [own], error, scene.clock, note="the program's own, safe at every angle")


def _by_series(q: Values, terms: int) -> Values:
    root = np.cbrt(3 * q)
    square, total = root * root, np.zeros_like(q)
    for coefficient in reversed(TERMS[:terms]):
        total = total * square + coefficient
    return root * total


def _by_halving(q: Values, halvings: int) -> Values:
    low, high = np.zeros_like(q), np.full_like(q, pi / 2)
    for _ in range(halvings):
        middle = (low + high) / 2
        below = np.tan(middle) - middle < q
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return np.asarray((low + high) / 2)


def _by_fixed_point(q: Values, steps: int) -> Values:
    angle = np.full_like(q, START)
    for _ in range(steps):
        angle = np.arctan(q + angle)
    return angle


def _by_newton(q: Values, steps: int) -> Values:
    angle = np.full_like(q, START)
    for _ in range(steps):
        tangent = np.tan(angle)
        angle = angle - (tangent - angle - q) / tangent**2
    return angle


def _distances(pairs: list[Pair], angle: Values) -> Values:
    """a_w in modules (n,)."""
    return np.array([pair.first.base + pair.second.base for pair in pairs]) / np.cos(angle)


def _ratios(found: list[MeshPair], pairs: list[Pair], angle: Values) -> Values:
    """eps_alpha (n,) with tips that keep the clearance, or those asked for."""
    distance = _distances(pairs, angle)
    tips = []
    for k, pair in enumerate(pairs):
        asked, m = found[k].task.tips, found[k].task.module
        one, two = pair.wheels
        plain = (distance[k] - two.root - one.rack.clearance, distance[k] - one.root - one.rack.clearance)
        tips.append([rule if given is None else given / m for given, rule in zip(asked, plain, strict=True)])
    bases = np.array([[wheel.base for wheel in pair.wheels] for pair in pairs])
    rho = np.sqrt(np.maximum((np.array(tips) - bases) * (np.array(tips) + bases), FLOOR)).sum(axis=1)
    return (rho - distance * np.sin(angle)) / np.array([pair.first.base_pitch for pair in pairs])
