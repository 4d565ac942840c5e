"""How likely a written number is, by what it should be: densities over the natural logarithm of its magnitude.

A number that somebody has computed lies about the value that comes out, as exact as he works; it is written with a last
figure, so what is likely is the mean over the interval of rounding. A number that comes of nothing known lies anywhere:
often near the right one, sometimes decades off, of either sign.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

Array = NDArray[np.float64]

DECADES = 4.0  # on either side, over which a number that comes of nothing is spread
_NEAR, _FAR = 0.25, 1.0  # scales of its distance to the right one, of logarithms
_SHARES = (0.4, 0.25, 0.35)  # near, farther, anywhere
_SAME_SIGN = (0.85, 0.7, 0.5)


class Way(NamedTuple):
    """How exact somebody works: shares of relative deviations."""

    shares: tuple[float, ...]
    deviations: tuple[float, ...]


COMPUTED = Way((0.5, 0.35, 0.15), (3e-4, 1.5e-3, 6e-3))  # by a program, by hand, with rounded values between


def drawn(plans: float) -> Way:
    """By plans of this relative accuracy."""
    return Way((0.5, 0.5), (plans / 3, plans * 2 / 3))


class Written(NamedTuple):
    """Numbers as they are written."""

    values: Array  # (I,), none of them 0
    halves: Array  # (I,) half of their last figures


def computed(written: Written, predicted: Array, ways: tuple[Way, ...]) -> Array:
    """The density of each number (W, ..., I) by way of working, where ``predicted`` (..., I) is what comes out.

    0 where nothing is predicted, or a number of the other sign.
    """
    values = np.abs(written.values)
    halves = np.clip(written.halves, 1e-6 * values, 0.5 * values)
    with np.errstate(divide="ignore", invalid="ignore"):
        expected = np.log(np.where(predicted * written.values > 0, np.abs(predicted), np.nan))
    low, high = np.log(values - halves) - expected, np.log(values + halves) - expected
    densities = [
        sum(
            share * (ndtr(high / deviation) - ndtr(low / deviation)) / (high - low)
            for share, deviation in zip(way.shares, way.deviations, strict=True)
        )
        for way in ways
    ]
    return np.nan_to_num(np.array(densities), nan=0.0)


def anything(written: Written, right: Array) -> Array:
    """The density of each number (I,) where it comes of nothing known."""
    apart = np.abs(np.log(np.abs(written.values / right)))
    same = written.values * right > 0
    densities = (
        np.exp(-apart / _NEAR) / (2 * _NEAR),
        np.exp(-apart / _FAR) / (2 * _FAR),
        np.full(apart.shape, 1 / (2 * DECADES * np.log(10))),
    )
    return sum(
        share * np.where(same, sign, 1 - sign) * density
        for share, sign, density in zip(_SHARES, _SAME_SIGN, densities, strict=True)
    )
