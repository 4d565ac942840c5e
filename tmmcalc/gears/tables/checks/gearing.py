"""Checks of ``[gearing]``: meshes or a layout, members that are there, a motion that is determined.

The motion is looked at last, and only where nothing else is at fault: one slip in a name would make several.
"""

from __future__ import annotations

from collections.abc import Iterator

from pydantic import ValidationError

from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.network.model import FRAME
from tmmcalc.gears.scheme import CARRIER, Layout
from tmmcalc.gears.tables.checks.gearing_members import (
    bearers_of,
    check_axes,
    check_members,
    check_meshes,
    meshed,
    name_of,
)
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, word
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.values import amount, check_bare_speed

_OF_LAYOUT = ("teeth", "planets", "sharing")
_OF_MESHES = ("meshes", "members")
_BY_MEMBER = ("speeds", "torques", "load", "powers")
_LOADS = ("torques", "load", "powers")


def check_gearing(outline: Outline) -> Iterator[Finding]:
    """All faults of the table; what rests on what is faulty is not looked at."""
    gearing = subtable(outline.document, "gearing")
    if form := [*_check_form(gearing)]:
        yield from form
        return
    members = [*check_members(gearing)]
    meshes = [*check_meshes(gearing), *([] if members else check_axes(gearing))]
    found = [*_check_layout(gearing), *members, *meshes, *_check_names(gearing), *_check_known(gearing)]
    yield from found if found else _check_motion(gearing)


def _scheme(gearing: Raw) -> Layout | None:
    return LAYOUTS.get(word(gearing, "layout"))


def _check_form(gearing: Raw) -> Iterator[Finding]:
    """A train has meshes, or a layout, and the keys of that form."""
    if "layout" not in gearing and gearing.get("meshes", []) == []:
        rule = "missing key: a gearing has its meshes, or a layout with its teeth"
        yield Finding(("gearing",), rule, 'add [[gearing.meshes]], or layout = "AI" and teeth = [22, 118, 17, 97]')
        return
    if "layout" in gearing:
        for key in _OF_MESHES:
            if key in gearing:
                rule = f"{key} together with layout: a layout has its meshes and members"
                yield Finding(("gearing", key), rule, f"remove {key}, or layout")
        return
    for key in _OF_LAYOUT:
        if key in gearing:
            where = "the meshes" if key == "teeth" else "[[gearing.members]]"
            yield Finding(("gearing", key), f"{key} belongs to a layout; without one it stands in {where}", "move it")
    if isinstance(gearing.get("efficiency"), list):
        rule = "a list of efficiencies belongs to a layout"
        yield Finding(("gearing", "efficiency"), rule, "write one for all, or efficiency in each of [[gearing.meshes]]")


def _check_layout(gearing: Raw) -> Iterator[Finding]:
    """Every wheel and every mesh of a layout has its number."""
    scheme = _scheme(gearing)
    if scheme is None:
        return
    teeth, wheels = gearing.get("teeth"), listing(scheme.wheels)
    if "teeth" not in gearing:
        yield Finding(("gearing",), "missing key: a layout has its numbers of teeth", f"add teeth = [...], of {wheels}")
    elif isinstance(teeth, list) and len(teeth) != len(scheme.wheels):
        rule = f"{len(teeth)} numbers of teeth, layout {scheme.key} has {len(scheme.wheels)} wheels"
        yield Finding(("gearing", "teeth"), rule, f"write those of the wheels {wheels}")
    elif isinstance(teeth, list) and all(map(is_integer, teeth)):
        yield from _check_rings(scheme, dict(zip(scheme.wheels, teeth, strict=True)))
    each = gearing.get("efficiency")
    if isinstance(each, list) and len(each) != len(scheme.meshes):
        pairs = listing(f"{mesh.first}-{mesh.second}" for mesh in scheme.meshes)
        rule = f"{len(each)} efficiencies, layout {scheme.key} has {len(scheme.meshes)} meshes"
        yield Finding(("gearing", "efficiency"), rule, f"write those of the meshes {pairs}, or one for all")
    if "planets" in gearing and not scheme.branched:
        rule = f"layout {scheme.key} has neither planets nor parallel layshafts"
        yield Finding(("gearing", "planets"), rule, "remove it")
    elif "sharing" in gearing and gearing.get("planets", 1) == 1:
        yield Finding(("gearing", "sharing"), "there is one planet: it shares with none", "remove it, or add planets")


def _check_rings(scheme: Layout, teeth: dict[str, int]) -> Iterator[Finding]:
    for mesh in scheme.meshes:
        if not mesh.internal:
            continue
        ring, pinion = (mesh.second, mesh.first) if mesh.second in scheme.rings else (mesh.first, mesh.second)
        if teeth[ring] <= teeth[pinion]:
            rule = f"ring {ring} has {teeth[ring]} teeth, wheel {pinion} within it {teeth[pinion]}"
            yield Finding(("gearing", "teeth"), rule, f"the order of the wheels is {listing(scheme.wheels)}")


