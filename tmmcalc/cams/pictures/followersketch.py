"""The follower at the start of the rise, as it is drawn on its cam."""

from __future__ import annotations

import cmath
from typing import Any

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.profile.results import Face
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import INK
from tmmcalc.report.drawing.symbols import hatched, pin, pivot

STEM = 1.4  # half its width on paper [mm]
GUIDE = 8.0  # length of the guide on paper [mm]
LINE: dict[str, Any] = {"color": INK, "linewidth": 1.4, "zorder": 7}
AXIS: dict[str, Any] = {"color": "#6b6b6b", "linewidth": 0.6, "linestyle": (0, (9, 2, 2, 2)), "zorder": 2}


def draw_follower(board: Board, follower: Follower, face: Face | None) -> None:
    """A stem with roller or flat face and its guide, or a rocker with its pivot."""
    if follower.kind == "oscillating":
        _draw_rocker(board, follower)
    else:
        _draw_stem(board, follower, face)


def _draw_rocker(board: Board, follower: Follower) -> None:
    at = complex(follower.centres)
    arm = -follower.rocker * cmath.exp(-1j * follower.assembly * follower.start)
    centre = at + (arm if follower.sense > 0 else arm.conjugate())
    board.line((0j, at), weight=0.5, **AXIS)
    board.line((at, centre), **{**LINE, "linewidth": 2.0})
    _draw_roller(board, centre, follower.roller)
    pivot(board, at, -1j)
    board.labels.put("A", [at], size=9, prefer=1 + 1j)
    board.labels.put("C", [centre], size=9, prefer=centre)


def _draw_stem(board: Board, follower: Follower, face: Face | None) -> None:
    side = complex(follower.offset * follower.sense)
    foot = side + 1j * follower.start
    half, top = STEM * board.mu, side + 1j * (follower.start + follower.roller + 0.5 * follower.base)
    low = foot + (0 if face is not None else 1j * follower.roller)
    board.line((side, top), weight=0.3, **AXIS)
    for way in (-1, 1):
        board.line((low + way * half, top + way * half), weight=0.5, **LINE)
        end = top - 1j * 0.15 * follower.base
        hatched(board, end + way * half, end + way * half - 1j * GUIDE * board.mu, complex(way))
    if face is not None:
        board.line((foot - face.left - face.margin, foot + face.right + face.margin), **{**LINE, "linewidth": 2.4})
        return
    board.line((low - half, foot, low + half), weight=0.5, **LINE)
    _draw_roller(board, foot, follower.roller)
    board.labels.put("C", [foot], size=9, prefer=1 - 1j)


def _draw_roller(board: Board, centre: complex, radius: float) -> None:
    if radius:
        around = centre + radius * np.exp(1j * np.linspace(0, 2 * np.pi, 121))
        board.area(around[:-1], facecolor="none", linewidth=1.4, zorder=6, weight=0.5)
        pin(board, centre)
