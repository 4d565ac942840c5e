"""The constraints that a candidate is tested against, by name.

Those of ratio, coaxiality and tooth limits are solved for by the layouts; the others are masks over a block. Integer
conditions are tested in integers. The only irrational number is sin(pi/K); it is rational for K = 6, where equality
occurs, and 1/2 is then taken exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from tmmcalc.gears.exact import within
from tmmcalc.gears.model import Interval, TrainTask, Values
from tmmcalc.gears.scheme import Mesh
from tmmcalc.gears.search.blocks import Block, Tally

Mask = np.ndarray


def sieve(task: TrainTask, block: Block, tally: Tally) -> Block:
    """The candidates that meet every constraint of the task that is not solved for, in the order of the table."""
    for name, (binds, test) in CONSTRAINTS.items():
        if len(block) and binds(task):
            block = tally.keep(name, block, test(task, block))
    return block


def coprime(task: TrainTask, block: Block) -> Mask:
    """Whether the wheels of every mesh have no common factor."""
    return np.logical_and.reduce([np.gcd(block[m.first], block[m.second]) == 1 for m in task.scheme.meshes])


def undercut(task: TrainTask, block: Block) -> Mask:
    """Whether no external wheel is undercut by the rack: Z >= 2 h_a/sin^2(alpha)."""
    external = [wheel for wheel in task.scheme.wheels if wheel not in task.scheme.rings]
    return np.logical_and.reduce([block[wheel] >= (task.demands.undercut or 0) for wheel in external])


def interference(task: TrainTask, block: Block) -> Mask:
    """Whether every ring has enough teeth more than its pinion."""
    least = task.demands.ring_difference or 0
    inner = [mesh for mesh in task.scheme.meshes if mesh.internal]
    return np.logical_and.reduce([abs(block[m.first] - block[m.second]) >= least for m in inner])


def assembly(task: TrainTask, block: Block) -> Mask:
    """Whether K equally spaced planets fit in between the central wheels (4.25, 4.26)."""
    assert task.scheme.assembly is not None
    terms = task.scheme.assembly(block.teeth, task.planets)
    return np.logical_and.reduce([numerator % denominator == 0 for numerator, denominator in terms])


def adjacency(task: TrainTask, block: Block) -> Mask:
    """Whether neighbouring planets keep the gap between their tips (4.27, 4.28); paired ones by (8), not strict."""
    if task.scheme.paired:
        return np.logical_and.reduce([room >= 0 for room in rooms(task, block)])
    return np.logical_and.reduce([room > 0 for room in rooms(task, block)])


class Neighbours(NamedTuple):
    """Neighbouring planets on one central wheel: ``across`` has to exceed ``tips`` [module of the stage]."""

    mesh: Mesh
    central: str
    planet: str
    across: Values  # (n,) twice the orbit times sin(pi/K): the distance of the axes of neighbours
    tips: float  # what their tips and the gap take beyond the teeth of the planet


def neighbours(task: TrainTask, block: Block) -> Iterator[Neighbours]:
    """The condition of neighbourhood of every mesh of a central wheel with a planet (4.27, 4.28), of 2A-AA (8)."""
    gap = Fraction(0) if task.scheme.paired else (task.demands.gap or Fraction(0))
    tips = float(2 * task.addendum + gap)
    s = 0.5 if task.planets == 6 else math.sin(math.pi / task.planets)
    for mesh, stretch in zip(task.scheme.meshes, stretches(task, block), strict=True):
        central, planet = _central_first(task, mesh)
        if not central:
            continue
        total = block[central] - block[planet] if mesh.internal else block[central] + block[planet]
        raised = not task.scheme.paired and task.demands.largest_angle is not None
        yield Neighbours(mesh, central, planet, total * (stretch * s if raised else s), tips)


def rooms(task: TrainTask, block: Block) -> list[Values]:
    """Room between neighbouring planets [module of the stage] beyond the gap asked for, of every planet wheel."""
    return [each.across - block[each.planet] - each.tips for each in neighbours(task, block)]


def _central_first(task: TrainTask, mesh: Mesh) -> tuple[str, str]:
    """The central wheel and the planet of a mesh; of two planets none is central."""
    one, other = (wheel in task.scheme.planets for wheel in (mesh.first, mesh.second))
    if one and other:
        return "", ""
    return (mesh.second, mesh.first) if one else (mesh.first, mesh.second)


def sums(task: TrainTask, block: Block) -> list[np.ndarray]:
    """Twice the reference centre distances of the axes that must coincide, in units of one length."""
    z = block.teeth
    if task.scheme.axes is not None:
        return task.scheme.axes(z)
    found = []
    for mesh in task.scheme.meshes:
        total = abs(z[mesh.first] - z[mesh.second]) if mesh.internal else z[mesh.first] + z[mesh.second]
        found.append(total * block.proportion[mesh.stage])
    return found


def stretches(task: TrainTask, block: Block) -> list[Values]:
    """By how much the operating centre distance of each mesh exceeds the reference one.

    The stage of the largest reference distance keeps the angle of the rack and the others are raised to it.
    """
    ones = np.ones(len(block))
    if task.demands.largest_angle is None or not task.scheme.branched:
        return [ones for _ in task.scheme.meshes]
    found = sums(task, block)
    widest = np.maximum.reduce(found)
    each = [widest / total for total in found]
    return [each[0], each[0], each[1]] if task.scheme.paired else each


def mesh_angles(task: TrainTask, block: Block) -> Mask:
    """Whether no operating pressure angle is beyond the largest."""
    limit = math.cos(task.pressure_angle) / math.cos(task.demands.largest_angle or 0.0)
    return np.logical_and.reduce([stretch <= limit for stretch in stretches(task, block)])


def diameters(task: TrainTask, block: Block) -> Mask:
    """Whether the wheels 2 and 3 of two stages with a common axis are alike in diameter."""
    band = task.demands.diameter_band or Fraction(0)
    mu1, mu2 = block.proportion
    below = mu1 * block["2"]
    return np.asarray(within(Interval(1 - band, 1 + band), mu2 * block["3"], below, int(below.max(initial=1))))


def slow_stages(task: TrainTask, block: Block) -> Mask:
    """Whether no stage of a coaxial train exceeds the largest ratio of one stage."""
    admitted = Interval(Fraction(0), task.demands.stage_ratio or Fraction(1))
    pairs = [(block[mesh.second], block[mesh.first]) for mesh in task.scheme.meshes]
    return np.logical_and.reduce([within(admitted, *pair, int(pair[1].max(initial=1))) for pair in pairs])


def centre_distance(task: TrainTask, block: Block) -> Mask:
    """Whether the centre distance of stage 1 lies within its limits."""
    low, high = task.demands.centre_distance or (None, None)
    distance = centre_distances(task, block)
    return (distance >= (low or 0.0)) & (distance <= (math.inf if high is None else high))


def centre_distances(task: TrainTask, block: Block) -> Values:
    """Centre distance [m] of the wheels 1 and 2."""
    mesh = task.scheme.meshes[0]
    one, other = block[mesh.first], block[mesh.second]
    total = abs(one - other) if mesh.internal else one + other
    distance: Values = (task.module or 0.0) / 2 * total * stretches(task, block)[0]
    return distance


def envelope(task: TrainTask, block: Block) -> Mask:
    """Whether the circle around planets and rings (of a branched train) is within its limit."""
    return envelopes(task, block) <= (task.demands.envelope or 0.0)


def envelopes(task: TrainTask, block: Block) -> Values:
    """Diameter [m] of the circle around the pitch circles of the planets and the central wheels."""
    module = task.module or 0.0
    units = [module * mu / block.proportion[0] for mu in block.proportion]
    central = {wheel for wheel in task.scheme.wheels if wheel not in task.scheme.planets}
    sizes = []
    for mesh in task.scheme.meshes:
        own, planet = _central_first(task, mesh)
        if own in central:
            sizes.append(units[mesh.stage] * block[own])
            outer = block[own] if mesh.internal else block[own] + 2 * block[planet]
            sizes.append(units[mesh.stage] * outer)
    largest: Values = np.maximum.reduce(sizes)
    return largest


# name: (whether it binds in this task, the mask); the order in which they are put and counted
CONSTRAINTS: dict[str, tuple[Callable[[TrainTask], bool], Callable[[TrainTask, Block], Mask]]] = {
    "mesh_angles": (lambda t: t.demands.largest_angle is not None and t.scheme.branched, mesh_angles),
    "undercut": (lambda t: t.demands.undercut is not None and t.demands.undercut > t.limits.least, undercut),
    "interference": (lambda t: t.demands.ring_difference is not None and bool(t.scheme.rings), interference),
    "stage_ratio": (
        lambda t: t.demands.stage_ratio is not None and t.scheme.branched and not t.scheme.planetary,
        slow_stages,
    ),
    "diameter_band": (lambda t: t.demands.diameter_band is not None and t.scheme.common_axis, diameters),
    "assembly": (lambda t: t.demands.assembly and t.scheme.branched and t.planets > 1, assembly),
    "adjacency": (lambda t: t.demands.gap is not None and t.scheme.branched and t.planets > 2, adjacency),
    "coprime": (lambda t: t.demands.coprime, coprime),
    "centre_distance": (lambda t: t.demands.centre_distance is not None and bool(t.module), centre_distance),
    "envelope": (lambda t: t.demands.envelope is not None and t.scheme.branched and bool(t.module), envelope),
}
