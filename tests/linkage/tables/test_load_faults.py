"""Every kind of fault in [[loads]]: its place, its line, its words."""

from __future__ import annotations

import pytest
from faults import HOSTILE, Faults, check_lines, check_only_fault
from project.scenes import CONFIGS
from sparing import sparing

from tmmcalc.project import parse_spec

LOAD = '[[loads]]\nlink = 5\npoint = "D"\n'
FORCE = LOAD + "force = 1500\n"
TABLE = LOAD + "[loads.table]\n"
INDICATOR = LOAD + "[loads.indicator]\n"


def cylinder(second: str) -> str:
    """The strokes of an indicator diagram with a sound first one."""
    return f'diameter = "80 mm"\nstrokes = [{{ x = [0, 1], p = ["5 MPa", "1 MPa"] }}, {second}]\n'


STROKES = cylinder("{ x = [1, 0], p = [1e5, 1e5] }").partition("\n")[2]

# what is added to the shaper; then the path, the message and the remedy of the one fault
FAULTS = [
    (
        '[[loads]]\nforce = 1\npoint = "D"\n',
        "loads[0].link",
        "missing key: every load acts on a link",
        "add link = 5",
    ),
    (
        '[[loads]]\nlink = 0\npoint = "B"\nforce = 1\n',
        "loads[0].link",
        "link 0 is the frame and does not move",
        "name a moving link",
    ),
    (
        '[[loads]]\nlink = 7\npoint = "D"\nforce = 1\n',
        "loads[0].link",
        "there is no link 7",
        "the links are: 0 (the frame), 1, 2, 3, 4, 5",
    ),
    (
        '[[loads]]\nlink = "5"\npoint = "D"\nforce = 1\n',
        "loads[0].link",
        "'5' is not a whole number",
        "write 5",
    ),
    (
        '[[loads]]\nlink = 5\npoint = "E"\nforce = 1\n',
        "loads[0].point",
        "link 5 has no point 'E'",
        "the points of link 5 are: D; or add E = [x, y] to the points of link 5",
    ),
    (
        '[[loads]]\nlink = 5\npoint = "S5"\nforce = 1\n',
        "loads[0].point",
        "link 5 has no point 'S5'",
        "the points are: D; a centre of mass needs the center of its link",
    ),
    (
        '[[loads]]\nlink = 5\npoint = "C"\nforce = 1\n',
        "loads[0].point",
        "link 5 has no point 'C'",
        "the points of link 5 are: D; or add C = [x, y] to the points of link 5",
    ),
    (
        "[[loads]]\nlink = 5\npoint = 5\nforce = 1\n",
        "loads[0].point",
        "5 is not a point",
        'write the name of a point, such as "B", or two coordinates [x, y]',
    ),
    (
        "[[loads]]\nlink = 5\npoint = [1]\nforce = 1\n",
        "loads[0].point",
        "[1] has 1 value; a point is two coordinates",
        'write [x, y], such as [0, "620 mm"]',
    ),
    (
        '[[loads]]\nlink = 5\npoint = ["1 kg", 0]\nforce = 1\n',
        "loads[0].point[0]",
        "'1 kg' is a mass, a length is needed",
        'write a number and its unit in quotes, such as "200 mm"',
    ),
    (
        FORCE + "axes = 9\n",
        "loads[0].axes",
        "there is no link 9",
        "the links are: 0 (the frame), 1, 2, 3, 4, 5",
    ),
    (
        FORCE + "axes = -1\n",
        "loads[0].axes",
        "-1 is less than 0, the least allowed",
        "write 0 or more",
    ),
    (
        FORCE + "against = 9\n",
        "loads[0].against",
        "there is no link 9",
        "the links are: 0 (the frame), 1, 2, 3, 4, 5",
    ),
    (
        FORCE + "against = 5\n",
        "loads[0].against",
        "a load on link 5 against the same link does nothing",
        "name the other link, or remove against: then the frame takes the opposite load",
    ),
    (
        FORCE + 'name = "1Q"\n',
        "loads[0].name",
        "'1Q' cannot name a load",
        "a name is a Latin letter, then letters, digits, _ or '",
    ),
    (
        FORCE + 'name = "Q"\n[[loads]]\nlink = 5\npoint = "D"\nforce = 1500\nname = "Q"\n',
        "loads[1].name",
        "'Q' is already the name of another load (line 110)",
        "give each load a name of its own",
    ),
    (
        FORCE + 'role = "both"\n',
        "loads[0].role",
        '\'both\' is not allowed here; the value is "resistance", "drive" or "neutral"',
        'write "resistance", "drive" or "neutral"',
    ),
    (
        FORCE + "factor = -1\n",
        "loads[0].factor",
        "-1 is out of range; a load factor is at least 0",
        "write a number, such as 1.2",
    ),
    (
        FORCE + 'factor = "two"\n',
        "loads[0].factor",
        "'two' is not a load factor",
        "write a number, such as 1.2; it has no quotes and no unit",
    ),
    (
        FORCE + 'factor = "1/0"\n',
        "loads[0].factor",
        "'1/0' is not a load factor",
        "write a number, such as 1.2; it has no quotes and no unit",
    ),
    (
        FORCE + "factor = nan\n",
        "loads[0].factor",
        "nan is not a finite number of ordinary size",
        "write a number, such as 1.2",
    ),
    (
        FORCE + "direction = 90\n",
        "loads[0].direction",
        "90 without a unit is in radians, more than a full turn",
        'write "90 deg" or "90 rad"',
    ),
    (
        FORCE + "forze = 1\n",
        "loads[0].forze",
        "unknown key 'forze' in [[loads]]",
        'did you mean "force"?',
    ),
    (
        "[loads]\nlink = 5\n",
        "loads",
        "a single table, where a list of tables is needed",
        "begin each with [[loads]], two brackets",
    ),
    (
        LOAD,
        "loads[0]",
        "missing key: a load has one law: force, moment, polynomial, viscous, quadratic, table or indicator",
        'add force = "1500 N", for example',
    ),
    (
        FORCE + 'moment = "40 N*m"\n',
        "loads[0].moment",
        "force and moment together: a load has one law",
        "write one [[loads]] for each",
    ),
    (
        LOAD + 'force = "40 N*m"\n',
        "loads[0].force",
        "'40 N*m' is a moment, a force is needed",
        'write a number and its unit in quotes, such as "1.5 kN"',
    ),
    (
        "[[loads]]\nlink = 5\nforce = 1\n",
        "loads[0]",
        "missing key: a force acts at a point of its link",
        'add point = "D"',
    ),
    (
        LOAD + 'moment = "40 N*m"\n',
        "loads[0].point",
        "a moment has no point",
        "remove it, or give a force",
    ),
    (
        '[[loads]]\nlink = 3\nmoment = 40\ndirection = "90 deg"\n',
        "loads[0].direction",
        "a moment has no direction",
        "remove it, or give a force",
    ),
    (
        "[[loads]]\nlink = 3\nmoment = 40\naxes = 2\n",
        "loads[0].axes",
        "a moment has no axes",
        "remove it, or give a force",
    ),
    (
        LOAD + 'viscous = "0.5 N*m*s/rad"\n',
        "loads[0].viscous",
        "'0.5 N*m*s/rad' is a torsional damping coefficient, but the load has a point, so it is a force",
        'write a damping coefficient, such as "20 N*s/m", or remove point',
    ),
    (
        LOAD + 'viscous = "0.5 N*m"\n',
        "loads[0].viscous",
        "'0.5 N*m' is a moment, a damping coefficient or a torsional damping coefficient is needed",
        'write a number and its unit in quotes, such as "20 N*s/m" or "0.5 N*m*s/rad"',
    ),
    (
        LOAD + "viscous = -20\n",
        "loads[0].viscous",
        "-20 is negative; a damping coefficient or a torsional damping coefficient is at least 0",
        "write it without the minus",
    ),
    (
        '[[loads]]\nlink = 5\nviscous = "20 N*s/m"\n',
        "loads[0]",
        "missing key: a force acts at a point of its link",
        'add point = "D"',
    ),
    (
        LOAD + 'quadratic = "0.5 N*m*s^2/rad^2"\n',
        "loads[0].quadratic",
        "'0.5 N*m*s^2/rad^2' is a torsional coefficient of quadratic resistance, but the load has a point, so it is a "
        "force",
        'write a coefficient of quadratic resistance, such as "3.5 N*s^2/m^2", or remove point',
    ),
    (
        LOAD + "quadratic = 3.5\nbetween = [0, 1]\n",
        "loads[0].between",
        "between together with quadratic: a resistance against the velocity acts all the time",
        "remove between",
    ),
    (
        LOAD + "polynomial = {}\n",
        "loads[0].polynomial",
        "missing key: force or moment",
        "write polynomial = { force = [0, 250, -12.5] }",
    ),
    (
        LOAD + "polynomial = { force = [1], moment = [1] }\n",
        "loads[0].polynomial",
        "force and moment together: a load is one of them",
        "write one [[loads]] for each",
    ),
    (
        LOAD + "polynomial = { force = [] }\n",
        "loads[0].polynomial.force",
        "[] has no values; a list of coefficients",
        "write force = [0, 250, -12.5]",
    ),
    (
        LOAD + "polynomial = { force = 5 }\n",
        "loads[0].polynomial.force",
        "5 is not a list of coefficients",
        "write force = [0, 250, -12.5]",
    ),
    (
        LOAD + 'polynomial = { force = [1, "2 N"] }\n',
        "loads[0].polynomial.force[1]",
        "'2 N' is not a coefficient",
        "write a number, such as 1.5; it has no quotes and no unit",
    ),
    (
        LOAD + "polynomial = [1, 2]\n",
        "loads[0].polynomial",
        "[1, 2] is not a table",
        "write polynomial = { force = [0, 250, -12.5] }",
    ),
    (
        LOAD + "polynomial = { moment = [1] }\n",
        "loads[0].point",
        "a moment has no point",
        "remove it, or give a force",
    ),
    (
        FORCE + 'stroke = "work"\n',
        "loads[0].stroke",
        '\'work\' is not allowed here; the value is "working" or "idle"',
        'write "working" or "idle"',
    ),
    (
        FORCE + 'stroke = "working"\nbetween = ["30 deg", "60 deg"]\n',
        "loads[0].between",
        "stroke and between together: a load acts in one window",
        "keep one of them, or write one [[loads]] for each",
    ),
    (
        FORCE + 'output = "D"\n',
        "loads[0].output",
        "output without stroke: it tells whose stroke is meant",
        "remove it",
    ),
    (
        FORCE + 'stroke = "idle"\noutput = "C"\n',
        "loads[0].output",
        "there is no output 'C'",
        "the outputs are: D",
    ),
    (
        FORCE + 'between = ["30 deg"]\n',
        "loads[0].between",
        "['30 deg'] has 1 value; two angles, from and to",
        'write between = ["30 deg", "180 deg"]',
    ),
    (
        FORCE + 'between = "30 deg"\n',
        "loads[0].between",
        "'30 deg' is not two angles, from and to",
        'write between = ["30 deg", "180 deg"]',
    ),
    (
        FORCE + 'between = ["30 deg", "30 deg"]\n',
        "loads[0].between",
        "['30 deg', '30 deg'] begins where it ends",
        "write from and to; remove between for always",
    ),
    (
        FORCE + 'between = ["30 deg", "400 deg"]\n',
        "loads[0].between[1]",
        "'400 deg' is beyond the cycle of the loads, 360 deg",
        "count from position 0",
    ),
    (
        FORCE + 'between = ["-30 deg", "60 deg"]\n',
        "loads[0].between[0]",
        "'-30 deg' is negative; an angle or a length is at least 0",
        "write it without the minus",
    ),
    (
        FORCE + 'between = ["30 mm", "60 deg"]\n',
        "loads[0].between[0]",
        "'30 mm' is a length; the input joint \"O\" is revolute, so an angle is needed",
        'write an angle, such as "30 deg"',
    ),
    (
        FORCE + "positions = [2, 25]\n",
        "loads[0].positions[1]",
        "there is no position 25",
        "the positions are 0 to 24 ([mechanism.grid])",
    ),
    (
        FORCE + "positions = [2, 2]\n",
        "loads[0].positions",
        "[2, 2] begins where it ends",
        "write from and to; remove positions for always",
    ),
    (
        FORCE + 'positions = ["2", "6\'"]\n',
        "loads[0].positions[1]",
        "there is no position 6': the grid has no added positions",
        "add extra = [...] or extremes = true to [mechanism.grid]",
    ),
    (
        FORCE + 'positions = [2, "b"]\n',
        "loads[0].positions[1]",
        "'b' is not a position",
        'write its number, such as 6, or its label: "6\'"',
    ),
    (
        FORCE + "positions = [-2, 3]\n",
        "loads[0].positions[0]",
        "-2 is not a position",
        'write its number, such as 6, or its label: "6\'"',
    ),
    (
        FORCE + "positions = [2.0, 3]\n",
        "loads[0].positions[0]",
        "2.0 is not a position",
        'write its number, such as 6, or its label: "6\'"',
    ),
    (
        FORCE + "positions = [2]\n",
        "loads[0].positions",
        "[2] has 1 value; two positions, from and to",
        "write positions = [2, 12]",
    ),
    (
        TABLE,
        "loads[0].table",
        "missing key: a table of a load has its values",
        'add force = [0, "1.5 kN", 0], moment = [...], or file = "q.csv"',
    ),
    (
        TABLE + "force = [1]\n",
        "loads[0].table.force",
        "[1] has 1 value; a list of two forces or more",
        'write force = [0, "1.5 kN", 0]',
    ),
    (
        TABLE + "force = 5\n",
        "loads[0].table.force",
        "5 is not a list of two forces or more",
        'write force = [0, "1.5 kN", 0]',
    ),
    (
        TABLE + "force = [1, 2]\nmoment = [1, 2]\n",
        "loads[0].table.moment",
        "force and moment together: a load is one of them",
        "write one [[loads]] for each",
    ),
    (
        TABLE + "moment = [1, 2]\n",
        "loads[0].point",
        "a moment has no point",
        "remove it, or give a force",
    ),
    (
        TABLE + "of = 'crank'\nforce = [1, 2]\n",
        "loads[0].table.of",
        '\'crank\' is not allowed here; the value is "angle", "position", "displacement" or "stroke"',
        'write "angle", "position", "displacement" or "stroke"',
    ),
    (
        TABLE + 'x = ["0 deg", "90 deg"]\nforce = [1, 2, 3]\n',
        "loads[0].table.force",
        "3 values for 2 abscissae x",
        "write one value for each abscissa",
    ),
    (
        TABLE + 'x = ["0 deg", "90 deg", "90 deg", "90 deg"]\nforce = [1, 2, 3, 4]\n',
        "loads[0].table.x[3]",
        "'90 deg' does not come after '90 deg'; at most two values at one angle, a jump",
        "put the values in order",
    ),
    (
        TABLE + 'interpolation = "pchip"\nx = ["0 deg", "90 deg", "90 deg"]\nforce = [1, 2, 3]\n',
        "loads[0].table.x[2]",
        "'90 deg' does not come after '90 deg'; x ascends",
        "put the values in order; a jump is two loads, each between its own angles",
    ),
    (
        TABLE + "x = [0, 90, 180]\nforce = [1, 2, 3]\n",
        "loads[0].table.x[2]",
        "180 without a unit is in radians, more than the cycle of the loads",
        'write "180 deg"',
    ),
    (
        TABLE + 'x = ["0 deg", "90 deg", "365 deg"]\nforce = [1, 2, 3]\n',
        "loads[0].table.x[2]",
        "'365 deg' is beyond the cycle of the loads, 360 deg",
        "count from position 0",
    ),
    (
        TABLE + 'x = ["0 deg", "90 mm", "180 deg"]\nforce = [1, 2, 3]\n',
        "loads[0].table.x[1]",
        "'90 mm' is a length; the input joint \"O\" is revolute, so an angle is needed",
        'write an angle, such as "30 deg"',
    ),
    (
        TABLE + 'x = ["0 deg", "90 N", "180 deg"]\nforce = [1, 2, 3]\n',
        "loads[0].table.x[1]",
        "'90 N' is a force, an angle or a length is needed",
        'write a number and its unit in quotes, such as "30 deg" or "200 mm"',
    ),
    (
        TABLE + 'x = ["-10 deg", "90 deg"]\nforce = [1, 2]\n',
        "loads[0].table.x[0]",
        "'-10 deg' is negative; an angle or a length is at least 0",
        "write it without the minus",
    ),
    (
        TABLE + 'x = "0 deg"\nforce = [1, 2]\n',
        "loads[0].table.x",
        "'0 deg' is not a list of two abscissae or more",
        'write x = ["0 deg", "90 deg", "270 deg"]',
    ),
    (
        TABLE + "force = [0" + 24 * ", 0" + "]\n",
        "loads[0].table.force",
        "25 values are 25 equal steps over the period, but the last repeats the first as at the 25 positions 0 to 24",
        'write of = "position", or leave the last value out',
    ),
    (
        TABLE + 'of = "position"\nforce = [0' + 25 * ", 0" + "]\n",
        "loads[0].table.force",
        "26 values for 25 positions (0 to 24)",
        "write one value for each position, or add x",
    ),
    (
        TABLE + 'of = "position"\nx = [0, 1.5]\nforce = [1, 2]\n',
        "loads[0].table.x[1]",
        "there is no position 1.5",
        "the positions are 0 to 24 ([mechanism.grid])",
    ),
    (
        TABLE + 'of = "position"\nx = [0, 30]\nforce = [1, 2]\n',
        "loads[0].table.x[1]",
        "there is no position 30",
        "the positions are 0 to 24 ([mechanism.grid])",
    ),
    (
        TABLE + 'of = "position"\nx = [0, "30 deg"]\nforce = [1, 2]\n',
        "loads[0].table.x[1]",
        "'30 deg' has a unit; x are numbers of positions",
        "write a number without unit",
    ),
    (
        TABLE + 'of = "stroke"\nx = [0, 1.5]\nforce = [1, 2]\n',
        "loads[0].table.x[1]",
        "1.5 is more than 1, the whole stroke",
        'write parts of the stroke from 0 to 1, or of = "displacement"',
    ),
    (
        TABLE + 'of = "stroke"\nx = [0, "15 mm"]\nforce = [1, 2]\n',
        "loads[0].table.x[1]",
        "'15 mm' has a unit; x are parts of the stroke, from 0 to 1",
        "write a number without unit",
    ),
    (
        TABLE + 'of = "displacement"\nforce = [1, 2]\n',
        "loads[0].table",
        "missing key: a table of displacements has its x",
        'add x = ["0 mm", "50 mm", "200 mm"]',
    ),
    (
        TABLE + 'of = "displacement"\nx = [0, "15 deg"]\nforce = [1, 2]\n',
        "loads[0].table.x[1]",
        "'15 deg' is an angle; the displacement of the output is a length",
        'write a length, such as "200 mm"',
    ),
    (
        TABLE + 'of = "displacement"\noutput = "E"\nx = [0, "15 mm"]\nforce = [1, 2]\n',
        "loads[0].table.output",
        "there is no output 'E'",
        "the outputs are: D",
    ),
    (
        TABLE + 'output = "D"\nforce = [1, 2]\n',
        "loads[0].table.output",
        "output in a table of angle: only a displacement or stroke is that of an output",
        'remove it, or write of = "displacement"',
    ),
    (
        TABLE + 'of = "stroke"\nperiod = "360 deg"\nforce = [1, 2]\n',
        "loads[0].table.period",
        "period in a table of stroke: only crank angles repeat",
        "remove it",
    ),
    (
        TABLE + 'period = "500 deg"\nforce = [1, 2]\n',
        "loads[0].table.period",
        "'500 deg' is neither a whole number of turns nor a whole part of a turn",
        'write "360 deg", "720 deg" for a four-stroke engine, or "180 deg"',
    ),
    (
        TABLE + 'of = "position"\nperiod = "180 deg"\nforce = [1, 2]\n',
        "loads[0].table.period",
        "'180 deg' is not a whole number of turns",
        'write "720 deg" for a four-stroke engine',
    ),
    (
        TABLE + 'of = "position"\nperiod = "720 deg"\nforce = [' + "0, " * 49 + "1]\n",
        "loads[0].table.force",
        "50 values for 49 positions (0 to 48)",
        "write one value for each position, or add x",
    ),
    (
        TABLE + 'period = "7200 deg"\nforce = [1, 2]\n',
        "loads[0].table.period",
        "'7200 deg' are 20 turns; a cycle has up to 12",
        'write "720 deg" for a four-stroke engine',
    ),
    (
        FORCE + 'between = ["30 deg", "60 deg"]\nperiod = "540 deg"\n',
        "loads[0].period",
        "'540 deg' is not a whole number of turns",
        'write "720 deg" for a four-stroke engine',
    ),
    (
        FORCE + 'period = "720 deg"\n',
        "loads[0].period",
        "period without a window: a constant load has none",
        "add between = [...], or remove period",
    ),
    (
        FORCE + 'stroke = "working"\nperiod = "720 deg"\n',
        "loads[0].period",
        "period together with stroke: every stroke comes back each turn",
        'name the angles of the one that is meant: between = ["360 deg", "540 deg"]',
    ),
    (
        LOAD + 'period = "720 deg"\nviscous = 3\n',
        "loads[0].period",
        "period together with viscous: a resistance against the velocity acts all the time",
        "remove it",
    ),
    (
        LOAD + 'period = "720 deg"\n[loads.table]\nforce = [1, 2]\n',
        "loads[0].period",
        "period beside table: the table tells when the load repeats",
        "write it there, [loads.table]",
    ),
    (
        FORCE + 'positions = [40, 50]\nperiod = "720 deg"\n',
        "loads[0].positions[1]",
        "there is no position 50",
        "the positions are 0 to 48 ([mechanism.grid])",
    ),
    (
        TABLE + 'period = "0 deg"\nforce = [1, 2]\n',
        "loads[0].table.period",
        "'0 deg' is zero; an angle other than 0 is needed here",
        'write "30 deg", for example',
    ),
    (
        TABLE + "period = 720\nforce = [1, 2]\n",
        "loads[0].table.period",
        "720 without a unit is in radians, more than a full turn",
        'write "720 deg" or "720 rad"',
    ),
    (
        TABLE + 'file = "q.csv"\nforce = [1, 2]\n',
        "loads[0].table.file",
        "file together with force: the file holds all values",
        "remove file, or remove force",
    ),
    (
        TABLE + 'file = "none.csv"\n',
        "loads[0].table.file",
        "there is no file 'none.csv'",
        "its path counts from the folder of the spec",
    ),
    (
        TABLE + "file = 5\n",
        "loads[0].table.file",
        "5 is not a text",
        "write a text in quotes",
    ),
    (
        TABLE + 'interpolation = "cubic"\nforce = [1, 2]\n',
        "loads[0].table.interpolation",
        '\'cubic\' is not allowed here; the value is "linear" or "pchip"',
        'write "linear" or "pchip"',
    ),
    (
        LOAD + "table = 5\n",
        "loads[0].table",
        "5 is not a table",
        "write a table: [loads.table], then its keys",
    ),
    (
        INDICATOR + STROKES,
        "loads[0].indicator",
        "missing key: an indicator diagram needs the size of its piston",
        'add diameter = "80 mm"',
    ),
    (
        INDICATOR + 'diameter = "80 mm"\narea = 0.005\n' + STROKES,
        "loads[0].indicator.area",
        "diameter and area together: the piston is measured once",
        "remove one of them",
    ),
    (
        INDICATOR + "diameter = 0\n" + STROKES,
        "loads[0].indicator.diameter",
        "0 is zero; a length other than 0 is needed here",
        'write "200 mm", for example',
    ),
    (
        INDICATOR + 'diameter = "80 mm"\nstrokes = []\n',
        "loads[0].indicator.strokes",
        "0 strokes: the cycle of a cylinder has two or four",
        "write one { x = [...], p = [...] } for each stroke of the cycle",
    ),
    (
        INDICATOR + 'diameter = "80 mm"\nstrokes = [{ x = [0, 1], p = ["5 MPa", "1 MPa"] }]\n',
        "loads[0].indicator.strokes",
        "1 stroke: the cycle of a cylinder has two or four",
        "write one { x = [...], p = [...] } for each stroke of the cycle",
    ),
    (
        INDICATOR + cylinder("{ x = [1, 0.5, 0], p = [1e5, 1e5] }"),
        "loads[0].indicator.strokes[1].p",
        "2 pressures for 3 distances x",
        "write one pressure for each distance",
    ),
    (
        INDICATOR + cylinder("{ x = [1, 0.2], p = [1e5, 1e5] }"),
        "loads[0].indicator.strokes[1].x",
        "[1, 0.2] does not run over the whole stroke",
        "write distances from 0 (the closed end) to 1, or from 1 to 0",
    ),
    (
        INDICATOR + cylinder("{ x = [1, 0.2, 0.4, 0], p = [1, 2, 3, 4] }"),
        "loads[0].indicator.strokes[1].x[2]",
        "0.4 after 0.2: the distances run one way",
        "put them in order",
    ),
    (
        INDICATOR + cylinder("{ x = [1.2, 0], p = [1e5, 1e5] }"),
        "loads[0].indicator.strokes[1].x[0]",
        "1.2 is out of range; a part of the stroke is at least 0 and at most 1",
        "write a number, such as 0.1",
    ),
    (
        INDICATOR + cylinder("{ x = 1, p = [1e5, 1e5] }"),
        "loads[0].indicator.strokes[1].x",
        "1 is not a list of two distances or more, from 0 to 1",
        "write x = [0, 0.1, 0.5, 1]",
    ),
    (
        INDICATOR + cylinder("{ p = [1e5, 1e5] }"),
        "loads[0].indicator.strokes[1].x",
        "missing key: every stroke has its distances from 0 to 1",
        "add x = [0, 0.5, 1]",
    ),
    (
        INDICATOR + cylinder("{ x = [1, 0] }"),
        "loads[0].indicator.strokes[1].p",
        "missing key: every stroke has its pressures",
        'add p = ["5 MPa", "1 MPa", "0.3 MPa"]',
    ),
    (
        INDICATOR + cylinder("{ x = [1, 0], p = [-1e5, 1e5] }"),
        "loads[0].indicator.strokes[1].p[0]",
        "-100000.0 is negative; a pressure is at least 0",
        "write it without the minus",
    ),
    (
        INDICATOR + cylinder("5"),
        "loads[0].indicator.strokes[1]",
        "5 is not a table",
        'write strokes = [{ x = [0, 1], p = ["5 MPa", "0.3 MPa"] }, ...]',
    ),
    (
        INDICATOR + 'diameter = "80 mm"\nback_pressure = "5 N"\n' + STROKES,
        "loads[0].indicator.back_pressure",
        "'5 N' is a force, a pressure is needed",
        'write a number and its unit in quotes, such as "600 MPa"',
    ),
    (
        INDICATOR + 'diameter = "80 mm"\ndelay = "-5 deg"\n' + STROKES,
        "loads[0].indicator.delay",
        "'-5 deg' is negative; an angle is at least 0",
        "write it without the minus",
    ),
    (
        LOAD + 'axes = 3\n[loads.indicator]\ndiameter = "80 mm"\n' + STROKES,
        "loads[0].axes",
        "an indicator diagram belongs to a cylinder in the frame; its direction does not turn with a link",
        "remove axes; the direction points from the closed end to the crank",
    ),
]


