"""Random linkages with random loads for a reduction, and what they are in extended precision."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any, Literal

import numpy as np
from linkage.forces.loadings import random_loading, unit
from linkage.scenes import crank_slider, four_bar, full_turn, part, slotted, trammel, with_input, yoke
from random_mechanisms import build

from tmmcalc import TmmError, solve_kinematics
from tmmcalc.core.plane import Real
from tmmcalc.linkage.lastdigit import in_full
from tmmcalc.linkage.loading import Body, Load, Loading, Pair, Spring, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.law import Law
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.machine.reduction.causes import Causes, causes_of
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.reduction.solve import solve_reduction

TURN = 2 * math.pi
ROUNDS = 30  # of halving panels of the truth
KINKS = 12  # panels that are halved at once
TINY = 1e-17  # of the integral of the magnitude: what a panel may leave
POINTS = 20  # of the rule on a panel of the truth


def drawn(seed: int) -> tuple[Mechanism, Loading]:
    """A scene: dyads of any kind over a part of their range, closed linkages over a turn, rockers near their limits."""
    rng = np.random.default_rng(seed)
    if seed % 4 == 0:
        scene = build(rng, positions=13, span=np.radians(12))
        return scene.mechanism, random_loading(rng, scene.mechanism, 0.1 * (seed // 4 % 2))
    size, mass = 10 ** rng.uniform(-3, 3, 2)
    mechanism = closed(rng, size) if seed % 4 < 3 else rocking(rng, size)
    speed = float(rng.choice([-1, 1]) * 10 ** rng.uniform(-2, 3))
    return with_input(mechanism, speed=speed, acceleration=0.0), loaded(rng, mechanism, size, mass, speed)


def closed(rng: np.random.Generator, size: float, nearest: float = -3, kinds: int = 5) -> Mechanism:
    """A linkage whose crank turns fully, most of them near to the length at which it would not (of 5 kinds but one)."""
    gap = 10 ** rng.uniform(nearest, 0)
    kind = rng.integers(kinds)
    a = float(size * rng.uniform(0.2, 1))
    if kind == 0:
        e = rng.uniform(-0.5, 0.5) * size
        found = crank_slider(a, (a + abs(e)) * (1 + gap), e, int(rng.choice([-1, 1])))
    elif kind == 1:
        shortest, longest = a, a * rng.uniform(2, 4)
        other = rng.uniform(1.2, 1.9) * a
        rest = longest + a - other
        lengths = (other, rest * (1 + 0.2 * gap)) if rng.random() < 0.5 else (rest * (1 + 0.2 * gap), other)
        frame = longest * np.exp(1j * rng.uniform(-np.pi, np.pi))
        found = four_bar(shortest, *lengths, frame, int(rng.choice([-1, 1])))
    elif kind == 2:
        found = slotted(a, a * (1 + gap) if rng.random() < 0.5 else a * (1 - gap / 2))
    elif kind == 3:
        found = yoke(a, rng.uniform(0.2, 2.9))
    else:
        found = trammel(a, rng.uniform(-0.3, 0.3))
        return part(found, -0.9, 0.9, 12)
    return full_turn(found, rng.uniform(-3, 3), 12)


def rocking(rng: np.random.Generator, size: float) -> Mechanism:
    """A crank that cannot turn fully, over a range that ends near its limit position."""
    a, ratio = float(size * rng.uniform(0.5, 2)), rng.uniform(0.3, 0.95)
    limit = math.asin(ratio)
    left = limit * 10 ** rng.uniform(-4, -0.5)
    return part(crank_slider(a, ratio * a), -limit * rng.uniform(0.1, 0.8), limit - left, 12)


def loaded(rng: np.random.Generator, mechanism: Mechanism, size: float, mass: float, speed: float) -> Loading:
    """Masses, weights, springs, friction in half of them, and one to four loads of which some cancel others."""
    links = [link.id for link in mechanism.links]
    heavy = [k for k in links if rng.random() < 0.8]

    def place() -> complex:
        return complex(size * rng.uniform(-1, 1), size * rng.uniform(-1, 1)) * float(rng.choice([0.0, 0.5]))

    bodies = tuple(
        Body(k, mass * rng.uniform(0.1, 3), mass * size**2 * rng.uniform(0, 0.5) * rng.integers(2), place())
        for k in heavy
    )
    force = float(mass * 10 ** rng.uniform(-1, 3))
    loads = [_load(rng, f"Q{i}", links, place(), force, size, speed) for i in range(rng.integers(1, 4))]
    if rng.random() < 0.3:
        loads.append(replace(loads[0], name="against", factor=-loads[0].factor * (1 + 10 ** rng.uniform(-9, -1))))
    gravity = complex(9.81 * unit(rng)) if rng.random() < 0.7 else 0j
    pairs = _pairs(rng, mechanism, size) if rng.random() < 0.5 else ()
    return Loading(bodies, gravity, tuple(loads), _springs(rng, links, size, force), pairs)


def _load(
    rng: np.random.Generator, name: str, links: list[int], at: complex, force: float, size: float, speed: float
) -> Load:
    kind: Literal["force", "moment"] = "force" if rng.random() < 0.7 else "moment"
    unit_speed = abs(speed) * (size if kind == "force" else 1)
    value = force * (1 if kind == "force" else size)
    edges = np.sort(rng.uniform(0.1, 6, 4))
    laws: list[Law] = [
        Constant(value),
        Polynomial(tuple(value * rng.normal(size=3))),
        Viscous(value / unit_speed),
        Quadratic(value / unit_speed**2),
        Tabulated("angle", tuple(edges), tuple(value * rng.normal(size=4)), period=None),
        Tabulated("stroke", (0.0, 0.3, 0.35, 1.0), tuple(value * rng.normal(size=4))),
    ]
    law = laws[rng.integers(6)]
    window = None
    if isinstance(law, Constant | Polynomial) and rng.random() < 0.6:
        low, high = np.sort(rng.uniform(0, 6, 2))
        window = Window(stroke="working") if rng.random() < 0.3 else Window(angles=(float(low), float(high)))
    direction = complex(rng.choice([1, 1j])) if rng.random() < 0.5 else unit(rng)
    link = int(rng.choice(links[-2:]))
    return Load(name, link, kind, law, at, direction, 0, window, float(rng.uniform(0.3, 2)))


def _springs(rng: np.random.Generator, links: list[int], size: float, force: float) -> tuple[Spring, ...]:
    if rng.random() < 0.6:
        return ()
    far = complex(size * 4 * unit(rng))
    return (Spring("s", "linear", (links[-1], 0), (0j, far), force / size, size, force / size * rng.integers(2)),)


def _pairs(rng: np.random.Generator, mechanism: Mechanism, size: float) -> tuple[Pair, ...]:
    f = 10 ** rng.uniform(-2, -0.7)
    return tuple(
        Pair(j.name, f, size * 0.02)
        if j.kind == "revolute"
        else Pair(j.name, f, length=(None, 0.3 * size)[rng.integers(2)])
        for j in mechanism.joints
    )


@cache
def solved(seed: int) -> tuple[Reduction, Causes] | None:
    """A drawn scene as the program reduces it, and its causes in extended precision; None if it refuses."""
    mechanism, loading = drawn(seed)
    try:
        kinematics = solve_kinematics(mechanism)
        causes = causes_of(compile_scene(mechanism, loading, kinematics))
        return solve_reduction(mechanism, loading, kinematics), causes.on(in_full(causes.scene.chain))
    except TmmError:
        return None


def integrals(f: Callable[[Real], Real], edges: Real) -> tuple[Real, Real]:
    """Integrals of functions ``f(x) -> (F, n)`` over a range cut at ``edges``, in extended precision, and of |f|.

    Panels are halved where both halves together do not tell what the whole does, the worst of them first; more of them
    than kinks are noise.
    """
    ends = edges.astype(np.longdouble)
    low, high = ends[:-1], ends[1:]
    whole, sizes = _on_panels(f, low, high)
    total, size, top = 0 * sizes.sum(axis=1), 0 * sizes.sum(axis=1), sizes.sum(axis=1)
    for _ in range(ROUNDS):
        middle = (low + high) / 2
        found, sizes = _on_panels(f, np.concatenate((low, middle)), np.concatenate((middle, high)))
        halves, parts = found.reshape(len(top), 2, -1), sizes.reshape(len(top), 2, -1)
        gap = np.max(np.abs(halves.sum(axis=1) - whole) / np.where(top > 0, top, 1)[:, None], axis=0)
        rough = gap > max(TINY, float(np.sort(gap)[-KINKS - 1]) if len(gap) > KINKS else 0.0)
        total, size = total + halves[:, :, ~rough].sum(axis=(1, 2)), size + parts[:, :, ~rough].sum(axis=(1, 2))
        if not rough.any():
            break
        whole = halves[:, :, rough].reshape(len(top), -1)
        low, high = np.concatenate((low[rough], middle[rough])), np.concatenate((middle[rough], high[rough]))
    else:
        total, size = total + whole.sum(axis=1), size + np.abs(whole).sum(axis=1)
    return total, size


def _on_panels(f: Callable[[Real], Real], low: Real, high: Real) -> tuple[Real, Real]:
    """Integrals (F, K) of functions and of their magnitudes on panels (K,)."""
    x, w = wide_rule()
    values = f((low[:, None] + (high - low)[:, None] * x).ravel()).reshape(-1, len(low), POINTS)
    return values @ w * (high - low), np.abs(values) @ w * (high - low)


@cache
def wide_rule() -> tuple[Real, Real]:
    """Nodes and weights of Gauss and Legendre on [0, 1] in extended precision."""
    import mpmath as mp

    with mp.workdps(40):
        roots = [mp.findroot(lambda t: mp.legendre(POINTS, t), t) for t in np.polynomial.legendre.leggauss(POINTS)[0]]
        slope = [POINTS * (mp.legendre(POINTS - 1, t) - t * mp.legendre(POINTS, t)) / (1 - t * t) for t in roots]
        weights = [1 / ((1 - t * t) * d * d) for t, d in zip(roots, slope, strict=True)]
        text = [[mp.nstr(v, 30) for v in row] for row in ([(1 + t) / 2 for t in roots], weights)]
    points, heavy = (np.array([np.longdouble(v) for v in row]) for row in text)
    return points, heavy


def wide(causes: Causes, theta: Real, side: Real | None = None) -> Any:
    """Everything at theta (n,) in extended precision."""
    return causes.sampled(theta.astype(np.longdouble), np.ones(len(theta)) if side is None else side, lambda _: [])
