"""Which numbers of a spec matter for which results: partial derivatives with their errors, ranked."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal, TypedDict

import numpy as np

from tmmcalc.batch.reading import frame_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.design.differences import LEVELS, Slope
from tmmcalc.design.exact import Exact
from tmmcalc.design.ladders import Ladders, Progress, Reach
from tmmcalc.design.model import Model, solver_of
from tmmcalc.design.sizes import scales, varied
from tmmcalc.naming.keys import chosen
from tmmcalc.project.loader import Variants, read_text

Way = Literal["exact", "differences"]


class Ways(TypedDict, total=False):
    """Who solves the variants of `sensitivity`, and who is told."""

    jobs: int | None  # processes; None: as many as pay
    scheduler: str | None  # address of a cluster
    tell: Callable[[str], None]  # what there is to be said
    progress: Progress


@record
class Partial:
    """The derivative of one result with respect to one key, in the units of both."""

    name: str  # of the result
    key: str
    value: float  # of the key
    slope: Slope
    relative: float  # per cent of the result for a per cent of the key; NaN where either is 0
    way: Way = "differences"

    @property
    def error(self) -> float:
        """Of the derivative, relative to it; NaN where there is none, 0 of one that is exactly nothing."""
        size = abs(self.slope.value)
        return self.slope.error / size if size else 0.0

    @property
    def acts(self) -> bool:
        """Whether the key has an influence that is more than the error of its derivative, or none that settles."""
        return self.slope.side in ("kink", "jump", "none") or abs(self.slope.value) > self.slope.error


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
    keys = chosen(data, to)
    frame = frame_of(file, fixed, keys, of)
    sizes = scales(frame.axes)
    reasons = varied(frame, sizes)
    for axis, reason in zip(frame.axes, reasons, strict=True):
        if reason and axis.key in to:
            raise UsageError(f"{axis.key} takes no small change: {reason}", where="--to", remedy="leave it out")
    kept = [k for k, reason in enumerate(reasons) if not reason]
    whole, frame = frame, replace(frame, axes=tuple(frame.axes[k] for k in kept))
    model = Model(frame, solver_of(frame, 2 * LEVELS * len(kept), jobs, scheduler, tell))
    wide = [sizes[k] for k in kept]
    given = Exact(frame, model.names, wide).at(model.nominal.tolist(), model.run)
    found = Ladders(model, np.array(wide), given, progress)
    partials = tuple(
        Partial(
            name=name,
            key=model.keys[k],
            value=float(model.nominal[k]),
            slope=found.slopes[k][m],
            relative=_relative(model, k, m, found.slopes[k][m]),
            way="exact" if found.exact[k][m] else "differences",
        )
        for m, name in enumerate(model.names)
        for k in range(len(kept))
    )
    left = tuple((axis.key, reason) for axis, reason in zip(whole.axes, reasons, strict=True) if reason)
    return Sensitivity(model.names, tuple(model.found.tolist()), partials, found.reaches, left, found.solved)


def _relative(model: Model, k: int, m: int, found: Slope) -> float:
    value, result = float(model.nominal[k]), float(model.found[m])
    return found.value * value / result if value and result else np.nan
