"""The bound of the natural frequencies of the device against eigenvalues in 50 digits."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds

from tmmcalc.vibration.vibrator.modes import modes_of
from tmmcalc.vibration.vibrator.task import Damping

pytestmark = pytest.mark.slow


def _definite(rng: np.random.Generator, spread: float) -> np.ndarray:
    """A positive definite matrix whose eigenvalues span ``spread`` decades, in units of any size."""
    turned, _ = np.linalg.qr(rng.normal(size=(7, 7)))
    unit = np.diag(10 ** rng.uniform(-1, 1, 7))
    found: np.ndarray = unit @ turned @ np.diag(10 ** rng.uniform(0, spread, 7)) @ turned.T @ unit
    return (found + found.T) / 2


def _relative_error(told: np.ndarray, mass: np.ndarray, stiffness: np.ndarray) -> float:
    lower = mp.cholesky(mp.matrix(mass.tolist()))
    inverse = lower**-1
    exact = sorted(mp.sqrt(x) for x in mp.eigsy(inverse * mp.matrix(stiffness.tolist()) * inverse.T, eigvals_only=True))
    return float(max(abs(one - other) / other for one, other in zip(told.tolist(), exact, strict=True)))


def test_bounds_of_frequencies() -> None:
    rng, pairs = np.random.default_rng(9), []
    with mp.workdps(50):
        for _ in range(200):
            mass, stiffness = _definite(rng, 1.0), _definite(rng, 2.0)
            modes = modes_of(mass, stiffness, Damping(0.02), 0.1)
            pairs.append((modes.error, _relative_error(modes.frequency, mass, stiffness)))
    assert_bounds(pairs, "frequencies")
