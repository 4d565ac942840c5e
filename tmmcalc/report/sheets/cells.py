"""Words in the cells of a title block: as large as the cell allows."""

from __future__ import annotations

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import LEADING, plain, width, wrapped
from tmmcalc.report.drawing.shapes import Drawing, Words

AIR = 0.8  # between words and the lines of a cell [mm]
HEIGHTS = (7.0, 5.0, 3.5, 2.5, 1.8)  # of lettering (ISO 3098, GOST 2.304) [mm]


def caption(drawing: Drawing, cell: Box, text: str, *, align: complex = 0j, height: float = 2.5) -> None:
    """A printed word of one line, smaller where the cell is narrow."""
    wide = width(text, height)
    size = height * min(1.0, (cell.width - 2 * AIR) / wide)
    at = complex((cell.left + AIR, cell.middle.real, cell.right - AIR)[int(align.real) + 1], cell.middle.imag)
    drawing.add(Words(at, text, size, align))


def filled_in(
    drawing: Drawing, cell: Box, text: str, *, height: float = 7.0, align: complex = 0j, most: int = 3
) -> None:
    """What a user gave, no higher and in no more lines than this, in the middle of a cell or at its left."""
    if not text.strip():
        return
    wide, high = cell.width - 2 * AIR, cell.height - 2 * AIR
    lines, size = [plain(text)], height
    for size in (each for each in HEIGHTS if each <= height):
        lines = wrapped(plain(text), wide, size)
        if len(lines) <= most and width("\n".join(lines), size) <= wide and _tall(len(lines), size) <= high:
            break
    else:
        lines = [plain(text)]
        size *= min(1.0, wide / width(lines[0], size))
    at = complex(cell.left + AIR if align.real < 0 else cell.middle.real, cell.middle.imag)
    drawing.add(Words(at, "\n".join(lines), size, complex(align.real, 0)))


def _tall(lines: int, size: float) -> float:
    return size * (1.3 + LEADING * (lines - 1))
