"""Every kind of fault in the tables of springs and of the machine: its place, its line, its words."""

from __future__ import annotations

from pathlib import Path

import pytest
from faults import HOSTILE, Faults, check_fault, check_lines, check_only_fault
from project.scenes import CONFIGS
from sparing import sparing

from tmmcalc.project import parse_spec

SPRING = '[[springs]]\nlinks = [5, 0]\npoints = ["D", "O"]\n'
TORSION = '[[springs]]\nkind = "torsion"\nlinks = [3, 4]\n'
GEAR = '[drive]\nkind = "gear"\n'
BARE = '[motor]\npower = "7.5 kW"\nspeed = "1455 rpm"\n'
MOTOR = BARE + 'synchronous_speed = "1500 rpm"\n'
POINTS = BARE + 'characteristic = "table"\n'
CHARACTERISTICS = '"parabolic", "linear", "kloss", "shunt", "series", "table" or "constant"'

# what is added to the shaper; then the path, the message and the remedy of the one fault
FAULTS = [
    (
        '[[springs]]\npoints = ["D", "O"]\nstiffness = 1\nfree_length = 0\n',
        "springs[0].links",
        "missing key: every spring connects two links",
        "add links = [2, 0]; 0 is the frame",
    ),
    (
        SPRING,
        "springs[0]",
        "missing key: stiffness or damping",
        'add stiffness = "30 N/mm"',
    ),
    (
        SPRING + 'stiffness = "30 N/mm"\n',
        "springs[0]",
        "missing key: a spring needs its length without load",
        'add free_length = "200 mm"',
    ),
    (
        SPRING + 'stiffness = "30 N*m/rad"\nfree_length = "0.2 m"\n',
        "springs[0].stiffness",
        "'30 N*m/rad' is a torsional stiffness; a linear spring has a stiffness",
        'write a stiffness, such as "30 N/mm"',
    ),
    (
        SPRING + 'damping = "30 N*m*s/rad"\n',
        "springs[0].damping",
        "'30 N*m*s/rad' is a torsional damping coefficient; a linear spring has a damping coefficient",
        'write a damping coefficient, such as "20 N*s/m"',
    ),
    (
        SPRING + "damping = 5\nfree_angle = 1\n",
        "springs[0].free_angle",
        "a linear spring has no free_angle",
        'remove it, or write kind = "torsion"',
    ),
    (
        SPRING + "damping = -5\n",
        "springs[0].damping",
        "-5 is negative; a damping coefficient or a torsional damping coefficient is at least 0",
        "write it without the minus",
    ),
    (
        '[[springs]]\nlinks = [5, 5]\npoints = ["D", "O"]\ndamping = 5\n',
        "springs[0].links",
        "[5, 5] is one link twice; a spring joins two different links",
        "the links are: 0 (the frame), 1, 2, 3, 4, 5",
    ),
    (
        '[[springs]]\nlinks = [5, 8]\npoints = ["D", "O"]\ndamping = 5\n',
        "springs[0].links[1]",
        "there is no link 8",
        "the links are: 0 (the frame), 1, 2, 3, 4, 5",
    ),
    (
        '[[springs]]\nlinks = [5]\npoints = ["D", "O"]\ndamping = 5\n',
        "springs[0].links",
        "[5] has 1 value; two link numbers",
        "write links = [2, 0]",
    ),
    (
        '[[springs]]\nlinks = [5, 0]\npoints = ["D", "C"]\ndamping = 5\n',
        "springs[0].points[1]",
        "the frame has no point 'C'",
        "the points of the frame are: O, B; or add C = [x, y] to [mechanism.fixed]",
    ),
    (
        '[[springs]]\nlinks = [5, 0]\npoints = ["D", 5]\ndamping = 5\n',
        "springs[0].points[1]",
        "5 is not a point",
        'write the name of a point, such as "B", or two coordinates [x, y]',
    ),
    (
        '[[springs]]\nlinks = [5, 0]\npoints = ["D", [1]]\ndamping = 5\n',
        "springs[0].points[1]",
        "[1] has 1 value; a point is two coordinates",
        'write [x, y], such as [0, "620 mm"]',
    ),
    (
        '[[springs]]\nlinks = [5, 0]\npoints = ["D"]\ndamping = 5\n',
        "springs[0].points",
        "['D'] has 1 value; the ends of the spring on the two links",
        'write points = ["B", [0.1, 0.2]]',
    ),
    (
        '[[springs]]\nlinks = [5, 0]\npoints = "D"\ndamping = 5\n',
        "springs[0].points",
        "'D' is not the ends of the spring on the two links",
        'write points = ["B", [0.1, 0.2]]',
    ),
    (
        "[[springs]]\nlinks = [5, 0]\ndamping = 5\n",
        "springs[0]",
        "missing key: a linear spring has an end on each link",
        'add points = ["B", [0.1, 0.2]]',
    ),
    (
        SPRING + 'damping = 5\nname = "a b"\n',
        "springs[0].name",
        "'a b' cannot name a spring",
        "a name is a Latin letter, then letters, digits, _ or '",
    ),
    (
        2 * (SPRING + 'damping = 5\nname = "T"\n'),
        "springs[1].name",
        "'T' is already the name of another spring (line 110)",
        "give each spring a name of its own",
    ),
    (
        SPRING + 'damping = 5\nkind = "air"\n',
        "springs[0].kind",
        '\'air\' is not allowed here; the value is "linear" or "torsion"',
        'write "linear" or "torsion"',
    ),
    (
        TORSION + "stiffness = 100\n",
        "springs[0]",
        "missing key: a spring needs its angle without load",
        'add free_angle = "30 deg"',
    ),
    (
        TORSION + 'points = ["C", "C"]\ndamping = 1\n',
        "springs[0].points",
        "a torsion spring has no points",
        'remove it, or write kind = "linear"',
    ),
    (
        TORSION + "free_length = 1\ndamping = 1\n",
        "springs[0].free_length",
        "a torsion spring has no free_length",
        'remove it, or write kind = "linear"',
    ),
    (
        TORSION + 'damping = "5 N*s/m"\n',
        "springs[0].damping",
        "'5 N*s/m' is a damping coefficient; a torsion spring has a torsional damping coefficient",
        'write a torsional damping coefficient, such as "0.5 N*m*s/rad"',
    ),
    (
        TORSION,
        "springs[0]",
        "missing key: stiffness or damping",
        'add stiffness = "5000 N*m/rad"',
    ),
    (
        "[drive]\nradius = 0.1\n",
        "drive.radius",
        "a coupling has no radius",
        'remove it, or write kind = "gear"',
    ),
    (
        '[drive]\nkind = "belt"\n',
        "drive.kind",
        '\'belt\' is not allowed here; the value is "coupling" or "gear"',
        'write "coupling" or "gear"',
    ),
    (
        GEAR + 'pinion = "90 deg"\n',
        "drive.radius",
        "missing key: a gear has its pitch radius",
        'add radius = "150 mm", or [open_pair]',
    ),
    (
        GEAR + 'radius = "150 mm"\n',
        "drive.pinion",
        "missing key: the mesh force depends on where the pinion is",
        'add pinion = "90 deg", the direction from the pivot to its centre',
    ),
    (
        GEAR + 'radius = "150 mm"\npinion = "90 deg"\nmesh_angle = "50 deg"\n',
        "drive.mesh_angle",
        "'50 deg' is not a pressure angle; it is above 0 and below 45 deg",
        'write "20 deg", for example',
    ),
    (
        GEAR + 'radius = 0\npinion = "90 deg"\n',
        "drive.radius",
        "0 is zero; a length other than 0 is needed here",
        'write "200 mm", for example',
    ),
    (
        GEAR + "radius = 1\npinion = 90\n",
        "drive.pinion",
        "90 without a unit is in radians, more than a full turn",
        'write "90 deg" or "90 rad"',
    ),
    (
        GEAR + "radius = 1\npinion = 0\ninternal = 1\n",
        "drive.internal",
        "1 is neither true nor false",
        "write true or false, without quotes",
    ),
    (
        "[motor]\n",
        "motor",
        "missing key: a motor has a name in the catalogue, or its data",
        'add name = "4A132S4", or power = "7.5 kW" and speed = "1455 rpm"',
    ),
    (
        "[motor]\ninertia = 1\n",
        "motor",
        "missing key: a motor has a name in the catalogue, or its data",
        'add name = "4A132S4", or power = "7.5 kW" and speed = "1455 rpm"',
    ),
    (
        BARE,
        "motor.synchronous_speed",
        "missing key: a parabolic characteristic needs synchronous_speed",
        'add synchronous_speed = "1500 rpm"',
    ),
    (
        BARE + 'no_load_speed = "1500 rpm"\n',
        "motor.no_load_speed",
        "an induction motor has no no_load_speed",
        'write synchronous_speed, or kind = "shunt"',
    ),
    (
        BARE + 'characteristic = "constant"\nvoltage = "220 V"\n',
        "motor.voltage",
        "an induction motor has no voltage",
        'remove it, or write kind = "shunt" or kind = "series"',
    ),
    (
        MOTOR + 'characteristic = "kloss"\n',
        "motor.overload",
        "missing key: a kloss characteristic needs overload",
        "add overload = 2.2",
    ),
    (
        MOTOR + 'characteristic = "shunt"\n',
        "motor.characteristic",
        "'shunt' is a characteristic of a shunt motor, not of an induction one",
        'write "parabolic", or kind = "shunt"',
    ),
    (
        MOTOR + 'characteristic = "cubic"\n',
        "motor.characteristic",
        "'cubic' is not allowed here; the value is " + CHARACTERISTICS,
        "write " + CHARACTERISTICS,
    ),
    (
        MOTOR + 'characteristic = "table"\n',
        "motor.table",
        "missing key: a table characteristic needs table",
        'add table = { speed = ["0 rpm", "1500 rpm"], moment = ["15 N*m", 0] }',
    ),
    (
        MOTOR + 'kind = "shunt"\n',
        "motor.synchronous_speed",
        "a shunt motor has no synchronous_speed",
        'write no_load_speed, or kind = "induction"',
    ),
    (
        MOTOR + 'kind = "series"\nefficiency = 0.9\n',
        "motor.synchronous_speed",
        "a series motor has no synchronous_speed",
        'remove it, or write kind = "induction"',
    ),
    (
        MOTOR + 'kind = "stepper"\n',
        "motor.kind",
        '\'stepper\' is not allowed here; the value is "induction", "shunt" or "series"',
        'write "induction", "shunt" or "series"',
    ),
    (
        BARE + 'kind = "shunt"\n',
        "motor.no_load_speed",
        "missing key: a shunt characteristic needs no_load_speed",
        'add no_load_speed = "1600 rpm"',
    ),
    (
        BARE + 'kind = "shunt"\nvoltage = "220 V"\nconstant = 1.4\n',
        "motor.resistance",
        "missing key: a shunt characteristic needs resistance",
        'add resistance = "0.5 ohm"',
    ),
    (
        BARE + 'kind = "shunt"\nno_load_speed = "1400 rpm"\n',
        "motor.speed",
        "the rated speed '1455 rpm' is not below no_load_speed '1400 rpm'",
        'a motor slips under load: such as speed = "1455 rpm" below synchronous_speed = "1500 rpm"',
    ),
    (
        BARE + 'kind = "series"\n',
        "motor.efficiency",
        "missing key: a series characteristic needs efficiency",
        "add efficiency = 0.88",
    ),
    (
        BARE + 'kind = "series"\nvoltage = "220 V"\n',
        "motor.resistance",
        "missing key: a series characteristic needs resistance",
        'add resistance = "0.5 ohm"',
    ),
    (
        BARE + 'kind = "shunt"\ncharacteristic = "kloss"\nno_load_speed = "1600 rpm"\n',
        "motor.characteristic",
        "'kloss' is a characteristic of an induction motor, not of a shunt one",
        'write "shunt", or kind = "induction"',
    ),
    (
        BARE + 'kind = "shunt"\ncharacteristic = "linear"\n',
        "motor.no_load_speed",
        "missing key: a linear characteristic needs no_load_speed",
        'add no_load_speed = "1600 rpm"',
    ),
    (
        BARE + 'synchronous_speed = "1455 rpm"\n',
        "motor.speed",
        "the rated speed '1455 rpm' is not below synchronous_speed '1455 rpm'",
        'a motor slips under load: such as speed = "1455 rpm" below synchronous_speed = "1500 rpm"',
    ),
    (
        '[motor]\npower = "7.5 kW"\nspeed = 1455\nsynchronous_speed = "1500 rpm"\n',
        "motor.speed",
        "1455 without a unit is in rad/s, which is 13894 rpm",
        'write "1455 rpm" or "1455 rad/s"',
    ),
    (
        '[motor]\npower = 7.5\nspeed = "1455 rpm"\nsynchronous_speed = "1500 rpm"\n',
        "motor.power",
        "7.5 without a unit is in W",
        'write "7.5 kW" or "7.5 W"',
    ),
    (
        '[motor]\npower = "-7.5 kW"\nspeed = "1455 rpm"\nsynchronous_speed = "1500 rpm"\n',
        "motor.power",
        "'-7.5 kW' is negative; a power is at least 0",
        "write it without the minus",
    ),
    (
        '[motor]\npower = "7.5 N"\nspeed = "1455 rpm"\nsynchronous_speed = "1500 rpm"\n',
        "motor.power",
        "'7.5 N' is a force, a power is needed",
        'write a number and its unit in quotes, such as "1.1 kW"',
    ),
    (
        MOTOR + "overload = 1\n",
        "motor.overload",
        "1 is out of range; an overload ratio is above 1",
        "write a number, such as 2.2",
    ),
    (
        MOTOR + 'overload = "2.2 N"\n',
        "motor.overload",
        "'2.2 N' is not an overload ratio",
        "write a number, such as 2.2; it has no quotes and no unit",
    ),
    (
        MOTOR + "start = 0\n",
        "motor.start",
        "0 is out of range; a starting ratio is above 0",
        "write a number, such as 1.8",
    ),
    (
        MOTOR + "efficiency = 1\n",
        "motor.efficiency",
        "1 is out of range; the efficiency of a motor is above 0 and below 1",
        "write a number, such as 0.88",
    ),
    (
        MOTOR + "inertia = -1\n",
        "motor.inertia",
        "-1 is negative; a moment of inertia is at least 0",
        "write it without the minus",
    ),
    (
        MOTOR + "time_constant = -1\n",
        "motor.time_constant",
        "-1 is negative; a time is at least 0",
        "write it without the minus",
    ),
    (
        MOTOR + 'time_constant = "aut"\n',
        "motor.time_constant",
        "'aut' is not a time",
        'did you mean "auto"?',
    ),
    (
        '[motor]\nkind = "shunt"\npower = "1.2 kW"\nspeed = "1400 rpm"\n'
        'voltage = "220 V"\nresistance = 3\nconstant = 1.6\n',
        "motor.constant",
        "no-load speed U/k = 1313.03 rpm is not above the rated speed '1400 rpm'",
        "check voltage and constant: a shunt motor of 220 V and 1.4 V*s/rad runs at 1500 rpm without load",
    ),
    (
        MOTOR + 'time_constant = "auto"\n',
        "motor.overload",
        'missing key: time_constant = "auto" follows from the critical slip, which needs overload',
        "add overload = 2.2",
    ),
    (
        '[motor]\nkind = "series"\npower = "5 kW"\nspeed = "900 rpm"\nefficiency = 0.8\ntime_constant = "auto"\n',
        "motor.time_constant",
        '"auto" is for an induction motor, not for a series one: it follows from the critical slip',
        'write a time, such as "20 ms"',
    ),
    (
        MOTOR + "flywheel_moment = 0.1\ninertia = 0.025\n",
        "motor.flywheel_moment",
        "inertia and flywheel_moment together: the rotor has one",
        "remove one of them",
    ),
    (
        MOTOR + 'flywheel_moment = "0.1 kg*m^2"\n',
        "motor.flywheel_moment",
        "'0.1 kg*m^2' is a moment of inertia, a flywheel moment GD^2 is needed",
        'write a number and its unit in quotes, such as "0.11 kgf*m^2"',
    ),
    (
        '[motor]\nname = "choose"\ncatalogue = "none.csv"\n',
        "motor.catalogue",
        "there is no file 'none.csv'",
        "its path counts from the folder of the spec",
    ),
    (
        '[motor]\nname = "choose"\npower = "5 kW"\n',
        "motor.power",
        'power together with name = "choose": the catalogue gives the data of the motor that is chosen',
        "remove it; beside the choice there may be synchronous_speed, catalogue, reserve, characteristic, "
        "time_constant",
    ),
    (
        "[motor]\nname = 5\n",
        "motor.name",
        "5 is not a text",
        "write a text in quotes",
    ),
    (
        '[motor]\nname = "4A132S4"\ncharacteristic = "table"\n',
        "motor.table",
        "missing key: a table characteristic needs table",
        'add table = { speed = ["0 rpm", "1500 rpm"], moment = ["15 N*m", 0] }',
    ),
    (
        '[motor]\nname = "4A132S4"\nkind = "series"\ncharacteristic = "kloss"\n',
        "motor.characteristic",
        "'kloss' is a characteristic of an induction motor, not of a series one",
        'write "series", or kind = "induction"',
    ),
    (
        POINTS + "table = { speed = [0, 10], moment = [5] }\n",
        "motor.table.moment",
        "[5] has 1 value; a list of two moments or more",
        'write moment = ["15 N*m", "7.5 N*m", 0]',
    ),
    (
        POINTS + "table = { speed = [0, 10], moment = [5, 1, 2] }\n",
        "motor.table.moment",
        "3 moments for 2 speeds",
        "write one moment for each speed",
    ),
    (
        POINTS + "table = { speed = [10, 0], moment = [5, 1] }\n",
        "motor.table.speed[1]",
        "0 does not come after 10; speeds ascend",
        "put the points in order",
    ),
    (
        POINTS + "table = { speed = [0, 10] }\n",
        "motor.table.moment",
        "missing key: a characteristic has its moments",
        'add moment = ["15 N*m", "7.5 N*m", 0], or both in a file, file = "m.csv"',
    ),
    (
        POINTS + "table = { moment = [0, 10] }\n",
        "motor.table.speed",
        "missing key: a characteristic has its speeds",
        'add speed = ["0 rpm", "1400 rpm", "1500 rpm"], or both in a file, file = "m.csv"',
    ),
    (
        POINTS + "table = 5\n",
        "motor.table",
        "5 is not a table",
        'write table = { speed = ["0 rpm", "1500 rpm"], moment = ["15 N*m", 0] }',
    ),
    (
        POINTS + 'table = { speed = ["0 rpm", "10 mm"], moment = [5, 1] }\n',
        "motor.table.speed[1]",
        "'10 mm' is a length, an angular speed is needed",
        'write a number and its unit in quotes, such as "55 rpm"',
    ),
    (
        MOTOR + 'table = { speed = [0, 10], moment = [5, 1] }\ncharacteristic = "kloss"\noverload = 2\n',
        "motor.table",
        'table without characteristic = "table"; the characteristic is kloss',
        'add characteristic = "table", or remove table',
    ),
    (
        '[motor]\nname = "4A132S4"\ntable = { speed = [0, 10], moment = [5, 1] }\n',
        "motor.table",
        'table without characteristic = "table"; the characteristic is that of the catalogue',
        'add characteristic = "table", or remove table',
    ),
    (
        '[motor]\nname = "M1"\npower = "1 kW"\nspeed = "1400 rpm"\n',
        "motor.synchronous_speed",
        "missing key: a parabolic characteristic needs synchronous_speed",
        'add synchronous_speed = "1500 rpm"',
    ),
    (
        MOTOR + "sinchronous_speed = 1\n",
        "motor.sinchronous_speed",
        "unknown key 'sinchronous_speed' in [motor]",
        'did you mean "synchronous_speed"?',
    ),
    (
        "[transmission]\nratio = 0\n",
        "transmission.ratio",
        "0 is out of range; a ratio is above 0",
        "write a number, such as 26.4",
    ),
    (
        "[transmission]\nefficiency = 1.2\n",
        "transmission.efficiency",
        "1.2 is out of range; an efficiency is above 0 and at most 1",
        "write a number, such as 0.95",
    ),
    (
        "[transmission]\nefficiency = 0\n",
        "transmission.efficiency",
        "0 is out of range; an efficiency is above 0 and at most 1",
        "write a number, such as 0.95",
    ),
    (
        '[transmission]\ninertia = "-1 kg*m^2"\n',
        "transmission.inertia",
        "'-1 kg*m^2' is negative; a moment of inertia is at least 0",
        "write it without the minus",
    ),
    (
        '[reduction]\nrods = "none"\n',
        "reduction.rods",
        '\'none\' is not allowed here; the value is "exact" or "lumped"',
        'write "exact" or "lumped"',
    ),
    (
        '[motion]\ndrive = "motor"\n',
        "motion.drive",
        'drive = "motor" without a motor',
        'add [motor], or write drive = "positional"',
    ),
    (
        '[motion]\ndrive = "engine"\n',
        "motion.drive",
        '\'engine\' is not allowed here; the value is "motor", "positional" or "none"',
        'write "motor", "positional" or "none"',
    ),
    (
        "[motion]\nspeed = 0\n",
        "motion.speed",
        "0 is zero; an angular speed other than 0 is needed here",
        'write "55 rpm", for example',
    ),
    (
        '[motion]\nspeed = "55 rpm"\n[motor]\npower = "7.5 kW"\nspeed = "1455 rpm"\nsynchronous_speed = "1500 rpm"\n',
        "motion.speed",
        "speed together with a motor: its characteristic and the load set the speed",
        'remove it, or write drive = "positional"',
    ),
    (
        '[motion]\ndrive = "none"\nspeed = "55 rpm"\n',
        "motion.speed",
        'speed together with drive = "none": the loads set the speed',
        'remove it, or write drive = "positional"',
    ),
    (
        "[motion]\ninertia = -1\n",
        "motion.inertia",
        "-1 is negative; a moment of inertia is at least 0",
        "write it without the minus",
    ),
    (
        "[flywheel]\n",
        "flywheel",
        "missing key: the allowed unevenness, or the moment of inertia of a flywheel that is there",
        'add delta = "1/25", or inertia = "20 kg*m^2"',
    ),
    (
        "[flywheel]\ndelta = 0\n",
        "flywheel.delta",
        "0 is out of range; a coefficient of unevenness is above 0 and below 1",
        "write a number, such as 0.04",
    ),
    (
        "[flywheel]\ndelta = 1\n",
        "flywheel.delta",
        "1 is out of range; a coefficient of unevenness is above 0 and below 1",
        "write a number, such as 0.04",
    ),
    (
        '[flywheel]\ndelta = "1/0.5"\n',
        "flywheel.delta",
        "'1/0.5' is out of range; a coefficient of unevenness is above 0 and below 1",
        "write a number, such as 0.04",
    ),
    (
        "[flywheel]\ninertia = -1\n",
        "flywheel.inertia",
        "-1 is negative; a moment of inertia is at least 0",
        "write it without the minus",
    ),
    (
        '[flywheel]\ndelta = 0.04\nshaft = "motor"\n',
        "flywheel.shaft",
        'shaft = "motor" without a motor: the ratio to the crank is not known',
        "add [motor], or [transmission] with ratio = 26.4",
    ),
    (
        '[flywheel]\ndelta = 0.04\nshaft = "input"\nratio = 4\n',
        "flywheel.ratio",
        'shaft = "input" together with ratio: its ratio is known',
        "remove shaft for another shaft of this ratio, or remove ratio",
    ),
    (
        "[flywheel]\ndelta = 0.04\nratio = -4\n",
        "flywheel.ratio",
        "-4 is out of range; a ratio is above 0",
        "write a number, such as 26.4",
    ),
    (
        '[flywheel]\ndelta = 0.04\nwidth = "100 mm"\n',
        "flywheel.width",
        "width alone: a rim is sized from its diameter, or from its width and thickness",
        'add diameter = "800 mm"',
    ),
    (
        '[flywheel]\ndelta = 0.04\ndiameter = 1\nwidth = "100 mm"\nthickness = "50 mm"\n',
        "flywheel.thickness",
        "diameter, width and thickness together: one of them follows from the moment of inertia",
        "remove one of them",
    ),
    (
        "[flywheel]\ndelta = 0.04\ndensity = 0\n",
        "flywheel.density",
        "0 is zero; a density other than 0 is needed here",
        'write "7850 kg/m^3", for example',
    ),
    (
        '[flywheel]\ndelta = 0.04\nspeed_limit = "30 mm"\n',
        "flywheel.speed_limit",
        "'30 mm' is a length, a speed is needed",
        'write a number and its unit in quotes, such as "0.2 m/s"',
    ),
]


