"""Lines of a drawing are told apart in black and white, and by the colour-blind."""

from __future__ import annotations

from itertools import combinations

import pytest

from tmmcalc.report.drawing.pens import CURVES, FORCES, PENS, VECTORS, Pen

WIDER = 0.15  # the least difference of widths that is seen on paper [mm]


def alike(one: Pen, other: Pen) -> bool:
    """Whether only colour tells them apart."""
    return one.dashes == other.dashes and abs(one.width - other.width) < WIDER - 1e-9


@pytest.mark.parametrize("family", [CURVES, tuple(VECTORS.values()), tuple(FORCES.values())])
def test_pens_of_a_family_differ_without_colours(family: tuple[Pen, ...]) -> None:
    assert [(a.layer, b.layer) for a, b in combinations(family, 2) if alike(a, b)] == []


@pytest.mark.parametrize("family", [CURVES, tuple(VECTORS.values()), tuple(FORCES.values())])
def test_every_pen_is_seen_on_white(family: tuple[Pen, ...]) -> None:
    """The luminance of sRGB leaves a contrast of 1.9 at least: light blue and yellow are dashed."""
    for pen in family:
        red, green, blue = (int(pen.colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
        linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in (red, green, blue)]
        luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
        assert 1.05 / (luminance + 0.05) > 1.9, pen.layer


def test_every_layer_has_one_pen() -> None:
    assert len({pen.layer for pen in PENS}) == len(PENS)
