"""From [cam] to what is asked of a cam: every key, laws of one's own, what is found, defaults, the ready specs."""

from __future__ import annotations

import json
import math
import re
import tomllib
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from project.scenes import CONFIGS, TORQUE
from project.test_loader import loaded_by
from project.test_schema import accepts

from cams.tables.camscenes import DEGREE, FOLLOWER, LOADS, MOTION, ROCKING, cam, law_names, own
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.tables.cam import CamTable
from tmmcalc.cams.tables.cam_parts import (
    CamElasticTable,
    CamGuideTable,
    CamLimitsTable,
    CamLoadsTable,
    CamOptimumTable,
    CamRequirementsTable,
    CamSpringTable,
)
from tmmcalc.cams.tables.tasks.cam import to_cam
from tmmcalc.cams.task import (
    PRESSURE_ANGLES,
    AngleLimits,
    Asked,
    CamTask,
    Elastic,
    Force,
    Guide,
    Loads,
    Optimum,
    Requirements,
    Spring,
)
from tmmcalc.core.errors import UsageError
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project import load_spec, parse_spec, templates
from tmmcalc.project.files import named_files
from tmmcalc.spec.units import parse

DOCS = CONFIGS.parent / "docs" / "spec.md"
CASES = {case["id"]: case for case in json.loads((CONFIGS.parent / "tests" / "cases" / "cams.json").read_text())}
TURN = 2 * math.pi


SHAFT = '[cam.loads]\nmass = "0.2 kg"\n[torque]\nspeed = "60 rpm"\nformula = "1"\nperiod = "720 deg"\n'


def asked(key: str) -> Callable[[CamTask], Any]:
    return lambda task: getattr(task.asked, key)


def carried(key: str) -> Callable[[CamTask], Any]:
    return lambda task: getattr(task.loads, key)


def pressed(key: str) -> Callable[[CamTask], Any]:
    return lambda task: None if task.loads is None else getattr(task.loads.spring, key)


def phases(task: CamTask) -> list[tuple[str, float]]:
    return [(phase.kind, round(phase.angle / DEGREE, 9)) for phase in task.program.phases]


