"""Checks of where a load acts: on a stroke, between two angles, or between two positions."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.loads import loads
from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, tables
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.units import FULL_TURN, dimension_of
from tmmcalc.spec.values import amount

WINDOWS = ("stroke", "between", "positions")
TURN = 2 * math.pi
MOST_TURNS = 12  # of a cycle


def check_windows(outline: Outline) -> Iterator[Finding]:
    """A load acts always or in one window, which exists."""
    from tmmcalc.linkage.loadlaws import laws  # here: the checks of other rooms read this module, but no loads
    from tmmcalc.linkage.loadlaws.placed import Placed

    for path, load in loads(outline):
        windows = [window for window in WINDOWS if window in load]
        for window in windows[1:]:
            yield Finding(
                (*path, window),
                f"{' and '.join(windows)} together: a load acts in one window",
                "keep one of them, or write one [[loads]] for each",
            )
        key = next((key for key, law in laws().items() if key in load and not issubclass(law, Placed)), None)
        if key and windows:
            yield Finding(
                (*path, windows[0]),
                f"{windows[0]} together with {key}: a resistance against the velocity acts all the time",
                f"remove {windows[0]}",
            )
        if "output" in load and "stroke" not in load:
            yield Finding((*path, "output"), "output without stroke: it tells whose stroke is meant", "remove it")
        yield from check_output(outline, load.get("output"), (*path, "output"))
        yield from _check_between(outline, load.get("between"), (*path, "between"))
        yield from _check_positions(outline, load.get("positions"), (*path, "positions"))
        if "period" in load:
            yield from _check_period(outline, load, path, always=key)


def _check_period(outline: Outline, load: Raw, path: Path, always: str | None) -> Iterator[Finding]:
    """Only what has its place in the cycle comes back after several turns; tables have a period of their own."""
    at = (*path, "period")
    own = next((key for key in ("table", "indicator") if key in load), None)
    placed = "between" in load or "positions" in load
    if always is not None:
        yield Finding(
            at, f"period together with {always}: a resistance against the velocity acts all the time", "remove it"
        )
    elif written_linkage(outline).slides:
        yield Finding(at, "period with a driven slider: only crank angles repeat", "remove it")
    elif own is not None:
        of_table = "write it there, [loads.table]" if own == "table" else "remove it"
        yield Finding(at, f"period beside {own}: the {own} tells when the load repeats", of_table)
    elif "stroke" in load:
        said = "period together with stroke: every stroke comes back each turn"
        yield Finding(at, said, 'name the angles of the one that is meant: between = ["360 deg", "540 deg"]')
    elif not placed and "polynomial" not in load:
        yield Finding(at, "period without a window: a constant load has none", "add between = [...], or remove period")
    else:
        yield from check_turns(load["period"], at)


def check_turns(value: object, path: Path) -> Iterator[Finding]:
    """A period is a whole number of turns, and not too many."""
    turns = (amount(value, "angle") or TURN) / TURN
    if abs(turns - round(turns)) > 1e-9 or round(turns) < 1:
        said = f"{show(value)} is not a whole number of turns"
        yield Finding(path, said, 'write "720 deg" for a four-stroke engine')
    elif round(turns) > MOST_TURNS:
        said = f"{show(value)} are {round(turns)} turns; a cycle has up to {MOST_TURNS}"
        yield Finding(path, said, 'write "720 deg" for a four-stroke engine')


def check_output(outline: Outline, name: object, path: Path) -> Iterator[Finding]:
    """An output of this name is listed."""
    known = [name for name, _ in outputs(outline)]
    if isinstance(name, str) and name not in known:
        guess = did_you_mean(name, known)
        remedy = f"the outputs are: {listing(known)}" if known else "add it: [[mechanism.outputs]]"
        yield Finding(path, f"there is no output {show(name)}", f"{guess} {remedy}".strip())


def outputs(outline: Outline) -> list[tuple[str, Raw]]:
    """Return the outputs by name: their own, or that of the point, the link or the joint."""
    named = [
        (next((str(output[key]) for key in ("name", "point", "link", "joint") if key in output), ""), output)
        for _, output in tables(written_linkage(outline).table, "outputs")
    ]
    return [(name, output) for name, output in named if name]


def cycle(outline: Outline) -> float:
    """Return the angle after which all loads repeat: a turn, of a four-stroke engine two."""
    from tmmcalc.linkage.loadlaws import laws

    given = [(law, load) for _, load in loads(outline) for key, law in laws().items() if key in load]
    windows = (amount(load.get("period"), "angle") or 0.0 for _, load in loads(outline))
    return max([TURN, *(law.cycle(load) for law, load in given), *windows])


def turns_of_cycle(outline: Outline) -> int:
    """Return the whole turns of the cycle of all loads."""
    return max(1, round(cycle(outline) / TURN))


def travel(outline: Outline) -> str:
    """Return the dimension of the input's travel."""
    return "length" if written_linkage(outline).slides else "angle"


