"""How far each tooth set is from each constraint: the quantity that the constraint limits, one value a set."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.gears.model import Integers, ToothSets, TrainTask, Values
from tmmcalc.gears.search.blocks import Block
from tmmcalc.gears.search.constraints import centre_distances, envelopes, rooms, stretches


def block_of(sets: ToothSets) -> Block:
    """The tooth sets as a block; its proportions are arrays (n,) of their own."""
    parts = tuple(sets.modules[:, k] for k in range(sets.modules.shape[1]))
    return Block(sets.by_wheel, parts)


def tooth_ratio(sets: ToothSets) -> tuple[Integers, Integers]:
    """Numerator and denominator (n,) of the tooth ratio U, of AII of i_14; the denominator carries no sign.

    >>> sets = ToothSets("AIbar", np.array([[20, 52, 124]]), np.array([[1]]), np.zeros((1, 2)))
    >>> [int(part[0]) for part in tooth_ratio(sets)]
    [31, 5]
    """
    numerator, denominator = sets.scheme.tooth_ratio(sets.by_wheel)
    common = np.gcd(numerator, denominator)
    return numerator // common, denominator // common


def coprime_meshes(sets: ToothSets) -> np.ndarray:
    """Whether the wheels of every mesh of a set have no common factor: every tooth meets every other."""
    return np.logical_and.reduce([np.gcd(sets.of(m.first), sets.of(m.second)) == 1 for m in sets.scheme.meshes])


def room(task: TrainTask, sets: ToothSets) -> Values:
    """Least room between neighbouring planets [module] beyond the gap asked for."""
    least: Values = np.minimum.reduce(rooms(task, block_of(sets)))
    return least


def tip_gap(task: TrainTask, sets: ToothSets) -> Values:
    """Least gap (n,) between the tips of neighbouring planets [module] at the operating centre distances.

    That of pairs of planets is not what their condition (8) tests, which takes the centre distances of the rack;
    planets 2 and 3 of neighbouring pairs count as well.
    """
    if not sets.scheme.paired:
        return room(task, sets) + float(task.demands.gap or 0)
    z2, z3 = sets.of("2"), sets.of("3")
    inner, _, outer = stretches(task, block_of(sets))
    # twice the radii of the orbits, in modules
    near, far = (sets.of("1") + z2) * inner, (z3 + sets.of("4")) * outer
    turn = 2 * np.pi / sets.planets
    s, tips = np.sin(turn / 2), 2 * float(task.addendum)
    across = np.sqrt(near**2 + far**2 - 2 * near * far * np.cos(turn)) / 2 - (z2 + z3) / 2
    least: Values = np.minimum.reduce([near * s - z2, far * s - z3, across]) - tips
    return least


def ring_difference(task: TrainTask, sets: ToothSets) -> Values:
    """Least number of teeth that a ring has more than its pinion."""
    inner = [abs(sets.of(m.first) - sets.of(m.second)) for m in sets.scheme.meshes if m.internal]
    least: Values = np.minimum.reduce(inner).astype(float)
    return least


def least_external(task: TrainTask, sets: ToothSets) -> Values:
    """Teeth of the smallest external wheel."""
    wheels = [sets.of(wheel) for wheel in sets.scheme.wheels if wheel not in sets.scheme.rings]
    least: Values = np.minimum.reduce(wheels).astype(float)
    return least


def steepest(task: TrainTask, sets: ToothSets) -> Values:
    """Largest ratio of one stage."""
    ratios = [sets.of(m.second) / sets.of(m.first) for m in sets.scheme.meshes]
    largest: Values = np.maximum.reduce(ratios)
    return largest


def unlikeness(task: TrainTask, sets: ToothSets) -> Values:
    """Largest relative difference of the diameters of the wheels of neighbouring stages."""
    names = sets.scheme.wheels
    if sets.scheme.branched:
        first, second = (sets.modules[:, k] for k in (0, 1))
        found: Values = abs(second * sets.of("3") / (first * sets.of("2")) - 1)
        return found
    parts = []
    for k in range(1, sets.scheme.stages):
        before, wide, wheel = (sets.of(names[place]) for place in (2 * k - 2, 2 * k - 1, 2 * k + 1))
        parts.append(abs(np.cbrt(wide / before) * wheel / wide - 1))
    largest: Values = np.maximum.reduce(parts)
    return largest


def largest_angle(task: TrainTask, sets: ToothSets) -> Values:
    """Largest operating pressure angle [rad]."""
    stretched = np.maximum.reduce(stretches(task, block_of(sets)))
    return np.arccos(np.minimum(np.cos(task.pressure_angle) / stretched, 1.0))


def distance(task: TrainTask, sets: ToothSets) -> Values:
    """Centre distance [m] of the wheels 1 and 2."""
    return centre_distances(task, block_of(sets))


def diameter(task: TrainTask, sets: ToothSets) -> Values:
    """Diameter [m] around the pitch circles."""
    return envelopes(task, block_of(sets))


def assembly_number(sets: ToothSets) -> Values:
    """R of the assembly condition (4.25, 4.26); a whole number if equally spaced planets fit in."""
    assert sets.scheme.assembly is not None
    numerator, denominator = sets.scheme.assembly(sets.by_wheel, sets.planets)[-1]
    found: Values = numerator / denominator
    return found


Measure = Callable[[TrainTask, ToothSets], Values]