@pytest.mark.parametrize(("added", "path", "message", "remedy"), FAULTS)
def test_one_slip_is_one_fault_at_its_line(
    shaper: str, faults_of: Faults, added: str, path: str, message: str, remedy: str
) -> None:
    text = f"{shaper}\n{added}"
    check_only_fault(text, faults_of(text), path, message, remedy)


def test_bare_degrees(shaper: str, faults_of: Faults) -> None:
    found = faults_of(f"{shaper}\n{FORCE}between = [30, 60]\n")
    assert [fault.path for fault in found] == ["loads[0].between[0]", "loads[0].between[1]"]
    assert [fault.remedy for fault in found] == ['write "30 deg"', 'write "60 deg"']


def test_all_faults_of_all_loads_come_together(shaper: str, faults_of: Faults) -> None:
    text = f"{shaper}\n{FORCE}factor = -1\naxes = 9\n\n{TABLE}x = [0, 1]\nforce = [1, 2, 3]\nof = 5\n"
    assert [fault.path for fault in faults_of(text)] == [
        "loads[0].factor",
        "loads[0].axes",
        "loads[1].table.force",
        "loads[1].table.of",
    ]


def test_a_fault_names_its_load(shaper: str, faults_of: Faults) -> None:
    (fault,) = faults_of(f'{shaper}\n{FORCE}name = "cut"\nfactor = -1\n')
    assert fault.message == '-1 is out of range; a load factor is at least 0 (load "cut")'


