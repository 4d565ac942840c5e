"""Where the wheels, arms and shafts of a train that is written out mesh by mesh stand in its scheme from the side.

The line of centres is upright, shafts lie across. Every mesh has a plane along the axes; planes are shared where wheels
do not run into each other, and follow one another so that shafts on one axis need not cross. A member inside another
one's hub leaves through it. A planet that stands beside the line of centres is seen in projection.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.gears.network.model import FRAME, INTERNAL, Network
from tmmcalc.gears.network.places import Places

ALIKE = 1e-9  # relative: lengths that are one
WIDE, STEP = 0.1, 0.26  # width of a wheel, distance of planes, in parts of the height of the train
RIM = 0.05  # of a ring, in the same parts
MOST = 5  # meshes whose planes are tried in all ways; those of more follow one another
EXIT = 0.75  # of a shaft beyond the last plane, in distances of planes
AXLES = 0.2  # length of the shaft of a bevel wheel, in parts of the height
FAR = 1e3  # beyond all planes, in the same parts


@record
class Wheel:
    """A wheel of a member."""

    member: str
    teeth: int
    radius: float  # [m]
    ring: bool
    meshes: tuple[int, ...]
    tilt: complex = 0j  # of bevel wheels s + i height of the pitch point from the place of the planet along the axis

    def like(self, other: Wheel) -> bool:
        """Whether it is the same wheel, seen in another mesh."""
        same = (self.member, self.teeth, self.ring) == (other.member, other.teeth, other.ring)
        return same and not self.tilt and not other.tilt and abs(self.radius - other.radius) < ALIKE * self.radius


@record
class Scheme:
    """Wheels and carriers with their planes."""

    network: Network
    at: Places
    wheels: tuple[Wheel, ...]
    planes: tuple[int, ...]  # by mesh
    arms: dict[str, float]  # where the arms of a carrier stand, in planes
    held: tuple[str, ...]
    unit: float  # height of the train [m]
    through: tuple[tuple[str, int], ...] = ()  # members that leave inside of others, to the right +1 or to the left -1

    def span(self, wheel: Wheel) -> tuple[int, int]:
        """The first and the last plane of a wheel."""
        own = [self.planes[k] for k in wheel.meshes]
        return min(own), max(own)

    def place(self, plane: float) -> float:
        """Where a plane stands along the axes, or at a half number the middle between two [m]."""
        sizes = [STEP / 2 * self.unit] * (max(self.planes) + 1)
        for wheel in self.wheels:
            if wheel.tilt:  # a bevel planet lies along the axis
                first = self.span(wheel)[0]
                sizes[first] = max(sizes[first], abs(wheel.tilt.real) + STEP / 3 * self.unit)
        edges = [2 * sum(sizes[:k]) for k in range(len(sizes) + 1)]
        k = int(plane + 0.5)
        return edges[k] if plane != k else edges[k] + sizes[k]

    def along(self, wheel: Wheel) -> tuple[float, float]:
        """From where to where along the axes a wheel reaches [m]."""
        first, last = self.span(wheel)
        shift, half = wheel.tilt.real, WIDE / 2 * self.unit * (0.3 if wheel.tilt else 1.0)
        return self.place(first) + shift - half, self.place(last) + shift + half

    def stands(self, member: str) -> list[float]:
        """Where along the axes a member has a wheel or an arm [m], ascending."""
        found = [end for wheel in self.wheels if wheel.member == member for end in self.along(wheel)]
        if member in self.arms:
            found.append(self.place(self.arms[member]))
        found += [side * FAR * self.unit for name, side in self.through if name == member]
        return sorted(found)

    def height(self, member: str) -> float:
        """The height of the axis of a member [m]."""
        return 0.0 if member == FRAME else self.at.axes[member].real

    @property
    def content(self) -> Plane:
        """Corners of all that is drawn."""
        corners = [complex(0.0, self.height(name)) for name in self.network.members]
        for wheel in self.wheels:
            reach = wheel.radius + (RIM * self.unit if wheel.ring else 0.0)
            axis = self.height(wheel.member)
            if wheel.tilt and self.network.tilted(wheel.member):
                middle = self.place(self.span(wheel)[0])
                over = 1j * AXLES * self.unit * (self.network.bearer(wheel.member) == FRAME)
                corners += [complex(middle + side * wheel.radius, axis) + over for side in (-1, 1)]
                continue
            corners += [complex(s, axis + side * reach) for s in self.along(wheel) for side in (-1, 1)]
        corners += [complex(self.place(arm), self.height(name)) for name, arm in self.arms.items()]
        low, high = (f(z.real for z in corners) for f in (min, max))
        over = EXIT * STEP * self.unit * (1.6 if self.through else 1.0)
        return np.array([*corners, complex(low - over), complex(high + over)])


def arranged(network: Network, at: Places, held: tuple[str, ...]) -> Scheme:
    """The scheme whose wheels and shafts are least in each other's way."""
    wheels = tuple(_wheels(network, at))
    count = len(network.meshes)
    reach = [abs(at.axes.get(wheel.member, 0j)) + wheel.radius for wheel in wheels]
    unit = max(reach, default=1e-3)
    carriers = [name for name in network.members if any(network.bearer(other) == name for other in network.members)]
    tried = product(range(count), repeat=count) if count <= MOST else [tuple(range(count))]
    best, least = None, np.inf
    for planes in tried:
        if set(planes) != set(range(max(planes, default=-1) + 1)):
            continue
        cost = _clashes(Scheme(network, at, wheels, planes, {}, held, unit)) + 2.0 * max(planes, default=0)
        if cost >= least:
            continue
        for sides in product((-1, 1), repeat=len(carriers)):
            arms = dict(_arms(network, wheels, planes, carriers, sides))
            scheme = Scheme(network, at, wheels, planes, arms, held, unit)
            total = cost + 10.0 * _interleaved(scheme)
            if total < least:
                best, least = scheme, total
    assert best is not None  # one plane for every mesh is always tried
    return replace(best, through=tuple(_through(best)))


