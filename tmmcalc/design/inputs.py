"""The numbers that stages read of a spec, as functions of its keys: what they are at a place, and their slopes there.

Nearly all are quantities times a unit, affine in every key, so that steps to both sides give slopes without an error
but rounding; what is not, as a direction given by an angle, is an elementary function, of which differences over
halved steps are extrapolated.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.task import Task
from tmmcalc.core.errors import TmmError
from tmmcalc.core.numerics.alike import numbers, shape_of
from tmmcalc.core.stage import STAGES
from tmmcalc.design.differences import FIRST
from tmmcalc.project import Spec
from tmmcalc.spec.variants import given

Numbers = NDArray[np.complexfloating[Any, Any]]

AFFINE = 1e-14  # of a number: what may be left of three differences of an affine one
FAR = 1e-13  # the same from one place to another
HALVED = 5  # steps of others
KNOWN = 1e-9  # of the largest change: less has to be left where others are extrapolated
FINER = 1 / 64  # of the step, where a larger one makes no valid spec
ROUNDS = 3


class Slopes(NamedTuple):
    """Derivatives (K, L) of all numbers by the keys; their relative errors (K,), NaN of a key that has none."""

    value: Numbers
    error: NDArray[np.floating[Any]]


class _Affine(NamedTuple):
    """Numbers (L,) at a place with their slopes, which are those of other places too where the numbers there agree."""

    values: NDArray[np.floating[Any]]
    here: Numbers
    shape: Any
    slopes: Slopes

    def holds(self, values: NDArray[np.floating[Any]], here: Numbers, shape: Any) -> bool:
        """Whether they are affine from there to other values."""
        if shape != self.shape:
            return False
        moved = np.abs(values - self.values) @ np.abs(self.slopes.value)
        off = here - self.here - (values - self.values) @ self.slopes.value
        return bool(np.all(np.abs(off) <= FAR * (np.abs(here) + np.abs(self.here) + moved)))


class Inputs:
    """What some stages read of the spec of a frame, as functions of the values of its keys."""

    def __init__(self, frame: Task, stages: Sequence[str]) -> None:
        self._axes, self._stages = frame.axes, tuple(stages)
        self._variants = frame.variants()
        self._nominal = [given(axis.key, self._variants.data)[0] for axis in frame.axes]
        self._affine: _Affine | None = None

    def spec(self, values: Sequence[float]) -> Spec:
        """The spec with these values of the keys; raises `SpecError` where it is none."""
        every = zip(self._axes, values, self._nominal, strict=True)
        return self._variants.spec([axis.assignment(float(value)) for axis, value, own in every if value != own])

    def of(self, spec: Any) -> dict[str, Any]:
        """What each stage reads of a spec."""
        return {stage: STAGES[stage].inputs(spec) for stage in self._stages}

    def slopes(self, values: Sequence[float], sizes: Sequence[float]) -> Slopes:
        """Derivatives by the keys, of which ``sizes`` are ordinary changes, at a place."""
        trees = self.of(self.spec(values))
        here, shape = _flat(trees), _shape(trees)
        if self._affine is not None and self._affine.holds(np.array(values), here, shape):
            return self._affine.slopes

        def read(k: int, step: float) -> Numbers | None:
            moved = [*values]
            moved[k] += step
            try:
                trees = self.of(self.spec(moved))
            except TmmError:
                return None
            return _flat(trees) if _shape(trees) == shape else None

        found = [_slope(k, sizes[k], here, read) for k in range(len(sizes))]
        none = np.zeros(len(here), complex)
        made = Slopes(
            np.array([none if each is None else each[0] for each in found]).reshape(len(found), len(here)),
            np.array([np.nan if each is None else each[1] for each in found]),
        )
        if self._affine is None and np.all(made.error == AFFINE):
            self._affine = _Affine(np.array(values), here, shape, made)
        return made


def parts_of(trees: Mapping[str, Any]) -> dict[str, slice]:
    """Which of the numbers of all are those of each stage."""
    ends = np.cumsum([0, *(len(numbers(tree)) for tree in trees.values())]).tolist()
    return {stage: slice(low, high) for stage, low, high in zip(trees, ends, ends[1:], strict=False)}


def same(one: Any, other: Any) -> bool:
    """Whether two stages read the same."""
    return bool(shape_of(one) == shape_of(other)) and numbers(one) == numbers(other)


def _slope(k: int, size: float, here: Numbers, read: Any) -> tuple[Numbers, float] | None:
    """Derivatives (L,) by one key with their relative error; None where none is found."""
    for step in (size * FIRST * FINER**n for n in range(ROUNDS)):
        up, down = read(k, step), read(k, -step)
        if up is None or down is None:
            continue
        middle = read(k, step / 2)
        scale = np.maximum(np.abs(up), np.abs(down))
        bent = np.abs(up + down - 2 * here), np.abs(up + here - 2 * middle) if middle is not None else scale
        central = (up - down) / (2 * step)
        if all(np.all(each <= AFFINE * scale) for each in bent):
            return central, AFFINE
        return _extrapolated(central, step, [(read(k, h), read(k, -h)) for h in _halves(step)])
    return None


def _halves(step: float) -> Iterator[float]:
    return (step / 2**n for n in range(1, HALVED))


def _extrapolated(first: Numbers, step: float, pairs: Sequence[tuple[Any, Any]]) -> tuple[Numbers, float] | None:
    """By central differences over halved steps; None where they do not settle."""
    if any(up is None or down is None for up, down in pairs):
        return None
    row = [first, *((up - down) / (2 * h) for (up, down), h in zip(pairs, _halves(step), strict=True))]
    for m in range(1, HALVED - 1):
        row = [fine + (fine - coarse) / (4**m - 1) for coarse, fine in pairwise(row)]
    value = row[1] + (row[1] - row[0]) / (4 ** (HALVED - 1) - 1)
    largest = float(np.max(np.abs(value))) or 1.0
    error = max(float(np.max(np.abs(row[1] - row[0]))) / largest, AFFINE)
    return (value, error) if error < KNOWN else None


def _flat(trees: Mapping[str, Any]) -> Numbers:
    return np.array([number for tree in trees.values() for number in numbers(tree)], complex)


def _shape(trees: Mapping[str, Any]) -> Any:
    return [shape_of(tree) for tree in trees.values()]
