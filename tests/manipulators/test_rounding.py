"""Estimated errors of grippers and joints against 50 digits, near singular places and limits of their laws too."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np
import pytest
from bounding import assert_bounds
from mpmath import mp, mpf

from tmmcalc.core.errors import TmmError
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import (
    BASE,
    JOINTS,
    ArcRoute,
    ArcThrough,
    Arm,
    Drive,
    JointMove,
    LawTask,
    ManipulatorTask,
    PathTask,
    PolyRoute,
    Route,
    TableTask,
)

from . import exact

ROWS = 3  # of a scene, with those of the fastest joints
KINDS = ("spherical", "cylindrical", "angular")
Pairs = dict[str, list[tuple[float, float]]]


def random_arm(rng: np.random.Generator, kind: str, unit: float) -> Arm:
    spatial = bool(rng.random() < 0.5)
    lengths = {"upper": float(rng.uniform(0.6, 1.2)) * unit, "forearm": float(rng.uniform(0.5, 1.2)) * unit}
    return Arm(
        kind,
        spatial,
        elbow=int(rng.choice([-1, 1])),
        height=float(rng.choice([0.0, rng.uniform(-0.5, 0.5) * unit])),
        **(lengths if kind == "angular" else {}),
    )


def random_points(rng: np.random.Generator, arm: Arm, count: int, unit: float) -> list[tuple[float, ...]]:
    """One in four next to the shoulder or the base's axis, or to where the arms are in line."""
    points = rng.uniform(-1.2, 1.2, (count, arm.dimensions)) * unit
    if rng.random() < 0.25:
        gap = 10 ** rng.uniform(-4, -1)
        way = rng.normal(size=arm.dimensions)
        way /= np.linalg.norm(way)
        reach = (arm.upper + arm.forearm) * (1 - gap) if arm.kind == "angular" else gap * unit
        points[-1] = way * reach
        points[-1, -1] += arm.height
    return [tuple(map(float, point)) for point in points]


def random_route(rng: np.random.Generator, arm: Arm, unit: float) -> Route:
    kind = rng.integers(4)
    if kind == 0:
        start, end = random_points(rng, arm, 2, unit)
        least = float(np.linalg.norm(np.subtract(start, end))) / 2
        stretch = float(rng.choice([1.0, 1 + 10 ** rng.uniform(-8, 1)]))
        normal = tuple(map(float, rng.normal(size=3)))
        return ArcRoute(start, end, least * stretch * (1 + 1e-13), int(rng.choice([-1, 1])), normal)
    if kind == 1:
        return ArcThrough(*random_points(rng, arm, 3, unit))
    points = random_points(rng, arm, int(rng.integers(2, 5)), unit)
    sharp = kind == 2 or len(points) == 2
    return PolyRoute(tuple(points), 0.0 if sharp else float(10 ** rng.uniform(-3, -1)) * unit)


def random_drive(rng: np.random.Generator, unit: float, length: float, stops: bool) -> Drive:
    a = float(10 ** rng.uniform(-1, 1)) * unit
    if not stops and rng.random() < 0.3:
        least = 2 * (length / a) ** 0.5
        return Drive(a, duration=least * (1 + float(10 ** rng.uniform(-8, 1))))
    speed = float(10 ** rng.uniform(-1, 1)) * unit
    more = {"normal": float(rng.uniform(0.1, 3)) * unit} if rng.random() < 0.3 else {}
    if rng.random() < 0.3:
        more["total"] = a * float(rng.uniform(1.001, 3))
    return Drive(a, speed, **more)


def random_path(rng: np.random.Generator, kind: str) -> ManipulatorTask:
    unit = float(10 ** rng.uniform(-3, 3))
    arm = random_arm(rng, kind, unit)
    route = random_route(rng, arm, unit)
    with mp.workdps(30):
        parts = exact.legs(route)
        length = float(sum(piece[0] for leg in parts for piece in leg))
    return ManipulatorTask(arm, PathTask(route, random_drive(rng, unit, length, len(parts) > 1)), check_arm=False)