@pytest.mark.parametrize(
    "added",
    [
        FORCE,
        FORCE + 'between = ["300 deg", "60 deg"]\n',
        FORCE + "between = [0, 6.28]\n",
        FORCE + 'positions = ["22", 2]\n',
        FORCE + 'positions = [40, 48]\nperiod = "720 deg"\n',
        FORCE + 'between = ["490 deg", "540 deg"]\nperiod = "720 deg"\n',
        LOAD + 'period = "720 deg"\npolynomial = { force = [0, 1] }\n',
        TABLE + 'of = "position"\nperiod = "720 deg"\nforce = [' + "0, " * 48 + "0]\n",
        LOAD + 'viscous = "20 N*s/m"\n',
        LOAD + "quadratic = 0\n",
        "[[loads]]\nlink = 3\nviscous = 20\nagainst = 1\n",
        '[[loads]]\nlink = 3\nmoment = "-40 N*m"\nstroke = "idle"\n',
        TABLE + "force = [" + "0, " * 24 + "1]\n",
        TABLE + 'of = "position"\nforce = [' + "0, " * 24 + "0]\n",
        TABLE + 'x = ["30 deg", "390 deg"]\nforce = [0, 1]\n',
        TABLE + 'period = "720 deg"\nx = [0, 12.5]\nforce = [0, 1]\n',
        TABLE + 'period = "180 deg"\nforce = [0, 1]\n',
        TABLE + 'of = "displacement"\nx = ["0 mm", 0.5]\nforce = [0, 1]\n',
    ],
)
def test_what_is_allowed(shaper: str, added: str) -> None:
    assert len(parse_spec(f"{shaper}\n{added}").loads) == 1