# key: lines with it, the follower, what is read from the task, and the value
KEYS: dict[str, tuple[str, str, Callable[[CamTask], Any], Any]] = {
    "follower": ("", "RK", asked("kind"), "oscillating"),
    "rotation": ('rotation = "counter-clockwise"', "RT", asked("sense"), -1),
    "closure": ('closure = "groove"', "RT", asked("closure"), "groove"),
    "stroke": ("", "RK", lambda task: task.program.stroke, 20 * DEGREE),
    "speed": ('speed = "60 rpm"', "RT", lambda task: task.loads, Loads(TURN, spring=Spring("none"))),
    "shaft": (f'shaft = "crank"\n{SHAFT}', "RT", lambda task: task.turns, 1),
    "ratio": (f'shaft = "crank"\nratio = "3/2"\n{SHAFT}', "RT", lambda task: (task.ratio, task.turns), (1.5, 2)),
    "crank_angle": ('crank_angle = "90 deg"', "RT", lambda task: task.begin, 90 * DEGREE),
    "start_distance": ('start_distance = "50 mm"', "RT", asked("start"), 0.05),
    "start_angle": ('start_angle = "35 deg"', "RK", asked("start"), 35 * DEGREE),
    "base_radius": ('base_radius = "60 mm"', "PT", asked("base"), 0.06),
    "offset": ('offset = "-7 mm"', "RT", asked("offset"), -0.007),
    "roller_radius": ("roller_radius = 0", "RT", asked("roller"), 0.0),
    "centre_distance": ('centre_distance = "120 mm"', "RK", asked("centres"), 0.12),
    "rocker_length": ("", "RK", asked("rocker"), 0.1),
    "rocker_turn": ('rocker_turn = "against"', "RK", asked("assembly"), -1),
    "steps": ("steps = 10", "RT", lambda task: task.steps, 10),
    "step": ('step = "0.5 deg"', "RT", lambda task: task.step, 0.5 * DEGREE),
    "tool_radius": ('tool_radius = "40 mm"', "RT", asked("tool"), 0.04),
    "tolerance": ('tolerance = "5 um"', "RT", asked("tolerance"), 5e-6),
    "face_margin": ('face_margin = "2 mm"', "PT", asked("margin"), 0.002),
    "refuse": ("refuse = false", "RT", asked("report_faults"), True),
    "rise": ("", "RT", phases, [("rise", 60), ("high dwell", 30), ("return", 90), ("low dwell", 180)]),
    "law": ("", "RT", law_names, ["sine", "sine"]),
    "rise_law": ('rise_law = "shun"', "RT", law_names, ["shun", "sine"]),
    "return_law": ('return_law = "const"', "RT", law_names, ["sine", "const"]),
    "limits.pressure_angle": (
        '[cam.limits]\npressure_angle = "25 deg"',
        "RT",
        lambda task: task.limits,
        AngleLimits(25 * DEGREE, None),
    ),
    "limits.pressure_angle_return": (
        '[cam.limits]\npressure_angle_return = "50 deg"',
        "RK",
        lambda task: task.limits,
        AngleLimits(45 * DEGREE, 50 * DEGREE),
    ),
    "limits.convex_radius": ('[cam.limits]\nconvex_radius = "3 mm"', "RT", lambda task: task.limits.convex, 0.003),
    "limits.concave_radius": ('[cam.limits]\nconcave_radius = "9 cm"', "RT", lambda task: task.limits.concave, 0.09),
    "limits.allow_concave": (
        "[cam.limits]\nallow_concave = false",
        "RT",
        lambda task: task.limits.allow_concave,
        False,
    ),
    "limits.shaft_radius": ('[cam.limits]\nshaft_radius = "12 mm"', "PT", lambda task: task.limits.shaft, 0.012),
    "loads.mass": (LOADS, "RT", carried("mass"), 0.2),
    "loads.inertia": (ROCKING, "RK", carried("mass"), 1e-4),
    "loads.force": (f'{LOADS}force = "-2 kN"', "RT", carried("force"), Force(-2000.0)),
    "loads.force_return": (f'{ROCKING}force_return = "3 N*m"', "RK", carried("force"), Force(0.0, 3.0)),
    "loads.gravity": (f"{LOADS}gravity = -9.81", "RT", carried("gravity"), -9.81),
    "loads.friction": (f"{LOADS}friction = 0.1\n[cam.guide]\ntop = 0.2", "PT", carried("friction"), 0.1),
    "loads.pivot_friction": (
        f'{ROCKING}pivot_friction = 0.08\npivot_radius = "6 mm"',
        "RK",
        carried("pivot_friction"),
        0.08,
    ),
    "loads.pivot_radius": (
        f'{ROCKING}pivot_friction = 0.08\npivot_radius = "6 mm"',
        "RK",
        carried("pivot_radius"),
        0.006,
    ),
    "spring.method": (f'{LOADS}[cam.spring]\nmethod = "none"', "RT", pressed("method"), "none"),
    "spring.safety": (f"{LOADS}[cam.spring]\nsafety = 1.6", "RT", pressed("safety"), 1.6),
    "spring.exact": (f"{LOADS}[cam.spring]\nexact = true", "RT", pressed("exact"), True),
    "spring.stiffness": (f'{LOADS}[cam.spring]\nstiffness = "8 N/mm"', "RT", pressed("stiffness"), 8000.0),
    "spring.preload": (f"{ROCKING}[cam.spring]\nstiffness = 6.3\npreload = 0.75", "RK", pressed("preload"), 0.75),
    "spring.deflection": (f'{LOADS}[cam.spring]\ndeflection = "16 mm"', "RT", pressed("deflection"), 0.016),
    "spring.least_contact": (f"{LOADS}[cam.spring]\nleast_contact = 7", "RT", pressed("least"), 7.0),
    "spring.wire": (f"{LOADS}[cam.spring]\nwire = 0.002\ncoil = 0.016", "RT", pressed("wire"), 0.002),
    "spring.shear_stress": (f'{LOADS}[cam.spring]\nshear_stress = "500 MPa"', "RT", pressed("allowed"), 5e8),
    "spring.dead_coils": (f"{LOADS}[cam.spring]\nshear_stress = 5e8\ndead_coils = 1.5", "PT", pressed("dead"), 1.5),
    "spring.coil": (f"{LOADS}[cam.spring]\nwire = 0.002\ncoil = 0.016", "PT", pressed("coil"), 0.016),
    "spring.shear_modulus": (
        f'{LOADS}[cam.spring]\nwire = 0.002\ncoil = 0.016\nshear_modulus = "75000 MPa"',
        "RT",
        pressed("shear"),
        7.5e10,
    ),
    "optimum.step": (
        f'{LOADS}[cam.optimum]\nstep = "0.5 mm"',
        "",
        lambda task: task.optimum,
        Optimum(step=5e-4),
    ),
    "optimum.height_step": (
        f'{LOADS}[cam.optimum]\nheight_step = "2 mm"',
        "",
        lambda task: task.optimum,
        Optimum(height_step=2e-3),
    ),
    "optimum.heights": (
        f'{LOADS}[cam.optimum]\nheights = ["90 mm", 0.12]',
        "",
        lambda task: task.optimum,
        Optimum(heights=(0.09, 0.12)),
    ),
    "optimum.centre_distances": (
        f'{ROCKING}[cam.requirements]\npin_pressure = 5e6\n[cam.optimum]\ncentre_distances = ["90 mm", 0.12]',
        "RK",
        lambda task: task.optimum,
        Optimum(centre_distances=(0.09, 0.12)),
    ),
    "optimum.rocker_lengths": (
        f'{ROCKING}[cam.requirements]\npin_pressure = 5e6\n[cam.optimum]\nrocker_lengths = ["90 mm", "90 mm"]',
        "RK",
        lambda task: task.optimum,
        Optimum(rocker_lengths=(0.09, 0.09)),
    ),
    "optimum.laws": (
        f'{LOADS}[cam.optimum]\nlaws = ["sine", "shun"]',
        "",
        lambda task: task.optimum,
        Optimum(laws=("sine", "shun")),
    ),
    "optimum.phases": (
        f'{LOADS}[cam.optimum]\nphases = "rise"',
        "",
        lambda task: task.optimum,
        Optimum(phases="rise"),
    ),
    "optimum.safeties": (
        f"{LOADS}[cam.optimum]\nsafeties = [1.2, 1.5]",
        "",
        lambda task: task.optimum,
        Optimum(safeties=(1.2, 1.5)),
    ),
    "optimum.contacts": (
        f'{LOADS}[cam.optimum]\ncontacts = {{ "steel 45" = "600 MPa", bronze = 2e8 }}',
        "",
        lambda task: task.optimum,
        Optimum(contacts=(("steel 45", 6e8), ("bronze", 2e8))),
    ),
    "optimum.roller_ratios": (
        f'{LOADS}[cam.optimum]\nroller_ratios = ["needle", 2.5]',
        "",
        lambda task: task.optimum,
        Optimum(roller_ratios=(("needle", 1.15), ("", 2.5))),
    ),
    "optimum.combine": (
        f"{LOADS}[cam.optimum]\ncombine = true",
        "",
        lambda task: task.optimum,
        Optimum(combine=True),
    ),
    "elastic.stiffness": (
        f'{LOADS}[cam.elastic]\nstiffness = "2000 N/mm"',
        "RT",
        lambda task: task.elastic,
        Elastic(2e6),
    ),
    "elastic.damping": (
        f"{LOADS}[cam.elastic]\nstiffness = 2e6\ndamping = 0.05",
        "RT",
        lambda task: task.elastic,
        Elastic(2e6, 0.05),
    ),
    "elastic.mass": (
        f"{ROCKING}[cam.elastic]\nstiffness = 2e3\nmass = 3e-4",
        "RK",
        lambda task: task.elastic,
        Elastic(2e3, mass=3e-4),
    ),
}
KEYS["high_dwell"] = KEYS["return_angle"] = KEYS["rise"]
_GUIDES = {"top": 0.12, "length": 0.05, "gap": 0.002, "stem_radius": 0.0035, "land": 0.004}
for _key, _value in _GUIDES.items():
    _name = {"stem_radius": "stem"}.get(_key, _key)
    _reads = (f"[cam.guide]\n{_key} = {_value}", "RT", lambda task: task.guide, Guide(**{_name: _value}))
    KEYS[f"guide.{_key}"] = _reads
