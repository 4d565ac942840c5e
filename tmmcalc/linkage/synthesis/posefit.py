"""Linkages that pass near more points or poses than can be met: the least squares of all distances and angles.

Starts come from the equations of exact synthesis, solved in the least squares from many random places at once; the best
of them are fitted with the crank's angles free, or tied to the first by the prescribed timing.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.linkage.plane import Plane, Real
from tmmcalc.linkage.synthesis.batch import levenberg
from tmmcalc.linkage.synthesis.pathequations import Path, residuals, starts, turns, unpacked
from tmmcalc.linkage.synthesis.planar import Bars, bars_of
from tmmcalc.linkage.synthesis.posed import body_drift, pinned, ranked
from tmmcalc.linkage.synthesis.rating import Rating, variants
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask
from tmmcalc.progress import tell

SOME = 6  # points that the starts for many points meet exactly
CURVE = 180  # places of the crank at which their curves are compared
TURN = 2 * np.pi
RANDOM = 600  # random starts
FITS = 12  # fits of the points themselves, from the best of them
LARGE = 12.0  # sizes against the points' spread beyond which a start is left out
BEYOND = 1.0  # weight of the gap of links that do not reach


def fitted(task: SynthesisTask) -> list[tuple[Bars, Rating]]:
    """Fits of a task, ranked."""
    asked: PoseTask = task.asked
    middle, unit = complex(asked.points.mean()), float(np.max(np.abs(asked.points - asked.points.mean()))) or 1.0
    path = Path((asked.points - middle) / unit, asked.timing, asked.mechanism == "slider_crank")
    rng = np.random.default_rng(task.seed)
    bars, b, c = _starts(path, asked, rng)
    results = []
    for done in range(min(FITS, len(b))):
        tell((done + 1) / (FITS + 1), f"fit {done + 1} of {FITS}")
        results.append(_fit(path, asked, bars.rows(np.array([done])), b[done], c[done]))
    found: list[tuple[Bars, Rating]] = []
    for one, phi in results:
        placed = one.at(phi[None, :])
        scaled, pins, ends = _enlarged(one, placed.b, placed.c, unit, middle)
        found += ranked(task, scaled, pins, ends, keep=1)
    return found


def _starts(path: Path, asked: PoseTask, rng: np.random.Generator) -> tuple[Bars, Plane, Plane]:
    """Linkages near the points, by the algebraic residual; every dyad of a four-bar is tried as the crank."""
    if asked.angles is None and path.timing is None and len(path.points) > path.most:
        return _through_some(path, rng)
    if asked.angles is None:
        x, _ = levenberg(lambda x: residuals(path, x), starts(path, RANDOM, rng), 60, LARGE)
        x = x[: 4 * FITS]
        turn = turns(path, x)
        c1, z1, z2, last = (part[:, 0] for part in unpacked(path, x))
    else:
        turn, c1, z1, z2, last = _dyads(path, asked.angles, rng)
    sound = np.all(np.isfinite(turn), axis=1)
    turn, c1, z1, z2, last = turn[sound], c1[sound], z1[sound], z2[sound], last[sound]
    if path.slides:
        bars, b, c = pinned(path.points, turn, z1, c1, z2, None)
        way = -1j * last
        middle = c.mean(axis=1)
        return bars._replace(guide=way[:, None], end=middle[:, None]), b, c
    first = pinned(path.points, turn, z1, c1, z2, last)
    if path.timing is not None:
        return first
    second = pinned(path.points, turn, z2, last, z1, c1)
    order = np.arange(2 * len(z1)).reshape(2, -1).T.ravel()
    parts = [np.concatenate(pair)[order] for pair in zip(first[0][:-1], second[0][:-1], strict=True)]
    bars = bars_of(parts, False)
    return bars, np.concatenate((first[1], second[1]))[order], np.concatenate((first[2], second[2]))[order]


def _through_some(path: Path, rng: np.random.Generator) -> tuple[Bars, Plane, Plane]:
    """Linkages that meet some of the points exactly and whose whole curves come nearest to all of them."""
    n = len(path.points)
    few = Path(path.points[np.rint(np.linspace(0, n - 1, SOME)).astype(int)], None, path.slides)
    x, worst = levenberg(lambda x: residuals(few, x), starts(few, 2 * RANDOM, rng), large=LARGE)
    x = x[worst < 1e-6]
    c1, z1, z2, last = (part[:, 0] for part in unpacked(few, x))
    turn = turns(few, x)
    ways = [(z1, c1, z2, None if path.slides else last)]
    if not path.slides:
        ways.append((z2, last, z1, c1))
    found = []
    for way in ways:
        bars, b, c = pinned(few.points, turn, *way)
        sound = np.all(np.isfinite(b) & np.isfinite(c), axis=1)
        bars, b, c = bars.rows(sound), b[sound], c[sound]
        bars = bars._replace(sign=np.where(np.sum(variants(bars, b, c), axis=1, keepdims=True) < 0, -1.0, 1.0))
        curve = bars.at(TURN * np.arange(CURVE)[None, :] / CURVE)
        gap = np.where((curve.margin > 0)[:, :, None], np.abs(curve.point[:, :, None] - path.points), np.inf)
        nearest = np.argmin(gap, axis=1)
        error = np.sqrt(np.mean(np.min(gap, axis=1) ** 2, axis=1))
        for k in np.argsort(error)[:FITS]:
            found.append((float(error[k]), bars.rows(np.array([k])), curve.b[k, nearest[k]], curve.c[k, nearest[k]]))
    found.sort(key=lambda each: each[0])
    chosen = [each for each in found if np.isfinite(each[0])][:FITS]
    if not chosen:
        return bars.rows(np.zeros(0, int)), np.zeros((0, n), complex), np.zeros((0, n), complex)
    parts = [np.concatenate(part) for part in zip(*(each[1][:-1] for each in chosen), strict=True)]
    bars = bars_of(parts, path.slides)
    return bars, np.array([each[2] for each in chosen]), np.array([each[3] for each in chosen])


def _dyads(path: Path, angles: Real, rng: np.random.Generator) -> tuple[Plane, Plane, Plane, Plane, Plane]:
    """Pins whose places come nearest to circles (and a line), paired: for poses the two are independent."""
    turn = np.exp(1j * (angles - angles[0]))[None, :]

    def circle(x: Real) -> Real:
        places = path.points + turn * (x[:, [0]] + 1j * x[:, [1]]) - (x[:, [2]] + 1j * x[:, [3]])
        radius = np.abs(places)
        return radius - radius.mean(axis=1, keepdims=True)

    def line(x: Real) -> Real:
        places = (path.points + turn * (x[:, [0]] + 1j * x[:, [1]])) * np.exp(-1j * x[:, [2]])
        return np.asarray(places.imag - places.imag.mean(axis=1, keepdims=True))

    x, _ = levenberg(circle, 2 * rng.normal(size=(300, 4)), 60)
    kept = _different(x, 5)
    z, c = kept[:, 0] + 1j * kept[:, 1], kept[:, 2] + 1j * kept[:, 3]
    if path.slides:
        y, _ = levenberg(line, 2 * rng.normal(size=(200, 3)), 60)
        lines = _different(y, 4)
        i, j = (rows.ravel() for rows in np.meshgrid(np.arange(len(z)), np.arange(len(lines)), indexing="ij"))
        end = 1j * np.exp(1j * lines[j, 2])
        return np.repeat(turn, len(i), 0), c[i], z[i], lines[j, 0] + 1j * lines[j, 1], end
    pairs = [(i, j) for i in range(len(z)) for j in range(len(z)) if i != j]
    i, j = (np.array(rows) for rows in zip(*pairs, strict=True)) if pairs else (np.zeros(0, int), np.zeros(0, int))
    return np.repeat(turn, len(i), 0), c[i], z[i], z[j], c[j]


def _different(x: Real, count: int) -> Real:
    """The first ``count`` rows that differ."""
    kept: list[Real] = []
    for row in x:
        if np.all(np.isfinite(row)) and all(np.max(np.abs(row[:2] - other[:2])) > 1e-2 for other in kept):
            kept.append(row)
        if len(kept) == count:
            break
    return np.array(kept)


def _fit(path: Path, asked: PoseTask, bars: Bars, b: Plane, c: Plane) -> tuple[Bars, Real]:
    """One linkage fitted to the points, and the crank's angles (n,) at them."""
    from scipy.optimize import least_squares

    sign = float(np.sign(np.sum(variants(bars, b[None, :], c[None, :])))) or 1.0
    phi = np.unwrap(np.angle(b - bars.pivot[0, 0]))
    n = len(path.points)
    values = [bars.pivot, bars.end, bars.point]
    sizes = [float(part) for value in values for part in (value[0, 0].real, value[0, 0].imag)]
    sizes += [float(bars.crank[0, 0]), float(bars.coupler[0, 0])]
    sizes.append(float(np.angle(bars.guide[0, 0])) if path.slides else float(bars.rocker[0, 0]))
    free = phi[:1] if path.timing is not None else phi

    def linkage(x: Real) -> tuple[Bars, Real]:
        a, d, p = (np.array([[complex(x[2 * i], x[2 * i + 1])]]) for i in range(3))
        crank, coupler, last = abs(x[6]), abs(x[7]), x[8]
        rocker, guide = (1.0, np.exp(1j * last)) if path.slides else (abs(last), 1 + 0j)
        parts = (a, [[crank]], [[coupler]], d, [[rocker]], [[guide]], p, [[sign]])
        at = x[9:] if path.timing is None else x[9] + path.timing
        return bars_of(parts, path.slides), at

    def residual(x: Real) -> Real:
        one, at = linkage(x)
        placed = one.at(at[None, :])
        off = placed.point[0] - path.points
        gap = BEYOND * np.minimum(placed.margin[0], 0)
        if asked.angles is None:
            return np.concatenate((off.real, off.imag, gap))
        drift = np.angle(placed.turn[0] * np.exp(-1j * (asked.angles - asked.angles[0])) / placed.turn[0, 0])
        return np.concatenate((off.real, off.imag, gap, drift - body_drift(drift)))

    start = np.concatenate((sizes, free))
    solved = least_squares(residual, start, xtol=1e-14, ftol=1e-14, gtol=1e-14, max_nfev=60 * (1 + n // 10))
    return linkage(solved.x)


def _enlarged(bars: Bars, b: Plane, c: Plane, unit: float, middle: complex) -> tuple[Bars, Plane, Plane]:
    """Back from units of the points' spread to metres."""
    scaled = bars._replace(
        pivot=bars.pivot * unit + middle,
        crank=bars.crank * unit,
        coupler=bars.coupler * unit,
        end=bars.end * unit + middle,
        rocker=bars.rocker * unit,
        point=bars.point * unit,
    )
    return scaled, b * unit + middle, c * unit + middle