def random_laws(rng: np.random.Generator, kind: str) -> ManipulatorTask:
    unit = float(10 ** rng.uniform(-3, 3))
    arm = random_arm(rng, kind, unit)
    moves = []
    for joint in arm.joints:
        size = 1.0 if joint.turns else unit
        start, end = (rng.uniform(0.2, 3, 2) * size).tolist()
        speed, pull = (10 ** rng.uniform(-1, 1, 2) * size).tolist()
        moves.append(JointMove(joint.name, start, start if rng.random() < 0.2 else end, speed, pull))
    return ManipulatorTask(arm, LawTask(tuple(moves), bool(rng.random() < 0.5)), check_arm=False)


def random_table(rng: np.random.Generator, kind: str) -> ManipulatorTask:
    unit = float(10 ** rng.uniform(-3, 3))
    arm = random_arm(rng, kind, unit)
    t = np.cumsum(10 ** rng.uniform(-2, 1, int(rng.integers(2, 9)))) + rng.choice([0.0, 100.0])
    sizes = np.array([[1.0 if joint.turns else unit] for joint in arm.joints])
    return ManipulatorTask(arm, TableTask(t, rng.uniform(0.2, 3, (len(sizes), len(t))) * sizes), check_arm=False)


def _rows(rng: np.random.Generator, found: Manipulator) -> np.ndarray:
    peaks = np.argmax(np.abs(found.q[1:]), axis=-1).ravel()
    return np.unique(np.concatenate((peaks, rng.permutation(len(found.t))[:ROWS])))


def _joints_of(asked: Any, arm: Arm, t: float, side: int) -> list[list[Any]]:
    """Joint states (3, J) by laws or by a table."""
    if isinstance(asked, TableTask):
        states = [exact.spline(tuple(asked.t), tuple(q))(mpf(t)) for q in asked.q]
        return [list(each) for each in zip(*states, strict=True)]
    moves = [next(move for move in asked.moves if move.name == joint.name) for joint in arm.joints]
    ways = [mpf(move.end) - mpf(move.start) for move in moves]
    laws = [exact.quickest(abs(way), mpf(m.speed), mpf(m.acceleration)) for way, m in zip(ways, moves, strict=True)]
    whole = max(2 * each[0] + each[1] for each in laws)
    states = []
    for way, move, law in zip(ways, moves, laws, strict=True):
        a, own = mpf(move.acceleration), law
        if asked.together and way and 2 * law[0] + law[1] < whole * (1 - mpf(10) ** -12):
            uniform = mp.sqrt(whole**2 - 4 * abs(way) / a)
            own = ((whole - uniform) / 2, uniform, a * (whole - uniform) / 2)
        ends = 2 * own[0] + own[1]
        rests = t > ends * (1 + exact.NEAR) or (t > ends * (1 - exact.NEAR) and side > 0 and ends < whole)
        if not way or rests:
            states.append([mpf(move.end), mpf(0), mpf(0)])
            continue
        moved = exact.along(own, abs(way), a, mpf(t), side)
        sign = 1 if way > 0 else -1
        states.append([mpf(move.start) + sign * moved[0], sign * moved[1], sign * moved[2]])
    return [list(each) for each in zip(*states, strict=True)]


def _truth(task: ManipulatorTask, found: Manipulator, rows: np.ndarray) -> dict[str, tuple[Any, Any]]:
    """By key what is told and what is true."""
    told: dict[str, list[Any]] = defaultdict(list)
    true: dict[str, list[Any]] = defaultdict(list)
    arm = task.arm
    for k in rows.tolist():
        t, side = float(found.t[k]), int(found.side[k])
        if isinstance(task.motion, PathTask):
            way, hand = exact.gripper(task.motion, t, side)
            joints = exact.inverse(arm, hand)
            for name, one, other in zip("sva", found.way[:, k], way, strict=True):
                told[name].append(one)
                true[name].append(other)
        else:
            joints = _joints_of(task.motion, arm, t, side)
            hand = exact.direct(arm, joints)
        for order, name in enumerate(("place", "velocity", "acceleration")):
            told[name] += found.gripper[order, :, k].tolist()
            true[name] += hand[order]
        for j, joint in enumerate(arm.joints):
            for order, name in enumerate(joint[:3]):
                one, other = mpf(float(found.q[order, j, k])), joints[order][j]
                if joint.turns and order == 0:
                    other += 2 * mp.pi * mp.nint((one - other) / (2 * mp.pi))
                told[name].append(one)
                true[name].append(other)
    return {name: (told[name], true[name]) for name in told}


