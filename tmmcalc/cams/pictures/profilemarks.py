"""What is named on the drawing of a cam: positions of the follower by their number in the tables, the phases."""

from __future__ import annotations

from math import degrees
from typing import Any

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.program import SAME, Positions, Program
from tmmcalc.cams.task import CamTask
from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import PATH, THIN
from tmmcalc.report.numbers import number

MOST = 10  # positions of a moving phase
STRIDES = tuple(m * 10**n for n in range(6) for m in (1, 2, 5))
APART = 4.0  # of two numbers on paper [mm]
WITHIN = (0.62, 0.5, 0.76, 0.4)  # of the profile, where a phase is named
BESIDE = (0.0, 0.5, -0.5)  # of half its sector, from the middle
DOT: dict[str, Any] = {"color": PATH, "marker": "o", "markersize": 2.5, "linestyle": ""}


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
    """Rays to the ends of the phases, circles of the roller, dots."""
    board.lines([(0j, mark.place) for mark in marks if mark.ends], colors=THIN, linewidths=0.5, weight=0.3)
    for mark in marks:
        if follower.roller:
            around = mark.place + follower.roller * np.exp(1j * np.linspace(0, 2 * np.pi, 61))
            board.line(around, zorder=2, weight=0.1, color=THIN, linewidth=0.5)
        board.axes.plot(mark.place.real, mark.place.imag, zorder=6, **{**DOT, "markersize": 2.0})


def name_marks(board: Board, marks: list[Mark]) -> None:
    """Their numbers, the ends of the phases first; where they crowd some are left out."""
    named: list[complex] = []
    for mark in sorted(marks, key=lambda each: not each.ends):
        if all(abs(mark.place - other) > APART * board.mu for other in named):
            gaps = (0.9, 1.6, 2.6, 4.0)
            board.labels.put(mark.label, [mark.place], size=6.5, prefer=mark.place, gaps=gaps, color=PATH)
            named.append(mark.place)


def name_phases(board: Board, task: CamTask, result: Profile, rim: Rim) -> None:
    """The phases with their angles in their sectors, where they cover least."""
    program = task.program
    for begin, end, phase in zip(program.starts[:-1], program.starts[1:], program.phases, strict=True):
        sector = _sector(rim, result, np.linspace(begin, end, 65))
        text = f"{phase.kind} {number(degrees(phase.angle), 5)}°"
        board.labels.put(text, sector, size=7, prefer=sector[0], gaps=(0.3, 1.5, 3.0), color="#444444")


def _sector(rim: Rim, result: Profile, phi: np.ndarray) -> list[complex]:
    """Places in the sector that the curve covers over phi, the best first."""
    angle = np.unwrap(np.angle(rim.follower.placed(rim.at(phi).points)))
    wall: Plane = rim.follower.placed(rim.at(phi).offset(result.working.distance))
    middle, half = (angle[0] + angle[-1]) / 2, (angle[-1] - angle[0]) / 2
    radius = float(np.min(np.abs(wall)))
    return [complex(part * radius * np.exp(1j * (middle + by * half))) for part in WITHIN for by in BESIDE]
