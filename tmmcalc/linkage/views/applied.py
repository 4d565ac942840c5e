"""Forces that links bear beside the reactions, as a page draws them: loads, weights, springs, inertia, the drive.

Each stands at its point of the link at the places of the forces stage, both limits where it jumps. Couples have no
arrow: they are columns of their own, as the moment of the drive is.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.freebody import Known, Solved
from tmmcalc.linkage.model import FRAME
from tmmcalc.report.drawing.lettering import symbol
from tmmcalc.report.moving import FRAME as STANDING
from tmmcalc.report.moving import OLIVE, PURPLE, Body, Layer, Vector, track_of

NEAR = 1e-9  # [m] so far a point of a link may seem to go along it


class Drawn(NamedTuple):
    """The layers of the forces, and the points that they stand at, which have no marks."""

    points: tuple[Body, ...]
    layers: tuple[Layer, ...]


def applied_of(found: Solved, result: Forces, per: float) -> Drawn:
    """The given forces with that of the drive, and those of inertia, which may be far smaller, each to its own scale.

    ``per`` is the unit of the places of the view.
    """
    places = result.phi / per
    points: dict[tuple[str, complex], Body] = {}
    vectors: dict[bool, list[Vector]] = {False: [], True: []}
    for force in applied(found):
        on, at = _seat(found, force)
        body = points.setdefault((on, np.round(at, 9)), _point(f"acting-{len(points)}", on, at))
        value, sign = np.array(force.value), symbol(force.letter, force.index).strip("$")
        x, y = (track_of(part, 0.0, len(places)) for part in (value.real, value.imag))
        vectors[force.kind == "inertia"].append(Vector(sign, body.name, x, y, places))
    layers = (
        Layer("given", "Given forces", "N", (), tuple(vectors[False]), tone=PURPLE, hidden=True),
        Layer("inertia", "Forces of inertia", "N", (), tuple(vectors[True]), tone=OLIVE, hidden=True),
    )
    return Drawn(tuple(points.values()), tuple(layer for layer in layers if layer.vectors))


def applied(found: Solved) -> Iterator[Known]:
    """All forces on links that are no reactions, over the positions; one that is nothing everywhere is left out."""
    return (each for each in found.known if not each.couple and np.any(each.value))


def _seat(found: Solved, force: Known) -> tuple[str, complex]:
    """The body that a force goes with, and its place there: its link, else another, as of what pushes against it."""
    motions, at = found.place.configuration.motions, np.array(force.at)
    seats = {}
    for link in dict.fromkeys((force.link, *motions)):
        motion = motions[link]
        places = motion.base + (at - motion.r) / motion.u
        seats[link] = float(np.abs(places - places[0]).max()), complex(places[0])
        if seats[link][0] < NEAR:
            break
    link, (_, place) = min(seats.items(), key=lambda each: each[1][0])
    return (STANDING if link == FRAME else str(link)), place


def _point(name: str, on: str, at: complex) -> Body:
    """A point of a body, that a vector stands at."""
    still = track_of(0.0, 0.0, 1)
    return Body(name, track_of(at.real, 0.0, 1), track_of(at.imag, 0.0, 1), still, (), on=on)
