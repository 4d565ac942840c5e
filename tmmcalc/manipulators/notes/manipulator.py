"""The chapter on a manipulator: its data, the path or the motion of the joints, both problems, what limits them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.manipulators.notes import along, arms, moves
from tmmcalc.manipulators.notes.given import rows, scene, whole
from tmmcalc.manipulators.notes.path import path, seen
from tmmcalc.manipulators.notes.told import Told
from tmmcalc.manipulators.notes.verdicts import verdicts
from tmmcalc.manipulators.pictures.manipulator import pieces_of
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator
from tmmcalc.manipulators.task import LawTask, ManipulatorTask, TableTask
from tmmcalc.report.drawing.order import POSITIONS, Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Paragraph
from tmmcalc.report.telling import data_table, pictured, tabulated


def blocks(order: Order) -> Iterator[Block]:
    """The manipulator as a calculation by hand finds it."""
    result: Manipulator = order.results["manipulator"]
    told = Told(to_manipulator(order.spec), result, ())
    asked = order.rows(POSITIONS, result.labels)
    chosen = asked or (along.shown(told) if result.inverse else moves.shown(told))
    told = Told(told.task, result, tuple(chosen))
    first, second = pieces_of(order)
    yield Heading(tr("Manipulator and its task"), 2)
    yield from _given(told.task)
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


def data(order: Order) -> Iterator[Block]:
    """The arm, the path or the motion of the joints, their limits, the obstacles."""
    yield from whole(to_manipulator(order.spec))


def _given(task: ManipulatorTask) -> Iterator[Block]:
    """What is given, as a table."""
    kind, problem = scene(task)
    yield kind
    table = tr("The given data are in table {table}.", table="{tab:manipulator_data}")
    yield Paragraph(f"{problem.text} {table}")
    yield data_table(tr("Given data of the manipulator"), rows(task), "manipulator_data")


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
