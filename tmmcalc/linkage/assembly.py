"""Where the mechanism assembles: the exact intervals of the input, and the reason at each end.

Every dyad has a margin, a smooth function of the input coordinate that is negative exactly where its
links do not reach. The dyads are taken in order of assembly: within the intervals that the dyads before
leave, the roots of the next margin are the limit positions. A dense sample brackets them; its local
extrema near zero are refined first, so that a short gap (or a short interval) between two samples is
found as well.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from tmmcalc.core.errors import AssemblyError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.numerics.extrema import with_turning_points
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Branch, Domain, Interval, Limit

TURN = 2 * math.pi
SAMPLES = 360  # positions of the dense sample, one a degree on a full turn
NEAR = 0.02  # a local extremum of the margin smaller than this is always refined before it is believed
TOUCH = 1e-12  # a margin (a squared sine) this small is a change point, not a gap


def find_domain(chain: Chain, low: float, high: float) -> Domain:
    """Assembly intervals of the input coordinate; a crank's are sought on the turn (or period) from ``low``.

    A driven slider's are sought beyond [low, high] as well, as far as the links can reach; that range itself is
    sampled as densely as a turn. Raises `AssemblyError` if there is none at all.
    """
    turn = TURN if chain.turns else None
    beyond = 0.0 if turn else 2 * reach_of(chain.mechanism) + high - low
    core = np.empty(0) if turn else np.linspace(low, high, SAMPLES + 1)
    intervals = [Interval(low - beyond, low + turn if turn else high + beyond)]
    branches = chain.branches
    for k, step in enumerate(chain.steps):
        if not step.group.kind:
            branch = branches[step.group.name]
            intervals, turn = _on_branch(branch, intervals), max(turn, branch.period or turn) if turn else None
            continue
        found = [part for interval in intervals for part in _cut(chain, k, interval, turn, core)]
        if not found:
            raise _never(chain, k, intervals)
        intervals = _joined(found, turn) if turn else found
    whole = intervals[0]
    full = len(intervals) == 1 and not whole.limits
    return Domain(tuple(sorted(intervals, key=lambda i: i.low)), full)


def reach_of(mechanism: Mechanism) -> float:
    """Sum of the distances of all points and joints from their link's origin [m]: nothing stands farther away."""
    named = sum(abs(p) for link in (mechanism.frame, *mechanism.links) for p in link.points.values())
    return named + sum(abs(p) for joint in mechanism.joints for p in joint.points)


def sample(interval: Interval, count: int = SAMPLES) -> Real:
    """Points of an interval, denser towards limits, where positions change with a square root."""
    if not interval.limits:
        return np.linspace(interval.low, interval.high, count + 1)
    u = np.linspace(0.0, math.pi, count + 1)
    u[[0, -1]] = 1e-4, math.pi - 1e-4
    return (interval.low + interval.high) / 2 - (interval.high - interval.low) / 2 * np.cos(u)


def _cut(chain: Chain, k: int, interval: Interval, turn: float | None, core: Real) -> list[Interval]:
    """The parts of an interval where dyad k reaches; ``core`` (m,) are places to sample besides."""
    x = sample(interval)
    if core.size:
        x = np.sort(np.concatenate((x, core[(core > x[0]) & (core < x[-1])])))
        x = x[np.append(True, np.diff(x) > 0)]
    period = None if interval.limits else turn
    x, m = with_turning_points(
        lambda at, _: chain.margins(at, k), x, chain.margins(x, k), near=NEAR, period=period, touch=TOUCH
    )
    change = np.flatnonzero((m[1:] < 0) != (m[:-1] < 0))
    if not change.size:
        return [interval] if m[0] >= 0 else []
    roots = bracketed(lambda at, _: chain.margins(at, k), x[change], x[change + 1])
    edges = [interval.low, *roots, interval.high]
    reasons = {float(r): _limit(chain, k, float(r)) for r in roots}
    before = {limit.x: limit for limit in interval.limits}
    parts = []
    for i, (a, b) in enumerate(pairwise(edges)):
        inside = m[0] >= 0 if i == 0 else m[change[i - 1] + 1] >= 0
        if inside:
            ends = tuple(d[end] for end in (a, b) for d in (reasons, before) if end in d)
            parts.append(Interval(float(a), float(b), ends))
    return parts


def _on_branch(branch: Branch, intervals: list[Interval]) -> list[Interval]:
    """What a branch leaves of the intervals in one of which it was followed: all its turns, where it comes back."""
    if branch.period is not None:
        return [Interval(interval.low, interval.low + branch.period) for interval in intervals]
    return [Interval(branch.low, branch.high, branch.limits)]


def _joined(parts: list[Interval], turn: float) -> list[Interval]:
    """One interval for the two parts that meet at the arbitrary seam of the turn."""
    parts = sorted(parts, key=lambda part: part.low)
    first, last = parts[0], parts[-1]
    seam_low = all(limit.x != first.low for limit in first.limits)
    seam_high = all(limit.x != last.high for limit in last.limits)
    if len(parts) == 1 or not (seam_low and seam_high):
        return parts
    limits = last.limits + tuple(Limit(limit.x + turn, limit.group, limit.reason) for limit in first.limits)
    return [*parts[1:-1], Interval(last.low, first.high + turn, limits)]


def _limit(chain: Chain, k: int, x: float) -> Limit:
    """What stops dyad k at its limit position x."""
    step = chain.dyad(k)
    port1, port2 = step.ports(chain.evaluate(np.array([x]), order=0, steps=k).motions)
    a, b = step.group.links
    return Limit(x, step.group.name, step.dyad.limit(a, b, port1, port2))


