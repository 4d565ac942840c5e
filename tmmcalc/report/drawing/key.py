"""The key beside a drawing: headed lists of names and values, and samples of what lines mean."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Shape, Stroke, Words

LINE, GAP = 4.6, 2.4  # from line to line, and between lists [mm]
HEIGHT, HEADING = 2.3, 2.8
LEAST = 1.6  # names are not written smaller
INDENT, SAMPLE = 2.0, 10.0


@record
class Sample:
    """A short piece of a line, or a patch of a colour, with its meaning."""

    text: str
    line: Pen | str


@record
class Part:
    """A headed list."""

    heading: str
    rows: Sequence[tuple[str, str]] = ()
    samples: Sequence[Sample] = ()


def write_key(drawing: Drawing, box: Box, parts: Sequence[Part]) -> None:
    """Write the lists one under another from the top of a rectangle, smaller where they would not fit."""
    lines = sum(1.15 + len(part.rows) + len(part.samples) for part in parts)
    pitch = min(1.0, box.height / (lines * LINE + GAP * len(parts)))
    y = box.top - pitch * LINE / 2
    for part in parts:
        drawing.add(Words(complex(box.left, y), part.heading, pitch * HEADING, -1))
        y -= 1.15 * LINE * pitch
        for name, value in part.rows:
            room = box.width - INDENT - 2.0
            size = min(1.0, room / (width(name, HEIGHT) + width(value, HEIGHT))) * pitch * HEIGHT
            size = max(size, LEAST)
            drawing.add(Words(complex(box.left + INDENT, y), name, size, -1))
            drawing.add(Words(complex(box.right, y), value, size, 1))
            y -= LINE * pitch
        for sample in part.samples:
            room = box.width - INDENT - SAMPLE - 3.0
            fitted = max(LEAST / HEIGHT, min(pitch, room / width(sample.text, HEIGHT)))
            drawing.add(*_sample(sample, complex(box.left + INDENT, y), fitted))
            y -= LINE * pitch
        y -= GAP * pitch


def _sample(sample: Sample, at: complex, pitch: float) -> list[Shape]:
    words = Words(at + SAMPLE + 3.0, sample.text, pitch * HEIGHT, -1)
    if isinstance(sample.line, str):
        half = 1.3j * pitch
        corners = np.array([at - half, at + SAMPLE - half, at + SAMPLE + half, at + half])
        return [Area(corners, sample.line), words]
    return [Stroke(np.array([at, at + SAMPLE]), sample.line), words]


def samples_in_rows(drawing: Drawing, box: Box, samples: Sequence[tuple[str, Pen]], height: float = HEIGHT) -> None:
    """What lines mean, side by side in the middle of a rectangle, in as many rows as they need, from its top."""
    air = 5.0
    rows: list[list[tuple[str, Pen]]] = []
    at = np.inf
    for text, pen in samples:
        wide = SAMPLE + 1.5 + width(text, height) + air
        if at + wide - air > box.width:
            rows.append([])
            at = 0.0
        rows[-1].append((text, pen))
        at += wide
    for k, row in enumerate(rows):
        wide = sum(SAMPLE + 1.5 + width(text, height) + air for text, _ in row) - air
        here = complex(box.middle.real - wide / 2, box.top - height / 2 - 2 * height * k)
        for text, pen in row:
            drawing.add(Stroke(np.array([here, here + SAMPLE]), pen), Words(here + SAMPLE + 1.5, text, height, -1))
            here += SAMPLE + 1.5 + width(text, height) + air
