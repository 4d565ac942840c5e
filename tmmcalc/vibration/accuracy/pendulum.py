"""Methods for the whirl of the pendulum-rotor: elements of low degree ever finer, one element of ever higher degree.

Ritz's method is variational: a frequency is off by the square of what its mode is, so that cubics on elements are of
order 4, and polynomials of one element beyond every order as long as the modes are smooth.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Series, Study
from tmmcalc.vibration.pendulum.basis import Basis
from tmmcalc.vibration.pendulum.energies import matrices
from tmmcalc.vibration.pendulum.results import PendulumResult
from tmmcalc.vibration.pendulum.task import PendulumTask
from tmmcalc.vibration.pendulum.whirl import lowest, whirl

ELEMENTS = (2, 3, 4, 6, 8, 12, 16, 24)
EACH = ((3, "Hermite cubics", 4.0), (5, "quintics", 8.0))  # degree on an element, name, order of a frequency
DEGREES = (5, 6, 7, 8, 10, 12, 16, 20)  # on one element
FINEST = ((4, 12), (6, 14))  # elements and degree: the reference, and what it is compared with
SPECTRAL = "beyond every order while the modes are smooth; thin layers of a soft rod ask for elements of their own"


def studies(scene: Scene) -> Iterator[Study]:
    """The lowest frequencies at the spin, in the plane xz."""
    task: PendulumTask = scene.inputs
    result: PendulumResult = scene.results["pendulum"]
    count = len(result.modes[0].frequency)
    coarse, exact = (_frequencies(task, count, elements, degree) for elements, degree in FINEST)

    def error(found: Values) -> float:
        return float(np.max([relative(a, b) for a, b in zip(found, exact, strict=True)]))

    elements, degree = FINEST[1]
    yield Study(
        "pendulum",
        f"{count} frequencies of either whirl",
        Reference(f"{elements} elements of degree {degree}, beside {FINEST[0][0]} of {FINEST[0][1]}", error(coarse)),
        tuple(_series(task, count, error, scene)),
    )


def _series(task: PendulumTask, count: int, error: Callable[[Values], float], scene: Scene) -> Iterator[Series]:
    for degree, name, order in EACH:
        ways = [
            Way(f"{n} elements", 1 / n, partial(_frequencies, task, count, n, degree))
            for n in ELEMENTS
            if n * (degree - 1) >= count
        ]
        yield series(name, ways, error, scene.clock, expected=order)
    ways = [Way(f"degree {n}", None, partial(_frequencies, task, count, 1, n)) for n in DEGREES if n > count]
    yield series("one element", ways, error, scene.clock, note=SPECTRAL)


def _frequencies(task: PendulumTask, count: int, elements: int, degree: int) -> Values:
    """Forward and backward [rad/s] (2, count)."""
    edges = tuple(np.linspace(0.0, 1.0, elements + 1).tolist())
    basis = Basis(edges, degree, task.pivot is not None)
    found = lowest(whirl(matrices(task, basis, 0), np.array(task.spin)), count)
    return np.abs(np.stack(found))
