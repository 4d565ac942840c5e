"""Numbers along the axes of diagrams."""

from __future__ import annotations

from itertools import pairwise

import pytest

from tmmcalc.report.drawing.diagram import HEIGHT, Axis, across, written
from tmmcalc.report.drawing.lettering import width


@pytest.mark.parametrize("ends", [(0.65754, 0.65856), (12932.4, 12944.6), (0.0, 360.0), (-1.23e-4, 4.5e-4)])
@pytest.mark.parametrize("wide", [70.0, 120.0, 261.0])
def test_numbers_of_an_abscissa_do_not_touch(ends: tuple[float, float], wide: float) -> None:
    low, high = ends
    marks = across(Axis("", low, high), wide)
    assert len(marks) >= 2
    longest = max(width(written(mark, marks), HEIGHT) for mark in marks)
    nearest = min(b - a for a, b in pairwise(marks)) * wide / (high - low)
    assert longest < nearest


def test_there_are_as_many_as_have_room() -> None:
    assert across(Axis("", 0.0, 10.0), 120.0) == [float(k) for k in range(11)]
