"""Where the lines of words begin, and the room that they take on paper."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.lettering import LEADING, extent, width
from tmmcalc.report.drawing.shapes import Words


def rows(words: Words) -> Iterator[tuple[complex, str]]:
    """The lines of words with the place where the baseline of each begins."""
    texts, along = words.text.split("\n"), np.exp(1j * words.turn)
    _, low, high = _sizes(words)
    first = -high if words.align.imag > 0 else -low if words.align.imag < 0 else -(low + high) / 2
    for k, text in enumerate(texts):
        start = -(words.align.real + 1) / 2 * width(text, words.height)
        yield complex(words.at + along * (start + 1j * (first - k * LEADING * words.height))), text


def corners(words: Words) -> Plane:
    """The corners (4,) of the box that the letters fill, counter-clockwise from the lower left."""
    wide, low, high = _sizes(words)
    left = -(words.align.real + 1) / 2 * wide
    if words.align.imag > 0:
        low, high = low - high, 0.0
    elif words.align.imag < 0:
        low, high = 0.0, high - low
    else:
        low, high = (low - high) / 2, (high - low) / 2
    box = np.array([left + 1j * low, left + wide + 1j * low, left + wide + 1j * high, left + 1j * high])
    return np.asarray(words.at + np.exp(1j * words.turn) * box)


def _sizes(words: Words) -> tuple[float, float, float]:
    """Width, and the lowest and highest place of letters from the baseline of the first line."""
    above, below = extent(words.text, words.height)
    return width(words.text, words.height), -below - words.text.count("\n") * LEADING * words.height, above