_REQUIREMENTS = {field.name: 0.013 * (place + 1) for place, field in enumerate(fields(Requirements))}
del _REQUIREMENTS["contact_source"]  # of the material
for _key, _value in _REQUIREMENTS.items():
    _kept = Requirements(**{_key: _value})
    _reads = (f"{LOADS}[cam.requirements]\n{_key} = {_value!r}", "RT", lambda task: task.requirements, _kept)
    KEYS[f"requirements.{_key}"] = _reads
_STEEL = 'material = { treatment = "improved", hardness = "HB 300", failure = "severe" }'
KEYS["requirements.material"] = (
    f"{LOADS}[cam.requirements]\n{_STEEL}", "RT", lambda task: task.requirements.contact, 670e6 / 1.25,
)  # fmt: skip
# what the search needs beside its own keys
SEARCHED = (
    '[cam.guide]\nstem_radius = "4 mm"\nland = "4 mm"\n[cam.requirements]\nwidth = "7 mm"\n'
    'contact = "400 MPa"\npin_pressure = "5 MPa"\nguide_pressure = "5 MPa"\n'
)
TABLES = {
    "limits": CamLimitsTable,
    "loads": CamLoadsTable,
    "spring": CamSpringTable,
    "guide": CamGuideTable,
    "requirements": CamRequirementsTable,
    "optimum": CamOptimumTable,
    "elastic": CamElasticTable,
}


