"""Every kind of fault in [cam]: its place, its words, what to write instead."""

from __future__ import annotations

import re
from typing import get_args, get_type_hints

import pytest
from faults import HOSTILE, Faults, check_fault
from project.scenes import CONFIGS
from sparing import sparing

from tmmcalc.cams import follower, task
from tmmcalc.cams.tables.cam import CLOSURES, FOLLOWERS
from tmmcalc.cams.tables.cam_spring import SPRING_KEYS
from tmmcalc.core.errors import Fault, SpecError
from tmmcalc.project import parse_spec

TURN = 'rise = "60 deg"\nhigh_dwell = "30 deg"\nreturn_angle = "60 deg"\n'
LAW = 'law = "sine"\n'
RT = f'[cam]\nfollower = "translating"\nstroke = "30 mm"\n{TURN}{LAW}'
RK = f'[cam]\nfollower = "oscillating"\nstroke = "30 deg"\nrocker_length = "100 mm"\n{TURN}{LAW}'
PT = f'[cam]\nfollower = "flat"\nstroke = "30 mm"\n{TURN}{LAW}'
BARE = RT.replace(LAW, "")
SPEED = 'speed = "120 rpm"\n'
LOADS = f'{SPEED}[cam.loads]\nmass = "0.2 kg"\n'
ROCKING = f'{SPEED}[cam.loads]\ninertia = "1e-4 kg*m^2"\n'
GROOVE = f'{RT}closure = "groove"\n'
TABLE = f"{RT}{SPEED}[cam.loads]\nforce_table = "


def own(law: str) -> str:
    return RT.replace('"sine"', f"{{ {law} }}")


TURNED = '[torque]\nspeed = "60 rpm"\nformula = "1"\n'
MASS = '[cam.loads]\nmass = "0.2 kg"\n'


def driven(lines: str, torque: str = TURNED, loads: str = MASS) -> str:
    return f"{RT}{lines}\n{loads}{torque}"


