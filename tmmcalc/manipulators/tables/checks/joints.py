"""Checks of the joints in ``[manipulator]``: those that the arm has, their quantities, their rows and ranges."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.manipulators.tables.checks.written import ARM_JOINTS, ROOT, turns_base, written_manipulator
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, word
from tmmcalc.spec.phrases import Path, listing, show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.values import amount, amounts, first_disorder

_LENGTHS = ("l_3", "h", "r")


def check_joints(outline: Outline) -> Iterator[Finding]:
    """Joints and limits are those of the arm, and their quantities lengths or angles as they are."""
    table = written_manipulator(outline)
    own = ARM_JOINTS.get(word(table, "arm"))
    if own is None:
        return
    spatial = turns_base(table)
    for key in ("joints", "motion"):
        part = subtable(table, key)
        if key not in table or not isinstance(table[key], dict):
            continue
        for name in own:
            if name not in part:
                yield Finding((ROOT, key), f"missing key: this arm has the joint {name}", f"add {name}")
        yield from _check_named(part, (ROOT, key), ("psi", *own), {"together", "t"})
    extra = ("elbow",) if table.get("arm") == "angular" else ()
    yield from _check_named(
        subtable(table, "limits"), (ROOT, "limits"), (*(("psi",) if spatial else ()), *own, *extra), set()
    )


def _check_named(part: Raw, at: Path, known: tuple[str, ...], others: set[str]) -> Iterator[Finding]:
    every = {"psi", "elbow", *(name for names in ARM_JOINTS.values() for name in names)}
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
    table = written_manipulator(outline)
    for name, joint in subtable(table, "joints").items():
        if (
            isinstance(joint, dict)
            and "to" in joint
            and amount(joint["to"], "length", "angle") != amount(joint.get("from"), "length", "angle")
        ):
            for key in ("speed", "acceleration"):
                if key not in joint:
                    rule = f"missing key: the joint moves, and has no largest {key}"
                    yield Finding((ROOT, "joints", name), rule, f"add {key}")
    motion = subtable(table, "motion")
    times = amounts(motion.get("t"), "time")
    if times is None:
        return
    disorder = first_disorder(times)
    if disorder is not None:
        rule = f"{show(motion['t'][disorder])} does not come after {show(motion['t'][disorder - 1])}; times ascend"
        yield Finding((ROOT, "motion", "t", disorder), rule, "put the rows in order")
    for name, rows in motion.items():
        if name != "t" and isinstance(rows, list) and len(rows) != len(times):
            rule = f"{len(rows)} values for {len(times)} times"
            yield Finding((ROOT, "motion", name), rule, "write one value for each time")


def check_limits(outline: Outline) -> Iterator[Finding]:
    """The lower limit of a joint comes first."""
    for name, pair in subtable(written_manipulator(outline), "limits").items():
        numbers = amounts(pair, "length", "angle")
        if numbers is not None and len(numbers) == 2 and not numbers[0] < numbers[1]:
            rule = f"{show(pair)}: the first is not below the second"
            yield Finding((ROOT, "limits", name), rule, "write [lowest, highest]")


CHECKS = (check_joints, check_moves, check_limits)