def test_all_keys_are_tried() -> None:
    known = {key for key in CamTable.model_fields if key not in TABLES}
    known |= {f"{name}.{key}" for name, table in TABLES.items() for key in table.model_fields}
    assert KEYS.keys() == known - {"loads.force_table"}  # that one has tests of its own


@pytest.mark.parametrize("key", KEYS)
def test_a_key_reaches_the_task(key: str) -> None:
    lines, kind, read, value = KEYS[key]
    task = cam(lines, kind) if kind else cam(lines + "\n" + SEARCHED)
    assert read(task) == value
    if lines and key != "loads.mass":
        plain = cam(LOADS if "[cam.loads]" in lines and kind != "RK" else "", kind or "RT")
        assert plain.loads is None or read(plain) != value


def test_nothing_but_the_motion() -> None:
    task = cam()
    assert task.asked == Asked("translating", offset=None)
    assert task.limits == AngleLimits(30 * DEGREE, None)
    assert (task.steps, task.step, task.loads) == (None, DEGREE, None)
    assert (task.guide, task.requirements, task.optimum, task.elastic) == (Guide(), Requirements(), None, None)
    assert task.remarks == ()


def test_the_program_is_a_whole_turn() -> None:
    task = cam()
    assert task.program.starts[-1] == pytest.approx(TURN, abs=1e-15)
    rise, high, back, low = task.program.phases
    assert [(phase.start, phase.end) for phase in (rise, high, back, low)] == [
        (0, 0.03),
        (0.03,) * 2,
        (0.03, 0),
        (0,) * 2,
    ]
    assert task.program.at(np.array([0.0, 30, 60, 80, 135, 180, 300]) * DEGREE)[0] == pytest.approx(
        [0, 0.015, 0.03, 0.03, 0.015, 0, 0], abs=1e-15
    )