@pytest.mark.parametrize(("added", "path", "message", "remedy"), FAULTS)
def test_one_slip_is_one_fault_at_its_line(
    shaper: str, faults_of: Faults, added: str, path: str, message: str, remedy: str
) -> None:
    text = f"{shaper}\n{added}"
    check_only_fault(text, faults_of(text), path, message, remedy)


def test_what_a_motor_lacks_comes_together(shaper: str, faults_of: Faults) -> None:
    found = faults_of(f'{shaper}\n[motor]\npower = "7.5 kW"\ncharacteristic = "kloss"\n')
    assert [fault.path for fault in found] == ["motor.speed", "motor.synchronous_speed", "motor.overload"]


def test_a_misspelt_key_is_not_missing_as_well(shaper: str, faults_of: Faults) -> None:
    (fault,) = faults_of(shaper + "\n" + MOTOR.replace("power", "powr"))
    assert (fault.path, fault.remedy) == ("motor.powr", 'did you mean "power"?')
    (fault,) = faults_of(f"{shaper}\n[flywheel]\ndelda = 0.04\n")
    assert (fault.path, fault.remedy) == ("flywheel.delda", 'did you mean "delta"?')


def test_a_key_in_the_wrong_table_has_a_home(shaper: str, faults_of: Faults) -> None:
    (fault,) = faults_of(f"{shaper}\n[reduction]\nefficiency = 0.9\n")
    assert fault.remedy.startswith("efficiency belongs in [motor], [transmission], [gearing]")
    (fault,) = faults_of(f"{shaper}\n[reduction]\nstiffness = 1\n")
    assert fault.remedy.startswith("stiffness belongs in [[springs]], [[shafts]], ")
    assert fault.remedy.endswith(", [cam.spring] or [cam.elastic]")
    (fault,) = faults_of(f"{shaper}\n[weather]\n")
    assert fault.remedy.startswith(
        "the keys here are: project, mechanism, synthesis, dyad, torque, loads, springs, paths, drive"
    )


