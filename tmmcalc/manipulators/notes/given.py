"""What is given of a manipulator: its arm, the path of the gripper or the motion of the joints, what limits them."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.manipulators.notes.told import AXES, gripper_law, joint_words, letter
from tmmcalc.manipulators.task import (
    ArcRoute,
    ArcThrough,
    Arm,
    Joint,
    JointLimit,
    LawTask,
    ManipulatorTask,
    Obstacle,
    PathTask,
    Place,
    PolyRoute,
    TableTask,
)
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Paragraph
from tmmcalc.report.telling import in_rows


def scene(task: ManipulatorTask) -> Iterator[Paragraph]:
    """What arm it is, and which of its two problems is asked."""
    kinds = {
        "spherical": tr("a spherical arm, which turns in its vertical plane and extends"),
        "cylindrical": tr("a cylindrical arm, which lifts and reaches out in its vertical plane"),
        "angular": tr("an angular arm, an upper arm and a forearm in a vertical plane"),
    }
    kind = kinds[task.arm.kind]
    base = tr("The manipulator has {arm}, on a base that turns about the vertical axis.", arm=kind)
    yield Paragraph(base if task.arm.spatial else tr("The manipulator has {arm}.", arm=kind))
    yield Paragraph(
        tr(
            "The path of the gripper is given: this is the inverse problem, which finds the joint coordinates with "
            "their derivatives by the time."
        )
        if isinstance(task.motion, PathTask)
        else tr(
            "The motion of the joints is given: this is the direct problem, which finds place, velocity and "
            "acceleration of the gripper."
        )
    )


def whole(task: ManipulatorTask) -> Iterator[Block]:
    """All that is given, beside the arm its axes and the law of the motion."""
    yield from scene(task)
    axes = (
        tr(
            "The shoulder is on axis $z$, which points upwards; the base turns about it by $psi$ from axis $x$, other "
            "angles are those with the horizontal, positive upwards."
        )
        if task.arm.spatial
        else tr(
            "The shoulder is on axis $y$, which points upwards; angles are those with axis $x$, positive "
            "counter-clockwise."
        )
    )
    yield Paragraph(axes if task.arm.height else f"{axes} {tr('The shoulder is in the origin.')}")
    asked = task.motion
    if isinstance(asked, PathTask):
        yield _by_path(asked)
    elif isinstance(asked, LawTask):
        yield _by_laws(asked)
    yield from rows(task)
    if isinstance(asked, PathTask) and isinstance(asked.route, PolyRoute) and len(asked.route.points) > 2:
        for k, place in enumerate(asked.route.points, 1):
            yield _point(tr("point {number} of the path", number=k), task.arm, str(k), place)
    elif isinstance(asked, TableTask):
        yield from _of_table(task.arm, asked)
    yield Datum(tr("number of equal steps of the time of the motion"), ("n",), (float(task.steps),))
    if task.obstacles:
        clear = tr("gripper and arm") if task.check_arm else tr("gripper alone")
        yield Datum(tr("what must keep clear of the obstacles"), text=clear)


def _by_path(asked: PathTask) -> Paragraph:
    """How the gripper goes along its path."""
    drive, route = asked.drive, asked.route
    said = [gripper_law(drive)]
    if isinstance(route, ArcRoute):
        said.append(tr("The gripper goes along the shorter arc of the given radius."))
        said.append(tr("$K = 1$: the centre is to the left of the way from start to end, $K = -1$: to the right."))
    elif isinstance(route, ArcThrough):
        said.append(tr("The gripper goes along the arc through three given points."))
    elif len(route.points) == 2:
        said.append(tr("The gripper goes along a straight line."))
    elif route.corner:
        said.append(tr("The gripper goes along lines between the given points; arcs round the corners."))
    else:
        said.append(tr("The gripper goes along lines between the given points and stops at each corner."))
    if drive.normal is not None or drive.total is not None:
        said.append(
            tr("Between two stops the largest speed keeps the limits of the accelerations on the arc of least radius.")
        )
    return Paragraph(" ".join(said))


def _by_laws(asked: LawTask) -> Paragraph:
    """How the joints move."""
    law = tr(
        "Each joint moves from rest to rest with its largest acceleration, at constant speed, with its largest "
        "deceleration."
    )
    together = tr(
        "All joints take the time of the slowest one, the others with their largest accelerations at lower speeds."
    )
    return Paragraph(f"{law} {together if asked.together else tr('Each joint is as quick as it can.')}")


def rows(task: ManipulatorTask) -> Iterator[Datum]:
    """The data as they stand in the table of the chapter."""
    arm, asked = task.arm, task.motion
    if arm.kind == "angular":
        yield Datum(tr("length of the upper arm"), ("l_a",), (arm.upper,), "m")
        yield Datum(tr("length of the forearm"), ("l_b",), (arm.forearm,), "m")
        if isinstance(asked, PathTask):
            side = (
                tr("to the left of the line from the shoulder to the gripper, seen along it")
                if arm.elbow > 0
                else tr("to the right of the line from the shoulder to the gripper, seen along it")
            )
            yield Datum(tr("where the elbow is"), text=side)
    if arm.height:
        yield Datum(tr("height of the shoulder"), ("H",), (arm.height,), "m")
    if isinstance(asked, PathTask):
        yield from _of_path(arm, asked)
    elif isinstance(asked, LawTask):
        yield from _of_laws(arm, asked)
    for limit in task.limits:
        yield _of_limit(arm, limit)
    for obstacle in task.obstacles:
        yield from _of_obstacle(arm, obstacle)


def _point(said: str, arm: Arm, index: str, place: Place) -> Datum:
    return Datum(said, tuple(f"{axis}_{index}" for axis in AXES[: arm.dimensions]), place, "m")


def _of_path(arm: Arm, asked: PathTask) -> Iterator[Datum]:
    route, drive = asked.route, asked.drive
    if isinstance(route, ArcRoute | ArcThrough):
        yield _point(tr("start of the path"), arm, "1", route.start)
        yield _point(tr("end of the path"), arm, "2", route.end)
        if isinstance(route, ArcThrough):
            yield _point(tr("point of the arc"), arm, "v", route.via)
        else:
            yield Datum(tr("radius of the arc"), ("R",), (route.radius,), "m")
            yield Datum(tr("side of the centre"), ("K",), (float(route.side),))
            if arm.spatial:
                yield Datum(tr("normal of the plane of the arc"), ("n_x", "n_y", "n_z"), route.normal)
    elif len(route.points) == 2:
        yield _point(tr("start of the path"), arm, "1", route.points[0])
        yield _point(tr("end of the path"), arm, "2", route.points[1])
    else:
        yield Datum(tr("number of points of the path"), (), (float(len(route.points)),))
        if route.corner:
            yield Datum(tr("radius of the rounded corners"), ("R",), (route.corner,), "m")
    limits = (
        (drive.speed, "v_m", "m/s", tr("Allowed speed of the gripper")),
        (drive.duration, "T", "s", tr("Time of the motion")),
        (drive.acceleration, "a_m", "m/s^2", tr("Allowed tangential acceleration of the gripper")),
        (drive.normal, "a_n^{lim}", "m/s^2", tr("Allowed normal acceleration of the gripper")),
        (drive.total, "a_Σ^{lim}", "m/s^2", tr("Allowed total acceleration of the gripper")),
    )
    yield from (Datum(said, (name,), (value,), unit) for value, name, unit, said in limits if value is not None)


def _of_laws(arm: Arm, asked: LawTask) -> Iterator[Datum]:
    moves = {move.name: move for move in asked.moves}
    for joint in arm.joints:
        move, said = moves[joint.name], joint_words(arm, joint)
        if move.start == move.end:
            yield _coordinates(_capital(said[0]), joint, move.start)
            continue
        ends = tr("{what}, at the beginning and at the end", what=_capital(said[0]))
        yield _coordinates(ends, joint, move.start, move.end)
        unit = "rad" if joint.turns else "m"
        limits = (joint.rate, move.speed, f"{unit}/s"), (joint.acceleration, move.acceleration, f"{unit}/s^2")
        for (name, value, own), what in zip(limits, said[1:], strict=True):
            if value is not None:
                yield Datum(tr("allowed: {what}", what=what), (name,), (value,), own)


def _of_table(arm: Arm, asked: TableTask) -> Iterator[Block]:
    """The coordinates of the joints at the times of a table."""
    yield Paragraph(
        tr(
            "Between the rows of the given table each coordinate is a polynomial of the third degree in the time; at "
            "the rows velocity and acceleration are continuous, at both ends the joint is at rest."
        )
    )
    lists = [Datum(tr("times of the table"), ("t_k",), tuple(asked.t.tolist()), "s")]
    for joint, values in zip(arm.joints, asked.q, strict=True):
        said = tr("{what}, at these times", what=_capital(joint_words(arm, joint)[0]))
        lists.append(_coordinates(said, joint, *values.tolist()))
    yield from in_rows(*lists)


def _of_limit(arm: Arm, limit: JointLimit) -> Datum:
    """The range of a joint, or the end of it that there is."""
    joint = next(each for each in arm.ranged if each.name == limit.name)
    said = joint_words(arm, joint)[0]
    ends = [edge for edge in (limit.low, limit.high) if edge is not None]
    if len(ends) == 2:
        return _coordinates(tr("Range: {what}", what=said), joint, *ends)
    at_least = tr("At least: {what}", what=said)
    return _coordinates(at_least if limit.high is None else tr("At most: {what}", what=said), joint, *ends)


def _of_obstacle(arm: Arm, obstacle: Obstacle) -> Iterator[Datum]:
    for k, each in enumerate(obstacle.corners, 1):
        said = tr("corner {number} of obstacle {name}", number=k, name=obstacle.name)
        yield Datum(said, ("x", "y"), (each.real, each.imag), "m")
    if arm.spatial:
        said = tr("height of obstacle {name}, its lower and its upper end", name=obstacle.name)
        yield Datum(said, ("z",), (obstacle.low, obstacle.high), "m")


def _coordinates(said: str, joint: Joint, *values: float) -> Datum:
    """Values of a joint coordinate."""
    shown = map(math.degrees, values) if joint.turns else values
    return Datum(said, (letter(joint),), tuple(shown), "deg" if joint.turns else "m")


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
