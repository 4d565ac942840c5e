"""Where planets of a carrier fit in beside the first ones: at angles as equal as whole teeth let them be.

With one central wheel held and the carrier turned by a part alpha of a turn, the planets roll, and another central
wheel of z teeth goes on by

    z (1 - i) alpha  teeth,  i its turns for one of that wheel with the carrier held

Planets fit in there if that is a whole number for all central wheels, for these then stand as they did.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from itertools import permutations

from tmmcalc.gears.network.model import FRAME, INTERNAL, Mesh, Network


def spread(network: Network, axes: Mapping[str, complex], bearer: str, unit: float) -> list[Fraction]:
    """The parts of a turn at which planets of a carrier stand, all that mesh with one another together.

    ``axes`` are the places of the members with wheels of the module ``unit`` [m]. Where not all fit in, or would run
    into each other, one stands for all.
    """
    planets = [name for name in network.members if network.bearer(name) == bearer]
    count = max(map(network.count, planets), default=1)
    step = _step(network, bearer)
    turns = [Fraction(k, count) if not step else round(Fraction(k, count) / step) * step for k in range(count)]
    if bearer != FRAME and (len({turn % 1 for turn in turns}) < count or _crowded(network, axes, bearer, turns, unit)):
        return [Fraction(0)]
    return turns


def _step(network: Network, bearer: str) -> Fraction:
    """The least part of a turn after which planets fit in again; 0: wherever they stand."""
    meshes = [mesh for mesh, carrier in zip(network.meshes, network.carriers, strict=True) if carrier == bearer]
    if bearer == FRAME or any(network.tilted(name) for mesh in meshes for name in (mesh.first, mesh.second)):
        return Fraction(0)
    central = {
        (name, teeth)
        for mesh in meshes
        for name, teeth in ((mesh.first, mesh.first_teeth), (mesh.second, mesh.second_teeth))
        if network.bearer(name) != bearer
    }
    rates = _rates(meshes, min(name for name, _ in central)) if central else {}
    steps = [1 / abs(z * (1 - rates[name])) for name, z in central if name in rates and rates[name] != 1]
    if not steps:
        return Fraction(0)
    return Fraction(math.lcm(*(each.numerator for each in steps)), math.gcd(*(each.denominator for each in steps)))


def _rates(meshes: list[Mesh], first: str) -> dict[str, Fraction]:
    """Turns of members for one of the ``first``, with the carrier held."""
    rates, grown = {first: Fraction(1)}, True
    while grown:
        grown = False
        for mesh in meshes:
            ends = (mesh.first, mesh.first_teeth), (mesh.second, mesh.second_teeth)
            for (one, z), (other, y) in (ends, ends[::-1]):
                if one in rates and other not in rates:
                    rates[other], grown = rates[one] * mesh.sign * Fraction(z, y), True
    return rates


def _crowded(network: Network, axes: Mapping[str, complex], bearer: str, turns: list[Fraction], unit: float) -> bool:
    """Whether the tip circles of planets that mesh with one another, or are alike, would run into each other."""
    sizes: dict[str, float] = {}
    pairs: set[tuple[str, str]] = set()
    for mesh in network.meshes:
        for name, teeth in ((mesh.first, mesh.first_teeth), (mesh.second, mesh.second_teeth)):
            if network.bearer(name) == bearer:
                sizes[name] = max(sizes.get(name, 0.0), unit * (teeth / 2 + 1))
                pairs.add((name, name))
        if mesh.sign != INTERNAL and network.bearer(mesh.first) == network.bearer(mesh.second) == bearer:
            pairs.add((mesh.first, mesh.second))
    ways = {other - one for one, other in permutations(turns, 2)}
    for one, other in pairs:
        for turn in ways:
            angle = 2 * math.pi * float(turn)
            apart = (axes[other] - axes[bearer]) * complex(math.cos(angle), math.sin(angle)) - axes[one] + axes[bearer]
            if abs(apart) < sizes[one] + sizes[other]:
                return True
    return False
