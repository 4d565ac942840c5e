"""A mechanism in place: its chain on the assembly that is meant, where it assembles, and where position 0 is.

Every group is taken on the assembly that the spec tells or its sketch is nearest to (see `assemblies`), at the input
coordinate where the sketch was read; a higher group is followed from there along the input.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmmcalc.core.errors import AssemblyError, NoSolutionError, SingularityError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assemblies import assemblies_of, chosen
from tmmcalc.linkage.assembly import TURN, check_range, coordinate, find_domain
from tmmcalc.linkage.chain import Chain, step_of
from tmmcalc.linkage.grid import analysed_range
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.outputs import working_centres
from tmmcalc.linkage.quality import assess, check_regular, passes_clearly
from tmmcalc.linkage.results import Domain, Interval, Limit
from tmmcalc.linkage.structure import Group, Structure
from tmmcalc.linkage.survey import survey
from tmmcalc.linkage.trace import principal
from tmmcalc.linkage.variants import candidates, distance, given_variants, nearest, sketched_groups

if TYPE_CHECKING:
    from tmmcalc.linkage.loops.closure import Loops
    from tmmcalc.linkage.loops.equations import Equations
    from tmmcalc.linkage.loops.step import LoopStep

SEAM = 0.01  # the search for assembly intervals starts at an angle where nothing special happens [rad]


class Placed(NamedTuple):
    """A mechanism in place."""

    chain: Chain  # on its assembly
    domain: Domain  # where it assembles
    start: float  # input coordinate of position 0
    centres: (
        Real | None
    )  # dead centres (k,) of the first output over a turn, that of position 0 first; None: it is given


def placed(mechanism: Mechanism, structure: Structure) -> Placed:
    """The mechanism in place; raises what says why it has no position 0."""
    told = given_variants(mechanism, structure)
    if chosen_at(mechanism, structure) is None and structure.dyads_only:
        told = _at_extremes(mechanism, structure, told)
    chain = assembled(mechanism, structure, told)
    domain = domain_of(chain)
    return Placed(chain, domain, *_start(chain, domain))


def assembled(mechanism: Mechanism, structure: Structure, told: Mapping[str, int]) -> Chain:
    """The chain with every group on the assembly of its name in ``told``, else of the sketch; a dyad else on +1.

    Raises `NoSolutionError` where nothing tells which assembly of a group is meant, or the group has none.
    """
    at = chosen_at(mechanism, structure)
    sketched = sketched_groups(mechanism, structure, told) if at is not None else []
    chain = Chain(mechanism, structure, ())
    for group in structure.groups:
        variant = told.get(group.name)
        if not group.kind:
            chain = chain.joined(_followed(chain, group, at, variant))
            continue
        if at is not None and group in sketched:
            motions = chain.evaluate(np.array([at]), order=0).motions
            variant = chosen(chain, group, assemblies_of(mechanism, group, motions, np.array([at])), at, None).variant
        chain = chain.joined(step_of(mechanism, group, 1 if variant is None else variant))
    return chain


def _followed(chain: Chain, group: Group, at: float | None, number: int | None) -> LoopStep:
    """A higher group behind a chain, on the branch through the assembly that is meant at ``at``."""
    from tmmcalc.linkage.loops.continuation import follow
    from tmmcalc.linkage.loops.equations import equations_of  # only groups of class III and higher need them
    from tmmcalc.linkage.loops.step import LoopStep

    if at is None:
        raise NoSolutionError(
            f"the assembly of {group.name} is chosen at an input coordinate: neither assembly.at nor input.start "
            "gives one",
            where="kinematics, assembly",
            remedy="give assembly.at, the input coordinate of the sketch, or sketch a point of the crank",
        )
    interval, x = _interval(chain, group, at), np.array([at])
    assemblies = assemblies_of(chain.mechanism, group, chain.evaluate(x, order=0).motions, x)
    assembly = chosen(chain, group, assemblies, at, number)
    assert assembly.unknowns is not None  # a higher group has them
    equations = equations_of(chain.mechanism, group)
    turn = TURN if chain.turns else None
    branch = follow(group.name, partial(loops_at, chain, equations), at, assembly.unknowns, interval, turn)
    return LoopStep(group, assembly.variant, equations, branch)


def loops_at(chain: Chain, equations: Equations, x: Real) -> Loops:
    """The loops of the group after a chain, at input coordinates (n,)."""
    from tmmcalc.linkage.loops.closure import Loops

    motions = chain.evaluate(x).motions
    return Loops(equations, motions, equations.given(motions), x)


def _interval(chain: Chain, group: Group, at: float) -> Interval:
    """The interval around ``at`` where the groups before assemble."""
    for interval in domain_of(chain).intervals:
        if interval.holds(at, at, chain.period):
            shift = interval.shift(at, chain.period)
            limits = tuple(Limit(limit.x - shift, limit.group, limit.reason) for limit in interval.limits)
            return Interval(interval.low - shift, interval.high - shift, limits)
    raise NoSolutionError(
        f"at {coordinate(chain, at)}, where its assembly is chosen, the groups before it do not assemble",
        where=f"kinematics, group {group.name}",
        remedy="give assembly.at, another input coordinate",
    )


def domain_of(chain: Chain) -> Domain:
    """Where the chain assembles: within one turn of a crank, or as far as a slider reaches."""
    if chain.turns:
        return find_domain(chain, SEAM - np.pi, SEAM + np.pi)
    return find_domain(chain, *analysed_range(chain.mechanism, chain.mechanism.input.start or 0.0))


def chosen_at(mechanism: Mechanism, structure: Structure) -> float | None:
    """The input coordinate at which assemblies are chosen: assembly.at, or input.start.

    With groups of class III and higher else the sketched angle of the crank; None: position 0, a dead centre.
    """
    if mechanism.assembly.at is not None:
        return mechanism.assembly.at
    if mechanism.input.start is not None or structure.dyads_only:
        return mechanism.input.start
    return _sketched_angle(mechanism)


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


def _at_extremes(mechanism: Mechanism, structure: Structure, told: dict[str, int]) -> dict[str, int]:
    """The variants nearest to a sketch of position 0, compared with each candidate at its own extreme."""
    groups = sketched_groups(mechanism, structure, told)
    tried = []
    for signs in candidates(groups, told) if groups else ():
        chain = assembled(mechanism, structure, signs)
        at = _start_or_none(chain)
        if at is not None:
            tried.append((distance(chain, at), signs))
    # where no candidate has an extreme to start from, the first one tells why
    return nearest(tried, groups) if tried else told


def _start(chain: Chain, domain: Domain) -> tuple[float, Real | None]:
    """Input coordinate of position 0: given, or the dead centre before the working stroke, with all dead centres."""
    given = chain.mechanism.input.start
    if given is not None:
        return given, None
    check_range(chain, domain, -math.pi, math.pi)
    dense = survey(chain, -math.pi, math.pi)
    if not passes_clearly(chain, dense):
        check_regular(chain, assess(chain, dense, -math.pi))
    centres = working_centres(chain, dense)
    return float(principal(centres[:1])[0]), centres


def _start_or_none(chain: Chain) -> float | None:
    """The extreme start of a candidate variant, None if that variant does not turn or never reverses."""
    try:
        return _start(chain, domain_of(chain))[0]
    except (AssemblyError, SingularityError, NoSolutionError):
        return None
