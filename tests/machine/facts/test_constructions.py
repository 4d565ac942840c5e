"""Constructions of the flywheel: the paper measured with a ruler and a protractor against the exact numbers."""

from __future__ import annotations

import math

import numpy as np
import pytest
from machines import TURN, positions, sine
from paper import covered, curves, inside, of_words, on_sheet, written
from sparing import sparing

from machine.flywheel.scenes import press_cycle, upsetter_cycle
from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.methods import positional_flywheels
from tmmcalc.machine.flywheel.onpaper import LENGTH, artobolevsky, mertsalov, wittenbauer
from tmmcalc.machine.flywheel.wittenbauer import energy_mass
from tmmcalc.machine.flywheel.worked import round_scales
from tmmcalc.machine.pictures.constructions import (
    REST,
    draw_ordinates,
    machine_of,
    ordinates_sheet,
    wittenbauer_sheet,
)
from tmmcalc.machine.pictures.energymass import CURVE, FAST, SLOW, draw_energy_mass
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.scales import STEPS
from tmmcalc.report.drawing.shapes import Arc, Dimension, Drawing, Stroke
from tmmcalc.report.language import speaking

DELTA = 0.05
BOX = Box(7.0, 7.0, 290.0, 192.0)


def swinging(links: float, speed: float = 20.0) -> Cycle:
    """A load 100 sin(phi) N*m, links of the inertia links (1 + cos(2 phi)/2)."""
    on = panels(0.0, TURN)
    zero = np.zeros_like(on.x)
    inertia, slope = links * (1 + np.cos(2 * on.x) / 2), -links * np.sin(2 * on.x)
    return Cycle(on, inertia, slope, 100 * np.sin(on.x), zero, zero, speed)


CYCLES = [
    pytest.param(press_cycle(), id="press"),
    pytest.param(upsetter_cycle(), id="upsetter"),
    pytest.param(swinging(1.5), id="light links"),
    pytest.param(swinging(40.0), id="heavy links"),
    pytest.param(sine(100.0), id="none"),
]


def paper_curve(cycle: Cycle, sense: float = 1.0) -> Diagram:
    drawing = Drawing(297, 210)
    return draw_energy_mass(drawing, BOX, energy_mass(cycle, DELTA), sense)


def standard(mu: float) -> bool:
    digits = mu / 10 ** math.floor(math.log10(mu) + 1e-9)
    return min(abs(digits - step) for step in STEPS) < 1e-9


def scales_of(field: Diagram) -> tuple[float, float]:
    """Units of the axes to a mm, from two places on paper."""
    a, b = field.data(0j), field.data(1 + 1j)
    return b.real - a.real, b.imag - a.imag


def strokes(field: Diagram, layer: str) -> list[np.ndarray]:
    """Points on paper (n,) of the polylines of a layer inside the frame."""
    shapes = [each for each in field.drawing.shapes if isinstance(each, Stroke) and each.pen.layer == layer]
    return [each.points for each in shapes if inside(each.points, field.box)]


@pytest.mark.parametrize("cycle", CYCLES)
def test_angles_of_the_drawn_tangents(cycle: Cycle) -> None:
    """tan psi = omega^2 mu_J/(2 mu_A), on paper, along the line and by the arc, as it is written beside it."""
    field = paper_curve(cycle)
    mu_j, mu_a = scales_of(field)
    factor = 1e-3 if "kJ" in field.y.name else 1.0
    assert standard(mu_j)
    assert standard(mu_a)
    extreme = cycle.speed * (1 + DELTA / 2), cycle.speed * (1 - DELTA / 2)
    arcs = [each for each in field.drawing.shapes if isinstance(each, Arc) and not each.whole]
    assert len(arcs) == 2
    for omega, pen, arc, word in zip(extreme, (FAST, SLOW), arcs, ("max", "min"), strict=True):
        (line,) = strokes(field, pen.layer)
        wanted = math.atan(omega**2 * mu_j / (2 * mu_a / factor))
        along = line[-1] - line[0]
        assert math.atan2(along.imag, along.real) == pytest.approx(wanted, rel=1e-9)
        assert arc.end - arc.start == pytest.approx(wanted, rel=1e-9)
        assert f"$ψ_{{{word}}}$ = {math.degrees(wanted):.4g}°" in written(field.drawing)


@pytest.mark.parametrize("cycle", CYCLES)
def test_the_segment_by_its_scale_factor_gives_the_inertia(cycle: Cycle) -> None:
    field = paper_curve(cycle)
    _, mu_a = scales_of(field)
    (dimension,) = [each for each in field.drawing.shapes if isinstance(each, Dimension)]
    millimetres = abs(dimension.second - dimension.first)
    assert f"$GH$ = {millimetres:.4g} mm" in written(field.drawing)
    energy = millimetres * mu_a * (1e3 if "kJ" in field.y.name else 1.0)
    exact = positional_flywheels(cycle, 0.0, DELTA)[0]
    assert energy / (DELTA * cycle.speed**2) == pytest.approx(exact.inertia, rel=1e-9)