def _scales(found: Manipulator) -> dict[str, float]:
    """What errors are relative to: the largest values of all rows, of joints the sums of their terms."""
    p, q, arm = found.gripper, found.q, found.arm
    scales = {name: float(np.max(np.abs(p[k]))) for k, name in enumerate(("place", "velocity", "acceleration"))}
    scales |= {name: float(np.max(np.abs(row))) for name, row in zip("sva", found.way, strict=True)}
    flat = np.hypot(p[:, 0], p[:, 1]) if arm.spatial else np.abs(p[:, 0])
    (x, y), r = p[0, :2], flat[0]
    along = (x * p[1, 0] + y * p[1, 1]) / r if arm.spatial else p[1, 0]
    bend = (np.sum(p[1, :2] ** 2 + p[0, :2] * p[2, :2], axis=0) - along**2) / r if arm.spatial else p[2, 0]
    v, a = np.hypot(along, p[1, -1]), np.hypot(bend, p[2, -1])
    sizes: list[Any] = [(1.0, flat[1] / r, flat[2] / r + 2 * (flat[1] / r) ** 2)] if arm.spatial else []
    if arm.kind == "cylindrical":
        sizes.append((np.abs(p[0, -1] - arm.height) + abs(arm.height), np.abs(p[1, -1]), np.abs(p[2, -1])))
        sizes.append((r, flat[1], flat[2] + (flat[1] ** 2 / r if arm.spatial else 0.0)))
    elif arm.kind == "spherical":
        long = np.abs(q[0, -1])
        sizes += [(1.0, v / long, a / long + 2 * (v / long) ** 2), (long, v, a + v * v / long)]
    else:
        pull = a + arm.upper * q[1, -2] ** 2 + arm.forearm * q[1, -1] ** 2
        sine = np.abs(np.sin(q[0, -1] - q[0, -2]))
        sizes += [(1.0, v / (length * sine), pull / (length * sine)) for length in (arm.upper, arm.forearm)]
    for j, joint in enumerate(arm.joints):
        for order, name in enumerate(joint[:3]):
            scales[name] = max(float(np.max(sizes[j][order])), float(np.max(np.abs(q[order, j]))))
    return scales


def _held(make: Any, kinds: tuple[str, ...], scenes: int, group: Any) -> None:
    rng, pairs = np.random.default_rng(21), defaultdict(list)
    done = 0
    while done < scenes:
        task = make(rng, str(rng.choice(kinds)))
        try:
            found = solve_manipulator(task)
        except TmmError:
            continue
        done += 1
        with mp.workdps(50):
            scales = _scales(found)
            for name, (told, true) in _truth(task, found, _rows(rng, found)).items():
                worst = max(abs(mpf(float(one)) - other) for one, other in zip(told, true, strict=True))
                pairs[group(name)].append((found.error[name], float(worst / scales[name]) if scales[name] else 0.0))
    for name, each in pairs.items():
        assert_bounds(each, name, scenes=min(scenes, 200))


def _order(name: str) -> str:
    """All joints are judged together."""
    joints = [joint for each in (*JOINTS.values(), (BASE,)) for joint in each]
    return next((str(joint.index(name)) for joint in joints if name in joint[:3]), name)


def test_estimates() -> None:
    """Paths of all arms."""
    _held(random_path, KINDS, 30, _order)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("make", [random_path, random_laws, random_table])
def test_estimates_of_every_column(make: Any, kind: str) -> None:
    """Half of the arms turn on a base."""
    _held(make, (kind,), 480, str)
