"""Checks of the input and of the positions: ``[mechanism.input]``, ``[mechanism.grid]`` and ``assembly.at``.

The input joint decides what its quantities are: angles and angular speeds, or lengths and speeds.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TypeGuard

from tmmcalc.linkage.tables.checks.written_linkage import FRAME, WrittenJoint, WrittenLinkage, written_linkage
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, is_integer, subtable, tables
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.quantities import BY_MOTOR, CLOCKWISE
from tmmcalc.spec.units import FULL_TURN, UnitError, dimension_of, parse

_INPUT = ("mechanism", "input")
LARGEST = 2 * 10**9  # bytes that one computation may take
MOST = 4_000_000  # positions of any linkage, as the table says
PER_PART = 250  # bytes for each position and each link or joint: motions, forces, their copies and tables
_GRID = ("mechanism", "grid")

# Dimension of each derivative of the input coordinate, by the kind of the input joint.
_COORDINATE = {"revolute": "angle", "prismatic": "length"}
_SPEED = {"revolute": "angular speed", "prismatic": "speed"}
_ACCELERATION = {"revolute": "angular acceleration", "prismatic": "acceleration"}


def check_joint(outline: Outline) -> Iterator[Finding]:
    """The input joint exists and is with the frame; a prismatic one may join two moving links: a driven length."""
    linkage = written_linkage(outline)
    name = subtable(linkage.table, "input").get("joint")
    if not isinstance(name, str) or not linkage.joints:
        return
    joint = linkage.joint_named(name)
    fit = [str(j.name) for j in linkage.joints if j.name and j.links and (FRAME in j.links or j.kind == "prismatic")]
    known = f"the joints that can be driven are: {listing(fit)}"
    if joint is None:
        guess = did_you_mean(name, fit)
        yield Finding((*_INPUT, "joint"), f"there is no joint {show(name)}", f"{guess} {known}".strip())
    elif joint.links and FRAME not in joint.links and joint.kind == "revolute":
        yield Finding(
            (*_INPUT, "joint"),
            f"joint {show(name)} is a pin of links {joint.links[0]} and {joint.links[1]}, neither is the frame: "
            "a crank turns about the frame",
            known,
        )


_WITHOUT_SPEED = {
    "project",
    "mechanism",
    "unsteady",
    "paths",
    "optimize",
    "tolerances",
}  # tables that read no speed of the input
_UNHURRIED = {"structure", "paths"}  # stages whose results no speed changes; constraints on others may be on velocities


def check_speed(outline: Outline) -> Iterator[Finding]:
    """The input has its mean speed where forces, power or a motor depend on it; transfer functions do not."""
    table = written_linkage(outline).table
    given = subtable(table, "input")
    if not given or "speed" in given:
        return
    loaded = any("mass" in link or "inertia" in link for _, link in tables(table, "links"))
    others = {*outline.document} - _WITHOUT_SPEED
    if all(constraint.get("stage") in _UNHURRIED for _, constraint in tables(outline.document, "constraints")):
        others.discard("constraints")
    if loaded or others or "acceleration" in given:
        yield Finding((*_INPUT, "speed"), "missing key: the input needs its mean speed", 'add speed = "55 rpm"')


def check_dimensions(outline: Outline) -> Iterator[Finding]:
    """The quantities of the input have the dimensions of its joint."""
    joint = written_linkage(outline).input_joint
    if joint is None or joint.kind not in _COORDINATE:
        return
    for path, value, dimension in _quantities(outline, joint.kind):
        yield from _check_dimension(joint, path, value, dimension)


def check_coordinate(outline: Outline, value: object, path: Path) -> Iterator[Finding]:
    """An input coordinate in another table has the dimension of the input joint, too."""
    joint = written_linkage(outline).input_joint
    if joint is not None and joint.kind in _COORDINATE:
        yield from _check_dimension(joint, path, value, _COORDINATE[joint.kind])


def _check_dimension(joint: WrittenJoint, path: Path, value: object, dimension: str) -> Iterator[Finding]:
    written = dimension_of(value)
    if _is_disguised(value, dimension):
        yield Finding(
            path,
            f"{show(value)} without a unit is in radians, more than a full turn",
            f'write "{value:g} deg"',
        )
    # Any other dimension is a fault whatever the joint, and is reported with the tables.
    if written != dimension and written in _others(dimension):
        needed, example = DIMENSIONS[dimension].noun, DIMENSIONS[dimension].example
        yield Finding(
            path,
            f'{show(value)} is {DIMENSIONS[written].noun}; the input joint "{joint.name}" is '
            f"{joint.kind}, so {needed} is needed",
            f'write {needed}, such as "{example}"',
        )


def _quantities(outline: Outline, kind: str) -> Iterator[tuple[Path, object, str]]:
    linkage = written_linkage(outline)
    motion, grid = subtable(linkage.table, "input"), subtable(linkage.table, "grid")
    yield (*_INPUT, "speed"), motion.get("speed"), _SPEED[kind]
    yield (*_INPUT, "acceleration"), motion.get("acceleration"), _ACCELERATION[kind]
    yield (*_INPUT, "start"), motion.get("start"), _COORDINATE[kind]
    yield (*_GRID, "span"), grid.get("span"), _COORDINATE[kind]
    extra = grid.get("extra")
    for index, value in enumerate(extra if isinstance(extra, list) else ()):
        yield (*_GRID, "extra", index), value, _COORDINATE[kind]
    at = subtable(linkage.table, "assembly").get("at")
    yield ("mechanism", "assembly", "at"), at, _COORDINATE[kind]


def _is_disguised(value: object, dimension: str) -> TypeGuard[float]:
    """Whether a bare number, in radians, is so large that degrees were meant."""
    if dimension != "angle" or isinstance(value, bool):
        return False
    return isinstance(value, int | float) and abs(value) > FULL_TURN


def _others(dimension: str) -> set[str]:
    """Return the dimension that the same field has for the other kind of joint, with its own."""
    return next({*pair.values()} for pair in (_COORDINATE, _SPEED, _ACCELERATION) if dimension in pair.values())


def check_followed(outline: Outline) -> Iterator[Finding]:
    """A speed by the motor is that of a crank."""
    linkage = written_linkage(outline)
    path = (*_INPUT, "speed")
    if subtable(linkage.table, "input").get("speed") not in (BY_MOTOR, CLOCKWISE):
        return
    if linkage.slides:
        yield Finding(path, f'"{BY_MOTOR}" of a driven slider: a motor turns a crank', 'write its speed: "0.2 m/s"')
        return
    yield from followed_speed(outline, path)


def followed_speed(outline: Outline, path: Path) -> Iterator[Finding]:
    """A speed by the motor has a motor that is given, and a ratio that does not hang on the speed."""
    document = outline.document
    motor, train = subtable(document, "motor"), subtable(document, "train")
    if not motor:
        yield Finding(path, f'"{BY_MOTOR}" without [motor]', 'add [motor], or write the speed: "55 rpm"')
    elif motor.get("name") == "choose":
        rule = f'"{BY_MOTOR}" together with a motor that is chosen: the choice asks for the speed'
        yield Finding(path, rule, 'give the motor by its name, or write the speed: "55 rpm"')
    of_train = "ratio" in train or {"input_speed", "output_speed"} <= {*train}
    if not ("ratio" in subtable(document, "transmission") or "shafts" in document or of_train):
        rule = f'"{BY_MOTOR}" without a ratio: it would follow from the speed'
        remedy = 'add ratio to [transmission] or [train], or write the speed: "55 rpm"'
        yield Finding(path, rule, remedy)


def check_prismatic_input(outline: Outline) -> Iterator[Finding]:
    """A sliding input has no full turn and no dead centre to start from: it needs a span and a start."""
    linkage = written_linkage(outline)
    joint = linkage.input_joint
    if joint is None or joint.kind != "prismatic":
        return
    motion, grid = subtable(linkage.table, "input"), subtable(linkage.table, "grid")
    name = f'the input joint "{joint.name}" is prismatic'
    if "span" not in grid and not {"working", "idle"} & {*grid}:
        yield Finding((*_GRID, "span"), f"missing key: {name}, so the grid needs a span", 'add span = "200 mm"')
    if motion.get("start", "extreme") == "extreme":
        written = 'start is "extreme"' if "start" in motion else "missing key"
        yield Finding((*_INPUT, "start"), f"{written}: {name} and starts from a coordinate", 'write start = "0 mm"')
    for key in ("working", "idle"):
        if key in grid:
            yield Finding(
                (*_GRID, key),
                f"{name}; working and idle strokes are counted over a turn",
                "write positions and span instead",
            )


def check_grid(outline: Outline) -> Iterator[Finding]:
    """Positions are counted over a span, or over the working and the idle stroke."""
    linkage = written_linkage(outline)
    grid = subtable(linkage.table, "grid")
    strokes = [key for key in ("working", "idle") if key in grid]
    if len(strokes) == 1:
        other = "idle" if strokes == ["working"] else "working"
        yield Finding(
            (*_GRID, strokes[0]),
            f"{strokes[0]} without {other}: the two strokes have each a number of steps",
            f"add {other} = 8, or write positions = 24 instead",
        )
    start = subtable(linkage.table, "input").get("start", "extreme")
    joint = linkage.input_joint
    if strokes and start != "extreme" and not (joint and joint.kind == "prismatic"):
        yield Finding(
            (*_INPUT, "start"),
            f"start = {show(start)} together with {' and '.join(strokes)}: the working stroke begins at a dead centre",
            'write start = "extreme", or positions in place of working and idle',
        )
    for key in ("positions", "span"):
        if strokes and key in grid:
            yield Finding(
                (*_GRID, key),
                f"{key} together with {' and '.join(strokes)}: there is one way to divide the turn",
                f"remove {key}, or remove {' and '.join(strokes)}",
            )
    yield from _check_size(linkage, strokes or ["positions"])


def _check_size(linkage: WrittenLinkage, keys: Sequence[str]) -> Iterator[Finding]:
    """All that is computed at the positions has room in the memory of an ordinary computer."""
    grid = subtable(linkage.table, "grid")
    counts = [grid[key] for key in keys if is_integer(grid.get(key)) and grid[key] <= MOST]  # more have their fault
    parts = sum(len(listed) for key in ("links", "joints") if isinstance(listed := linkage.table.get(key), list))
    most = LARGEST // (PER_PART * max(parts, 1))
    if sum(counts) > most:
        yield Finding(
            (*_GRID, keys[0]),
            f"{sum(counts)} positions of {parts} links and joints take more memory than {LARGEST // 10**9} GB",
            f"write {most} or less: results between the positions are as exact with few of them",
        )


def check_reach(outline: Outline) -> Iterator[Finding]:
    """A crank is analysed over one turn at most, and extra positions lie within the span."""
    linkage = written_linkage(outline)
    joint = linkage.input_joint
    if joint is None or joint.kind not in _COORDINATE:
        return
    grid, dimension = subtable(linkage.table, "grid"), _COORDINATE[joint.kind]
    turn = 2 * math.pi * (1 + 1e-12) if joint.kind == "revolute" else math.inf
    span = _number(grid.get("span"), dimension, turn)
    if span > turn and not _is_disguised(grid["span"], dimension):
        yield Finding(
            (*_GRID, "span"),
            f"{show(grid['span'])} is more than one turn; the positions of a crank repeat after 360 deg",
            'write at most "360 deg", or remove span for a full turn',
        )
    extra = grid.get("extra")
    for index, value in enumerate(extra if isinstance(extra, list) else ()):
        if _number(value, dimension, 0.0) > min(span, turn) and not _is_disguised(value, dimension):
            yield Finding(
                (*_GRID, "extra", index),
                f"{show(value)} lies beyond the span of {show(grid.get('span', '360 deg'))}",
                "write a distance from position 0 within the span",
            )


def _number(value: object, dimension: str, otherwise: float) -> float:
    """The quantity in SI; ``otherwise`` if it is absent or faulty, which the tables report."""
    if value is None:
        return otherwise
    try:
        return parse(value, dimension)
    except UnitError:
        return otherwise
