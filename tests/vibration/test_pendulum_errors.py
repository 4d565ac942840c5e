"""Estimated errors of pendulum-rotors against the differential equation of the rod, by series in 40 digits and more."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

import numpy as np
import pytest
from bounding import accepted, assert_bounds, part
from mpmath import mp

from tmmcalc.vibration.pendulum.results import PendulumResult
from tmmcalc.vibration.pendulum.solve import solve_pendulum
from tmmcalc.vibration.pendulum.task import PendulumTask
from vibration.rods import frequency, random_pendulum, torsion, whirl

Scene = tuple[str, float, float]  # quantity, estimate, true error


def _far(told: float, exact: object) -> float:
    return abs(float(told / exact - 1))


def _judged(task: PendulumTask, found: PendulumResult) -> Iterator[Scene]:
    """The lowest and the highest frequency of every sense, critical speeds, the whirl, torsion."""
    missed = []
    for modes in found.modes:
        sign, plane = -1 if modes.name == "backward" else 1, int(modes.name == "plane yz")
        for told in {modes.frequency[0], modes.frequency[-1]}:
            missed.append(_far(sign * told, frequency(task, plane, sign * told, task.spin)))
    if found.campbell is not None:
        told = found.campbell.forward[-1, -1]
        missed.append(_far(told, frequency(task, 0, told, found.campbell.spin[-1])))
    yield "frequencies", found.error["frequencies"], max(missed)
    critical = [*found.forward_critical[-1:], *(-found.backward_critical[-1:])]
    if critical:
        yield "critical", found.error["critical"], max(_far(told, frequency(task, 0, told)) for told in critical)
    if found.deflection is not None:
        yield "whirl", found.error["whirl"], _far(found.deflection, whirl(task))
    yield "torsion", found.error["torsion"], max(_far(told, torsion(task, told)) for told in found.torsion[[0, -1]])


def _held(scenes: int, soft: float) -> None:
    rng = np.random.default_rng(17)
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)

    def scene() -> list[Scene]:
        task = random_pendulum(rng, soft)
        found = solve_pendulum(task)
        with mp.workdps(40):
            return [*_judged(task, found)]

    for found in accepted(scene, scenes):
        for name, estimate, error in found:
            pairs[name].append((estimate, error))
    for name, each in pairs.items():
        assert_bounds(each, name, scenes=scenes // 5)


def test_estimates_of_stiff_rods() -> None:
    _held(5, 0.3)


@pytest.mark.slow
def test_estimates() -> None:
    """Two rods in three spin."""
    _held(part(400, 8), 3e-2)
