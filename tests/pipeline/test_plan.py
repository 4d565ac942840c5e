"""The plan: what runs, what is left out, and why."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tmmcalc.core.errors import UsageError
from tmmcalc.core.plan import plan
from tmmcalc.project import parse_spec
from tmmcalc.rooms import STAGES

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


def test_the_reason_of_the_scene_itself_comes_before_that_of_the_chain():
    spare = replace(toy.STAGES["spare"], wanted=f"{toy.__name__}:energy_wanted")
    found = reasons(toy.Spec(speed=None), None, {**toy.STAGES, "spare": spare})
    assert found["spare"] == (False, "no [motor]: speed is constant")


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
    assert list(STAGES)[:3] == ["synthesis", "structure", "kinematics"]
    assert list(STAGES)[-1] == "feasibility"  # it may judge any of the others


TORQUE = '[torque]\nspeed = "180 rpm"\nformula = "sin(theta)"\n'
ROTOR = """
[rotor]
mass = 40
center = 0.2
bearings = [0, 0.4]
speed = 300
planes = [0.1, 0.3]
unbalances = [{ moment = 0.001, position = 0 }]
"""
STEADY = '[[transients]]\nduration = "5 s"\nmotor = "off"\nfrom = "steady"\n'


@pytest.mark.parametrize(
    ("text", "stage", "reason"),
    [
        (ROTOR, "structure", "no [mechanism]"),
        (ROTOR, "kinematics", "no [mechanism]"),
        (ROTOR, "forces", "no [mechanism]"),
        (ROTOR, "reduction", "no [mechanism]"),
        (TORQUE, "forces", "no [mechanism]"),
        (TORQUE, "motion", "no [motor]: the speed is constant"),
        (TORQUE + "[motion]\n", "motion", "no masses and no constant inertia: nothing stores kinetic energy"),
    ],
)
def test_what_a_spec_without_mechanism_leaves_out(text: str, stage: str, reason: str):
    step = plan(parse_spec(text)).step(stage)
    assert (step.runs, step.reason) == (False, reason)


@pytest.mark.parametrize("more", ["inertia = 3\n[motion]\n", f"inertia = 3\n{STEADY}", "[motion]\ninertia = 3\n"])
def test_a_torque_diagram_moves_what_has_inertia(more: str):
    assert plan(parse_spec(TORQUE + more)).step("motion").runs
