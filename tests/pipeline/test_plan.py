"""The plan: what runs, what is left out, and why."""

from __future__ import annotations

import pytest

from tmmcalc.errors import UsageError
from tmmcalc.pipeline.plan import plan
from tmmcalc.pipeline.stages import STAGES

from . import toy


def reasons(spec: toy.Spec, target: str | None, stages=toy.STAGES) -> dict[str, tuple[bool, str]]:
    return {step.stage: (step.runs, step.reason) for step in plan(spec, target, stages).steps}


def test_whole_scene():
    assert reasons(toy.Spec(), None, toy.TOY) == {
        "geometry": (True, "needed by path"),
        "path": (True, "needed by energy"),
        "energy": (True, "asked for"),
    }


def test_target_needs_only_what_is_before_it():
    assert reasons(toy.Spec(), "path") == {
        "geometry": (True, "needed by path"),
        "path": (True, "asked for"),
        "energy": (False, "not needed by path"),
        "spare": (False, "not needed by path"),
    }


def test_scene_leaves_a_stage_out_and_all_that_need_it():
    assert reasons(toy.Spec(speed=None), None) == {
        "geometry": (True, "needed by path"),
        "path": (True, "asked for"),
        "energy": (False, "no [motor]: speed is constant"),
        "spare": (False, "needs energy, which is left out"),
    }


def test_target_that_the_scene_leaves_out_runs_nothing():
    scene = plan(toy.Spec(speed=None), "energy", toy.STAGES)
    assert scene.running == ()
    assert scene.step("energy").reason == "no [motor]: speed is constant"
    assert scene.step("path").reason == "only energy needs it, which is left out"


def test_steps_that_the_target_does_not_need_are_marked():
    scene = plan(toy.Spec(speed=None), "path", toy.STAGES)
    assert [step.asked for step in scene.steps] == [True, True, False, False]


def test_unknown_target():
    with pytest.raises(UsageError, match="did you mean energy") as caught:
        plan(toy.Spec(), "enrgy", toy.STAGES)
    assert caught.value.exit_code == 2


def test_registry_names_each_stage_after_the_ones_it_needs():
    seen: set[str] = set()
    for name, stage in STAGES.items():
        assert stage.name == name
        assert seen.issuperset(stage.needs)
        assert "\n" not in stage.title
        seen.add(name)
    assert list(STAGES)[:2] == ["structure", "kinematics"]
