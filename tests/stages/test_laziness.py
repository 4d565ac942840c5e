"""What a scene does not have is neither imported nor computed."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import import_module

import pytest
from sparing import sparing

import tmmcalc
from tmmcalc import rooms as house
from tmmcalc.project import templates

from .observed import answer

CONFIGS = templates.folder()
NO_FRICTION = tuple(f"mechanism.joints[name={joint}].friction=0" for joint in ("A", "B", "B0"))


ROOMS = {room.name for room in house.ROOMS}
PLANE = ("solve", "shaking", "schemes", "circle", "moments", "redistribution", "contacts", "columns")


@cache
def imported(file: str, target: str | None = None, overrides: tuple[str, ...] = ()) -> frozenset[str]:
    return frozenset(answer("imported", str(CONFIGS / file), target, *overrides))


def within(names: frozenset[str], *packages: str) -> set[str]:
    """Those of the names that are one of the packages or lie in it.

    Of a whole room its theory counts: every start reads its manifest, and a spec its tables.
    """
    found = {name for name in names if name.startswith(tuple(f"{p}." for p in packages)) or name in packages}
    rooms = {p for p in packages if p.removeprefix("tmmcalc.") in ROOMS}
    read = {*rooms, *(f"{room}.{part}" for room in rooms for part in ("room", "wanted", "tables"))}
    return {
        name for name in found if name not in read and not name.startswith(tuple(f"{room}.tables." for room in rooms))
    }


def test_kinematics_imports_no_forces_and_no_machine() -> None:
    names = imported("shaper.toml", "kinematics")
    assert not within(names, "tmmcalc.linkage.forces", "tmmcalc.linkage.loads", "tmmcalc.machine", "scipy")


def test_forces_import_no_machine_and_no_balance() -> None:
    names = imported("shaper.toml", "forces")
    assert not within(names, "tmmcalc.machine", "tmmcalc.machine.balance", "tmmcalc.machine.reduction", "scipy")


@pytest.mark.parametrize("target", ["forces", "reduction"])
def test_a_scene_without_friction_imports_none(target: str) -> None:
    friction = ("tmmcalc.linkage.forces.friction", "tmmcalc.linkage.forces.locking")
    assert not within(imported("press.toml", target, NO_FRICTION), *friction)
    assert within(imported("press.toml", target), *friction) == set(friction)


@pytest.mark.parametrize("target", ["forces", "reduction"])
def test_pairs_without_friction_import_none(target: str) -> None:
    names = imported("press.toml", target, NO_FRICTION)
    assert within(names, "tmmcalc.linkage.forces.kinetostatics")
    assert not within(names, "tmmcalc.linkage.forces.friction", "tmmcalc.linkage.forces.locking")


def test_reduction_imports_no_motion() -> None:
    names = imported("shaper.toml", "reduction")
    machine = ("flywheel", "motion", "steady", "positional", "transient", "balancing", "power")
    assert not within(names, *(f"tmmcalc.machine.{name}" for name in machine), "tmmcalc.machine.balance", "scipy")


def test_a_scene_without_a_motor_imports_no_characteristic_and_no_transients() -> None:
    names = imported("press.toml")
    motors = ("catalogue", "characteristics", "choice", "direct_current", "gearing", "table")
    assert not within(
        names, *(f"tmmcalc.machine.motors.{name}" for name in motors), "tmmcalc.machine.transient.simulate"
    )
    assert not within(
        names, "tmmcalc.machine.transient.run", "tmmcalc.machine.tables.motor", "tmmcalc.machine.tables.shafts"
    )


@pytest.mark.parametrize("target", ["reduction", "balance"])
def test_stages_that_ask_for_no_motor_import_none(target: str) -> None:
    assert not within(imported("press.toml", target), "tmmcalc.machine.motors")


def test_power_imports_no_flywheel_and_no_motion() -> None:
    names = imported("press.toml", "power")
    machine = ("flywheel", "motion", "onemass", "positional", "recurrence", "regime", "settling", "stall", "steady")
    assert not within(names, *(f"tmmcalc.machine.{name}" for name in machine), "tmmcalc.core.numerics.collocation")


def test_positional_motion_imports_no_regime_under_a_motor() -> None:
    names = imported("press.toml", "motion")
    assert within(names, "tmmcalc.machine.positional", "tmmcalc.machine.flywheel.methods")
    under_motor = ("steady", "stall", "settling", "resisted", "flywheel.required", "flywheel.search")
    assert not within(names, *(f"tmmcalc.machine.{name}" for name in under_motor))


def test_motion_without_a_flywheel_imports_none_and_no_recurrence() -> None:
    names = imported("extreme/inertia-ratio.toml", "motion")
    assert within(names, "tmmcalc.machine.positional")
    assert not within(names, "tmmcalc.machine.flywheel", "tmmcalc.machine.recurrence", "tmmcalc.machine.steady")


def test_balance_of_a_linkage_imports_no_engine_and_no_rotor() -> None:
    names = imported("press.toml", "balance")
    parts = ("enginetask", "rotortask", "engines", "rotors", "firing", "cylinders", "grades")
    assert within(names, "tmmcalc.machine.balance.solve")
    assert not within(names, *(f"tmmcalc.machine.balance.{part}" for part in parts))


@pytest.mark.parametrize("file", ["rotor.toml", "in-line-engine.toml"])
def test_balance_without_a_linkage_imports_none(file: str) -> None:
    names = imported(file)
    assert within(names, "tmmcalc.machine.balance.rotors", "tmmcalc.machine.balance.engines")
    of_linkages = (f"tmmcalc.machine.balance.{part}" for part in PLANE)
    assert not within(names, *of_linkages, "tmmcalc.linkage.kinematics", "tmmcalc.machine.motors")


def test_a_scene_without_masses_imports_no_motion_and_no_balance() -> None:
    names = imported("extreme/massless.toml")
    machine = ("motion", "positional", "onemass", "regime", "recurrence", "flywheel", "transient", "balancing")
    left_out = (*(f"machine.{name}" for name in machine), "machine.balance")
    assert not within(names, *(f"tmmcalc.{name}" for name in left_out), "scipy")


@pytest.mark.parametrize("file", ["rotor.toml", "in-line-engine.toml"])
def test_a_scene_without_a_linkage_imports_no_forces(file: str) -> None:
    names = imported(file)
    assert not within(names, "tmmcalc.linkage.forces", "tmmcalc.machine.reduction", "tmmcalc.machine.flywheel", "scipy")


@sparing("file", ["shaper.toml", "press.toml", "piston-pump.toml", "four-stroke-engine.toml"], every=4)
def test_an_ordinary_project_runs_without_scipy(file: str) -> None:
    assert not within(imported(file), "scipy", "reportlab")


NOT_COMPUTED = [  # what is left out, the functions that compute it, spec, overrides, last stage
    ("friction", ["linkage.forces.friction:solve"], "press", NO_FRICTION, "forces"),
    ("friction", ["linkage.forces.friction:solve"], "press", NO_FRICTION, "reduction"),
    ("reduced inertia", ["machine.reduction.causes:reduced_inertia"], "extreme/massless", (), "reduction"),
    ("rods in two masses", ["machine.reduction.solve:lumped"], "extreme/massless", (), "reduction"),
    ("loads of inertia", ["linkage.forces.kinetostatics:inertia"], "extreme/massless", (), "forces"),
    ("the motor's regime", ["machine.steady:driven"], "press", (), "motion"),
    ("a resistance", ["machine.resisted:resisted"], "press", (), "motion"),
    ("the textbook's recurrence", ["machine.recurrence:on_nodes"], "press", (), "motion"),
    ("the motor's choice", ["machine.power:chosen_motor"], "shaper", (), "power"),
    ("the motor's choice", ["machine.power:chosen_motor", "machine.power:duty_of"], "press", (), "power"),
    ("an engine", ["machine.balance.enginetask:solve_engine"], "press", (), "balance"),
    ("a rotor", ["machine.balance.rotortask:solve_rotor"], "press", (), "balance"),
    ("a linkage", ["machine.balance.solve:solve_balance"], "rotor", (), "balance"),
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
    monkeypatch.setattr(import_module("tmmcalc.linkage.forces.friction"), "solve", refusing("friction"))
    with pytest.raises(AssertionError, match="friction is computed"):
        tmmcalc.run(press, target="forces")


def refusing(what: str) -> Callable[..., object]:
    def refuse(*_: object, **__: object) -> object:
        raise AssertionError(f"{what} is computed")

    return refuse


@sparing("file", ["pair.toml", "pair-internal.toml", "pair-rack.toml"], every=3)
def test_pairs_import_no_train_no_cam_and_no_machine(file: str) -> None:
    names = imported(file)
    train = ("search", "strength", "selection", "criteria", "network")
    others = (*(f"tmmcalc.gears.{part}" for part in train), "tmmcalc.cams", "tmmcalc.machine", "tmmcalc.linkage.forces")
    assert within(names, "tmmcalc.gears.meshing.solve")
    assert not within(names, *others, "scipy", "reportlab")


@sparing("file", [f"cam{name}.toml" for name in ("-translating", "-oscillating", "-flat", "", "-lantern")], every=4)
def test_a_cam_imports_no_gears_and_no_machine(file: str) -> None:
    names = imported(file)
    assert within(names, "tmmcalc.cams.program")
    assert not within(names, "tmmcalc.gears", "tmmcalc.machine", "tmmcalc.linkage.forces", "scipy", "reportlab")


def test_a_project_without_gears_and_cams_imports_none() -> None:
    assert not within(imported("shaper.toml"), "tmmcalc.gears", "tmmcalc.cams")


@sparing("file", ["shaper", "gears-coaxial", "cam-translating", "synth-crank-rocker"], every=2)
def test_a_project_without_constraints_imports_no_feasibility(file: str) -> None:
    of_constraints = ("feasibility", "gears.userconstraints")
    of_the_spec = ("feasibility.tables.constraints", "feasibility.tables.tasks.feasibility")
    assert not within(imported(f"{file}.toml"), *(f"tmmcalc.{part}" for part in (*of_constraints, *of_the_spec)))


def test_a_law_alone_imports_no_forces_of_cams() -> None:
    names = imported("cam-translating.toml", "cam_law")
    left_out = ("forces", "strength", "optimum", "synthesis", "profile", "elastic", "response")
    assert not within(names, *(f"tmmcalc.cams.{part}" for part in left_out))
