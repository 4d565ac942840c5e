"""The chain of a mechanism with its assembly: variants of dyads, branches of higher groups, where it assembles.

A higher group is taken on the assembly that the spec numbers or its sketch is nearest to, at ``assembly.at``, and is
followed from there along the input.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.errors import NoSolutionError, UsageError
from tmmcalc.linkage.assembly import TURN, coordinate, find_domain
from tmmcalc.linkage.chain import Chain, compile_chain
from tmmcalc.linkage.grid import analysed_range
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.results import Branch, Domain, Interval, Limit
from tmmcalc.linkage.structure import Group, Structure

if TYPE_CHECKING:
    from tmmcalc.linkage.loops.closure import Loops
    from tmmcalc.linkage.loops.equations import Equations

SEAM = 0.01  # the search for assembly intervals starts at an angle where nothing special happens [rad]
TIED = 1e-6  # relative difference of distances that does not tell two assemblies apart


def domain_of(chain: Chain) -> Domain:
    """Where the chain assembles: within one turn of a crank, or as far as a slider reaches."""
    if chain.turns:
        return find_domain(chain, SEAM - np.pi, SEAM + np.pi)
    return find_domain(chain, *analysed_range(chain.mechanism, chain.mechanism.input.start or 0.0))


def assembled(mechanism: Mechanism, structure: Structure, signs: Mapping[str, int]) -> Chain:
    """The chain with the dyads on these signs and every higher group on its branch.

    Raises `NoSolutionError` where nothing tells which assembly of a group is meant, or the group has none.
    """
    higher = [group for group in structure.groups if not group.kind]
    variants, branches = dict(signs), dict[str, Branch]()
    if higher:
        at = _told_at(mechanism, higher)
        for group in higher:
            chain = _before(mechanism, structure, group, variants, branches)
            variants[group.name], branches[group.name] = _branch(chain, group, at, signs.get(group.name))
    return compile_chain(mechanism, structure, variants, branches)


def _before(
    mechanism: Mechanism,
    structure: Structure,
    group: Group,
    variants: Mapping[str, int],
    branches: Mapping[str, Branch],
) -> Chain:
    """The chain of the groups before one."""
    earlier = structure.groups[: structure.groups.index(group)]
    steps = compile_chain(mechanism, _part(structure, earlier), variants, branches).steps
    return Chain(mechanism, structure, steps)


def _part(structure: Structure, groups: tuple[Group, ...]) -> Structure:
    return Structure(structure.mobility, structure.links, structure.joints, structure.input_link, groups)


def loops_at(chain: Chain, equations: Equations, x: Real) -> Loops:
    """The loops of the group after a chain, at input coordinates (n,)."""
    from tmmcalc.linkage.loops.closure import Loops

    motions = chain.evaluate(x).motions
    return Loops(equations, motions, equations.given(motions), x)


def _branch(chain: Chain, group: Group, at: float, number: int | None) -> tuple[int, Branch]:
    """Number and branch of the group after a chain, chosen at ``at``."""
    from tmmcalc.linkage.loops.assemblies import assemblies
    from tmmcalc.linkage.loops.equations import equations_of
    from tmmcalc.linkage.loops.track import follow

    equations = equations_of(chain.mechanism, group)
    loops = partial(loops_at, chain, equations)
    interval = _interval(chain, group, at)
    found = assemblies(loops(np.array([at])))
    k = _choice(chain, group, found, loops(np.array([at])), at, number)
    turn = TURN if chain.turns else None
    return k + 1, follow(group.name, loops, at, found[:, k], interval, turn)


def _interval(chain: Chain, group: Group, at: float) -> Interval:
    """The interval around ``at`` where the groups before assemble."""
    turn = TURN if chain.turns else None
    for interval in domain_of(chain).intervals:
        if interval.holds(at, at, turn):
            shift = turn * np.floor((at - interval.low) / turn) if turn else 0.0
            limits = tuple(Limit(limit.x + shift, limit.group, limit.reason) for limit in interval.limits)
            return Interval(interval.low + shift, interval.high + shift, limits)
    raise NoSolutionError(
        f"at {coordinate(chain, at)}, where its assembly is chosen, the groups before it do not assemble",
        where=f"kinematics, group {group.name}",
        remedy="give assembly.at, another input coordinate",
    )


def chosen_at(mechanism: Mechanism) -> float | None:
    """The input coordinate at which assemblies are chosen: assembly.at, input.start, or the sketched crank's angle."""
    if mechanism.assembly.at is not None:
        return mechanism.assembly.at
    return mechanism.input.start if mechanism.input.start is not None else _sketched_angle(mechanism)


