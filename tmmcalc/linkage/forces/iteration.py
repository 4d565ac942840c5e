"""Friction as the textbook iterates it: reactions, friction from them, reactions again (fig. 3.9, table D.3.3).

The plain fixed point is kept to be seen: it needs a few passes where friction is small, creeps near self-locking and
never settles beyond a loop gain of one, where `friction` still has the solution.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.forces.dyad import DyadEquilibrium
from tmmcalc.linkage.forces.friction import size_of
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.wrench import Seat, Slideway, Wrench

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.group import GroupEquilibrium

    Equilibrium = DyadEquilibrium | GroupEquilibrium

STOP = 0.03  # relative change at which the textbook stops
NOTHING = 1e-12  # of the largest reaction: a smaller one is rounding, and counts as found
Judged = Literal["components", "reactions"]  # what of a pair has to settle


@record
class Iteration:
    """The history of friction in one group at one position, over m solutions.

    Friction values are what each joint does to the link of the group that is named first: in the outer joint of a and
    the inner one on link a, in the outer joint of b on link b. The u unknowns are two a joint: T and N of an outer
    revolute pair of a dyad, x and y of another one; N and the arm h of a prismatic pair.
    """

    group: str = quantity("group", "name of the group")
    acting: tuple[
        tuple[str, int], ...
    ]  # its joints, of a dyad outer of a, inner, outer of b, and the link that each acts on
    joints: tuple[str, ...]  # (k,) that rub
    units: tuple[str, ...]  # (k,) "N" of a prismatic pair, "N*m" of a revolute one
    friction: Real  # (m + 1, k) friction in every solution; last: what the last reactions give
    names: tuple[str, ...]  # (u,) of the unknowns, such as "A.T"
    unknowns: Real  # (m, u) [N], arms [m]
    change: Real = quantity(  # (m,) the first is 1
        "change", "largest relative change of an unknown from the solution before", source="(3.30)"
    )
    shift: Real  # (m,) the largest change of a reaction against its magnitude; the first is 1
    stopped: bool = quantity("settled", "the rule stopped the passes")
    exact: Real | None  # (u,) the unknowns of the solution that `friction` finds; None if the group locks itself
    exact_friction: Real | None  # (k,) and its friction

    @derived("passes", "solutions until the stop")
    def passes(self) -> int:
        """Solutions until the stop m."""
        return len(self.unknowns)


def textbook_iteration(
    statics: Statics,
    group: str,
    theta: float,
    side: float = 1.0,
    stop: float = STOP,
    most: int = 50,
    judged: Judged = "components",
) -> Iteration:
    """Iterate the friction of a group at the angle theta, from no friction on, until the stop rule holds.

    It stops where no unknown changes by more than ``stop`` of its new value (3.30), or no reaction by more than
    ``stop`` of its magnitude, beside which a component may be next to nothing; ``side`` tells from which side a pair
    at rest is taken. Raises `UsageError` if there is no such group.
    """
    cut = statics.cut_out(group, statics.scene.place(np.array([theta]), side), side)
    friction: list[Real] = [np.zeros(len(cut.c))]
    unknowns, change, shift = list[Real](), list[float](), list[float]()
    told = change if judged == "components" else shift
    forces = np.array([not name.endswith(".h") for name in _names(cut)])
    while len(unknowns) < most and not (told and told[-1] <= stop):
        found = cut.under(friction[-1][:, None]).reactions
        now = _unknowns(cut, found)
        if not np.all(np.isfinite(now)):
            break
        change.append(_change(unknowns[-1], now) if unknowns else 1.0)
        shift.append(_shift(unknowns[-1], now, forces) if unknowns else 1.0)
        unknowns.append(now)
        friction.append(_friction(cut, found))
    posts = [cut.plan.posts[k] for k in cut.c]
    exact = _exact(cut)
    return Iteration(
        group=group,
        acting=tuple((post.joint.name, post.receiver) for post in cut.plan.posts),
        joints=tuple(post.joint.name for post in posts),
        units=tuple("N*m" if post.joint.kind == "revolute" else "N" for post in posts),
        friction=np.array(friction),
        names=_names(cut),
        unknowns=np.array(unknowns),
        change=np.array(change),
        shift=np.array(shift),
        stopped=bool(told) and told[-1] <= stop,
        exact=exact[0] if exact is not None else None,
        exact_friction=exact[1] if exact is not None else None,
    )


def _exact(cut: Equilibrium) -> tuple[Real, Real] | None:
    """The unknowns and the friction (k,) of the solution; None if the group locks itself."""
    held = cut.solve((1,))
    if held.solution is not None and held.solution.locked.any():
        return None
    return _unknowns(cut, held.reactions), np.array([_one(held.friction[k]).real for k in cut.c])


def _change(before: Real, now: Real) -> float:
    """Largest relative change; an unknown that is nothing counts as found."""
    nothing = now == 0
    return float(np.max(np.where(nothing, 0.0, np.abs(now - before) / np.where(nothing, 1.0, np.abs(now)))))


def _shift(before: Real, now: Real, forces: np.ndarray) -> float:
    """Largest change of a reaction against its magnitude, of unknowns (u,) of which these are ``forces``, not arms."""
    new, old = (np.where(forces, each, 0.0).reshape(-1, 2) for each in (now, before))
    size = np.hypot(*new.T)
    counts = size > NOTHING * np.max(size)
    return float(np.max(np.hypot(*(new - old).T)[counts] / size[counts], initial=0.0))


def _friction(cut: Equilibrium, found: tuple[Wrench, ...]) -> Real:
    """Friction (k,) under these reactions: (3.27), (3.28)."""
    values = [-c * size_of(cut.seats[k], found[k], cut.plan.posts[k].half) for k, c in cut.c.items()]
    return np.array([_one(value).real for value in values])


def _names(cut: Equilibrium) -> tuple[str, ...]:
    """Names of the unknowns."""
    names = []
    for k, post in enumerate(cut.plan.posts):
        plain = k == 1 or not cut.plan.group.kind
        pair = ("N", "h") if post.joint.kind == "prismatic" else ("x", "y") if plain else ("T", "N")
        names += [f"{post.joint.name}.{part}" for part in pair]
    return tuple(names)


def _unknowns(cut: Equilibrium, found: tuple[Wrench, ...]) -> Real:
    """The unknowns (u,)."""
    inner = cut.seats[1] if isinstance(cut, DyadEquilibrium) else None
    return np.concatenate([_pair(seat, wrench, inner) for seat, wrench in zip(cut.seats, found, strict=True)])


def _pair(seat: Seat, wrench: Wrench, inner: Seat | None) -> Real:
    """T and N of an outer pin of a dyad, N to its inner hinge or normal to its inner guide; x, y; or N and h."""
    force, moment = _one(wrench.force), _one(wrench.moment).real
    if isinstance(seat, Slideway):
        normal = (np.conj(1j * _one(seat.e)) * force).real
        return np.array([normal, moment / normal if normal else 0.0])
    if inner is None or seat is inner:
        return np.array([force.real, force.imag])
    axis = 1j * _one(inner.e) if isinstance(inner, Slideway) else _one(inner.r - seat.r)
    along = np.conj(axis / abs(axis)) * force
    return np.array([along.imag, along.real])


def _one(z: Plane | Real) -> complex:
    return complex(np.ravel(z)[0])