@pytest.mark.parametrize(
    "added",
    [
        '[motor]\nname = "4A132S4"\n',
        '[motor]\nname = "4A132S4"\noverload = 2.5\nspeed = "1450 rpm"\n',
        '[motor]\nname = "choose"\nsynchronous_speed = "1500 rpm"\ncharacteristic = "kloss"\n',
        MOTOR,
        MOTOR + 'overload = 2.2\ncharacteristic = "kloss"\n',
        MOTOR + 'characteristic = "linear"\n',
        BARE + 'characteristic = "constant"\n',
        BARE + 'kind = "shunt"\nno_load_speed = "1600 rpm"\n',
        BARE + 'kind = "shunt"\nno_load_speed = "1600 rpm"\ncharacteristic = "linear"\n',
        BARE + 'kind = "shunt"\nvoltage = "220 V"\nresistance = 0.5\nconstant = 1.4\n',
        BARE + 'kind = "series"\nefficiency = 0.85\n',
        BARE + 'kind = "series"\nvoltage = "220 V"\nresistance = "0.5 ohm"\n',
        BARE + 'name = "M1"\ncharacteristic = "constant"\n',
        BARE + 'characteristic = "table"\ntable = { speed = ["0 rpm", "1500 rpm"], moment = ["15 N*m", 0] }\n',
        '[motor]\nname = "4A132S4"\ncharacteristic = "table"\ntable = { speed = [0, 150], moment = [15, 0] }\n',
        MOTOR + '[motion]\ndrive = "positional"\nspeed = "55 rpm"\n',
        '[motion]\ndrive = "none"\n',
        '[motion]\nspeed = "55 rpm"\n',
        '[flywheel]\ndelta = "1/25"\n',
        "[flywheel]\ninertia = 20\nratio = 4\n",
        '[flywheel]\ndelta = 0.04\nshaft = "motor"\n[transmission]\nratio = 26.4\n',
        "[flywheel]\ndelta = 0.04\nwidth = 0.1\nthickness = 0.05\n",
        "[flywheel]\ndelta = 0.04\ndiameter = 0.8\nwidth = 0.1\n",
        "[drive]\n",
        "[reduction]\n",
        "[transmission]\n",
        "[motion]\n",
        SPRING + 'damping = "20 N*s/m"\n',
        TORSION + "stiffness = 100\nfree_angle = 0\n",
    ],
)
def test_what_is_allowed(shaper: str, added: str) -> None:
    assert parse_spec(f"{shaper}\n{added}")


