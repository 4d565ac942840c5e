"""The trap of the splitting: where a dyad changes its sign while the group goes on regularly."""

from __future__ import annotations

from typing import cast

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Real
from tmmcalc.linkage import solvers
from tmmcalc.linkage.assembly import coordinate
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loops.splitstep import SplitStep, split_chain
from tmmcalc.linkage.loops.step import LoopStep
from tmmcalc.linkage.results import Grade

ZOOMS = 4  # that narrow down where a sign changes
PARTS = 16  # of the interval, by each


def split_grades(chain: Chain, x: Real) -> tuple[Grade, ...]:
    """How the groups of a chain are split, and every change of sign of a dyad between the coordinates x (n,)."""
    split = split_chain(chain)
    placed = split.evaluate(x, order=0).placed
    found = list[Grade]()
    for k, step in enumerate(split.steps):
        if not step.group.kind:
            found += _grades(split, k, x, placed[k])
    return tuple(found)


def _grades(chain: Chain, k: int, x: Real, variant: np.ndarray) -> list[Grade]:
    """How one group is split, and its changes of sign."""
    step = cast(SplitStep, chain.steps[k])
    split, where = step.split, Phrase("splitting of {name}", name=step.group.name)
    dyads = [group.name for group in split.dyads]
    how = Phrase(
        "link {removed} is removed, the angle of link {trial} is tried, dyads {dyads}",
        removed=split.removed,
        trial=split.trial,
        dyads=dyads,
    )
    found = [Grade("note", where, how)]
    for i in np.flatnonzero(np.diff(variant)):
        at = _change(chain, k, float(x[i]), float(x[i + 1]))
        changed = [
            Phrase(
                "{name} from {before:+d} to {after:+d}",
                name=one.group.name,
                before=one.variant,
                after=other.variant,
            )
            for one, other in zip(split.variants[variant[i]], split.variants[variant[i + 1]], strict=True)
            if one.variant != other.variant
        ]
        regularity = _regularity(chain, k, step.loops, at)
        message = Phrase(
            "the sign of {changed} changes at {coordinate}, where the group itself is regular ({regularity:.2g}): "
            "with frozen signs the iteration ends there or jumps; both signs were tried",
            changed=changed,
            coordinate=coordinate(chain, at),
            regularity=regularity,
        )
        found.append(Grade("warning", where, message))
    return found


def _change(chain: Chain, k: int, low: float, high: float) -> float:
    """The coordinate between two at which the signs change."""
    for _ in range(ZOOMS):
        x = np.linspace(low, high, PARTS + 1)
        variant = chain.evaluate(x, order=0, steps=k + 1).placed[k]
        i = int(np.argmax(variant[1:] != variant[0]))
        low, high = float(x[i]), float(x[i + 1])
    return (low + high) / 2


def _regularity(chain: Chain, k: int, step: LoopStep, at: float) -> float:
    """How regular the group itself is there."""
    x = np.array([at])
    _, placed = step.advance(chain.evaluate(x, order=0, steps=k).motions, {}, x, 0, solvers.closed)
    return float(step.regularity(placed)[0])
