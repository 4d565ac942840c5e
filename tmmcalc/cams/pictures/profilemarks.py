"""The positions of the follower on the drawing of a cam, by their number in the tables."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pictures.followersketch import ring
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.program import SAME, Positions, Program
from tmmcalc.cams.task import CamTask
from tmmcalc.core.records import record
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import OTHER, PATH

MOST = 10  # positions of a moving phase
STRIDES = tuple(m * 10**n for n in range(6) for m in (1, 2, 5))
APART = 4.0  # of two numbers on paper [mm]
NUMBER = 1.8  # height of a number [mm]
DOT = 0.45  # radius of a position [mm]


@record
class Mark:
    """A position of the follower on the cam."""

    label: str  # i of the tables
    place: complex  # centre of the roller, or contact of a flat face [m]
    ends: bool  # a phase begins there


def marks_of(task: CamTask, result: Profile, rim: Rim) -> list[Mark]:
    """The rows of the tables that are drawn, at most `MOST` and the ends of a moving phase."""
    rows, ends = _chosen(task.positions, task.program)
    places = result.follower.placed(rim.at(task.positions.phi[rows], task.positions.piece[rows]).points)
    return [
        Mark(task.positions.labels[row], complex(place), bool(end))
        for row, place, end in zip(rows.tolist(), places, ends, strict=True)
    ]


def _chosen(positions: Positions, program: Program) -> tuple[np.ndarray, np.ndarray]:
    """Numbers (m,) of the rows, and whether a phase begins there (m,): rows of round numbers between such places."""
    plain = np.array([row for row, label in enumerate(positions.labels) if "-" not in label])[:-1]
    phi, edges = positions.phi[plain], program.starts[:-1]
    ends = np.abs(phi[:, None] - edges).min(axis=1) <= SAME * program.starts[-1]
    kept, at_end = ends.copy(), np.flatnonzero(ends)
    for first, last, phase in zip(at_end, [*at_end[1:], len(plain)], program.phases, strict=True):
        if not phase.moves:
            continue
        inner = np.arange(first + 1, last)
        stride = next(each for each in STRIDES if len(inner) < MOST * each)
        clear = (inner - first >= stride / 2) & (last - inner >= stride / 2)
        kept[inner] = clear & (inner % stride == 0)
    return plain[kept], ends[kept]


def draw_marks(board: Board, marks: list[Mark], follower: Follower) -> None:
    """Circles of the roller, and dots."""
    for mark in marks:
        if follower.roller:
            ring(board, mark.place, follower.roller, OTHER, weight=0.1)
        board.dot(mark.place, DOT, colour=PATH.colour, level=6)


def name_marks(board: Board, marks: list[Mark]) -> None:
    """Their numbers, the ends of the phases first; where they crowd some are left out."""
    named: list[complex] = []
    for mark in sorted(marks, key=lambda each: not each.ends):
        if all(abs(mark.place - other) > APART * board.mu for other in named):
            at, gaps = board.paper([mark.place]), (0.9, 1.6, 2.6, 4.0)
            board.labels.put(mark.label, at, height=NUMBER, prefer=mark.place, gaps=gaps, colour=PATH.colour)
            named.append(mark.place)