@pytest.mark.parametrize(
    ("added", "path", "message"),
    [
        (MOTOR, "motor", 'the input joint "A0" is prismatic; a motor turns a crank'),
        (
            "[motion]\n",
            "motion",
            'the input joint "A0" is prismatic; the motion is found of a machine with a crank',
        ),
        (
            "[flywheel]\ndelta = 0.04\n",
            "flywheel",
            'the input joint "A0" is prismatic; a flywheel turns with a crank',
        ),
        (
            GEAR + "radius = 0.1\npinion = 0\n",
            "drive.kind",
            'the input joint "A0" is prismatic; only a crank carries a gear',
        ),
    ],
)
def test_a_driven_slider_is_no_machine(faults_of: Faults, added: str, path: str, message: str) -> None:
    (fault,) = faults_of((CONFIGS / "hydraulic-lift.toml").read_text(encoding="utf-8") + added)
    assert (fault.path, fault.message) == (path, message)


KEYS = {
    "springs": "name kind links points stiffness free_length free_angle damping",
    "drive": "kind radius mesh_angle pinion internal",
    "motor": "name catalogue kind power speed synchronous_speed no_load_speed overload start inertia flywheel_moment "
    "time_constant efficiency voltage resistance constant characteristic table",
    "motor.table": "speed moment interpolation",
    "transmission": "ratio efficiency inertia",
    "reduction": "rods",
    "motion": "drive inertia speed",
    "flywheel": "delta inertia shaft ratio diameter width thickness material density speed_limit",
}


