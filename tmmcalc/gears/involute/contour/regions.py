"""Regions of a contour: its parts joined where they adjoin.

A tip circle that is its reference circle is no condition, only the line on which the room before interference is least.
Where the straight flank ends deeper than h_a*, some room is left there, and the parts on both sides are one region: the
edge that they share is taken away, and a line that runs across it goes on without a corner.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.involute.contour.trace import ContourPart, Corner, Edge
from tmmcalc.gears.model import Values

TIPS = ("tip1", "tip2")
SAME = 1e-7  # distance of the ends of an edge as found on both of its sides

Key = tuple[int, int]  # number of a part, number of its edge


@record
class Region:
    """A closed region of admissible shifts."""

    parts: tuple[ContourPart, ...]
    edges: tuple[Edge, ...]  # counter-clockwise
    corners: tuple[Corner, ...]
    area: float

    @cached_property
    def outline(self) -> tuple[Values, Values]:
        """x1, x2 of the closed curve, counter-clockwise; the first point is the last too."""
        first = self.edges[0]
        x1 = np.concatenate([*(edge.x1[:-1] for edge in self.edges), first.x1[:1]])
        return x1, np.concatenate([*(edge.x2[:-1] for edge in self.edges), first.x2[:1]])

    @cached_property
    def angles(self) -> Values:
        """Operating angles [rad] of the lines of constant sum of all parts, ascending."""
        w = np.sort(np.concatenate([part.angles for part in self.parts]))
        return w[np.append(True, np.diff(w) > 0)]

    @property
    def ends(self) -> tuple[float, float]:
        """The least and the largest sum of shifts."""
        return min(float(part.total[0]) for part in self.parts), max(float(part.total[-1]) for part in self.parts)


def regions_of(frame: Frame, parts: Sequence[ContourPart]) -> tuple[Region, ...]:
    """The parts of all branches as regions; parts that only touch in a point stay apart."""
    shared = _shared_edges(parts) if frame.neck > 0 else {}
    groups = list(range(len(parts)))
    for (one, _), (other, _) in shared.items():
        groups = [groups[one] if group == groups[other] else group for group in groups]
    found = []
    for group in dict.fromkeys(groups):
        members = [k for k, own in enumerate(groups) if own == group]
        own = tuple(parts[k] for k in members)
        if len(own) == 1:
            found.append(Region(own, own[0].edges, own[0].corners, own[0].area))
            continue
        # no condition fails on an island within a region, so that it has one closed curve
        edges, corners = _merged([parts[k].edges[n] for k, n in _loop(parts, members, shared)])
        found.append(Region(own, edges, corners, sum(part.area for part in own)))
    return tuple(found)


def _shared_edges(parts: Sequence[ContourPart]) -> dict[Key, Key]:
    """The edges along tip lines that two parts share."""
    tips = [((k, n), edge) for k, part in enumerate(parts) for n, edge in enumerate(part.edges) if edge.line in TIPS]
    return {
        key: other
        for key, edge in tips
        for other, mate in tips
        if key[0] != other[0]
        and edge.line == mate.line
        and abs(_start(edge) - _end(mate)) < SAME
        and abs(_end(edge) - _start(mate)) < SAME
    }


def _start(edge: Edge) -> complex:
    return complex(edge.x1[0], edge.x2[0])


def _end(edge: Edge) -> complex:
    return complex(edge.x1[-1], edge.x2[-1])


def _loop(parts: Sequence[ContourPart], members: Sequence[int], shared: dict[Key, Key]) -> Iterator[Key]:
    """The edges of the closed curve about the parts, from the one that begins at the least sum."""

    def after(key: Key) -> Key:
        return key[0], (key[1] + 1) % len(parts[key[0]].edges)

    own = [(k, n) for k in members for n in range(len(parts[k].edges)) if (k, n) not in shared]
    starts = [_start(parts[k].edges[n]) for k, n in own]
    first = at = own[int(np.argmin([z.real + z.imag for z in starts]))]
    for _ in own:
        yield at
        at = after(at)
        while at in shared:  # across the shared edge, on in the neighbour
            at = after(shared[at])
        if at == first:
            return


def _merged(edges: Sequence[Edge]) -> tuple[tuple[Edge, ...], tuple[Corner, ...]]:
    """Neighbouring edges on one line as one, and the corners between the others."""
    start = next((k for k in range(len(edges)) if edges[k - 1].line != edges[k].line), 0)
    found: list[Edge] = []
    for edge in (*edges[start:], *edges[:start]):
        if found and found[-1].line == edge.line:
            last = found.pop()
            edge = Edge(edge.line, np.concatenate((last.x1, edge.x1[1:])), np.concatenate((last.x2, edge.x2[1:])))
        found.append(edge)
    if len(found) == 1:
        return tuple(found), ()
    return tuple(found), tuple(
        Corner(float(edge.x1[0]), float(edge.x2[0]), (found[k - 1].line, edge.line)) for k, edge in enumerate(found)
    )