# the whole spec; then the path of its one fault, a piece of its message and of its remedy
FAULTS = [
    # a shaft of the machine
    (driven('shaft = "gear"'), "cam.shaft", "'gear' is no shaft of the machine", "crank, motor"),
    (driven("ratio = 2"), "cam.ratio", "ratio without shaft", 'shaft = "crank"'),
    (driven('shaft = "crank"', ""), "cam.shaft", "there is no shaft that turns", "[mechanism]"),
    (driven('shaft = "crank"\nspeed = "10 rpm"'), "cam.speed", "speed together with shaft", "remove it"),
    (driven('shaft = "crank"', loads=""), "cam.shaft", "shaft without [cam.loads]", "add [cam.loads]"),
    (driven('shaft = "motor"'), "cam.shaft", "without the ratio of the gears", "[transmission]"),
    (driven('shaft = "crank"\nratio = 0'), "cam.ratio", "0 is out of range; a ratio of speeds is above 0", "0.5"),
    (driven('shaft = "crank"\nratio = 0.377'), "cam.ratio", "turns 0.377 times in a turn of the crank", '"1/3"'),
    (
        driven('shaft = "motor"\nratio = 0.5', f"{TURNED}[transmission]\nratio = 3.1\n"),
        "cam.ratio",
        "with a ratio of 0.5 and a ratio of 3.1 of the gears the cam turns 1.55 times",
        "quotient",
    ),
    (
        driven('shaft = "crank"\nratio = 0.5'),
        "cam.ratio",
        "the cam repeats after 720 deg of the shaft, the cycle of [torque] is 360 deg",
        'period = "720 deg"',
    ),
    # what is missing
    (RT.replace('follower = "translating"\n', ""), "cam.follower", "missing key: a cam has a follower", "flat"),
    (RT.replace('stroke = "30 mm"\n', ""), "cam.stroke", "missing key: a follower has its stroke", '"30 mm"'),
    (RT.replace('rise = "60 deg"\n', ""), "cam.rise", "missing key: the rise takes an angle", '"60 deg"'),
    (RT.replace('return_angle = "60 deg"\n', ""), "cam.return_angle", "missing key: the return takes", '"60 deg"'),
    (BARE, "cam", "missing key: the follower moves by a law", 'law = "sine"'),
    (f'{BARE}rise_law = "sine"\n', "cam", "missing key: return_law", 'return_law = "sine"'),
    (f'{BARE}return_law = "sine"\n', "cam", "missing key: rise_law", 'rise_law = "sine"'),
    (
        RK.replace('rocker_length = "100 mm"\n', ""),
        "cam",
        "missing key: angles alone give a rocker no size",
        "add rock",
    ),
    # words
    (RT.replace("translating", "translatory"), "cam.follower", "is no kind of follower", '"translating"'),
    (f'{RT}rotation = "left"\n', "cam.rotation", "'left' is no sense of rotation", "clockwise, counter-clockwise"),
    (f'{RT}closure = "form"\n', "cam.closure", "'form' is no way to keep", "force, groove"),
    (f'{RK}rocker_turn = "co"\n', "cam.rocker_turn", "is no sense of the rocker", "with, against"),
    (f'{RT}stroek = "1 mm"\n', "cam.stroek", "unknown key 'stroek' in [cam]", 'did you mean "stroke"?'),
    (f"{RT}mass = 1\n", "cam.mass", "unknown key 'mass'", "mass belongs in"),
    # phases
    (RT.replace('rise = "60', 'rise = "0'), "cam.rise", "'0 deg' is zero", "for example"),
    (RT.replace('rise = "60', 'rise = "-60'), "cam.rise", "is negative", "without the minus"),
    (RT.replace('rise = "60 deg"', "rise = 60"), "cam.rise", "60 without a unit is in radians", '"60 deg"'),
    (RT.replace('return_angle = "60', 'return_angle = "0'), "cam.return_angle", "is zero", "for example"),
    (RT.replace('dwell = "30', 'dwell = "-3'), "cam.high_dwell", "is negative", "without the minus"),
    (
        RT.replace('dwell = "30', 'dwell = "300'),
        "cam.return_angle",
        "together take 420 deg, more than a turn",
        "360 deg or less",
    ),
    # the stroke
    (RT.replace('"30 mm"', '"30 deg"'), "cam.stroke", "'30 deg' is an angle; stroke of a translating", '"200 mm"'),
    (PT.replace('"30 mm"', '"30 deg"'), "cam.stroke", "stroke of a flat-faced follower is a length", "a length"),
    (RK.replace('"30 deg"', '"30 mm"', 1), "cam.stroke", "stroke of an oscillating follower is an angle", '"30 deg"'),
    (RT.replace('"30 mm"', "30"), "cam.stroke", "30 without a unit is in m", 'write "30 mm"'),
    (RK.replace('"30 deg"', "30", 1), "cam.stroke", "30 without a unit is in radians", 'write "30 deg"'),
    (RK.replace('"30 deg"', '"180 deg"', 1), "cam.stroke", "'180 deg' is half a turn or more", "swings less"),
    (RT.replace('"30 mm"', '"0 mm"'), "cam.stroke", "is zero", "for example"),
    (RT.replace('"30 mm"', '"-3 mm"'), "cam.stroke", "is negative", "without the minus"),
    (RT.replace('"30 mm"', '"30 kg"'), "cam.stroke", "is a mass", "200 mm"),
    # speed, rows
    (f"{RT}speed = 1450\n", "cam.speed", "1450 without a unit is in rad/s", '"1450 rpm"'),
    (f"{RT}speed = 0\n", "cam.speed", "0 is zero", "for example"),
    (f'{RT}speed = "-10 rpm"\n', "cam.speed", "is negative", "without the minus"),
    (f'{RT}steps = 10\nstep = "1 deg"\n', "cam.steps", "steps and step together", "keep one"),
    (f"{RT}steps = 1\n", "cam.steps", "a number of steps is between 2 and", "between"),
    (f'{RT}step = "0 deg"\n', "cam.step", "out of range", "between them"),
    # laws by name
    (RT.replace("sine", "sinus"), "cam.law", "'sinus' is no law of motion", 'did you mean "sine"?'),
    (RT.replace('"sine"', "3"), "cam.law", "3 is no law of motion", 'write law = "sine"'),
    (
        f'{RT}rise_law = "shun"\nreturn_law = "const"\n',
        "cam.law",
        "no phase is left for it",
        "remove it",
    ),
    (
        f'{RT}roller_radius = "8 mm"\n{LOADS}[cam.requirements]\npin = "9 mm"\n',
        "cam.requirements.pin",
        "a pin of 9 mm radius does not fit into a roller of 8 mm",
        'less than "8 mm"',
    ),
    # laws of one's own
    (RT.replace('"sine"', "{}"), "cam.law", "missing key: a law of one's own has", "points"),
    (
        own("points = [[0, 0], [1, 1]], polynomial = [0, 0, 3, -2]"),
        "cam.law.polynomial",
        "points and polynomial together",
        "keep one",
    ),
    (own('points = [[0, 0], [1, 1]], file = "law.csv"'), "cam.law.file", "points and file together", "keep one"),
    (own("point = [[0, 0], [1, 1]]"), "cam.law.point", "unknown key 'point' in [cam.law]", "points"),
    (own("points = [[0, 0]]"), "cam.law.points", "has 1 value; a list of two points or more", "points = ["),
    (own("points = [[0, 0], [1]]"), "cam.law.points[1]", "has 1 value; a part of the phase", "[0.5, 0.4]"),
    (own("points = 3"), "cam.law.points", "3 is not a list of two points or more", "points = ["),
    (own('points = [[0, 0], ["x", 1]]'), "cam.law.points[1][0]", "'x' is not", "such as"),
    (own("points = [[0, 0], [0.6, 0.4], [0.5, 1]]"), "cam.law.points[2][0]", "0.5 does not come after 0.6", "order"),
    (own("points = [[0, 0], [0.5, 0.4], [0.5, 1]]"), "cam.law.points[2][0]", "0.5 does not come after 0.5", "order"),
    (own("points = [[0.1, 0], [1, 1]]"), "cam.law.points[0][0]", "k begins at 0.1, not at 0", "from the beginning"),
    (own("points = [[0, 0.1], [1, 1]]"), "cam.law.points", "s runs from 0.1 to 1", "displacements from 0"),
    (own("points = [[0, 0], [1, -1]]"), "cam.law.points", "s runs from 0 to -1", "displacements from 0"),
    (own('points = [[0, 0], [0.5, 1], ["60 deg", 2]]'), "cam.law.points[2][0]", "k of the other points", "one unit"),
    (own('points = [[0, 0], ["9 mm", 1]]'), "cam.law.points[1][0]", "is a length; k is a part of the phase", "angles"),
    (
        own('points = [[0, 0], [1, "3 mm"], [2, "1 deg"]]'),
        "cam.law.points[2][1]",
        "s of the other points is a length",
        "one unit",
    ),
    (
        own("points = [[0, 0], [0.5, 0.1], [0.5000001, 0.2], [1, 1]]"),
        "cam.law.points",
        "point number 3 stands closer than 1e-06 of the phase",
        "fewer points",
    ),
    (
        own("acceleration = [[0, 1], [1, 1]]"),
        "cam.law.acceleration",
        "does not add up to 0",
        "equal areas above and below zero",
    ),
    (
        own("acceleration = [[0, -1], [1, 1]]"),
        "cam.law.acceleration",
        "gives no lift",
        "first an acceleration above zero",
    ),
    (
        own('acceleration = [[0, "1 mm"], [1, -1]]'),
        "cam.law.acceleration[0][1]",
        "accelerations are to any scale",
        "write a number",
    ),
    (
        own("acceleration = [[0, 1], [0.5, 1], [0.5, 0], [0.5, -1], [1, -1]]"),
        "cam.law.acceleration[3][0]",
        "stands at most twice",
        "in order",
    ),
    (own("polynomial = [0, 0]"), "cam.law.polynomial", "2 values; a list of 3 to 30 coefficients", "polynomial = ["),
    (own("polynomial = [0, 1, 1]"), "cam.law.polynomial", "at its begin s = 0, s' = 0.5", "s'(0) = s'(1) = 0"),
    (own("polynomial = [0, 0, -1]"), "cam.law.polynomial", "it ends at s(1) = -1", "add up to 1"),
    (own('polynomial = [0, 0, "3 mm"]'), "cam.law.polynomial[2]", "is not a coefficient", "no unit"),
    (own("points = [[0, 0], [0.5, 1e200], [1, 1e-200]]"), "cam.law.points", "of too different size", "ordinary size"),
    (own("polynomial = [0, 0, 1e200, 1e-200]"), "cam.law.polynomial", "at its end s = 1, s' = 2", "struck"),
    (own('file = "no.csv"'), "cam.law.file", "there is no file 'no.csv'", "counts from the folder"),
    # keys of another follower
    (f'{RK}start_distance = "50 mm"\n', "cam.start_distance", "a rocker begins at an angle", "start_angle"),
    (f'{RT}start_angle = "30 deg"\n', "cam.start_angle", "a stem begins at a distance", "start_distance"),
    (f'{RK}offset = "5 mm"\n', "cam.offset", "of an oscillating follower: only a roller on a stem", "remove"),
    (f'{PT}offset = "5 mm"\n', "cam.offset", "of a flat-faced follower: only a roller on a stem", "remove"),
    (f'{PT}roller_radius = "5 mm"\n', "cam.roller_radius", "there is no roller", "remove"),
    (f'{RT}centre_distance = "90 mm"\n', "cam.centre_distance", "there is no rocker", "remove"),
    (f'{PT}rocker_length = "90 mm"\n', "cam.rocker_length", "there is no rocker", "remove"),
    (f'{RT}rocker_turn = "with"\n', "cam.rocker_turn", "there is no rocker", "remove"),
    (f'{RT}face_margin = "2 mm"\n', "cam.face_margin", "there is no flat face", "remove"),
    (f'{RK}[cam.guide]\nland = "4 mm"\n', "cam.guide", "a rocker has no guide", "remove"),
    (f'{PT}[cam.limits]\npressure_angle = "30 deg"\n', "cam.limits.pressure_angle", "0 everywhere", "remove"),
    (f"{PT}[cam.limits]\npressure_angle_return = false\n", "cam.limits.pressure_angle_return", "0 every", "remove"),
    (f'{PT}[cam.limits]\nconcave_radius = "70 mm"\n', "cam.limits.concave_radius", "all is convex", "remove"),
    (f"{PT}[cam.limits]\nallow_concave = true\n", "cam.limits.allow_concave", "all is convex", "remove"),
    (f"{RK}{SPEED}[cam.loads]\nmass = 1\n", "cam.loads.mass", "a rocker has a moment of inertia", "inertia ="),
    (f"{RT}{SPEED}[cam.loads]\ninertia = 1\n", "cam.loads.inertia", "a stem has a mass", "mass ="),
    (f"{RK}{ROCKING}gravity = -9.81\n", "cam.loads.gravity", "the weight of a rocker is a moment", "add it to force"),
    (f"{RK}{ROCKING}friction = 0.1\n", "cam.loads.friction", "a rocker has no guide", "pivot_friction"),
    (f"{RT}{LOADS}pivot_friction = 0.1\n", "cam.loads.pivot_friction", "a stem has no pivot", "write friction"),
    (f'{PT}{LOADS}pivot_radius = "6 mm"\n', "cam.loads.pivot_radius", "a stem has no pivot", "remove"),
    (f'{RK}{ROCKING}[cam.spring]\nwire = "2 mm"\n', "cam.spring.wire", "a rocker's spring turns", "remove"),
    (f'{RK}{ROCKING}[cam.spring]\ncoil = "20 mm"\n', "cam.spring.coil", "a rocker's spring turns", "remove"),
    (f'{PT}{LOADS}[cam.requirements]\npin = "4 mm"\n', "cam.requirements.pin", "there is no roller", "remove"),
    (
        f'{RK}{ROCKING}[cam.requirements]\nguide_pressure = "5 MPa"\n',
        "cam.requirements.guide_pressure",
        "a rocker has no guide",
        "remove",
    ),
    # units of another follower
    (f'{RK}{ROCKING}force = "-5 N"\n', "cam.loads.force", "force of an oscillating follower is a moment", '"40 N*m"'),
    (f'{RT}{LOADS}force_return = "-5 N*m"\n', "cam.loads.force_return", "is a force", '"1.5 kN"'),
    (
        f'{RK}{ROCKING}[cam.spring]\nstiffness = "5 N/mm"\n',
        "cam.spring.stiffness",
        "is a torsional stiffness",
        "N*m/rad",
    ),
    (
        f'{RT}{LOADS}[cam.spring]\nstiffness = 5000\npreload = "1 N*m"\n',
        "cam.spring.preload",
        "preload of a translating follower is a force",
        '"1.5 kN"',
    ),
    (f'{RT}{LOADS}[cam.spring]\ndeflection = "9 deg"\n', "cam.spring.deflection", "is a length", '"200 mm"'),
    (f'{RK}{ROCKING}[cam.spring]\nleast_contact = "5 N"\n', "cam.spring.least_contact", "is a moment", "N*m"),
    (
        f'{RT}{LOADS}[cam.elastic]\nstiffness = "5 N*m/rad"\n',
        "cam.elastic.stiffness",
        "is a torsional stiffness; stiffness of a translating follower is a stiffness",
        "N/mm",
    ),
    (
        f'{RK}{ROCKING}[cam.elastic]\nstiffness = 5\nmass = "1 kg"\n',
        "cam.elastic.mass",
        "is a moment of inertia",
        "kg*m^2",
    ),
    # closure
    (PT.replace(LAW, f'{LAW}closure = "groove"\n'), "cam.closure", "a groove guides a roller", '"force"'),
    (f"{GROOVE}roller_radius = 0\n", "cam.roller_radius", "a knife edge in a groove", '"10 mm"'),
    (f"{GROOVE}{LOADS}[cam.spring]\n", "cam.spring", "the groove keeps the follower on the cam", "remove"),
    # sizes
    (f"{RT}start_distance = 50\n", "cam.start_distance", "50 without a unit is in m", '"50 mm"'),
    (f'{RT}start_distance = "0 mm"\n', "cam.start_distance", "out of range", "between"),
    (f'{RT}roller_radius = "-1 mm"\n', "cam.roller_radius", "out of range", "between"),
    (f'{RK}start_angle = "0 deg"\n', "cam.start_angle", "out of range", "between"),
    (
        f'{RT}start_distance = "50 mm"\nbase_radius = "60 mm"\noffset = "9 mm"\n',
        "cam.base_radius",
        "two of the three give the third",
        "remove one",
    ),
    (
        f'{RT}start_distance = "50 mm"\nbase_radius = "49 mm"\n',
        "cam.base_radius",
        "a base circle of 49 mm does not reach the roller centre 50 mm above",
        "larger one",
    ),
    (f'{PT}start_distance = "50 mm"\nbase_radius = "50 mm"\n', "cam.base_radius", "they are the same", "remove one"),
    (
        f'{RK}start_angle = "30 deg"\nbase_radius = "60 mm"\ncentre_distance = "100 mm"\n',
        "cam.base_radius",
        "start_angle and base_radius and centre_distance and rocker_length together: three of the four",
        "remove one",
    ),
    (
        f'{RK}start_angle = "30 deg"\nbase_radius = "49 mm"\n',
        "cam.base_radius",
        "base_radius = 49 mm makes no triangle with a start angle of 30 deg",
        "more than 50 mm",
    ),
    (
        f'{RK}start_angle = "100 deg"\nbase_radius = "99 mm"\n',
        "cam.base_radius",
        "makes no triangle with a start angle of 100 deg",
        "more than 100 mm",
    ),
    (
        f'{GROOVE}roller_radius = "10 mm"\ntool_radius = "11 mm"\n',
        "cam.tool_radius",
        "a tool of 11 mm does not fit into the groove of a roller of 10 mm",
        "10 mm or less",
    ),
    (
        f'{RT}base_radius = "50 mm"\noffset = "-50 mm"\n',
        "cam.offset",
        "the base circle of 50 mm does not reach the stem, whose axis is 50 mm off",
        "smaller offset",
    ),
    (
        f'{RK}centre_distance = "150 mm"\nbase_radius = "50 mm"\n',
        "cam.base_radius",
        "base_radius = 50 mm makes no triangle with centre_distance = 150 mm and rocker_length = 100 mm",
        "between 50 mm and 250 mm",
    ),
    (
        f'{RK}centre_distance = "150 mm"\nbase_radius = "251 mm"\n',
        "cam.base_radius",
        "makes no triangle",
        "between 50 mm and 250 mm",
    ),
    (
        f'{RK}start_angle = "150 deg"\n',
        "cam.start_angle",
        "begins at 150 deg and swings 30 deg: it would pass the line of centres",
        "below 180 deg",
    ),
    (
        f'{RK}centre_distance = "150 mm"\nbase_radius = "249 mm"\n',
        "cam.base_radius",
        "it would pass the line of centres",
        "smaller stroke",
    ),
    (
        f'{RT}start_distance = "30 mm"\noffset = "40 mm"\nroller_radius = "50 mm"\n',
        "cam.roller_radius",
        "a roller of 50 mm covers the cam's axis: the pitch curve's base circle has 50 mm",
        "smaller roller",
    ),
    (
        f'{RK}centre_distance = "100 mm"\nstart_angle = "30 deg"\nroller_radius = "60 mm"\n',
        "cam.roller_radius",
        "base circle has 51.7638 mm",
        "smaller roller",
    ),
    (
        f'{RT}start_distance = "50 mm"\nroller_radius = "10 mm"\n[cam.guide]\ntop = "90 mm"\n',
        "cam.guide.top",
        "at its highest reaches 90 mm, the guide's upper edge stands at 90 mm",
        "higher",
    ),
    (f'{PT}base_radius = "50 mm"\n[cam.guide]\ntop = "70 mm"\n', "cam.guide.top", "reaches 80 mm", "higher"),
    (f'{RT}[cam.guide]\ntop = "90 mm"\nlength = "40 mm"\n', "cam.guide.length", "length together with top", "one"),
    # limits
    (f'{RT}[cam.limits]\npressure_angle = "90 deg"\n', "cam.limits.pressure_angle", "between 1 and 89", "between"),
    (f"{RT}[cam.limits]\npressure_angle = 30\n", "cam.limits.pressure_angle", "30 without a unit", '"30 deg"'),
    (
        f"{RT}[cam.limits]\npressure_angle_return = true\n",
        "cam.limits.pressure_angle_return",
        "true is not an angle",
        "or false to switch it off",
    ),
    (
        f'{RT}[cam.limits]\nallow_concave = false\nconcave_radius = "70 mm"\n',
        "cam.limits.concave_radius",
        "no part is concave",
        "remove one",
    ),
    (f'{RT}[cam.limits]\nconvex_radius = "-1 mm"\n', "cam.limits.convex_radius", "out of range", "between"),
    # loads
    (f"{RT}[cam.loads]\nmass = 1\n", "cam.loads", "without speed: inertia forces depend on it", 'speed = "120 rpm"'),
    (f"{RT}{SPEED}[cam.loads]\n", "cam.loads", "missing key: nothing acts on the follower", 'mass = "0.2 kg"'),
    (f"{RT}{SPEED}[cam.loads]\nforce = -5\ngravity = -9.81\n", "cam.loads.gravity", "nothing is weighed", "mass ="),
    (f"{RT}{LOADS.replace('0.2', '-0.2')}", "cam.loads.mass", "is negative", "without the minus"),
    (f"{RT}{LOADS}friction = 0.1\n", "cam.loads.friction", "friction without a guide", "top ="),
    (f"{RK}{ROCKING}pivot_friction = 0.1\n", "cam.loads.pivot_friction", "without pivot_radius", '"6 mm"'),
    (f'{RK}{ROCKING}pivot_radius = "6 mm"\n', "cam.loads.pivot_radius", "without pivot_friction", "0.1"),
    # a force by the angle
    (f"{TABLE}{{}}\n", "cam.loads.force_table", "missing key: a table of forces has its values", "force ="),
    (f"{TABLE}3\n", "cam.loads.force_table", "3 is not a table", "force_table = {"),
    (
        f"{TABLE}{{ force = [1, 2] }}\nforce = 5\n",
        "cam.loads.force_table",
        "force_table together with force",
        "remove one",
    ),
    (f"{TABLE}{{ force = [1, 2], moment = [1, 2] }}\n", "cam.loads.force_table.moment", "force and moment", "remove"),
    (f"{TABLE}{{ moment = [1, 2] }}\n", "cam.loads.force_table.moment", "on which a force acts", "write force"),
    (
        f"{RK}{ROCKING}force_table = {{ force = [1, 2] }}\n",
        "cam.loads.force_table.force",
        "on which a moment acts",
        "write moment",
    ),
    (
        f"{TABLE}{{ phi = [0, 1], force = [1, 2, 3] }}\n",
        "cam.loads.force_table.force",
        "3 values for 2",
        "one for each",
    ),
    (
        f"{TABLE}{{ phi = [0], force = [1, 2] }}\n",
        "cam.loads.force_table.phi",
        "1 value; a list of two angles",
        "phi =",
    ),
    (f"{TABLE}{{ phi = [1, 0.5], force = [1, 2] }}\n", "cam.loads.force_table.phi[1]", "does not come after", "order"),
    (
        f'{TABLE}{{ phi = [0, "400 deg"], force = [1, 2] }}\n',
        "cam.loads.force_table.phi[1]",
        "400 deg is more than a turn",
        "0 to 360",
    ),
    (
        f'{TABLE}{{ phi = [0, "360 deg"], force = [1, 2] }}\n',
        "cam.loads.force_table.force[1]",
        "at 0 and at 360 deg differ",
        "make the two equal",
    ),
    (
        f'{TABLE}{{ file = "q.csv", force = [1, 2] }}\n',
        "cam.loads.force_table.file",
        "file together with force",
        "remove file",
    ),
    # the spring
    (f"{RT}[cam.spring]\nsafety = 1.5\n", "cam.spring", "[cam.spring] without [cam.loads]", "add [cam.loads]"),
    (f"{RT}{LOADS}[cam.spring]\nsafety = 0.9\n", "cam.spring.safety", "a safety of the contact is", "1.25"),
    (f'{RT}{LOADS}[cam.spring]\nmethod = "K1"\n', "cam.spring.method", "'K1' is no way to size", "safety, given"),
    (
        f'{RT}{LOADS}[cam.spring]\nstiffness = "5 N/mm"\nsafety = 1.5\n',
        "cam.spring.safety",
        'safety is of no use with method = "given"',
        'method = "safety"',
    ),
    (
        f'{RT}{LOADS}[cam.spring]\nmethod = "safety"\nleast_contact = "5 N"\n',
        "cam.spring.least_contact",
        "of no use",
        'method = "preload"',
    ),
    (f'{RT}{LOADS}[cam.spring]\nmethod = "none"\nexact = true\n', "cam.spring.exact", "of no use", '"safety"'),
    (f'{RT}{LOADS}[cam.spring]\npreload = "5 N"\n', "cam.spring", "missing key: a given spring", '"5 N/mm"'),
    (f'{RK}{ROCKING}[cam.spring]\nmethod = "given"\n', "cam.spring", "missing key: a given spring", '"2 N*m/rad"'),
    (
        f"{RT}{SPEED}[cam.loads]\nforce = -100\n[cam.spring]\nsafety = 1.5\n",
        "cam.spring",
        "without a mass: it is sized by the inertia force",
        'mass = "0.2 kg"',
    ),
    (f'{RT}{LOADS}[cam.spring]\nwire = "2 mm"\n', "cam.spring.wire", "wire without coil", "coil ="),
    (
        f'{RT}{LOADS}[cam.requirements]\ncontact = "400 MPa"\n'
        'material = { treatment = "improved", hardness = "300 HB" }\n',
        "cam.requirements.contact",
        "together with material",
        "remove",
    ),
    (
        f'{RT}{LOADS}[cam.requirements]\nmaterial = {{ treatment = "carburised", hardness = "40 HRC" }}\n',
        "cam.requirements.material.hardness",
        "outside the tables",
        "change the hardness",
    ),
    (
        f'{RT}{LOADS}[cam.requirements]\nmaterial = {{ treatment = "improved", hardness = "hard" }}\n',
        "cam.requirements.material.hardness",
        "is not a hardness",
        "change the hardness",
    ),
    (f"{RT}{LOADS}[cam.spring]\ndead_coils = 2\n", "cam.spring.dead_coils", "without shear_stress", "shear_stress ="),
    (
        f"{RK}{ROCKING}[cam.spring]\nshear_stress = 5e8\n",
        "cam.spring.shear_stress",
        "a rocker's spring turns",
        "remove",
    ),
    (f"{RT}{LOADS}[cam.spring]\nshear_modulus = 8e10\n", "cam.spring.shear_modulus", "without wire and coil", "coil"),
    (
        f'{RT}{LOADS}[cam.spring]\nwire = "2 mm"\ncoil = "2 mm"\n',
        "cam.spring.coil",
        "a wire of 2 mm cannot be coiled to a mean diameter of 2 mm",
        "larger coil",
    ),
    (
        f'{RT}{LOADS}[cam.spring]\nmethod = "none"\nwire = "2 mm"\ncoil = "9 mm"\n',
        "cam.spring.wire",
        'of no use with method = "none"',
        "remove",
    ),
    # requirements
    (f'{RT}[cam.requirements]\nwidth = "7 mm"\n', "cam.requirements", "without [cam.loads]", "add [cam.loads]"),
    (f"{RT}{LOADS}[cam.requirements]\ncontact = 0\n", "cam.requirements.contact", "0 is zero", "for example"),
    (f'{RT}{LOADS}[cam.requirements]\ncontact = "-4 MPa"\n', "cam.requirements.contact", "is negative", "minus"),
    (f'{RT}{LOADS}[cam.requirements]\nwidth = "0 mm"\n', "cam.requirements.width", "out of range", "between"),
    (f"{RT}{LOADS}[cam.requirements]\ntorsion = 0\n", "cam.requirements.torsion", "a factor is above 0", "1.4"),
    # the search
    (
        f"{RT}{LOADS}[cam.optimum]\n",
        "cam.optimum",
        "as small as you please",
        "add stem_radius in [cam.guide], land in [cam.guide], guide_pressure in [cam.requirements], width in",
    ),
    (
        f'{PT}{LOADS}[cam.guide]\nland = "4 mm"\n[cam.optimum]\n',
        "cam.optimum",
        "as small as you please",
        "add stem_radius in [cam.guide], guide_pressure in [cam.requirements]",
    ),
    (
        f"{RK}{SPEED}[cam.loads]\nforce = -4\n[cam.optimum]\n",
        "cam.optimum",
        "cam and roller would become as small as you please",
        "add inertia in [cam.loads], width in [cam.requirements], contact in [cam.requirements]",
    ),
    # the elastic follower
    (f"{RT}[cam.elastic]\nstiffness = 5\nmass = 1\n", "cam.elastic", "[cam.elastic] without speed", "speed ="),
    (f"{RT}{SPEED}[cam.elastic]\nmass = 1\n", "cam.elastic.stiffness", "missing key: an elastic follower", "N/mm"),
    (f"{RT}{SPEED}[cam.elastic]\nstiffness = 5\n", "cam.elastic", "missing key: what swings", 'mass = "0.2 kg"'),
    (f"{RT}{LOADS}[cam.elastic]\nstiffness = 5\ndamping = 1\n", "cam.elastic.damping", "is at least 0 and", "0.05"),
]

