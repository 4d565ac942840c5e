"""Which numbers of a spec matter for which results: partial derivatives with their errors, ranked."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.reading import frame_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.design.differences import FIRST, LEVELS, Slope, slope, steps
from tmmcalc.design.keys import chosen, keys_of, scales, varied
from tmmcalc.design.model import Model, solver_of
from tmmcalc.project.loader import Variants, read_text

Values = NDArray[np.floating[Any]]
Progress = Callable[[int, int], None]  # places that are solved, of how many

AIM = 1e-6  # relative error of a derivative that is good enough
FINER = 1 / 64  # of the steps, where it is not reached
ROUNDS = 3
NEGLIGIBLE = 1e-9  # of the largest relative derivative: what is less is no influence where its error is larger


@record
class Partial:
    """The derivative of one result with respect to one key, in the units of both."""

    name: str  # of the result
    key: str
    value: float  # of the key
    slope: Slope
    relative: float  # per cent of the result for a per cent of the key; NaN where either is 0

    @property
    def error(self) -> float:
        """Of the derivative, relative to it; NaN where there is none, 0 of one that is exactly nothing."""
        size = abs(self.slope.value)
        return self.slope.error / size if size else 0.0


@record
class Reach:
    """How far a key can go to a side until a variant has no solution: between two of the steps that were tried."""

    key: str
    step: float  # the smallest that failed, in the unit of the key
    reason: str


@record
class Sensitivity:
    """All partial derivatives, by results then by keys; what was left out, and how near the ends are."""

    names: tuple[str, ...]
    found: tuple[float, ...]  # the results
    partials: tuple[Partial, ...]
    reaches: tuple[Reach, ...]
    fixed: tuple[tuple[str, str], ...]  # keys that take no small change, and why
    solved: int  # variants

    def of(self, name: str) -> list[Partial]:
        """Those of one result, the one that matters most first: kinks and jumps before all."""
        return sorted((each for each in self.partials if each.name == name), key=_rank)


def _rank(each: Partial) -> tuple[bool, float]:
    if np.isnan(each.slope.value):
        sides = [abs(side) for side in (each.slope.left, each.slope.right) if np.isfinite(side)]
        return False, -max(sides, default=np.inf) * abs(each.value)
    return True, -abs(each.slope.value * each.value)


def sensitivity(
    file: Path,
    of: Sequence[str],
    to: Sequence[str] = (),
    fixed: Sequence[str] = (),
    *,
    jobs: int | None = None,
    scheduler: str | None = None,
    tell: Callable[[str], None] = lambda said: None,
    progress: Progress = lambda done, count: None,
) -> Sensitivity:
    """Derivatives of the results ``of`` (names, see `tmmcalc.naming.language`) with respect to keys ``to``.

    Keys may have the wildcards ``*`` and ``?``; without any all numbers of the spec are meant. ``fixed`` are overrides.
    Raises UsageError for names and keys that there are not and for a key that takes no small change, and the error of
    the spec as it is.
    """
    data = Variants(read_text(file), str(file), file.parent, fixed).data
    keys = chosen(data, to) if to else keys_of(data)
    frame = frame_of(file, fixed, keys, of)
    sizes = scales(frame.axes)
    reasons = varied(frame, sizes)
    for axis, reason in zip(frame.axes, reasons, strict=True):
        if reason and axis.key in to:
            raise UsageError(f"{axis.key} takes no small change: {reason}", where="--to", remedy="leave it out")
    kept = [k for k, reason in enumerate(reasons) if not reason]
    whole, frame = frame, replace(frame, axes=tuple(frame.axes[k] for k in kept))
    model = Model(frame, solver_of(frame, 2 * LEVELS * len(kept), jobs, scheduler, tell))
    slopes, reaches, solved = _slopes(model, np.array([sizes[k] for k in kept]), progress)
    partials = tuple(
        Partial(name, model.keys[k], float(model.nominal[k]), slopes[k][m], _relative(model, k, m, slopes[k][m]))
        for m, name in enumerate(model.names)
        for k in range(len(kept))
    )
    left = tuple((axis.key, reason) for axis, reason in zip(whole.axes, reasons, strict=True) if reason)
    return Sensitivity(model.names, tuple(model.found.tolist()), partials, reaches, left, solved)


def _relative(model: Model, k: int, m: int, found: Slope) -> float:
    value, result = float(model.nominal[k]), float(model.found[m])
    return found.value * value / result if value and result else np.nan


def _slopes(model: Model, sizes: Values, progress: Progress) -> tuple[list[list[Slope]], tuple[Reach, ...], int]:
    """Derivatives by key and result, with finer steps of those keys whose errors are too large."""
    found: list[list[Slope]] = [[] for _ in sizes]
    reaches: dict[tuple[int, bool], Reach] = {}
    left, solved, scale = list(range(len(sizes))), 0, sizes.copy()
    for _ in range(ROUNDS):
        total = solved + 2 * LEVELS * len(left)

        def told(done: int, before: int = solved, total: int = total) -> None:
            progress(before + done, total)

        for some, part in _parts(model, left, FIRST * scale):
            moves = [(at, step) for at, k in enumerate(some) for step in steps(scale[k])]
            places = np.tile(part.nominal, (len(moves), 1))
            for row, (at, step) in enumerate(moves):
                places[row, at] += step
            answers = part(places, told)
            solved += len(moves)
            for at, k in enumerate(some):
                own = slice(at * 2 * LEVELS, (at + 1) * 2 * LEVELS)
                sides = zip(model.found, answers.values[own].T, strict=True)
                new = [slope(scale[k], here, there) for here, there in sides]
                found[k] = [_better(*pair) for pair in zip(found[k], new, strict=True)] if found[k] else new
                _note(reaches, k, model.keys[k], moves[own], answers.reasons[own])
        scale[left] *= FINER
        left = [k for k in left if any(map(_poor, found[k]))]
    return found, tuple(reaches.values()), solved


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


def _poor(each: Slope) -> bool:
    """Whether finer steps may do better."""
    return each.side in ("none", "left", "right") or each.error > AIM * abs(each.value)


def _better(old: Slope, new: Slope) -> Slope:
    """What a coarser and a finer ladder found: a kink or a jump nearby of the coarser one may be none at the place."""
    if old.side in ("kink", "jump") or new.side in ("kink", "jump"):
        return new if old.side in ("kink", "jump", "none") else old
    if (old.side == "both") != (new.side == "both"):
        return old if old.side == "both" else new
    return old if not new.error < old.error else new


def _note(
    reaches: dict[tuple[int, bool], Reach], k: int, key: str, moves: Sequence[tuple[int, float]], reasons: Sequence[str]
) -> None:
    """Note the smallest step to each side at which a variant has no solution."""
    for (_, step), reason in zip(moves, reasons, strict=True):
        side = (k, step > 0)
        if reason and (side not in reaches or abs(step) < abs(reaches[side].step)):
            reaches[side] = Reach(key, step, reason)
