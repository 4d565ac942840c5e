"""What a scene does not have is neither imported nor computed."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from importlib import import_module

import pytest

import tmmcalc
from tmmcalc.spec import templates

CONFIGS = templates.folder()
RUN = """
import sys, tmmcalc
from tmmcalc.pipeline.runner import run
run(tmmcalc.load_spec({file!r}, {overrides!r}), target={target!r})
print(" ".join(sorted(name for name in sys.modules if name.startswith(("tmmcalc.", "scipy", "matplotlib")))))
"""
NO_FRICTION = tuple(f"mechanism.joints[name={joint}].friction=0" for joint in ("A", "B", "B0"))


def imported(file: str, target: str | None = None, overrides: tuple[str, ...] = ()) -> set[str]:
    code = RUN.format(file=str(CONFIGS / file), target=target, overrides=overrides)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


def within(names: set[str], *packages: str) -> set[str]:
    """Those of the names that are one of the packages or lie in it."""
    return {name for name in names if name.startswith(tuple(f"{p}." for p in packages)) or name in packages}


def test_kinematics_imports_no_forces_and_no_machine() -> None:
    names = imported("shaper.toml", "kinematics")
    assert not within(names, "tmmcalc.linkage.forces", "tmmcalc.linkage.loads", "tmmcalc.machine", "scipy")


def test_forces_import_no_machine_and_no_balance() -> None:
    names = imported("shaper.toml", "forces")
    assert not within(names, "tmmcalc.machine", "tmmcalc.linkage.balance", "tmmcalc.linkage.reduction", "scipy")


def test_reduction_imports_no_motion() -> None:
    names = imported("shaper.toml", "reduction")
    machine = ("flywheel", "motion", "steady", "positional", "transient", "balancing", "power")
    assert not within(names, *(f"tmmcalc.machine.{name}" for name in machine), "tmmcalc.linkage.balance", "scipy")


def test_a_scene_without_a_motor_imports_no_search_of_one_and_no_transients() -> None:
    names = imported("press.toml")
    assert not within(names, "tmmcalc.machine.motors.choice", "tmmcalc.machine.transient.simulate")
    assert not within(names, "tmmcalc.machine.transient.run", "tmmcalc.spec.motor", "tmmcalc.spec.shafts")


def test_a_scene_without_masses_imports_no_motion_and_no_balance() -> None:
    names = imported("extreme/massless.toml")
    left_out = ("machine.motion", "machine.positional", "machine.transient", "machine.balancing", "linkage.balance")
    assert not within(names, *(f"tmmcalc.{name}" for name in left_out), "scipy")


@pytest.mark.parametrize("file", ["rotor.toml", "in-line-engine.toml"])
def test_a_scene_without_a_linkage_imports_no_forces(file: str) -> None:
    names = imported(file)
    assert not within(names, "tmmcalc.linkage.forces", "tmmcalc.linkage.reduction", "tmmcalc.machine.flywheel", "scipy")


@pytest.mark.parametrize("file", ["shaper.toml", "press.toml", "piston-pump.toml", "four-stroke-engine.toml"])
def test_an_ordinary_project_runs_without_scipy(file: str) -> None:
    assert not within(imported(file), "scipy", "matplotlib")


NOT_COMPUTED = [  # what is left out, the functions that compute it, spec, overrides, last stage
    ("friction", ["linkage.forces.cut:solve", "linkage.forces.drive:solve"], "press", NO_FRICTION, "forces"),
    ("friction", ["linkage.forces.cut:solve", "linkage.forces.drive:solve"], "press", NO_FRICTION, "reduction"),
    ("loads of inertia", ["linkage.forces.kinetostatics:inertia"], "extreme/massless", (), "forces"),
    ("the motor's regime", ["machine.steady:driven", "machine.motion:driven"], "press", (), "motion"),
    ("the motor's choice", ["machine.power:chosen_motor"], "shaper", (), "power"),
    ("the motor's choice", ["machine.power:chosen_motor", "machine.power:duty_of"], "press", (), "power"),
    ("an engine", ["machine.balancing.task:solve_engine"], "press", (), "balance"),
    ("a rotor", ["machine.balancing.task:solve_rotor"], "press", (), "balance"),
    ("a linkage", ["linkage.balance.task:solve_balance"], "rotor", (), "balance"),
]  # fmt: skip


@pytest.mark.parametrize(("what", "functions", "spec", "overrides", "stage"), NOT_COMPUTED)
def test_nothing_is_computed_in_vain(
    what: str,
    functions: list[str],
    spec: str,
    overrides: tuple[str, ...],
    stage: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = tmmcalc.load_spec(CONFIGS / f"{spec}.toml", overrides)
    tmmcalc.run(scene, target=stage)  # a module that is imported later would keep the refusal
    homes = [function.split(":") for function in functions]
    for module, name in [(import_module(f"tmmcalc.{home}"), name) for home, name in homes]:
        monkeypatch.setattr(module, name, refusing(what))
    result = tmmcalc.run(scene, target=stage)
    assert stage in result.outcomes


def test_the_refusals_refuse(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same functions are asked where the scene has the part."""
    press = tmmcalc.load_spec(CONFIGS / "press.toml")
    tmmcalc.run(press, target="forces")
    monkeypatch.setattr(import_module("tmmcalc.linkage.forces.cut"), "solve", refusing("friction"))
    with pytest.raises(AssertionError, match="friction is computed"):
        tmmcalc.run(press, target="forces")


def refusing(what: str) -> Callable[..., object]:
    def refuse(*_: object, **__: object) -> object:
        raise AssertionError(f"{what} is computed")

    return refuse
