"""The rounded tables of ISO 286 against the standard's formulas, and values of handbooks; ISO 2768."""

from __future__ import annotations

import itertools
import math

import pytest

from tmmcalc.design.tables.fits import GRADES, LOWER, STEPS, UPPER, WIDTHS, deviations, grade_width
from tmmcalc.design.tables.general import of_angle, of_length
from tmmcalc.spec.units import UnitError

UNITS = {5: 7, 6: 10, 7: 16, 8: 25, 9: 40, 10: 64, 11: 100, 12: 160, 13: 250, 14: 400, 15: 640, 16: 1000, 17: 1600,
         18: 2500}  # fmt: skip
MEANS = [math.sqrt(3), *(math.sqrt(low * high) for low, high in itertools.pairwise(STEPS))]  # [mm]


def unit(size: float, step: int) -> float:
    """i up to 500 mm, I beyond [um]."""
    return 0.45 * size ** (1 / 3) + 0.001 * size if step <= 500 else 0.004 * size + 2.1


@pytest.mark.parametrize("row", range(len(STEPS)))
def test_widths_are_the_formula_rounded(row: int) -> None:
    """Rounding of the standard is up to 6 %; of the first step, where it is coarse, half a micrometre to 16 %."""
    for grade, many in UNITS.items():
        exact = many * unit(MEANS[row], STEPS[row])
        assert WIDTHS[str(grade)][row] == pytest.approx(exact, rel=0.16 if row == 0 else 0.095)


def test_widths_grow_with_grade_and_size() -> None:
    for row in range(13):
        column = [WIDTHS[grade][row] for grade in GRADES]
        assert column == sorted(column)
        assert len({*column}) == len(column)
    for grade in GRADES:
        assert list(WIDTHS[grade]) == sorted(WIDTHS[grade])
        assert len(WIDTHS[grade]) == (13 if grade in ("01", "0") else 21)


@pytest.mark.parametrize(
    ("letter", "formula"),
    [("d", lambda d: 16 * d**0.44), ("e", lambda d: 11 * d**0.41), ("f", lambda d: 5.5 * d**0.41)],
)
def test_upper_deviations_are_the_formula_rounded(letter: str, formula: object) -> None:
    for row, mean in enumerate(MEANS):
        assert UPPER[letter][row] == pytest.approx(formula(mean), rel=0.06, abs=1.0)  # type: ignore[operator]


def test_lower_deviations_follow_the_grades() -> None:
    for row, mean in enumerate(MEANS):
        if 0 < row < 13:
            assert LOWER["m"][row] == pytest.approx(WIDTHS["7"][row] - WIDTHS["6"][row], abs=1.0)
            assert LOWER["n"][row] == pytest.approx(5 * mean**0.34, abs=1.1)
            assert 0 <= LOWER["p"][row] - WIDTHS["7"][row] <= 5
            assert LOWER["k"][row] == pytest.approx(0.6 * mean ** (1 / 3), abs=0.6)
            assert UPPER["g"][row] == pytest.approx(2.5 * mean**0.34, abs=1.0)
        elif row:  # rounded to preferred numbers
            assert LOWER["m"][row] == pytest.approx(0.024 * mean + 12.6, rel=0.06)
            assert LOWER["n"][row] == pytest.approx(0.04 * mean + 21, rel=0.06)
            assert LOWER["p"][row] == pytest.approx(0.072 * mean + 37.8, rel=0.06)


@pytest.mark.parametrize(
    ("text", "size", "low", "high"),
    [  # size [mm], deviations [um], as shop handbooks have them
        ("H7", 25, 0, 21), ("h6", 25, -13, 0), ("f7", 50, -50, -25), ("g6", 40, -25, -9), ("k6", 30, 2, 15),
        ("m6", 60, 11, 30), ("n6", 60, 20, 39), ("p6", 60, 32, 51), ("K7", 25, -15, 6), ("M7", 25, -21, 0),
        ("N7", 25, -28, -7), ("P7", 25, -35, -14), ("N9", 25, None, None), ("H8", 18, 0, 27), ("H8", 18.001, 0, 33),
        ("js6", 25, -6.5, 6.5), ("IT7", 25, -10.5, 10.5), ("F8", 30, 20, 53), ("M6", 300, -41, -9), ("k8", 30, 0, 33),
    ],
)  # fmt: skip
def test_classes(text: str, size: float, low: float | None, high: float | None) -> None:
    if low is None or high is None:
        with pytest.raises(UnitError):
            deviations(text, size * 1e-3)
        return
    assert deviations(text, size * 1e-3) == pytest.approx((low * 1e-6, high * 1e-6), abs=1e-12)


def test_what_the_standard_has_not_is_told() -> None:
    for text, size in (("H7", 3.2), ("IT01", 0.6), ("H19", 0.02), ("q7", 0.02), ("H7", 0.0)):
        with pytest.raises(UnitError):
            deviations(text, size)
    assert grade_width("6", 0.1) == 22e-6


def test_general_tolerances() -> None:
    assert of_length("m", 0.1) == 0.3e-3
    assert of_length("f", -0.006) == 0.05e-3
    assert of_length("v", 3.0) == 8e-3
    assert of_angle("c", 0.08) == pytest.approx(math.radians(0.5))
    for letter, size in (("f", 2.5), ("v", 0.002), ("m", 0.0), ("m", 5.0)):
        with pytest.raises(UnitError):
            of_length(letter, size)
