"""Derivatives of results that stages give exactly, by the keys of a spec at a place."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.batch.task import Task
from tmmcalc.core.derivatives import Derivatives
from tmmcalc.core.facts import named
from tmmcalc.core.stage import STAGES
from tmmcalc.design.differences import Slope
from tmmcalc.design.inputs import Inputs, parts_of, same
from tmmcalc.naming.language import Name, parse
from tmmcalc.naming.slopes import Sides, slopes_of_rows
from tmmcalc.naming.table import table_of

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec

APART = 3.0  # times the error that two sides differ by to be those of a kink


class Exact:
    """Exact derivatives of named results of a frame by its keys, of which ``sizes`` (k,) are ordinary changes."""

    def __init__(self, frame: Task, names: Sequence[str], sizes: Sequence[float]) -> None:
        self._names, self._sizes = [parse(name) for name in names], sizes
        asked = dict.fromkeys(name.stage for name in self._names)
        self._stages = tuple(stage for stage in asked if stage in STAGES and STAGES[stage].part("derivatives"))
        self._inputs = Inputs(frame, self._stages)

    def spec(self, values: Sequence[float]) -> Spec:
        """The spec where the keys have these values; raises `SpecError` where it is none."""
        return self._inputs.spec(values)

    def at(self, values: Sequence[float], run: RunResult) -> list[list[Slope | None]]:
        """Derivatives by key and result where the keys have these values; ``run`` is what was found there.

        None of what is not given exactly.
        """
        found: list[list[Slope | None]] = [[None] * len(self._names) for _ in self._sizes]
        read = self._inputs.of(self._inputs.spec(values)) if self._stages else {}
        stages = [stage for stage in read if stage in run.results and self._reads_alike(stage, read[stage], run)]
        if not stages:
            return found
        slopes = self._inputs.slopes(values, self._sizes)
        known, parts = np.flatnonzero(np.isfinite(slopes.error)).tolist(), parts_of(read)
        for stage in stages:
            own = STAGES[stage].part("derivatives")
            try:
                made: Derivatives | None = own(
                    read[stage], run.results, slopes.value[:, parts[stage]], self._facts(stage)
                )
            except np.linalg.LinAlgError:  # at a dead point itself
                continue
            for m, name in enumerate(self._names):
                sides = None if made is None or name.stage != stage else _sides(name, made, run.results[stage])
                if sides is not None:
                    for k in known:
                        found[k][m] = _slope(sides, k, float(slopes.error[k]))
        return found

    def _facts(self, stage: str) -> frozenset[str]:
        """Keys of the facts of a stage that are asked for."""
        return frozenset(_key(name) for name in self._names if name.fact and name.stage == stage)

    @staticmethod
    def _reads_alike(stage: str, read: Any, run: RunResult) -> bool:
        """Whether a stage has read what the spec says, and nothing that other stages put in its place."""
        return same(read, STAGES[stage].inputs(run.spec))


def _key(name: Name) -> str:
    """The key of a fact, as its stage tells it."""
    return f"{name.what}[{name.unit}]" if name.unit else name.what


def _sides(name: Name, made: Derivatives, result: Any) -> Sides | None:
    """Derivatives of a named result along all directions, if they are given."""
    if name.fact:
        change = made.facts.get(_key(name))
        return None if change is None else Sides(change.value, change.value, change.error)
    table = table_of(name.stage, result)
    headers = () if table is None else [each for each in table.headers if named(each)[0] == name.what]
    return slopes_of_rows(name, table, headers[0], made.columns) if table is not None and headers else None


def _slope(sides: Sides, k: int, read: float) -> Slope:
    """The derivative by one key, of whose numbers the slopes are known to ``read``."""
    right, left = float(sides.right[k]), float(sides.left[k])
    error = float(sides.error[k]) + read * max(abs(right), abs(left))
    if abs(right - left) > APART * error:
        return Slope(np.nan, error, "kink", right, left, np.nan)
    return Slope(right, error, "both", right, left, np.nan)
