"""What a scene does not need is not imported, computed or written: every kind of scene in a process of its own.

The sentences of ``plan --why`` and its tables of packages are held against what is observed there.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from typing import Any, get_args

import pytest
from sparing import sparing

from tmmcalc.core.plan import plan
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.gears.wanted import NO_KEPT
from tmmcalc.linkage.stages.forces import GEAR, INERTIA
from tmmcalc.linkage.stages.kinematics import EXTRA, LOOPS
from tmmcalc.linkage.stages.synthesis import CLOSED, NO_SEARCH, NO_SIFT
from tmmcalc.linkage.wanted import FRICTION, NO_CSV, SLIDES, SPRINGS
from tmmcalc.machine.stages.balance import NO_ENGINE, NO_LINKAGE, NO_ROTOR
from tmmcalc.machine.stages.motion import NO_WHEEL
from tmmcalc.machine.stages.power import GIVEN_MOTOR, NO_MOTOR
from tmmcalc.machine.stages.reduction import DIAGRAM, REDUCED, RODS
from tmmcalc.machine.stages.transient import NO_SHAFTS, NO_STEADY, POSITIONAL
from tmmcalc.machine.wanted import NO_REGIME
from tmmcalc.manipulators.stages.manipulator import NO_OBSTACLES
from tmmcalc.pipeline.store import CSV_ROWS
from tmmcalc.pipeline.why import explain, packages
from tmmcalc.project import Spec, load_spec, templates
from tmmcalc.rooms import STAGES, TABLES
from tmmcalc.spec.deferred import DeferredTable
from tmmcalc.vibration.stages.vibrator import NO_CURVE, NO_DRIVE, NO_EXCITATION, NO_START

from .observed import answer

CONFIGS = templates.folder()
ROOMS = ("linkage", "machine", "gears", "cams", "vibration", "extras", "manipulators", "feasibility")
OUTER = ("cli", "report", "batch", "accuracy", "stress")  # no room: a run needs none of them
ON_MODELS = {"linkage.model", "linkage.results", "linkage.structure", "linkage.matching"}
READ = ("room", "wanted", "tables", "stages")  # parts of a room that a spec is read and planned with
TOLD = ("facts", "pictures", "accuracy")  # parts of a room that a run needs not

KINDS = {  # a scene of every kind, the rooms that it needs
    "four-bar": ("linkage",),  # kinematics alone
    "hydraulic-lift": ("linkage", "machine"),  # forces and their reduction, no motor, no cycle
    "scotch-yoke": ("linkage", "machine"),  # forces without friction
    "class-three": ("linkage", "machine"),  # a group of class III
    "press": ("linkage", "machine"),  # friction, a flywheel, no motor
    "shaper": ("linkage", "machine"),  # friction, a motor
    "elastic-drive": ("linkage", "machine"),  # a stiff drive
    "extreme/massless": ("linkage", "machine"),
    "rotor": ("machine",),
    "in-line-engine": ("machine",),
    "gears-kinematic": ("gears",),
    "gears-circulating": ("gears",),
    "pair-rack": ("gears",),
    "wheel": ("gears",),
    "cam-flat": ("cams",),
    "cam-lantern": ("cams",),
    "manipulator": ("manipulators",),
    "manipulator-direct": ("manipulators",),
    "extra-bearing": ("extras",),
    "extra-ball": ("extras",),
    "synth-slider-crank": ("linkage",),
    "synth-dwell": ("linkage",),
    "crane-luffing": ("linkage",),
    "vibratory-device": ("machine", "vibration"),
    "pendulum-rotor": ("machine", "vibration"),
}

SHORTER = {  # the same scenes, with less to integrate
    "elastic-drive": ('transients=[{duration = "20 ms", from = "steady"}]',),
    "vibratory-device": ('vibrator.drive.duration="0.2 s"', 'vibrator.start.duration="0.2 s"'),
}

# Sentences of what a stage leaves out, and the functions that are called if it does not; "path:" are all of a module.
CALLED = {
    ("kinematics", LOOPS): ("linkage/loops/",),
    ("forces", FRICTION): ("linkage/forces/friction.py:", "linkage/forces/locking.py:"),
    ("reduction", FRICTION): ("linkage/forces/friction.py:", "linkage/forces/locking.py:"),
    ("forces", INERTIA): ("linkage/loads/sources.py:inertia",),
    ("reduction", REDUCED): ("machine/reduction/inertia.py:reduced_inertia",),
    ("forces", SPRINGS): ("linkage/loads/sources.py:springs",),
    ("reduction", SPRINGS): ("linkage/loads/sources.py:springs",),
    ("forces", GEAR): ("linkage/forces/drive.py:mesh_force",),
    ("reduction", RODS): ("machine/reduction/inertia.py:lumped",),
    ("reduction", DIAGRAM): ("machine/reduction/solve.py:solve_reduction",),
    ("power", NO_MOTOR): ("machine/power.py:duty_of", "machine/power.py:chosen_motor"),
    ("power", GIVEN_MOTOR): ("machine/power.py:chosen_motor",),
    ("flywheel", NO_REGIME): ("machine/flywheel/required.py:",),
    ("motion", NO_REGIME): ("machine/steady.py:driven",),
    ("motion", NO_WHEEL): ("machine/stages/shaft.py:shaft_ratio",),
    ("transient", NO_SHAFTS): ("machine/transient/solve.py:_rigid_moments",),
    ("transient", NO_STEADY): ("machine/transient/solve.py:_steady",),
    ("balance", NO_LINKAGE): ("machine/balance/solve.py:",),
    ("balance", NO_ENGINE): ("machine/balance/engines.py:", "machine/balance/enginetask.py:"),
    ("balance", NO_ROTOR): ("machine/balance/rotors.py:", "machine/balance/rotortask.py:"),
    ("train", NO_KEPT): ("gears/userconstraints.py:kept_sets",),
    ("criteria", NO_KEPT): ("gears/userconstraints.py:kept_trains",),
    ("synthesis", NO_SIFT): ("linkage/stages/sifted.py:",),
    ("synthesis", CLOSED): ("linkage/stages/sifted.py:",),
    ("synthesis", NO_SEARCH): ("linkage/synthesis/dwell/optimum.py:",),
    ("manipulator", NO_OBSTACLES): ("manipulators/contacts.py:_path_contacts",),
    ("vibrator", NO_EXCITATION): ("vibration/vibrator/forced.py:steady",),
    ("vibrator", NO_CURVE): ("vibration/vibrator/forced.py:peaks",),
    ("vibrator", NO_START): ("vibration/vibrator/runup.py:run_up",),
    ("vibrator", NO_DRIVE): ("vibration/vibrator/rotor.py:driven",),
}
WIDER = {  # where one of these is said, or the scene is of another kind, the sentence itself says nothing more
    GIVEN_MOTOR: NO_MOTOR,
    CLOSED: NO_SIFT,
    NO_SIFT: CLOSED,
    FRICTION: DIAGRAM,
    REDUCED: DIAGRAM,
    SPRINGS: DIAGRAM,
    RODS: DIAGRAM,
}
ONCE = (  # however many stages read them
    "linkage/kinematics.py:solve_kinematics",
    "linkage/errors.py:estimate",
    "linkage/forces/solve.py:solve_forces",
    "machine/reduction/solve.py:solve_reduction",
    "linkage/forces/solve.py:_amplified",
    "machine/power.py:solve_power",
    "machine/motion.py:solve_motion",
)


def scene(name: str) -> tuple[str, ...]:
    """The file of a spec, and overrides."""
    return (str(CONFIGS / f"{name}.toml"), *SHORTER.get(name, ()))


def observed(name: str) -> dict[str, Any]:
    """Functions, modules and files of the run of a spec."""
    seen: dict[str, Any] = answer("observe", *scene(name))
    return seen


def faults(name: str, seen: Mapping[str, Any]) -> list[str]:
    """All that a scene did beyond its need, or that its plan tells wrongly."""
    file, *overrides = scene(name)
    spec = load_spec(file, overrides)
    running = plan(spec).running
    return [
        f"{name}: {what}"
        for what in (
            *imports(spec, running, seen),
            *sentences(spec, seen),
            *repeated(name, seen),
            *written(running, seen),
            *[f"{key} is imported" for key in heavy(spec, seen)],
        )
    ]


def imports(spec: Spec, running: tuple[str, ...], seen: Mapping[str, Any]) -> list[str]:
    """Modules of stages that do not run, of tables that the spec has not, and of what stands outside the rooms.

    A constraint on a fact reads the documents, where facts are told.
    """
    modules = {name.removeprefix("tmmcalc.") for name in seen["modules"]}
    if any(each.given is None and each.asked.fact for each in to_feasibility(spec).constraints):
        modules = {name for name in modules if placed(name)[0] != "report" and placed(name)[1] != "facts"}
    judged = "feasibility" in running  # designs are judged by the stages of their own specs
    stages = {stage.home.removeprefix("tmmcalc.") for name, stage in STAGES.items() if name not in running}
    return [
        *(() if judged else sorted(modules & stages)),
        *(() if judged else sorted(modules & tables(spec))),
        *(module for module in sorted(modules) if placed(module)[0] in OUTER or told(module)),
    ]


def placed(module: str) -> tuple[str, str]:
    """The package of a module, and the part of it."""
    package, _, rest = module.partition(".")
    return package, rest.partition(".")[0]


def told(module: str) -> bool:
    """Whether a module of a room only tells of results."""
    package, part = placed(module)
    return package in ROOMS and part in TOLD


def tables(spec: Spec) -> set[str]:
    """Modules of the tables, and of their checks, that this spec has no use for."""
    given = spec.model_fields_set
    models = {name: late(field.annotation, *field.metadata) for name, field in Spec.model_fields.items()}
    checks = {
        name: {f"{entry.home[8:]}.tables.checks.{each}" for each in entry.checks} for name, entry in TABLES.items()
    }
    of_loads = {f"linkage.tables.checks.{name}" for name in ("loads", "windows", "curves")}
    shared = of_loads if spec.cam or spec.torque or spec.motor else set()
    shared |= {"gears.tables.gearing"} if spec.open_pair else set()
    shared |= {"gears.tables.checks.train"} if spec.pair else set()
    needed = shared.union(*(each.get(name, set()) for each in (models, checks) for name in given))
    return set().union(*models.values(), *checks.values()) - needed


def late(*annotations: Any) -> set[str]:
    """Modules of the late tables within annotations."""
    own = {each.module.removeprefix("tmmcalc.") for each in annotations if isinstance(each, DeferredTable)}
    return own.union(*(late(*get_args(each)) for each in annotations if get_args(each)))


def sentences(spec: Spec, seen: Mapping[str, Any]) -> list[str]:
    """Sentences that are said though the functions were called, or not said though they were not."""
    found = []
    for why in explain(spec, plan(spec)):
        for (stage, sentence), functions in CALLED.items():
            if stage != why.step.stage or not why.step.runs or (stage == "synthesis" and not concerns(spec, sentence)):
                continue
            called, said = any(map(seen_in(seen), functions)), sentence in why.omits
            if said == called and WIDER.get(sentence) not in why.omits:
                found.append(f"{stage}: {'said' if said else 'not said'}: {sentence}")
    return found


def concerns(spec: Spec, sentence: str) -> bool:
    """Whether a sentence on a synthesis concerns its kind."""
    return sentence != NO_SEARCH or (spec.synthesis is not None and spec.synthesis.dwell is not None)


def seen_in(seen: Mapping[str, Any]) -> Any:
    """Whether a function, or any of a module or folder that ends so, was called; an import is no call."""
    calls = [name for name in seen["counts"] if not name.endswith(":<module>")]
    bodies = [name for name in calls if name.partition(":")[2][:1].islower() or name.partition(":")[2][:1] == "_"]
    return lambda function: (
        any(name.startswith(function) for name in bodies) if function[-1] in ":/" else function in bodies
    )


def repeated(name: str, seen: Mapping[str, Any]) -> list[str]:
    """Functions that a scene calls more than once; of a synthesis every solution is a scene of its own."""
    # these have several motions; a motor that is chosen is tried with the train of each
    further = name.startswith(("synth", "feasibility", "crane", "tipper", "geared-pump"))
    return [] if further else [f"{each}: {n} calls" for each in ONCE if (n := seen["counts"].get(each, 0)) > 1]


def written(running: tuple[str, ...], seen: Mapping[str, Any]) -> list[str]:
    """Files that are not those of the stages of the plan, or lacking."""
    expected = {"run.log", ".lock", *(f"{name}.toml" for name in running)}
    expected |= {f"{name}.npz" for name in running if seen["arrays"][name]}
    expected |= {f"{name}.csv" for name, rows in seen["rows"].items() if rows <= CSV_ROWS}
    return sorted(expected ^ set(seen["files"]))


def heavy(spec: Spec, seen: Mapping[str, Any]) -> set[str]:
    """Parts of heavy packages that were imported and do not come with those that the plan names, or the reverse."""
    named = packages(explain(spec, plan(spec)))
    return parts(set(seen["modules"])) ^ parts(come_with(named))


def parts(modules: set[str]) -> set[str]:
    """Public parts of packages that are not the program's own: scipy.linalg of scipy.linalg._basic."""
    names = {".".join(name.split(".")[:2]) for name in modules if not name.startswith("tmmcalc")}
    return {name for name in names if "._" not in name}


