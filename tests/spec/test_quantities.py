"""Numbers without a unit, and labels of positions."""

from __future__ import annotations

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmmcalc.spec.identifiers import Label
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.units import UnitError

SHARE = Number("a share", "0.5", above=0, at_most=1)
ANY = Number("a number", "1.5")


@pytest.mark.parametrize(
    ("value", "number"),
    [(1, 1.0), (0.25, 0.25), ("1/4", 0.25), (" 3 / 4 ", 0.75), (".5e1/1e1", 0.5), ("+1/2", 0.5), ("-1/-2", 0.5)],
)
def test_a_share(value: object, number: float) -> None:
    assert SHARE.read(value) == number


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (0, "0 is out of range; a share is above 0 and at most 1"),
        (1.5, "1.5 is out of range; a share is above 0 and at most 1"),
        ("3/2", "'3/2' is out of range; a share is above 0 and at most 1"),
        ("0.5", "'0.5' is not a share"),
        ("1/0", "'1/0' is not a share"),
        ("1/2/3", "'1/2/3' is not a share"),
        ("1/2 m", "'1/2 m' is not a share"),
        ("", "'' is not a share"),
        (True, "true is not a share"),
        ([1], "[1] is not a share"),
        (math.nan, "nan is not a finite number of ordinary size"),
        (math.inf, "inf is not a finite number of ordinary size"),
        (10**400, "a number of more than 60 digits is not a finite number of ordinary size"),
        ("1e400/1e400", "'1e400/1e400' is not a finite number of ordinary size"),
    ],
)
def test_what_is_no_share(value: object, message: str) -> None:
    with pytest.raises(UnitError) as caught:
        SHARE.read(value)
    assert caught.value.message == message
    assert caught.value.remedy.startswith("write a number, such as 0.5")


@given(st.one_of(st.text("0123456789.eE+-/ x", max_size=12), st.floats(), st.integers()))
def test_a_number_is_finite_and_the_schema_agrees(value: str | float) -> None:
    try:
        number = ANY.read(value)
    except UnitError:
        return
    assert math.isfinite(number)
    kinds = ANY.describe()["anyOf"]
    assert isinstance(value, int | float) or re.search(kinds[1]["pattern"], value)


@pytest.mark.parametrize(("value", "label"), [(6, "6"), (0, "0"), ("12", "12"), ("6''", "6''")])
def test_labels(value: object, label: str) -> None:
    assert Label().read(value) == label


@pytest.mark.parametrize("value", [-1, 1.0, True, "", "'", "a", "06", "6'\n", "1" * 9, None])
def test_what_is_no_label(value: object) -> None:
    with pytest.raises(UnitError, match="is not a position"):
        Label().read(value)
