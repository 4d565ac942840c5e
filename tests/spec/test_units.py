from __future__ import annotations

import math
import re
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmmcalc.spec.dimensions import DIMENSIONS, UNITS
from tmmcalc.spec.quantities import Quantity
from tmmcalc.spec.units import UnitError, dimension_of, exact, parse

ALL_UNITS = [(dimension, unit) for dimension, units in UNITS.items() for unit in units]
PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899")


@pytest.mark.parametrize(
    ("text", "dimension", "si"),
    [
        ("290 mm", "length", 0.29),
        ("1020 mm", "length", 1.02),
        ("0.1 mm", "length", 0.0001),
        ("200mm", "length", 0.2),
        ("7 um", "length", 7e-6),
        ("90 deg", "angle", math.pi / 2),
        ("180°", "angle", math.pi),
        ("-90 deg", "angle", -math.pi / 2),
        ("0.5 rev", "angle", math.pi),
        ("60 arcmin", "angle", float(PI / 180)),
        ("60 rpm", "angular speed", 2 * math.pi),
        ("60 1/min", "angular speed", 2 * math.pi),
        ("60 min^-1", "angular speed", 2 * math.pi),
        ("60 min⁻¹", "angular speed", 2 * math.pi),
        ("5 1/s", "angular speed", 5.0),
        ("36 km/h", "speed", 10.0),
        ("3 m/min", "speed", 0.05),
        ("9.81 m/s²", "acceleration", 9.81),
        ("9.81 m / s^2", "acceleration", 9.81),
        ("4.5 kg·m²", "inertia", 4.5),
        ("450 g*cm^2", "inertia", 4.5e-5),
        ("1.1 kW", "power", 1100.0),
        ("600 N/mm²", "pressure", 6e8),
        ("7850 kg/m³", "density", 7850.0),
        ("1e3 mm", "length", 1.0),
        ("−18.819 deg", "angle", float(Fraction("-18.819") * PI / 180)),
        ("0 mm", "length", 0.0),
        (3, "mass", 3.0),
        (0.25, "mass", 0.25),
    ],
)
def test_value_is_exact(text: object, dimension: str, si: float) -> None:
    assert parse(text, dimension) == si


@pytest.mark.parametrize(
    ("value", "dimension", "fragment", "remedy"),
    [
        ("5 kW", "length", "'5 kW' is a power, a length is needed", "200 mm"),
        ("5 Hz", "angular speed", "is a frequency, an angular speed is needed", "55 rpm"),
        ("200 MM", "length", "unknown unit 'MM'", 'did you mean "mm"?'),
        ("4 kg*m2", "inertia", "unknown unit 'kg*m2'", 'did you mean "kg*m^2"?'),
        ("4 parsec", "length", "unknown unit 'parsec'", "known here: m, mm"),
        ("200", "length", "'200' has no unit", "a number without quotes is in m"),
        (
            "0",
            "length",
            "'0' has no unit",
            'write 0 without quotes, or a number and its unit in quotes, such as "200 mm"',
        ),
        ("-0.00", "angle", "'-0.00' has no unit", "write 0 without quotes"),
        ("200,5 mm", "length", "has a decimal comma", '"200.5 mm"'),
        ("1 000 mm", "length", "does not start with one plain number", "200 mm"),
        ("2/3 m", "length", "does not start with one plain number", "200 mm"),
        ("mm", "length", "'mm' is not a length", "200 mm"),
        ("", "length", "'' is not a length", "200 mm"),
        ("inf m", "length", "'inf m' is not a length", "200 mm"),
        ("1e999 m", "length", "not a finite number", "200 mm"),
        ("1e-999999999 m", "length", "not a finite number", "200 mm"),
        ("1" * 5000 + " m", "length", "not a finite number", "200 mm"),
        (math.inf, "length", "inf is not a finite number", "200 mm"),
        (math.nan, "length", "nan is not a finite number", "200 mm"),
        (10**400, "length", "not a finite number", "200 mm"),
        (True, "mass", "true is not a mass", "55 kg"),
        ([1], "mass", "[1] is not a mass", "55 kg"),
    ],
)
def test_fault_says_value_rule_and_remedy(value: object, dimension: str, fragment: str, remedy: str) -> None:
    with pytest.raises(UnitError) as caught:
        parse(value, dimension)
    assert fragment in caught.value.message
    assert remedy in caught.value.remedy