@sparing(("table", "key"), [(table, key) for table, keys in KEYS.items() for key in keys.split()], every=6)
def test_no_value_breaks_the_checks(shaper: str, table: str, key: str) -> None:
    head = "[[springs]]" if table == "springs" else f"[{table}]"
    for value in HOSTILE:
        check_lines(f"{shaper}\n{head}\n{key} = {value}\n")


@pytest.mark.parametrize("table", [table for table in KEYS if "." not in table])
def test_no_table_of_another_type_breaks_the_checks(faults_of: Faults, table: str) -> None:
    for value in HOSTILE:
        assert faults_of(f"mechanism = {value}\n{table} = {value}\n")


def test_a_motor_that_no_catalogue_has_is_a_fault_of_the_spec(shaper: str, tmp_path: Path) -> None:
    check_fault(f'{shaper}\n[motor]\nname = "4A132S5"\n', "motor.name", "the catalogue has no motor", "4A132S")
    own = tmp_path / "own.csv"
    own.write_text("name,power_kW,synchronous_rpm,speed_rpm\nM1,1,1500,x\n", "utf-8")
    text = f'{shaper}\n[motor]\nname = "M1"\ncatalogue = "{own.as_posix()}"\n'
    check_fault(text, "motor.catalogue", "'x' is not a number", "")
