"""The rotor in one of its planes, in the functions of one basis: what tells how fine the basis is, and all else too."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.vibration.pencil import Pencil
from tmmcalc.vibration.pendulum.basis import Basis
from tmmcalc.vibration.pendulum.energies import Matrices, matrices
from tmmcalc.vibration.pendulum.task import PendulumTask
from tmmcalc.vibration.pendulum.whirl import Critical, critical_speeds, lowest, whirl


@record
class Plane:
    """A plane with its whirl at speeds of spin, that of the task first, and its critical speeds."""

    number: int  # 0 of xz, 1 of yz
    basis: Basis
    parts: Matrices
    count: int  # modes that are asked for and that there are
    spins: Values  # (s,)
    pencil: Pencil  # of whirl at these
    critical: tuple[Critical, ...]  # forward and backward; empty: it does not spin

    @property
    def frequencies(self) -> Values:
        """Of whirl, and critical speeds, in a row."""
        both = lowest(self.pencil, self.count)
        return np.concatenate([part.ravel() for part in (*both, *(each.speeds for each in self.critical))])

    def at(self, spin: int) -> Pencil:
        """The whirl at one of the speeds of spin."""
        return Pencil(*(each[spin] for each in self.pencil))


def plane_of(task: PendulumTask, number: int, basis: Basis) -> Plane:
    """Plane 0 (v) or 1 (w); speeds of spin are that of the task and the ends of the diagram."""
    parts, count = matrices(task, basis, number), min(task.modes, basis.count)
    spins = np.array([task.spin] if task.speeds is None else [task.spin, task.speeds.low, task.speeds.high])
    critical = critical_speeds(parts, count) if may_spin(task) else ()
    return Plane(number, basis, parts, count, spins, whirl(parts, spins), critical)


def may_spin(task: PendulumTask) -> bool:
    """Whether critical speeds and the whirl of an unbalance are of interest."""
    return task.axisymmetric and (task.spin != 0 or task.speeds is not None)
