"""Willis' equation of every train of wheels on one carrier, with the numbers of its teeth and of its speeds.

    (w_a - w_c)/(w_b - w_c) = i_ab^c,   i_ab^c the product of sign z_b/z_a over the meshes from a to b      (4.19)

One equation ties the first central wheel on a carrier to each other wheel that hangs together with it there, central
ones and planets. On fixed axes w_c = 0, and the equation is that of an ordinary train.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.letters import filled, teeth_of
from tmmcalc.gears.network.model import FRAME, INTERNAL, Network
from tmmcalc.gears.network.speeds import Motion
from tmmcalc.gears.scheme import Layout

Wheels = Sequence[tuple[str, str]]  # names of both wheels of every mesh


@record
class Willis:
    """One equation."""

    carrier: str = quantity("carrier", "the member that is taken to stand")
    first: str = quantity("first", "the central wheel that the ratio counts from")
    last: str = quantity("last", "the wheel that it is tied to")
    planet: bool = quantity("planet", "whether that is a planet, and no central wheel")
    path: tuple[str, ...] = quantity("path", "members from the first to the last, as they mesh")
    formula: str = quantity("formula", "the equation in letters")
    numbers: str = quantity("numbers", "the same with numbers, speeds in rad/s")
    inverted: float = quantity("i_inverted", "ratio of the inverted train", symbol="i^c", source="(4.19)")
    exact: str = quantity("i_inverted_exact", "the same as a fraction")
    first_relative: float = quantity("omega_first_rel[rad/s]", "speed of the first against the carrier")
    last_relative: float = quantity("omega_last_rel[rad/s]", "speed of the last against the carrier")
    held: float | None = quantity(  # None: the last is a planet, or the carrier is the frame
        "i_carrier", "ratio of the first to the carrier with the last held, 1 - i^c", source="(4.19)"
    )

    @property
    def name(self) -> str:
        """The wheels that it ties together, by which it is known among the others."""
        return f"{self.first}-{self.last}"


def willis(network: Network, motion: Motion, wheels: Wheels | None = None) -> tuple[Willis, ...]:
    """The equations of all carriers in the order of the meshes; ``wheels`` name the wheels of the meshes.

    >>> from tmmcalc.gears.network.builder import network_of
    >>> from tmmcalc.gears.network.speeds import solve_speeds
    >>> train = network_of("AIbar", (18, 48, 114))
    >>> found = willis(train.network, solve_speeds(train.network, {"1": 22.0, "3": 0.0}))
    >>> [(each.first, each.last, each.exact) for each in found]
    [('1', '2', '-8/3'), ('1', '3', '-19/3')]
    >>> found[1].formula, found[1].numbers
    ('(omega_1 - omega_H)/(omega_3 - omega_H) = (-Z2/Z1)*(Z3/Z2)', '(22 - 3)/(0 - 3) = (-48/18)*(114/48)')
    """
    named = wheel_names(network) if wheels is None else wheels
    return tuple(
        _equation(network, motion, named, carrier, path)
        for carrier in dict.fromkeys(network.carriers)
        for path in _paths(network, carrier)
    )


def wheel_names(network: Network, layout: Layout | None = None) -> tuple[tuple[str, str], ...]:
    """Names of both wheels of every mesh: those of the layout; else of the member, with ' for its further wheels."""
    if layout is not None:
        return tuple((mesh.first, mesh.second) for mesh in layout.meshes)
    known: dict[str, list[int]] = {}

    def named(member: str, teeth: int) -> str:
        own = known.setdefault(member, [])
        if teeth not in own:
            own.append(teeth)
        return member + "'" * own.index(teeth)

    return tuple((named(m.first, m.first_teeth), named(m.second, m.second_teeth)) for m in network.meshes)


def _paths(network: Network, carrier: str) -> Iterator[list[tuple[int, str]]]:
    """The meshes, each with the member that it leads to, from a first wheel on the carrier to each other one."""
    meshes = [k for k, own in enumerate(network.carriers) if own == carrier]
    members = [name for k in meshes for name in (network.meshes[k].first, network.meshes[k].second)]
    centrals = [name for name in members if carrier == FRAME or network.bearer(name) != carrier]
    left = list(dict.fromkeys((*centrals, *members)))
    while left:
        ways: dict[str, list[tuple[int, str]]] = {left[0]: []}
        queue = [left[0]]
        for name in queue:
            for k in meshes:
                mesh = network.meshes[k]
                other = mesh.second if mesh.first == name else mesh.first if mesh.second == name else None
                if other is not None and other not in ways:
                    ways[other] = [*ways[name], (k, other)]
                    queue.append(other)
        yield from ([(-1, left[0]), *way] for way in ways.values() if way)
        left = [name for name in left if name not in ways]


def _equation(
    network: Network, motion: Motion, wheels: Wheels, carrier: str, path: Sequence[tuple[int, str]]
) -> Willis:
    first, last = path[0][1], path[-1][1]
    terms: list[str] = []
    teeth: dict[str, float] = {}
    ratio, at = Fraction(1), first
    for k, other in path[1:]:
        mesh, names = network.meshes[k], wheels[k]
        numbers = mesh.first_teeth, mesh.second_teeth
        (from_, to), (own, next_) = (names, numbers) if mesh.first == at else (names[::-1], numbers[::-1])
        ratio *= Fraction(mesh.sign * next_, own)
        terms.append(f"({'' if mesh.sign == INTERNAL else '-'}{teeth_of(to)}/{teeth_of(from_)})")
        teeth |= {teeth_of(from_): own, teeth_of(to): next_}
        at = other
    one, other_speed = (_relative(network, motion, name, carrier) for name in (first, last))
    letters = [_letters(network, name, carrier) for name in (first, last)]
    product = "*".join(terms)
    left = "/".join(f"({each})" if " " in each else each for each in letters)
    formula = f"{left} = {product}"
    if not other_speed:  # nothing turns against the carrier: without a quotient
        formula = f"{letters[0]} = {product}*{f'({letters[1]})' if ' ' in letters[1] else letters[1]}"
    planet = carrier != FRAME and network.bearer(last) == carrier
    return Willis(
        carrier,
        first,
        last,
        planet,
        tuple(name for _, name in path),
        formula,
        filled(formula, {**teeth, **_speeds(network, motion)}),
        float(ratio),
        str(ratio),
        float(one),
        float(other_speed),
        None if planet or carrier == FRAME else float(1 - ratio),
    )


def _speeds(network: Network, motion: Motion) -> Mapping[str, float]:
    return {_omega(name): speed for name, speed in zip(network.members, motion.speeds.tolist(), strict=True)} | {
        _omega(FRAME): 0.0
    }


def _omega(name: str) -> str:
    return f"omega_{name}"


def _letters(network: Network, name: str, carrier: str) -> str:
    """Speed against the carrier in letters; that of a tilted member is so as it is."""
    if carrier == FRAME or network.tilted(name):
        return _omega(name)
    return f"{_omega(name)} - {_omega(carrier)}"


def _relative(network: Network, motion: Motion, name: str, carrier: str) -> Fraction:
    def speed(member: str) -> Fraction:
        return Fraction() if member == FRAME else motion.exact[network.place[member]]

    return speed(name) if network.tilted(name) else speed(name) - speed(carrier)
