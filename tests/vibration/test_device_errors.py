"""Estimated errors of random vibratory devices against their equations at 50 digits, next to resonance too."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from bounding import accepted, assert_bounds, part
from mpmath import mp

from tmmcalc.vibration.vibrator.solve import solve_vibrator
from tmmcalc.vibration.vibrator.task import Range, VibratorTask
from vibration.devices import amplitudes, equations, natural, random_device

ROWS = 3  # of a curve


def _asked(rng: np.random.Generator) -> VibratorTask:
    """At a speed next to a natural frequency, or anywhere; and over some speeds."""
    task = random_device(rng)
    w = solve_vibrator(task).frequency
    near = float(rng.choice([1 + 10 ** rng.uniform(-6, -1), rng.uniform(0.3, 3)]))
    curve = Range(float(w[0]) * 0.5, float(w[2]) * 1.1, 40)
    return replace(task, speed=float(rng.choice(w)) * near, curve=curve)


def _far(told: np.ndarray, exact: Any, arm: float, size: Any = None) -> tuple[float, Any]:
    """Largest error of complex amplitudes as lengths, and the size that it is relative to."""
    lengths = [1, 1, arm, arm, arm, 1, arm]
    sizes = [abs(each) * length for each, length in zip(exact, lengths, strict=True)]
    missed = [abs(mp.mpc(complex(a)) - b) * c for a, b, c in zip(told, exact, lengths, strict=True)]
    return float(max(missed) / (max(sizes) if size is None else size)), max(sizes)


def _judged(rng: np.random.Generator) -> list[tuple[str, float, float]]:
    task = _asked(rng)
    found = solve_vibrator(task)
    exact, _ = natural(*equations(task))
    missed = [abs(float(a / b - 1)) for a, b in zip(found.frequency.tolist(), exact, strict=True)]
    steady, curve, arm = found.steady, found.curve, task.rods.radius
    assert steady is not None
    assert curve is not None
    x, _ = amplitudes(task, steady.speed)
    lengths = np.array([1, 1, arm, arm, arm, 1, arm])
    highest = np.argsort(np.max(curve.amplitude * lengths[:, None], axis=0))[-ROWS:]
    told = (curve.amplitude * np.exp(-1j * curve.phase)).T
    true = [amplitudes(task, float(curve.omega[k]))[0] for k in highest]
    size = max(_far(told[k], x, arm)[1] for k, x in zip(highest, true, strict=True))
    far = max(_far(told[k], x, arm, size)[0] for k, x in zip(highest, true, strict=True))
    return [
        ("frequencies", found.error["frequencies"], max(missed)),
        ("amplitudes", found.error["amplitudes"], _far(steady.cosine - 1j * steady.sine, x, arm)[0]),
        ("curve", found.error["curve"], far),
    ]


def _power(rng: np.random.Generator) -> tuple[float, float] | None:
    """Estimate and true error of the power of a device that is damped."""
    task = replace(_asked(rng), curve=None)
    found = solve_vibrator(task)
    assert found.steady is not None
    if not found.steady.power:
        return None
    _, power = amplitudes(task, found.steady.speed)
    return found.error["power"], abs(float(found.steady.power / power - 1))


def _held(scenes: int) -> None:
    rng = np.random.default_rng(23)
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)
    with mp.workdps(50):
        for found in accepted(lambda: _judged(rng), scenes):
            for name, estimate, error in found:
                pairs[name].append((estimate, error))
    for name, each in pairs.items():
        assert_bounds(each, name, scenes=scenes)


def _powers_held(scenes: int) -> None:
    rng = np.random.default_rng(2)
    with mp.workdps(50):
        assert_bounds(accepted(lambda: _power(rng), scenes), "power", scenes=scenes)


def test_estimates_of_some_devices() -> None:
    _held(3)
    _powers_held(5)


@pytest.mark.slow
def test_estimates() -> None:
    _held(part(320, 8))


@pytest.mark.slow
def test_estimates_of_power() -> None:
    _powers_held(part(900, 6))
