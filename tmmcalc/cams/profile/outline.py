"""Outlines of the curves of a cam for drawings and machines: exact arcs of the dwells, cubics or chords elsewhere."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.curves import Curve, cubics, knots
from tmmcalc.report.outlines import Bow, Cubics, Outline, Piece

FINEST = 1e-9  # of the base circle: a finer tolerance would take millions of points


def check_tolerance(rim: Rim, tolerance: float) -> None:
    """Raise `UsageError` for a tolerance that nobody could use."""
    least = FINEST * rim.follower.base
    if not tolerance >= least:
        raise UsageError(
            f"a chord tolerance of {tolerance:g} m is too fine for a base circle of {rim.follower.base:g} m",
            where="cam profile",
            value=tolerance,
            limit=least,
            remedy=f"at least {least:.1g} m; the coordinates themselves are exact to rounding",
        )


def adaptive(rim: Rim, distance: float, tolerance: float) -> tuple[Values, Indices]:
    """Angles (n,) with the numbers of their pieces, the chords between whose points keep the tolerance.

    Both ends of the turn and of every piece are among them, each once. Raises as `check_tolerance`.
    """
    check_tolerance(rim, tolerance)
    parts = [knots(_curve(rim, distance, piece), tolerance) for piece in range(len(rim.program.edges) - 1)]
    phi = np.concatenate([parts[0], *(part[1:] for part in parts[1:])])
    pieces = np.repeat(np.arange(len(parts)), [len(parts[0]), *(len(part) - 1 for part in parts[1:])])
    return phi, pieces


def outline(rim: Rim, name: str, distance: float, tolerance: float) -> Outline:
    """The closed outline of an offset in the user's sense, counter-clockwise [m]; raises as `check_tolerance`."""
    phi, pieces = adaptive(rim, distance, tolerance)
    polygon = rim.follower.placed(rim.at(phi, pieces).offset(distance))[:-1]
    chain = [_piece(rim, distance, piece, tolerance) for piece in range(len(rim.program.edges) - 1)]
    if rim.follower.sense < 0:
        polygon, chain = polygon[::-1], chain[::-1]
    return Outline(name, name, tuple(chain), polygon, True)


def _curve(rim: Rim, distance: float, piece: int) -> Curve:
    """One piece of an offset, canonical."""
    start, end = rim.program.edges[piece : piece + 2].tolist()

    def numbers(phi: Values) -> Indices:
        return np.full(phi.size, piece)

    def point(phi: Values) -> Complex:
        return rim.at(phi.ravel(), numbers(phi)).offset(distance).reshape(phi.shape)

    def rate(phi: Values) -> Complex:
        return rim.at(phi.ravel(), numbers(phi)).rate(distance, rim.flat).reshape(phi.shape)

    return Curve(point, rate, start, end)


def _piece(rim: Rim, distance: float, piece: int, tolerance: float) -> Piece:
    """One piece in the user's sense; a dwell is an arc about O."""
    curve, follower = _curve(rim, distance, piece), rim.follower
    if not rim.program.phases[rim.program.places[0][piece]].moves:
        ends = follower.placed(curve.point(np.array([curve.start, curve.end])))
        first = complex(ends[0] if follower.sense > 0 else ends[1])
        return Bow(0j, abs(first), float(np.angle(first)), curve.end - curve.start)
    control = follower.placed(cubics(curve, tolerance))
    return Cubics(control if follower.sense > 0 else control[::-1, ::-1])
