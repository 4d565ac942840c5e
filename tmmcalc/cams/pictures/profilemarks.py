"""The positions of the follower on the drawing of a cam, by their number in the tables."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex, Follower
from tmmcalc.cams.pictures.followersketch import ring
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.program import SAME, Positions, Program
from tmmcalc.cams.task import CamTask
from tmmcalc.core.records import record
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import OTHER, PATH, Pen

MOST = 10  # positions of a moving phase
STRIDES = tuple(m * 10**n for n in range(6) for m in (1, 2, 5))
APART = 4.0  # of two numbers on paper [mm]
NUMBER = 2.1  # height of a number [mm]
FACE = 0.3  # of the base circle: half of the piece of a face that is drawn
LAID = Pen("LIFTS_LAID_OFF", 0.25, colour=PATH.colour)
DOT = 0.45  # radius of a position [mm]


@record
class Mark:
    """A position of the follower on the cam."""

    label: str  # i of the tables
    place: complex  # centre of the roller, or contact of a flat face [m]
    ends: bool  # a phase begins there
    laid: Complex  # (n,) how the lift is laid off from the lowest position, as the cam sees it [m]
    face: Complex  # (2,) a piece of the flat face about the contact; (0,) of a roller


def marks_of(task: CamTask, result: Profile, rim: Rim) -> list[Mark]:
    """The rows of the tables that are drawn, at most `MOST` and the ends of a moving phase."""
    rows, ends = _chosen(task.positions, task.program)
    follower, phi = result.follower, task.positions.phi[rows]
    places = rim.at(phi, task.positions.piece[rows]).points.tolist()
    found = []
    for row, at, place, end in zip(rows.tolist(), phi.tolist(), places, ends, strict=True):
        face = np.empty(0, complex)
        if result.flat:
            face = place + FACE * follower.base * np.exp(1j * at) * np.array([-1, 1])
        laid = follower.placed(_laid_off(follower, at, float(task.motion[0, row])))
        label, centre = task.positions.labels[row], complex(follower.placed(np.array([place]))[0])
        found.append(Mark(label, centre, bool(end), laid, follower.placed(face)))
    return found


def _laid_off(follower: Follower, phi: float, lift: float) -> Complex:
    """The way (n,) of the roller, or of the foot of a stem, from its lowest place to that of this lift [m]."""
    turn, steps = np.exp(1j * phi), follower.start + lift * np.linspace(0, 1, 9)
    if follower.kind == "oscillating":
        arm = follower.rocker * np.exp(1j * (phi - follower.assembly * steps))
        return np.asarray(follower.centres * turn - arm)
    return np.asarray((follower.offset + 1j * steps) * turn)


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
    """Circles of the roller or pieces of the flat face, whose envelope is the profile; lifts laid off, and dots."""
    for mark in marks:
        if follower.roller:
            ring(board, mark.place, follower.roller, OTHER, weight=0.1)
        if len(mark.face):
            board.line(mark.face, OTHER, weight=0.1, level=2)
        board.line(mark.laid, LAID, weight=0.2, level=2)
        board.dot(mark.place, DOT, colour=PATH.colour, level=6)


def name_marks(board: Board, marks: list[Mark]) -> None:
    """Their numbers, the ends of the phases first; where they crowd some are left out."""
    named: list[complex] = []
    for mark in sorted(marks, key=lambda each: not each.ends):
        if all(abs(mark.place - other) > APART * board.mu for other in named):
            at, gaps = board.paper([mark.place]), (0.9, 1.6, 2.6, 4.0)
            board.labels.put(mark.label, at, height=NUMBER, prefer=mark.place, gaps=gaps, colour=PATH.colour)
            named.append(mark.place)
