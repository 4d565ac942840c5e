"""Texts that the tests of the spec share."""

from __future__ import annotations

from pathlib import Path

CONFIGS = Path(__file__).parents[2] / "configs"

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

[[shafts]]
stiffness = "5000 N*m/rad"
damping = "2 N*m*s/rad"
ratio = 4
inertia = "0.5 kg*m^2"

[[shafts]]
name = "low"
stiffness = "80 kN*m/rad"
ratio = "13.2/2"
behind_gear = true

[[transients]]
duration = "5 s"
load = 0
load_steps = [{ factor = 1, speed = "50 rpm", quiet = true }, { factor = 0.5, time = "3 s" }]
targets = ["20 rpm", "40 rpm"]
end_angle = "20 rev"

[[transients]]
name = "stop"
duration = "10 s"
from = "steady"
motor_on = [["0 s", "2 s"]]
brake = { moment = "200 N*m", viscous = 1.5, from = "2 s", to = "8 s", mass = 0 }
standstill = "pass"
method = "merson"
step = "1 ms"

[balance]
radius = "150 mm"
point = "B"
schemes = ["minimax", "lanchester 2"]
counterweights = [{ link = 1, radius = "60 mm" }, { link = 3, mass = 4.5 }]
add = [{ order = -1, mass = "2 kg", radius = "60 mm", angle = "90 deg", axis = [0, "-200 mm"] }]
"""

# what may stand beside a mechanism or alone
ENGINE = """
[engine]
speed = "3000 rpm"
arrangement = "in-line"
cylinders = 4
spacing = "90 mm"
crank_radius = "40 mm"
rod_length = "140 mm"
reciprocating_mass = "0.6 kg"
throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
firing_order = [1, 3, 4, 2]
orders = [1, 2]
"""
ROTOR = """
[rotor]
mass = "40 kg"
center = "200 mm"
bearings = [0, "400 mm"]
speed = "3000 rpm"
planes = ["50 mm", "350 mm"]
grade = "G6.3"
radius = "80 mm"

[[rotor.unbalances]]
moment = "12 g*mm"
angle = "90 deg"
position = "120 mm"

[[rotor.unbalances]]
mass = "-5 g"
radius = "80 mm"
position = 0.3
"""

# in place of a mechanism
TORQUE = """
[torque]
speed = "180 rpm"
formula = "M0*sin(theta)^2 - 120"
constants = { M0 = "1000/2" }
count = 2
inertia = 3
balanced = true
"""

TRAIN = """
[train]
layout = ["AI", "AIbar"]
ratio = "7.29"
tolerance = "1 %"
planets = [3, 4]
module_ratios = [[2, 3], [4, 7]]
sum_max = 200
keep = 500
module = "2 mm"

[train.constraints]
adjacency_gap = 0.5
undercut = true
centre_distance = ["20 mm", "400 mm"]
envelope = false
"""