def _told_at(mechanism: Mechanism, groups: Sequence[Group]) -> float:
    at = chosen_at(mechanism)
    if at is None:
        names = ", ".join(group.name for group in groups)
        raise NoSolutionError(
            f"the assembly of {names} is chosen at an input coordinate: neither assembly.at nor input.start gives one",
            where="kinematics, assembly",
            remedy="give assembly.at, the input coordinate of the sketch, or sketch a point of the crank",
        )
    return at


def _sketched_angle(mechanism: Mechanism) -> float | None:
    """The angle of the crank as a sketch of one of its points shows it."""
    joint = mechanism.joint(mechanism.input.joint)
    if joint.kind != "revolute" or FRAME not in joint.links:
        return None
    side = 1 - joint.links.index(FRAME)
    pivot, own = joint.points[1 - side], joint.points[side]
    for name, p in mechanism.link(joint.links[side]).points.items():
        if name in mechanism.assembly.sketch and p != own:
            return float(np.angle((mechanism.assembly.sketch[name] - pivot) / (p - own)))
    return None


def _choice(chain: Chain, group: Group, found: Real, loops: Loops, at: float, number: int | None) -> int:
    """Which of the assemblies (N, a) at ``at`` is meant: numbered, sketched, or the only one."""
    count, where = found.shape[1], f"kinematics, group {group.name}"
    if count == 0:
        raise NoSolutionError(
            f"no assembly exists at {coordinate(chain, at)}",
            where=where,
            remedy="give assembly.at, another input coordinate, or check the lengths",
        )
    if number is not None:
        if not 1 <= number <= count:
            raise UsageError(
                f"there is no assembly {number}: at {coordinate(chain, at)} the group has {count}",
                where=f"mechanism.assembly.variants, {group.name}",
                remedy="tmmcalc structure --assemblies lists them",
            )
        return number - 1
    gaps = _distances(chain, group, loops, found)
    if gaps is None:
        if count == 1:
            return 0
        raise NoSolutionError(
            f"the group has {count} assemblies at {coordinate(chain, at)}, and nothing tells which one is meant",
            where=where,
            remedy="sketch its points in assembly.sketch, or give the number of the assembly in assembly.variants; "
            "tmmcalc structure --assemblies lists them",
        )
    order = np.argsort(gaps)
    if count > 1 and tied(gaps[order[0]], gaps[order[1]]):
        raise NoSolutionError(
            f"the sketch stands equally near to the assemblies {order[0] + 1} and {order[1] + 1}",
            where=where,
            remedy="sketch more of its points, or give the number of the assembly in assembly.variants",
        )
    return int(order[0])


def tied(nearest: float, next_one: float) -> bool:
    """Whether two distances of a sketch [m] do not tell two assemblies apart."""
    return next_one <= nearest * (1 + TIED) + 1e-15


def _distances(chain: Chain, group: Group, loops: Loops, found: Real) -> Real | None:
    """Root mean square distances (a,) [m] of the sketched points of a group from its assemblies; None without any."""
    motions = dict(loops.motions)
    placed = loops.place(found)
    still = np.zeros_like(found)
    loops.move(placed, still, still, motions, {})
    sketch = chain.mechanism.assembly.sketch
    own = [(name, k, p) for name, k, p in own_points(chain.mechanism, group) if name in sketch]
    gaps = [np.abs(motions[k].point(p).r - sketch[name]) for name, k, p in own]
    if not gaps:
        return None
    return np.asarray(np.sqrt(np.mean(np.square(np.broadcast_arrays(*gaps)), axis=0)))


def own_points(mechanism: Mechanism, group: Group) -> list[tuple[str, int, complex]]:
    """Named points of the links of a group, with link and place on it, but for outer pins, which others place."""
    outer = [mechanism.joint(name) for name in group.outer]
    pins = {pin for joint in outer if joint.kind == "revolute" for pin in zip(joint.links, joint.points, strict=True)}
    points = ((name, k, p) for k in group.links for name, p in mechanism.link(k).points.items())
    return [(name, k, p) for name, k, p in points if (k, p) not in pins]