SEARCH = (
    f'{RT}{LOADS}[cam.guide]\nstem_radius = "4 mm"\nland = "4 mm"\n[cam.requirements]\nwidth = "7 mm"\n'
    'contact = "400 MPa"\nguide_pressure = "5 MPa"\n[cam.optimum]\n'
)
TURNED_SEARCH = f"{RK}{ROCKING}[cam.requirements]\npin_pressure = 5e6\n[cam.optimum]\n"
FAULTS += [
    (f"{TURNED_SEARCH}heights = [0.1, 0.2]\n", "cam.optimum.heights", "a rocker has no guide", "centre_distances"),
    (f"{TURNED_SEARCH}height_step = 0.001\n", "cam.optimum.height_step", "a rocker has no guide", "write step"),
    (f"{SEARCH}centre_distances = [0.1, 0.2]\n", "cam.optimum.centre_distances", "there is no rocker", "heights"),
    (f"{SEARCH}rocker_lengths = [0.1, 0.2]\n", "cam.optimum.rocker_lengths", "there is no rocker", "remove"),
    (
        f"{TURNED_SEARCH}centre_distances = [0.2, 0.1]\n",
        "cam.optimum.centre_distances",
        "backwards",
        "smaller distance",
    ),
    (f"{TURNED_SEARCH}rocker_lengths = [0.2, 0.1]\n", "cam.optimum.rocker_lengths", "backwards", "smaller length"),
    (f'{SEARCH}heights = ["90 mm", "80 mm"]\n', "cam.optimum.heights", "runs backwards", "smaller height first"),
    (f'{SEARCH}heights = ["90 mm"]\n', "cam.optimum.heights", "not a list of 2 values", '["100 mm", "140 mm"]'),
    (f'{SEARCH}laws = ["sine", "shum"]\n', "cam.optimum.laws", "'shum' is no law", 'did you mean "shun"?'),
    (f'{SEARCH}laws = ["sine", "shun", "sine"]\n', "cam.optimum.laws", "'sine' is named twice", "remove one"),
    (f'{SEARCH}step = "0 mm"\n', "cam.optimum.step", "out of range", "between"),
    (f'{SEARCH}phases = "return"\n', "cam.optimum.phases", "is no part of the turn", "turn, rise"),
    (f"{SEARCH}safeties = [0.9]\n", "cam.optimum.safeties", "is at least 1", "1.25"),
    (f"{SEARCH}safeties = [1.2, 1.2]\n", "cam.optimum.safeties", "1.2 is named twice", "remove one"),
    (f'{SEARCH}contacts = "600 MPa"\n', "cam.optimum.contacts", "is not a list", '["400 MPa", "600 MPa"]'),
    (f'{SEARCH}contacts = {{ steel = "6 mm" }}\n', "cam.optimum.contacts", "mm", "MPa"),
    (
        SEARCH.replace('width = "7 mm"\n', 'pin_pressure = "5 MPa"\n') + 'contacts = ["600 MPa"]\n',
        "cam.optimum.contacts",
        "without the width",
        "add width",
    ),
    (f'{SEARCH}roller_ratios = ["needle"]\n', "cam.optimum.roller_ratios", "without what the pin", "pin_pressure"),
    (
        SEARCH.replace(RT, PT) + 'roller_ratios = ["needle"]\n',
        "cam.optimum.roller_ratios",
        "it has no roller",
        "remove",
    ),
    (f"{SEARCH}contacts = {{}}\n", "cam.optimum.contacts", "{} is empty: there is nothing to try", "write ["),
    (f"{SEARCH}contacts = []\n", "cam.optimum.contacts", "[] is empty: there is nothing to try", "write ["),
    (
        SEARCH.replace("guide_pressure", 'pin_pressure = "5 MPa"\nguide_pressure') + 'roller_ratios = ["needel"]\n',
        "cam.optimum.roller_ratios",
        "no known kind",
        'did you mean "needle"?',
    ),
    (
        f'{SEARCH}laws = ["sine", "shun", "const"]\nsafeties = [1.2, 1.3, 1.4]\ncombine = true\n'
        'contacts = ["500 MPa", "600 MPa", "700 MPa"]\n',
        "cam.optimum",
        "64 mechanisms",
        "combine = false",
    ),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS, ids=[str(k) for k in range(len(FAULTS))])
