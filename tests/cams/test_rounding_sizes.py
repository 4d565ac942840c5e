"""Estimates of the sizes found by synthesis, of their angles and radii, against 50 digits."""

from __future__ import annotations

from functools import partial
from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest
from mpmath import mp, mpf

from cams.exact import motion_at, random_program
from cams.exact_peaks import extremes
from cams.exact_rims import bend_of
from cams.scenes import briefly, judged
from cams.test_rounding_pressure import of_theta
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pressure.angle import reached
from tmmcalc.cams.synthesis import oscillatingsizes, roller
from tmmcalc.cams.synthesis.errors import size_errors
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.synthesis.translatingsizes import lines_of, nearest
from tmmcalc.cams.task import AngleLimits, Asked, CamTask

FEW = 1
FREE = {"translating": {"offset": None}, "flat": {}, "oscillating": {"rocker": 0.1}}


def extreme_at(f, slope, phi, low, high):
    """The extreme value of f near phi in 50 digits by Newton on its derivative, or its end; f, slope of an mpf."""
    x = mpf(phi)
    if min(abs(x - low), abs(x - high)) < mpf(10) ** -9:
        return f(low if abs(x - low) < abs(x - high) else high)
    h = mpf(10) ** -18
    for _ in range(5):
        bend = (slope(x + h) - slope(x - h)) / (2 * h)
        x -= slope(x) / bend if bend else 0
    return f(x)


def pieces_beside(program, phi):
    edges = program.edges
    found = {int(np.clip(np.searchsorted(edges, phi + s) - 1, 0, len(edges) - 2)) for s in (-1e-9, 1e-9)}
    return sorted(found)


def largest(program, phi, value):
    """The largest in 50 digits of ``value(motion) -> (f, f')`` on the pieces at an angle."""
    found = []
    for piece in pieces_beside(program, phi):
        low, high = map(mpf, program.edges[piece : piece + 2].tolist())

        def at(x, piece=piece):
            return motion_at(program, x, piece)

        found.append(extreme_at(lambda x: value(at(x))[0], lambda x: value(at(x))[1], phi, low, high))
    return max(found)


def stem_at(task, found):
    """e and S0 in 50 digits: of the corners and feet of the lines of the limits the one that is found."""
    lines = []
    for line in lines_of(task):
        kind = 0 if line.phi < task.program.starts[2] - 1e-6 and line.phi <= task.program.starts[1] + 1e-6 else 2
        limit = mpf(task.limits.rise if kind == 0 else task.limits.back)
        t = mp.tan(limit)
        height = largest(
            task.program, line.phi, lambda m, t=t, side=line.side: (side * m[1] / t - m[0], side * m[2] / t - m[1])
        )
        lines.append((line.side / t, height))
    points = [(-g * h / (1 + g * g), h / (1 + g * g)) for g, h in lines]
    for (g, h), (g2, h2) in combinations(lines, 2):
        if abs(g - g2) > mpf(10) ** -30:
            e = (h2 - h) / (g - g2)
            points.append((e, g * e + h))
    return min(points, key=lambda p: abs(p[0] - found.offset) + abs(p[1] - found.start))


def rocker_at(task, found):
    """The axis o, the rocker being the unit, in 50 digits: on the border at the angles that hold it."""
    program, held = task.program, []
    for on in (found.rise, found.back):
        for each in (on.least, on.largest):
            if abs(abs(each.value) - on.limit) < 1e-9:
                held.append((each.phi, 1 if each.value > 0 else -1, mpf(on.limit)))
    pieces = [pieces_beside(program, phi) for phi, *_ in held]
    inner = [len(each) == 1 for each in pieces]

    def line(k, phi):
        _, side, limit = held[k]
        y, y1, y2, _ = motion_at(program, phi, pieces[k][0])
        n = mp.expj(y + (mp.pi - limit if side > 0 else limit))
        c, rate = -side * (1 - y1) * mp.cos(limit), side * y2 * mp.cos(limit)
        return n, c, y1, rate

    def rest(x, y, *at):
        o, at = mp.mpc(x, y), list(at)
        rows = []
        for k in range(len(held)):
            n, c, y1, rate = line(k, at.pop(0) if inner[k] else mpf(held[k][0]))
            rows.append((o * mp.conj(n)).real - c)
            if inner[k]:
                rows.append((o * mp.conj(mp.mpc(0, 1) * y1 * n)).real - rate)
        if len(held) == 1:
            rows.append(((o - 1) * mp.conj(n)).imag)
        return rows

    o = found.follower.centres / found.follower.rocker * np.exp(-1j * found.follower.start)
    first = [
        mpf(float(o.real)),
        mpf(float(o.imag)),
        *(mpf(float(phi)) for (phi, *_), free in zip(held, inner, strict=True) if free),
    ]
    x, h = mp.matrix(first), mpf(10) ** -20
    for _ in range(4):
        value = mp.matrix(rest(*x))
        slope = mp.matrix(len(x), len(x))
        for k in range(len(x)):
            moved = x.copy()
            moved[k] += h
            column = mp.matrix(rest(*moved))
            for i in range(len(x)):
                slope[i, k] = (column[i] - value[i]) / h
        x -= mp.lu_solve(slope, value)
    return mp.mpc(x[0], x[1])