def _wheels(network: Network, at: Places) -> Iterator[Wheel]:
    """All wheels, those that are in several meshes once."""
    found: list[Wheel] = []
    for point in at.pitch:
        mesh = network.meshes[point.mesh]
        tilted = network.tilted(mesh.first) or network.tilted(mesh.second)
        internal = mesh.sign == INTERNAL and not tilted
        tilt = complex(point.place.imag, point.place.real) if tilted else 0j
        for name, teeth, radius, other in (
            (mesh.first, mesh.first_teeth, point.radii[0], mesh.second_teeth),
            (mesh.second, mesh.second_teeth, point.radii[1], mesh.first_teeth),
        ):
            wheel = Wheel(name, teeth, radius, internal and teeth > other, (point.mesh,), tilt)
            same = next((k for k, own in enumerate(found) if own.like(wheel)), None)
            if same is None:
                found.append(wheel)
            else:
                own = found[same]
                found[same] = Wheel(own.member, own.teeth, own.radius, own.ring, (*own.meshes, point.mesh))
    yield from found


def _clashes(scheme: Scheme) -> float:
    """How many wheels run into one another."""
    found = 0.0
    slack = ALIKE * scheme.unit
    for k, one in enumerate(scheme.wheels):
        for other in scheme.wheels[k + 1 :]:
            (a, b), (c, d) = scheme.span(one), scheme.span(other)
            if b < c or d < a:
                continue
            if one.tilt or other.tilt:
                both = set(one.meshes) & set(other.meshes) or one.member == other.member
                planet = one.tilt and other.tilt and _planet(scheme, one) == _planet(scheme, other)
                found += 0.0 if both or planet else 100.0
                continue
            apart = abs(scheme.at.axes.get(one.member, 0j) - scheme.at.axes.get(other.member, 0j))
            if one.ring and other.ring:
                clash = True
            elif one.ring or other.ring:
                ring, inner = (one, other) if one.ring else (other, one)
                clash = apart + inner.radius > ring.radius + slack and inner.member != ring.member
            else:
                clash = apart < one.radius + other.radius - slack
            found += 100.0 * clash
    # a wheel that is wide
    return found + sum(0.5 * (scheme.span(wheel)[1] - scheme.span(wheel)[0]) for wheel in scheme.wheels)


def _planet(scheme: Scheme, wheel: Wheel) -> str:
    """The bevel planet of a mesh."""
    mesh = scheme.network.meshes[wheel.meshes[0]]
    return mesh.first if scheme.network.tilted(mesh.first) else mesh.second


