"""Structural analysis: mobility, Assur groups, the order of assembly, the structural formula.

Every moving link has 3 freedoms, every lower pair takes 2, the driver takes the last one. Constraints are matched to
links (see `matching`): "link p depends on link q" is a directed graph whose strongly connected components are the Assur
groups and whose topological order is the order of assembly (the Dulmage-Mendelsohn decomposition of the closure
equations). Textbook 2.2, (3.2).
"""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.errors import StructureError
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.matching import STAGE, check_pairs, components, matched, named
from tmmcalc.linkage.model import FRAME, Input, Joint, Link, Mechanism

ROMAN = {1: "I", 2: "II", 3: "III", 4: "IV", 5: "V", 6: "VI", 7: "VII", 8: "VIII"}


@record
class Group:
    """One Assur group.

    ``links`` are in the order that defines the kind: of a dyad the links a and b, so that ``kind`` reads
    outer joint of a, inner joint, outer joint of b. ``outer`` are the joints with the source chain
    (the attachment points), in the order of the links; ``inner`` those between links of the group.
    """

    links: tuple[int, ...]
    kind: str  # "RRR", "RRP", "RPR", "PRP", "RPP"; empty for class III and higher
    class_number: int  # 2 for a dyad, 3 with a basic link of three joints, 4 and more for closed contours
    order: int  # number of outer joints
    inner: tuple[str, ...]
    outer: tuple[str, ...]
    source: tuple[int, ...]  # links of the source chain: frame, input and all groups before
    drive: str = ""  # the joint of the drive, where it acts between two links of the group: a driven length

    @property
    def name(self) -> str:
        """Name in messages and formulas: ``RRP(2,3)``, ``III(2,3,4,5)``; ``D(1,2,3)`` with the drive inside it."""
        letter = "D" if self.drive else self.kind or ROMAN.get(self.class_number, str(self.class_number))
        return f"{letter}({','.join(map(str, self.links))})"


@record
class Structure:
    """Result of the structural analysis of a mechanism of mobility 1."""

    mobility: int = quantity("mobility", "mobility W = 3 n - 2 p", symbol="W")
    links: int = quantity("links", "number of moving links", symbol="n")
    joints: int = quantity("joints", "number of lower pairs", symbol="p")
    input_link: int  # the slider, where the drive acts between two moving links
    groups: tuple[Group, ...]  # in order of assembly
    names: dict[str, str] = quantity("links_named", "names of the moving links by their numbers", default_factory=dict)

    @property
    def driven(self) -> Group | None:
        """The group that holds the drive; None: it acts on a link from the frame."""
        return next((group for group in self.groups if group.drive), None)

    @property
    def dyads_only(self) -> bool:
        """Whether no group is of class III or higher, nor holds the drive."""
        return all(group.kind for group in self.groups)

    @derived("formula", "structural formula")
    def formula(self) -> str:
        """Structural formula such as ``I(0,1) -> II RPR(2,3) -> II RRP(4,5)``."""
        parts = [f"I(0,{self.input_link})"] if self.driven is None else []
        for group in self.groups:
            number = ROMAN.get(group.class_number, str(group.class_number))
            parts.append(f"{number} {group.name}" if group.kind or group.drive else group.name)
        return " -> ".join(parts)

    @derived("class_number", "class of the mechanism")
    def class_number(self) -> int:
        """Class of the mechanism: the highest class of its groups."""
        return max((group.class_number for group in self.groups), default=1)


def skeleton(mechanism: Mechanism) -> Mechanism:
    """The mechanism without its metric, motion and assembly: all that the structure depends on."""
    return Mechanism(
        Link(FRAME),
        tuple(Link(link.id, name=link.name) for link in mechanism.links),
        tuple(Joint(joint.name, joint.kind, joint.links, (0j, 0j)) for joint in mechanism.joints),
        Input(mechanism.input.joint, 1.0),
    )


