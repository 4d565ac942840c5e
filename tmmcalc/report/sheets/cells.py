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


def filled_in(drawing: Drawing, cell: Box, text: str, *, height: float = 7.0, align: complex = 0j) -> None:
    """What a user gave, in one or several lines, no higher than this, in the middle of a cell or from its left."""
    if not text.strip():
        return
    words = plain(text)
    sizes = [size for size in HEIGHTS if size <= height]
    for size in sizes:
        lines = wrapped(words, cell.width - 2 * AIR, size)
        if width("\n".join(lines), size) <= cell.width - 2 * AIR and _tall(len(lines), size) <= cell.height - 2 * AIR:
            break
    lines = lines if _tall(len(lines), size) <= cell.height - 2 * AIR else [words]
    size *= min(1.0, (cell.width - 2 * AIR) / width("\n".join(lines), size))
    at = complex(cell.left + AIR if align.real < 0 else cell.middle.real, cell.middle.imag)
    drawing.add(Words(at, "\n".join(lines), size, complex(align.real, 0)))


def _tall(lines: int, size: float) -> float:
    return size * (1.0 + LEADING * (lines - 1))
