"""Which link determines which: a matching of constraints to links, and the order in which groups of links follow.

Giving each constraint to one of the links it joins, at most 3 to a link, is a bipartite matching. If it is perfect,
link p depends on link q where a constraint of p joins them; the strongly connected components of that graph are the
groups. If it is not, the unmatched rest names the links at fault.
"""

from __future__ import annotations

from collections.abc import Iterable

from tmmcalc.core.errors import StructureError
from tmmcalc.linkage.model import FRAME, Joint, Mechanism

STAGE = "structure"


def check_pairs(mechanism: Mechanism) -> None:
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


def named(links: Iterable[int]) -> str:
    """The numbers of links in words."""
    links = sorted(links)
    return f"link {links[0]}" if len(links) == 1 else "links " + ", ".join(map(str, links))


def _moving(joint: Joint) -> list[int]:
    return [k for k in joint.links if k != FRAME]


def matched(mechanism: Mechanism, driver: Joint, input_link: int) -> dict[int, list[Joint]]:
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

    within = driver.links if FRAME not in driver.links else (FRAME, input_link)
    drive = Joint("the drive", "revolute", within, (0j, 0j))
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
        f"excess constraints: {named(links)} have {3 * len(links)} freedoms, but joints {', '.join(joints)} "
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
    reason = f"{named(idle)} floats: no joint names it; " if idle else ""
    return StructureError(
        f"{reason}missing constraints: {named(part)} keep {free} freedom{'s' * (free > 1)} when the input link "
        f"stands still ({_mobility(mechanism)}, 1 is needed)",
        where=STAGE,
        remedy="join these links to the frame or to the rest of the mechanism, or remove them",
    )


def components(taken: dict[int, list[Joint]]) -> list[tuple[int, ...]]:
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