def test_the_cycle_of_a_four_stroke_engine_has_two_turns(shaper: str, faults_of: Faults) -> None:
    window = FORCE + 'between = ["400 deg", "700 deg"]\n'
    assert len(faults_of(f"{shaper}\n{window}")) == 2
    four = INDICATOR + cylinder(", ".join(["{ x = [1, 0], p = [1, 1] }"] * 3))
    assert len(parse_spec(f"{shaper}\n{window}\n{four}").loads) == 2
    table = TABLE + 'period = "720 deg"\nforce = [0, 1]\n'
    assert len(parse_spec(f"{shaper}\n{window}\n{table}").loads) == 2


def test_added_positions_have_labels(shaper: str) -> None:
    text = shaper.replace("positions = 24", "positions = 24\nextremes = true")
    spec = parse_spec(f'{text}\n{FORCE}positions = ["14\'", 20]\n')
    assert spec.loads[0].positions == ["14'", "20"]


def test_a_grid_of_strokes_has_its_own_positions(shaper: str, faults_of: Faults) -> None:
    text = shaper.replace("positions = 24", "working = 6\nidle = 4")
    (fault,) = faults_of(f"{text}\n{FORCE}positions = [2, 11]\n")
    assert (fault.path, fault.remedy) == ("loads[0].positions[1]", "the positions are 0 to 10 ([mechanism.grid])")


