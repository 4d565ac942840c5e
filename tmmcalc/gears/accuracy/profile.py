"""Methods of drawing a tooth: the fillet as what positions of the rolling rack leave, curves by chords and by cubics.

Between two positions of the rack a crest of metal remains, as high as the square of the step; a chord misses its curve
by as much, a cubic with the right tangents by the fourth power. Errors are distances from the exact curve over the tip
radius; the exact fillet has a closed form, that of an ellipse on a rolling line.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import pi

import numpy as np

from tmmcalc.core.numerics.curves import Curve
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.plane import Plane
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study
from tmmcalc.gears.involute.profile.flank import Flank
from tmmcalc.gears.meshing.members import members
from tmmcalc.gears.model import Values

POSITIONS = (5, 9, 17, 33, 65, 129, 257, 513)  # of the rack
PIECES = (4, 8, 16, 32, 64, 128, 256)  # of a curve
LOOKED = 193  # places of the fillet where the crests are measured
WITHIN = np.linspace(0.0, 1.0, 9)[1:-1]  # parts of a piece where it is compared with its curve
ROUNDING = 4 * EPS  # of the closed forms


def studies(scene: Scene) -> Iterator[Study]:
    """Fillet and flank of the first external wheel."""
    external = [each for each in members(scene.results["pair"]) if each.shape == "external"]
    if not external:
        return
    member = external[0]
    flank = member.flank
    involute, fillet = flank.curves
    reference = Reference("closed forms of fillet and involute", ROUNDING)

    def error(missed: float) -> float:
        return relative(missed, 0.0, flank.tip)

    ways = [Way(f"{n} positions", 1 / (n - 1), partial(_crests, flank, n)) for n in POSITIONS]
    drawn = [("chords", _chord, 2.0), ("cubics", _cubic, 4.0)]
    yield Study(
        "profile",
        f"fillet of wheel {member.label}",
        reference,
        (
            series("positions of the rack", ways, error, scene.clock, expected=2.0),
            *(series(name, _pieces(fillet, way), error, scene.clock, expected=order) for name, way, order in drawn),
        ),
    )
    yield Study(
        "profile",
        f"involute of wheel {member.label}",
        reference,
        tuple(series(name, _pieces(involute, way), error, scene.clock, expected=order) for name, way, order in drawn),
    )


def _crests(flank: Flank, count: int) -> float:
    """Height of the highest crest that equal steps of the rack's roll leave of the fillet [module]."""
    tool, psi = flank.rounding, float(flank.wheel.half_angle)
    ends = float(tool.roll(flank.slope)), float(tool.roll(pi / 2))
    roll = np.linspace(*ends, count)[:, None]
    places = flank.on_fillet(np.linspace(flank.slope, pi / 2, LOOKED)) * np.exp(-1j * psi)
    in_rack = places * np.exp(1j * roll) - 1j * tool.reference + tool.reference * roll  # (positions, places)
    across, along = (in_rack.real - tool.x) / tool.width, (in_rack.imag - tool.y) / tool.height
    level = np.hypot(across, along)
    slope = np.hypot(across / tool.width, along / tool.height) / level
    return float(np.max(np.min(np.abs(level - 1) / slope, axis=0)))


def _pieces(curve: Curve, missed: Callable[[Curve, Values, Values], Values]) -> list[Way]:
    return [Way(f"{n} pieces", 1 / n, partial(_drawn, curve, missed, n)) for n in PIECES]


def _drawn(curve: Curve, missed: Callable[[Curve, Values, Values], Values], count: int) -> float:
    """Largest distance [module] of a curve from its pieces over equal steps of its parameter."""
    at = np.linspace(curve.start, curve.end, count + 1)
    return float(np.max(missed(curve, at[:-1], at[1:])))


def _chord(curve: Curve, first: Values, last: Values) -> Values:
    a, b = curve.point(first)[:, None], curve.point(last)[:, None]
    inner = curve.point((first[:, None] + (last - first)[:, None] * WITHIN).ravel()).reshape(first.size, -1)
    return np.abs(((inner - a) * np.conj(b - a)).imag) / np.abs(b - a)


def _cubic(curve: Curve, first: Values, last: Values) -> Values:
    """Across the direction of the curve; the parameter of the cubic runs as that of the curve."""
    t, step = WITHIN, (last - first)[:, None]
    a, b = curve.point(first)[:, None], curve.point(last)[:, None]
    da, db = step * curve.rate(first)[:, None], step * curve.rate(last)[:, None]
    at = (first[:, None] + step * t).ravel()
    cubic: Plane = (
        a * (1 + 2 * t) * (1 - t) ** 2 + da * t * (1 - t) ** 2 + b * t * t * (3 - 2 * t) - db * t * t * (1 - t)
    )
    there, rate = (part.reshape(first.size, -1) for part in (curve.point(at), curve.rate(at)))
    return np.abs(((cubic - there) * np.conj(rate)).imag) / np.abs(rate)
