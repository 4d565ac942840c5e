"""Power that circulates in a train: it flows round a loop of members and elements and never leaves.

The elements are ordinary meshes, planetary sets (the meshes that share planets, with their carrier) and locks. Each
takes power from some members and gives it to others, so the flows form a directed graph; a loop in it carries
circulating power, which loads the teeth and feeds losses but does no work outside. The split into loops starts from the
first member; a loop's power is the least flow along it.
"""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.model import FRAME, Network

ZERO = 1e-12  # a flow below this part of the largest is none

Flows = dict[str, dict[str, float]]  # node -> next node -> power [W]


@record
class Loop:
    """A loop of circulating power."""

    # members and elements in the direction of the flow; the last one leads to the first
    path: tuple[str, ...] = quantity("path", "way of the power")
    power: float = quantity("power[W]", "power that circulates")


def circulating(
    network: Network, mesh_powers: Values, locks: Sequence[tuple[str, str, float]] = ()
) -> tuple[Loop, ...]:
    """Loops of circulating power, from the powers (m, 3) that meshes give to their wheels and carrier [W].

    ``locks`` holds for each lock its two members and the power that it gives to the first.
    """
    flows = _flows(network, mesh_powers, locks)
    loops = []
    while loop := next((found for start in flows if (found := _loop_from(flows, [start]))), None):
        ring = list(zip(loop, (*loop[1:], loop[0]), strict=True))
        power = min(flows[a][b] for a, b in ring)
        for a, b in ring:
            flows[a][b] -= power
            if flows[a][b] <= 0:
                del flows[a][b]
        loops.append(Loop(tuple(loop), power))
    largest = max((loop.power for loop in loops), default=0.0)
    return tuple(loop for loop in loops if loop.power > ZERO * largest)


def elements(network: Network) -> tuple[tuple[int, ...], ...]:
    """Numbers of the meshes of every element: planetary sets, and ordinary meshes one by one."""
    sets: list[tuple[set[str], list[int]]] = []
    for j, (mesh, carrier) in enumerate(zip(network.meshes, network.carriers, strict=True)):
        planets = {n for n in (mesh.first, mesh.second) if carrier != FRAME and network.bearer(n) == carrier}
        joined = [entry for entry in sets if entry[0] & planets]
        sets = [entry for entry in sets if entry not in joined]
        sets.append((planets.union(*(e[0] for e in joined)), sorted([j, *(k for e in joined for k in e[1])])))
    return tuple(sorted(tuple(numbers) for _, numbers in sets))


def _flows(network: Network, mesh_powers: Values, locks: Sequence[tuple[str, str, float]]) -> Flows:
    """Powers from members to elements and back, without those that rounding alone makes."""
    given = []
    for numbers in elements(network):
        title = " + ".join(str(network.meshes[j]) for j in numbers)
        sums: dict[str, float] = {}
        for j in numbers:
            mesh = network.meshes[j]
            for name, power in zip((mesh.first, mesh.second, network.carriers[j]), mesh_powers[j], strict=True):
                sums[name] = sums.get(name, 0.0) + float(power)
        given += [(title, name, power) for name, power in sums.items() if name != FRAME]
    for first, second, power in locks:
        given += [(f"lock {first}-{second}", n, p) for n, p in ((first, power), (second, -power)) if n != FRAME]
    limit = ZERO * max((abs(float(p)) for p in mesh_powers.flat), default=0.0)
    flows: Flows = {}
    for element, member, power in given:
        a, b = (element, member) if power > 0 else (member, element)
        if abs(power) > limit:
            flows.setdefault(a, {})[b] = abs(power)
            flows.setdefault(b, {})
    return flows


def _loop_from(flows: Flows, path: list[str]) -> list[str] | None:
    """A loop that leads back to the first node of a path, by depth first."""
    for node in flows[path[-1]]:
        if node == path[0]:
            return path
        if node not in path and (found := _loop_from(flows, [*path, node])):
            return found
    return None
