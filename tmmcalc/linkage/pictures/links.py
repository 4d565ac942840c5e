"""A moving link with main lines: plate, slots, bars, slider blocks, filled corners."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import combinations

from tmmcalc.linkage.pictures.bodies import LinkOutline, Segment
from tmmcalc.linkage.pictures.cycle import LinkageMotion
from tmmcalc.report.drawing import signs
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import MIDDLE, PLATE, THICK

SHARP = 0.05  # sine of an angle below which two bars are one line


def draw_link(board: Board, body: LinkOutline, motion: LinkageMotion, k: int = 0) -> None:
    """Draw a link in the k-th position of the motion."""
    turn = complex(motion.turn(body.link)[k])

    def placed(points: tuple[complex, ...]) -> list[complex]:
        return [complex(motion.place(body.link, p)[k]) for p in points]

    if body.plate:
        board.area(placed(body.plate), MIDDLE, fill=PLATE, level=signs.PLATE)  # no support is hidden by it
    for slot in body.slots:
        board.line(placed(slot), THICK, level=signs.SLOT)
    for bar in body.bars:
        board.line(placed(bar), THICK, level=signs.LINK)
    for block in body.blocks:
        signs.block(board, placed((block.centre,))[0], block.direction * turn)
    for at, first, second in corners_of(body):
        signs.weld(board, placed((at,))[0], first * turn, second * turn)


def corners_of(body: LinkOutline) -> Iterator[tuple[complex, complex, complex]]:
    """Where two bars of a link meet at an angle: the point, and the directions of both from there."""
    lines: tuple[Segment, ...] = (*body.bars, *body.slots)
    for one, other in combinations(lines, 2):
        for at in (*one, *other):
            ends = [_far_end(at, segment) for segment in (one, other)]
            if all(end is not None for end in ends):
                first, second = (end - at for end in ends if end is not None)
                if abs(math.sin(cmath.phase(second / first))) > SHARP:
                    yield at, first / abs(first), second / abs(second)
                break


def _far_end(at: complex, segment: Segment) -> complex | None:
    """The end of a segment farther from a point that lies on it; None if the point lies off it."""
    a, b = segment
    t = ((at - a) / (b - a)) if a != b else 1j
    if abs(t.imag) > 1e-6 or not -1e-6 <= t.real <= 1 + 1e-6:
        return None
    return max(segment, key=lambda p: abs(p - at))