def test_either_of_two_dimensions() -> None:
    assert parse("2 rad", "angle", "length") == parse("2 m", "angle", "length") == 2.0
    with pytest.raises(UnitError, match="an angle or a length is needed"):
        parse("2 kg", "angle", "length")


def test_every_unit_belongs_to_one_dimension() -> None:
    assert UNITS.keys() == DIMENSIONS.keys()
    assert len({unit for _, unit in ALL_UNITS}) == len(ALL_UNITS)
    for dimension, (_, si, example) in DIMENSIONS.items():
        assert parse(f"1 {si}", dimension) == 1.0
        assert dimension_of(example) == dimension


@given(st.sampled_from(ALL_UNITS), st.floats(allow_nan=False, min_value=-1e200, max_value=1e200))
def test_conversion_is_correctly_rounded(unit: tuple[str, str], number: float) -> None:
    dimension, name = unit
    if 0 < abs(number) < 1e-200:
        return
    factor = UNITS[dimension][name]
    exact = Fraction(repr(number)) * factor.num / factor.den * (PI if factor.pi else 1)
    assert parse(f"{number!r} {name}", dimension) == float(exact)
    assert dimension_of(f"{number!r} {name}") == dimension


@given(st.floats(allow_nan=False, min_value=-1e200, max_value=1e200))
def test_si_string_and_bare_number_agree(number: float) -> None:
    if number == 0 or abs(number) > 1e-200:
        assert parse(f"{number!r} kg", "mass") == parse(number, "mass") == number


@pytest.mark.slow
@given(st.text(max_size=20))
def test_any_text_is_read_or_refused(text: str) -> None:
    message = ""
    try:
        value = parse(text, "length", "angle")
    except UnitError as fault:
        value, message = 0.0, fault.message
    assert math.isfinite(value)
    assert message.isprintable()


@given(st.sampled_from(ALL_UNITS))
def test_schema_pattern_takes_every_unit(unit: tuple[str, str]) -> None:
    dimension, name = unit
    pattern = Quantity(dimension).describe()["anyOf"][1]["pattern"]
    raised = name.replace("*", "·").replace("^2", "²").replace("^3", "³")
    gap = " " if name[0].isdigit() else ""
    for text in (f"1.5 {name}", f"-2{gap}{name}", f".5e3 {raised}"):
        assert re.search(pattern, text), text
        parse(text, dimension)
    assert not re.search(pattern, f"1,5 {name}")


@pytest.mark.parametrize(
    ("value", "unit", "found"),
    [
        ("7.5 cm", "mm", Fraction(75)),
        ("0.1 m", "mm", Fraction(100)),
        (0.1, "", Fraction(1, 10)),
        ("1e-3 MPa", "Pa", Fraction(1000)),
        ("−5", "mm", Fraction(-5)),
        ("30 deg", "deg", Fraction(30)),
        (1e22, "N", Fraction(10**22)),
    ],
)
def test_exact_numbers(value: str | float, unit: str, found: Fraction) -> None:
    assert exact(value, unit) == found


def test_exact_turns() -> None:
    """60 rpm are 2 pi rad/s, by sixty digits of pi; and back."""
    there = exact("60 rpm", "rad/s")
    assert float(there) == 2 * math.pi
    assert exact("1 rad/s", "rpm") * there == 60


@pytest.mark.parametrize(
    ("value", "unit"), [("3 kg", "mm"), ("3 mm", ""), ("far", "mm"), (f"1{'0' * 500}", ""), ("", "")]
)
def test_what_is_no_exact_number(value: str, unit: str) -> None:
    with pytest.raises(UnitError):
        exact(value, unit)
