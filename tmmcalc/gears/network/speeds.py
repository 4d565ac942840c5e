"""Speeds of all members of a train by one linear system, solved in exact fractions.

Unknowns are the speeds of the members; the equations are those of the meshes, of members locked to one another, and
the given speeds. All coefficients are whole numbers, so mobility, dependence and ratios are exact, and speeds are
rounded once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isfinite, pi

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.model import Values
from tmmcalc.gears.network.elimination import Reduced, reduce
from tmmcalc.gears.network.model import FRAME, WHERE, Mesh, Network

Locks = Sequence[tuple[str, str]]

AGREEMENT = Fraction(1, 10**9)  # of a speed given although it follows from the others, relative to their terms


@record
class Motion:
    """Speeds of a train of n members and m meshes. Positive directions are those of the frame's axes."""

    members: tuple[str, ...]  # (n,)
    driven: tuple[str, ...]  # (g,) members of given speed
    transfer: tuple[tuple[Fraction, ...], ...]  # (n, g) speed of a member for unit speed of each given one, exact
    exact: tuple[Fraction, ...]  # (n,) the speeds
    exact_rolling: tuple[tuple[Fraction, Fraction], ...]  # (m, 2)
    # (n,); of a tilted planet relative to its carrier
    speeds: Values = quantity("omega[rad/s]", "speed of the member")
    relative: Values = quantity("omega_rel[rad/s]", "speed of the member relative to its own carrier")  # (n,)
    rolling: Values  # (m, 2) [rad/s], both wheels relative to the carrier of the mesh
    mobility: int = quantity("mobility", "degrees of freedom before speeds are given", symbol="W")
    redundant: tuple[str, ...]  # meshes that others imply

    @derived("n[rpm]", "speed of the member")
    def turns(self) -> Values:
        """The speeds (n,) in turns a minute."""
        return self.speeds / (pi / 30)

    @derived("n_rel[rpm]", "speed of the member relative to its own carrier")
    def relative_turns(self) -> Values:
        """The same relative to the carriers."""
        return self.relative / (pi / 30)

    def speed(self, member: str) -> float:
        """Speed of a member [rad/s]."""
        return float(self.speeds[self.members.index(member)])


def mesh_row(network: Network, mesh: Mesh, carrier: str) -> list[int]:
    """Coefficients of z1 (w1 - wc) - sign z2 (w2 - wc) = 0."""
    row = [0] * len(network.members)
    for name, z in ((mesh.first, mesh.first_teeth), (mesh.second, -mesh.sign * mesh.second_teeth)):
        _add(network, row, name, z)
        if not network.tilted(name):
            _add(network, row, carrier, -z)
    return row


def lock_row(network: Network, first: str, second: str) -> list[int]:
    """Coefficients of w1 - w2 = 0; a tilted planet can be locked only to its own carrier."""
    row = [0] * len(network.members)
    for name, other, sign in ((first, second, 1), (second, first, -1)):
        if network.tilted(name):
            if network.bearer(name) != other:
                raise UsageError(
                    f"the tilted member {name!r} cannot be locked to {other!r}",
                    where=WHERE,
                    remedy=f"lock it to its carrier {network.bearer(name)!r}",
                )
            return [int(member == name) for member in network.members]
        _add(network, row, name, sign)
    return row


def _add(network: Network, row: list[int], name: str, coefficient: int) -> None:
    if name != FRAME:
        row[network.place[network.known(name)]] += coefficient


def constraint_rows(network: Network, locked: Locks = ()) -> list[list[int]]:
    """Rows of all meshes, then of all locks."""
    meshes = [mesh_row(network, mesh, c) for mesh, c in zip(network.meshes, network.carriers, strict=True)]
    return meshes + [lock_row(network, *pair) for pair in locked]


def mobility(network: Network, locked: Locks = ()) -> int:
    """Degrees of freedom: members less independent meshes and locks.

    >>> from tmmcalc.gears.network.model import Body
    >>> mobility(Network((Mesh("1", 18, "2", 48), Mesh("2", 48, "3", 114, 1)), (Body("2", "H"),)))
    2
    """
    return len(reduce(constraint_rows(network, locked), len(network.members)).free)


def ratio(network: Network, first: str, second: str, fixed: str | Sequence[str] = (), locked: Locks = ()) -> Fraction:
    """Exact ratio of speeds w_first / w_second with members fixed (Willis, textbook (4.19)).

    Raises `UsageError` if the speeds stay undetermined, `NoSolutionError` if ``second`` stands.

    >>> from tmmcalc.gears.network.model import Body
    >>> train = Network((Mesh("1", 18, "2", 48), Mesh("2", 48, "3", 114, 1)), (Body("2", "H"),))
    >>> ratio(train, "1", "H", fixed="3"), ratio(train, "1", "3", fixed="H")
    (Fraction(22, 3), Fraction(-19, 3))
    """
    held = (fixed,) if isinstance(fixed, str) else fixed
    motion = solve_speeds(network, {**dict.fromkeys(held, 0.0), second: 1.0}, locked)
    return motion.transfer[network.place[network.known(first)]][motion.driven.index(second)]