@pytest.mark.parametrize(
    ("angles", "kinds"),
    [
        ((120, 120, 120), ["rise", "high dwell", "return"]),
        ((180, 0, 180), ["rise", "return"]),
        ((100, 0, 100), ["rise", "return", "low dwell"]),
        ((33.3, 293.4, 33.3), ["rise", "high dwell", "return"]),
        ((5, 10, 5), ["rise", "high dwell", "return", "low dwell"]),
    ],
)
def test_dwells_of_no_angle_are_left_out(angles: tuple[float, ...], kinds: list[str]) -> None:
    rise, high, back = angles
    motion = f'rise = "{rise} deg"\nhigh_dwell = "{high} deg"\nreturn_angle = "{back} deg"\nlaw = "shun"\n'
    task = cam(motion=motion)
    assert [phase.kind for phase in task.program.phases] == kinds
    assert task.program.starts[-1] == pytest.approx(TURN, abs=1e-12)


@pytest.mark.parametrize(
    ("kind", "lines", "offset"),
    [
        ("RT", "", None),
        ("RT", "offset = 0", 0.0),
        ("RT", 'start_distance = "50 mm"', 0.0),
        ("RT", 'base_radius = "50 mm"', 0.0),
        ("RT", 'base_radius = "50 mm"\nstart_distance = "40 mm"', None),
        ("RT", 'base_radius = "50 mm"\noffset = "3 mm"', 0.003),
        ("RT", 'rotation = "counter-clockwise"\noffset = "3 mm"', 0.003),  # in the user's sense
        ("RK", "", 0.0),
        ("PT", "", 0.0),
    ],
)
def test_the_offset_is_found_with_the_start_distance(kind: str, lines: str, offset: float | None) -> None:
    assert cam(lines, kind).asked.offset == offset


@pytest.mark.parametrize(
    ("kind", "lines", "rise", "back"),
    [
        ("RT", "", 30, None),
        ("RK", "", 45, None),
        ("PT", "", 90, None),
        ("RT", 'closure = "groove"', 30, 30),
        ("RK", 'closure = "groove"\n[cam.limits]\npressure_angle = "40 deg"', 40, 40),
        ("RT", 'closure = "groove"\n[cam.limits]\npressure_angle_return = false', 30, None),
        ("RT", '[cam.limits]\npressure_angle = "20 deg"', 20, None),
        ("RT", '[cam.limits]\npressure_angle_return = "45 deg"', 30, 45),
    ],
)
def test_limits_of_the_pressure_angle(kind: str, lines: str, rise: float, back: float | None) -> None:
    limits = cam(lines, kind).limits
    assert limits.rise == pytest.approx(rise * DEGREE, abs=1e-15)
    assert limits.back == (None if back is None else pytest.approx(back * DEGREE, abs=1e-15))
    assert PRESSURE_ANGLES["flat"] == pytest.approx(90 * DEGREE)


@pytest.mark.parametrize(
    ("kind", "lines", "method"),
    [
        ("RT", LOADS, "safety"),
        ("RT", f'closure = "groove"\n{LOADS}', "none"),
        ("RT", 'speed = "30 rad/s"\n[cam.loads]\nforce = -100', "none"),
        ("RT", f"{LOADS}[cam.spring]\n", "safety"),
        ("RT", f"{LOADS}[cam.spring]\nstiffness = 5000\n", "given"),
        ("RT", f"{LOADS}[cam.spring]\nleast_contact = 5\n", "preload"),
        ("RK", f"{ROCKING}[cam.spring]\ndeflection = '8 deg'\n", "preload"),
        ("RT", f"{LOADS}[cam.spring]\nwire = 0.001\ncoil = 0.01\n", "safety"),
        ("RT", f"{LOADS}[cam.spring]\nmethod = 'preload'\n", "preload"),
    ],
)
def test_the_way_to_find_the_spring(kind: str, lines: str, method: str) -> None:
    loads = cam(lines, kind).loads
    assert loads is not None
    assert loads.spring.method == method


def test_the_speed_of_the_crank(shaper: str) -> None:
    text = f"[cam]\n{FOLLOWER['RT']}{MOTION}"
    task = to_cam(parse_spec(f"{shaper}\n{text}[cam.loads]\nmass = 1\n"))
    assert task.loads is not None
    assert task.loads.speed == pytest.approx(55 * math.pi / 30, rel=1e-15)
    assert task.remarks == ("[cam] has no speed: the cam turns as the crank does, at 55 rpm",)
    own = to_cam(parse_spec(f'{shaper}\n{text}speed = "10 rad/s"\n'))
    assert own.loads is not None
    assert (own.loads.speed, own.remarks) == (10.0, ())
    (remark,) = to_cam(parse_spec(f"{TORQUE}\n{text}")).remarks
    assert "as the shaft does, at 180 rpm" in remark