def solve_structure(mechanism: Mechanism) -> Structure:
    """Find the Assur groups of a mechanism from its links and joints alone.

    Raises `StructureError` (exit code 3) with the reason if the mobility is not 1: excess constraints,
    missing constraints, a floating link, a chain of prismatic joints only.
    """
    check_pairs(mechanism)
    driver = mechanism.joint(mechanism.input.joint)
    input_link = next(k for k in driver.links if k != FRAME)
    within = FRAME not in driver.links
    taken = matched(mechanism, driver, input_link)
    groups: list[Group] = []
    known: tuple[int, ...] = (FRAME,) if within else (FRAME, input_link)
    for component in components(taken):
        if component == (input_link,) and not within:
            continue
        groups.append(_group(mechanism, component, known, driver if within else None))
        known = (*known, *sorted(component))
    n, p = len(mechanism.links), len(mechanism.joints)
    names = {str(link.id): link.name for link in mechanism.links if link.name}
    return Structure(3 * n - 2 * p, n, p, input_link, tuple(groups), names)


def _group(mechanism: Mechanism, links: tuple[int, ...], known: tuple[int, ...], driver: Joint | None) -> Group:
    members = set(links)
    drive = driver.name if driver is not None and set(driver.links) & members else ""
    inner = [j for j in mechanism.joints if set(j.links) <= members]
    outer = [j for j in mechanism.joints if len(members & set(j.links)) == 1 and members | set(known) >= set(j.links)]
    _check_turning(links, inner, outer)
    if len(links) == 2 and not drive:
        return _dyad(links, inner, outer, known)
    outer.sort(key=lambda j: min(members & set(j.links)))
    names = tuple(j.name for j in inner), tuple(j.name for j in outer)
    number = 2 if drive and len(links) == 3 else _class_number(inner)
    return Group(links, "", number, len(outer), *names, known, drive)


def _check_turning(links: tuple[int, ...], inner: Sequence[Joint], outer: Sequence[Joint]) -> None:
    """A closed loop of prismatic joints alone constrains one rotation twice and leaves one translation."""
    root = {k: k for k in links}

    def find(k: int) -> int:
        k = k if k in root else FRAME
        while root.get(k, k) != k:
            k = root[k]
        return k

    for joint in (*inner, *outer):
        if joint.kind != "prismatic":
            continue
        a, b = find(joint.links[0]), find(joint.links[1])
        if a == b:
            raise StructureError(
                f"group of {named(links)}: prismatic joints alone close a loop (the last is {joint.name}), which "
                "leaves a translation free and fixes a rotation twice",
                where=STAGE,
                remedy="make one joint of that loop revolute",
            )
        root[a if a != FRAME else b] = b if a != FRAME else FRAME


def _dyad(links: tuple[int, ...], inner: Sequence[Joint], outer: Sequence[Joint], known: tuple[int, ...]) -> Group:
    """Order the two links so that the kind reads RRR, RRP, RPR, PRP or RPP: a revolute outer joint first."""
    at = {k: next(j for j in outer if k in j.links) for k in links}
    a, b = sorted(links, key=lambda k: (at[k].kind == "prismatic", k))
    kind = "".join(j.kind[0].upper() for j in (at[a], inner[0], at[b]))
    return Group((a, b), kind, 2, 2, (inner[0].name,), (at[a].name, at[b].name), known)


def _class_number(inner: Sequence[Joint]) -> int:
    """Class III for a basic link of three joints, IV and more for a closed contour of that many inner joints.

    The contour of a joint is the shortest closed one through it; the longest of these gives the class.
    """
    contours = [_shortest_contour(joint, inner) for joint in inner]
    return max(3, *contours)


def _shortest_contour(joint: Joint, inner: Sequence[Joint]) -> int:
    """Number of joints of the shortest closed contour through this joint, 0 if it lies on none."""
    start, goal = joint.links
    frontier, seen, length = {start}, {start}, 1
    while frontier:
        frontier = {
            q for j in inner if j is not joint for k, q in (j.links, j.links[::-1]) if k in frontier and q not in seen
        }
        seen |= frontier
        length += 1
        if goal in frontier:
            return length
    return 0