def test_faults(text: str, path: str, message: str, remedy: str) -> None:
    check_fault(text, path, message, remedy)


def test_all_faults_come_at_once(faults_of: Faults) -> None:
    text = (
        '[cam]\nfollower = "oscillating"\nstroke = "30 mm"\nrise = 60\nreturn_angle = "60 deg"\noffset = 0.005\n'
        "rise_law = { polynomial = [0, 1, 2] }\nreturn_law = { acceleration = [[0, 1], [1, 1]] }\n"
        '[cam.loads]\nmass = 1\n[cam.guide]\ntop = "-1 mm"\n[cam.requirements]\ncontct = 1\n'
    )
    assert sorted(fault.path for fault in faults_of(text)) == [
        "cam",
        "cam.guide",
        "cam.guide.top",
        "cam.loads",
        "cam.loads.mass",
        "cam.offset",
        "cam.requirements.contct",
        "cam.return_law.acceleration",
        "cam.rise",
        "cam.rise_law.polynomial",
        "cam.stroke",
    ]


@pytest.mark.parametrize("key", ["law", "rise_law", "return_law"])
def test_faults_of_every_law(faults_of: Faults, key: str) -> None:
    other = {"law": "", "rise_law": 'return_law = "sine"\n', "return_law": 'rise_law = "sine"\n'}[key]
    (fault,) = faults_of(f"{BARE}{other}{key} = {{ points = [[0, 0], [1, 1], [1]] }}\n")
    assert fault.path == f"cam.{key}.points[2]"
    assert fault.remedy == "write [0.5, 0.4]"


