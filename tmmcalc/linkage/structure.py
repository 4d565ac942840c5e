"""Structural analysis: mobility, Assur groups, the order of assembly, the structural formula.

Every moving link has 3 freedoms, every lower pair takes 2, the driver takes the last one. Giving each
constraint to one of the links it joins, at most 3 to a link, is a bipartite matching. If it is perfect,
"link p depends on link q" is a directed graph whose strongly connected components are the Assur groups
and whose topological order is the order of assembly (the Dulmage-Mendelsohn decomposition of the
closure equations). If it is not, the unmatched rest names the links at fault. Textbook 2.2, (3.2).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tmmcalc.errors import StructureError
from tmmcalc.linkage.model import FRAME, Input, Joint, Link, Mechanism
from tmmcalc.records import record

ROMAN = {1: "I", 2: "II", 3: "III", 4: "IV", 5: "V", 6: "VI", 7: "VII", 8: "VIII"}
STAGE = "structure"


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

    @property
    def name(self) -> str:
        """Name in messages and formulas: ``RRP(2,3)``, ``III(2,3,4,5)``."""
        return f"{self.kind or ROMAN.get(self.class_number, self.class_number)}({','.join(map(str, self.links))})"


@record
class Structure:
    """Result of the structural analysis of a mechanism of mobility 1."""

    mobility: int  # W = 3 n - 2 p
    links: int  # n, moving links
    joints: int  # p, lower pairs
    input_link: int
    groups: tuple[Group, ...]  # in order of assembly

    @property
    def formula(self) -> str:
        """Structural formula such as ``I(0,1) -> II RPR(2,3) -> II RRP(4,5)``."""
        parts = [f"I(0,{self.input_link})"]
        for group in self.groups:
            number = ROMAN.get(group.class_number, str(group.class_number))
            parts.append(f"{number} {group.name}" if group.kind else group.name)
        return " -> ".join(parts)

    @property
    def class_number(self) -> int:
        """Class of the mechanism: the highest class of its groups."""
        return max((group.class_number for group in self.groups), default=1)


def skeleton(mechanism: Mechanism) -> Mechanism:
    """The mechanism without its metric, motion and assembly: all that the structure depends on."""
    return Mechanism(
        Link(FRAME),
        tuple(Link(link.id) for link in mechanism.links),
        tuple(Joint(joint.name, joint.kind, joint.links, (0j, 0j)) for joint in mechanism.joints),
        Input(mechanism.input.joint, 1.0),
    )


def solve_structure(mechanism: Mechanism) -> Structure:
    """Find the Assur groups of a mechanism from its links and joints alone.

    Raises `StructureError` (exit code 3) with the reason if the mobility is not 1: excess constraints,
    missing constraints, a floating link, a chain of prismatic joints only.
    """
    _check_pairs(mechanism)
    driver = mechanism.joint(mechanism.input.joint)
    input_link = next(k for k in driver.links if k != FRAME)
    matching = _match(mechanism, driver, input_link)
    components = _components(mechanism, matching)
    groups: list[Group] = []
    known: tuple[int, ...] = (FRAME, input_link)
    for component in components:
        if component == (input_link,):
            continue
        groups.append(_group(mechanism, component, known))
        known = (*known, *sorted(component))
    n, p = len(mechanism.links), len(mechanism.joints)
    return Structure(3 * n - 2 * p, n, p, input_link, tuple(groups))


def check_solvable(structure: Structure) -> None:
    """Raise `StructureError` if a group is not a dyad: class III and higher are recognised, not yet solved."""
    higher = [group for group in structure.groups if not group.kind]
    if higher:
        names = ", ".join(f"{group.name} of order {group.order}" for group in higher)
        raise StructureError(
            f"recognised, but not solvable yet: {names}",
            where=f"{STAGE}, {structure.formula}",
            remedy="drive another link, if the task allows: the class depends on the input link",
        )


def _names(links: Iterable[int]) -> str:
    links = sorted(links)
    return f"link {links[0]}" if len(links) == 1 else "links " + ", ".join(map(str, links))


def _moving(joint: Joint) -> list[int]:
    return [k for k in joint.links if k != FRAME]


def _check_pairs(mechanism: Mechanism) -> None:
    """Two links joined twice are one rigid body or an excess constraint, which counting alone may hide."""
    seen: dict[frozenset[int], str] = {}
    for joint in mechanism.joints:
        pair = frozenset(joint.links)
        if pair in seen:
            raise StructureError(
                f"links {joint.links[0]} and {joint.links[1]} are joined twice, by {seen[pair]} and {joint.name}: "
                "4 constraints on their 3 relative freedoms",
                where=STAGE,
                remedy="remove one of the two joints, or join one of them to another link",
            )
        seen[pair] = joint.name


def _match(mechanism: Mechanism, driver: Joint, input_link: int) -> dict[int, list[Joint]]:
    """Give every constraint to one of its links, at most 3 to a link; raise with the reason if impossible."""
    taken: dict[int, list[Joint]] = {link.id: [] for link in mechanism.links}

    def place(joint: Joint, tried: set[int]) -> bool:
        for k in _moving(joint):
            if k in tried:
                continue
            tried.add(k)
            if len(taken[k]) < 3:
                taken[k].append(joint)
                return True
            for slot, other in enumerate(taken[k]):
                if place(other, tried):
                    taken[k][slot] = joint
                    return True
        return False

    drive = Joint("the drive", "revolute", (FRAME, input_link), (0j, 0j))
    for joint in (drive, *(j for j in mechanism.joints for _ in range(2))):
        tried: set[int] = set()
        if not place(joint, tried):
            raise _excess(mechanism, tried or set(_moving(joint)))
    loose = {k for k, joints in taken.items() if len(joints) < 3}
    if loose:
        raise _missing(mechanism, taken, loose)
    return taken


def _mobility(mechanism: Mechanism) -> str:
    n, p = len(mechanism.links), len(mechanism.joints)
    return f"mobility W = 3n - 2p = 3*{n} - 2*{p} = {3 * n - 2 * p}"


def _excess(mechanism: Mechanism, links: set[int]) -> StructureError:
    joints = [j.name for j in mechanism.joints if set(_moving(j)) <= links]
    return StructureError(
        f"excess constraints: {_names(links)} have {3 * len(links)} freedoms, but joints {', '.join(joints)} "
        f"and the drive take at least {3 * len(links) + 1} ({_mobility(mechanism)}, 1 is needed)",
        where=STAGE,
        remedy="remove a joint there, or put a link with two joints in its place",
    )


def _missing(mechanism: Mechanism, taken: dict[int, list[Joint]], loose: set[int]) -> StructureError:
    free = sum(3 - len(joints) for joints in taken.values())
    part = set(loose)
    while grown := {k for k, js in taken.items() if k not in part and any(part & set(j.links) for j in js)}:
        part |= grown
    idle = sorted(k for k in part if not any(k in j.links for j in mechanism.joints))
    reason = f"{_names(idle)} floats: no joint names it; " if idle else ""
    return StructureError(
        f"{reason}missing constraints: {_names(part)} keep {free} freedom{'s' * (free > 1)} when the input link "
        f"stands still ({_mobility(mechanism)}, 1 is needed)",
        where=STAGE,
        remedy="join these links to the frame or to the rest of the mechanism, or remove them",
    )


def _components(mechanism: Mechanism, taken: dict[int, list[Joint]]) -> list[tuple[int, ...]]:
    """Strongly connected components of the dependency graph, sources first, then by lowest link number."""
    needs = {k: {q for j in joints for q in _moving(j) if q != k} for k, joints in taken.items()}
    reach = {k: _reachable(needs, k) for k in needs}
    of = {k: tuple(sorted(q for q in reach[k] if k in reach[q])) for k in needs}
    waiting = sorted(set(of.values()))
    done: set[int] = set()
    order: list[tuple[int, ...]] = []
    while waiting:
        ready = next(c for c in waiting if all(reach[k] - set(c) <= done for k in c))
        waiting.remove(ready)
        order.append(ready)
        done |= set(ready)
    return order


def _reachable(needs: dict[int, set[int]], start: int) -> set[int]:
    seen, stack = {start}, [start]
    while stack:
        for q in needs[stack.pop()] - seen:
            seen.add(q)
            stack.append(q)
    return seen


def _group(mechanism: Mechanism, links: tuple[int, ...], known: tuple[int, ...]) -> Group:
    members = set(links)
    inner = [j for j in mechanism.joints if set(j.links) <= members]
    outer = [j for j in mechanism.joints if len(members & set(j.links)) == 1 and members | set(known) >= set(j.links)]
    _check_turning(links, inner, outer)
    if len(links) == 2:
        return _dyad(links, inner, outer, known)
    outer.sort(key=lambda j: min(members & set(j.links)))
    names = tuple(j.name for j in inner), tuple(j.name for j in outer)
    return Group(links, "", _class_number(links, inner, outer), len(outer), *names, known)


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
                f"group of {_names(links)}: prismatic joints alone close a loop (the last is {joint.name}), which "
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


def _class_number(links: tuple[int, ...], inner: Sequence[Joint], outer: Sequence[Joint]) -> int:
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