def check_travel(outline: Outline, value: object, limit: float, path: Path) -> Iterator[Finding]:
    """A distance along the motion has the dimension of the input, and lies within ``limit``."""
    linkage = written_linkage(outline)
    needed, written = travel(outline), dimension_of(value)
    number = amount(value, "angle", "length")  # a bare number as well, whatever its size
    if written in ("angle", "length") and written != needed and linkage.input_joint is not None:
        yield Finding(
            path,
            f'{show(value)} is {DIMENSIONS[written].noun}; the input joint "{linkage.input_joint.name}" is '
            f"{linkage.input_joint.kind}, so {DIMENSIONS[needed].noun} is needed",
            f'write {DIMENSIONS[needed].noun}, such as "{DIMENSIONS[needed].example}"',
        )
    elif number is not None and number > limit * (1 + 1e-12):
        yield beyond(value, number, limit, path)


def beyond(value: object, number: float, limit: float, path: Path) -> Finding:
    """Return the finding for an angle after the end of the cycle: perhaps degrees without their unit."""
    if not isinstance(value, str) and number > FULL_TURN:
        what = f"{show(value)} without a unit is in radians, more than the cycle of the loads"
        return Finding(path, what, f'write "{value} deg"')
    return Finding(
        path, f"{show(value)} is beyond the cycle of the loads, {math.degrees(limit):g} deg", "count from position 0"
    )


def _check_between(outline: Outline, pair: object, path: Path) -> Iterator[Finding]:
    linkage = written_linkage(outline)
    if not isinstance(pair, list) or len(pair) != 2:
        return
    limit = math.inf if linkage.slides else cycle(outline)
    for index, value in enumerate(pair):
        yield from check_travel(outline, value, limit, (*path, index))
    first, last = (amount(value, "angle", "length") for value in pair)
    if first is None or last is None:
        return
    if first == last:
        yield Finding(path, f"{show(pair)} begins where it ends", "write from and to; remove between for always")
    elif first > last and linkage.slides:
        yield Finding(
            path, f"{show(pair)} runs backwards: a driven slider passes each place once", "write from, then to"
        )


def _check_positions(outline: Outline, pair: object, path: Path) -> Iterator[Finding]:
    if not isinstance(pair, list) or len(pair) != 2:
        return
    steps, grid = grid_steps(outline), subtable(written_linkage(outline).table, "grid")
    steps = None if steps is None else steps * turns_of_cycle(outline)
    for index, label in enumerate(pair):
        digits = str(label).rstrip("'") if is_integer(label) or isinstance(label, str) else ""
        if steps is not None and digits.isdecimal() and len(digits) < 8 and int(digits) > steps:
            yield Finding(
                (*path, index), f"there is no position {label}", f"the positions are 0 to {steps} ([mechanism.grid])"
            )
        elif isinstance(label, str) and label.endswith("'") and not (grid.get("extra") or grid.get("extremes")):
            yield Finding(
                (*path, index),
                f"there is no position {label}: the grid has no added positions",
                "add extra = [...] or extremes = true to [mechanism.grid]",
            )
    if str(pair[0]) == str(pair[1]):
        yield Finding(path, f"{show(pair)} begins where it ends", "write from and to; remove positions for always")


def grid_steps(outline: Outline) -> int | None:
    """Return the number of steps of the grid, which is the number of its last position."""
    grid = subtable(written_linkage(outline).table, "grid")
    strokes = [grid[key] for key in ("working", "idle") if key in grid]
    parts = strokes or [grid.get("positions", 24)]
    return sum(parts) if all(map(is_integer, parts)) else None