def test_a_cam_turns_with_its_crank(shaper: str) -> None:
    """The crank of the shaper turns counter-clockwise; a cam with a speed of its own, or none of a crank, does not."""
    text = f"[cam]\n{FOLLOWER['RT']}{MOTION}"
    backwards = shaper.replace('speed = "55 rpm"', 'speed = "-55 rpm"')
    for spec, more, sense in (
        (shaper, "", -1),
        (backwards, "", 1),
        (shaper, 'rotation = "clockwise"\n', 1),
        (shaper, 'speed = "10 rad/s"\n', 1),
        (TORQUE, "", 1),
        ("", "", 1),
    ):
        assert to_cam(parse_spec(f"{spec}\n{text}{more}")).asked.sense == sense


def test_the_crank_turns_either_way(shaper: str) -> None:
    backwards = shaper.replace('speed = "55 rpm"', 'speed = "-55 rpm"')
    assert backwards != shaper
    loads = to_cam(parse_spec(f"{backwards}\n[cam]\n{FOLLOWER['RT']}{MOTION}")).loads
    assert loads is not None
    assert loads.speed == pytest.approx(55 * math.pi / 30, rel=1e-15)


# forces by the angle

TABLED = [
    ('{ phi = ["0 deg", "90 deg", "270 deg"], force = [1, "-2 kN", 3] }', [0, 90, 270], [1, -2000, 3]),
    ("{ force = [1, 2, 3, 4] }", [0, 90, 180, 270], [1, 2, 3, 4]),
    ('{ phi = [0, "180 deg", "360 deg"], force = [1, 2, 1] }', [0, 180], [1, 2]),  # the end is the begin
    ('{ phi = ["10 deg", "190 deg"], force = [1, 2] }', [10, 190], [1, 2]),
]


@pytest.mark.parametrize(("table", "phi", "values"), TABLED)
def test_forces_by_the_angle(table: str, phi: list[float], values: list[float]) -> None:
    loads = cam(f"{LOADS}force_table = {table}").loads
    assert loads is not None
    assert (loads.force.rise, loads.force.back) == (0.0, 0.0)
    assert loads.force.phi == pytest.approx(np.array(phi) * DEGREE, abs=1e-15)
    assert loads.force.values == pytest.approx(values)


def test_moments_by_the_angle() -> None:
    loads = cam(f'{ROCKING}force_table = {{ phi = [0, 1], moment = ["-4 N*m", 0] }}', "RK").loads
    assert loads is not None
    assert loads.force.values == pytest.approx([-4, 0])


def test_forces_in_a_file(tmp_path: Path) -> None:
    text = f'[cam]\n{FOLLOWER["RT"]}{MOTION}{LOADS}force_table = {{ file = "q.csv" }}\n'
    (tmp_path / "spec.toml").write_text(text)
    (tmp_path / "q.csv").write_text("phi[deg];Q[kN]\n0;-0.1\n90;-0.2\n360;-0.1\n")
    spec = load_spec(tmp_path / "spec.toml")
    loads = to_cam(spec).loads
    assert loads is not None
    assert loads.force.phi == pytest.approx([0, math.pi / 2])
    assert loads.force.values == pytest.approx([-100, -200])
    assert named_files(spec, tmp_path) == [tmp_path / "q.csv"]


# the whole


def test_without_a_cam(shaper: str) -> None:
    with pytest.raises(UsageError, match=r"no \[cam\]"):
        to_cam(parse_spec(shaper))


