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

import numpy as np

from tmmcalc.gears.model import Values
from tmmcalc.gears.network.circulation import Loop, circulating
from tmmcalc.gears.network.directions import agreeing_directions
from tmmcalc.gears.network.equilibrium import Statics, equilibrium, residual
from tmmcalc.gears.network.model import FRAME, Network
from tmmcalc.gears.network.speeds import Locks, Motion, solve_speeds
from tmmcalc.records import record


@record
class PowerFlow:
    """Torques and powers of a train of n members, m meshes and l locks.

    Columns of ``mesh_torques`` and ``mesh_powers`` are first wheel, second wheel, carrier; all planets together.
    """

    motion: Motion
    torques: Values  # (n,) [N*m] outside torque on each member
    powers: Values  # (n,) [W] put in from outside
    mesh_torques: Values  # (m, 3) [N*m] that the mesh puts on members
    mesh_powers: Values  # (m, 3) [W] that the mesh gives to members, in the frame
    branch_torques: Values  # (m, 2) [N*m] size on both wheels of the most loaded planet's mesh
    rolling: Values  # (m,) [W] power that the first wheel gives to the second in the carrier's frame, at its source
    losses: Values  # (m,) [W]
    lock_torques: Values  # (l,) [N*m] on the first of the locked members
    power_in: float  # [W] sum of what is put in
    efficiency: float | None  # power given out to power put in; None if no power is put in
    self_locking: bool  # all power put in is lost
    loops: tuple[Loop, ...]  # power that circulates between members
    error: float  # largest residual of an equilibrium, relative to its terms

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
    return _flow(statics, directions, x)


def _flow(statics: Statics, directions: Values, x: Values) -> PowerFlow:
    network, motion = statics.network, statics.motion
    m, held = len(network.meshes), len(network.meshes) + len(statics.locked)
    torques = statics.load.copy()
    torques[[network.place[name] for name in statics.unknown]] = x[held:]
    powers = torques * motion.speeds
    mesh_torques, rolling, losses = _meshes(statics, directions, x[:m])
    mesh_powers = mesh_torques * _mesh_speeds(network, motion)
    locks = [(*pair, torque) for pair, torque in zip(statics.locked, x[m:held], strict=True)]
    power_in, power_out = float(powers[powers > 0].sum()), float(-powers[powers < 0].sum())
    return PowerFlow(
        motion,
        torques,
        powers,
        mesh_torques,
        mesh_powers,
        _branches(network, mesh_torques),
        rolling,
        losses,
        x[m:held],
        power_in,
        power_out / power_in if power_in else None,
        power_in > 0 and not power_out,
        circulating(network, mesh_powers, [(a, b, t * _speed(network, motion, a)) for a, b, t in locks]),
        residual(statics, directions, x),
    )


def _speed(network: Network, motion: Motion, name: str) -> float:
    return float(motion.speeds[network.place[name]]) if name != FRAME else 0.0


def _mesh_speeds(network: Network, motion: Motion) -> Values:
    """Speeds (m, 3) of first wheel, second wheel and carrier [rad/s]."""
    named = [(m.first, m.second, c) for m, c in zip(network.meshes, network.carriers, strict=True)]
    return np.array([[_speed(network, motion, name) for name in names] for names in named]).reshape(-1, 3)


def _meshes(statics: Statics, directions: Values, first: Values) -> tuple[Values, Values, Values]:
    """Torques (m, 3) on both wheels and the carrier, rolling powers (m,), losses (m,)."""
    network, speeds = statics.network, statics.motion.rolling
    exponent = np.zeros(len(first))
    exponent[statics.active] = directions
    eta = np.array([mesh.efficiency for mesh in network.meshes])
    teeth = np.array([-m.sign * m.second_teeth / m.first_teeth for m in network.meshes])
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
