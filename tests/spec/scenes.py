"""Texts and assertions that the tests of the spec share."""

from __future__ import annotations

from pathlib import Path

from tmmcalc.errors import Fault

CONFIGS = Path(__file__).parents[2] / "configs"

# values of every TOML type, none of which may break a check
HOSTILE = [
    "1",
    "true",
    '"x"',
    "[]",
    "{}",
    "[[]]",
    "[1]",
    "[{}]",
    "1979-01-01",
    "{ A = [] }",
    "nan",
    '["a", 1]',
]

# added to the shaper: every table of a machine, each with what it may hold
MACHINE = """
[[loads]]
name = "cut"
link = 5
point = "D"
direction = "180 deg"
force = "1500 N"
factor = 1.2
positions = [2, 12]

[[loads]]
link = 5
point = ["10 mm", 0]
polynomial = { force = [1, 2.5, "1/4"] }
between = ["300 deg", "90 deg"]

[[loads]]
link = 3
against = 4
viscous = "0.5 N*m*s/rad"

[[loads]]
link = 3
point = "S3"
quadratic = 3.5
role = "drive"

[[loads]]
link = 5
point = { length = "1 m", angle = "90 deg" }
axes = 3
stroke = "working"
output = "D"
[loads.table]
of = "stroke"
force = [0, "1.5 kN", 100]
interpolation = "pchip"

[[loads]]
link = 5
point = "D"
[loads.indicator]
diameter = "80 mm"
back_pressure = "0.1 MPa"
delay = "90 deg"
strokes = [
    { x = [0, 0.1, 1], p = ["5 MPa", "2 MPa", 1e5] },
    { x = [1, 0], p = [1e5, 1e5] },
]

[[springs]]
links = [5, 0]
points = ["D", [0.1, "200 mm"]]
stiffness = "30 N/mm"
free_length = "200 mm"

[[springs]]
name = "T"
kind = "torsion"
links = [3, 4]
stiffness = 100
free_angle = "90 deg"
damping = "0.5 N*m*s/rad"

[drive]
kind = "gear"
radius = "150 mm"
pinion = "90 deg"
internal = true

[motor]
power = "7.5 kW"
speed = "1455 rpm"
synchronous_speed = "1500 rpm"
overload = 2.2
flywheel_moment = 0.11
characteristic = "kloss"

[transmission]
efficiency = 0.95

[reduction]
rods = "lumped"

[motion]
inertia = 12

[flywheel]
delta = "1/25"
shaft = "motor"
"""


def check_only_fault(text: str, faults: list[Fault], path: str, message: str, remedy: str) -> None:
    """There is one fault, with exactly these words, and its line is that of its key."""
    assert [(fault.path, fault.message, fault.remedy) for fault in faults] == [(path, message, remedy)]
    line = text.splitlines()[(faults[0].line or 0) - 1]
    if message.startswith("missing key"):
        assert line.startswith(("[", "strokes", "polynomial", "table"))
    else:
        assert path.replace("]", "").split(".")[-1].split("[")[0] in line
