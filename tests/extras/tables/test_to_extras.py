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
from tmmcalc.extras.tables.reliability import ReliabilityTable
from tmmcalc.extras.tables.tasks.bearing import to_bearing
from tmmcalc.extras.tables.tasks.contact import to_contact
from tmmcalc.extras.tables.tasks.falling_ball import to_ball
from tmmcalc.extras.tables.tasks.reliability import to_reliability
from tmmcalc.extras.tables.tasks.tie_down import to_tie_down
from tmmcalc.extras.tables.tie_down import SupportTable, ThreadTable, TieDownTable
from tmmcalc.project import load_spec, parse_spec

NEEDED = {
    "contact": 'load = "1 kN"\nradii = "20 mm"',
    "reliability": "load = [2, 2.5]\nrate = 0.36\nstrength = 2.6\ndecay = 2e-4",
    "tie_down": 'weight = "5 kN"\nfactor = 0.8\nelevation = "30 deg"\nfriction = 0.4',
    "falling_ball": 'radius = "1 mm"\ndrag = 1e-4\ndecay = 0.5',
    "bearing": 'speed = "46 rpm"\ninner = "150 mm"\nouter = "340 mm"\nroller = "39 mm"\ncount = 14',
}
READ = {
    "contact": to_contact,
    "reliability": to_reliability,
    "tie_down": to_tie_down,
    "falling_ball": to_ball,
    "bearing": to_bearing,
}
TABLES = {
    "contact": ContactTable,
    "reliability": ReliabilityTable,
    "tie_down": TieDownTable,
    "falling_ball": FallingBallTable,
    "bearing": BearingTable,
}
TEST = "items = 30\nleast_life = 100\nmean_life = 150"
THREAD = 'thread = { moment = "30 N*m", diameter = "14 mm", lead_angle = "3 deg", friction_angle = "9 deg" }'
SUPPORT = (
    'support = { weight = "1 kN", friction = 0.2, base = "4 m", cradle_arm = "3 m", arm = "1 m", diameter = "2 m" }'
)
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
}


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
        further = {"contact": (GapTableTable,), "tie_down": (ThreadTable, SupportTable)}.get(table, ())
        wanted = {key for each in (model, *further) for key in each.model_fields}
        assert {*re.findall(r"`(\w+)`", section)} | {*re.findall(r"\[tie_down\.(\w+)|\[contact\.(\w+)", section)} >= {
            key for key in wanted if key not in ("table", "thread", "support")
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
    "late": ("falling_ball", 'times = ["200 s"]', "", 5, "falling_ball.times", "nothing of the ball is left"),
    "no gravity": ("falling_ball", 'relative_speed = "own"\ngravity = 0', "", 6, "falling_ball.gravity", "without"),
    "no speed": ("bearing", "wheel_speed = 2", 'speed = "46 rpm"', 1, "bearing", "with a wheel"),
    "rings": ("bearing", 'outer = "150 mm"', 'outer = "340 mm"', 7, "bearing.outer", "not larger"),
    "bodies": ("bearing", 'roller = "96 mm"', 'roller = "39 mm"', 7, "bearing.roller", "do not fit"),
    "crowd": ("bearing", "count = 20", "count = 14", 7, "bearing.count", "room for 19"),
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


@pytest.mark.parametrize("name", ["contact", "reliability", "tie-down", "ball", "bearing"])
def test_the_schema_takes_the_ready_specs(name: str, schema: dict[str, Any]) -> None:
    file = CONFIGS / f"extra-{name}.toml"
    load_spec(file)
    assert accepts(schema, tomllib.loads(file.read_text()), schema)
