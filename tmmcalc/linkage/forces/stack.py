"""Reactions of all joints at many angles, stacked in arrays, in blocks that stay in cache."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.kinetostatics import ForceState, Statics
from tmmcalc.linkage.forces.kinks import faces
from tmmcalc.linkage.forces.verification import residuals, virtual_drive
from tmmcalc.linkage.forces.wrench import Slideway
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.trace import BLOCK

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.friction import Solution


class Stack(NamedTuple):
    """Everything at n angles, one row a joint."""

    reaction: Plane  # (J, n)
    normal: Real
    couple: Real
    friction: Real
    drive: Real  # (n,)
    mesh: Plane | None
    equilibrium: Real
    virtual: Real
    faces: Real  # (F, n) forces whose signs the friction of sliders depends on

    def columns(self, which: slice) -> Stack:
        """The same at some of the angles."""
        parts: list[Any] = [None if part is None else part[..., which] for part in self]
        return Stack(*parts)


def stacked(statics: Statics, theta: Real, side: Real, *, checked: bool = True) -> tuple[Stack, dict[str, Solution]]:
    """Reactions at theta (n,), each from its side; and how the friction of each group came out.

    Unless ``checked`` the residuals are left at zero.
    """
    parts, locks = [], []
    for at in range(0, len(theta), BLOCK):
        place = statics.scene.place(theta[at : at + BLOCK], side[at : at + BLOCK])
        state = statics.solve(place, side[at : at + BLOCK])
        parts.append(_stack(statics, state, place, checked))
        locks.append(state.solutions)
    return _joined(parts), _together(locks)


def _together(locks: list[dict[str, Solution]]) -> dict[str, Solution]:
    """The solutions of all blocks, by the name of the group."""
    if len(locks) == 1 or not locks[0]:
        return locks[0]
    from tmmcalc.linkage.forces.friction import joined  # only what rubs needs it

    return {name: joined([part[name] for part in locks]) for name in locks[0]}


def _joined(parts: list[Stack]) -> Stack:
    if len(parts) == 1:
        return parts[0]
    columns: list[Any] = [
        None if column[0] is None else np.concatenate(column, axis=-1) for column in zip(*parts, strict=True)
    ]
    return Stack(*columns)


def _stack(statics: Statics, state: ForceState, place: Place, checked: bool = True) -> Stack:
    n, joints = len(place.theta), statics.joints
    reaction = np.empty((len(joints), n), complex)
    normal, couple, friction = (np.empty((len(joints), n)) for _ in range(3))
    for j, joint in enumerate(joints):
        found = state.reactions[joint.name]
        reaction[j], couple[j], friction[j] = found.wrench.force, found.wrench.moment, found.friction
        if isinstance(found.seat, Slideway):
            normal[j] = (np.conj(1j * found.seat.e) * reaction[j]).real
        else:
            normal[j] = np.abs(reaction[j])
    balance = np.maximum(*residuals(statics, state, place)) if checked else np.zeros(n)
    return Stack(
        reaction,
        normal,
        couple,
        friction,
        state.drive,
        state.mesh,
        balance,
        virtual_drive(statics, state, place) if checked else state.drive,
        faces(statics, state, (n,)),
    )
