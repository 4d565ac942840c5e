"""Zeros of many periodic functions at once, against their closed forms."""

from __future__ import annotations

import numpy as np

from tmmcalc.linkage.stacked.zeros import zeros

N = 120
X = 2 * np.pi / N * np.arange(N) - np.pi - np.pi / N


def test_zeros_of_shifted_cosines() -> None:
    shift = np.array([0.1, 1.0, 2.0])

    def f(at, variant, function):
        return np.cos((function + 1) * (at - shift[variant]))

    values = np.array([[np.cos(k * (X - a)) for a in shift] for k in (1, 2)])
    found = zeros(f, X, values, np.ones((2, 3)))
    assert found.clear.all()
    for k, places in enumerate(found.places, 1):
        assert places.shape == (3, 2 * k)
        assert np.max(np.abs(np.cos(k * (places - shift[:, None])))) < 1e-15 * 4
        assert np.all(np.diff(places, axis=1) > 0)


def test_what_nearly_touches_zero_or_turns_otherwise_is_told_apart() -> None:
    def f(at, variant, function):
        return OFFSET[variant] + np.cos(at)

    OFFSET = np.array([0.0, 0.3, 1.01, 0.9999, 2.0, -0.3])
    values = (OFFSET[:, None] + np.cos(X))[None]
    found = zeros(f, X, values, np.ones((1, 6)))
    assert found.clear.tolist() == [True, True, False, False, False, True]
    assert np.allclose(np.cos(found.places[0][[0, 1, 5]]), -OFFSET[[0, 1, 5], None], rtol=0, atol=1e-15)


def test_how_many_the_first_has_to_have() -> None:
    """Most have four; those with two are taken all the same where two are asked for, though they are fewer."""
    TWICE = np.array([1, 2, 2, 2, 1])

    def f(at, variant, function):
        return np.cos(TWICE[variant] * at)

    values = np.cos(TWICE[:, None] * X)[None]
    for first, taken in ((None, TWICE == 2), (4, TWICE == 2), (2, TWICE == 1), (6, TWICE == 3)):
        found = zeros(f, X, values, np.ones((1, 5)), first)
        assert found.clear.tolist() == taken.tolist()
        assert found.places[0].shape == (5, first or 4) or not taken.any()
        places = found.places[0][taken]
        assert np.allclose(np.cos(TWICE[taken, None] * places), 0, rtol=0, atol=1e-14)
