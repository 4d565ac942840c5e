"""Checks of ``[[mechanism.outputs]]``: each names one thing that exists and moves."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import FRAME, written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, tables
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show

_KINDS = ("point", "link", "joint")


def check_outputs(outline: Outline) -> Iterator[Finding]:
    """Yield the faults of all outputs."""
    seen: set[str] = set()
    for index, output in tables(written_linkage(outline).table, "outputs"):
        path: Path = ("mechanism", "outputs", index)
        yield from _check_name(output, path, seen)
        yield from _check_choice(output, path)
        if isinstance(output.get("point"), str):
            yield from check_moving(outline, output["point"], (*path, "point"))
        if is_integer(output.get("link")):
            yield from _check_link(outline, output["link"], (*path, "link"))
        if isinstance(output.get("joint"), str):
            yield from _check_joint(outline, output["joint"], (*path, "joint"))


def _check_name(output: Raw, path: Path, seen: set[str]) -> Iterator[Finding]:
    """Outputs are told apart by their names; ``seen`` collects them."""
    name = next((str(output[key]) for key in ("name", *_KINDS) if key in output), None)
    if name in seen:
        yield Finding(
            (*path, "name") if "name" in output else path,
            f"a second output is called {show(name)}; their columns could not be told apart",
            f'give it a name of its own, such as name = "{name}y"',
        )
    if name is not None:
        seen.add(name)


def _check_choice(output: Raw, path: Path) -> Iterator[Finding]:
    named = [key for key in _KINDS if key in output]
    if not named:
        yield Finding(path, "missing key: an output is a point, a link or a joint", 'add point = "D"')
    for key in named[1:]:
        yield Finding(
            (*path, key),
            f"{' and '.join(named)} together: an output is one of point, link, joint",
            "write one [[mechanism.outputs]] for each",
        )
    if "direction" in output and named and "point" not in named:
        yield Finding(
            (*path, "direction"),
            f"a {named[0]} has no direction; only a point is followed along one",
            "remove it",
        )


def check_moving(outline: Outline, name: str, path: Path) -> Iterator[Finding]:
    """A point of this name exists, and moves."""
    linkage = written_linkage(outline)
    if None in linkage.points.values() or not linkage.ids_complete:
        return
    moving = sorted({name for link, points in linkage.points.items() if link != FRAME for name in points or ()})
    if name not in linkage.names:
        hint = " (the centre of mass of a link needs its center)" if name[:1] == "S" and name[1:].isdigit() else ""
        guess = did_you_mean(name, moving)
        yield Finding(
            path,
            f"there is no point {show(name)}{hint}",
            f"{guess} the points are: {listing(moving)}".strip(),
        )
    elif name in (linkage.points[FRAME] or ()) and (name not in moving or _is_pinned(outline, name)):
        yield Finding(
            path,
            f"{show(name)} is a point of the frame and does not move",
            f"name a point of a moving link: {listing(point for point in moving if point != name)}",
        )


def _is_pinned(outline: Outline, name: str) -> bool:
    """Return whether a revolute joint holds the point of this name to the frame."""
    return any(j.links and FRAME in j.links and j.pins == (name, name) for j in written_linkage(outline).joints)


def _check_link(outline: Outline, link: int, path: Path) -> Iterator[Finding]:
    linkage = written_linkage(outline)
    moving = listing(id_ for id_ in linkage.ids if id_ != FRAME)
    if link > FRAME and linkage.ids_complete and link not in linkage.ids:  # others are out of range
        yield Finding(path, f"there is no link {link}", f"the moving links are: {moving}")


def _check_joint(outline: Outline, name: str, path: Path) -> Iterator[Finding]:
    linkage = written_linkage(outline)
    if not linkage.joints:
        return
    joint = linkage.joint_named(name)
    prismatic = [str(joint.name) for joint in linkage.joints if joint.kind == "prismatic"]
    known = f"the prismatic joints are: {listing(prismatic)}"
    if joint is None:
        yield Finding(path, f"there is no joint {show(name)}", f"{did_you_mean(name, prismatic)} {known}".strip())
    elif joint.kind == "revolute":
        yield Finding(
            path,
            f"joint {show(name)} is revolute; an output joint is prismatic",
            f'{known}; or write point = "{name}" for the pin, link = ... for an angle',
        )