def _arms(
    network: Network, wheels: tuple[Wheel, ...], planes: tuple[int, ...], carriers: list[str], sides: tuple[int, ...]
) -> Iterator[tuple[str, float]]:
    """Where the arms of carriers stand: before or after all the wheels that they bear."""
    for carrier, side in zip(carriers, sides, strict=True):
        own = [planes[k] for wheel in wheels if network.bearer(wheel.member) == carrier for k in wheel.meshes]
        if own:
            yield carrier, (max(own) + 0.5) if side > 0 else (min(own) - 0.5)


def _interleaved(scheme: Scheme) -> int:
    """Pairs of members on one axis of which neither stands in a gap of the other."""
    upright = [name for name in scheme.network.members if not scheme.network.tilted(name)]
    found = 0
    for k, one in enumerate(upright):
        for other in upright[k + 1 :]:
            if abs(scheme.at.axes[one] - scheme.at.axes[other]) > ALIKE * scheme.unit:
                continue
            found += not (
                _in_gap(scheme.stands(one), scheme.stands(other)) or _in_gap(scheme.stands(other), scheme.stands(one))
            )
    return found


def _in_gap(inner: list[float], outer: list[float]) -> bool:
    """Whether all of the first lie between two neighbours of the second, or beyond its ends."""
    return len({sum(at > edge for edge in outer) for at in inner}) <= 1


def _through(scheme: Scheme) -> Iterator[tuple[str, int]]:
    """The members that leave through the hollow shafts of others, one a side of every axis."""
    taken: list[tuple[float, int]] = []
    for name in scheme.network.members:
        stands, axis = scheme.stands(name), scheme.height(name)
        if not stands or scheme.network.tilted(name) or scheme.network.bearer(name) != FRAME or exit_of(scheme, name):
            continue
        sides = [side for side in (-1, 1) if (axis, side) not in taken]
        if sides and len([wheel for wheel in scheme.wheels if wheel.member == name and wheel.ring]) == 0:
            taken.append((axis, sides[0]))
            yield name, sides[0]


def exit_of(scheme: Scheme, name: str) -> int:
    """To which side the shaft of a member can leave: +1 right, -1 left, 0: something else on its axis is there."""
    solid = replace(scheme, through=())
    stands = solid.stands(name)
    on_axis = [
        at
        for other in scheme.network.members
        if other != name
        and not scheme.network.tilted(other)
        and abs(scheme.at.axes[other] - scheme.at.axes[name]) <= ALIKE * scheme.unit
        for at in solid.stands(other)
    ]
    if all(at > stands[0] for at in on_axis):
        return -1
    return 1 if all(at < stands[-1] for at in on_axis) else 0


def layers_of(scheme: Scheme) -> dict[str, int]:
    """How many shafts each member that stands across has inside of its own."""
    upright = [name for name in scheme.network.members if not scheme.network.tilted(name)]

    def inside(name: str, passed: tuple[str, ...] = ()) -> int:
        own = scheme.stands(name)
        through = [
            other
            for other in upright
            if other not in (name, *passed)
            and abs(scheme.at.axes[other] - scheme.at.axes[name]) <= ALIKE * scheme.unit
            and own
            and any(at < own[0] for at in scheme.stands(other))
            and any(at > own[-1] for at in scheme.stands(other))
        ]
        return max((1 + inside(other, (*passed, name)) for other in through), default=0)

    return {name: inside(name) for name in upright}


def web_of(scheme: Scheme, ring: Wheel) -> float:
    """Where the web of a ring goes down to its axis: away from the arms that bear what runs in it."""
    start, end = scheme.along(ring)
    mates = [_mate(scheme.network, k, ring.member) for k in ring.meshes]
    arms = [scheme.arms[scheme.network.bearer(mate)] for mate in mates if scheme.network.bearer(mate) in scheme.arms]
    left = any(scheme.place(arm) > end for arm in arms)
    clear = 0.3 * STEP * scheme.unit
    return start - clear if left else end + clear


def _mate(network: Network, k: int, member: str) -> str:
    mesh = network.meshes[k]
    return mesh.second if mesh.first == member else mesh.first
