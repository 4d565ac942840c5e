"""Checks of ``[manipulator]``: one motion, the keys of its kind of arm and path, joints that the arm has."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import Path, either, listing, show
from tmmcalc.spec.units import DIMENSIONS, dimension_of

from .outline import Outline, Raw, subtable, tables, word
from .values import amount, amounts, first_disorder

_ROOT = "manipulator"
_MOTIONS = ("path", "joints", "motion")
_ARM_JOINTS = {"spherical": ("phi_2", "l_3"), "cylindrical": ("h", "r"), "angular": ("phi_2", "phi_3")}
_LENGTHS = ("l_3", "h", "r")
_OF_PATH = ("speed", "acceleration", "normal_acceleration", "total_acceleration", "duration")
_KEYS = {
    "arc": ("start", "end", "radius", "side", "via", "normal"),
    "line": ("start", "end"),
    "polyline": ("points", "corner_radius"),
}
_NEAR = 1e-12


def check_motion(outline: Outline) -> Iterator[Finding]:
    """A manipulator has one motion: a path, laws of the joints, or a table of them."""
    table = _table(outline)
    given = [key for key in _MOTIONS if key in table]
    if not given:
        rule = "missing key: the gripper has neither a path nor joints that move it"
        remedy = "add [manipulator.path], [manipulator.joints] or [manipulator.motion]"
        yield Finding((_ROOT,), rule, remedy)
    for key in given[1:]:
        yield Finding((_ROOT, key), f"{key} together with {given[0]}: there is one motion", "remove one of them")
    if "path" not in given and given:
        for key in _OF_PATH:
            if key in table:
                rule = f"{key} is that of the gripper along a path; there is none"
                yield Finding((_ROOT, key), rule, f"remove it; joints have their own, in [manipulator.{given[0]}]")
    if "path" in given:
        if "acceleration" not in table:
            rule = "missing key: the largest tangential acceleration is needed"
            yield Finding((_ROOT,), rule, 'add acceleration = "2 m/s^2"')
        if not {"speed", "duration", "normal_acceleration", "total_acceleration"} & {*table}:
            rule = "missing key: neither a largest speed nor a duration is given"
            yield Finding((_ROOT,), rule, 'add speed = "0.6 m/s"')


def check_arm(outline: Outline) -> Iterator[Finding]:
    """Two links have their lengths, and an elbow."""
    table = _table(outline)
    kind, keys = word(table, "arm"), ("upper_arm", "forearm")
    if kind == "angular":
        for key in keys:
            if key not in table:
                yield Finding((_ROOT,), f"missing key: an angular arm has its {key}", f'add {key} = "0.8 m"')
    elif kind in _ARM_JOINTS:
        for key in (*keys, "elbow"):
            if key in table:
                yield Finding((_ROOT, key), f"{key} belongs to an angular arm, this one is {kind}", "remove it")


def check_path(outline: Outline) -> Iterator[Finding]:
    """A path has the keys of its kind, and points of as many coordinates."""
    path = subtable(_table(outline), "path")
    kind = word(path, "kind")
    if kind not in _KEYS:
        return
    at = (_ROOT, "path")
    for key in path:
        owners = [other for other in _KEYS if key in _KEYS[other]]
        if owners and kind not in owners:
            yield Finding((*at, key), f"{key} belongs to {either(owners)}, this path is {kind}", "remove it")
    needed = {"arc": ("start", "end"), "line": ("start", "end"), "polyline": ("points",)}[kind]
    for key in needed:
        if key not in path:
            yield Finding(
                at,
                f"missing key: {kind} has {key}",
                f"add {key} = {'[[0, 0], [1, 1]]' if key == 'points' else '[1.2, 0.3]'}",
            )
    if kind == "arc":
        yield from _check_arc(path, at)
    yield from _check_coordinates(path, at)


def _check_arc(path: Raw, at: Path) -> Iterator[Finding]:
    """An arc is given once, and its radius spans the distance of its ends."""
    sized = [key for key in ("radius", "side") if key in path]
    if "via" in path:
        for key in (*sized, *(["normal"] if "normal" in path else [])):
            yield Finding((*at, key), f"{key} together with via: three points settle the arc", "remove one of them")
        return
    for key, example in (("radius", '"0.8 m"'), ("side", '"left"')):
        if key not in path:
            yield Finding(at, "missing key: an arc has radius and side, or via", f"add {key} = {example}")
            return
    radius, start, end = (
        amount(path["radius"], "length"),
        amounts(path.get("start"), "length"),
        amounts(path.get("end"), "length"),
    )
    if radius is None or start is None or end is None or len(start) != len(end):
        return
    half = math.dist(start, end) / 2
    if half == 0:
        yield Finding((*at, "end"), "the arc ends where it begins", "write another point")
    elif radius < half * (1 - _NEAR):
        rule = f"{show(path['radius'])} does not span the ends of the arc, which are {2 * half:.9g} m apart"
        yield Finding((*at, "radius"), rule, f'write at least "{math.ceil(half * 1e6) / 1e6:.9g} m"')


def _check_coordinates(path: Raw, at: Path) -> Iterator[Finding]:
    """All points have two coordinates, or all have three."""
    points = [((*at, key), path[key]) for key in ("start", "via", "end") if key in path]
    listed = path.get("points")
    points += [((*at, "points", k), point) for k, point in enumerate(listed if isinstance(listed, list) else ())]
    counts = [(where, len(point)) for where, point in points if isinstance(point, list)]
    for where, count in counts[1:]:
        if count != counts[0][1]:
            rule = f"{count} coordinates, and the first point has {counts[0][1]}"
            yield Finding(where, rule, "write [x, y] everywhere, or [x, y, z] for an arm with a turning base")
    if counts and counts[0][1] == 2 and "normal" in path:
        yield Finding((*at, "normal"), "normal has no effect: the path lies in the arm's plane", "remove it")


def check_accelerations(outline: Outline) -> Iterator[Finding]:
    """The total acceleration leaves something beside the tangential one."""
    table = _table(outline)
    total, own = (amount(table.get(key), "acceleration") for key in ("total_acceleration", "acceleration"))
    if total is not None and own is not None and 0 < total < own:
        rule = f"{show(table['total_acceleration'])} is less than the tangential acceleration alone"
        yield Finding((_ROOT, "total_acceleration"), rule, "write a larger one, or a smaller acceleration")


def check_joints(outline: Outline) -> Iterator[Finding]:
    """Joints and limits are those of the arm, and their quantities lengths or angles as they are."""
    table = _table(outline)
    own = _ARM_JOINTS.get(word(table, "arm"))
    if own is None:
        return
    spatial = _spatial(table)
    for key in ("joints", "motion"):
        part = subtable(table, key)
        if key not in table or not isinstance(table[key], dict):
            continue
        for name in own:
            if name not in part:
                yield Finding((_ROOT, key), f"missing key: this arm has the joint {name}", f"add {name}")
        yield from _check_named(part, (_ROOT, key), ("psi", *own), {"together", "t"})
    extra = ("elbow",) if table.get("arm") == "angular" else ()
    yield from _check_named(
        subtable(table, "limits"), (_ROOT, "limits"), (*(("psi",) if spatial else ()), *own, *extra), set()
    )


def _check_named(part: Raw, at: Path, known: tuple[str, ...], others: set[str]) -> Iterator[Finding]:
    every = {"psi", "elbow", *(name for names in _ARM_JOINTS.values() for name in names)}
    for name, value in part.items():
        if name in others or name not in every:
            continue
        if name not in known:
            yield Finding((*at, name), f"this arm has no joint {name}", f"its joints: {listing(known)}")
            continue
        wanted = (
            ("length", "speed", "acceleration")
            if name in _LENGTHS
            else ("angle", "angular speed", "angular acceleration")
        )
        for place, each, dimension in _values(value, (*at, name), wanted):
            written = dimension_of(each)
            if (
                written in {"length", "angle", "speed", "angular speed", "acceleration", "angular acceleration"}
                and written != dimension
            ):
                noun, example = DIMENSIONS[dimension].noun, DIMENSIONS[dimension].example
                yield Finding(
                    place,
                    f"{show(each)} is {DIMENSIONS[written].noun}; {name} needs {noun}",
                    f'write "{example}", for example',
                )


def _values(value: object, at: Path, wanted: tuple[str, str, str]) -> Iterator[tuple[Path, object, str]]:
    """All quantities of a joint: of a list, or of a table with its ends and limits."""
    if isinstance(value, list):
        yield from (((*at, k), each, wanted[0]) for k, each in enumerate(value))
    elif isinstance(value, dict):
        keys = {"from": wanted[0], "to": wanted[0], "speed": wanted[1], "acceleration": wanted[2]}
        yield from (((*at, key), value[key], keys[key]) for key in keys if key in value)


def check_moves(outline: Outline) -> Iterator[Finding]:
    """A joint that moves has its limits; rows of a table are as many as its times, which ascend."""
    table = _table(outline)
    for name, joint in subtable(table, "joints").items():
        if (
            isinstance(joint, dict)
            and "to" in joint
            and amount(joint["to"], "length", "angle") != amount(joint.get("from"), "length", "angle")
        ):
            for key in ("speed", "acceleration"):
                if key not in joint:
                    rule = f"missing key: the joint moves, and has no largest {key}"
                    yield Finding((_ROOT, "joints", name), rule, f"add {key}")
    motion = subtable(table, "motion")
    times = amounts(motion.get("t"), "time")
    if times is None:
        return
    disorder = first_disorder(times)
    if disorder is not None:
        rule = f"{show(motion['t'][disorder])} does not come after {show(motion['t'][disorder - 1])}; times ascend"
        yield Finding((_ROOT, "motion", "t", disorder), rule, "put the rows in order")
    for name, rows in motion.items():
        if name != "t" and isinstance(rows, list) and len(rows) != len(times):
            rule = f"{len(rows)} values for {len(times)} times"
            yield Finding((_ROOT, "motion", name), rule, "write one value for each time")


def check_limits(outline: Outline) -> Iterator[Finding]:
    """The lower limit of a joint comes first."""
    for name, pair in subtable(_table(outline), "limits").items():
        numbers = amounts(pair, "length", "angle")
        if numbers is not None and len(numbers) == 2 and not numbers[0] < numbers[1]:
            rule = f"{show(pair)}: the first is not below the second"
            yield Finding((_ROOT, "limits", name), rule, "write [lowest, highest]")


def check_obstacles(outline: Outline) -> Iterator[Finding]:
    """An obstacle has an outline with an area, and heights where the base turns."""
    table = _table(outline)
    spatial = _spatial(table)
    for k, obstacle in tables(table, "obstacles"):
        at = (_ROOT, "obstacles", k)
        if ("corners" in obstacle) == ("box" in obstacle):
            rule = "corners together with box" if "box" in obstacle else "missing key: an obstacle has corners or a box"
            yield Finding(at, rule, "write corners = [[x, y], ...], or box with two opposite corners")
        yield from _check_heights(obstacle, at, spatial)
        corners = obstacle.get("box", obstacle.get("corners"))
        points = [amounts(point, "length") for point in corners] if isinstance(corners, list) else []
        flat = [complex(*point) for point in points if point is not None and len(point) == 2]
        if len(flat) == len(points) and _empty(flat, "box" in obstacle):
            key = "box" if "box" in obstacle else "corners"
            yield Finding((*at, key), "the obstacle has no area", "write corners that are not on one line")


def _check_heights(obstacle: Raw, at: Path, spatial: bool) -> Iterator[Finding]:
    for key in ("low", "high"):
        if spatial and key not in obstacle:
            yield Finding(at, f"missing key: with a turning base an obstacle has {key}", f'add {key} = "0.5 m"')
        if not spatial and key in obstacle:
            yield Finding(
                (*at, key), f"{key} has no effect: without a turning base the polygon is upright", "remove it"
            )
    low, high = (amount(obstacle.get(key), "length") for key in ("low", "high"))
    if spatial and low is not None and high is not None and not low < high:
        yield Finding((*at, "high"), f"{show(obstacle['high'])} is not above low", "write a greater height")


def _empty(corners: list[complex], box: bool) -> bool:
    if box:
        return len(corners) == 2 and ((corners[1] - corners[0]).real == 0 or (corners[1] - corners[0]).imag == 0)
    if len(corners) < 3:
        return False
    around = [*corners[1:], corners[0]]
    area = sum((a.conjugate() * b).imag for a, b in zip(corners, around, strict=True))
    size = max(abs(corner - corners[0]) for corner in corners)
    return abs(area) <= _NEAR * size * size


def _spatial(table: Raw) -> bool:
    """Whether the base turns."""
    path = subtable(table, "path")
    listed = path.get("points")
    first = path.get("start", listed[0] if isinstance(listed, list) and listed else None)
    if isinstance(first, list):
        return len(first) == 3
    return any("psi" in subtable(table, key) for key in ("joints", "motion"))


def _table(outline: Outline) -> Raw:
    return subtable(outline.document, _ROOT)


CHECKS = (
    check_motion,
    check_arm,
    check_path,
    check_accelerations,
    check_joints,
    check_moves,
    check_limits,
    check_obstacles,
)