def sizes_missed(task, found):
    follower = found.follower
    if task.asked.kind == "translating":
        e, start = stem_at(task, follower)
        base = mp.hypot(e, start)
        return float(max(abs(follower.offset - e), abs(follower.start - start)) / base)
    if task.asked.kind == "flat":
        least = largest(task.program, found.convexity.least.phi, lambda m: (-m[0] - m[2], -m[1] - m[3]))
        start = mpf(task.limits.convex) + least
        return float(abs(follower.start - start) / start)
    o, l2 = rocker_at(task, found), mpf(follower.rocker)
    base = l2 * abs(o - 1)
    return float(max(abs(follower.centres - l2 * abs(o)) / base, abs(follower.start + mp.arg(o))))


def bare(task):
    """The follower that the limits alone ask for, its angles and estimates: the synthesis without all else it tells."""
    if task.asked.kind == "flat":
        return solve_synthesis(task)
    if task.asked.kind == "translating":
        e, start = nearest(lines_of(task))
        follower = Follower("translating", start, e, task.asked.roller)
    else:
        found = oscillatingsizes.least_triangle(task)
        sizes = {"centres": found.centres, "rocker": found.rocker, "roller": task.asked.roller}
        follower = Follower("oscillating", found.start, **sizes)
    rise, back = reached(task, follower)
    choice = roller.choose(task, follower)
    error = size_errors(task, follower, (rise, back), choice, None)
    return SimpleNamespace(follower=follower, rise=rise, back=back, choice=choice, error=error)


def the_sizes(random, kind):
    """The sizes, and the angles and radii that the follower reaches as it is found."""
    stroke = random.uniform(0.1, 0.5) if kind == "oscillating" else 10 ** random.uniform(-2.5, -1.7)
    limits = AngleLimits(*np.radians(random.uniform(25, 45, 2)).tolist())
    asked = Asked(kind, roller=None if kind == "flat" else 1e-3, **FREE[kind])
    task = CamTask(random_program(random, stroke, own=False), asked, limits, 12)
    found = bare(task)
    pairs = {"sizes": sizes_missed(task, found), "radii": float(max(_radii(task, found)))}
    if kind != "flat":
        pairs["angles"] = float(_angles(task, found))
    return {name: (found.error[name], true) for name, true in pairs.items()}


def _radii(task, found):
    """Each relative to itself; the follower as it is found."""
    (low, _), (high, _) = extremes(task.program, bend_of(found.follower))
    if found.follower.kind == "flat":
        yield abs(found.convexity.radius / low - 1)
        return
    yield abs(found.choice.convex.value * high - 1)
    if found.choice.concave is not None:
        yield abs(found.choice.concave.value * low + 1)


def _angles(task, found):
    """Of all extremes of the pressure angle, over the largest."""
    theta = of_theta(found.follower)
    both = [(on, extremes(task.program, theta, {kind})) for on, kind in ((found.rise, "rise"), (found.back, "return"))]
    size = max(abs(value) for _, ends in both for value, _ in ends)
    missed = [abs(each.value - value) for on, ends in both
              for each, (value, _) in zip((on.least, on.largest), ends, strict=True)]  # fmt: skip
    return max(missed) / size


@pytest.mark.parametrize("kind", FREE)
def test_estimates_in_a_few_scenes(kind):
    briefly(partial(the_sizes, kind=kind), 21, FEW)


@pytest.mark.slow
@pytest.mark.parametrize("kind", FREE)
def test_estimates(kind):
    judged(partial(the_sizes, kind=kind), 121)


@pytest.mark.parametrize("kind", FREE)
def test_the_synthesis_carries_the_estimate(kind):
    random = np.random.default_rng(31)
    task = CamTask(random_program(random, 0.3 if kind == "oscillating" else 0.01, own=False),
                   Asked(kind, **FREE[kind]), AngleLimits(0.5, 0.6), 12)  # fmt: skip
    error = solve_synthesis(task).error
    assert error["sizes"] < 1e-12
    assert error["radii"] < 1e-10
