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
        self._own = _Asked(self.spec)
        for name, stage in self._own.stages.items():
            if name in self.right:
                self._known[self._key(stage, self._own, self.right, None)] = self.right[name], None

    def scene(self, spec: Any = None, amiss: Mapping[str, Amiss] = NONE, targets: Sequence[str] | None = None) -> Scene:
        """The scene of another spec (None: the right one), with functions in place of those of its stages.

        It goes up to ``targets``, None: those of the bench. A stage that comes to no result is left out, with those
        that need it. Raises `TmmError` where nothing can be planned.
        """
        asked = self._own if spec is None or spec is self.spec else _Asked(spec)
        done = dict[str, Outcome]()
        instead = {name: partial(wrong, self._function(asked.stages[name])) for name, wrong in amiss.items()}
        lost = set[str]()
        for name in plan(asked.spec, self.targets if targets is None else targets, STAGES).running:
            stage = asked.stages[name]
            if not lost.isdisjoint((*stage.needs, *stage.uses)):
                lost.add(name)
                continue
            found = self._outcome(stage, asked, done, amiss.get(name), instead.get(name))
            if found is None:
                lost.add(name)
            else:
                done[name] = found
        return Scene(asked.spec, Results(done, self._alone), instead)

    def unchanged(self, scene: Scene) -> bool:
        """Whether all stages that a scene has are those of the right solution."""
        found, right = scene.results, Results(self.right, self._alone)
        return scene.spec is self.spec and all(
            name in right and found[name] is right[name] for name in found if name not in self._alone
        )

    def _outcome(
        self, stage: Stage, asked: _Asked, done: Mapping[str, Outcome], wrong: Amiss | None, instead: Any
    ) -> Outcome | None:
        """The outcome of a stage; None where it comes to none."""
        try:
            key = self._key(stage, asked, done, wrong)
            if key not in self._known:
                inputs = asked.inputs(stage)[0]
                self._known[key] = self._computed(stage, inputs, done, instead or stage.solved), (dict(done), wrong)
            return self._known[key][0]
        except Exception:  # inputs may be worked out, too
            return None

    def _function(self, stage: Stage) -> Callable[..., Any]:
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
            and content_hash(given) == content_hash(arguments(self._own.inputs(stage)[0]))
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

    def _key(self, stage: Stage, asked: _Asked, done: Mapping[str, Outcome], wrong: Amiss | None) -> Key:
        """What a stage reads, by the outcomes that it takes; they stay as long as the bench."""
        read = done if stage.every else {name: done[name] for name in stage.upstream(done)}
        return stage.name, wrong, asked.inputs(stage)[1], tuple((name, id(each)) for name, each in read.items())


class _Asked:
    """A spec, with its stages and what they read of it, each found once."""

    def __init__(self, spec: Any) -> None:
        self.spec, self.stages = spec, of_scene(STAGES, spec)
        self._inputs: dict[str, tuple[Any, str]] = {}

    def inputs(self, stage: Stage) -> tuple[Any, str]:
        """What a stage reads of the spec, and its hash."""
        if stage.name not in self._inputs:
            own = stage.inputs(self.spec)
            self._inputs[stage.name] = own, content_hash(own)
        return self._inputs[stage.name]
