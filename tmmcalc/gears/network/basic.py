"""Whether a train is a simple planetary one: two central wheels joined by one chain of planets on one carrier.

Such a train has the closed formulas of the textbook whatever its wheels, bevel ones too: wheel 1 is the central wheel
that moves, wheel 3 the held one (4.19).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import prod

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.network.model import FRAME, Network
from tmmcalc.gears.network.speeds import ratio


@record
class BasicTrain:
    """A simple planetary train."""

    first: str  # central wheel that moves
    carrier: str
    last: str  # central wheel that is held, or the frame
    ratio: Fraction  # i_1H
    efficiency: float = quantity("eta_0", "efficiency of the inverted train: of all meshes one after the other")


def basic_train(network: Network, held: Sequence[str]) -> BasicTrain | None:
    """The simple planetary train that a network is with one member held; None if it is none.

    >>> from tmmcalc.gears.network.builder import network_of
    >>> found = basic_train(network_of("AIbar", (18, 48, 114), efficiency=0.97).network, ("3",))
    >>> found.first, found.carrier, str(found.ratio), round(found.efficiency, 4)
    ('1', 'H', '22/3', 0.9409)
    """
    carriers = {*network.carriers}
    carrier = next(iter(carriers)) if len(carriers) == 1 else FRAME
    centrals = _ends_of_chain(network, carrier)
    still = [name for name in centrals if name == FRAME or name in held]
    moving = [name for name in centrals if name not in still]
    if carrier == FRAME or carrier in held or len(still) != 1 or len(moving) != 1:
        return None
    if {*network.members} - {carrier, *centrals} != _planets(network, carrier) or len(held) > 1:
        return None
    fixed = [name for name in still if name != FRAME]
    i_1h = ratio(network, moving[0], carrier, fixed)
    if not i_1h:
        return None
    return BasicTrain(moving[0], carrier, still[0], i_1h, prod(mesh.efficiency for mesh in network.meshes))


def _planets(network: Network, carrier: str) -> set[str]:
    return {name for name in network.members if network.bearer(name) == carrier}


def _ends_of_chain(network: Network, carrier: str) -> tuple[str, ...]:
    """The two wheels between which the meshes form one chain over all planets; empty if they do not."""
    planets = _planets(network, carrier)
    wheels = [name for mesh in network.meshes for name in (mesh.first, mesh.second)]
    centrals = [name for name in wheels if name not in planets]
    passed = all(wheels.count(planet) == 2 for planet in planets)
    if len(centrals) != 2 or centrals[0] == centrals[1] or not passed or not _is_joined(network, centrals[0]):
        return ()
    return tuple(centrals)


def _is_joined(network: Network, start: str) -> bool:
    """Whether all meshes hang together."""
    reached, left = {start}, list(network.meshes)
    while touched := [mesh for mesh in left if {mesh.first, mesh.second} & reached]:
        left = [mesh for mesh in left if mesh not in touched]
        reached.update(name for mesh in touched for name in (mesh.first, mesh.second))
    return not left