GOOD = [
    RT,
    RK,
    PT,
    GROOVE,
    f"{BARE}rise_law = 'sine'\nreturn_law = 'poly4567'\n",
    f"{RT}return_law = 'shun'\n",  # of one phase, in place of the law of both
    f'{RT}rotation = "counter-clockwise"\noffset = "-5 mm"\nbase_radius = "40 mm"\nroller_radius = 0\n',
    f'{RK}start_angle = "30 deg"\ncentre_distance = 0.1\nroller_radius = "10 mm"\nrocker_turn = "against"\n',
    f'{RK}base_radius = "60 mm"\ncentre_distance = "0.1 m"\n',
    f'{PT}base_radius = "40 mm"\nface_margin = "1 mm"\n',
    # the extremes that can be asked for
    RT.replace('"30 mm"', '"1 um"').replace('"60 deg"', '"5 deg"'),
    RT.replace('"30 mm"', "1").replace('high_dwell = "30 deg"\n', 'speed = "20000 rpm"\n'),
    RT.replace('"60 deg"', '"120 deg"').replace('"30 deg"', '"120 deg"'),
    RT.replace('"60 deg"', '"165 deg"'),
    RK.replace('stroke = "30 deg"', "stroke = 0.5"),
    own("points = [[0, 0], [0.25, 0.1], [1, 1]]"),
    own('points = [[0, 0], ["30 deg", "12 mm"], ["60 deg", "30 mm"]]'),
    own("acceleration = [[0, 1], [0.5, 1], [0.5, -1], [1, -1]]"),
    own("acceleration = [[0, 0], [1, 5], [3, -5], [4, 0]]"),
    own("polynomial = [0, 0, 0, 10, -15, 6]"),
    own("polynomial = [0, 0, 3e6, -2e6]"),
    f"{GROOVE}{LOADS}",
    f"{RT}{SPEED}[cam.loads]\nforce = -100\n",
    f'{RT}{SPEED}[cam.loads]\nforce_table = {{ phi = [0, "360 deg"], force = [-1, -1] }}\n',
    f'{RT}{LOADS}friction = 0.1\n[cam.guide]\ntop = "120 mm"\n',
    f"{PT}{LOADS}friction = 0\n",
    f"{RT}{LOADS}[cam.spring]\n",
    f'{RT}{LOADS}[cam.spring]\nmethod = "none"\n',
    f'{RT}{LOADS}[cam.spring]\nleast_contact = "5 N"\nwire = "2 mm"\ncoil = "16 mm"\n',
    f"{RT}[cam.limits]\npressure_angle_return = false\n",
    SEARCH,
    SEARCH.replace('width = "7 mm"\ncontact = "400 MPa"', 'pin_pressure = "5 MPa"'),
    SEARCH.replace('width = "7 mm"\ncontact = "400 MPa"\n', "").replace('"translating"', '"flat"'),
    f'{RT}start_distance = "50 mm"\nbase_radius = "60 mm"\n',
    f'{RK}start_angle = "30 deg"\nbase_radius = "60 mm"\n',
    RK.replace("rocker_length", "base_radius"),
    f'{GROOVE}roller_radius = "10 mm"\ntool_radius = "10 mm"\n',
    SEARCH.replace('"0.2 kg"\n', '"0.2 kg"\nfriction = 0.1\n'),
    f'{SEARCH}heights = [0.08, "90 mm"]\nlaws = ["sine", "shun"]\n',
    f'{RT}{SPEED}[cam.elastic]\nstiffness = "2000 N/mm"\nmass = "1 kg"\n',
    f'{RK}{ROCKING}[cam.elastic]\nstiffness = "2000 N*m/rad"\n',
    f"{RT}[project]\ntitle = 'x'\n",
]


