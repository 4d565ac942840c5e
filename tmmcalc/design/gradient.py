"""Results and their derivatives at any place: what a search asks for at every step.

Where a stage gives derivatives exactly, they cost about as much as the results; the others are found by differences of
variants that are solved together.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.points import run_of
from tmmcalc.batch.quantities import told
from tmmcalc.batch.task import Task
from tmmcalc.core.records import record
from tmmcalc.design.differences import FIRST, LEVELS, Slope, slope, steps
from tmmcalc.design.exact import Exact
from tmmcalc.design.keys import scales
from tmmcalc.design.model import Model
from tmmcalc.naming.scene import Scene

Values = NDArray[np.floating[Any]]


@record
class Gradient:
    """Results (m,) at a place and their derivatives (m, k) by the keys with their errors; NaN where there is none.

    At a kink ``slopes`` is NaN, and ``right`` and ``left`` are the derivatives to larger and to smaller values; else
    all three agree. ``exact`` tells how each was found.
    """

    values: Values
    slopes: Values
    errors: Values
    right: Values
    left: Values
    exact: NDArray[np.bool_]

    def along(self, direction: Values) -> Values:
        """Changes (m,) of the results along a direction (k,) of the keys, at kinks those to its side."""
        side = np.where(direction > 0, self.right, self.left)
        return np.asarray(np.where(direction == 0, 0.0, side * direction).sum(axis=1))


class Gradients:
    """Gradients of the results of a frame (`batch.reading.frame_of`) at places: values (k,) of its keys.

    ``sizes`` (k,) are ordinary changes of these; by default parts of their values in the spec. Raises as `Model`.
    """

    def __init__(self, frame: Task, sizes: Sequence[float] | None = None, model: Model | None = None) -> None:
        self.model = model or Model(frame)
        self.names, self.keys = self.model.names, self.model.keys
        self._frame, self._sizes = frame, list(sizes or scales(frame.axes))
        self._exact = Exact(frame, self.names, self._sizes)

    def __call__(self, place: Values) -> Gradient:
        """Results and derivatives at a place (k,); raises the error of a variant that has no solution there."""
        values = [float(value) for value in place]
        run = run_of(self._frame, self._exact.spec(values))
        error = next(iter(run.failures.values()), None)
        if error is not None:
            raise error
        known = dict(told(run.results, self.names, Scene(run.spec, run.results), [*run.outcomes]))
        found = np.array([known.get(name, np.nan) for name in self.names])
        given = self._exact.at(values, run)
        exact = np.array([[each is not None for each in own] for own in given]).T
        left = [k for k, own in enumerate(given) if None in own]
        ladders = self._by_differences(values, found, left)
        every = [
            [each or ladders[k][m] for m, each in enumerate(own)] if k in ladders else own
            for k, own in enumerate(given)
        ]
        slopes, errors, right, at_left = (
            np.array([[getattr(each, name) for each in own] for own in every]).T
            for name in ("value", "error", "right", "left")
        )
        return Gradient(found, slopes, errors, right, at_left, exact)

    def _by_differences(self, values: Sequence[float], found: Values, keys: Sequence[int]) -> dict[int, list[Slope]]:
        """Derivatives of all results by some of the keys, from ladders of steps about the place."""
        if not keys:
            return {}
        here = np.array(values)
        wide = np.zeros(len(values))
        wide[[*keys]] = FIRST * np.array(self._sizes)[[*keys]]
        part = self.model.over(range(len(values)), here - wide, here + wide, about=values)
        moves = np.concatenate([np.tile(here, (2 * LEVELS, 1)) for _ in keys])
        for at, k in enumerate(keys):
            moves[at * 2 * LEVELS : (at + 1) * 2 * LEVELS, k] += steps(self._sizes[k])
        there = part(moves).values.reshape(len(keys), 2 * LEVELS, len(found))
        return {
            k: [slope(self._sizes[k], float(one), own) for one, own in zip(found, there[at].T, strict=True)]
            for at, k in enumerate(keys)
        }
