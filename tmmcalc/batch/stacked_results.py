"""The results of every variant by itself, of stages that are solved for all together as far as they can be.

Linkage and steady motion are; the other stages of the scene run for each variant on what it has so far.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.quantities import told
from tmmcalc.batch.stacked_inputs import STUCK, Inputs, Together
from tmmcalc.batch.stacked_machine import MACHINE, given_of, motions_of_each
from tmmcalc.batch.task import OK, Row, Task, verdict
from tmmcalc.core.errors import TmmError
from tmmcalc.core.numerics.alike import Rows
from tmmcalc.core.stage import arguments
from tmmcalc.machine.tables.tasks.machine import speed_key
from tmmcalc.pipeline.runner import upstream_of

if TYPE_CHECKING:
    from tmmcalc.batch.stacked_machine import Machine
    from tmmcalc.linkage.stacked.scene import Block, Same
    from tmmcalc.machine.stacked.reduction import Cycles
    from tmmcalc.pipeline.outcome import RunResult

Found = dict[str, Any]  # results by stage
Values = NDArray[np.floating[Any]]
Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]

BLOCK = 32  # variants: more take no less time each, and are lost where a process is killed
TOGETHER = ("structure", "kinematics", "paths", "forces", "reduction", "power")
MOVED = ("flywheel", "motion")  # and these with a motor


class _Variant(NamedTuple):
    """What a variant has so far, and its machine."""

    results: Found
    machine: Machine | None


class Results:
    """Solves blocks of points, of which any facts or columns are asked for."""

    block = BLOCK  # points that are solved together

    def __init__(self, task: Task, inputs: Inputs, same: Same, base: RunResult, *, with_motion: bool) -> None:
        self._task, self._inputs, self._same, self._base = task, inputs, same, base
        self._stages = {name: outcome.stage for name, outcome in base.outcomes.items()}
        self._motion = with_motion  # those of all variants are found together
        self._key = speed_key(inputs.spec(inputs.first))

    @property
    def alone(self) -> tuple[str, ...]:
        """Stages that each variant runs by itself."""
        together = (*TOGETHER, *(MOVED if self._motion else ()))
        return tuple(name for name in self._stages if name not in together)

    def rows(self, points: Sequence[int], given: Values) -> Together[Row]:
        """Rows of those points of a block that are solved together; ``given`` are their values (v, axes)."""
        shared: dict[tuple[str, ...], tuple[str, ...]] = {}  # a thousand variants have the names of one
        found, (every, apart, refused) = {}, self.results(given)
        for k, results in every.items():
            try:
                values = self._quantities(results)
            except Exception as fault:  # one variant that breaks the program must not end the others
                apart[k] = verdict(fault)[1]
                continue
            names = shared.setdefault(tuple(values), tuple(values))
            found[k] = Row(points[k], OK, "", names, array("d", values.values()))
        return Together(found, apart, refused)

    def results(self, given: Values) -> Together[Found]:
        """Results by stage of those variants, of values (v, axes), that are solved together and have all of them."""
        every = Together[Found]({}, {}, {})
        for which, (variants, stuck) in self._inputs.parts(given, self._solved, every.apart):
            every.refused.update(dict.fromkeys(which[stuck].tolist(), STUCK))
            for k, variant in variants.items():
                at = int(which[k])
                self._complete(at, given[at], variant, every)
        return every

    def _quantities(self, results: Found) -> dict[str, float]:
        task = self._task
        asked = [*self._stages] if task.patterns or not task.targets else [*task.targets]
        return dict(told(results, task.patterns, stages=asked))

    def _solved(self, tree: Any, count: int) -> tuple[dict[int, _Variant], Flags]:
        """What is solved together of the variants of stacked inputs, by their numbers, of those that are clear.

        And which of all (v,) surely do not assemble.
        """
        from tmmcalc.linkage.stacked.paths import paths_records
        from tmmcalc.linkage.stacked.scene import block_of
        from tmmcalc.machine.stacked.records import forces_records, kinematics_records, reduction_records

        mechanism, loading, machine, paths = tree
        block = block_of(self._same, count, mechanism, loading, tracked=True, told=True)
        some, machines = np.flatnonzero(block.settled.clear), Rows(machine)
        found = {v: _Variant({"structure": self._base.results["structure"]}, machines(v)) for v in some.tolist()}
        if some.size:
            some = _noted(found, some, "kinematics", kinematics_records(block, some))
        if some.size and "paths" in self._stages:
            own = paths_records(block, some, paths, _of(found, some, "kinematics"), self._base.results["paths"])
            some = _noted(found, some, "paths", own)
        if some.size and "forces" in self._stages:
            some = _noted(found, some, "forces", forces_records(block, some, _of(found, some, "kinematics")))
        if some.size and "reduction" in self._stages:
            reductions, cycles = reduction_records(block, some, _of(found, some, "kinematics"))
            before, some = some, _noted(found, some, "reduction", reductions)
            if self._motion and some.size and "power" in self._stages:
                self._move(block, machine, before, cycles, found)
        return found, block.settled.stuck

    def _move(self, block: Block, machine: Machine, some: Indices, cycles: Cycles, found: dict[int, _Variant]) -> None:
        """Find the flywheels and the steady motions of variants; those that are not clear are left out."""
        from tmmcalc.batch.stacked_flywheel import flywheels_of_each

        for v in some.tolist():
            if v in found:
                self._run("power", found[v])
        for name, each in (("flywheel", flywheels_of_each), ("motion", motions_of_each)):
            if name in self._stages:
                own = [found[v].results if v in found else None for v in some.tolist()]
                made = each(block, some, machine, cycles, own, self._key)
                there = [k for k, results in enumerate(own) if results is not None]
                _noted(found, some[there], name, [made[k] for k in there])

    def _complete(self, k: int, values: Values, variant: _Variant, every: Together[Found]) -> None:
        """Run the stages that are left, and note the variant if all have a result."""
        try:
            for name in self._stages:
                if name not in variant.results:
                    self._run(name, variant, values)
        except TmmError:
            return  # solved alone it says why
        except Exception as fault:
            every.apart[k] = verdict(fault)[1]
            return
        every.found[k] = variant.results

    def _run(self, name: str, variant: _Variant, values: Values | None = None) -> None:
        """Run a stage for one variant."""
        stage = self._stages[name]
        if name in MACHINE and variant.machine is not None:
            given: Any = given_of(name, variant.machine, self._key)
        else:
            given = stage.inputs(self._inputs.spec(self._inputs.first if values is None else values))
        upstream = upstream_of(stage, variant.results)
        variant.results[name] = stage.solved(*arguments(given), **upstream, **stage.settings)


def _of(found: dict[int, _Variant], some: Indices, stage: str) -> list[Any]:
    return [found[v].results[stage] for v in some.tolist()]


def _noted(found: dict[int, _Variant], some: Indices, stage: str, results: Sequence[Any]) -> Indices:
    """Note the results of a stage; variants without one are dropped. The others."""
    for v, result in zip(some.tolist(), results, strict=True):
        if result is None:
            del found[v]
        else:
            found[v].results[stage] = result
    return np.array([v for v in some.tolist() if v in found], np.intp)
