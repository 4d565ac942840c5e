"""Numbers and units as people write them."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from tmmcalc.classroom.answers.figures import NoNumberError, read_number
from tmmcalc.classroom.answers.measures import UnitOfAnswerError, factor_to, in_unit

NUMBERS = {
    "1,25": ("1.25", "0.01", 3, ""),
    "1 250,5": ("1250.5", "0.1", 5, ""),
    "1\u2009250\u202f000": ("1250000", "1", 7, ""),
    "12\u00a0500,0 Н": ("12500", "0.1", 6, "Н"),
    "\u22120,05 рад/с": ("-0.05", "0.01", 1, "рад/с"),
    "1.2e3": ("1200", "100", 2, ""),
    "1,2\u00b710^3": ("1200", "100", 2, ""),
    "1,20\u00b710³ мм": ("1200", "10", 3, "мм"),
    "1,2*10^(-3)": ("0.0012", "0.0001", 2, ""),
    "1,2х10⁻³": ("0.0012", "0.0001", 2, ""),
    "1,2Е3": ("1200", "100", 2, ""),
    "0.1667e4": ("1667", "1", 4, ""),
    "1,234.5": ("1234.5", "0.1", 5, ""),
    "1.234,5": ("1234.5", "0.1", 5, ""),
    "+.5": ("0.5", "0.1", 1, ""),
    "≈ 30°": ("30", "1", 2, "°"),
    "2.50": ("2.5", "0.01", 3, ""),
    "12 1/s": ("12", "1", 2, "1/s"),
    "20°38'": ("619/30", "1/60", 4, "deg"),
    "−20° 38′ 15″": ("-4953/240", "1/3600", 5, "deg"),
    "20 º 38’ 15,5''": ("148591/7200", "1/36000", 6, "deg"),
    "0°30,0`": ("0.5", "1/600", 3, "deg"),
    "0°0'": ("0", "1/60", 0, "deg"),
}


@pytest.mark.parametrize("text", NUMBERS)
def test_a_number_is_read_with_its_figures(text: str) -> None:
    value, step, figures, unit = NUMBERS[text]
    read = read_number(text)
    assert (read.value, read.step, read.figures, read.unit) == (Fraction(value), Fraction(step), figures, unit)


NONE = ["", "abc", "=1+1", "+A1", "-SUM(A1)", "@x", "12 50", "1,2;3", "1..2", "12/5", "1.5±0.1", "½", "nan", "inf"]


@pytest.mark.parametrize(
    "text", [*NONE, "1e999", "9" * 100, "1,23,4", "20°60'", "20°10,5'3\"", "1 - 2", "=cmd|' /C calc'!A0"]
)
def test_what_is_no_number_is_told(text: str) -> None:
    with pytest.raises(NoNumberError):
        read_number(text)


RATIOS = [
    ("мм", "m", 1e-3),
    ("см", "mm", 10.0),
    ("М", "mm", 1000.0),
    ("об/хв", "rad/s", math.pi / 30),
    ("об./хв.", "rad/s", math.pi / 30),
    ("RPM", "rad/s", math.pi / 30),
    ("хв⁻¹", "rpm", 1.0),
    ("с⁻¹", "rad/s", 1.0),
    ("с-1", "rad/s", 1.0),
    ("1/с", "rad/s", 1.0),
    ("c^-1", "rad/s", 1.0),  # a Latin c
    ("рад/с", "rpm", 30 / math.pi),
    ("рад/с²", "rad/s^2", 1.0),
    ("с⁻²", "rad/s^2", 1.0),
    ("м/с2", "m/s^2", 1.0),
    ("град", "rad", math.pi / 180),
    ("°", "deg", 1.0),
    ("градусів", "deg", 1.0),
    ("Н·м", "N*m", 1.0),
    ("Нм", "N*m", 1.0),
    ("H", "N", 1.0),  # Latin letters for Cyrillic ones, wholly or in part
    ("kH", "N", 1000.0),
    ("к\u0048", "N", 1000.0),
    ("k\u041d", "N", 1000.0),
    ("MH", "kN", 1000.0),
    ("H*м", "N*m", 1.0),
    ("H·m", "kN*m", 1e-3),
    ("кH м", "N*m", 1000.0),
    ("кBт", "W", 1000.0),
    ("\u0441m", "mm", 10.0),
    ("об/xв", "rpm", 1.0),
    ("pад/c", "rad/s", 1.0),
    ("H/мм²", "MPa", 1.0),
    ("Н.м", "N*m", 1.0),
    ("кН м", "N*m", 1000.0),
    ("Nm", "kN*m", 1e-3),
    ("кг·м²", "kg*m^2", 1.0),
    ("кг*м2", "kg*m^2", 1.0),
    ("кВт", "W", 1000.0),
    ("Дж", "kJ", 1e-3),
    ("Н/мм²", "MPa", 1.0),
    ("[МПа]", "Pa", 1e6),
    ("%", "", 0.01),
    ("", "mm", 1.0),
    ("-", "", 1.0),
]


@pytest.mark.parametrize(("written", "asked", "ratio"), RATIOS)
def test_a_unit_of_any_spelling_counts(written: str, asked: str, ratio: float) -> None:
    assert factor_to(written, asked) == pytest.approx(ratio, rel=1e-14)


@pytest.mark.parametrize(
    ("written", "asked"),
    [("Н", "mm"), ("xyz", "mm"), ("мм", ""), ("x" * 500, "mm"), ("Н·м", "N"), ("H", "mm"), ("H", "")],
)
def test_a_unit_of_something_else_is_told(written: str, asked: str) -> None:
    with pytest.raises(UnitOfAnswerError):
        factor_to(written, asked)


def test_a_conversion_by_powers_of_ten_rounds_once() -> None:
    assert in_unit(Fraction("120.7"), factor_to("мм", "m")) == 0.1207