def _never(chain: Chain, k: int, intervals: list[Interval]) -> AssemblyError:
    """No position at all: by how much the links of dyad k miss each other, at best."""
    x = np.concatenate([sample(interval) for interval in intervals])
    step = chain.dyad(k)
    margins = chain.margins(x, k)
    known = np.isfinite(margins)  # where the groups before this one reach each other by rounding alone it has no place
    best = int(np.argmax(np.where(known, margins, -np.inf)))
    ports = step.ports(chain.evaluate(x[best : best + 1], order=0, steps=k).motions)
    a, b = step.group.links
    what = "any crank angle" if chain.turns else "any position of the input slider"
    gap = step.dyad.gap(a, b, *ports) if known.any() else "the links before it reach each other by rounding alone"
    return AssemblyError(
        f"cannot be assembled at {what}: {gap} ({coordinate(chain, float(x[best]))}, where it comes nearest)",
        where=f"kinematics, group {step.group.name}",
        value=float(margins[best]) if known.any() else 0.0,
        limit=0.0,
        remedy="change these lengths or the positions of the pivots",
    )


def coordinate(chain: Chain, *x: float) -> str:
    """Input coordinates as text: crank angles in degrees or displacements in mm."""
    amounts = listed([_amount(chain, at) for at in x], " and ")
    if chain.turns:
        return Phrase("angle_{link} = {amounts} deg", link=chain.structure.input_link, amounts=amounts)
    return Phrase("s_{joint} = {amounts} mm", joint=chain.input_joint.name, amounts=amounts)


def _coordinate_name(chain: Chain) -> str:
    return f"angle_{chain.structure.input_link}" if chain.turns else f"s_{chain.input_joint.name}"


def _amount(chain: Chain, x: float) -> str:
    """The input coordinate in degrees or mm, nine digits at most."""
    amount = math.degrees(x) if chain.turns else x * 1000
    return f"{round(amount, 9) + 0.0:.9g}" if chain.turns else f"{amount:.9g}"


def check_range(chain: Chain, domain: Domain, low: float, high: float) -> None:
    """Raise `AssemblyError` unless the whole range [low, high] assembles without a gap."""
    _check_return(chain, high - low)
    if domain.full:
        return
    turn = chain.period
    if any(interval.holds(low, high, turn) for interval in domain.intervals):
        return
    limits = [limit for interval in domain.intervals for limit in interval.limits]
    crossed = [limit for limit in limits if _between(limit.x, low, high, turn)] or limits
    ranges = " and ".join(describe(chain, interval) for interval in domain.intervals)
    raise AssemblyError(
        "\n  ".join((f"{_asked(chain, low, high)}: it assembles for {ranges} only", *_reasons(chain, limits))),
        where=f"kinematics, group {crossed[0].group}" if crossed else "kinematics",
        remedy="change the lengths named, or analyse inside an interval: set input.start and grid.span",
    )


def _check_return(chain: Chain, span: float) -> None:
    """Raise `AssemblyError` if a whole turn is asked for, after which a branch stands otherwise."""
    if not chain.turns or abs(span - TURN) > 1e-9:
        return
    for name, branch in chain.branches.items():
        turns = round((branch.period or 0.0) / TURN)
        if turns == 1 or (not turns and branch.high - branch.low < TURN):
            continue
        what = f"it comes back after {turns} turns" if turns else "it comes to a limit position before it comes back"
        whole = f", or to {360 * turns} deg" if turns else ""
        raise AssemblyError(
            f"after one turn of the crank the group stands otherwise: {what}",
            where=f"kinematics, group {name}",
            remedy=f"set grid.span below one turn{whole}, or choose another assembly",
        )


def _asked(chain: Chain, low: float, high: float) -> str:
    if chain.turns and high - low >= TURN - 1e-9:
        return "the crank cannot make a full turn"
    return f"the range from {coordinate(chain, low)} to {coordinate(chain, high)} does not assemble throughout"


def _reasons(chain: Chain, limits: list[Limit]) -> list[str]:
    """What happens at the limits, each reason once with all its places."""
    places: dict[tuple[str, str], list[str]] = {}
    for limit in limits:
        places.setdefault((limit.group, limit.reason), []).append(_amount(chain, limit.x))
    name, unit = _coordinate_name(chain), "deg" if chain.turns else "mm"
    return [
        f"{group} at {name} = {' and '.join(sorted(at, key=float))} {unit}: {reason}"
        for (group, reason), at in places.items()
    ]


def _between(x: float, low: float, high: float, turn: float | None) -> bool:
    """Whether a limit lies in [low, high], counted modulo ``turn`` if there is one."""
    return low <= (x - turn * math.floor((x - low) / turn) if turn else x) <= high


def describe(chain: Chain, interval: Interval) -> str:
    """The interval as text: ``angle_1 in [-44.427, 224.427] deg``, ``s_O >= 200 mm``."""
    name, unit = _coordinate_name(chain), "deg" if chain.turns else "mm"
    low, high = _amount(chain, interval.low), _amount(chain, interval.high)
    ends = {limit.x for limit in interval.limits}
    if interval.low not in ends or interval.high not in ends:
        return f"{name} >= {low} {unit}" if interval.low in ends else f"{name} <= {high} {unit}"
    return f"{name} in [{low}, {high}] {unit}"
