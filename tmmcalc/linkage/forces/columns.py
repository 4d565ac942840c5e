"""The columns of the forces table; a reaction is the force of the lower-numbered link on the higher-numbered one.

In a prismatic pair that force is given by its normal part too, positive along the left normal of the line (a quarter
turn counter-clockwise from the direction of its guide), and by the couple of the same link on the same one, positive
counter-clockwise, about the slider's point.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.quantity import Quantity, quantities, quantity_of
from tmmcalc.linkage.columns import phi_column
from tmmcalc.linkage.forces.results import Forces, PairForces, edge_reactions

REACTION = (
    Quantity("R_{joint}_x[N]", "reaction in {joint} along x"),
    Quantity("R_{joint}_y[N]", "reaction in {joint} along y"),
    Quantity("R_{joint}[N]", "magnitude of the reaction in {joint}"),
)
NORMAL = Quantity(
    "N_{slide}[N]",
    "normal part of the reaction in prismatic pair {slide}, of the lower-numbered link on the other, along the left "
    "normal of its guide",
)
COUPLE = Quantity(
    "M_{slide}[N*m]",
    "couple of the lower-numbered link on the other in prismatic pair {slide} about the slider's point, "
    "counter-clockwise",
)
EDGES = (
    Quantity("N'_{slide}[N]", "reaction of the edge ahead in {slide}"),
    Quantity("N''_{slide}[N]", "reaction of the edge behind in {slide}"),
)
FRICTION = Quantity("F_fr_{slide}[N]", "friction along the line of prismatic pair {slide}")
FRICTION_MOMENT = Quantity("M_fr_{pin}[N*m]", "moment of friction about the pin of {pin}")
MESH = tuple(quantity_of(Forces, "mesh").marked(axis) for axis in ("x", "y"))


def drive_of(turns: bool) -> Quantity:
    """What the drive does along its coordinate: a moment on a crank, else a force."""
    letter, unit = ("M", "N*m") if turns else ("F", "N")
    return quantity_of(Forces, "drive", letter=letter, unit=unit)


def columns(result: Forces) -> list[Column]:
    """All columns of a result in their usual order."""
    told = quantities(Forces)
    pairs = [each for j, pair in enumerate(result.pairs) for each in _pair(result, j, pair)]
    return [
        phi_column(result.phi, result.turns),
        column(drive_of(result.turns), lambda: result.drive),
        column(told["power"], lambda: result.power),
        *pairs,
        *_mesh(result),
        column(told["equilibrium"], lambda: result.equilibrium),
        column(told["virtual"], lambda: result.virtual),
    ]


def _pair(result: Forces, j: int, pair: PairForces) -> Iterator[Column]:
    reaction = (lambda: result.reaction[j].real, lambda: result.reaction[j].imag, lambda: np.abs(result.reaction[j]))
    for told, make in zip(REACTION, reaction, strict=True):
        yield column(told.of(joint=pair.joint), make)
    if pair.kind == "prismatic":
        yield column(NORMAL.of(slide=pair.joint), lambda: result.normal[j])
        yield column(COUPLE.of(slide=pair.joint), lambda: result.couple[j])
        if pair.length:
            ahead, behind = edge_reactions(result.normal[j], result.couple[j], pair.length)
            yield column(EDGES[0].of(slide=pair.joint), lambda: ahead)
            yield column(EDGES[1].of(slide=pair.joint), lambda: behind)
        if pair.friction:
            yield column(FRICTION.of(slide=pair.joint), lambda: result.friction[j])
    elif pair.friction and pair.radius:
        yield column(FRICTION_MOMENT.of(pin=pair.joint), lambda: result.friction[j])


def _mesh(result: Forces) -> Iterator[Column]:
    mesh = result.mesh
    if mesh is not None:
        yield column(MESH[0], lambda: mesh.real)
        yield column(MESH[1], lambda: mesh.imag)