@pytest.mark.parametrize("text", GOOD, ids=[str(k) for k in range(len(GOOD))])
def test_good_cams(text: str) -> None:
    assert parse_spec(text).cam is not None


def test_beside_a_mechanism(shaper: str, faults_of: Faults) -> None:
    spec = parse_spec(f"{shaper}\n{RT}[cam.loads]\nmass = 1\n")  # its speed is that of the crank
    assert spec.cam is not None
    assert spec.mechanism is not None
    (fault,) = faults_of(f"{shaper}\n{RT}stepp = 1\n")
    assert fault.path == "cam.stepp"


def test_what_belongs_to_a_machine_does_not_belong_to_a_cam(faults_of: Faults) -> None:
    (fault,) = faults_of(f'{RT}[flywheel]\ndelta = "1/25"\n')
    assert (fault.path, "without [mechanism] or [torque]" in fault.message) == ("flywheel", True)


KEYS = [
    "follower",
    "closure",
    "stroke",
    "rise",
    "high_dwell",
    "law",
    "rise_law",
    "start_distance",
    "base_radius",
    "offset",
    "roller_radius",
    "steps",
    "speed",
    "limits",
    "loads",
    "spring",
    "guide",
    "requirements",
    "optimum",
    "elastic",
]
INNER = [
    "law = {{ points = {} }}",
    "law = {{ points = [[0, 0], {}] }}",
    "law = {{ points = [[0, {}], [1, 1]] }}",
    "law = {{ acceleration = {} }}",
    "law = {{ polynomial = {} }}",
    "law = {{ file = {} }}",
    "loads = {{ mass = {} }}",
    "loads = {{ force_table = {} }}",
    "loads = {{ force_table = {{ phi = {}, force = [1, 2] }} }}",
    "loads = {{ force_table = {{ phi = [0, 1], force = {} }} }}",
    "loads = {{ force_table = {{ file = {} }} }}",
    "loads = {{ mass = 1, friction = {} }}",
    "spring = {{ method = {} }}",
    "spring = {{ wire = {}, coil = {} }}",
    "guide = {{ top = {} }}",
    "optimum = {{ laws = {}, heights = {} }}",
    "elastic = {{ stiffness = {}, mass = {} }}",
]


