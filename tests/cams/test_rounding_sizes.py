"""Estimates of sizes found by synthesis and optimum, and of indexing drives, against 50 digits or denser nodes."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import radians
from types import SimpleNamespace

import numpy as np
import pytest
from mpmath import mp, mpf

from tests.cams.exact import SCENES, judge, law_at, missed, motion_at, random_program
from tests.cams.optimum_scene import flat_task, roller_task
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.indexing import solve_indexing
from tmmcalc.cams.indexing.laws import step_law
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.optimum import flat
from tmmcalc.cams.optimum.checks import choice_of
from tmmcalc.cams.optimum.errors import optimum_errors
from tmmcalc.cams.optimum.scene import scene_of
from tmmcalc.cams.pressure import reached
from tmmcalc.cams.synthesis import oscillating, roller
from tmmcalc.cams.synthesis.errors import size_errors
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.synthesis.translating import lines_of, nearest
from tmmcalc.cams.task import AngleLimits, Asked, CamTask
from tmmcalc.errors import NoSolutionError

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
        found = oscillating.find(task)
        sizes = {"centres": found.centres, "rocker": found.rocker, "roller": task.asked.roller}
        follower = Follower("oscillating", found.start, **sizes)
    rise, back = reached(task, follower)
    error = size_errors(task, follower, (rise, back), roller.choose(task, follower), None)
    return SimpleNamespace(follower=follower, rise=rise, back=back, error=error)


@pytest.mark.slow
@pytest.mark.parametrize("kind", FREE)
def test_estimates_of_the_sizes(kind):
    random, pairs = np.random.default_rng(21), {"sizes": []}
    while len(pairs["sizes"]) < SCENES:
        stroke = random.uniform(0.1, 0.5) if kind == "oscillating" else 10 ** random.uniform(-2.5, -1.7)
        limits = AngleLimits(*np.radians(random.uniform(25, 45, 2)).tolist())
        asked = Asked(kind, roller=None if kind == "flat" else 1e-3, **FREE[kind])
        task = CamTask(random_program(random, stroke, own=False), asked, limits, 12)
        try:
            found = bare(task)
        except NoSolutionError:
            continue
        pairs["sizes"].append((found.error["sizes"], sizes_missed(task, found)))
    judge(pairs)


@pytest.mark.parametrize("kind", FREE)
def test_the_synthesis_carries_the_estimate(kind):
    random = np.random.default_rng(31)
    task = CamTask(random_program(random, 0.3 if kind == "oscillating" else 0.01, own=False),
                   Asked(kind, **FREE[kind]), AngleLimits(0.5, 0.6), 12)  # fmt: skip
    error = solve_synthesis(task).error
    assert error["sizes"] < 1e-12
    assert error["radii"] < 1e-10


@pytest.mark.slow
def test_estimates_of_a_flat_optimum():
    """The least height by convexity and the length of the guide (fig. 5.37), on nodes eight times as dense."""
    random, pairs = np.random.default_rng(22), {"height": []}
    while len(pairs["height"]) < SCENES:
        task = flat_task()
        task = replace(task, program=random_program(random, 10 ** random.uniform(-2.5, -2.0), own=False))
        follower = Follower("flat", 0.1)
        try:
            scene = scene_of(task, follower)
        except NoSolutionError:
            continue
        least = flat.choice_of(scene, *flat.lowest(scene))
        exact = flat.chart(scene_of(task, follower, "turn", 8)).least_height
        if abs(least.height - exact) < 1e-9:
            error = optimum_errors(task, follower, "turn", scene, least, least)
            pairs["height"].append((error["height"], abs(least.height - exact) / exact))
    judge(pairs)


@pytest.mark.slow
def test_estimates_of_the_optimum_of_a_roller():
    random, pairs = np.random.default_rng(23), {"margins": []}
    while len(pairs["margins"]) < SCENES:
        task = replace(roller_task(), program=random_program(random, 10 ** random.uniform(-2.3, -1.7), own=False))
        follower = Follower("translating", 0.06)
        try:
            scene = scene_of(task, follower)
        except NoSolutionError:
            continue
        choice = choice_of(scene, random.uniform(0.04, 0.1), random.uniform(0.005, 0.02), random.uniform(0.15, 0.25))
        error = optimum_errors(task, follower, "turn", scene, choice, choice)
        finest = choice_of(scene_of(task, follower, "turn", 5), choice.start, choice.roller, choice.height)
        pairs["margins"].append(
            (error["margins"], max(abs(a.margin - b.margin) for a, b in both_judged(choice, finest)))
        )
    judge(pairs)


def both_judged(choice, other):
    return [(a, b) for a, b in zip(choice.checks, other.checks, strict=True) if a.number > 1 and a.margin > -1]


@pytest.mark.slow
def test_estimates_of_an_indexing_drive():
    random, pairs = np.random.default_rng(24), {"points": [], "ends": []}
    names = ("sine", "cosine", "linear", "shun", "modified_trapezoid", "modified_sine", "poly4567")
    while len(pairs["points"]) < SCENES:
        law = step_law(names[random.integers(len(names))])
        task = IndexingTask(law, 6, radians(random.uniform(85, 120)), 10 ** random.uniform(-2, -0.7), None, None)
        task = replace(task, rollers=int(random.choice([6, 8, 10])), rows=20)
        try:
            found = solve_indexing(task)
        except NoSolutionError:
            continue
        if found.cam is None:
            continue
        wheel, half = mpf(found.wheel), mp.pi / found.rollers
        centres = mpf(found.ratio * found.wheel)

        def roller_at(k, side, law=law.law, half=half, centres=centres, wheel=wheel):
            s = law_at(law, k, int(law.piece(np.array([float(k)]))[0]))[0]
            return centres - wheel * mp.expj(-(side * half + 2 * half * s))

        step, worst = mpf(task.step), 0.0
        for side, table in ((1, found.cam.a), (-1, found.cam.b)):
            exact = [roller_at(mpf(float(k)), side) * mp.expj(-step * mpf(float(k))) for k in found.k]
            worst = max(worst, missed(table.pitch, exact))
        pairs["points"].append((found.error["points"], worst))
        part = mp.findroot(
            lambda k, r=roller_at, step=step: mp.arg(r(k, 1)) - step * (k - mpf(1) / 2), mpf(found.cam.handover.part)
        )
        pairs["ends"].append((found.error["ends"], float(abs(part - mpf(found.cam.handover.part)))))
    judge(pairs)
