"""Euclid's algorithm and prime factors: case GT-S02 and their definitions."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gears.criteria.worked import CASES
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.factors import euclid, prime_factors


def test_worked_numbers() -> None:
    case = CASES["GT-S02"]
    found = [euclid(*pair) for pair in case["inputs"]["pairs"]]
    assert [each.divisor for each in found] == case["expected"]["gcd"]
    assert list(found[0].quotients) == case["expected"]["euclid_quotients_1254_42"]
    for n, factors in case["expected"]["factors"].items():
        assert list(prime_factors(int(n))) == factors


@given(st.integers(1, 10**9), st.integers(1, 10**9))
def test_euclid(a: int, b: int) -> None:
    found = euclid(a, b)
    assert found.divisor == math.gcd(a, b)
    for quotient, rest in zip(found.quotients, found.remainders, strict=True):
        assert a == quotient * b + rest
        assert 0 <= rest < b
        a, b = b, rest
    assert b == 0


@given(st.integers(2, 10**6))
def test_factors(n: int) -> None:
    factors = prime_factors(n)
    assert math.prod(factors) == n
    assert list(factors) == sorted(factors)
    assert all(f % d for f in set(factors) for d in range(2, math.isqrt(f) + 1))


def test_faults() -> None:
    for wrong in (lambda: euclid(0, 3), lambda: euclid(3, 0), lambda: prime_factors(1)):
        with pytest.raises(UsageError):
            wrong()
