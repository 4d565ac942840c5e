"""From the tables of the small calculators to their tasks: every key, faults with their lines, the ready specs."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable
from typing import Any

import pytest
from project.scenes import CONFIGS
from project.test_schema import accepts

from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.extras.tables.bearing import BearingTable
from tmmcalc.extras.tables.contact import ContactTable, GapTableTable
from tmmcalc.extras.tables.falling_ball import FallingBallTable
from tmmcalc.extras.tables.liner import ClampTable, LinerTable
from tmmcalc.extras.tables.reliability import ReliabilityTable
from tmmcalc.extras.tables.tasks.bearing import to_bearing
from tmmcalc.extras.tables.tasks.contact import to_contact
from tmmcalc.extras.tables.tasks.falling_ball import to_ball
from tmmcalc.extras.tables.tasks.liner import to_liner
from tmmcalc.extras.tables.tasks.reliability import to_reliability
from tmmcalc.extras.tables.tasks.tie_down import to_tie_down
from tmmcalc.extras.tables.tasks.transloader import to_transloader
from tmmcalc.extras.tables.tie_down import SupportTable, ThreadTable, TieDownTable
from tmmcalc.extras.tables.transloader import (
    HoistTable,
    InfluenceTable,
    StartTable,
    TransloaderLoadsTable,
    TransloaderPartTable,
    TransloaderTable,
    TransloaderWindTable,
    TrolleyTable,
)
from tmmcalc.project import load_spec, parse_spec

NEEDED = {
    "contact": 'load = "1 kN"\nradii = "20 mm"',
    "reliability": "load = [2, 2.5]\nrate = 0.36\nstrength = 2.6\ndecay = 2e-4",
    "tie_down": 'weight = "5 kN"\nfactor = 0.8\nelevation = "30 deg"\nfriction = 0.4',
    "falling_ball": 'radius = "1 mm"\ndrag = 1e-4\ndecay = 0.5',
    "bearing": 'speed = "46 rpm"\ninner = "150 mm"\nouter = "340 mm"\nroller = "39 mm"\ncount = 14',
    "liner": 'radius = "69 mm"\nthickness = "6 mm"\nring_outer = "80 mm"\nring_width = "10 mm"\nmoment = "1 kN"',
    "transloader": 'capacity = "16 t"',
}
READ = {
    "contact": to_contact,
    "reliability": to_reliability,
    "tie_down": to_tie_down,
    "falling_ball": to_ball,
    "bearing": to_bearing,
    "liner": to_liner,
    "transloader": to_transloader,
}
TABLES = {
    "contact": ContactTable,
    "reliability": ReliabilityTable,
    "tie_down": TieDownTable,
    "falling_ball": FallingBallTable,
    "bearing": BearingTable,
    "liner": LinerTable,
    "transloader": TransloaderTable,
}
TEST = "items = 30\nleast_life = 100\nmean_life = 150"
THREAD = 'thread = { moment = "30 N*m", diameter = "14 mm", lead_angle = "3 deg", friction_angle = "9 deg" }'
SUPPORT = (
    'support = { weight = "1 kN", friction = 0.2, base = "4 m", cradle_arm = "3 m", arm = "1 m", diameter = "2 m" }'
)
CLAMP = 'clamp = { gas_pressure = "8 MPa", bore = "130 mm", arm = "4 mm", factor = 2 }'
TROLLEY = 'trolley = { path = "60 m", acceleration = 0.6 }'
PART = (
    '[[transloader.parts]]\nname = "beam"\narea = 0.02\nstrength = "240 MPa"\nmechanism = "luffing"\nduty = "light"\n'
    'making = "cast"\nendurance = "180 MPa"\nimportance = [1, 2, 3]\ninfluence = { rated_load = 2 }'
)
BARE = '[[transloader.parts]]\nname = "beam"\narea = 0.02\nstrength = 1\n'
WIND = "{ pressure = 150, area = 20, height = 1.3, shape = 1.4, overload = 1.1, dynamic = 1.2 }"
TABLE = 'table = { x = [0, "1 mm"], y = [0, "2 mm"], h = [[0, 0.001], [0.002, 0.003]] }'

# key: the lines with it, the lines that they replace, what is read, the value
KEYS: dict[str, dict[str, tuple[str, str, Callable[[Any], Any], Any]]] = {
    "contact": {
        "load": ("", "", lambda task: task.load, 1000.0),
        "modulus": ('modulus = "100 MPa"', "", lambda task: task.modulus, 1e8),
        "young": ('young = ["200 MPa", "200 MPa"]', "", lambda task: task.modulus, 1e8 / 0.91),
        "poisson": ("poisson = [0, 0.5]", "", lambda task: task.modulus, 206e9 / 1.75),
        "radii": ('radii = ["20 mm", "30 mm"]', 'radii = "20 mm"', lambda task: task.radii, (0.02, 0.03)),
        "gap": ('gap = "x**2"\nsize = "1 mm"', 'radii = "20 mm"', lambda task: task.formula, "x**2"),
        "table": (TABLE, 'radii = "20 mm"', lambda task: task.table.h, ((0, 0.001), (0.002, 0.003))),
        "cells": ("cells = 8", "", lambda task: task.cells, 8),
        "size": ('size = "3 mm"', "", lambda task: task.size, 0.003),
    },
    "reliability": {
        "load": ("", "", lambda task: (task.low, task.high), (2, 2.5)),
        "readings": ("readings = [2, 3]", "load = [2, 2.5]", lambda task: (task.low, task.high), (1, 4)),
        "rate": ("", "", lambda task: task.rate, 0.36),
        "strength": ("", "", lambda task: task.strength, 2.6),
        "decay": ("", "", lambda task: task.decay, 2e-4),
        "items": (TEST, "strength = 2.6\ndecay = 2e-4", lambda task: task.test.items, 30),
        "least_life": (TEST, "strength = 2.6\ndecay = 2e-4", lambda task: task.test.least, 100),
        "mean_life": (TEST, "strength = 2.6\ndecay = 2e-4", lambda task: task.test.mean, 150),
        "times": ("times = [1, 2]", "", lambda task: task.times, (1, 2)),
        "until": ("until = 300", "", lambda task: task.until, 300),
        "rows": ("rows = 7", "", lambda task: task.rows, 7),
    },
    "tie_down": {
        "weight": ("", "", lambda task: task.weight, 5000),
        "factor": ("", "", lambda task: task.factor, 0.8),
        "elevation": ("", "", lambda task: task.elevation, math.pi / 6),
        "plan_angle": ('plan_angle = "15 deg"', "", lambda task: task.plan, math.pi / 12),
        "friction": ("", "", lambda task: task.friction, 0.4),
        "preload": ('preload = "1 kN"', "", lambda task: task.preload, 1000),
        "section": ('section = "2 cm^2"', "", lambda task: task.section, 2e-4),
        "strength": ('section = 1\nstrength = "240 MPa"', "", lambda task: task.strength, 2.4e8),
        "thread": (THREAD, "", lambda task: task.thread.diameter, 0.014),
        "support": (SUPPORT, "", lambda task: (task.support.arm, task.support.cradle_arm), (1, 3)),
    },
    "falling_ball": {
        "radius": ("", "", lambda task: task.radius, 1e-3),
        "drag": ("", "", lambda task: task.drag, 1e-4),
        "decay": ("", "", lambda task: task.decay, 0.5),
        "gravity": ("gravity = 1.6", "", lambda task: task.gravity, 1.6),
        "reaction": ('reaction = "accelerating"', "", lambda task: task.sign, 1),
        "relative_speed": ('relative_speed = "36 km/h"', "", lambda task: task.relative, 10),
        "initial_speed": ("initial_speed = 2", "", lambda task: task.initial, 2),
        "times": ('times = ["500 ms"]', "", lambda task: task.times, (0.5,)),
        "duration": ("duration = 3", "", lambda task: task.duration, 3),
        "rows": ("rows = 7", "", lambda task: task.rows, 7),
    },
    "bearing": {
        "speed": ("", "", lambda task: task.omega, 46 * math.pi / 30),
        "wheel_speed": (
            'wheel_speed = 1.2\nwheel_diameter = "600 mm"',
            'speed = "46 rpm"',
            lambda task: task.omega,
            4.0,
        ),
        "wheel_diameter": ("wheel_speed = 1\nwheel_diameter = 0.5", 'speed = "46 rpm"', lambda task: task.omega, 4.0),
        "inner": ("", "", lambda task: task.inner, 0.15),
        "outer": ("", "", lambda task: task.outer, 0.34),
        "roller": ("", "", lambda task: task.roller, 0.039),
        "count": ("", "", lambda task: task.count, 14),
        "contact_angle": ('contact_angle = "30 deg"', "", lambda task: task.angle, math.pi / 6),
        "peak": ("peak = [4]\nrms = [2]", "", lambda task: task.peak, (4,)),
        "rms": ("peak = [4]\nrms = [2]", "", lambda task: task.rms, (2,)),
    },
    "liner": {
        "radius": ("", "", lambda task: task.radius, 0.069),
        "thickness": ("", "", lambda task: task.thickness, 0.006),
        "ring_outer": ("", "", lambda task: task.outer, 0.08),
        "ring_width": ("", "", lambda task: task.width, 0.01),
        "length": ('length = "200 mm"', "", lambda task: task.length, 0.2),
        "young": ('young = "110000 MPa"', "", lambda task: task.young, 1.1e11),
        "poisson": ("poisson = 0.3", "", lambda task: task.poisson, 0.3),
        "load": ('load = "20 N/mm"', "", lambda task: task.load, 2e4),
        "moment": ("", "", lambda task: task.moment, 1000.0),
        "clamp": (CLAMP, 'moment = "1 kN"', lambda task: (task.clamp.arm, task.clamp.factor), (0.004, 2.0)),
        "pressure": ('pressure = "2 MPa"', "", lambda task: task.pressure, 2e6),
        "continuity": ('continuity = "centre"', "", lambda task: task.continuity, "centre"),
        "allowed": ('allowed = "90 MPa"', "", lambda task: task.allowed, 9e7),
        "rows": ("rows = 7", "", lambda task: task.rows, 7),
    },
    "transloader": {
        "capacity": ("", "", lambda task: task.capacity, 16_000.0),
        "mass": ('mass = "500 t"', "", lambda task: task.mass, 5e5),
        "gravity": ("gravity = 9.8", "", lambda task: task.gravity, 9.8),
        "span": ("span = 60", "", lambda task: task.span, 60.0),
        "deflection": ('span = 60\ndeflection = "80 mm"', "", lambda task: task.deflection, 0.08),
        "bridge_speed": ('bridge_speed = "30 m/min"', "", lambda task: task.bridge_speed, 0.5),
        "trolley": (TROLLEY, "", lambda task: (task.trolley.length, task.trolley.acceleration), (60.0, 0.6)),
        "hoist": (
            "hoist = { height = 25, acceleration = 1, speed = 1.5, lowering = 2 }",
            "",
            lambda task: (task.hoist.length, task.hoist.speed, task.lowering),
            (25.0, 1.5, 2.0),
        ),
        "inertia": (
            "inertia = { weights = [1, 2], speed = 3, time = 4 }",
            "",
            lambda task: (task.inertia.weights, task.inertia.speed, task.inertia.time),
            ((1.0, 2.0), 3.0, 4.0),
        ),
        "wind": (f"wind = {WIND}", "", lambda task: (task.winds[0][0], task.winds[0][1].dynamic), ("wind", 1.2)),
        "equivalent_wind": (f"equivalent_wind = {WIND}", "", lambda task: task.winds[0][0], "equivalent_wind"),
        "hurricane": (f"hurricane = {WIND}", "", lambda task: task.winds[0][0], "hurricane"),
        "loads": ('loads = { shock = "2 kN" }', "", lambda task: task.loads[0], ("shock", 2000.0)),
        "factors": ('factors = "product"', "", lambda task: task.factors, "product"),
        "blanks": ('blanks = "with"', "", lambda task: task.blanks, "with"),
        "parts": (
            PART,
            "",
            lambda task: (task.parts[0].mechanism, task.parts[0].making, task.parts[0].importance, task.parts[0].duty),
            ("luffing", "cast", (1.0, 2.0, 3.0), "light"),
        ),
    },
}


PARTS = (
    *(HoistTable, InfluenceTable, StartTable, TransloaderLoadsTable, TransloaderPartTable, TransloaderWindTable),
    TrolleyTable,
)


def spec_text(table: str, lines: str = "", instead: str = "") -> str:
    needed = NEEDED[table]
    assert instead in needed
    kept = needed.replace(instead, "") if instead else needed
    return f"[{table}]\n{kept}\n{lines}\n"


@pytest.mark.parametrize(("table", "key"), [(table, key) for table, keys in KEYS.items() for key in keys])
def test_every_key_reaches_the_task(table: str, key: str) -> None:
    lines, instead, read, value = KEYS[table][key]
    found = read(READ[table](parse_spec(spec_text(table, lines, instead))))
    assert found == value if isinstance(value, str | tuple) else found == pytest.approx(value)


def test_every_key_has_its_test_and_its_line_in_the_docs() -> None:
    text = (CONFIGS.parent / "docs" / "spec.md").read_text()
    for table, model in TABLES.items():
        assert KEYS[table].keys() == model.model_fields.keys()
        section = text.split(f"## `[{table}]`")[1].split("\n## ")[0]
        further = {
            "contact": (GapTableTable,),
            "tie_down": (ThreadTable, SupportTable),
            "liner": (ClampTable,),
            "transloader": PARTS,
        }.get(table, ())
        wanted = {key for each in (model, *further) for key in each.model_fields}
        assert {*re.findall(r"`(\w+)`", section)} | {*re.findall(r"\[tie_down\.(\w+)|\[contact\.(\w+)", section)} >= {
            key for key in wanted if key not in ("table", "thread", "support", "clamp", "loads", "parts")
        }


# what is written: its table, lines in place of others, the line and place of the fault, the rule
FAULTS = {
    "no gap": ("contact", "", 'radii = "20 mm"', 1, "contact", "none of radii, gap or table"),
    "two gaps": ("contact", 'gap = "x"\nsize = "1 mm"', "", 4, "contact.gap", "together"),
    "no size": ("contact", 'gap = "x"', 'radii = "20 mm"', 1, "contact", "how far"),
    "formula": ("contact", 'gap = "z"\nsize = "1 mm"', 'radii = "20 mm"', 4, "contact.gap", "unknown name"),
    "rows": ("contact", TABLE.replace(", [0.002, 0.003]", ""), 'radii = "20 mm"', 4, "contact.table.h", "1 rows for 2"),
    "moduli": ("contact", "modulus = 1e9\npoisson = [0.3, 0.3]", "", 5, "contact.poisson", "together with modulus"),
    "loads": ("reliability", "load = [3, 2]", "load = [2, 2.5]", 6, "reliability.load", "loads from 3 to 2"),
    "test": ("reliability", "items = 30", "", 4, "reliability.strength", "together with items"),
    "half a test": (
        "reliability",
        "items = 3\nleast_life = 2",
        "strength = 2.6\ndecay = 2e-4",
        1,
        "reliability",
        "mean",
    ),
    "no decay": ("reliability", "", "decay = 2e-4", 1, "reliability", "strength and decay"),
    "twice": ("tie_down", f'preload = "1 kN"\n{THREAD}', "", 6, "tie_down.preload", "together with thread"),
    "no section": ("tie_down", 'strength = "240 MPa"', "", 1, "tie_down", "strength without section"),
    "late": ("falling_ball", 'times = ["200 s"]', "", 5, "falling_ball.times", "nothing of the ball is left"),
    "no gravity": ("falling_ball", 'relative_speed = "own"\ngravity = 0', "", 6, "falling_ball.gravity", "without"),
    "no speed": ("bearing", "wheel_speed = 2", 'speed = "46 rpm"', 1, "bearing", "with a wheel"),
    "rings": ("bearing", 'outer = "150 mm"', 'outer = "340 mm"', 7, "bearing.outer", "not larger"),
    "bodies": ("bearing", 'roller = "96 mm"', 'roller = "39 mm"', 7, "bearing.roller", "do not fit"),
    "crowd": ("bearing", "count = 20", "count = 14", 7, "bearing.count", "room for 19"),
    "no load": ("liner", "", 'moment = "1 kN"', 1, "liner", "nothing loads the liner"),
    "two moments": ("liner", CLAMP, "", 6, "liner.moment", "together with clamp"),
    "ring": ("liner", 'ring_outer = "60 mm"', 'ring_outer = "80 mm"', 7, "liner.ring_outer", "within the shell"),
    "no bore": ("liner", 'thickness = "140 mm"', 'thickness = "6 mm"', 7, "liner.thickness", "leaves no bore"),
    "short": ("liner", 'length = "0.1 mm"', "", 7, "liner.length", "too short to bend"),
    "two winds": ("transloader", f"wind = {WIND}\nloads = {{ wind = 3 }}", "", 4, "transloader.loads.wind", "together"),
    "no speed of a start": (
        "transloader",
        "inertia = { weights = [1], time = 2 }",
        "",
        3,
        "transloader.inertia",
        "the speed is not known",
    ),
    "no time of a start": (
        "transloader",
        "inertia = { weights = [1], speed = 2 }",
        "",
        3,
        "transloader.inertia",
        "the time is not known",
    ),
    "no gravity of a start": (
        "transloader",
        f"gravity = 0\n{TROLLEY}\ninertia = {{ weights = [1] }}",
        "",
        3,
        "transloader.gravity",
        "no masses",
    ),
    "no span": ("transloader", 'deflection = "8 mm"', "", 1, "transloader", "measured by the span"),
    "no K1": (
        "transloader",
        f'{BARE}mechanism = "bridge"\ninfluence = {{ rated_load = 1 }}',
        "",
        3,
        "transloader.parts",
        "no K1 of the mechanism 'bridge'",
    ),
    "unknown load": (
        "transloader",
        f"{BARE}influence = {{ shock = 1 }}",
        "",
        7,
        "transloader.parts",
        "shock is not known",
    ),
    "unloaded": ("transloader", f"{BARE}influence = {{}}", "", 7, "transloader.parts", "no load acts"),
    "same part": ("transloader", f"{PART}\n{PART}", "", 14, "transloader.parts", "a second part is named 'beam'"),
    "readings": ("bearing", "peak = [1]", "", 1, "bearing", "peak without rms"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_one_slip_is_one_fault_at_its_line(name: str) -> None:
    table, lines, instead, line, place, rule = FAULTS[name]
    with pytest.raises(SpecError) as caught:
        parse_spec(spec_text(table, lines, instead))
    assert len(caught.value.faults) == 1, caught.value
    (fault,) = caught.value.faults
    assert (fault.line, fault.path.startswith(place), rule in fault.message) == (line, True, True), str(fault)


@pytest.mark.parametrize("table", TABLES)
def test_a_spec_without_one(table: str) -> None:
    with pytest.raises(UsageError, match=rf"no \[{table}\]"):
        READ[table](load_spec(CONFIGS / "cam.toml"))


@pytest.mark.parametrize("name", ["contact", "reliability", "tie-down", "ball", "bearing", "liner", "transloader"])
def test_the_schema_takes_the_ready_specs(name: str, schema: dict[str, Any]) -> None:
    file = CONFIGS / f"extra-{name}.toml"
    load_spec(file)
    assert accepts(schema, tomllib.loads(file.read_text()), schema)
