"""The text of a formula: what is read, what is refused, what its value is."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmmcalc.report.formula.simplify import simplified
from tmmcalc.report.formula.symbols import canonical, symbol_of
from tmmcalc.report.formula.syntax import FormulaError, read
from tmmcalc.report.formula.tree import Number, Sum, names, value, written_out

VALUES = {"a": 3.0, "b": -2.0, "c": 0.5, "phi_3": 0.7}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a + b*c", 2.0),
        ("-a*b", 6.0),
        ("(-a)*b", 6.0),
        ("-a**2", -9.0),
        ("(-a)**2", 9.0),
        ("a - (b - c)", 5.5),
        ("a - b - c", 4.5),
        ("a/b/c", -3.0),
        ("a/(b*c)", -3.0),
        ("a - -b", 1.0),
        ("sin(phi_3)**2 + cos(phi_3)**2", 1.0),
        ("atan2(a, b)", math.atan2(3, -2)),
        ("inv(deg(20))", math.tan(math.radians(20)) - math.radians(20)),
        ("abs(b) + sqrt(a**2)", 5.0),
        ("min(a, b, c) + max(a, b)", 1.0),
        ("2*pi", 2 * math.pi),
        ("(9*a)**(1/3)", 3.0),
        ("floor(b/3) + ceil(c)", 0.0),
        ("gcd(18, 6*a + 9)", 9.0),
    ],
)
def test_a_formula_has_the_value_of_its_arithmetic(text: str, expected: float) -> None:
    assert value(read(text).sides[0], VALUES) == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize("text", ["a +", "a**", "f(a)", "a if b else c", "a <", "'a'", "a.b", "[a]", "sum(a)", "a % b"])
def test_what_is_no_formula_is_refused(text: str) -> None:
    with pytest.raises(FormulaError):
        read(text)


def test_a_sum_over_an_index_is_the_sum_of_its_terms() -> None:
    node = read("sum(P_i*v_i*cos(alpha_i), i)").sides[0]
    values = {"P_i": [1.0, 2.0, 3.0], "v_i": [0.5, -1.0, 2.0], "alpha_i": [0.0, math.pi, 0.0]}
    assert value(node, values) == pytest.approx(0.5 + 2.0 + 6.0)
    tree = written_out(node, values)
    assert isinstance(tree, Sum)
    assert names(tree) == [f"{name}_i#{k}" for k in range(3) for name in ("P", "v", "alpha")]
    with pytest.raises(KeyError, match="different lengths"):
        value(node, {**values, "v_i": [1.0]})


@pytest.mark.parametrize(
    ("key", "same"),
    [("M_{4}^{D}", "M_4^D"), ("v_{Bx}", "v_Bx"), ("S''", "S''"), ("alpha_{tw}", "alpha_tw"), ("N_{10,9}", "N_{10,9}")],
)
def test_a_name_is_written_in_one_way(key: str, same: str) -> None:
    assert canonical(key) == same
    assert symbol_of(key) == symbol_of(same)
    assert names(read(f"{key} = 2*{key}")) == [same]


@given(st.sets(st.sampled_from(["a", "b", "c", "d", "e"])))
def test_a_formula_without_what_is_nothing_has_the_same_value(nothing: set[str]) -> None:
    formula = read("x = (a*sin(b) - (c - d)*cos(b) + 2*e*c)/(3 + a**2) - atan2(b, 1 + a**2) + d*(a + b)")
    values = {key: 0.0 if key in nothing else 0.3 + 0.2 * k for k, key in enumerate("abcde")}
    (_, whole), (_, short) = formula.sides, simplified(formula, nothing).sides
    assert value(short, values) == pytest.approx(value(whole, values), abs=1e-15)
    assert not set(names(short)) & nothing


def test_all_that_is_nothing_leaves_nothing() -> None:
    formula = read("x = a*b + sin(a)")
    assert simplified(formula, {"a"}).sides[1] == Number("0")
