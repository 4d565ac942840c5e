"""From the table ``[manipulator]`` to what is asked of a manipulator."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.manipulators.tables.manipulator import ELBOWS, SIDES
from tmmcalc.manipulators.task import (
    ArcRoute,
    ArcThrough,
    Arm,
    Drive,
    JointLimit,
    JointMove,
    LawTask,
    ManipulatorTask,
    Obstacle,
    PathTask,
    Place,
    PolyRoute,
    Route,
    TableTask,
)

if TYPE_CHECKING:
    from tmmcalc.manipulators.room import ManipulatorTables
    from tmmcalc.manipulators.tables.manipulator import (
        JointsTable,
        JointTable,
        ManipulatorTable,
        MotionTable,
        ObstacleTable,
        PathTable,
    )

UP: Place = (0.0, 0.0, 1.0)


def to_manipulator(spec: ManipulatorTables) -> ManipulatorTask:
    """The manipulator of the spec; raises `UsageError` if it has none."""
    table = spec.manipulator
    if table is None:
        remedy = "add [manipulator] with arm, speed, acceleration and [manipulator.path]"
        raise UsageError("the spec has no [manipulator]", remedy=remedy)
    arm = _arm(table)
    return ManipulatorTask(
        arm=arm,
        motion=_motion(table, arm),
        limits=_limits(table),
        obstacles=tuple(_obstacle(each, k) for k, each in enumerate(table.obstacles)),
        check_arm=table.check_arm,
        steps=table.steps,
    )


def with_steps(spec: ManipulatorTables, count: int) -> ManipulatorTables:
    """The spec with so many equal steps at least, its own among them."""
    table = spec.manipulator
    if table is None:
        raise UsageError("the spec has no [manipulator]")
    dense = table.model_copy(update={"steps": table.steps * -(-count // table.steps)})
    whole: Any = spec  # the root of the spec, which is put together of the rooms
    placed: ManipulatorTables = whole.model_copy(update={"manipulator": dense})
    return placed


def _arm(table: ManipulatorTable) -> Arm:
    return Arm(
        kind=table.arm,
        spatial=_spatial(table),
        upper=table.upper_arm or 0.0,
        forearm=table.forearm or 0.0,
        elbow=ELBOWS[table.elbow or "up"],
        height=table.height,
    )


def _spatial(table: ManipulatorTable) -> bool:
    """Whether the base turns: points have three coordinates, or psi is among the joints."""
    if table.path is not None:
        place = table.path.start or (table.path.points or [[]])[0]
        return len(place) == 3
    joints: JointsTable | MotionTable | None = table.joints or table.motion
    return joints is not None and joints.psi is not None


def _motion(table: ManipulatorTable, arm: Arm) -> PathTask | LawTask | TableTask:
    names = [joint.name for joint in arm.joints]
    if table.joints is not None:
        moves = tuple(_move(name, getattr(table.joints, name)) for name in names)
        return LawTask(moves, table.joints.together)
    if table.motion is not None:
        rows = np.array([getattr(table.motion, name) for name in names], float)
        return TableTask(np.array(table.motion.t, float), rows)
    assert table.path is not None
    assert table.acceleration is not None
    drive = Drive(
        acceleration=table.acceleration,
        speed=table.speed,
        normal=table.normal_acceleration,
        total=table.total_acceleration,
        duration=table.duration,
    )
    return PathTask(_route(table.path), drive)


def _move(name: str, table: JointTable) -> JointMove:
    end = table.start if table.end is None else table.end
    return JointMove(name, table.start, end, table.speed, table.acceleration)


def _route(path: PathTable) -> Route:
    if path.kind == "polyline":
        assert path.points is not None
        return PolyRoute(tuple(map(tuple, path.points)), path.corner_radius)
    assert path.start is not None
    assert path.end is not None
    start, end = tuple(path.start), tuple(path.end)
    if path.kind == "line":
        return PolyRoute((start, end))
    if path.via is not None:
        return ArcThrough(start, tuple(path.via), end)
    assert path.radius is not None
    assert path.side is not None
    normal = UP if path.normal is None else tuple(path.normal)
    return ArcRoute(start, end, path.radius, SIDES[path.side], normal)


def _limits(table: ManipulatorTable) -> tuple[JointLimit, ...]:
    given = {name: getattr(table.limits, name) for name in table.limits.__class__.model_fields}
    return tuple(JointLimit(name, *pair) for name, pair in given.items() if pair is not None)


def _obstacle(table: ObstacleTable, k: int) -> Obstacle:
    name = table.name or ("obstacle" if k == 0 else f"obstacle {k + 1}")
    if table.box is not None:
        (x1, y1), (x2, y2) = table.box
        corners = [[x1, y1], [x2, y1], [x2, y2], [x1, y2]]
    else:
        assert table.corners is not None
        corners = table.corners
    return Obstacle(name, tuple(complex(x, y) for x, y in corners), table.low or 0.0, table.high or 0.0)
