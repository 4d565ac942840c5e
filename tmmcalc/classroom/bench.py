"""A scene solved again and again with something wrong in it: what a mistake leaves as it is, is taken and not solved.

A stage is known by what it reads: its inputs, the outcomes that it takes of others, and the function that stands in
place of its own. So a wrong gravity solves forces, power and flywheel again, but neither positions nor gears.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from tmmcalc.core.mistake import Amiss
from tmmcalc.core.plan import plan
from tmmcalc.core.stage import Stage, arguments, of_scene
from tmmcalc.naming.scene import Scene
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.pipeline.outcome import Outcome, Results
from tmmcalc.pipeline.runner import run, upstream_of
from tmmcalc.rooms import STAGES

NONE: Mapping[str, Amiss] = {}
Key = tuple[Any, ...]


class Bench:
    """Stages of a scene up to the ``targets``; raises what a stage of the right solution raises."""

    def __init__(self, spec: Any, targets: Sequence[str]) -> None:
        self.targets = tuple(targets)
        solved = run(spec, target=self.targets, by_name=True)
        self.spec = solved.spec
        self.right = solved.outcomes
        self._alone = solved.alone
        self._known: dict[Key, tuple[Outcome | None, Any]] = {}
        for name, stage in self._stages(self.spec).items():
            if name in self.right:
                key = self._key(stage, stage.inputs(self.spec), self.right, None)
                self._known[key] = self.right[name], None

    def scene(self, spec: Any = None, amiss: Mapping[str, Amiss] = NONE) -> Scene:
        """The scene of another spec (None: the right one), with functions in place of those of its stages.

        A stage that comes to no result is left out, with those that need it. Raises `TmmError` where nothing can be
        planned.
        """
        spec = self.spec if spec is None else spec
        stages, done = self._stages(spec), dict[str, Outcome]()
        instead = {name: partial(wrong, self._own(stages[name])) for name, wrong in amiss.items()}
        running = plan(spec, self.targets, STAGES).running
        lost = set[str]()
        for name in running:
            stage = stages[name]
            if not lost.isdisjoint((*stage.needs, *stage.uses)):
                lost.add(name)
                continue
            found = self._outcome(stage, spec, done, amiss.get(name), instead.get(name))
            if found is None:
                lost.add(name)
            else:
                done[name] = found
        return Scene(spec, Results(done, self._alone), instead)

    def unchanged(self, scene: Scene) -> bool:
        """Whether all stages of a scene are those of the right solution."""
        found = scene.results
        return scene.spec is self.spec and all(
            name in found and found[name] is each.result for name, each in self.right.items() if name not in self._alone
        )

    def _stages(self, spec: Any) -> dict[str, Stage]:
        return of_scene(STAGES, spec)

    def _outcome(
        self, stage: Stage, spec: Any, done: Mapping[str, Outcome], wrong: Amiss | None, instead: Any
    ) -> Outcome | None:
        """The outcome of a stage; None where it comes to none."""
        try:
            inputs = stage.inputs(spec)
            key = self._key(stage, inputs, done, wrong)
            if key not in self._known:
                self._known[key] = self._computed(stage, inputs, done, instead or stage.solved), (dict(done), wrong)
            return self._known[key][0]
        except Exception:  # inputs may be worked out, too
            return None

    def _own(self, stage: Stage) -> Callable[..., Any]:
        """The function of a stage, which is not worked out again for what the right solution gives it."""

        def solve(*given: Any, **upstream: Any) -> Any:
            right = self.right.get(stage.name)
            if right is None or not self._is_right(stage, given, upstream):
                return stage.solved(*given, **upstream)
            return right.result

        return solve

    def _is_right(self, stage: Stage, given: tuple[Any, ...], upstream: Mapping[str, Any]) -> bool:
        own = {**stage.given(Results(self.right, self._alone)), **stage.settings, **stage.by_name}
        return (
            stage.name not in self._alone
            and own.keys() == upstream.keys()
            and all(upstream[name] is each for name, each in own.items())
            and content_hash(given) == content_hash(arguments(stage.inputs(self.spec)))
        )

    def _computed(self, stage: Stage, inputs: Any, done: Mapping[str, Outcome], solve: Any) -> Outcome | None:
        upstream = upstream_of(stage, Results(done, self._alone))
        try:
            with np.errstate(all="ignore"), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                record = stage.dump(solve(*arguments(inputs), **upstream, **stage.settings, **stage.by_name))
                outcome = Outcome(stage, lambda: record)
                outcome.result  # noqa: B018 -- a record that makes no result is none
        except Exception:  # whatever a wrong number does to a theory that never had to expect it
            return None
        return outcome

    def _key(self, stage: Stage, inputs: Any, done: Mapping[str, Outcome], wrong: Amiss | None) -> Key:
        """What a stage reads, by the outcomes that it takes; they stay as long as the bench."""
        read = done if stage.every else {name: done[name] for name in stage.upstream(done)}
        return stage.name, wrong, content_hash(inputs), tuple((name, id(each)) for name, each in read.items())
