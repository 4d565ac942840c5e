"""A formula as it is typeset, in all four forms: nothing is lost, nothing reads as something else."""

from __future__ import annotations

import itertools
import math
import random
import re
from typing import Any
from xml.etree import ElementTree

import pytest

from tmmcalc.report.formula.breaking import broken, width
from tmmcalc.report.formula.digits import Given, rounded, significant, worked
from tmmcalc.report.formula.layout import Box, Sign, inner
from tmmcalc.report.formula.mathml import mathml
from tmmcalc.report.formula.omml import omml
from tmmcalc.report.formula.plain import plain
from tmmcalc.report.formula.setting import Shown, side, statement
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import value
from tmmcalc.report.formula.typst import typst
from tmmcalc.report.language import speaking

OMML = "http://schemas.openxmlformats.org/officeDocument/2006/math"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("sigma = -a*b", "σ = −a b"),
        ("x = (-a)*b", "x = −a b"),
        ("x = a*(-b)", "x = a·(−b)"),
        ("x = a - (b - c)", "x = a − (b − c)"),
        ("x = (a + b)**2", "x = (a + b)^2"),
        ("x = cos(phi_3)**2", "x = cos^2 φ_3"),
        ("x = sin(a)*b", "x = sin a·b"),
        ("x = a*sin(b + c)", "x = a sin(b + c)"),
        ("x = a/b", "x = a/b"),
        ("x = omega_2**2*l_2", "x = ω_2^2 l_2"),
        ("x = (a_{BA}^n)**2", "x = (a_BA^n)^2"),
        ("l_1 + abs(e) <= l_2", "l_1 + |e| ≤ l_2"),
        ("A = sum(P_i*v_i, i)", "A = ∑_i P_i v_i"),
        ("x = sqrt(a**2 + b**2)", "x = √(a^2 + b^2)"),
        ("x = (a + b)**(1/3)", "x = ³√(a + b)"),
        ("x = a**(1/2)", "x = √(a)"),
        ("x = floor(a/b) + ceil(c)", "x = ⌊a/b⌋ + ⌈c⌉"),
        ("x = a/gcd(b, c)", "x = a/(gcd(b; c))"),
        ("Deltaphi = deg(360)/n", "Δφ = 360°/n"),
        ("x = 2*3", "x = 2·3"),
    ],
)
def test_letters(text: str, said: str) -> None:
    assert plain(statement(read(text))) == said


def test_numbers_have_points_between_and_brackets_about_negative_ones() -> None:
    shown = {"a": Shown("-2.5"), "b": Shown("-3"), "phi": Shown("-30", degrees=True)}
    assert plain(side(read("a*b*sin(phi)").sides[0], shown)) == "−2.5·(−3)·sin(−30°)"
    assert plain(side(read("b - a").sides[0], shown)) == "−3 − (−2.5)"
    assert plain(side(read("-a").sides[0], shown)) == "−(−2.5)"
    assert plain(side(read("a**2").sides[0], shown)) == "(−2.5)^2"
    with speaking("uk"):
        assert plain(side(read("a*tan(phi)").sides[0], shown)) == "−2,5·tg(−30°)"
        assert plain(side(read("gcd(x, y)").sides[0])) == "НСД(x; y)"


def test_no_line_of_numbers_begins_with_minus_nothing() -> None:
    shown = {"v": Shown("0"), "w": Shown("0.5"), "phi": Shown("90", degrees=True)}
    assert plain(side(read("-v*cos(phi) - v*w").sides[0], shown)) == "0·cos 90° − 0·0.5"
    assert plain(side(read("-w*v").sides[0], shown)) == "−0.5·0"


def test_an_angle_has_its_sign_within_a_power_and_enough_digits_in_rad() -> None:
    values = {"phi": Shown("90", degrees=True)}
    assert plain(statement(read("phi**2"), values)) == "(90°)^2"
    assert plain(statement(read("rad(phi)"), values)) == "1.570796"


def test_a_power_of_ten_stands_beside_its_number() -> None:
    assert plain(side(read("E*a").sides[0], {"E": Shown("2.1e11"), "a": Shown("-1e-7")})) == "2.1·10^11·(−1·10^−7)"


