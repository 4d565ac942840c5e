"""Every kind of fault in [manipulator]; and what its keys become."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from faults import HOSTILE, Faults, check_lines, check_only_fault
from project.scenes import CONFIGS

from tmmcalc.core.errors import UsageError
from tmmcalc.manipulators.tables.manipulator import ManipulatorTable
from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator
from tmmcalc.manipulators.task import ArcRoute, ArcThrough, JointLimit, JointMove, LawTask, ManipulatorTask, PolyRoute
from tmmcalc.project import parse_spec

ARM = '[manipulator]\narm = "spherical"\nspeed = "0.6 m/s"\nacceleration = "2 m/s^2"\n'
TWO = ARM.replace("spherical", "angular") + 'upper_arm = "0.9 m"\nforearm = "0.8 m"\n'
LINE = '[manipulator.path]\nkind = "line"\nstart = [1.2, 0.3]\nend = [0.5, 1.1]\n'
ARC = '[manipulator.path]\nkind = "arc"\nstart = [1.2, 0.3]\nend = [0.5, 1.1]\n'
SPACE = '[manipulator.path]\nkind = "line"\nstart = [1.2, 0.3, 0]\nend = [0.5, 1.1, 0]\n'
BARE = '[manipulator]\narm = "spherical"\n'
JOINTS = "[manipulator.joints]\nphi_2 = { from = 0.1 }\nl_3 = { from = 0.7 }\n"
BOX = "[[manipulator.obstacles]]\nbox = [[0.8, 0.5], [1, 0.9]]\n"

# the text; the path, the message and the remedy of the one fault
FAULTS = [
    (
        ARM,
        "manipulator",
        "missing key: the gripper has neither a path nor joints that move it",
        "add [manipulator.path], [manipulator.joints] or [manipulator.motion]",
    ),
    (ARM + LINE + JOINTS, "manipulator.joints", "joints together with path: there is one motion", "remove one of them"),
    (
        BARE + "speed = 1\n" + JOINTS,
        "manipulator.speed",
        "speed is that of the gripper along a path; there is none",
        "remove it; joints have their own, in [manipulator.joints]",
    ),
    (
        BARE + "speed = 1\n" + LINE,
        "manipulator",
        "missing key: the largest tangential acceleration is needed",
        'add acceleration = "2 m/s^2"',
    ),
    (
        BARE + "acceleration = 1\n" + LINE,
        "manipulator",
        "missing key: neither a largest speed nor a duration is given",
        'add speed = "0.6 m/s"',
    ),
    (
        ARM.replace("spherical", "angular") + "upper_arm = 1\n" + LINE,
        "manipulator",
        "missing key: an angular arm has its forearm",
        'add forearm = "0.8 m"',
    ),
    (
        ARM + 'elbow = "up"\n' + LINE,
        "manipulator.elbow",
        "elbow belongs to an angular arm, this one is spherical",
        "remove it",
    ),
    (
        BARE.replace("spherical", "angular")
        + 'upper_arm = 1\nforearm = 1\nelbow = "down"\n'
        + JOINTS.replace("l_3", "phi_3"),
        "manipulator.elbow",
        "elbow has no effect: the joints are given, and their directions settle it",
        "remove it",
    ),
    (
        ARM + LINE + "radius = 1\n",
        "manipulator.path.radius",
        "radius belongs to arc, this path is line",
        "remove it",
    ),
    (
        ARM + '[manipulator.path]\nkind = "polyline"\n',
        "manipulator.path",
        "missing key: polyline has points",
        "add points = [[0, 0], [1, 1]]",
    ),
    (
        ARM + '[manipulator.path]\nkind = "line"\nstart = [1, 2]\n',
        "manipulator.path",
        "missing key: line has end",
        "add end = [1.2, 0.3]",
    ),
    (
        ARM + ARC + "radius = 1\n",
        "manipulator.path",
        "missing key: an arc has radius and side, or via",
        'add side = "left"',
    ),
    (
        ARM + ARC + "via = [1, 1]\nradius = 1\n",
        "manipulator.path.radius",
        "radius together with via: three points settle the arc",
        "remove one of them",
    ),
    (
        ARM + ARC + 'radius = 0.5\nside = "left"\n',
        "manipulator.path.radius",
        "0.5 does not span the ends of the arc, which are 1.06301458 m apart",
        'write at least "0.531508 m"',
    ),
    (
        ARM + '[manipulator.path]\nkind = "arc"\nstart = [1, 1]\nend = [1, 1]\nradius = 1\nside = "left"\n',
        "manipulator.path.end",
        "the arc ends where it begins",
        "write another point",
    ),
    (
        ARM + ARC.replace("0.3]", "0.3, 0]") + 'radius = 1\nside = "left"\n',
        "manipulator.path.end",
        "2 coordinates, and the first point has 3",
        "write [x, y] everywhere, or [x, y, z] for an arm with a turning base",
    ),
    (
        ARM + ARC + 'radius = 1\nside = "left"\nnormal = [0.0, 0.0, 1.0]\n',
        "manipulator.path.normal",
        "normal has no effect: the path lies in the arm's plane",
        "remove it",
    ),
    (
        ARM + "total_acceleration = 1.5\n" + LINE,
        "manipulator.total_acceleration",
        "1.5 is less than the tangential acceleration alone",
        "write a larger one, or a smaller acceleration",
    ),
    (
        BARE + "[manipulator.joints]\nphi_2 = { from = 0.1 }\n",
        "manipulator.joints",
        "missing key: this arm has the joint l_3",
        "add l_3",
    ),
    (
        BARE + JOINTS + "r = { from = 1 }\n",
        "manipulator.joints.r",
        "this arm has no joint r",
        "its joints: psi, phi_2, l_3",
    ),
    (
        BARE + JOINTS.replace("0.7", '"20 deg"'),
        "manipulator.joints.l_3.from",
        "'20 deg' is an angle; l_3 needs a length",
        'write "200 mm", for example',
    ),
    (
        BARE + JOINTS.replace("from = 0.1", "from = 0.1, to = 0.3, speed = 1"),
        "manipulator.joints.phi_2",
        "missing key: the joint moves, and has no largest acceleration",
        "add acceleration",
    ),
    (
        BARE + "[manipulator.motion]\nt = [0, 1, 1]\nphi_2 = [0, 1, 2]\nl_3 = [1, 1, 1]\n",
        "manipulator.motion.t[2]",
        "1 does not come after 1; times ascend",
        "put the rows in order",
    ),
    (
        BARE + "[manipulator.motion]\nt = [0, 1]\nphi_2 = [0, 1, 2]\nl_3 = [1, 1]\n",
        "manipulator.motion.phi_2",
        "3 values for 2 times",
        "write one value for each time",
    ),
    (
        ARM + LINE + "[manipulator.limits]\nl_3 = [2, 1]\n",
        "manipulator.limits.l_3",
        "[2, 1]: the first is not below the second",
        "write [lowest, highest]",
    ),
    (
        ARM + LINE + "[manipulator.limits]\npsi = [1, 2]\n",
        "manipulator.limits.psi",
        "this arm has no joint psi",
        "its joints: phi_2, l_3",
    ),
    (
        ARM + LINE + "[[manipulator.obstacles]]\n",
        "manipulator.obstacles[0]",
        "missing key: an obstacle has corners or a box",
        "write corners = [[x, y], ...], or box with two opposite corners",
    ),
    (
        ARM + LINE + BOX + "low = 0\n",
        "manipulator.obstacles[0].low",
        "low has no effect: without a turning base the polygon is upright",
        "remove it",
    ),
    (
        ARM + SPACE + BOX + "low = 0\n",
        "manipulator.obstacles[0]",
        "missing key: with a turning base an obstacle has high",
        'add high = "0.5 m"',
    ),
    (
        ARM + SPACE + BOX + "low = 1\nhigh = 1\n",
        "manipulator.obstacles[0].high",
        "1 is not above low",
        "write a greater height",
    ),
    (
        ARM + LINE + BOX.replace("0.9]", "0.5]"),
        "manipulator.obstacles[0].box",
        "the obstacle has no area",
        "write corners that are not on one line",
    ),
    (
        ARM + LINE + "[[manipulator.obstacles]]\ncorners = [[0, 0], [1, 1], [2, 2]]\n",
        "manipulator.obstacles[0].corners",
        "the obstacle has no area",
        "write corners that are not on one line",
    ),
    (
        ARM.replace("spherical", "spheric") + LINE,
        "manipulator.arm",
        "'spheric' is no kind of arm",
        'did you mean "spherical"? there are: spherical, cylindrical, angular',
    ),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), FAULTS)
def test_one_fault(faults_of: Faults, text: str, path: str, message: str, remedy: str) -> None:
    check_only_fault(text, faults_of(text), path, message, remedy)


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", ManipulatorTable.model_fields)
def test_hostile_values_never_break_a_check(key: str, value: str) -> None:
    check_lines(f"[manipulator]\n{key} = {value}\n")


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", ["kind", "start", "end", "radius", "side", "via", "normal", "points", "corner_radius"])
def test_hostile_paths_never_break_a_check(key: str, value: str) -> None:
    check_lines(
        f"{ARM}[manipulator.path]\n{key} = {value}\n{'' if key == 'kind' else 'kind = ' + chr(34) + 'arc' + chr(34)}\n"
    )


def task(text: str) -> ManipulatorTask:
    return to_manipulator(parse_spec(text))


KEYS: dict[str, tuple[str, Callable[[ManipulatorTask], Any], Any]] = {
    "arm": (ARM.replace("spherical", "cylindrical") + LINE, lambda t: t.arm.kind, "cylindrical"),
    "upper_arm": (TWO + LINE, lambda t: t.arm.upper, 0.9),
    "forearm": (TWO + LINE, lambda t: t.arm.forearm, 0.8),
    "elbow": (TWO + 'elbow = "down"\n' + LINE, lambda t: t.arm.elbow, -1),
    "height": (ARM + 'height = "250 mm"\n' + LINE, lambda t: t.arm.height, 0.25),
    "speed": (ARM + LINE, lambda t: t.motion.drive.speed, 0.6),
    "acceleration": (ARM + LINE, lambda t: t.motion.drive.acceleration, 2.0),
    "normal_acceleration": (ARM + "normal_acceleration = 1.5\n" + LINE, lambda t: t.motion.drive.normal, 1.5),
    "total_acceleration": (ARM + "total_acceleration = 2.5\n" + LINE, lambda t: t.motion.drive.total, 2.5),
    "duration": (ARM + 'duration = "4 s"\n' + LINE, lambda t: t.motion.drive.duration, 4.0),
    "steps": (ARM + "steps = 9\n" + LINE, lambda t: t.steps, 9),
    "path": (ARM + LINE, lambda t: t.motion.route, PolyRoute(((1.2, 0.3), (0.5, 1.1)))),
    "joints": (
        BARE + JOINTS,
        lambda t: t.motion,
        LawTask((JointMove("phi_2", 0.1, 0.1), JointMove("l_3", 0.7, 0.7))),
    ),
    "motion": (
        BARE + '[manipulator.motion]\nt = [0, 2]\nl_3 = [0.5, 1]\nphi_2 = ["0 deg", "90 deg"]\n',
        lambda t: t.motion.q.tolist(),
        [[0.0, math.pi / 2], [0.5, 1.0]],
    ),
    "limits": (
        ARM + LINE + '[manipulator.limits]\nl_3 = ["500 mm", 2]\n',
        lambda t: t.limits,
        (JointLimit("l_3", 0.5, 2.0),),
    ),
    "obstacles": (ARM + LINE + BOX, lambda t: t.obstacles[0].corners, (0.8 + 0.5j, 1 + 0.5j, 1 + 0.9j, 0.8 + 0.9j)),
    "check_arm": (ARM + "check_arm = false\n" + LINE, lambda t: t.check_arm, False),
}


def test_every_key_is_here() -> None:
    assert KEYS.keys() == ManipulatorTable.model_fields.keys()


@pytest.mark.parametrize("key", KEYS)
def test_what_a_key_becomes(key: str) -> None:
    text, read, value = KEYS[key]
    assert read(task(text)) == value


def test_routes() -> None:
    arc = ARM + ARC
    assert task(arc + 'radius = 1\nside = "right"\n').motion.route == ArcRoute((1.2, 0.3), (0.5, 1.1), 1.0, -1)
    assert task(arc + "via = [1, 1]\n").motion.route == ArcThrough((1.2, 0.3), (1.0, 1.0), (0.5, 1.1))
    poly = ARM + '[manipulator.path]\nkind = "polyline"\npoints = [[0, 1], [1, 1], [1, 2]]\ncorner_radius = "5 cm"\n'
    assert task(poly).motion.route == PolyRoute(((0.0, 1.0), (1.0, 1.0), (1.0, 2.0)), 0.05)
    space = arc.replace("0.3]", "0.3, 0]").replace("1.1]", "1.1, 1]") + 'radius = 1\nside = "left"\n'
    assert task(space + "normal = [1.0, 0.0, 0.0]\n").motion.route.normal == (1.0, 0.0, 0.0)
    assert task(space).arm.spatial


def test_a_base_by_its_joint() -> None:
    found = task(BARE + JOINTS + 'psi = { from = "0 deg", to = "90 deg", speed = 1, acceleration = 2 }\n')
    assert found.arm.spatial
    assert [move.name for move in found.motion.moves] == ["psi", "phi_2", "l_3"]
    table = task(BARE + "[manipulator.motion]\nt = [0, 1]\npsi = [0, 1]\nphi_2 = [0, 0]\nl_3 = [1, 1]\n")
    assert table.arm.spatial
    assert np.array_equal(table.motion.q, [[0, 1], [0, 0], [1, 1]])


def test_names_of_obstacles() -> None:
    found = task(ARM + LINE + BOX + BOX + BOX.replace("box", 'name = "press"\nbox', 1))
    assert [each.name for each in found.obstacles] == ["obstacle", "obstacle 2", "press"]


def test_a_spec_without_the_table() -> None:
    with pytest.raises(UsageError, match=r"no \[manipulator\]"):
        to_manipulator(parse_spec((CONFIGS / "crank-slider.toml").read_text(encoding="utf-8")))
