"""Derivatives of a model by all its keys: by differences over ladders of steps, or exact ones with a few to check them.

What is given exactly is held against the two ends of its ladder alone: the shortest steps show a kink, a jump or an
error of the program, the longest ones how far the results have solutions. What does not agree gets its whole ladder,
which then decides.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.differences import FIRST, FLOOR, LEVELS, NOISE, Slope, slope, steps
from tmmcalc.design.model import Model

Values = NDArray[np.floating[Any]]
Progress = Callable[[int, int], None]  # places that are solved, of how many
Given = Sequence[Sequence[Slope | None]]  # exact derivatives by key and result

AIM = 1e-6  # relative error of a derivative that is good enough
FINER = 1 / 64  # of the steps, where it is not reached
ROUNDS = 3
ENDS = (0, LEVELS - 1, LEVELS, 2 * LEVELS - 1)  # of a ladder: its longest and its shortest step to each side
AGREES = 1e-3  # of the larger side: what a difference over the shortest steps may be off by, which is bent


@record
class Reach:
    """How far a key can go to a side until a variant has no solution: between two of the steps that were tried."""

    key: str
    step: float  # the smallest that failed, in the unit of the key
    reason: str


class Ladders:
    """The derivatives of a model by key and result, with what became known of its ends on the way."""

    def __init__(self, model: Model, sizes: Values, given: Given, progress: Progress) -> None:
        self.model, self.sizes, self.given, self._progress = model, sizes, given, progress
        self.solved = 0
        self._reaches: dict[tuple[int, bool], Reach] = {}
        self.slopes: list[list[Slope]] = [[] for _ in sizes]
        self.exact = [[False] * len(model.names) for _ in sizes]
        self._settle()

    @property
    def reaches(self) -> tuple[Reach, ...]:
        """Keys of which a step to a side has no solution."""
        return tuple(self._reaches.values())

    def _settle(self) -> None:
        whole = [k for k, own in enumerate(self.given) if None not in own]
        left = [k for k in range(len(self.sizes)) if k not in whole]
        for k, ends in self._tried(whole, self.sizes, ENDS):
            here = zip(self.given[k], self.model.found, ends[1], ends[3], strict=True)
            found = [held(given, self.sizes[k], *each) for given, *each in here]
            if None in found:
                left.append(k)
            else:
                self.slopes[k] = [each for each in found if each is not None]
                self.exact[k] = [True] * len(found)
        ladders = self._by_differences(sorted(left))
        for k, own in ladders.items():
            found = [of_both(*pair) for pair in zip(self.given[k], own, strict=True)]
            self.slopes[k] = [each or other for each, other in zip(found, own, strict=True)]
            self.exact[k] = [each is not None for each in found]

    def _by_differences(self, left: list[int]) -> dict[int, list[Slope]]:
        """Derivatives by whole ladders, with finer steps of those keys whose errors are too large."""
        found: dict[int, list[Slope]] = {}
        scale = self.sizes.copy()
        for _ in range(ROUNDS):
            for k, there in self._tried(left, scale, range(2 * LEVELS)):
                sides = zip(self.model.found, there.T, strict=True)
                new = [slope(scale[k], here, own) for here, own in sides]
                found[k] = [_better(*pair) for pair in zip(found[k], new, strict=True)] if k in found else new
            scale[left] *= FINER
            left = [k for k in left if any(map(self._poor, self.given[k], found[k]))]
        return found

    def _poor(self, given: Slope | None, each: Slope) -> bool:
        """Whether finer steps may do better."""
        if given is not None and of_both(given, each) is not None:
            return False
        return each.side in ("none", "left", "right") or each.error > AIM * abs(each.value)

    def _tried(self, some: Sequence[int], scale: Values, rungs: Sequence[int]) -> Iterator[tuple[int, Values]]:
        """The results (r, m) at these rungs of the ladders of keys."""
        total = self.solved + len(rungs) * len(some)

        def told(done: int) -> None:
            self._progress(self.solved + done, total)

        for own, part in _parts(self.model, some, FIRST * scale):
            moves = [(at, step) for at, k in enumerate(own) for step in steps(scale[k])[[*rungs]]]
            places = np.tile(part.nominal, (len(moves), 1))
            for row, (at, step) in enumerate(moves):
                places[row, at] += step
            answers = part(places, told)
            self.solved += len(moves)
            for at, k in enumerate(own):
                rows = slice(at * len(rungs), (at + 1) * len(rungs))
                self._note(k, moves[rows], answers.reasons[rows])
                yield k, answers.values[rows]

    def _note(self, k: int, moves: Sequence[tuple[int, float]], reasons: Sequence[str]) -> None:
        """Note the smallest step to each side at which a variant has no solution."""
        for (_, step), reason in zip(moves, reasons, strict=True):
            side = (k, step > 0)
            if reason and (side not in self._reaches or abs(step) < abs(self._reaches[side].step)):
                self._reaches[side] = Reach(self.model.keys[k], step, reason)


def held(given: Slope | None, size: float, here: float, up: float, down: float) -> Slope | None:
    """An exact derivative with the curvature, if differences over the shortest steps of a key agree; else None.

    ``here``, ``up`` and ``down`` are the result at the place and at these steps to both sides.
    """
    h = size * FIRST * 0.5 ** (LEVELS - 1)
    right, left, curvature = (up - here) / h, (here - down) / h, (up - 2 * here + down) / h**2
    noise = NOISE * max(abs(here), abs(up), abs(down)) / h + FLOOR / size
    if given is None or not (np.isfinite(right) and np.isfinite(left)):
        return None
    most = AGREES * max(abs(right), abs(left), abs(given.right), abs(given.left)) + noise
    if given.side == "kink":
        return given if max(abs(right - given.right), abs(left - given.left)) <= most else None
    # to each side the bend adds the same, so that the mean of both is nearer
    return replace(given, curvature=curvature) if abs((right + left) / 2 - given.value) <= most else None


def of_both(given: Slope | None, found: Slope) -> Slope | None:
    """An exact derivative with what a ladder of differences adds, unless these tell otherwise."""
    if given is None or found.side == "jump":
        return None
    size = max(abs(given.right), abs(given.left))
    sides = [(given.right, found.right), (given.left, found.left)]
    if given.side == "kink" or found.side == "kink":
        alike = given.side == found.side and all(abs(one - other) <= AGREES * size for one, other in sides)
        return given if alike else None
    if found.side == "both":
        agrees = abs(given.value - found.value) <= AGREES * size + found.error
        return replace(given, curvature=found.curvature) if agrees else None
    return replace(given, side=found.side)  # near an end: the steps alone do not settle


def _parts(model: Model, some: Sequence[int], step: Values) -> Iterator[tuple[Sequence[int], Model]]:
    """Keys whose variants are solved together, with the results as a function of them; of others each by itself."""
    if not some:
        return
    own = [*some]
    middle = model.nominal[own]
    part = model.over(own, middle - step[own], middle + step[own])
    if len(own) == 1 or part.together:
        yield own, part
        return
    half = len(own) // 2
    yield from _parts(model, own[:half], step)
    yield from _parts(model, own[half:], step)


def _better(old: Slope, new: Slope) -> Slope:
    """What a coarser and a finer ladder found: a kink or a jump nearby of the coarser one may be none at the place."""
    if old.side in ("kink", "jump") or new.side in ("kink", "jump"):
        return new if old.side in ("kink", "jump", "none") else old
    if (old.side == "both") != (new.side == "both"):
        return old if old.side == "both" else new
    return old if not new.error < old.error else new
