"""The picture of a manipulator: points equally spaced in time, phases in two colours, obstacle, arm."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from tmmcalc.manipulators.pictures.manipulator import EVEN, RAMP, manipulator_figure
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import Obstacle

from .scenes import task

BOX = Obstacle("press", (0.85 + 0.65j, 1.05 + 0.65j, 1.05 + 0.85j, 0.85 + 0.85j))


def test_the_path_in_the_plane() -> None:
    asked = task("spherical", "arc", (BOX,), steps=16)
    result = solve_manipulator(asked)
    figure = manipulator_figure(asked, result)
    axes = figure.axes[0]
    lines = {
        color: [line for line in axes.lines if line.get_color() == color] for color in (RAMP["color"], EVEN["color"])
    }
    paths = {color: [line for line in found if line.get_marker() == "None"] for color, found in lines.items()}
    dots = [line for found in lines.values() for line in found if line.get_marker() == "o"]
    assert [len(found) for found in paths.values()] == [2, 1]
    assert len(dots) == 17
    equal = np.array([k for k, label in enumerate(result.labels) if label.isdigit()])
    places = {(round(float(dot.get_xdata()[0]), 9), round(float(dot.get_ydata()[0]), 9)) for dot in dots}
    assert places == {tuple(np.round(result.gripper[0, :, k], 9).tolist()) for k in equal}
    assert np.ptp(np.diff(result.t[equal])) < 1e-12
    (even,) = paths[EVEN["color"]]
    law, radius = result.legs[0].law, result.legs[0].pieces[0].radius
    chord = np.hypot(np.diff(even.get_xdata()), np.diff(even.get_ydata()))
    assert np.sum(2 * radius * np.arcsin(chord / (2 * radius))) == pytest.approx(law.uniform_travel, rel=1e-9)
    (zone,) = axes.patches
    assert zone.get_xy()[:4] == pytest.approx(np.array([[c.real, c.imag] for c in BOX.corners]))
    assert {"press", "start", "end"} <= {text.get_text() for text in axes.texts}


@pytest.mark.slow
def test_two_views_in_space() -> None:
    asked = task("elbow up, base", "rounded")
    figure = manipulator_figure(asked, solve_manipulator(asked))
    assert [axes.get_title() for axes in figure.axes[:2]] == ["from above", "in the plane of the arm"]
