from __future__ import annotations

import pytest

from tmmcalc.report.numbers import angle, column, number, scientific


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.6580645161290324, "0.6580645"), (-0.0, "0"), (2.798, "2.798"), (1e-9, "1e-09"), (-1.5, "-1.5"), (55, "55")],
)
def test_number(value: float, text: str) -> None:
    assert number(value) == text


def test_a_number_that_is_noise_against_its_peak_is_zero() -> None:
    assert number(-3e-16, peak=2.0) == "0"
    assert number(-3e-16) == "-3e-16"


@pytest.mark.parametrize(
    ("value", "text"),
    [(198.8190633, "198.81906"), (-3.4e-12, "0"), (180.0, "180"), (-0.5, "-0.5"), (100.0, "100"), (1e-5, "0.00001")],
)
def test_angle(value: float, text: str) -> None:
    assert angle(value) == text


@pytest.mark.parametrize(
    ("values", "cells"),
    [
        ([], []),
        ([0.0, -0.0], ["0", "0"]),
        ([0.0, 15.0, 30.0], ["0", "15", "30"]),
        ([0.0, -0.009927, -0.0366924], ["0.000000", "-0.009927", "-0.036692"]),
        ([1e-16, 2.5, -1e-15], ["0.0", "2.5", "0.0"]),
        ([100.0, 200.0], ["100", "200"]),
        ([1e9, -2.5e9, 0.0], ["1.00000e+09", "-2.50000e+09", "0"]),
        ([2e-7], ["2.00000e-07"]),
        ([-0.0000001, 1.0], ["0", "1"]),
        ([1.2345, 0.9876, -306176.64821], ["1.234", "0.988", "-306176.648"]),
    ],
)
def test_column(values: list[float], cells: list[str]) -> None:
    assert column(values) == cells


def test_noise_in_chosen_rows_is_measured_against_the_whole_column() -> None:
    assert column([5.75e-17], peak=2.8) == ["0"]
    assert column([5.75e-17]) == ["5.75000e-17"]


def test_column_has_one_width_of_decimals() -> None:
    cells = column([12.3456789, -0.5, 3.25])
    assert {len(cell.partition(".")[2]) for cell in cells} == {4}


def test_scientific() -> None:
    assert scientific([0.0, 3.62e-6, -4.5]) == ["0", "3.62e-06", "-4.50e+00"]
