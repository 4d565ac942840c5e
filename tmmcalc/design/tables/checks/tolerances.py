"""Checks of ``[[tolerances]]``: keys that hold numbers, one way to say how they vary, joints that there are."""

from __future__ import annotations

import json
from collections.abc import Iterator

from tmmcalc.core.errors import UsageError
from tmmcalc.design.tables.general import class_of
from tmmcalc.linkage.tables.checks.written_linkage import WrittenJoint, link_words, written_linkage
from tmmcalc.naming.keys import chosen
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, tables
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.variants import given

OF_FILES = ("column", "measured_as")
OF_DIMENSIONS = ("tolerance", "side", "measured", "measurements", *OF_FILES, "alike", "correlation")
OF_JOINTS = ("clearance", "direction", "link")
OF_CLEARANCE = "clearance of "  # and the name of the joint: how one is told
MEASURED = ("measured", "measurements")  # deviations, and the file of pieces


def check_tolerances(outline: Outline) -> Iterator[Finding]:
    """Each is that of dimensions, or of a joint that has no other one, and complete."""
    seen: set[str] = set()
    for index, table in tables(outline.document, "tolerances"):
        path: Path = ("tolerances", index)
        if "joint" in table and "of" not in table:
            yield from _check_joint(path, table, outline)
            name = table["joint"]
            if isinstance(name, str) and name in seen:
                rule = f"{show(name)} has two clearances"
                yield Finding((*path, "joint"), rule, "remove one of the tables")
            seen |= {name} if isinstance(name, str) else set()
        elif "of" not in table:
            yield Finding(path, "missing key: of, the dimensions, or joint", 'add of = "...", or joint = "A"')
        else:
            yield from _check_dimensions(path, table, outline)


def _check_dimensions(path: Path, table: Raw, outline: Outline) -> Iterator[Finding]:
    for key in ("joint", *OF_JOINTS):
        if key in table:
            rule = f"{key} together with of: a joint has a table of its own"
            yield Finding((*path, key), rule, "write two [[tolerances]]")
            return
    keys = table["of"] if isinstance(table["of"], list) else [table["of"]]
    for key in keys:
        if isinstance(key, str) and key.strip() and "=" not in key.rpartition("]")[2]:
            try:
                chosen(outline.document, [key.strip()])
            except UsageError as error:
                yield Finding((*path, "of"), error.message, error.remedy)
    yield from _check_width(path, table)
    yield from _check_group(path, table.get("alike"), outline)
    if table.get("correlation") is not None and not table.get("alike"):
        rule = "correlation without alike: it is that of a group"
        yield Finding((*path, "correlation"), rule, 'add alike = "bores", or remove it')


def _check_group(path: Path, group: object, outline: Outline) -> Iterator[Finding]:
    """A group is told beside dimensions and clearances, and has a name that is none of theirs."""
    if not isinstance(group, str) or not group:
        return
    try:
        given(group, outline.document)
        kind = "a number of the spec"
    except UsageError:
        if not group.startswith(OF_CLEARANCE):
            return
        kind = "a clearance"
    rule = f"{show(group)} is the name of {kind}: the group would be told as it"
    yield Finding((*path, "alike"), rule, 'choose another name, such as "bores"')


def _check_width(path: Path, table: Raw) -> Iterator[Finding]:
    """A tolerance, or deviations that were measured."""
    asked = table.get("distribution") == "measured"
    given = [key for key in MEASURED if key in table]
    if given and "tolerance" in table:
        rule = f"tolerance together with {given[0]}: what was measured says all"
        yield Finding((*path, "tolerance"), rule, "remove one of them")
    elif len(given) > 1:
        yield Finding((*path, given[1]), "measured together with measurements", "remove one of them")
    elif given and "distribution" in table and not asked:
        rule = f"{given[0]} with distribution = {show(table['distribution'])}"
        yield Finding((*path, "distribution"), rule, 'write "measured", or remove it')
    elif asked and not given:
        rule = "missing key: measured, the deviations of this distribution, or measurements"
        yield Finding(path, rule, 'add measured = ["-0.01 mm", "0.02 mm"], or measurements = "pieces.csv"')
    elif not given and "tolerance" not in table:
        yield Finding(path, "missing key: tolerance of these dimensions", 'add tolerance = "0.1 mm", "h7" or "m"')
    for key in OF_FILES:
        if key in table and "measurements" not in table:
            yield Finding((*path, key), f"{key} without measurements: of which file", 'add measurements = "pieces.csv"')
    width = table.get("tolerance")
    if isinstance(width, list) and len(width) == 2:
        yield from _check_ends(path, width)
    if "side" in table and not (isinstance(width, str) and class_of(width)):
        rule = "side is that of an angle with a class of ISO 2768"
        yield Finding((*path, "side"), rule, 'write tolerance = "m", or remove it')


def _check_ends(path: Path, width: list[object]) -> Iterator[Finding]:
    """The lower deviation comes first."""
    from tmmcalc.spec.units import UnitError, parse

    kinds = {dimension_of(each) for each in width if isinstance(each, str)} - {None}
    try:
        low, high = (parse(each, *(kind for kind in kinds if kind)) if kinds else float(str(each)) for each in width)
    except (UnitError, ValueError):
        return
    if low >= high:
        yield Finding(
            (*path, "tolerance"), f"{show(width)}: the first deviation is not below the second", "exchange them"
        )


