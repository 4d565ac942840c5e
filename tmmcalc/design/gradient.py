"""Results and their derivatives at any place: what a search asks for at every step.

Where a stage gives derivatives exactly, they are held against the shortest steps to both sides, which show a kink that
an extreme in two rows has; the others are found by differences over whole ladders. Variants are solved together.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.points import run_of
from tmmcalc.batch.quantities import told
from tmmcalc.batch.task import Task
from tmmcalc.core.records import record
from tmmcalc.design.differences import LEVELS, Slope, slope, steps
from tmmcalc.design.exact import Exact
from tmmcalc.design.ladders import Given, held, of_both
from tmmcalc.design.model import Model
from tmmcalc.design.sizes import scales
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
        settled = self._held(values, found, given)
        left = [k for k, own in enumerate(settled) if None in own]
        every = [*settled]
        for k, there in self._tried(values, left, range(2 * LEVELS)):
            ladder = [slope(self._sizes[k], float(one), own) for one, own in zip(found, there.T, strict=True)]
            settled[k] = [of_both(*pair) for pair in zip(given[k], ladder, strict=True)]
            every[k] = [each or other for each, other in zip(settled[k], ladder, strict=True)]
        exact = np.array([[each is not None for each in own] for own in settled]).T
        slopes, errors, right, at_left = (
            np.array([[getattr(each, name) for each in own] for own in every]).T
            for name in ("value", "error", "right", "left")
        )
        return Gradient(found, slopes, errors, right, at_left, exact)

    def _held(self, values: Sequence[float], found: Values, given: Given) -> list[Sequence[Slope | None]]:
        """Exact derivatives by key and result, None where there is none or the shortest steps tell otherwise."""
        settled = [*given]
        whole = [k for k, own in enumerate(given) if None not in own]
        for k, (up, down) in self._tried(values, whole, (LEVELS - 1, 2 * LEVELS - 1)):
            here = zip(given[k], found, up, down, strict=True)
            settled[k] = [held(each, self._sizes[k], *map(float, own)) for each, *own in here]
        return settled

    def _tried(
        self, values: Sequence[float], keys: Sequence[int], rungs: Sequence[int]
    ) -> Iterator[tuple[int, Values]]:
        """The results (r, m) at these rungs of the ladders of some of the keys, about the place."""
        if not keys:
            return
        here = np.array(values)
        own = np.array([steps(self._sizes[k])[[*rungs]] for k in keys])
        wide = np.zeros(len(values))
        wide[[*keys]] = np.abs(own).max(axis=1)
        part = self.model.over(range(len(values)), here - wide, here + wide, about=values)
        moves = np.tile(here, (len(keys) * len(rungs), 1))
        for at, k in enumerate(keys):
            moves[at * len(rungs) : (at + 1) * len(rungs), k] += own[at]
        yield from zip(keys, part(moves).values.reshape(len(keys), len(rungs), -1), strict=True)
