"""Methods for the profile: the exact envelope and curvature, those of a sampled curve, polygons within a tolerance.

A roller's centre is drawn at n positions; its neighbours give the tangent, and three points a circle. Of a flat face
two neighbouring face lines cross near the profile. Positions beside an end of a piece, where y'' may jump, are left
out. The reference is the envelope in extended precision.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.cams.follower import Complex, Follower
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.profile.offsets import Frame, Rim, frame
from tmmcalc.cams.profile.outline import adaptive
from tmmcalc.cams.program import TURN, Program
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Series, Study

COUNTS = (36, 72, 180, 360, 720, 1800, 3600, 12_000, 36_000)  # positions of the turn
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7)  # of the base circle
WITHIN = np.array([0.2, 0.35, 0.5, 0.65, 0.8])  # of a chord: where it is measured

EXTENDED = float(np.finfo(np.longdouble).eps)
Sample = tuple[Values, Indices]  # angles and pieces


def studies(scene: Scene) -> Iterator[Study]:
    """The working profile, its curvature, and the chords that stand for it."""
    if not WIDER:
        return
    rim = Rim(scene.results["cam_synthesis"].follower, scene.inputs.program)
    reference = Reference("the exact envelope in extended precision (64-bit mantissa)", EXTENDED)
    yield Study("cam_profile", "points of the working profile", reference, _points(rim, scene.clock))
    yield Study("cam_profile", "curvature", reference, _bends(rim, scene.clock))
    yield Study("cam_profile", "chords of the working profile", reference, _chords(rim, scene.clock))


def _sample(program: Program, count: int) -> tuple[Sample, Values]:
    """Positions (m,) at equal steps whose neighbours are in the same piece, and the step."""
    step = TURN / count
    phi = step * np.arange(count)
    low, high = (np.searchsorted(program.edges, phi + side * 1.01 * step) - 1 for side in (-1, 1))
    inside = (low == high) & (low >= 0) & (high < len(program.edges) - 1)
    return (phi[inside], low[inside]), np.full(int(inside.sum()), step)


def _exact(rim: Rim, at: Sample) -> Frame:
    phi = wide(at[0])
    return frame(wide(rim.follower), phi, rim.program.wider.at(phi, at[1]))


def _drawn(rim: Rim, count: int) -> Complex:
    """Points (m,) of the working profile from neighbouring positions."""
    (phi, piece), step = _sample(rim.program, count)
    if rim.flat:
        return _crossings(rim, phi, piece, step)
    before, here, after = (rim.at(phi + side * step, piece).points for side in (-1, 0, 1))
    tangent = (after - before) / np.abs(after - before)
    return np.asarray(here + rim.follower.roller * 1j * tangent)


def _crossings(rim: Rim, phi: Values, piece: Indices, step: Values) -> Complex:
    """Where the face lines before and after a position cross: Re(w conj n) = S, n = i e^(i phi)."""
    (n1, s1), (n2, s2) = (_line(rim.follower, rim.program, phi + side * step, piece) for side in (-1, 1))
    return np.asarray(1j * (s2 * n1 - s1 * n2) / (np.conj(n1) * n2).imag)


def _line(follower: Follower, program: Program, phi: Values, piece: Indices) -> tuple[Complex, Values]:
    return 1j * np.exp(1j * phi), np.asarray(follower.start + program.at(phi, piece)[0])


def _points(rim: Rim, clock: Clock) -> tuple[Series, ...]:
    roller = rim.follower.roller

    def error(found: tuple[int, Complex]) -> float:
        count, points = found
        true = _exact(rim, _sample(rim.program, count)[0]).offset(wide(roller))
        return relative(points, true)

    def closed() -> tuple[int, Complex]:
        return COUNTS[3], rim.at(*_sample(rim.program, COUNTS[3])[0]).offset(roller)

    def drawn(count: int) -> tuple[int, Complex]:
        return count, _drawn(rim, count)

    name = "crossing face lines" if rim.flat else "tangents of the sampled pitch curve"
    return (
        series("exact envelope", [Way(f"{COUNTS[3]} positions", 1 / COUNTS[3], closed)], error, clock),
        series(name, [Way(f"{n} positions", 1 / n, partial(drawn, n)) for n in COUNTS], error, clock, expected=2.0),
    )


def _bends(rim: Rim, clock: Clock) -> tuple[Series, ...]:
    """Of the pitch curve, or of the profile under a flat face."""

    def bend(here: Frame) -> Values:
        return 1 / here.speed if rim.flat else here.bend

    def error(found: tuple[int, Values]) -> float:
        return relative(found[1], bend(_exact(rim, _sample(rim.program, found[0])[0])))

    def closed() -> tuple[int, Values]:
        return COUNTS[3], bend(rim.at(*_sample(rim.program, COUNTS[3])[0]))

    def circles(count: int) -> tuple[int, Values]:
        (phi, piece), step = _sample(rim.program, count)
        a, b, c = (rim.at(phi + side * step, piece).points for side in (-1, 0, 1))
        area = (np.conj(b - a) * (c - b)).imag
        return count, 2 * area / (np.abs(b - a) * np.abs(c - b) * np.abs(c - a))

    ways = [Way(f"{n} positions", 1 / n, partial(circles, n)) for n in COUNTS]
    return (
        series("exact curvature", [Way(f"{COUNTS[3]} positions", 1 / COUNTS[3], closed)], error, clock),
        series("circles through three points", ways, error, clock, expected=2.0),
    )


def _chords(rim: Rim, clock: Clock) -> tuple[Series, ...]:
    """How far the polygon is from the curve, in parts of the base circle."""
    base, distance = rim.follower.base, rim.follower.roller

    def equal(count: int) -> Sample:
        edges = rim.program.edges
        phi = np.sort(np.concatenate((TURN / count * np.arange(count), edges)))
        phi = phi[np.concatenate(([True], np.diff(phi) > 1e-9))]
        return phi, np.clip(np.searchsorted(edges, phi, side="right") - 1, 0, len(edges) - 2)

    def sag(at: Sample) -> float:
        phi = at[0]
        middle = (phi[1:] + phi[:-1]) / 2
        piece = np.clip(np.searchsorted(rim.program.edges, middle) - 1, 0, len(rim.program.edges) - 2)
        ends = [_exact(rim, (each, piece)).offset(wide(distance)) for each in (phi[:-1], phi[1:])]
        worst = 0.0
        for part in WITHIN:
            there = _exact(rim, (phi[:-1] + part * (phi[1:] - phi[:-1]), piece)).offset(wide(distance))
            chord = ends[1] - ends[0]
            away = (np.conj(chord) * (there - ends[0])).imag / np.maximum(np.abs(chord), 1e-300)
            worst = max(worst, float(np.max(np.abs(away))))
        return relative(worst, 0.0, base)

    def kept(tolerance: float) -> Sample:
        return adaptive(rim, distance, tolerance * base)

    def count(at: Sample) -> int:
        return len(at[0])

    equally = [Way(f"{n} positions", 1 / n, partial(equal, n), count) for n in COUNTS[:-2]]
    within = [Way(f"tolerance {t:g} R0", t, partial(kept, t), count) for t in TOLERANCES]
    return (
        series("equal steps of phi", equally, sag, clock, expected=2.0),
        series("as many as the tolerance asks for", within, sag, clock, stepwise=False),
    )
