"""Works of the loads over a cycle as a mistake in the integration gives them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.machine.reduction.results import Reduction


def with_works(found: Reduction, works: Sequence[float]) -> Reduction:
    """A reduction with other works [J] of its causes (S,), also where they are by Simpson's rule."""
    causes = tuple(
        replace(each, work=float(work), simpson=None if each.simpson is None else float(work))
        for each, work in zip(found.contributions, works, strict=True)
    )
    return replace(found, contributions=causes)


def by_trapezoids(found: Reduction) -> list[float]:
    """Works by the trapezoid rule over the positions [J]."""
    return [float(np.sum((row[1:] + row[:-1]) * np.diff(found.phi)) / 2) for row in found.moment]


def over_half(found: Reduction) -> list[float]:
    """Works over the first half of the cycle [J]."""
    panels = found.cycle.panels
    middle = np.array([panels.edges[0] + found.cycle.period / 2])
    return [float(panels.primitive_at(part, middle)[0]) for part in found.parts]