def test_the_task_has_a_hash_that_knows_its_values() -> None:
    base = [cam(), cam(LOADS), cam(f"{LOADS}force = -1"), cam('offset = "1 mm"'), cam("steps = 9"), cam(kind="RK")]
    own_laws = [own("polynomial = [0, 0, 3, -2]"), own("points = [[0, 0], [0.5, 0.4], [1, 1]]")]
    tables = [cam(f"{LOADS}force_table = {table}") for table, *_ in TABLED]
    every = [*base, *own_laws, *tables]
    assert len({content_hash(task) for task in every}) == len(every)
    assert content_hash(cam()) == content_hash(cam())


def test_values_from_the_command_line() -> None:
    text = f"[cam]\n{FOLLOWER['RT']}{MOTION}"
    task = to_cam(
        parse_spec(text, overrides=["cam.law='shun'", "cam.start_distance='48 mm'", "cam.limits.shaft_radius=0.01"])
    )
    assert (law_names(task), task.asked.start, task.limits.shaft) == (["shun", "shun"], 0.048, 0.01)


@pytest.mark.slow
def test_a_cam_loads_what_it_needs(shaper: str) -> None:
    text = f"[cam]\n{FOLLOWER['RT']}{MOTION}"
    tables = {f"tmmcalc.project.{name}" for name in ("cam", "camparts", "camlaw", "cams", "ownlaw")}
    assert not (tables | {"numpy"}) & loaded_by(shaper)
    assert not any(name.startswith("tmmcalc.cams.tables.checks.cam") for name in loaded_by(shaper))
    plain = loaded_by(text + LOADS)
    assert not {"numpy", "scipy", "tmmcalc.project.files", "tmmcalc.project.words"} & plain
    assert {"tmmcalc.cams.tables.cam", "tmmcalc.cams.tables.checks.cam_sizes"} <= plain
    assert "scipy" not in loaded_by(text.replace('"sine"', "{ polynomial = [0, 0, 3, -2] }"))


def test_examples_of_the_reference() -> None:
    section = DOCS.read_text(encoding="utf-8").split("## `[cam]`")[1].split("\n## ")[0]
    (example,) = re.findall(r"```toml\n(.*?)```", section, re.DOTALL)
    assert to_cam(parse_spec(example)).limits == AngleLimits(parse("30 deg", "angle"), None)
    laws = re.findall(r"^\| `(\{ (?:points|acceleration|polynomial) .*? \})` \|", section, re.MULTILINE)
    assert len(laws) == 3
    for law in laws:
        assert law_names(cam(motion=MOTION.replace('"sine"', law))) == [law.split()[1]] * 2
    named = {
        name
        for line in re.findall(r"^\| (`\"[^|]*) \|", section, re.MULTILINE)
        for name in re.findall(r'"(\w+)"', line)
    }
    assert LAWS.keys() <= named


READY = {
    "cam": ("translating", ["sine", "sine"]),
    "cam-translating": ("translating", ["cosine", "shun"]),
    "cam-groove": ("translating", ["sine", "sine"]),
    "cam-oscillating": ("oscillating", ["sine", "sine"]),
    "cam-oscillating-against": ("oscillating", ["cosine", "cosine"]),
    "cam-flat": ("flat", ["sine", "sine"]),
    "cam-synthesis": ("translating", ["cosine", "cosine"]),
    "cam-rocker-synthesis": ("oscillating", ["linear", "linear"]),
    "cam-rocker-optimum": ("oscillating", ["sine", "sine"]),
    "cam-own-law": ("translating", ["cam-law.csv", "points"]),
}


def ready(name: str) -> CamTask:
    return to_cam(load_spec(CONFIGS / f"{name}.toml"))


def test_ready_specs() -> None:
    assert {file.stem for file in Path(CONFIGS).glob("cam*.toml") if "\n[cam]" in file.read_text()} == READY.keys()
    for name, (kind, laws) in READY.items():
        assert (ready(name).asked.kind, law_names(ready(name))) == (kind, laws)


