"""The follower at the start of the rise, as it is drawn on its cam."""

from __future__ import annotations

import cmath

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.profile.results import Face
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import AXIS, MIDDLE, THICK, Pen
from tmmcalc.report.drawing.shapes import Arc
from tmmcalc.report.drawing.signs import hatched, pin, pivot

STEM = 1.4  # half its width on paper [mm]
GUIDE = 8.0  # length of the guide on paper [mm]
LINE = Pen("FOLLOWER", 0.5)
AXES = AXIS._replace(width=0.18)
OVER = 0.5  # of the base circle: how far the stem goes over the roller


def draw_follower(board: Board, follower: Follower, face: Face | None) -> None:
    """A stem with roller or flat face and its guide, or a rocker with its pivot."""
    if follower.kind == "oscillating":
        _draw_rocker(board, follower)
    else:
        _draw_stem(board, follower, face)


def centre_of(follower: Follower) -> complex:
    """Where the roller stands at the start of the rise [m]; of a flat face the foot of the stem."""
    if follower.kind != "oscillating":
        return complex(follower.offset * follower.sense, follower.start)
    arm = -follower.rocker * cmath.exp(-1j * follower.assembly * follower.start)
    return complex(follower.centres) + (arm if follower.sense > 0 else arm.conjugate())


def top_of(follower: Follower) -> complex:
    """The upper end of the stem [m]."""
    return centre_of(follower) + 1j * (follower.roller + OVER * follower.base)


def ring(board: Board, centre: complex, radius: float, pen: Pen, *, weight: float = 0.3, level: float = 2.0) -> None:
    """A circle of this radius [m], through which one sees."""
    at, size = board.place(centre), radius / board.mu
    board.drawing.add(Arc(at, size, pen), level=level)
    board.labels.avoid(at + size * np.exp(1j * np.linspace(0, 2 * np.pi, 121)), weight)


def _draw_rocker(board: Board, follower: Follower) -> None:
    at, centre = complex(follower.centres), centre_of(follower)
    board.line((0j, at), AXES, weight=0.5, level=2)
    board.line((at, centre), THICK, level=7)
    _draw_roller(board, centre, follower.roller)
    pivot(board, at, -1j)


def _draw_stem(board: Board, follower: Follower, face: Face | None) -> None:
    foot, top = centre_of(follower), top_of(follower)
    half = STEM * board.mu
    low = foot + (0 if face is not None else 1j * follower.roller)
    board.line((complex(foot.real), top), AXES, weight=0.3, level=2)
    for way in (-1, 1):
        board.line((low + way * half, top + way * half), LINE, weight=0.5, level=7)
        end = top - 0.15j * follower.base
        hatched(board, end + way * half, end + way * half - 1j * GUIDE * board.mu, complex(way))
    if face is not None:
        board.line((foot - face.left - face.margin, foot + face.right + face.margin), THICK, level=7)
        return
    board.line((low - half, foot, low + half), LINE, weight=0.5, level=7)
    _draw_roller(board, foot, follower.roller)


def _draw_roller(board: Board, centre: complex, radius: float) -> None:
    if radius:
        ring(board, centre, radius, MIDDLE, weight=0.5, level=6)
        pin(board, centre)