def solve_speeds(network: Network, speeds: Mapping[str, float], locked: Locks = ()) -> Motion:
    """Speeds of all members from given ones [rad/s]; 0 holds a member.

    Raises `UsageError` if too few or contradictory speeds are given, `NoSolutionError` if meshes hold one another or
    held members stop a driven one.
    """
    constraints = constraint_rows(network, locked)
    n = len(network.members)
    held_first = sorted(speeds, key=lambda name: speeds[name] != 0)
    given = {network.known(name): _finite(name, speeds[name]) for name in held_first}
    rows = constraints + [[int(member == name) for member in network.members] for name in given]
    reduced = reduce(rows, n)
    _refuse_contradiction(network, constraints)
    _refuse_excess(network, reduced, len(constraints), given)
    _refuse_open(network, reduced, given)
    transfer = tuple(tuple(reduced.response(c, len(constraints) + k) for k in range(len(given))) for c in range(n))
    exact = [sum((t * u for t, u in zip(row, given.values(), strict=True) if t), Fraction()) for row in transfer]
    rolling = [
        (_relative(network, exact, mesh.first, carrier), _relative(network, exact, mesh.second, carrier))
        for mesh, carrier in zip(network.meshes, network.carriers, strict=True)
    ]
    independent = len(constraints) - sum(i < len(constraints) for i in reduced.dependent)
    return Motion(
        network.members,
        tuple(given),
        transfer,
        tuple(exact),
        tuple(rolling),
        np.array([float(w) for w in exact]),
        np.array([float(_relative(network, exact, name, network.bearer(name))) for name in network.members]),
        np.array([[float(w) for w in pair] for pair in rolling]).reshape(-1, 2),
        n - independent,
        tuple(str(mesh) for i, mesh in enumerate(network.meshes) if i in reduced.dependent),
    )


def _finite(name: str, speed: float) -> Fraction:
    if isfinite(speed):
        return Fraction(speed)
    raise UsageError(f"the speed of {name!r} is {speed}", where=WHERE, remedy="give a finite speed in rad/s")


def _relative(network: Network, exact: Sequence[Fraction], name: str, carrier: str) -> Fraction:
    """Speed relative to a carrier; that of a tilted planet is relative as it is."""
    if name == FRAME:
        return -exact[network.place[carrier]] if carrier != FRAME else Fraction()
    speed = exact[network.place[name]]
    return speed if carrier == FRAME or network.tilted(name) else speed - exact[network.place[carrier]]


def _refuse_contradiction(network: Network, constraints: Sequence[Sequence[int]]) -> None:
    """Raise `NoSolutionError` where meshes hold one another: no motion that they admit rolls them."""
    if not _dead(network, constraints, len(network.meshes)):
        return
    first = next(j for j in range(1, len(network.meshes) + 1) if _dead(network, constraints, j))
    dead = _dead(network, constraints, first)
    named = ", ".join(str(network.meshes[j]) for j in dead)
    raise NoSolutionError(
        f"meshes {named} hold one another: they form a loop whose tooth numbers admit no rolling",
        where=WHERE,
        value=float(len(dead)),
        remedy="take one of them away, or give them tooth numbers of equal ratio",
    )


def _dead(network: Network, constraints: Sequence[Sequence[int]], count: int) -> list[int]:
    """Numbers of the meshes among the first ``count`` whose wheels never turn in their carrier."""
    motions = reduce(constraints[:count], len(network.members)).motions()
    return [
        j
        for j in range(count)
        if not any(_relative(network, motion, network.meshes[j].first, network.carriers[j]) for motion in motions)
    ]


def _refuse_excess(network: Network, reduced: Reduced, constraints: int, given: dict[str, Fraction]) -> None:
    """Raise where a given speed contradicts those before it; one that agrees is let be."""
    names = list(given)
    for i, row in reduced.dependent.items():
        if i < constraints:
            continue
        name = names[i - constraints]
        terms = {other: Fraction(-row[constraints + k], row[i]) for k, other in enumerate(names) if other != name}
        follows = sum((c * given[other] for other, c in terms.items()), Fraction())
        scale = max((abs(c * given[other]) for other, c in terms.items()), default=Fraction())
        if abs(follows - given[name]) <= AGREEMENT * scale:
            continue
        others = ", ".join(f"{other} = {float(given[other]):g}" for other, c in terms.items() if c) or "the meshes"
        message = f"member {name!r} is given {float(given[name]):g} rad/s, but {others} "
        if follows:
            message += f"make it {float(follows):g}"
            remedy = f"leave the speed of {name!r} out, or one of those that determine it"
        else:
            message += "let it not turn"
            remedy = f"release a held member, or drive another one than {name!r}"
        error = UsageError if follows else NoSolutionError
        raise error(message, where=WHERE, value=float(given[name]), limit=float(follows), remedy=remedy)


def _refuse_open(network: Network, reduced: Reduced, given: Mapping[str, Fraction]) -> None:
    """Raise `UsageError` where speeds stay undetermined."""
    if not reduced.free:
        return
    missing = ", ".join(network.members[c] for c in reduced.undetermined())
    stated = ", ".join(f"{name} = {float(speed):g}" for name, speed in given.items()) or "none"
    raise UsageError(
        f"the speeds of {missing} are not determined: {len(reduced.free)} more must be given (given: {stated})",
        where=WHERE,
        value=float(len(given)),
        limit=float(len(given) + len(reduced.free)),
        remedy="give the speed of one of them, hold it (0), or lock two members",
    )
