"""Torques of a moving train with the losses of its meshes, and the power that flows through it.

A mesh puts a torque on each of its wheels and their sum, reversed, on the carrier. In the carrier's frame the wheels
roll as in an ordinary pair, and the loss is a part of this *rolling* (potential) power:

    first wheel drives in that frame    T2 = -sign (z2/z1) T1 eta
    second wheel drives                 T2 = -sign (z2/z1) T1 / eta

Which one drives follows from the torques, so directions are those of the train without losses, corrected until they
agree with the torques that they lead to. If none agree the train locks itself.

Torques on members are positive along the positive speed; an outside torque times speed is power put in.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.extended import EPS, MARGIN, apart
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.circulation import Loop, circulating
from tmmcalc.gears.network.directions import agreeing_directions
from tmmcalc.gears.network.equilibrium import Statics, equilibrium, residual
from tmmcalc.gears.network.errors import FlowError, corrected
from tmmcalc.gears.network.model import FRAME, Network
from tmmcalc.gears.network.speeds import Locks, Motion, solve_speeds


@record
class PowerFlow:
    """Torques and powers of a train of n members, m meshes and l locks.

    Columns of ``mesh_torques`` and ``mesh_powers`` are first wheel, second wheel, carrier; all planets together.
    """

    motion: Motion
    torques: Values = quantity("torque[N*m]", "outside torque on the member")  # (n,)
    powers: Values = quantity("power[W]", "power put in from outside")  # (n,)
    mesh_torques: Values = quantity("T_{member}[N*m]", "torque that the mesh puts on the member")  # (m, 3)
    mesh_powers: Values = quantity("P_{member}[W]", "power that the mesh gives to the member, in the frame")  # (m, 3)
    branch_torques: Values = quantity(  # (m, 2)
        "T_{member}_planet[N*m]", "size of the torque on the wheel in the most loaded planet's mesh"
    )
    rolling: Values = quantity(  # (m,)
        "P_roll[W]", "power that the first wheel gives to the second in the carrier's frame, at its source"
    )
    losses: Values = quantity("loss[W]", "power lost in the mesh")  # (m,)
    lock_torques: Values = quantity("lock_torques[N*m]", "torque on the first of the locked members")  # (l,)
    power_in: float = quantity("power_in[W]", "sum of the powers put in")
    efficiency: float | None = quantity(  # None if no power is put in
        "efficiency", "power given out to power put in"
    )
    self_locking: bool  # all power put in is lost
    loops: tuple[Loop, ...]  # power that circulates between members
    residual: float  # largest of an equilibrium, relative to its terms
    error: FlowError

    @derived("power_lost[W]", "power lost in all meshes")
    def power_lost(self) -> float:
        """Sum of the losses [W]."""
        return float(self.losses.sum())

    def torque(self, member: str) -> float:
        """Outside torque on a member [N*m]."""
        return float(self.torques[self.motion.members.index(member)])

    def power(self, member: str) -> float:
        """Power put in at a member from outside [W]."""
        return float(self.powers[self.motion.members.index(member)])


def solve_power(
    network: Network,
    speeds: Mapping[str, float],
    torques: Mapping[str, float],
    outputs: Sequence[str] = (),
    locked: Locks = (),
) -> PowerFlow:
    """Torques, powers and losses of a train at given speeds [rad/s] and outside torques [N*m].

    Equilibrium gives the outside torques of members of given speed (driven or held) and of ``outputs``, save those in
    ``torques``; all other members are free of outside torque. Raises `UsageError` if equilibrium needs more or fewer
    unknown torques, `NoSolutionError` if the train locks itself, and what `solve_speeds` raises.
    """
    return power_in_motion(network, solve_speeds(network, speeds, locked), torques, outputs, locked)


def power_in_motion(
    network: Network,
    motion: Motion,
    torques: Mapping[str, float],
    outputs: Sequence[str] = (),
    locked: Locks = (),
) -> PowerFlow:
    """The same for speeds that `solve_speeds` found under the same locks; raises the other errors."""
    statics = equilibrium(network, motion, torques, tuple(outputs), tuple(locked))
    directions, x = agreeing_directions(statics)
    found = _values(statics, directions, x)
    power_in = float(found.powers[found.powers > 0].sum())
    power_out = float(-found.powers[found.powers < 0].sum())
    locks = zip(locked, found.lock_torques, strict=True)
    return PowerFlow(
        motion,
        found.torques,
        found.powers,
        found.mesh_torques,
        found.mesh_powers,
        _branches(network, found.mesh_torques),
        found.rolling,
        found.losses,
        found.lock_torques,
        power_in,
        power_out / power_in if power_in else None,
        power_in > 0 and not power_out,
        circulating(network, found.mesh_powers, [(a, b, t * _speed(network, motion, a)) for (a, b), t in locks]),
        residual(statics, directions, x),
        _error(statics, directions, x, found),
    )


class _Values(NamedTuple):
    """The arrays of a power flow, in the kind of numbers of its equilibrium."""

    torques: Values
    powers: Values
    mesh_torques: Values
    mesh_powers: Values
    rolling: Values
    losses: Values
    lock_torques: Values


def _values(statics: Statics, directions: Values, x: Values) -> _Values:
    network, motion = statics.network, statics.motion
    m, held = len(network.meshes), len(network.meshes) + len(statics.locked)
    torques = statics.load.copy()
    torques[[network.place[name] for name in statics.unknown]] = x[held:]
    mesh_torques, rolling, losses = _meshes(statics, directions, x[:m])
    mesh_powers = mesh_torques * _mesh_speeds(network, motion)
    return _Values(torques, torques * motion.speeds, mesh_torques, mesh_powers, rolling, losses, x[m:held])


def _error(statics: Statics, directions: Values, x: Values, found: _Values) -> FlowError:
    """Against the same in extended precision; where nothing is loaded all torques are zero, exactly."""
    if not statics.load.any():
        return FlowError(0.0, 0.0, 0.0)
    wide, better, passed = corrected(statics, directions, x)
    exact = _values(wide, directions, better)
    loaded = float(np.max(passed) / np.max(np.abs(better)))
    outside = float(np.max(np.abs(exact.powers)))
    missed = float(np.sum(np.abs(found.powers - exact.powers))) / outside if outside else 0.0
    return FlowError(
        apart(*(_flat(each.torques, each.mesh_torques, each.lock_torques) for each in (found, exact))) + loaded,
        apart(*(_flat(each.powers, each.mesh_powers, each.rolling, each.losses) for each in (found, exact))) + loaded,
        MARGIN * missed + loaded + EPS,
    )


def _flat(*arrays: Values) -> Values:
    return np.concatenate([array.ravel() for array in arrays])


def _speed(network: Network, motion: Motion, name: str) -> float:
    speed: float = motion.speeds[network.place[name]] if name != FRAME else 0.0
    return speed


def _mesh_speeds(network: Network, motion: Motion) -> Values:
    """Speeds (m, 3) of first wheel, second wheel and carrier [rad/s]."""
    named = [(m.first, m.second, c) for m, c in zip(network.meshes, network.carriers, strict=True)]
    return np.array([[_speed(network, motion, name) for name in names] for names in named]).reshape(-1, 3)


def _meshes(statics: Statics, directions: Values, first: Values) -> tuple[Values, Values, Values]:
    """Torques (m, 3) on both wheels and the carrier, rolling powers (m,), losses (m,)."""
    network, speeds = statics.network, statics.motion.rolling
    exponent = np.zeros(len(first))
    exponent[statics.active] = directions
    eta = np.array([mesh.efficiency for mesh in network.meshes], first.dtype)
    number = first.dtype.type
    teeth = np.array([-m.sign * m.second_teeth / number(m.first_teeth) for m in network.meshes])
    parallel = np.array([[not network.tilted(n) for n in (m.first, m.second)] for m in network.meshes]).reshape(-1, 2)
    wheels = np.stack((first, first * teeth * eta**exponent), axis=1)
    powers = wheels * speeds
    source = np.where(powers[:, 0] <= 0, -powers[:, 0], -np.maximum(-powers[:, 1], 0.0))
    torques = np.column_stack((wheels, -(wheels * parallel).sum(axis=1)))
    losses = np.where(exponent != 0, np.abs(source) * (1 - eta), 0.0)
    return torques, source, losses


def _branches(network: Network, mesh_torques: Values) -> Values:
    """Sizes (m, 2) of the torques that the most loaded of the parallel planets takes."""
    shares = []
    for mesh in network.meshes:
        several = max((mesh.first, mesh.second), key=network.count)
        shares.append(network.sharing(several) / network.count(several))
    return np.abs(mesh_torques[:, :2]) * np.array(shares).reshape(-1, 1)
