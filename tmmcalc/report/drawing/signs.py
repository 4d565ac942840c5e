"""The signs of kinematic schemes: pins, pivots on hatched supports, slider blocks, hatched guides, arrows."""

from __future__ import annotations

import cmath

import numpy as np

from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import HATCH, INK, MARK, MIDDLE, Pen

PIN = 0.85  # radius of a revolute joint [mm]
BLOCK = (6.4, 3.6)  # length and height of a slider
PIVOT = (4.4, 3.4)  # width and height of the triangle under a pivot
STROKES = (1.1, 1.3)  # pitch and length of hatching
HEAD = 2.6  # length of the head of an arrow of motion
BENT = 2.2  # bars that meet at a greater angle [rad] need no filled corner
NARROW = 0.05  # and at a smaller one they are one line
PLATE, GUIDE, SLOT, BODY, LINK, PINS, ARROWS = 2.5, 3, 4, 5, 6, 8, 12  # levels, those drawn last above


def pin(board: Board, at: complex) -> None:
    """A revolute joint: a small open circle."""
    board.circle(at, PIN, level=PINS)


def pivot(board: Board, at: complex, down: complex) -> None:
    """A revolute joint with the frame: an open circle on a hatched triangle that points away from ``down``."""
    wide, high = (v * board.mu for v in PIVOT)
    foot, side = at + down * high, 1j * down * wide / 2
    board.area([at, foot - side, foot + side], weight=2, level=GUIDE)
    hatched(board, foot - 1.4 * side, foot + 1.4 * side, down)
    pin(board, at)


def hatched(board: Board, a: complex, b: complex, outward: complex) -> None:
    """A ground line with hatching on its outward side."""
    pitch, length = (v * board.mu for v in STROKES)
    e = (b - a) / abs(b - a)
    count = max(2, int(abs(b - a) / pitch))
    starts = a + (b - a) * (np.arange(count) + 0.75) / count
    slant = (outward - e) / abs(outward - e) * length
    board.line((a, b), MIDDLE, level=GUIDE)
    board.lines([(z, z + slant) for z in starts.tolist()], HATCH, level=GUIDE)


def block(board: Board, at: complex, direction: complex) -> None:
    """A slider: a rectangle along its guide."""
    board.area(rectangle(board, at, direction), level=BODY)


def rectangle(board: Board, at: complex, direction: complex) -> list[complex]:
    """Corners of a slider block."""
    a, b = (v * board.mu / 2 * direction for v in BLOCK)
    return [at + a + 1j * b, at - a + 1j * b, at - a - 1j * b, at + a - 1j * b]


def guide(board: Board, ends: tuple[complex, complex], outward: complex) -> None:
    """A guide on the frame: the hatched line that the blocks between these ends run on."""
    e = (ends[1] - ends[0]) / abs(ends[1] - ends[0]) if ends[1] != ends[0] else outward * 1j
    over = (BLOCK[0] / 2 + 1.5) * board.mu * e
    offset = BLOCK[1] / 2 * board.mu * outward
    hatched(board, ends[0] - over + offset, ends[1] + over + offset, outward)


def sleeve(board: Board, at: complex, direction: complex, outward: complex) -> None:
    """A block fixed in the frame, through which the guide of a moving link runs."""
    block(board, at, direction)
    guide(board, (at, at + 1e-9 * board.mu * direction), outward)


def sense_arrow(board: Board, centre: complex, along: complex, radius: float, sense: float) -> complex:
    """An arc with an arrowhead in the sense of rotation ahead of a crank; returns the place for its name."""
    start, end = cmath.phase(along) + sense * 0.5, cmath.phase(along) + sense * 1.75
    arc = centre + radius * np.exp(1j * np.linspace(start, end, 30))
    head = HEAD * board.mu / radius
    board.line(arc[: max(2, int(30 * (1 - head / 1.25)))], MARK, level=PINS)
    board.arrowhead(complex(arc[-1]), 1j * sense * cmath.exp(1j * (end - sense * head / 2)), MARK, HEAD, level=ARROWS)
    return complex(arc[15])


def straight_arrow(board: Board, start: complex, direction: complex) -> complex:
    """An arrow beside a driven slider; returns the place for its name."""
    tip = start + 9 * board.mu * direction
    board.vector(start, tip, MARK, HEAD, level=ARROWS)
    board.labels.avoid(board.paper([start, tip]), 2.0)
    return (start + tip) / 2


def weld(board: Board, at: complex, first: complex, second: complex) -> None:
    """A filled corner: two bars that meet here are one rigid link."""
    radius, turn = 4 * board.mu, cmath.phase(second / first)
    if NARROW < abs(turn) < BENT:
        arc = at + radius * first / abs(first) * np.exp(1j * turn * np.linspace(0, 1, 12))
        board.area([at, *arc.tolist()], None, fill=INK, weight=0, level=SLOT)


def centre_of_mass(board: Board, at: complex) -> None:
    """A circle with two opposite quarters filled."""
    board.circle(at, 0.8, Pen("POINTS", 0.18), level=PINS)
    for quarter in (0, np.pi):
        arc = at + 0.8 * board.mu * np.exp(1j * (quarter + np.linspace(0, np.pi / 2, 8)))
        board.area([at, *arc.tolist()], None, fill=INK, weight=0, level=PINS + 1)


def cross(board: Board, at: complex) -> None:
    """A point of the frame that nothing turns about."""
    reach = 0.9 * board.mu
    board.lines([(at - reach, at + reach), (at - 1j * reach, at + 1j * reach)], Pen("POINTS", 0.25), level=PINS)
