"""The graphical integration of a law: its error, how it falls, and the construction read back from paper."""

from __future__ import annotations

import re
from math import radians

import numpy as np
import pytest
from paper import inside, on_sheet, written
from scipy.integrate import cumulative_trapezoid

from cams.turns import task_of, turn
from tmmcalc.cams.lawresult import solve_law
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.graphical import constructed
from tmmcalc.cams.laws.law import polynomial
from tmmcalc.cams.pictures.integration import CHORD, INTERVALS, RAY, draw_integration
from tmmcalc.cams.program import Phase, Program
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.shapes import Arc, Dimension, Drawing, Stroke
from tmmcalc.report.language import speaking

STROKE = 0.02
ROUGH = polynomial("two parts", (0.0, [0, 0, 1.5]), (1 / 3, [1 / 6, 1, -0.75]))  # y'' jumps at a third


def rough():
    """A rise whose y'' jumps between equal intervals."""
    phases = (
        Phase("rise", radians(90), 0.0, STROKE, ROUGH),
        Phase("return", radians(90), STROKE, 0.0, ROUGH),
        Phase("low dwell", radians(180), 0.0, 0.0),
    )
    return Program(phases)


@pytest.mark.parametrize("law", sorted(LAWS))
def test_the_construction_is_as_near_as_it_says_and_nears_the_law_with_the_square(law):
    program = turn(law, "shun", stroke=STROKE)
    told = []
    for count in (16, 32):
        made = constructed(program, count)
        moving = [strip for strip in made.strips if len(strip.phi) > 2]
        assert [len(strip.bend) for strip in moving] == [count, count]
        phi = np.concatenate([strip.phi for strip in moving])
        exact = program.at(phi)
        slopes, places = (np.concatenate([getattr(strip, name) for strip in moving]) for name in ("slope", "place"))
        dense = np.linspace(0, program.starts[-1], 21601)
        peak = np.max(np.abs(program.at(dense)[1]))
        assert np.max(np.abs(slopes - exact[1])) / peak == pytest.approx(made.slope_error, rel=1e-6, abs=1e-12)
        assert np.max(np.abs(places - exact[0])) / STROKE == pytest.approx(made.place_error, rel=1e-9, abs=1e-12)
        told.append((made.slope_error, made.place_error))
    for coarse, fine in zip(*told, strict=True):
        assert fine < 0.01
        assert 3.6 < coarse / fine < 4.6


def test_it_is_the_integral_of_steps():
    """Steps as high as the middles, summed up by another's trapezoids on a fine grid."""
    made = constructed(turn("shun", stroke=STROKE), 8)
    (strip,) = made.strips[:1]
    fine = np.linspace(strip.phi[0], strip.phi[-1], 80001)
    steps = strip.bend[np.minimum(np.searchsorted(strip.phi, fine, side="right") - 1, 7)]
    slope = cumulative_trapezoid(steps, fine, initial=0)
    place = cumulative_trapezoid(slope, fine, initial=0)
    np.testing.assert_allclose(np.interp(strip.phi, fine, slope), strip.slope, atol=1e-4 * np.max(np.abs(strip.slope)))
    np.testing.assert_allclose(np.interp(strip.phi, fine, place), strip.place, atol=1e-4 * STROKE)


def test_an_ordinate_stands_where_the_acceleration_jumps():
    """Else the error would fall with the interval alone."""
    made = constructed(rough(), 8)
    assert np.min(np.abs(made.strips[0].phi - radians(30))) < 1e-9
    assert len(made.strips[0].bend) == 9
    assert made.slope_error < 1e-9  # constant pieces are integrated exactly
    assert made.strips[1].first == 9


def drawn(kind="translating", law="sine", size=(270.0, 200.0)):
    stroke = radians(25) if kind == "oscillating" else STROKE
    task = task_of(turn(law, "shun", stroke=stroke), kind)
    result, made = solve_law(task), constructed(task.program, INTERVALS)
    drawing = Drawing(*size)
    fields = draw_integration(drawing, Box(0, 0, *size), task.program, result, made)
    return drawing, fields, made, result


