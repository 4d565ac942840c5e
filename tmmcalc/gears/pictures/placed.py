"""A gear train to scale: its circles, where their axes stand, in which planes its wheels mesh.

The main axis is the origin of the end view; planets stand on rays, the first one upward, axes of unfolded trains in a
row to the right. Lengths are metres, or modules of stage 1 as long as that module is not known.
"""

from __future__ import annotations

import math
from itertools import permutations, product

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.criteria.size import RACK, centre_distances, orbits
from tmmcalc.gears.criteria.wheels import stage_of
from tmmcalc.gears.model import ToothSets, Values
from tmmcalc.gears.scheme import Layout, Mesh

ALIKE = 1e-9  # relative: lengths that are one


@record
class Wheel:
    """A wheel with all its places."""

    name: str
    teeth: int
    module: float  # [m, or m1]
    pitch: tuple[tuple[float, int], ...]  # radii of the circles that roll, with their planes; mostly one
    reference: float  # radius
    tip: float  # radius of the tips
    planes: tuple[int, int]  # of meshing, the first and the last
    axes: tuple[complex, ...]  # end view; of planets one a ray
    internal: bool
    planet: bool
    fixed: bool

    @property
    def outer(self) -> float:
        """Radius of the largest of its circles."""
        return max(self.tip, self.rolling)

    @property
    def rolling(self) -> float:
        """Radius of its larger pitch circle."""
        return max(radius for radius, _ in self.pitch)


@record
class Gap:
    """The least gap between the tips of neighbouring planets."""

    size: float  # [m, or m1]; negative: they overlap
    ends: tuple[complex, complex]  # on the tip circles, end view


@record
class PlacedTrain:
    """A train to scale."""

    scheme: Layout
    planets: int  # K
    wheels: tuple[Wheel, ...]
    modules: tuple[float, ...]  # of the stages [m, or m1]
    widths: tuple[float, ...] | None  # of the stages [m]; None: not known
    known: bool  # whether the modules are known, and lengths metres
    estimated: bool  # whether even their relation is taken from (4.4)
    distances: tuple[float, ...]  # of the meshes [m, or m1]
    angles: tuple[float, ...]  # [rad] operating pressure angles of the meshes
    output: str  # shaft against wheel 1: a wheel or the carrier H
    driver: str  # wheel 1 or the output shaft

    def wheel(self, name: str) -> Wheel:
        """The wheel of this name."""
        return self.wheels[self.scheme.index(name)]

    @property
    def planes(self) -> int:
        """Number of planes of meshing."""
        return 1 + max(wheel.planes[1] for wheel in self.wheels)

    @property
    def height(self) -> float:
        """Diameter around all circles, of unfolded trains that of the largest wheel."""
        if not self.scheme.branched:
            return 2 * max(wheel.outer for wheel in self.wheels)
        return 2 * max(abs(wheel.axes[0]) + wheel.outer for wheel in self.wheels)

    @property
    def gap(self) -> Gap | None:
        """The least gap between planets of different rays, the undermost of equals; None for fewer than three rays."""
        if self.planets < 3:
            return None
        found = [
            _gap(one, one.axes[k], other, other.axes[j])
            for one, other in product([wheel for wheel in self.wheels if wheel.planet], repeat=2)
            if one.planes[0] <= other.planes[1] and other.planes[0] <= one.planes[1]
            for k, j in permutations(range(self.planets), 2)
        ]
        least = min((gap.size for gap in found), default=0.0)
        equal = [gap for gap in found if gap.size <= least + ALIKE * self.height]
        return min(equal, key=lambda gap: sum(gap.ends).imag, default=None)


def _gap(one: Wheel, at: complex, other: Wheel, axis: complex) -> Gap:
    along = (axis - at) / abs(axis - at)
    return Gap(abs(axis - at) - one.tip - other.tip, (at + along * one.tip, axis - along * other.tip))


