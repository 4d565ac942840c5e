"""The picture of a manipulator: points equally spaced in time, phases in two colours, obstacle, arm."""

from __future__ import annotations

import numpy as np
import pytest
from paper import curves, of_words, on_sheet, written

from tmmcalc.manipulators.pictures.manipulator import EVEN, FILL, RAMP, manipulator_drawing
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import Obstacle
from tmmcalc.report.drawing.shapes import Arc, Area

from .scenes import task

BOX = Obstacle("press", (0.85 + 0.65j, 1.05 + 0.65j, 1.05 + 0.85j, 0.85 + 0.85j))


def test_the_path_in_the_plane() -> None:
    asked = task("spherical", "arc", (BOX,), steps=16)
    result = solve_manipulator(asked)
    drawing = manipulator_drawing(asked, result)
    board = drawing.fields[0]
    paths = {pen: curves(board, pen) for pen in (RAMP, EVEN)}
    assert [len(found) for found in paths.values()] == [2, 1]
    colours = {RAMP.colour, EVEN.colour}
    dots = [shape for shape in drawing.shapes if isinstance(shape, Arc) and shape.pen.colour in colours]
    assert len(dots) == 17
    equal = np.array([k for k, label in enumerate(result.labels) if label.isdigit()])
    places = sorted((board.data(dot.centre) for dot in dots), key=lambda z: (z.real, z.imag))
    hand = result.gripper[0, 0] + 1j * result.gripper[0, 1]
    expected = sorted(hand[equal].tolist(), key=lambda z: (z.real, z.imag))
    np.testing.assert_allclose(places, expected, atol=1e-9)
    assert np.ptp(np.diff(result.t[equal])) < 1e-12
    (even,) = paths[EVEN]
    law, radius = result.legs[0].law, result.legs[0].pieces[0].radius
    chord = np.abs(np.diff(even))
    assert np.sum(2 * radius * np.arcsin(chord / (2 * radius))) == pytest.approx(law.uniform_travel, rel=1e-9)
    (zone,) = [shape for shape in drawing.shapes if isinstance(shape, Area) and shape.fill == FILL]
    np.testing.assert_allclose([board.data(complex(at)) for at in zone.points], BOX.corners, atol=1e-9)
    assert {"press", "start", "end"} <= set(written(drawing))
    assert not on_sheet(drawing)


@pytest.mark.slow
def test_two_views_in_space() -> None:
    asked = task("elbow up, base", "rounded")
    drawing = manipulator_drawing(asked, solve_manipulator(asked))
    titles = {words.text: words.at.real for words in of_words(drawing)}
    assert titles["from above"] < titles["in the plane of the arm"]