def test_the_displacement_of_an_angle_is_an_angle(shaper: str, faults_of: Faults) -> None:
    text = f"{shaper}\n[[mechanism.outputs]]\nlink = 3\n\n{TABLE}"
    table = 'of = "displacement"\noutput = "3"\nforce = [0, 1]\n'
    assert parse_spec(f'{text}{table}x = [0, "5 deg"]\n').loads[0].table
    (fault,) = faults_of(f'{text}{table}x = [0, "5 mm"]\n')
    assert fault.message == "'5 mm' is a length; the displacement of the output is an angle"


def test_outputs_that_are_not_listed(shaper: str, faults_of: Faults) -> None:
    text = shaper.replace('[[mechanism.outputs]]\npoint = "D"\ndirection = "0 deg"', "")
    (fault,) = faults_of(f'{text}\n{FORCE}stroke = "idle"\noutput = "D"\n')
    assert (fault.message, fault.remedy) == ("there is no output 'D'", "add it: [[mechanism.outputs]]")
    assert parse_spec(f'{text}\n{FORCE}stroke = "idle"\n').loads[0].stroke == "idle"


LIFT = '[[loads]]\nlink = 4\npoint = "S4"\n'


@pytest.mark.parametrize(
    ("added", "path", "message"),
    [
        (
            'force = 1\nbetween = ["30 deg", "60 mm"]\n',
            "loads[0].between[0]",
            "'30 deg' is an angle; the input joint \"A0\" is prismatic, so a length is needed",
        ),
        (
            'force = 1\nbetween = ["60 mm", "20 mm"]\n',
            "loads[0].between",
            "['60 mm', '20 mm'] runs backwards: a driven slider passes each place once",
        ),
        (
            "[loads.table]\nforce = [1, 2]\n",
            "loads[0].table",
            "missing key: a table of distances of the driven slider has its x",
        ),
        (
            '[loads.table]\nx = ["0 deg", "9 deg"]\nforce = [1, 2]\n',
            "loads[0].table.x[1]",
            "'9 deg' is an angle; the input joint \"A0\" is prismatic, so a length is needed",
        ),
        (
            '[loads.table]\nx = [0, 1]\nperiod = "360 deg"\nforce = [1, 2]\n',
            "loads[0].table.period",
            "period in a table with a driven slider: only crank angles repeat",
        ),
        (
            "[loads.indicator]\n" + 'diameter = "80 mm"\n' + STROKES,
            "loads[0].indicator",
            "an indicator diagram with a driven slider: its strokes follow a crank",
        ),
    ],
)
def test_loads_of_a_driven_slider(faults_of: Faults, added: str, path: str, message: str) -> None:
    text = (CONFIGS / "hydraulic-lift.toml").read_text(encoding="utf-8")
    assert (path, message) in [(fault.path, fault.message) for fault in faults_of(f"{text}\n{LIFT}{added}")]