def placed(
    sets: ToothSets,
    row: int,
    module: Values | None = None,
    width: Values | None = None,
    rack: float = RACK,
    addendum: float = 1.0,
    driver: str = "1",
) -> PlacedTrain:
    """The train of one row; ``module`` and ``width`` [m] (stages,) of its stages where they are known.

    Without modules lengths are in modules of stage 1; where not even the proportion of the modules is known, it is
    taken as m2/m1 = cbrt(U1) (4.4). ``addendum`` is in modules. Tips are those of wheels without profile shift, as the
    condition of neighbourhood takes them.
    """
    one = ToothSets(
        sets.layout, sets.teeth[row : row + 1], sets.modules[row : row + 1], sets.angles[row : row + 1], sets.planets
    )
    estimated = module is None and not one.modules.all()
    modules = np.asarray(module, float) if module is not None else _proportion(one)
    distances = centre_distances(one, modules[None], rack)
    wheels = tuple(_wheel(one, name, modules, distances, addendum) for name in one.scheme.wheels)
    widths = None if width is None else tuple(float(b) for b in width)
    return PlacedTrain(
        one.scheme,
        one.planets,
        wheels,
        tuple(modules.tolist()),
        widths,
        module is not None,
        estimated,
        tuple(distances[0].tolist()),
        tuple(one.angles[0].tolist()),
        one.scheme.output,
        driver,
    )


def _proportion(one: ToothSets) -> Values:
    """Modules of the stages (stages,) in those of stage 1."""
    parts = one.modules[0].astype(float)
    if parts.all():
        return parts / parts[0]
    relation = [1.0]
    for mesh in one.scheme.meshes[:-1]:
        relation.append(relation[-1] * float(np.cbrt(one.of(mesh.second)[0] / one.of(mesh.first)[0])))
    return np.array(relation)


def _wheel(one: ToothSets, name: str, modules: Values, distances: Values, addendum: float) -> Wheel:
    scheme = one.scheme
    stage = stage_of(one, name)
    module, teeth, internal = float(modules[stage]), int(one.of(name)[0]), name in scheme.rings
    reference = module * teeth / 2
    planes = [_plane(mesh) for mesh in scheme.meshes if name in (mesh.first, mesh.second)]
    return Wheel(
        name,
        teeth,
        module,
        _rolling(one, name, distances),
        reference,
        reference - addendum * module if internal else reference + addendum * module,
        (min(planes), max(planes)),
        _axes(one, name, distances),
        internal,
        name in scheme.planets,
        scheme.fixed == name,
    )


def _plane(mesh: Mesh) -> int:
    return mesh.stage if mesh.plane is None else mesh.plane


def _rolling(one: ToothSets, name: str, distances: Values) -> tuple[tuple[float, int], ...]:
    """Radii and planes of the pitch circles of a wheel, alike ones once."""
    found: list[tuple[float, int]] = []
    for mesh, distance in zip(one.scheme.meshes, distances[0].tolist(), strict=True):
        if name in (mesh.first, mesh.second):
            first, second = (int(one.of(wheel)[0]) for wheel in (mesh.first, mesh.second))
            total = abs(second - first) if mesh.internal else first + second
            radius = distance * int(one.of(name)[0]) / total
            if not any(math.isclose(radius, other, rel_tol=ALIKE) for other, _ in found):
                found.append((radius, _plane(mesh)))
    return tuple(found)


def _axes(one: ToothSets, name: str, distances: Values) -> tuple[complex, ...]:
    scheme = one.scheme
    if not scheme.branched:
        return (complex(sum(distances[0, : int(name.rstrip("'")) - 1].tolist())),)
    if name not in scheme.planets:
        return (0j,)
    rays = 1j * np.exp(2j * np.pi * np.arange(one.planets) / one.planets)
    return tuple((float(orbits(one, distances)[name][0]) * rays).tolist())
