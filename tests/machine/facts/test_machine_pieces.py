"""What of the machine stands on the sheet of forces: standard scales, and curves that are read back from the paper."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from machines import MOTOR, spec_text
from paper import covered, curves, of_words, on_sheet, written

from tmmcalc.api import run
from tmmcalc.core.stage import STAGES, resolve
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.project import load_spec, parse_spec
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.scales import STEPS
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import speaking
from tmmcalc.report.sheets.piece import Piece

STAGES_WITH = ("reduction", "flywheel", "motion", "balance")
BORDER = 3.0  # around a piece that is drawn alone [mm]


@pytest.fixture(scope="module")
def order(tmp_path_factory: pytest.TempPathFactory) -> Order:
    """A press with its motor, solved."""
    file = tmp_path_factory.mktemp("pieces") / "press.toml"
    file.write_text(spec_text(MOTOR))
    spec = load_spec(file)

    def never(*_: Any) -> Any:
        raise AssertionError

    return Order(spec, run(spec).results, NONE, never, parse_spec)


def pieces(order: Order, stage: str) -> list[Piece]:
    picture = STAGES[stage].picture
    assert picture is not None
    found: Iterator[Piece] = resolve(picture.pieces)(order)
    return list(found)


def alone(piece: Piece, size: tuple[float, float]) -> Drawing:
    """The piece on a paper of its own, a border around it."""
    wide, high = size
    drawing = Drawing(wide + 2 * BORDER, high + 2 * BORDER)
    piece.draw(drawing, Box(BORDER, BORDER, BORDER + wide, BORDER + high))
    return drawing


def scale(field: Diagram) -> tuple[float, float]:
    a, b = field.data(0j), field.data(1 + 1j)
    return abs(b.real - a.real), b.imag - a.imag


def is_standard(mu: float) -> bool:
    digits = mu / 10 ** math.floor(math.log10(mu) + 1e-9)
    return min(abs(digits - step) for step in STEPS) < 1e-8


@pytest.mark.parametrize("language", ["en", "uk"])
@pytest.mark.parametrize("stage", STAGES_WITH)
def test_pieces_are_drawn_to_standard_scales_in_their_room(order: Order, stage: str, language: str) -> None:
    with speaking(language):
        found = pieces(order, stage)
        assert found
        for piece in found:
            assert piece.sheet == "forces"
            assert piece.heading.isascii() == (language == "en")
            assert all(least <= good for least, good in zip(piece.least, piece.good, strict=True))
            for size in (piece.least, piece.good):
                drawing = alone(piece, size)
                assert on_sheet(drawing) == []
                assert covered(drawing, 0.4) == []
                assert min(words.height for words in of_words(drawing)) >= 1.5
                for field in drawing.fields:
                    assert isinstance(field, Diagram)
                    assert all(map(is_standard, scale(field))), (piece.heading, scale(field))
                assert any("$μ_{" in text for text in written(drawing))


def test_the_headings_say_what_the_sheet_asks_for(order: Order) -> None:
    found = [piece.heading for stage in STAGES_WITH for piece in pieces(order, stage)]
    assert found == [
        "Reduced moments, works, excess energy, reduced inertia",
        "Energy-mass curve",
        "Excess work by Mertsalov and Artobolevsky",
        "Angular speed of the input link",
        "Characteristic of the motor and its working part",
        "Shaking force before and after balancing",
    ]


def test_works_are_the_integrals_of_the_moments_that_are_drawn(order: Order) -> None:
    """By the trapezoid rule on the points of the paper; both works close the cycle, their sum is the energy."""
    (piece,) = pieces(order, "reduction")
    moments, works, energy, inertia = alone(piece, piece.good).fields
    (load,), (drive,) = (curves(moments, pen) for pen in CURVES[:2])
    (done,), (given,) = (curves(works, pen) for pen in CURVES[:2])
    (excess,) = curves(energy, CURVES[2])
    phi = np.radians(load.real)
    for moment, work in ((load, done), (drive, given)):
        by_hand = np.append(0.0, np.cumsum(np.diff(phi) * (moment.imag[1:] + moment.imag[:-1]) / 2))
        assert work.imag == pytest.approx(by_hand, abs=2e-3 * np.ptp(work.imag))
    assert done.imag + given.imag == pytest.approx(excess.imag, abs=1e-9 * np.ptp(done.imag))
    assert excess.imag[-1] == pytest.approx(0.0, abs=1e-9 * np.ptp(excess.imag))
    picture = order.results["flywheel"].picture
    assert np.interp(phi, picture.theta, picture.work) == pytest.approx(excess.imag, abs=1e-2 * np.ptp(excess.imag))
    (links,) = curves(inertia, CURVES[0])
    assert links.imag[0] == pytest.approx(order.results["reduction"].inertia[0], rel=1e-9)


def test_the_speed_that_is_drawn_is_that_of_the_regime(order: Order) -> None:
    speed, motor = pieces(order, "motion")
    (field,) = alone(speed, speed.good).fields
    (loaded,) = curves(field, CURVES[0])
    regime = order.results["motion"].regime
    assert loaded.imag.max() == pytest.approx(regime.omega_max, rel=1e-4)
    assert regime.omega_at(np.radians(loaded.real)) == pytest.approx(loaded.imag, rel=1e-9)
    near, whole = alone(motor, motor.good).fields
    assert near.x.low < regime.omega_min < regime.omega_max < near.x.high
    assert whole.x.low == 0.0


def test_the_shaking_force_before_and_after(order: Order) -> None:
    (piece,) = pieces(order, "balance")
    result = order.results["balance"].linkage
    first = alone(piece, piece.good).fields[0]
    (before,) = curves(first, CURVES[0])
    (after,) = curves(first, CURVES[1])
    assert before.imag.max() == pytest.approx(result.shaking.size.largest, rel=1e-4)
    assert after.imag.max() == pytest.approx(result.schemes[0].balance.after.largest, rel=1e-4)
    assert math.sqrt(np.mean(after.imag[:-1] ** 2)) < math.sqrt(np.mean(before.imag[:-1] ** 2))


def test_a_slider_that_drives_has_forces_and_a_mass(tmp_path: Path) -> None:
    """Of a range that does not close there is no constant moment: force, work and mass alone."""
    spec = load_spec(Path(__file__).parents[3] / "configs" / "hydraulic-lift.toml")
    (piece,) = pieces(Order(spec, run(spec).results, NONE, lambda _: None, parse_spec), "reduction")
    drawing = alone(piece, piece.good)
    force, work, mass = drawing.fields
    assert isinstance(mass, Diagram)
    assert mass.x.name.startswith("$s")
    (drawn,), (done,) = curves(force, CURVES[0]), curves(work, CURVES[0])
    factors = [1e3 if "k" in field.y.name else 1.0 for field in (force, work)]
    by_hand = np.sum(np.diff(drawn.real) * 1e-3 * (drawn.imag[1:] + drawn.imag[:-1]) / 2) * factors[0]
    assert done.imag[-1] * factors[1] == pytest.approx(by_hand, rel=1e-3)
