"""Where the axes of a train and the pitch points of its meshes lie, in one plane across the axes.

Members that turn about one axis share its place: those in mesh with the planets of a carrier, the carrier itself, and
members that are locked. The first axis is the origin; planets stand on one ray from the axis of their carrier, the
line of centres, and shafts of fixed axes in a row along it. Planets that mesh with one another and are not in line
stand where the triangle of their distances closes. Radii are those of operating pitch circles,

    r_1 = a z_1/(z_1 + z_2)        in an internal mesh a z/(z_ring - z_pinion)

so distances that two meshes have in common, whatever the modules, are kept exactly. A bevel planet turns across the
axis of its carrier: the plane is then that of both axes, its pitch points stand beside the line of centres by their
radius on the planet, and velocities are across the plane.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import acos, cos, pi, sin

from tmmcalc.core.records import record
from tmmcalc.gears.network.model import FRAME, INTERNAL, Mesh, Network

CLOSE = 1e-9  # part of a distance by which a triangle may be open


@record
class PitchPoint:
    """Where the pitch circles of two wheels touch."""

    mesh: int
    place: complex  # [m]
    radii: tuple[float, float]  # of both wheels [m]


@record
class Places:
    """The axes of all members and the pitch points of the meshes that have one."""

    axes: dict[str, complex]  # by member [m]; of a bevel planet the middle of its pitch points
    pitch: tuple[PitchPoint, ...]


def places(
    network: Network,
    distances: Sequence[float] | None = None,
    coaxial: Sequence[tuple[str, str]] = (),
    unit: float = 1e-3,
) -> Places:
    """The places of a network; ``distances`` are centre distances [m] of its meshes, else those of the module ``unit``.

    ``coaxial`` are pairs of members on one axis which the meshes do not tell of.

    >>> from tmmcalc.gears.network.builder import network_of
    >>> found = places(network_of("AIbar", (18, 48, 114)).network)
    >>> [round(1e3 * abs(place), 9) for place in found.axes.values()]
    [0.0, 33.0, 0.0, 0.0]
    >>> [round(1e3 * each.place.real, 9) for each in found.pitch]
    [9.0, 57.0]
    """
    plain = [_plain_distance(mesh, unit) for mesh in network.meshes]
    given = plain if distances is None else list(distances)
    return _Plane(network, given, coaxial, unit).solved()


def _plain_distance(mesh: Mesh, unit: float) -> float:
    total = mesh.first_teeth - mesh.second_teeth if mesh.sign == INTERNAL else mesh.first_teeth + mesh.second_teeth
    return unit * abs(total) / 2


class _Plane:
    """Axes as they find their places, one after the other."""

    def __init__(
        self, network: Network, distances: Sequence[float], coaxial: Sequence[tuple[str, str]], unit: float
    ) -> None:
        self.network, self.distances, self.unit = network, distances, unit
        self.axis = _axes(network, coaxial)  # the axis of a member, by the name of its first one
        self.at: dict[str, complex] = {}
        self.flat = [k for k, mesh in enumerate(network.meshes) if not self._bevel(mesh)]

    def _bevel(self, mesh: Mesh) -> bool:
        return self.network.tilted(mesh.first) or self.network.tilted(mesh.second)

    def solved(self) -> Places:
        """All axes, then the pitch points on the lines between them."""
        upright = [name for name in self.network.members if not self.network.tilted(name)]
        farthest = 0.0
        for name in sorted(upright, key=self._depth):
            axis = self.axis[name]
            if axis not in self.at:  # nothing that is placed meshes with it
                self.at[axis] = complex(1.5 * farthest)
                self._grow(axis)
            farthest = max((abs(place) for place in self.at.values()), default=0.0)
        points = [point for k in self.flat if (point := self._pitch(k)) is not None]
        axes = {name: self.at[self.axis[name]] for name in upright}
        for name in self.network.members:
            if self.network.tilted(name):
                own = [self._bevel_pitch(k, name) for k, mesh in enumerate(self.network.meshes) if name in _both(mesh)]
                points += [point for point in own if point is not None]
                there = [point.place.real for point in own if point is not None]
                axes[name] = complex(sum(there) / len(there) if there else 0.0)
        points.sort(key=lambda point: point.mesh)
        return Places({name: axes[name] for name in self.network.members}, tuple(points))

    def _depth(self, name: str) -> int:
        """How many members bear it, one on another."""
        bearer = self.network.bearer(name)
        return 0 if bearer == FRAME else 1 + self._depth(bearer)

    def _grow(self, start: str) -> None:
        """Place all axes that hang together with one, those nearest to it in the meshes first."""
        queue = [start]
        for axis in queue:
            for k, near, far in self._meshes_of(axis):
                other = self.axis[far]
                if other not in self.at:
                    self.at[other] = self._placed(k, near, far)
                    queue.append(other)

    def _meshes_of(self, axis: str) -> Iterator[tuple[int, str, str]]:
        """Meshes of an axis with another one; those of central wheels before those of planets among themselves."""
        found = []
        for k in self.flat:
            mesh = self.network.meshes[k]
            for near, far in (_both(mesh), _both(mesh)[::-1]):
                if self._axis(near, k) == axis and far != FRAME and self._axis(far, k) != axis:
                    among = self.network.bearer(near) == self.network.bearer(far) != FRAME
                    found.append((among, k, near, far))
        yield from ((k, near, far) for _, k, near, far in sorted(found, key=lambda each: each[0]))

    def _axis(self, name: str, k: int) -> str:
        """The axis of a wheel of a mesh; one fixed in the housing is on that of its carrier."""
        return self.axis[self.network.carriers[k] if name == FRAME else name]

    def _placed(self, k: int, near: str, far: str) -> complex:
        """The place of the axis of ``far`` beside that of ``near``, which is placed."""
        place, distance, carrier = self.at[self._axis(near, k)], self.distances[k], self.network.bearer(far)
        for j in self.flat if carrier != FRAME else ():  # a planet in mesh with one that stands already
            mesh = self.network.meshes[j]
            mate = mesh.second if mesh.first == far else mesh.first
            if far in _both(mesh) and self.network.bearer(mate) == carrier and self.axis[mate] in self.at:
                return self._beside(j, mate, far, self.at[self.axis[carrier]])
        there = place + distance
        meeting = {self.axis[name] for name in self._mates(far)}
        taken = any(abs(own - there) <= CLOSE * abs(distance) for axis, own in self.at.items() if axis in meeting)
        return place - distance if taken else there

    def _mates(self, name: str) -> Iterator[str]:
        """Members in mesh with those on the axis of one."""
        for k in self.flat:
            for near, far in (_both(self.network.meshes[k]), _both(self.network.meshes[k])[::-1]):
                if near != FRAME and far != FRAME and self.axis[near] == self.axis[name]:
                    yield far

    def _beside(self, k: int, near: str, far: str, centre: complex) -> complex:
        """A planet in mesh with a placed one: at the distance of both, on the orbit that a central wheel gives it.

        One that a coupling holds on the axis of the carrier has no direction; the other is then on the line of centres.
        """
        placed, orbit, apart = self.at[self.axis[near]] - centre, self._orbit(far), self.distances[k]
        own = abs(placed)
        if not own:
            return centre + (apart if orbit is None else orbit)
        if orbit is None:
            return centre + placed * (1 + apart / own)
        if not orbit:
            return centre
        cosine = (own * own + orbit * orbit - apart * apart) / (2 * own * orbit)
        cosine = max(-1.0, min(1.0, cosine))
        turned = 0.0 if 1 - cosine <= CLOSE else pi if 1 + cosine <= CLOSE else acos(cosine)
        return centre + orbit * placed / own * complex(cos(turned), sin(turned))

    def _orbit(self, planet: str) -> float | None:
        """The distance of a planet from the axis of its carrier by its first mesh with a central wheel."""
        for k in self.flat:
            mesh = self.network.meshes[k]
            other = mesh.second if mesh.first == planet else mesh.first
            if planet in _both(mesh) and (other == FRAME or self.network.bearer(other) != self.network.bearer(planet)):
                return self.distances[k]
        return None

    def _pitch(self, k: int) -> PitchPoint | None:
        """Where the pitch circles touch; None of wheels of equal teeth inside one another, a coupling."""
        mesh = self.network.meshes[k]
        first, second = (self.at[self._axis(name, k)] for name in _both(mesh))
        apart = second - first
        z1, z2 = mesh.first_teeth, mesh.second_teeth
        total = z1 - z2 if mesh.sign == INTERNAL else z1 + z2
        if not apart or not total:
            return None
        # of an internal mesh z1 - z2 is positive where the ring is first, and the point lies beyond the pinion
        return PitchPoint(k, first + apart * z1 / total, (abs(apart * z1 / total), abs(apart * z2 / total)))

    def _bevel_pitch(self, k: int, tilted: str) -> PitchPoint | None:
        """Where a bevel planet touches a wheel on the axis of its carrier; None of two tilted wheels."""
        mesh = self.network.meshes[k]
        if self.network.tilted(mesh.first) and self.network.tilted(mesh.second):
            return None
        wheel = mesh.second if mesh.first == tilted else mesh.first
        radii = self.unit * mesh.first_teeth / 2, self.unit * mesh.second_teeth / 2
        own, around = radii if mesh.first == tilted else radii[::-1]
        return PitchPoint(k, self.at[self._axis(wheel, k)] + complex(around, mesh.sign * own), radii)


def _both(mesh: Mesh) -> tuple[str, str]:
    return mesh.first, mesh.second


def _axes(network: Network, coaxial: Sequence[tuple[str, str]]) -> dict[str, str]:
    """The first member on the axis of every member that is not tilted, and of the frame."""
    first = {name: name for name in (FRAME, *network.members)}

    def join(one: str, other: str) -> None:
        old, new = first[other], first[one]
        for name, own in first.items():
            if own == old:
                first[name] = new

    for mesh, carrier in zip(network.meshes, network.carriers, strict=True):
        for name in _both(mesh):
            if carrier != FRAME and name != FRAME and network.bearer(name) != carrier and not network.tilted(name):
                join(carrier, name)
    for one, other in coaxial:
        join(one, other)
    return first
