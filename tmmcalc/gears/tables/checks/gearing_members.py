"""Checks of the members and meshes of ``[gearing]``: who bears whom, and which wheels can mesh."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.network.model import FRAME
from tmmcalc.gears.tables.gearing import MemberName
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Raw, is_integer, tables
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.units import UnitError

_WHEEL = MemberName(frame=True)


def name_of(value: object) -> str | None:
    """The name of a member or of the frame; None for what is none and has that fault."""
    try:
        return _WHEEL.read(value)
    except UnitError:
        return None


def check_members(gearing: Raw) -> Iterator[Finding]:
    """Members are described once, take part in the train, and bear each other in order."""
    described: dict[str, Raw] = {}
    used = meshed(gearing) | {name_of(member.get("carrier")) for _, member in tables(gearing, "members")}
    for index, member in tables(gearing, "members"):
        path: Path = ("gearing", "members", index)
        name = name_of(member.get("name"))
        if name is None:
            continue
        if name in described:
            yield Finding((*path, "name"), f"member {show(name)} is described twice", "keep one of them")
        elif name == name_of(member.get("carrier")):
            yield Finding((*path, "carrier"), f"member {show(name)} cannot bear itself", "name its carrier")
        elif name not in used:
            known = [each for each in used if each is not None]
            rule = f"member {show(name)} is in no mesh and bears nothing"
            guess = did_you_mean(name, known)
            yield Finding((*path, "name"), rule, guess or f"in the meshes are {listing(sorted(meshed(gearing)))}")
        described.setdefault(name, member)
    for index, member in tables(gearing, "members"):
        yield from _check_bearing(described, member, ("gearing", "members", index))


def _check_bearing(described: dict[str, Raw], member: Raw, path: Path) -> Iterator[Finding]:
    """A carrier turns on an axis parallel to those that it bears, and is not borne by them."""
    name, bearer = name_of(member.get("name")), name_of(member.get("carrier"))
    if bearer is not None and described.get(bearer, {}).get("tilted") is True:
        rule = f"the tilted member {show(bearer)} bears {show(name)}; only one of parallel axis can"
        yield Finding((*path, "carrier"), rule, "name another carrier")
    if name is None:
        return
    passed = [name]
    while bearer is not None and bearer != name and bearer not in passed:
        passed.append(bearer)
        bearer = name_of(described.get(bearer, {}).get("carrier"))
    if bearer == name and len(passed) > 1:
        rule = f"members {listing(passed)} bear each other in a ring"
        yield Finding((*path, "carrier"), rule, "the last carrier turns in the frame: it has no carrier")
    if "sharing" in member and member.get("count", 1) == 1:
        rule = f"there is one {show(name)}: it shares with none"
        yield Finding((*path, "sharing"), rule, "remove it, or add count")


def meshed(gearing: Raw) -> set[str]:
    """The members in mesh, without the frame."""
    ends = (name_of(mesh.get(key)) for _, mesh in tables(gearing, "meshes") for key in ("first", "second"))
    return {name for name in ends if name is not None and name != FRAME}


def check_meshes(gearing: Raw) -> Iterator[Finding]:
    """Two wheels are on two members, each on its side; a ring is larger than the wheel within."""
    tilted = _tilted(gearing)
    sides: dict[tuple[object, ...], str] = {}
    for index, mesh in tables(gearing, "meshes"):
        path: Path = ("gearing", "meshes", index)
        first, second = (name_of(mesh.get(key)) for key in ("first", "second"))
        if first is None or second is None:
            continue
        if first == second:
            yield Finding((*path, "second"), f"member {show(first)} is in mesh with itself", "name the other member")
            continue
        yield from _check_ring(mesh, path, bool({first, second} & tilted))
        yield from _check_side(mesh, path, {first, second} & tilted, sides)


def check_axes(gearing: Raw) -> Iterator[Finding]:
    """Some member keeps the axes of a mesh apart."""
    bearers = bearers_of(gearing)
    for index, mesh in tables(gearing, "meshes"):
        first, second = (name_of(mesh.get(key)) for key in ("first", "second"))
        if first is None or second is None or first == second or _keeps_apart(bearers, first, second):
            continue
        homes = [f"{show(name)} is borne by {show(bearers.get(name, FRAME))}" for name in (first, second)]
        rule = f"no member keeps the axes of this mesh apart: {', '.join(homes)}"
        remedy = "wheels mesh on one carrier, or with a wheel that turns on the carrier's own axis"
        yield Finding(("gearing", "meshes", index), rule, remedy)


def bearers_of(gearing: Raw) -> dict[str, str]:
    """The carrier of every member that is described."""
    members = [member for _, member in tables(gearing, "members")]
    pairs = ((name_of(member.get("name")), name_of(member.get("carrier", FRAME))) for member in members)
    return {name: bearer for name, bearer in pairs if name is not None and bearer is not None}


def _tilted(gearing: Raw) -> set[str]:
    named = (name_of(member.get("name")) for _, member in tables(gearing, "members") if member.get("tilted") is True)
    return {name for name in named if name is not None}


def _keeps_apart(bearers: dict[str, str], first: str, second: str) -> bool:
    one, other = bearers.get(first, FRAME), bearers.get(second, FRAME)
    if one == other:
        return True
    return any(c != FRAME and bearers.get(c, FRAME) == o for c, o in ((one, other), (other, one)))


def _check_ring(mesh: Raw, path: Path, bevel: bool) -> Iterator[Finding]:
    """What is internal, and what is opposite."""
    if bevel and mesh.get("internal") is True:
        rule = "a bevel planet has no ring about it"
        yield Finding((*path, "internal"), rule, "remove it; opposite = true stands for the wheel on the other side")
    if not bevel and mesh.get("opposite") is True:
        rule = "opposite is said of a mesh with a tilted member"
        yield Finding(
            (*path, "opposite"), rule, "remove it, or add tilted = true to a bevel planet in [[gearing.members]]"
        )
    first, second = mesh.get("first_teeth"), mesh.get("second_teeth")
    if mesh.get("internal") is True and not bevel and is_integer(first) and first == second:
        rule = f"both wheels have {first} teeth: none is a ring about the other"
        yield Finding((*path, "internal"), rule, "remove it, or give the ring more teeth")


def _check_side(mesh: Raw, path: Path, planets: set[str], sides: dict[tuple[object, ...], str]) -> Iterator[Finding]:
    """Two like wheels do not mesh with one bevel planet on the same side."""
    for key, other in (("first", "second"), ("second", "first")):
        planet, wheel = name_of(mesh.get(key)), name_of(mesh.get(other))
        teeth = mesh.get(f"{key}_teeth"), mesh.get(f"{other}_teeth")
        if planet not in planets or wheel is None or not all(map(is_integer, teeth)):
            continue
        place = (planet, *teeth, mesh.get("opposite") is True)
        if place in sides:
            rule = f"{show(sides[place])} and {show(wheel)} mesh with {show(planet)} on the same side"
            yield Finding(path, rule, "add opposite = true to one of the two meshes")
        sides[place] = wheel