def _members(gearing: Raw) -> list[str] | None:
    """All members that turn; None where they cannot be known."""
    if "layout" in gearing:
        scheme = _scheme(gearing)
        if scheme is None:
            return None
        wheels = dict.fromkeys(wheel.rstrip("'") for wheel in scheme.wheels)
        return [*wheels, *([CARRIER] if scheme.planetary else [])]
    carriers = bearers_of(gearing).values()
    return sorted(meshed(gearing) | {name for name in carriers if name != FRAME}) or None


def _check_names(gearing: Raw) -> Iterator[Finding]:
    """What is known is known of members that are there."""
    members = _members(gearing)
    if members is None:
        return
    for path, name in _named(gearing):
        if name not in members and name != FRAME:
            guess = did_you_mean(name, members)
            blocks = "; 2 and 2' are one member, 2" if name.endswith("'") else ""
            yield Finding(path, f"there is no member {show(name)}", guess or f"members: {listing(members)}{blocks}")


def _named(gearing: Raw) -> Iterator[tuple[Path, str]]:
    """Places where members are named beside the meshes."""
    for key in _BY_MEMBER:
        for member in subtable(gearing, key):
            if name_of(member) is not None:
                yield ("gearing", key, member), member
    for key, end in _ends(gearing):
        yield ("gearing", key), end
    for index, pair in _locks(gearing):
        for value in pair:
            if (name := name_of(value)) is not None:
                yield ("gearing", "locked", index), name


def _ends(gearing: Raw) -> Iterator[tuple[str, str]]:
    """The keys input and output with the members that they name."""
    for key in ("input", "output"):
        written = gearing.get(key)
        for value in written if isinstance(written, list) else [written]:
            if (name := name_of(value)) is not None:
                yield key, name


def _locks(gearing: Raw) -> Iterator[tuple[int, list[object]]]:
    listed = gearing.get("locked")
    for index, pair in enumerate(listed if isinstance(listed, list) else []):
        if isinstance(pair, list):
            yield index, pair


def _check_known(gearing: Raw) -> Iterator[Finding]:
    """Speeds are in sensible units, losses known once; ends turn, and are not the same; a lock joins two members."""
    speeds = subtable(gearing, "speeds")
    for member, speed in speeds.items():
        yield from check_bare_speed(speed, ("gearing", "speeds", member))
    yield from _check_twice(gearing)
    drivers = [name for key, name in _ends(gearing) if key == "input"]
    for key, name in _ends(gearing):
        if amount(speeds.get(name), "angular speed") == 0:
            yield Finding(("gearing", key), f"member {show(name)} is held by speeds", f"name an {key} that turns")
        elif key == "output" and name in drivers:
            yield Finding(("gearing", key), f"{show(name)} is input and output", "name two members")
    for index, pair in _locks(gearing):
        if len(pair) == 2 and pair[0] == pair[1]:
            yield Finding(("gearing", "locked", index), f"{show(pair[0])} is locked to itself", "name two members")
    if "efficiency" in gearing and "friction" in gearing:
        rule = "friction together with efficiency: either gives the losses"
        yield Finding(("gearing", "friction"), rule, "remove one of them")


def _check_twice(gearing: Raw) -> Iterator[Finding]:
    """The torque of a member is known once."""
    for position, key in enumerate(_LOADS):
        for member in subtable(gearing, key):
            for other in _LOADS[:position]:
                if member in subtable(gearing, other):
                    rule = f"{key} of {show(member)} together with its {other}: either gives the torque"
                    yield Finding(("gearing", key, member), rule, "remove one of them")


def _check_motion(gearing: Raw) -> Iterator[Finding]:
    """The known speeds determine all others and do not contradict each other, and so do the torques."""
    from tmmcalc.gears.tables.gearing import GearingTable

    try:
        table = GearingTable.model_validate(gearing)
    except ValidationError:
        return  # the fault is the table's
    from tmmcalc.gears.gearing import solve_gearing  # late: it loads numpy
    from tmmcalc.gears.network.speeds import solve_speeds
    from tmmcalc.gears.tables.tasks.gearing import gearing_task

    key, more = "", ""
    try:
        task = gearing_task(table)
        key = "speeds"
        solve_speeds(task.network, task.speeds, task.locked)
        key, more = next((each for each in _LOADS if each in gearing), ""), ", or leave out a known torque"
        solve_gearing(task)
    except UsageError as error:
        yield Finding(("gearing", key) if key in gearing else ("gearing",), error.message, f"{error.remedy}{more}")
    except TmmError:
        return  # a train that cannot turn has its own exit code: it is told when the train is asked to


CHECKS = (check_gearing,)
