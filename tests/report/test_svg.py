"""Drawings as SVG, read back: lines and places as they were drawn, in few bytes."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.pens import CURVES, GRID, THIN
from tmmcalc.report.drawing.shapes import Arc, Area, Drawing, Shape, Stroke, Words
from tmmcalc.report.drawing.svg import svg

HIGH = 100.0
NUMBER = re.compile(r"-?(?:\d+\.?\d*|\.\d+)")
RANDOM = np.random.default_rng(4)


def drawn(*shapes: Shape) -> list[ElementTree.Element]:
    """The elements of a drawing of these shapes, without the sheet of paper."""
    drawing = Drawing(120.0, HIGH)
    drawing.add(*shapes)
    (group,) = (each for each in ElementTree.fromstring(svg(drawing)) if each.tag.endswith("}g"))
    return [*group]


def lines(path: str) -> list[Plane]:
    """The lines of a path, upwards from the lower edge of the paper, by the rules of SVG for M, l, h, v and z."""
    found: list[list[complex]] = []
    for letter, text in re.findall(r"([Mlhvz])([^A-Za-z]*)", path):
        numbers = [float(each) for each in NUMBER.findall(text)]
        if letter == "M":
            found.append([complex(*numbers)])
        elif letter == "l":
            for x, y in zip(numbers[::2], numbers[1::2], strict=True):
                found[-1].append(found[-1][-1] + complex(x, y))
        elif letter in "hv":
            for step in numbers:
                found[-1].append(found[-1][-1] + step * (1.0 if letter == "h" else 1j))
        else:
            found[-1].append(found[-1][0])
    return [np.conj(np.array(each)) + 1j * HIGH for each in found]


def test_a_long_line_of_short_steps_does_not_drift() -> None:
    points = np.cumsum(RANDOM.normal(0.0, 0.3, 2000) + 1j * RANDOM.normal(0.0, 0.3, 2000)) + 60 + 50j
    (element,) = drawn(Stroke(points, CURVES[0]))
    (found,) = lines(element.attrib["d"])
    assert len(found) > 1990  # those a hundredth of a millimetre apart may be one
    assert abs(found[-1] - points[-1]) < 0.008
    assert max(np.min(np.abs(found - point)) for point in points) < 0.008
    assert len(element.attrib["d"]) < 10 * len(points)


def test_lines_of_one_pen_are_one_path_as_long_as_nothing_comes_between() -> None:
    across = [Stroke(np.array([10 + 1j * y, 90 + 1j * y]), GRID) for y in (10, 20, 30)]
    square = Stroke(np.array([1, 2, 2 + 1j, 1 + 1j]) + 0j, THIN, closed=True)
    part = Arc(50 + 50j, 10.0, THIN, 0.0, np.pi / 2)
    elements = drawn(*across, square, part, across[0])
    assert [each.attrib["class"] for each in elements] == ["grid", "thin", "grid"]
    assert lines(elements[0].attrib["d"])[1] == pytest.approx([10 + 20j, 90 + 20j])
    outline, begun = lines(elements[1].attrib["d"].replace("a", "z"))[:2]
    assert outline == pytest.approx([1, 2, 2 + 1j, 1 + 1j, 1])
    assert begun[0] == pytest.approx(60 + 50j)
    assert elements[1].attrib["d"].endswith("a10 10 0 0 0 -10-10")  # a quarter, upwards to the left


def test_a_dot_of_one_point_is_seen() -> None:
    (element,) = drawn(Stroke(np.array([5 + 5j, 5 + 5j]), THIN))
    assert element.attrib["d"] == "M5 95h0"


def test_areas_and_circles_keep_their_own_element() -> None:
    corner = np.array([0, 2, 2j]) + 5 + 5j
    circle = Arc(20 + 20j, 1.5, THIN, fill="#ffffff")
    areas = Area(corner, "#123456"), Area(corner + 9, "#123456", THIN)
    first, second, ring, empty = drawn(*areas, circle, Arc(20 + 20j, 3.0, THIN))
    assert (first.get("class"), second.get("class"), first.get("fill")) == (None, "thin", "#123456")
    assert [ring.get(key) for key in ("cx", "cy", "r", "fill")] == ["20", "80", "1.5", "#ffffff"]
    assert empty.get("fill") is None


def test_words_have_their_colour_and_letters_their_places() -> None:
    black, blue = drawn(Words(10 + 10j, "one", 3.0), Words(10 + 20j, "$x_1$ is 2", 3.0, colour="#0072b2"))
    assert (black.text, black.get("style"), black.get("lengthAdjust")) == ("one", None, "spacingAndGlyphs")
    assert blue.get("style") == "fill:#0072b2"  # a rule of the sheet, for text in black, would hide an attribute
    assert [each.text for each in blue] == ["x", "1", " is 2"]
    places = [float(each.attrib["x"]) for each in blue]
    assert places == sorted(places)
