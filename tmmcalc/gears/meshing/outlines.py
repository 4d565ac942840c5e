"""Outlines of wheels and of single teeth as chains of arcs, lines and cubics, in metres.

A track runs counter-clockwise about its wheel: right half of a tooth, tip, left half, bottom of the space. That of a
rack is open and runs in the direction of its -X. Cubics keep a stated distance from the curves that they stand for;
arcs and lines are exact.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Iterator, Sequence
from math import pi
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.curves import chords, cubics
from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.gears.involute.profile.mesh import Placing
from tmmcalc.gears.involute.profile.outline import Arc
from tmmcalc.gears.meshing.halftooth import Half, ProfilePart, half_tooth
from tmmcalc.gears.meshing.members import Toothed
from tmmcalc.gears.meshing.refusal import millimetres
from tmmcalc.report.outlines import Bow, Cubics, Line, Piece

FINEST, COARSEST = 1e-8, 0.1  # chord tolerance in modules
UPRIGHT = Placing(0.0, 0j)  # centre at the origin, a tooth on +Y


@record
class Track:
    """The outline of one wheel or tooth where it stands [m]."""

    member: Toothed
    pieces: tuple[Piece, ...]  # each begins where the one before it ends
    polygon: Plane  # (n,) the outline in chords that keep the tolerance; the first point is not repeated
    closed: bool


class _Stroke(NamedTuple):
    """A piece in modules, and its points with both ends."""

    piece: Piece
    points: Plane


def track(member: Toothed, tolerance: float, placing: Placing = UPRIGHT, whole: bool = True) -> Track:
    """The outline of a whole wheel, or of one tooth between the middles of its spaces, placed in modules.

    ``tolerance`` is a length [m]. A rack has as many teeth as its pinion. Raises `UsageError` for a tolerance that
    would take millions of points or leaves nothing of the teeth, and as `half_tooth` does.
    """
    half, m = half_tooth(member), member.module
    fine = _fineness(tolerance, m)
    tooth = _tooth(half, fine)
    if whole:
        strokes, places = [*tooth, *_bottom(half, fine)], _places(member, placing)
    else:
        strokes, places = [*_before(half, fine), *tooth, *_after(half, fine)], [placing]
    closed = whole and member.shape != "rack"
    runs = [repeated(stroke.piece, places, m) for stroke in strokes]
    pieces = tuple(piece for of_tooth in zip(*runs, strict=True) for piece in of_tooth)
    one = np.concatenate([stroke.points[:-1] for stroke in strokes])
    points = _everywhere(one, places, m).ravel()
    if not closed:
        points = np.append(points, _everywhere(strokes[-1].points[-1:], places[-1:], m))
    return Track(member, pieces, points, closed)


def _fineness(tolerance: float, module: float) -> float:
    """A chord tolerance [m] in modules."""
    fine = tolerance / module
    if FINEST <= fine <= COARSEST:
        return fine
    small = fine < FINEST
    limit = (FINEST if small else COARSEST) * module
    least, most = millimetres(FINEST * module), millimetres(COARSEST * module)
    raise UsageError(
        f"a chord tolerance of {millimetres(tolerance)} is too {'fine' if small else 'coarse'} for the module of "
        f"{millimetres(module)}",
        where="tooth profile",
        value=tolerance,
        limit=limit,
        remedy=f"{least} to {most}; the coordinates themselves are exact to rounding",
    )


def _places(member: Toothed, placing: Placing) -> list[Placing]:
    """Where the teeth of a whole wheel stand."""
    pitch = 2 * member.half_pitch
    if member.shape != "rack":
        return [Placing(placing.turn + pitch * k, placing.centre) for k in range(member.wheel.teeth)]
    teeth, along = member.wheel.teeth, exp(1j * placing.turn)
    return [Placing(placing.turn, placing.centre + along * pitch * (teeth // 2 - k)) for k in range(teeth)]


def _tooth(half: Half, fine: float) -> list[_Stroke]:
    """Right side, tip and left side."""
    sides = [part for part in half.parts if part.name not in ("root", "tip")]
    tip = [_whole(part, fine) for part in half.parts if part.name == "tip"]
    right = [_stroke(part, fine) for part in sides]
    return [*right, *tip, *(_mirrored(stroke) for stroke in reversed(right))]


def _stroke(part: ProfilePart, fine: float) -> _Stroke:
    """The right side of a tooth, upward."""
    if part.kind == "line":
        run = -np.conj(part.curve.point(np.array([part.curve.start, part.curve.end])))
        return _Stroke(Line((complex(run[0]), complex(run[1]))), run)
    return _Stroke(Cubics(-np.conj(cubics(part.curve, fine))), -np.conj(chords(part.curve, fine)))


def _mirrored(stroke: _Stroke) -> _Stroke:
    """The left side, downward."""
    piece, points = stroke.piece, -np.conj(stroke.points[::-1])
    if isinstance(piece, Cubics):
        return _Stroke(Cubics(-np.conj(piece.control[::-1, ::-1])), points)
    return _Stroke(Line((complex(points[0]), complex(points[1]))), points)


def _whole(part: ProfilePart, fine: float) -> _Stroke:
    """Tip or bottom with its right half: the part ends or begins in the middle."""
    first, last = (complex(end) for end in part.curve.point(np.array([part.curve.start, part.curve.end])))
    if part.kind == "line":
        ends = (-first.conjugate(), first) if part.name == "tip" else (last, 2 * first - last)
        return _Stroke(Line(ends), np.array(ends))
    sweep = 2 * abs(part.curve.start - part.curve.end)
    return _bow(abs(first), pi / 2 - sweep / 2 if part.name == "tip" else part.curve.end, sweep, fine)


def _bottom(half: Half, fine: float) -> list[_Stroke]:
    return [_whole(part, fine) for part in half.parts if part.name == "root"]


def _after(half: Half, fine: float) -> list[_Stroke]:
    """From the left side to the middle of the space."""
    return [_to_middle(part, fine, right=False) for part in half.parts if part.name == "root"]


def _before(half: Half, fine: float) -> list[_Stroke]:
    """From the middle of the space to the right side."""
    return [_to_middle(part, fine, right=True) for part in half.parts if part.name == "root"]


def _to_middle(part: ProfilePart, fine: float, right: bool) -> _Stroke:
    if part.kind == "line":
        return _stroke(part, fine) if right else _mirrored(_stroke(part, fine))
    sweep = part.curve.start - part.curve.end
    start = pi - part.curve.start if right else part.curve.end
    return _bow(abs(complex(part.curve.point(np.array(part.curve.start)))), start, sweep, fine)


def _bow(radius: float, start: float, sweep: float, fine: float) -> _Stroke:
    bow = Bow(0j, radius, start, sweep)
    first, last = bow.ends
    return _Stroke(bow, np.array([first, *Arc(radius, start, sweep).points(fine), last]))


def _everywhere(points: Plane, places: Sequence[Placing], m: float) -> Plane:
    """Points (...) in every place (k, ...), in metres."""
    shape = (-1, *[1] * points.ndim)
    turns = np.exp(1j * np.array([place.turn for place in places])).reshape(shape)
    centres = np.array([place.centre for place in places]).reshape(shape)
    placed: Plane = m * (points * turns + centres)
    return placed


def repeated(piece: Piece, places: Sequence[Placing], m: float) -> Iterator[Piece]:
    """A piece in every place, in metres."""
    if isinstance(piece, Cubics):
        yield from map(Cubics, _everywhere(piece.control, places, m))
    elif isinstance(piece, Bow):
        centres = _everywhere(np.array(piece.centre), places, m).tolist()
        for centre, place in zip(centres, places, strict=True):
            yield Bow(centre, m * piece.radius, piece.start + place.turn, piece.sweep)
    else:
        for first, last in _everywhere(np.array(piece.ends), places, m).tolist():
            yield Line((first, last))
