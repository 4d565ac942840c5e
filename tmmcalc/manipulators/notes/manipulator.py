"""The chapter on a manipulator: its data, the path or the motion of the joints, both problems, what limits them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.manipulators.notes import along, arms, moves
from tmmcalc.manipulators.notes.path import path, seen
from tmmcalc.manipulators.notes.told import Told, joint_words, letter
from tmmcalc.manipulators.notes.verdicts import verdicts
from tmmcalc.manipulators.pictures.manipulator import pieces_of
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator
from tmmcalc.manipulators.task import ArcRoute, ArcThrough, LawTask, PathTask, TableTask
from tmmcalc.report.drawing.order import POSITIONS, Order
from tmmcalc.report.formula.digits import RESULT, significant
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Paragraph, Table
from tmmcalc.report.telling import pictured, tabulated


def blocks(order: Order) -> Iterator[Block]:
    """The manipulator as a calculation by hand finds it."""
    result: Manipulator = order.results["manipulator"]
    told = Told(to_manipulator(order.spec), result, ())
    asked = order.rows(POSITIONS, result.labels)
    chosen = asked or (along.shown(told) if result.inverse else moves.shown(told))
    told = Told(told.task, result, tuple(chosen))
    first, second = pieces_of(order)
    yield Heading(tr("Manipulator and its task"), 2)
    yield from _given(told)
    if result.inverse:
        yield Heading(tr("Path of the gripper"), 2)
        yield from path(told, first)
        yield from along.law(told)
        yield from along.motion(told)
        yield from arms.inverse(told)
    else:
        motion = told.task.motion
        if isinstance(motion, LawTask):
            yield from moves.by_laws(told, motion)
        elif isinstance(motion, TableTask):
            yield from moves.by_table(told, motion)
        yield from arms.direct(told)
        yield seen(told)
        yield pictured(first, key="manipulator_path")
    yield from _tables(told)
    yield pictured(second, key="manipulator_time")
    yield from verdicts(told)


def _given(told: Told) -> Iterator[Block]:
    """What is given, as a table."""
    kinds = {
        "spherical": tr("a spherical arm, which turns in its vertical plane and extends"),
        "cylindrical": tr("a cylindrical arm, which lifts and reaches out in its vertical plane"),
        "angular": tr("an angular arm, an upper arm and a forearm in a vertical plane"),
    }
    kind = kinds[told.arm.kind]
    base = tr("The manipulator has {arm}, on a base that turns about the vertical axis.", arm=kind)
    yield Paragraph(base if told.arm.spatial else tr("The manipulator has {arm}.", arm=kind))
    yield Paragraph(
        tr(
            "The path of the gripper is given: this is the inverse problem, which finds the joint coordinates with "
            "their derivatives by the time. The given data are in table {table}.",
            table="{tab:manipulator_data}",
        )
        if told.result.inverse
        else tr(
            "The motion of the joints is given: this is the direct problem, which finds place, velocity and "
            "acceleration of the gripper. The given data are in table {table}.",
            table="{tab:manipulator_data}",
        )
    )
    head = (tr("Quantity"), tr("Designation"), tr("Unit"), tr("Value"))
    yield Table(tr("Given data of the manipulator"), head, tuple(_rows(told)), "manipulator_data")


def _rows(told: Told) -> Iterator[tuple[str, str, str, str]]:
    arm, asked = told.arm, told.task.motion
    if arm.kind == "angular":
        yield tr("Length of the upper arm"), "$l_a$", tr_unit("m"), _number(arm.upper)
        yield tr("Length of the forearm"), "$l_b$", tr_unit("m"), _number(arm.forearm)
        if told.result.inverse:
            side = tr("to the left of the line from the shoulder") if arm.elbow > 0 else tr("to the right of that line")
            yield tr("Elbow"), "", "", side
    if arm.height:
        yield tr("Height of the shoulder"), "$H$", tr_unit("m"), _number(arm.height)
    if isinstance(asked, PathTask):
        yield from _of_path(told, asked)
    elif isinstance(asked, LawTask):
        yield from _of_laws(told, asked)
    for limit in told.task.limits:
        joint = next(each for each in arm.ranged if each.name == limit.name)
        ends = [_coordinate(edge, joint.turns) for edge in (limit.low, limit.high)]
        unit = "°" if joint.turns else tr_unit("m")
        said = joint_words(arm, joint)[0]
        yield tr("Range: {what}", what=said), f"${letter(joint)}$", unit, f"{ends[0]} … {ends[1]}"
    for obstacle in told.task.obstacles:
        corners = "; ".join(f"({_number(each.real)}; {_number(each.imag)})" for each in obstacle.corners)
        yield tr("Corners of obstacle {name}", name=obstacle.name), "$x$, $y$", tr_unit("m"), corners
        if arm.spatial:
            heights = f"{_number(obstacle.low)} … {_number(obstacle.high)}"
            yield tr("Height of obstacle {name}", name=obstacle.name), "$z$", tr_unit("m"), heights


def _of_path(told: Told, asked: PathTask) -> Iterator[tuple[str, str, str, str]]:
    route, drive = asked.route, asked.drive
    names = ", ".join(f"${axis}_%$" for axis in told.axes)
    if isinstance(route, ArcRoute | ArcThrough):
        yield tr("Start of the path"), names.replace("%", "1"), tr_unit("m"), _point(route.start)
        yield tr("End of the path"), names.replace("%", "2"), tr_unit("m"), _point(route.end)
        if isinstance(route, ArcThrough):
            yield tr("Point of the arc"), names.replace("%", "v"), tr_unit("m"), _point(route.via)
        else:
            yield tr("Radius of the arc"), "$R$", tr_unit("m"), _number(route.radius)
            yield tr("Side of the centre"), "$K$", "", f"{route.side:+d}".replace("-", "−")
            if told.arm.spatial:
                yield tr("Normal of the plane of the arc"), "$n_x$, $n_y$, $n_z$", "", _point(route.normal)
    elif len(route.points) == 2:
        yield tr("Start of the path"), names.replace("%", "1"), tr_unit("m"), _point(route.points[0])
        yield tr("End of the path"), names.replace("%", "2"), tr_unit("m"), _point(route.points[1])
    else:
        yield tr("Number of points of the path"), "", "", str(len(route.points))
        if route.corner:
            yield tr("Radius of the rounded corners"), "$R$", tr_unit("m"), _number(route.corner)
    limits = (
        (drive.speed, "$v_m$", "m/s", tr("Allowed speed of the gripper")),
        (drive.duration, "$T$", "s", tr("Time of the motion")),
        (drive.acceleration, "$a_m$", "m/s^2", tr("Allowed tangential acceleration of the gripper")),
        (drive.normal, "$a_n^{lim}$", "m/s^2", tr("Allowed normal acceleration of the gripper")),
        (drive.total, "$a_Σ^{lim}$", "m/s^2", tr("Allowed total acceleration of the gripper")),
    )
    for value, name, unit, said in limits:
        if value is not None:
            yield said, name, tr_unit(unit), _number(value)


def _of_laws(told: Told, asked: LawTask) -> Iterator[tuple[str, str, str, str]]:
    moves = {move.name: move for move in asked.moves}
    for joint in told.arm.joints:
        move, said = moves[joint.name], joint_words(told.arm, joint)
        unit = "°" if joint.turns else tr_unit("m")
        ends = [_coordinate(each, joint.turns) for each in (move.start, move.end)]
        told_as = ends[0] if move.start == move.end else tr("from {first} to {last}", first=ends[0], last=ends[1])
        yield _capital(said[0]), f"${joint.name}$", unit, told_as
        own = "rad" if joint.turns else "m"
        if move.start != move.end and move.speed is not None and move.acceleration is not None:
            yield tr("Allowed: {what}", what=said[1]), f"${joint.rate}$", tr_unit(f"{own}/s"), _number(move.speed)
            yield (
                tr("Allowed: {what}", what=said[2]),
                f"${joint.acceleration}$",
                tr_unit(f"{own}/s^2"),
                _number(move.acceleration),
            )


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _number(value: float) -> str:
    return tr_number(significant(value, RESULT)).replace("-", "−")


def _coordinate(value: float | None, turns: bool) -> str:
    return "–" if value is None else _number(math.degrees(value) if turns else value)


def _point(place: tuple[float, ...]) -> str:
    return "; ".join(map(_number, place))


def _tables(told: Told) -> Iterator[Block]:
    """The motion over all rows: gripper, joints, elbow."""
    result = told.result
    yield Heading(tr("Motion over the time"), 2)
    keys = [
        *(["way"] if result.inverse else []),
        *(["gripper", "gripper_2"] if told.arm.spatial else ["gripper"]),
        *(["joints", "joints_2"] if told.arm.spatial else ["joints"]),
        *(["elbow"] if result.elbow is not None and result.elbow_angle is not None else []),
    ]
    yield Paragraph(
        tr(
            "Tables {first}–{last} and figure {figure} have the motion over the time; a minus after the number of a "
            "row marks the limit before a jump of the acceleration.",
            first=f"{{tab:manipulator_{keys[0]}}}",
            last=f"{{tab:manipulator_{keys[-1]}}}",
            figure="{fig:manipulator_time}",
        )
    )
    if result.inverse:
        way = dict(zip(("$s$, m", "$v$, m/s", "$a$, m/s^2"), result.way, strict=True))
        caption = tr("Way of the gripper along the path, its speed and tangential acceleration")
        yield tabulated(caption, {"$t$, s": result.t, **way}, result.labels, head=tr("Row"), key="manipulator_way")
    states = [
        {f"${name}{axis}$, {unit}": result.gripper[order, k] for k, axis in enumerate(told.axes)}
        for order, (name, unit) in enumerate((("", "m"), ("v_", "m/s"), ("a_", "m/s^2")))
    ]
    first = [tr("Coordinates of the gripper, its velocity and acceleration")]
    if told.arm.spatial:  # a page has room for one more beside two vectors
        first = [tr("Coordinates of the gripper and its velocity"), tr("Acceleration of the gripper")]
    yield from _parted(told, first, states, "manipulator_gripper")
    joints = []
    for k, joint in enumerate(told.arm.joints):
        units = ("deg", "rad/s", "rad/s^2") if joint.turns else ("m", "m/s", "m/s^2")
        values = (np.degrees(result.q[0, k]) if joint.turns else result.q[0, k], *result.q[1:, k])
        joints.append({f"${name}$, {unit}": row for name, unit, row in zip(joint[:3], units, values, strict=True)})
    second = [tr("Joint coordinates with their derivatives")]
    if told.arm.spatial:
        joints = [*joints[1:], joints[0]]
        second += [tr("Rotation of the base with its derivatives")]
    yield from _parted(told, second, joints, "manipulator_joints")
    if result.elbow is not None and result.elbow_angle is not None:
        places = {f"${axis}_E$, m": row for axis, row in zip(told.axes, result.elbow, strict=True)}
        bent = {"$gamma$, deg": np.degrees(result.elbow_angle[0]), **places}
        caption = tr("Angle and place of the elbow")
        yield tabulated(caption, {"$t$, s": result.t, **bent}, result.labels, head=tr("Row"), key="manipulator_elbow")


def _parted(told: Told, captions: Sequence[str], columns: Sequence[Mapping[str, Values]], key: str) -> Iterator[Block]:
    """Columns over the time in one table, or the last of them in one of their own."""
    parts = [columns] if len(captions) == 1 else [columns[:-1], columns[-1:]]
    for k, (caption, own) in enumerate(zip(captions, parts, strict=True)):
        joined = {"$t$, s": told.result.t, **{name: row for each in own for name, row in each.items()}}
        yield tabulated(caption, joined, told.result.labels, head=tr("Row"), key=f"{key}_{k + 1}" if k else key)
