"""Checks of ``[manipulator]``: one motion with the keys that it needs, one kind of arm."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.manipulators.tables.checks.written import ARM_JOINTS, ROOT, written_manipulator
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, word
from tmmcalc.spec.phrases import show
from tmmcalc.spec.values import amount

_MOTIONS = ("path", "joints", "motion")
_OF_PATH = ("speed", "acceleration", "normal_acceleration", "total_acceleration", "duration")


def check_motion(outline: Outline) -> Iterator[Finding]:
    """A manipulator has one motion: a path, laws of the joints, or a table of them."""
    table = written_manipulator(outline)
    given = [key for key in _MOTIONS if key in table]
    if not given:
        rule = "missing key: the gripper has neither a path nor joints that move it"
        remedy = "add [manipulator.path], [manipulator.joints] or [manipulator.motion]"
        yield Finding((ROOT,), rule, remedy)
    for key in given[1:]:
        yield Finding((ROOT, key), f"{key} together with {given[0]}: there is one motion", "remove one of them")
    if "path" not in given and given:
        for key in _OF_PATH:
            if key in table:
                rule = f"{key} is that of the gripper along a path; there is none"
                yield Finding((ROOT, key), rule, f"remove it; joints have their own, in [manipulator.{given[0]}]")
    if "path" in given:
        if "acceleration" not in table:
            rule = "missing key: the largest tangential acceleration is needed"
            yield Finding((ROOT,), rule, 'add acceleration = "2 m/s^2"')
        if not {"speed", "duration", "normal_acceleration", "total_acceleration"} & {*table}:
            rule = "missing key: neither a largest speed nor a duration is given"
            yield Finding((ROOT,), rule, 'add speed = "0.6 m/s"')


def check_arm(outline: Outline) -> Iterator[Finding]:
    """Two links have their lengths, and an elbow."""
    table = written_manipulator(outline)
    kind, keys = word(table, "arm"), ("upper_arm", "forearm")
    if kind == "angular":
        for key in keys:
            if key not in table:
                yield Finding((ROOT,), f"missing key: an angular arm has its {key}", f'add {key} = "0.8 m"')
        if "elbow" in table and "path" not in table and any(key in table for key in _MOTIONS):
            rule = "elbow has no effect: the joints are given, and their directions settle it"
            yield Finding((ROOT, "elbow"), rule, "remove it")
    elif kind in ARM_JOINTS:
        for key in (*keys, "elbow"):
            if key in table:
                yield Finding((ROOT, key), f"{key} belongs to an angular arm, this one is {kind}", "remove it")


def check_accelerations(outline: Outline) -> Iterator[Finding]:
    """The total acceleration leaves something beside the tangential one."""
    table = written_manipulator(outline)
    total, own = (amount(table.get(key), "acceleration") for key in ("total_acceleration", "acceleration"))
    if total is not None and own is not None and 0 < total < own:
        rule = f"{show(table['total_acceleration'])} is less than the tangential acceleration alone"
        yield Finding((ROOT, "total_acceleration"), rule, "write a larger one, or a smaller acceleration")


CHECKS = (check_motion, check_arm, check_accelerations)