@cache
def come_with(named: tuple[str, ...]) -> set[str]:
    """Modules in memory after the packages are imported."""
    if not named:
        return set()
    code = f"import sys, {', '.join(named)}; print(*(name for name in sys.modules if name.startswith('scipy')))"
    return set(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split())


@sparing("name", KINDS, every=4)
def test_no_scene_does_what_it_does_not_need(name: str) -> None:
    found = observed(name)
    assert not faults(name, found)
    modules = {each.removeprefix("tmmcalc.") for each in found["modules"]}
    rooms = {room for room, part in map(placed, modules - ON_MODELS) if room in ROOMS and part not in ("", *READ)}
    assert rooms == set(KINDS[name])


def test_what_is_beyond_the_need_is_seen() -> None:
    seen = observed("scotch-yoke")
    assert not faults("scotch-yoke", seen)
    modules = (
        "tmmcalc.gears.stages.train",
        "tmmcalc.machine.tables.motor",
        "tmmcalc.linkage.facts.forces",
        "scipy.linalg",
    )
    calls = {"linkage/forces/friction.py:solve": 1, "linkage/errors.py:estimate": 2}
    beyond = [
        *({**seen, "modules": [*seen["modules"], name]} for name in modules),
        {**seen, "files": [*seen["files"], "train.toml"]},
        {**seen, "counts": {**seen["counts"], **calls}},
    ]
    said = [" ".join(faults("scotch-yoke", each)) for each in beyond]
    words = ("stages.train", "machine.tables.motor", "facts.forces", "scipy.linalg", "train.toml", "said: no friction")
    assert all(word in text for word, text in zip(words, said, strict=True))
    assert "2 calls" in said[-1]


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in templates.names() if "/" not in name and name not in KINDS])
def test_no_ready_spec_does_what_it_does_not_need(name: str) -> None:
    assert not faults(name, observed(name))


def test_every_sentence_is_held_against_what_happens() -> None:
    homes = [import_module(stage.home) for stage in STAGES.values()]
    homes += [import_module(f"tmmcalc.{room}.wanted") for room in ("linkage", "gears", "machine")]
    told = {
        value
        for home in homes
        for name, value in vars(home).items()
        if name.isupper() and isinstance(value, str) and ": " in value and value not in (SLIDES, POSITIONAL)
    }
    assert told - {sentence for _, sentence in CALLED} == {EXTRA, NO_CSV}  # see test_selection
