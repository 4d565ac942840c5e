"""Whether estimates of errors bound the true ones over random scenes, and how far above them they lie."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

import numpy as np

from tmmcalc.core.errors import TmmError

T = TypeVar("T")

FLOOR = 2.0**-53  # true errors below it cannot be told from rounding of the result itself
RATE = 0.99  # of the scenes in which an estimate has to be a bound
USEFUL = 30.0  # median ratio of estimate and true error
TRIES = 10  # random scenes for each that is wanted; if they are used up nearly all are refused


def part(scenes: int, of: int) -> int:
    """How many of the random scenes of a long check are taken: all with `make estimates`, else one in ``of``."""
    return scenes if os.environ.get("ESTIMATES") else scenes // of


def assert_bounds(pairs: Iterable[tuple[float, float]], what: str, *, scenes: int = 200) -> None:
    """Check pairs of estimate and true relative error, one a scene; failures tell the rate and the median ratio."""
    estimates, errors = np.array(list(pairs)).T
    assert len(errors) >= scenes, f"{what}: {len(errors)} scenes only"
    errors = np.maximum(errors, FLOOR)
    rate, ratio = float(np.mean(estimates >= errors)), float(np.median(estimates / errors))
    assert rate >= RATE, f"{what}: {rate:.1%} of the estimates are bounds; median ratio {ratio:.3g}"
    assert ratio < USEFUL, f"{what}: the median ratio is {ratio:.3g}; {rate:.1%} of the estimates are bounds"


def accepted(scene: Callable[[], T | None], scenes: int) -> Iterator[T]:
    """So many results of a random scene, without those that are refused (an error of the program, or None)."""
    done = 0
    for _ in range(TRIES * scenes):
        try:
            found = scene()
        except TmmError:
            continue
        if found is not None:
            yield found
            done += 1
            if done == scenes:
                return
    raise AssertionError(f"nearly all scenes are refused: {done} of {TRIES * scenes} are not, {scenes} are wanted")
