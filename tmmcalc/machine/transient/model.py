"""A drive as a chain of rotating masses from the motor to the crank, and its reduction to the crank's shaft.

      motor    shaft 1    gear 1          shaft 2    gear 2
    M_d -> [ J_1 ]---/\\/\\---( u_1 )---[ J_2 ]---/\\/\\---( u_2 )--- ... ---[ J_N + J(theta) ] <- load

A drive of N masses has N - 1 shafts. Masses, stiffnesses and dampings are given each on its own shaft; ``reduced``
carries them to the shaft of the last mass, the input shaft of the mechanism, where all speeds are equal
while the shafts are not twisted.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import accumulate
from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic


Back = Callable[[], tuple[Cycle, Cycle | None]]


@record
class Mass:
    """A rotating mass, rigid with everything that turns on its shaft."""

    inertia: float  # J on its own shaft [kg*m^2]
    name: str = ""

    def __post_init__(self) -> None:
        """Refuse an inertia that is no number or negative."""
        _check("the inertia of a mass", self.inertia, 0.0, "kg*m^2")


@record
class Shaft:
    """An elastic damped shaft and a gear behind it, between a mass and the next one towards the crank.

    An infinite ``stiffness`` makes the shaft rigid. ``behind_gear`` tells that the elastic part turns with the mass
    after the gear; by default it turns with the mass before it.
    """

    stiffness: float  # c [N*m/rad], on its own shaft; inf: rigid
    damping: float = 0.0  # k [N*m*s/rad], on its own shaft
    ratio: float = 1.0  # u: speed of the mass before over speed of the mass after it
    behind_gear: bool = False

    def __post_init__(self) -> None:
        """Refuse what cannot carry a moment."""
        if self.stiffness != math.inf:
            _check("the stiffness of a shaft", self.stiffness, 0.0, "N*m/rad")
        _check("the damping of a shaft", self.damping, 0.0, "N*m*s/rad")
        _check("the gear ratio of a shaft", self.ratio, 0.0, "", strict=True)
        if self.stiffness == self.damping == 0:
            raise UsageError(
                "a shaft without stiffness and damping carries no moment",
                where="transient motion",
                value=0.0,
                remedy="give stiffness [N*m/rad], or damping [N*m*s/rad] of a fluid coupling",
            )


@record
class Drive:
    """Motor, masses, shafts and load. The first mass carries the motor, the last one the ``cycle``."""

    masses: tuple[Mass, ...]  # (N,) from the motor to the crank
    shafts: tuple[Shaft, ...] = ()  # (N - 1,)
    characteristic: Characteristic | None = None  # of the motor, on the shaft of the first mass; None: no motor
    cycle: Cycle | None = None  # reduced moment and inertia on the shaft of the last mass; None: neither
    idle: Cycle | None = None  # the same cycle without the technological load: what a load factor 0 leaves
    time_constant: float = 0.0  # electromagnetic time constant tau_e of the motor [s]; 0: static characteristic
    back: Back | None = None  # if pairs rub: both cycles with the friction of the crank turning back

    def __post_init__(self) -> None:
        """Refuse a chain whose links do not fit together."""
        _check("the electromagnetic time constant", self.time_constant, 0.0, "s")
        if len(self.shafts) != len(self.masses) - 1:
            raise UsageError(
                f"{len(self.masses)} masses are joined by {len(self.masses) - 1} shafts, not {len(self.shafts)}",
                where="transient motion",
                value=len(self.shafts),
                remedy="one shaft between each mass and the next",
            )
        if any(mass.inertia == 0 for mass in self.masses[:-1]):
            raise UsageError(
                "a mass before the crank has no inertia",
                where="transient motion",
                value=0.0,
                remedy="give its inertia [kg*m^2], or join its two shafts into one",
            )


class Reduced(NamedTuple):
    """The chain of n groups of masses on the crank's shaft; masses joined by rigid shafts form one group."""

    ratio: tuple[float, ...]  # (N,) speed of every mass of the drive over the speed of the crank
    group: tuple[int, ...]  # (N,) to which group it belongs
    inertia: tuple[float, ...]  # (n,) [kg*m^2]
    stiffness: tuple[float, ...]  # (n - 1,) [N*m/rad]
    damping: tuple[float, ...]  # (n - 1,) [N*m*s/rad]

    @property
    def motor_ratio(self) -> float:
        """Speed of the motor's mass over the speed of the crank."""
        return self.ratio[0]


def ratios(drive: Drive) -> tuple[float, ...]:
    """Speed of every mass over the speed of the crank, (N,).

    >>> ratios(Drive((Mass(1.0), Mass(1.0), Mass(1.0)), (Shaft(1e5, ratio=2.0), Shaft(1e6, ratio=5.0))))
    (10.0, 5.0, 1.0)
    """
    upwards = accumulate((shaft.ratio for shaft in reversed(drive.shafts)), lambda u, v: u * v, initial=1.0)
    return tuple(reversed(tuple(upwards)))


def shaft_ratios(drive: Drive) -> tuple[float, ...]:
    """Speed of the elastic part of every shaft over the speed of the crank, (N - 1,)."""
    speed = ratios(drive)
    return tuple(speed[i + 1] if shaft.behind_gear else speed[i] for i, shaft in enumerate(drive.shafts))


def rigid_shafts(drive: Drive) -> frozenset[int]:
    """Indices of the shafts that are given as rigid."""
    return frozenset(i for i, shaft in enumerate(drive.shafts) if shaft.stiffness == math.inf)


def reduced(drive: Drive, rigid: frozenset[int] = frozenset()) -> Reduced:
    """Inertias, stiffnesses and dampings on the crank's shaft: J u^2, c u^2, k u^2; ``rigid`` shafts join masses."""
    speed, own = ratios(drive), shaft_ratios(drive)
    group = tuple(accumulate((int(i not in rigid) for i in range(len(drive.shafts))), initial=0))
    inertia = [0.0] * (group[-1] + 1)
    for mass, g, u in zip(drive.masses, group, speed, strict=True):
        inertia[g] += mass.inertia * u * u
    elastic = [i for i in range(len(drive.shafts)) if i not in rigid]
    return Reduced(
        speed,
        group,
        tuple(inertia),
        tuple(drive.shafts[i].stiffness * own[i] ** 2 for i in elastic),
        tuple(drive.shafts[i].damping * own[i] ** 2 for i in elastic),
    )


def _check(name: str, value: float, least: float, unit: str, *, strict: bool = False) -> None:
    if math.isfinite(value) and (value > least if strict else value >= least):
        return
    rule = "positive" if strict else "not negative"
    raise UsageError(
        f"{name} is {value:g} {unit}".rstrip() + f", it must be a {rule} number",
        where="transient motion",
        value=value,
        limit=least,
        remedy=f"give a {rule} number" + (f" in {unit}" if unit else ""),
    )
