"""Specs that the ready ones do not show: a group of class III, a mechanism near a dead point, no mechanism at all."""

from __future__ import annotations

from written import link, pin, slide

PLATFORM = (
    """
[mechanism.input]
joint = "O"
speed = "1 rad/s"

[mechanism.fixed]
O = [0, 0]
E = [4, 0]
H = [2, 4]

"""
    + link(1, "O = [0, 0], A = [1, 0]")
    + link(2, "A = [0, 0], B = [2, 0]")
    + link(3, "B = [0, 0], D = [1, 0], G = [0.5, 1]")
    + link(4, "D = [0, 0], E = [2, 0]")
    + link(5, "G = [0, 0], H = [2, 0]")
    + "".join(
        pin(*joint)
        for joint in (("O", 0, 1), ("A", 1, 2), ("B", 2, 3), ("D", 3, 4), ("E", 4, 0), ("G", 3, 5), ("H", 5, 0))
    )
)

# a piston drives a crank of 100 mm by a rod of 300 mm; their dead point is at 400 mm
PISTON = (
    """
[project]
title = "Piston and crank"

[mechanism.input]
joint = "piston"
speed = "0.1 m/s"
start = "230 mm"

[mechanism.grid]
span = "150 mm"
positions = 10

[mechanism.fixed]
O = [0, 0]

"""
    + link(1, "B = [0, 0]")
    + link(2, 'B = [0, 0], A = ["300 mm", 0]')
    + link(3, 'O = [0, 0], A = ["100 mm", 0]')
    + slide("piston", 1, 0, 'through = "O"')
    + pin("B", 1, 2)
    + pin("A", 2, 3)
    + pin("O", 3, 0)
    + """
[mechanism.assembly.sketch]
A = [0, "90 mm"]
"""
)

TORQUE = """
[torque]
speed = "180 rpm"
formula = "500*sin(theta)^2"
"""

ENGINE = """
[engine]
speed = "3000 rpm"
arrangement = "in-line"
cylinders = 4
spacing = "90 mm"
crank_radius = "50 mm"
rod_length = "150 mm"
reciprocating_mass = "0.6 kg"
"""

ROTOR = """
[rotor]
mass = "50 kg"
center = "200 mm"
bearings = [0, "500 mm"]
speed = "3000 rpm"
planes = ["50 mm", "350 mm"]

[[rotor.unbalances]]
moment = "12 g*mm"
position = "120 mm"
"""