def check_places(text: str) -> None:
    """A spec is read, or refused with faults of the cam alone."""
    faults: list[Fault] = []
    try:
        parse_spec(text)
    except SpecError as error:
        faults = error.faults
    assert all(fault.path.startswith("cam") for fault in faults)
    assert all(fault.line for fault in faults)


@pytest.mark.parametrize("scene", [RT, RK, PT])
@sparing("key", KEYS, every=4)
def test_nothing_breaks_a_check(scene: str, key: str) -> None:
    lines = "".join(line for line in scene.splitlines(keepends=True) if not line.startswith(f"{key} = "))
    for value in HOSTILE:
        check_places(f"{lines}{key} = {value}\n")


@pytest.mark.parametrize("line", INNER)
def test_nothing_inside_breaks_a_check(line: str) -> None:
    for scene in (f"{BARE}{SPEED}", f"{RK.replace(LAW, '')}{SPEED}"):
        for value in HOSTILE:
            check_places(f"{scene}{line.format(*[value] * 2)}\n")


def test_words_are_those_of_the_cams() -> None:
    assert get_args(follower.FollowerKind) == FOLLOWERS
    assert get_args(follower.Closure) == CLOSURES
    assert set(get_args(get_type_hints(task.Spring)["method"])) == SPRING_KEYS.keys()


def test_a_knife_edge_is_a_number_without_quotes() -> None:
    with pytest.raises(SpecError) as refused:
        parse_spec(f'{RT}roller_radius = "0"\n')
    (fault,) = refused.value.faults
    assert "has no unit" in fault.message
    assert fault.remedy.startswith("write 0 without quotes")
    parse_spec(f"{RT}roller_radius = 0\n")
    parse_spec(f'{RT}roller_radius = "0 mm"\n')


@pytest.mark.parametrize("key", ["rise", "return_angle"])
def test_a_phase_that_moves_takes_a_part_of_the_turn(key: str) -> None:
    text = (CONFIGS / "cam-flat.toml").read_text("utf-8")
    changed = re.sub(rf'(?m)^{key} = "[^"]*"', f'{key} = "1e-6 deg"', text)
    check_fault(changed, f"cam.{key}", "is no phase of a cam; one that moves takes 0.001 deg", '"120 deg"')