def _check_joint(path: Path, table: Raw, outline: Outline) -> Iterator[Finding]:
    for key in OF_DIMENSIONS:
        if key in table:
            rule = f"{key} together with joint: a joint has a clearance"
            yield Finding((*path, key), rule, 'write clearance = "0.05 mm", and the dimensions in a table of their own')
            return
    if "clearance" not in table:
        yield Finding(path, "missing key: clearance of the joint", 'add clearance = "0.05 mm"')
    if table.get("distribution") == "measured":
        rule = "a clearance with a measured distribution"
        yield Finding((*path, "distribution"), rule, 'write "normal", "uniform" or "triangular"')
    joints = {each.get("name"): each for _, each in tables(subtable(outline.document, "mechanism"), "joints")}
    name = table["joint"]
    known = [each for each in joints if isinstance(each, str)]
    if isinstance(name, str) and name not in joints:
        guess = did_you_mean(name, known)
        remedy = f"{guess} the joints are: {listing(known)}".strip() if known else "remove it: there is no [mechanism]"
        yield Finding((*path, "joint"), f"there is no joint {show(name)}", remedy)
    elif isinstance(name, str):
        yield from _check_place(path, table, joints[name], outline)


def _check_place(path: Path, table: Raw, joint: Raw, outline: Outline) -> Iterator[Finding]:
    """The pin is on the link that is named; a guide that moves is given by coordinates of its own."""
    links = joint.get("links")
    if joint.get("kind") == "prismatic":
        if table.get("direction", "any") not in ("any", "force"):
            rule = f"direction = {show(table['direction'])} of a slider: it leans on one side of its guide or the other"
            yield Finding((*path, "direction"), rule, 'write "any" or "force"')
        if "link" in table:
            rule = "link of a slider: its guide is moved across, whatever the link"
            yield Finding((*path, "link"), rule, "remove it")
        elif not isinstance(subtable(joint, "guide").get("through"), list):
            rule = f"the guide of {show(joint.get('name'))} goes through a named point, which other joints may have"
            yield Finding((*path, "joint"), rule, "write guide.through of the joint as coordinates [x, y]")
    elif "link" in table and isinstance(links, list) and table["link"] not in links:
        rule = f"{show(joint.get('name'))} is no joint of link {show(table['link'])}"
        yield Finding((*path, "link"), rule, f"its links are: {listing(links)}")
    elif isinstance(links, list):
        yield from _check_pin(path, table, outline)


def _check_pin(path: Path, table: Raw, outline: Outline) -> Iterator[Finding]:
    """The point of the link that is moved is that of this joint alone: others would move along."""
    joint = written_linkage(outline).joint_named(table["joint"])
    if joint is None or joint.links is None or joint.pins is None:
        return
    link = table["link"] if "link" in table else next((each for each in joint.links if each != 0), 0)
    name = joint.pin_on(link)
    guides, others = _users(joint, link, str(name), outline)
    if not guides and not others:
        return
    remedies = [f"write {each} as coordinates [x, y]" for each in guides]
    if others:
        names = [f"{name}_1" if each == link else pin for each, pin in zip(joint.links, joint.pins, strict=True)]
        own = f"points = {json.dumps(names, ensure_ascii=False)}"
        remedies.append(f"give the joint a point of its own there: {show(names[joint.links.index(link)])}, {own}")
    rule = f"point {show(name)} of {link_words(link)} is that of {listing([*guides, *others])} too: it would move along"
    yield Finding((*path, "joint"), rule, "; ".join(remedies))


def _users(joint: WrittenJoint, link: int, name: str, outline: Outline) -> tuple[list[str], list[str]]:
    """Who else has a point of a link: lines of sliders, which may have coordinates, and the others.

    An output or a path says no link: where both links of the joint have the name, it is that of the one that stays.
    """
    linkage, document = written_linkage(outline), outline.document
    guides, found = [], []
    for other in linkage.joints:
        if other.index == joint.index or other.links is None or link not in other.links:
            continue
        for line, own in (("slider", other.links[0]), ("guide", other.links[1])):
            if other.kind == "prismatic" and own == link and subtable(other.table, line).get("through") == name:
                guides.append(f"{line}.through of {other.title}")
        if other.pin_on(link) == name:
            found.append(other.title)
    for at, load in tables(document, "loads"):
        if load.get("link") == link and load.get("point") == name:
            found.append(f"load {show(load['name']) if 'name' in load else f'number {at + 1}'}")
    for at, spring in tables(document, "springs"):
        ends = [spring.get(key) for key in ("links", "points")]
        if all(isinstance(each, list) for each in ends) and [link, name] in map(list, zip(*ends, strict=False)):
            found.append(f"spring {show(spring['name']) if 'name' in spring else f'number {at + 1}'}")
    if joint.pins is not None and joint.pins[0] != joint.pins[1]:
        asked = [("output", each) for _, each in tables(linkage.table, "outputs")]
        asked += [("path", each) for _, each in tables(document, "paths")]
        found += [f"the {kind} of {show(name)}" for kind, each in asked if each.get("point") == name]
    return guides, found


CHECKS = (check_tolerances,)