def test_ready_specs_are_accepted_by_the_schema(schema: dict[str, Any]) -> None:
    texts = {name: (CONFIGS / f"{name}.toml").read_text(encoding="utf-8") for name in READY}
    assert all(accepts(schema, tomllib.loads(text), schema) for text in texts.values())
    for name, old, new in [
        ("cam", 'law = "sine"', 'law = "sinus"'),
        ("cam", '"translating"', '"sliding"'),
        ("cam", 'mass = "0.4 kg"', 'mass = "0.4 N"'),
        ("cam", "safety = 1.4", "safety = 0.4"),
        ("cam-own-law", '{ file = "cam-law.csv" }', "{ file = 3 }"),
        ("cam-own-law", "[0.25, 0.1]", "[0.25]"),
        ("cam-own-law", "points", "pints"),
        ("cam-translating", "bending", "bendig"),
        ("cam-translating", "steps = 12", "steps = 12.5"),
        ("cam-synthesis", 'pressure_angle_return = "30 deg"', "pressure_angle_return = true"),
    ]:
        assert texts[name].count(old) >= 1, old
        assert not accepts(schema, tomllib.loads(texts[name].replace(old, new)), schema), new


@pytest.mark.parametrize(("name", "case"), [("cam-oscillating", "cams-s08"), ("cam-oscillating-against", "cams-s09")])
def test_the_rockers_are_those_of_the_textbook(name: str, case: str) -> None:
    """Inputs and first stage of program 2.7: swing angles and the moment of inertia force."""
    given, expected, task = CASES[case]["inputs"], CASES[case]["expected"], ready(name)
    assert task.loads is not None
    assert task.asked == Asked(
        "oscillating",
        start=parse(f"{given['psi0_deg']} deg", "angle"),
        roller=given["r2_mm"] / 1e3,
        centres=given["l0_mm"] / 1e3,
        rocker=given["l2_mm"] / 1e3,
        assembly=given["assembly"],
    )
    assert (task.loads.speed, task.loads.mass, task.steps) == (given["omega"], given["J_kgm2"], given["n"])
    assert (task.requirements.width, task.requirements.modulus) == (given["b_mm"] / 1e3, given["E_MPa"] * 1e6)
    assert (task.loads.spring.method, task.loads.spring.safety) == ("safety", given["K1"])
    table = expected["table"]
    motion = task.program.at(np.array(table["phi_rad"][1:-1]))
    assert motion[0] == pytest.approx(table["dpsi_rad"][1:-1], abs=1e-6)
    inertia = -task.loads.mass * task.loads.speed**2 * motion[2]
    assert inertia == pytest.approx(table["M_in_Nm"][1:-1], abs=1e-5)


def test_the_translating_follower_is_that_of_the_case() -> None:
    given, expected, task = CASES["cams-s20"]["inputs"], CASES["cams-s20"]["expected"], ready("cam-translating")
    assert task.loads is not None
    assert (task.asked.start, task.asked.offset, task.asked.sense) == (0.05, given["e_canonical_mm"] / 1e3, 1)
    motion = task.program.at(np.array(expected["phi_deg"]) * DEGREE) * 1e3
    assert motion[0] + 50 == pytest.approx(expected["S_mm"], abs=1e-5)
    assert motion[1] == pytest.approx(expected["S1_mm"], abs=1e-5)
    assert task.optimum == Optimum()


def test_the_table_beside_a_ready_spec_is_written_too() -> None:
    assert [file.name for file in templates.beside("cam-own-law")] == ["cam-law.csv"]
    assert templates.beside("cam") == []
    law = ready("cam-own-law").program.phases[0].law
    assert law is not None
    assert law.at(np.linspace(0, 1, 41))[:2] == pytest.approx(LAWS["shun"].at(np.linspace(0, 1, 41))[:2], abs=2e-4)


def test_the_template_is_right_with_its_comments_taken_away() -> None:
    text = (CONFIGS / "cam.toml").read_text(encoding="utf-8")
    lines = [line.removeprefix("# ") if re.match("# [a-z_0-9]+ = ", line) else line for line in text.splitlines()]
    task = to_cam(parse_spec("\n".join(line for line in lines if not re.match("closure|law|friction", line))))
    assert (law_names(task), task.asked.start, task.asked.offset) == (["shun", "points"], 0.06, -0.008)
    assert task.loads is not None
    assert (task.loads.spring.safety, task.loads.spring.wire, task.loads.gravity) == (1.4, 0.002, -9.81)
