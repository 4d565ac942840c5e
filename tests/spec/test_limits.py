"""What is beyond the limits of a spec is told with its place, and nothing takes more time than its length asks for."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from time import perf_counter

import pytest
from faults import Faults
from hypothesis import given
from hypothesis import strategies as st
from properties import examples

from tmmcalc.core.errors import SpecError, TmmError
from tmmcalc.core.headers import key_and_unit
from tmmcalc.gears.strength.material import parse_hardness
from tmmcalc.project import parse_spec
from tmmcalc.spec.choices import Exact
from tmmcalc.spec.csvtables import Column, FileError, Form, columns_of
from tmmcalc.spec.limits import MOST_DEPTH, MOST_PARTS, beyond
from tmmcalc.spec.quantities import Number, QualityGrade
from tmmcalc.spec.syntax import read_toml
from tmmcalc.spec.units import UnitError, dimension_of, parse
from tmmcalc.spec.variants import is_range

LONG = 30_000


@pytest.mark.parametrize(
    ("line", "column", "fragment"),
    [
        ("a." * 20_000 + "b = 1", 32, "a key of more than 16 parts"),
        ("[" + "a." * 20_000 + "b]", 33, "a key of more than 16 parts"),
        ("a = { " + "'b' . " * 20_000 + "c = 1 }", 95 + 6, "a key of more than 16 parts"),
        ("a = " + "[" * 100_000, 21, "nested too deeply, more than 16 within one another"),
        ("a = " + "{ b = " * 5_000, 101, "nested too deeply"),
        ("a = " + "1" * 5_000, 5, "a number or key of 5000 signs, more than 300"),
        ("a = 0x" + "f" * 5_000, 5, "a number or key of 5002 signs"),
        ("a = 1." + "1" * 5_000, 7, "a number or key of 5000 signs"),
    ],
)
def test_what_is_beyond_a_limit_is_told_at_once(line: str, column: int, fragment: str) -> None:
    began = perf_counter()
    with pytest.raises(SpecError) as caught:
        read_toml(f"x = 1\n{line}\n", "a.toml")
    (fault,) = caught.value.faults
    assert (fault.line, fault.column) == (2, column)
    assert fragment in fault.message
    assert fault.remedy
    assert perf_counter() - began < 2


@pytest.mark.parametrize("line", ["a = " + "[" * 40 + "]" * 40, "a = " + "{ b = " * 40 + "1" + " }" * 40])
def test_a_depth_that_could_be_read_is_beyond_it_too(shaper: str, faults_of: Faults, line: str) -> None:
    (fault,) = faults_of(f"{shaper}\n{line}\n")
    assert "nested too deeply" in fault.message
    assert fault.column is not None


@pytest.mark.parametrize(
    "text",
    [
        ".".join("a" * MOST_PARTS) + " = 1",
        "a = " + "[" * MOST_DEPTH + "]" * MOST_DEPTH,
        f'a = "{"[." * LONG}"',
        f"a = '{'[{' * LONG}' # {'[.' * LONG}",
        f'a = """{"[.{" * LONG}\n"" x \\""""',
        f"a = '''{'[.{' * LONG}'\n''x'''",
        f'a = "{"1" * LONG}"',
        "a = [" + "1.5, " * LONG + "]",
    ],
)
def test_what_is_within_them_is_none(text: str) -> None:
    tomllib.loads(text)
    assert beyond(text) is None


TEXTS = st.lists(st.sampled_from([*"[]{}.,=\n\"'#\\", '"""', "'''", "a", "12", " "]), max_size=30).map("".join)


@examples(400)
@given(TEXTS)
def test_short_texts_are_within_them(text: str) -> None:
    """No text of thirty signs is, unless it opens seventeen brackets or has sixteen dots."""
    found = beyond(text)
    assert found is None or text.count("[") + text.count("{") > MOST_DEPTH or text.count(".") >= MOST_PARTS


def test_very_many_faults_are_counted(shaper: str) -> None:
    text = shaper + "".join(f"\n[[mechanism.links]]\nid = {k}\n" for k in range(10, 400))
    with pytest.raises(SpecError) as caught:
        parse_spec(text)
    told = str(caught.value)
    assert len(caught.value.faults) > 300
    assert told.count("\n    -> ") == SpecError.SHOWN
    assert re.search(r"\n  and \d+ more: mend these first$", told)


def header(text: str) -> object:
    form = Form("a load", "phi", ("angle",), ("force",), "write phi[deg],Q[N]")
    return columns_of([text, "Q[N]"], "angle", 1, form)


READERS: list[Callable[[str], object]] = [
    lambda text: parse(text, "length"),
    dimension_of,
    Number("a number", "1").read,
    Exact("a number", "1").read,
    QualityGrade().read,
    Column("", "").read,
    header,
    lambda text: is_range(f"a.b={text}"),
    lambda text: is_range(f"a.b={text},{text}"),
    lambda text: is_range(f"a.b={text}:{text}:{text}"),
    lambda text: is_range(f"a[{text}]=1"),
    lambda text: is_range(f"a[id={text}"),
    key_and_unit,
    parse_hardness,
    lambda text: read_toml(f"a = {text}\n", "a.toml"),
    lambda text: read_toml(f"{text} x = 1\n", "a.toml"),
]
HARD = [
    " " * LONG + "x",
    "1 m" + " " * LONG + "x",
    "1" * LONG + "x",
    "1." * LONG,
    "1e" + "0" * LONG + "1 mm",
    "1 m" + " *" * LONG,
    "[" * LONG + "1",
    "a[" * LONG + "]",
    "=1" * LONG,
    '"' * (LONG + 1),
    "1/" + "1" * LONG + "x",
    "," * LONG,
    "\t" * LONG + "]",
]


@pytest.mark.parametrize("number", range(len(READERS)))
def test_no_text_takes_the_square_of_its_length(number: int) -> None:
    for text in HARD:
        began = perf_counter()
        try:
            READERS[number](text)
        except (UnitError, FileError, TmmError) as error:
            told = str(error)
        else:
            told = ""
        assert "set_int_max_str_digits" not in told
        assert perf_counter() - began < 1.0, text[:20]
