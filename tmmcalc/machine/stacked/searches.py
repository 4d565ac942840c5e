"""Searches of many machines for an inertia, whose trials are run together.

A search is a function of a model, inertia -> delta. It is run until it asks for what is not known yet; what all ask for
is found at once, and each is run again with what is known by then. The search itself costs nothing beside a motion.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TypeVar

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.machine.flywheel.search import Model

T = TypeVar("T")
Motions = Callable[[Indices, Values], Values]
"""(numbers of machines (v,), their further inertia (v,) [kg*m^2]) -> delta (v,), NaN of what is not clear."""


class _WantedError(Exception):
    """The unevenness with an inertia is not known yet."""

    def __init__(self, inertia: float) -> None:
        self.inertia = inertia


def replayed(searches: Sequence[Callable[[Model], T]], motions: Motions) -> list[T | None]:
    """What the searches find; None of one that has no solution, or comes to a motion that is not clear."""
    found: list[T | None] = [None for _ in searches]
    known: list[dict[float, float]] = [{} for _ in searches]
    active = list(range(len(searches)))
    while active:
        wanted: dict[int, float] = {}
        for k in active:
            try:
                found[k] = searches[k](partial(_looked_up, known[k]))
            except _WantedError as wish:
                wanted[k] = wish.inertia
            except (NoSolutionError, AccuracyError):
                continue
        active = []
        if wanted:
            deltas = motions(np.array(list(wanted)), np.array(list(wanted.values())))
            for (k, inertia), delta in zip(wanted.items(), deltas.tolist(), strict=True):
                if np.isfinite(delta):
                    known[k][inertia] = delta
                    active.append(k)
    return found


def _looked_up(known: Mapping[float, float], inertia: float) -> float:
    if inertia not in known:
        raise _WantedError(inertia)
    return known[inertia]