@pytest.mark.parametrize("kind", ["translating", "oscillating"])
def test_chords_are_parallel_to_the_rays(kind):
    """On paper: every chord of S' has the slope of a ray of S'', and every chord of S that of a ray of S'."""
    drawing, fields, made, _ = drawn(kind)
    assert not on_sheet(drawing)
    strokes = [shape for shape in drawing.shapes if isinstance(shape, Stroke)]
    for above, below in ((fields[0], fields[1]), (fields[1], fields[2])):
        rays = [stroke.points for stroke in strokes if stroke.pen == RAY and inside(stroke.points, above.box)]
        slopes = np.array([(tip - pole).imag / (tip - pole).real for pole, tip in rays])
        chords = [stroke.points for stroke in strokes if stroke.pen == CHORD and inside(stroke.points, below.box)]
        assert len(chords) == len(made.strips)
        own = np.concatenate([np.diff(z).imag / np.diff(z).real for z in chords])
        assert len(own) == sum(len(strip.bend) for strip in made.strips)
        assert np.max(np.min(np.abs(own[:, None] - slopes), axis=1)) < 1e-9
        assert np.max(np.min(np.abs(own[:, None] - slopes), axis=0)) < 1e-9  # and no ray is idle


def test_rays_go_to_the_ordinates_in_the_middle_of_the_intervals():
    drawing, fields, made, _ = drawn()
    tips = [
        s.points[1].imag
        for s in drawing.shapes
        if isinstance(s, Stroke) and s.pen == RAY and inside(s.points, fields[0].box)
    ]
    dots = [a.centre for a in drawing.shapes if isinstance(a, Arc) and a.radius == 0.35]
    upper = sorted((z for z in dots if z.imag > fields[0].box.bottom), key=lambda z: z.real)
    middles = np.degrees(np.concatenate([(strip.phi[1:] + strip.phi[:-1]) / 2 for strip in made.strips]))
    np.testing.assert_allclose([fields[0].data(z).real for z in upper], middles, atol=1e-9)
    assert np.max(np.min(np.abs(np.array(tips)[:, None] - [z.imag for z in upper]), axis=1)) < 1e-9


@pytest.mark.parametrize("kind", ["translating", "oscillating"])
def test_the_written_scale_factors_measure_the_drawing(kind):
    """Heights in mm times the factors are the stroke and the largest S', to the error that is told."""
    drawing, fields, made, result = drawn(kind)
    line = next(text for text in written(drawing) if "$H_1$ = " in text)
    degrees_to_mm, rad, bend, slope, place = map(float, re.findall(r"= ([\d.]+)", line))
    assert rad == pytest.approx(radians(degrees_to_mm), rel=1e-3)
    dimensions = [shape for shape in drawing.shapes if isinstance(shape, Dimension)]
    poles = [float(each.text.rpartition(" = ")[2]) for each in dimensions]
    assert poles == pytest.approx([abs(each.second - each.first) for each in dimensions])
    assert slope == pytest.approx(bend * rad * poles[0], rel=1e-3)
    assert place == pytest.approx(slope * rad * poles[1], rel=1e-3)
    unit = 1.0 if kind == "oscillating" else 1e3
    chords = [s.points for s in drawing.shapes if isinstance(s, Stroke) and s.pen == CHORD]
    for field, factor, exact, error in (
        (fields[1], slope, max(e.value for e in result.extremes if e.order == 1), made.slope_error),
        (fields[2], place, result.stroke, made.place_error),
    ):
        zero = field.place(0j).imag
        top = max(float(z.imag.max()) for z in chords if inside(z, field.box))
        assert (top - zero) * factor == pytest.approx(unit * exact, rel=1.5 * error + 1e-3)
    said = next(text for text in written(drawing) if "%" in text)
    percents = [float(value) for value in re.findall(r"([\d.]+) %", said)]
    assert percents == pytest.approx([100 * made.slope_error, 100 * made.place_error], rel=1e-2)


def test_it_speaks_ukrainian():
    with speaking("uk"):
        drawing, *_ = drawn()
    assert any(text.startswith("Похибка побудови") for text in written(drawing))
    assert not any("mm" in text for text in written(drawing))