def formulas() -> list[Any]:
    """Random formulas of two levels."""
    draw = random.Random(7)
    atoms = ["a", "b_3", "phi", "v_{Bx}", "a_{BA}^n", "2", "0.5", "S''", "Deltax"]

    def some(depth: int) -> str:
        if not depth:
            return draw.choice(atoms)
        x, y = some(depth - 1), some(depth - 1)
        form = draw.choice(
            [
                "({}) + ({})",
                "({}) - ({})",
                "({})*({})",
                "({})/({})",
                "sin({}) + {}",
                "sqrt({}) - {}",
                "-({})*{}",
                "({})**(1/3) + {}",
            ]
        )
        return form.format(x, y)

    return [some(k % 4) for k in range(200)]


@pytest.mark.parametrize("write", [mathml, omml])
def test_xml_of_any_formula_is_well_formed_and_has_all_its_names(write: Any) -> None:
    for text in formulas():
        box = statement(read(f"x = {text}"))
        root = ElementTree.fromstring(f'<root xmlns:m="{OMML}">{write(box)}</root>')
        letters = "".join(root.itertext())
        for digit in re.findall(r"\d+", plain(box)):
            assert digit in letters
        assert ("sin" in letters) == ("sin" in text)


def test_fractions_and_scripts_have_as_many_parts_as_they_need() -> None:
    needs = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "munder": 2, "mover": 2}
    for text in formulas():
        root = ElementTree.fromstring(f"<root>{mathml(statement(read(f'x = {text}')))}</root>")
        for element in root.iter():
            if element.tag in needs:
                assert len(element) == needs[element.tag], (text, element.tag)


def test_typst_takes_every_formula() -> None:
    typeset = pytest.importorskip("typst")
    source = "\n".join(f"$ {typst(statement(read(f'x = {text}')))} $" for text in formulas())
    _, warnings = typeset.compile_with_warnings(f"#set page(height: auto)\n{source}".encode(), format="pdf")
    assert not warnings


def signs(box: Box) -> int:
    return isinstance(box, Sign) + sum(map(signs, inner(box)))


def test_a_broken_line_loses_nothing_and_fits() -> None:
    text = " + ".join(f"a_{k}*sin(phi_{k})*l_{k}" for k in range(12))
    parts = (side(read("x").sides[0]), side(read(text).sides[0]))
    rows = broken(parts, 30.0)
    assert len(rows) == 3
    assert all(width(row) <= 30.0 for row in rows)
    assert sum(map(signs, rows)) == sum(map(signs, parts)) + 1  # the sign of equality
    assert all(isinstance(row.boxes[0], Sign) for row in rows[1:])


@pytest.mark.parametrize("digits", [3, 5])
def test_a_printed_line_works_out(digits: int) -> None:
    """Random formulas and values: the printed operands give the printed result to half of its last digit."""
    draw = random.Random(3)
    texts = ["a - b", "a*b/c", "sqrt(a**2 + b**2)", "a*sin(phi) - b*cos(phi)", "(a - b)*(a + c)/(b - c)"]
    for text, _ in itertools.product(texts, range(200)):
        given = {key: Given(draw.choice([1, -1]) * 10 ** draw.uniform(-3, 4)) for key in "abc"}
        given["phi"] = Given(draw.uniform(-360, 360), "deg")
        plainly = {key: each.value for key, each in given.items()} | {"phi": math.radians(float(given["phi"].value))}
        result = value(read(text).sides[0], plainly)
        found = worked(read(text).sides[0], given, result, digits=digits)
        assert found.error < 1e-14
        assert found.off <= 0.5 + 1e-6
        printed = {key: float(each.digits) for key, each in found.shown.items()}
        if "phi" in printed:
            printed["phi"] = math.radians(printed["phi"])
        last = 10.0 ** (math.floor(math.log10(abs(result))) - digits + 1)
        assert abs(value(found.tree, printed) - float(found.result)) <= 0.501 * last


@pytest.mark.parametrize("number", [0.0, 1.0, -0.1, 123456.789, 1e-9, -2.5e12, 0.00012345, 99999.96])
def test_digits_are_those_of_the_number(number: float) -> None:
    assert float(significant(number, 5)) == pytest.approx(number, rel=5.1e-5, abs=0.0)
    assert float(significant(number, 15)) == pytest.approx(number, rel=1e-14)
    assert "-0" not in rounded(-1e-12, 1e-3)
