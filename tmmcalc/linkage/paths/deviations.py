"""What is told of the distances of paths from their wanted points, of V variants at once."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import quantities
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.paths.nearest import Path, nearest
from tmmcalc.linkage.paths.results import Order, PathDeviation
from tmmcalc.linkage.paths.task import WantedPath
from tmmcalc.linkage.survey import Evaluate, Quantity

SAME = 1e-9  # places of the input nearer than this part of a turn or range are one
ORDERS: tuple[Order, ...] = ("none", "along", "against")


class Range(NamedTuple):
    """Where paths of V variants are looked at."""

    x: Real  # (V, m) input coordinates of a survey, ascending
    start: Real  # (V,) position 0
    sense: float  # of the motion, 1 or -1
    closed: bool  # a whole turn, after which the last sample repeats the first


class Reached(NamedTuple):
    """The places of a path for its n points."""

    wanted: Plane  # (V, n)
    x: Real  # (V, n) input coordinates
    place: Plane  # (V, n)
    free: NDArray[np.bool_]  # (V, n) found as the nearest one between the ends of the path


def states(point: str) -> Quantity:
    """What evaluates a point of a moving link: r, r', r'' (3, rows)."""
    return partial(_states, point)


def _states(point: str, chain: Chain, configuration: Configuration, rows: NDArray[np.intp]) -> Any:
    link, p = next((link, p) for name, link, p in chain.layout.points if name == point)
    return np.stack([np.broadcast_to(part, rows.shape) for part in configuration.motions[link].point(p)])


def reached(evaluate: Evaluate, over: Range, asked: WantedPath) -> Reached:
    """The places of one path; the numbers of ``asked`` are those of all variants, or of each (`Alike`)."""
    count = len(over.x)
    turn, shift = _each((asked.turn, asked.shift), count).T[:, :, None]
    wanted = shift + np.exp(1j * turn) * _each(asked.through, count)
    point, each = states(asked.point), np.arange(count)
    if asked.at:
        x = over.start[:, None] + _each(asked.at, count)
        place = evaluate(x.ravel(), np.repeat(each, x.shape[1]), point, 0)[0]
        return Reached(wanted, x, place.reshape(x.shape), np.zeros(x.shape, bool))

    def track(x: Real, variants: NDArray[np.intp]) -> Any:
        return evaluate(x, variants, point, 2)

    found = nearest(Path(track, over.x, over.start, over.sense, over.closed), wanted)
    place = track(found.x.ravel(), np.repeat(each, wanted.shape[1]))[0]
    return Reached(wanted, found.x, place.reshape(wanted.shape), found.free)


def _each(numbers: Sequence[Any], count: int) -> Any:
    """Constants (n,), each of all variants or of every one, as (V, n)."""
    return np.stack([np.broadcast_to(np.asarray(number), count) for number in numbers], axis=1)


class Deviations(NamedTuple):
    """What `PathDeviation` tells, of every variant (V,)."""

    total: Real
    rms: Real
    largest: Real
    worst: NDArray[np.intp]  # from 1 on
    worst_at: Real
    covered: Real
    order: NDArray[np.intp]  # number in `ORDERS`

    @property
    def ordered(self) -> NDArray[np.bool_]:
        """Whether the points are met in their order."""
        return self.order > 0

    def record(self, v: int, asked: WantedPath) -> PathDeviation:
        """The record of one variant."""
        return PathDeviation(
            name=asked.name,
            point=asked.point,
            count=len(asked.through),
            timed=bool(asked.at),
            total=float(self.total[v]),
            rms=float(self.rms[v]),
            largest=float(self.largest[v]),
            worst=int(self.worst[v]),
            worst_at=float(self.worst_at[v]),
            covered=float(self.covered[v]),
            order=None if asked.at else ORDERS[self.order[v]],
        )


def deviations(over: Range, found: Reached, asked: WantedPath) -> Deviations:
    """Sums, extremes and order of the distances of one path."""
    off = found.place - found.wanted
    squares = off.real**2 + off.imag**2
    worst = np.argmax(squares, axis=1)
    phi = found.x - over.start[:, None]
    each = np.arange(len(phi))
    along = over.sense * phi
    order = np.ones(len(phi), np.intp) if asked.at else _order(along, over)
    return Deviations(
        total=np.sum(squares, axis=1),
        rms=np.sqrt(np.mean(squares, axis=1)),
        largest=np.sqrt(squares[each, worst]),
        worst=worst + 1,
        worst_at=phi[each, worst],
        covered=_covered(along, over.closed),
        order=order,
    )


def _order(along: Real, over: Range) -> NDArray[np.intp]:
    """Numbers (V,) in `ORDERS` of the order in which places (V, n) of the input follow; of a turn from any one on."""
    found = np.zeros(len(along), np.intp)
    for number, ways in ((2, -along), (1, along)):
        if over.closed:
            gaps = np.mod(np.roll(ways, -1, axis=1) - ways + SAME * TURN, TURN) - SAME * TURN
            found[np.sum(gaps, axis=1) < 1.5 * TURN] = number
        else:
            least = SAME * np.ptp(over.x, axis=1)
            found[np.min(np.diff(ways, axis=1), axis=1, initial=np.inf) > -least] = number
    return found


def _covered(along: Real, closed: bool) -> Real:
    """Part of the input (V,) over which places (V, n) stand: of a turn all but the largest gap."""
    if not closed:
        return np.asarray(np.ptp(along, axis=1))
    turned = np.sort(np.mod(along, TURN), axis=1)
    gaps = np.diff(np.concatenate((turned, turned[:, :1] + TURN), axis=1), axis=1)
    return np.asarray(TURN - np.max(gaps, axis=1))


def names_of(path: str) -> dict[str, str]:
    """Names of the facts of a path by the fields of `PathDeviation` that `Deviations` has."""
    told = quantities(PathDeviation)
    return {field: told[field].of(path=path, own="").name for field in told}


def told_by(found: Deviations, path: str) -> dict[str, Real]:
    """The facts (V,) of a path of cranks that turn wholly, by name: angles in degrees."""
    turned = found._replace(worst_at=np.degrees(found.worst_at), covered=np.degrees(found.covered))
    return {name: getattr(turned, field) for field, name in names_of(path).items()}