def test_a_driven_slider_counts_lengths() -> None:
    text = (CONFIGS / "hydraulic-lift.toml").read_text(encoding="utf-8")
    load = parse_spec(f'{text}\n{LIFT}force = 1\nbetween = ["20 mm", "60 mm"]\n').loads[0]
    assert load.between == [0.02, 0.06]
    table = parse_spec(f"{text}\n{LIFT}[loads.table]\nx = [0, 10]\nforce = [0, 1]\n").loads[0].table
    assert table is not None
    assert table.x == [0.0, 10.0]


KEYS = {
    "": "name link point direction axes against role factor force moment polynomial viscous quadratic table indicator "
    "stroke output between positions",
    "polynomial": "force moment",
    "table": "of x force moment file interpolation output period",
    "indicator": "diameter area back_pressure delay strokes",
}


@sparing(("table", "key"), [(table, key) for table, keys in KEYS.items() for key in keys.split()], every=6)
def test_no_value_breaks_the_checks(shaper: str, table: str, key: str) -> None:
    head = f"{LOAD}[loads.{table}]\n" if table else "[[loads]]\n" if key in LOAD else LOAD
    for value in HOSTILE:
        check_lines(f"{shaper}\n{head}{key} = {value}\n")


def test_no_list_of_loads_breaks_the_checks(faults_of: Faults) -> None:
    for value in HOSTILE:
        assert faults_of(f"mechanism = 5\nloads = {value}\n")
        assert faults_of(f"mechanism = 5\nloads = [{value}]\n")
        assert faults_of(f"mechanism = 5\n[[loads]]\n[loads.indicator]\nstrokes = [{value}]\n")