@pytest.mark.parametrize("cycle", CYCLES)
def test_what_is_drawn_lies_in_the_frame(cycle: Cycle) -> None:
    field = paper_curve(cycle)
    (curve,) = curves(field, CURVE)
    picture = energy_mass(cycle, DELTA)
    factor = 1e-3 if "kJ" in field.y.name else 1.0
    np.testing.assert_allclose(curve.real, picture.links, atol=1e-9 * np.max(picture.links, initial=1.0))
    np.testing.assert_allclose(curve.imag, picture.work * factor, atol=1e-9 * np.ptp(picture.work))
    assert on_sheet(field.drawing) == []
    assert field.labels.faults == []


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_wittenbauer_s_curve_is_made_of_the_diagrams_beside_it(sense: float) -> None:
    """Work on the left at the same heights, inertia above at the same places, one scale factor each."""
    cycle = press_cycle()
    picture = energy_mass(cycle, DELTA)
    machine = machine_of(picture, cycle, positions(24, sense)[1], DELTA)
    drawing = Drawing(297, 210)
    wittenbauer_sheet(drawing, BOX, machine)
    curve, work, inertia = drawing.fields
    (closed,), (over,), (turned,) = (strokes(each, CURVE.layer) for each in (curve, work, inertia))
    np.testing.assert_allclose(over.imag, closed.imag, atol=1e-9)
    np.testing.assert_allclose(turned.real, closed.real, atol=1e-9)
    mu_a, mu_j = round_scales(picture)
    assert scales_of(curve) == (pytest.approx(mu_j), pytest.approx(mu_a))
    degrees = np.degrees(picture.theta)
    np.testing.assert_allclose(curves(work, CURVE)[0].real, sense * degrees, atol=1e-9)
    np.testing.assert_allclose(curves(inertia, CURVE)[0].imag, degrees, atol=1e-9)
    assert on_sheet(drawing) == []


def test_the_links_are_taken_off_the_work() -> None:
    """100 (1 - cos phi) less 1.5 (1 + cos(2 phi)/2) 200, its excess in mm and by the scale factor."""
    cycle = swinging(1.5)
    machine = machine_of(energy_mass(cycle, DELTA), cycle, positions(24)[1], DELTA)
    drawing = Drawing(297, 210)
    mu_a, mu_j = draw_ordinates(drawing, BOX, machine)
    above, below = drawing.fields
    assert scales_of(above)[1] == pytest.approx(mu_a)
    assert scales_of(below)[1] == pytest.approx(mu_j)
    (rest,) = curves(above, REST)
    phi = np.radians(rest.real)
    assert rest.imag == pytest.approx(100 * (1 - np.cos(phi)) - 300 * (1 + np.cos(2 * phi) / 2), abs=1e-9)
    (dimension,) = [each for each in drawing.shapes if isinstance(each, Dimension)]
    excess = abs(dimension.second - dimension.first) * mu_a
    found = {each.method: each for each in positional_flywheels(cycle, 0.0, DELTA)}
    assert excess / (DELTA * cycle.speed**2) == pytest.approx(found["mertsalov"].inertia, rel=1e-9)
    assert f"$ΔT$ = {excess / mu_a:.1f} mm" in written(drawing)


@pytest.mark.parametrize("cycle", CYCLES[:4])
def test_readings_are_off_by_no_more_than_a_ruler_is(cycle: Cycle) -> None:
    picture = energy_mass(cycle, DELTA)
    machine = machine_of(picture, cycle, positions(24)[1], DELTA)
    mu_a, mu_j = scales = round_scales(picture)
    half, divisor = LENGTH / 2, DELTA * cycle.speed**2
    found = {each.method: each for each in positional_flywheels(cycle, 0.0, DELTA)}
    of_links = half * mu_j * 2 * cycle.speed**2 / 2
    for name, construction, most in (
        ("exact", wittenbauer(picture, scales, DELTA), half * mu_a),
        ("mertsalov", mertsalov(machine.rows["mertsalov_by_cycle"], mu_a), 2 * half * mu_a),
        (
            "artobolevsky",
            artobolevsky(machine.rows["artobolevsky_by_cycle"], scales, DELTA),
            2 * half * mu_a + of_links,
        ),
    ):
        assert construction.exact == pytest.approx(found[name].inertia, rel=1e-12)
        assert abs(construction.inertia - construction.exact) <= most / divisor * (1 + 1e-9)
        assert construction.inertia != construction.exact
        for each in construction.readings:
            assert each.read == pytest.approx(round(each.read, 1), abs=1e-9)


def test_a_sine_is_read_without_an_error() -> None:
    """200 J at 2 J/mm are 100 mm: J_F = 200/(0.05 20^2) = 10 kg*m^2."""
    picture = energy_mass(sine(100.0), DELTA)
    found = wittenbauer(picture, round_scales(picture), DELTA)
    segment, *_ = found.readings
    assert (segment.read, segment.value) == (pytest.approx(100.0), pytest.approx(200.0))
    assert found.inertia == pytest.approx(10.0, rel=1e-12)


@sparing("language", ["en", "uk"], every=2)
@pytest.mark.parametrize("cycle", CYCLES)
def test_sheets_are_clear(cycle: Cycle, language: str) -> None:
    with speaking(language):
        machine = machine_of(energy_mass(cycle, DELTA), cycle, positions(24)[1], DELTA)
        for sheet in (wittenbauer_sheet, ordinates_sheet):
            drawing = Drawing(297, 210)
            sheet(drawing, BOX, machine)
            assert on_sheet(drawing) == []
            assert covered(drawing, 0.4) == []
            assert all(words.height >= 1.6 for words in of_words(drawing))
