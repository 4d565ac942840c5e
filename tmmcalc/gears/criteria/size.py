"""Centre distances and overall size (textbook 4.48, 4.50, 4.51).

The size D is the textbook's: the circle around the planets 2, or the length of a row of wheels. The envelope takes in
whatever reaches farther: a larger planet 2', the pitch circle of a ring, a wheel above the others.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.gears.criteria.wheels import radii
from tmmcalc.gears.model import ToothSets, Values

RACK = math.radians(20)  # pressure angle of the basic rack


def centre_distances(sets: ToothSets, module: Values, rack: float = RACK) -> Values:
    """Operating centre distances [m] (n, meshes): m (Z2 +- Z1)/2 cos(alpha)/cos(alpha_w).

    >>> train = ToothSets("AI", np.array([[22, 118, 17, 97]]), np.array([[4, 7]]), np.full((1, 2), RACK))
    >>> centre_distances(train, np.array([[0.002, 0.0035]])).round(6).tolist()
    [[0.14, 0.14]]
    """
    columns = []
    for mesh in sets.scheme.meshes:
        one, other = sets.of(mesh.first), sets.of(mesh.second)
        total = abs(other - one) if mesh.internal else one + other
        columns.append(module[:, mesh.stage] / 2 * total)
    distances: Values = np.stack(columns, axis=1) * _stretch(sets, rack)
    return distances


def _stretch(sets: ToothSets, rack: float) -> Values:
    """Operating over reference centre distance (n, meshes); exactly one at the pressure angle of the rack."""
    stretch: Values = np.cos(rack) / np.cos(sets.angles)
    return stretch


def orbits(sets: ToothSets, distances: Values) -> dict[str, Values]:
    """Radii [m] (n,) of the circles on which the axes of the planets or layshafts lie, by wheel."""
    if sets.scheme.paired:
        return {"2": distances[:, 0], "3": distances[:, 2]}
    return dict.fromkeys(sets.scheme.planets, distances[:, 0])


def size(sets: ToothSets, module: Values, rack: float = RACK) -> Values:
    """The size D [m] (n,) of the textbook; for modules [m] (n, stages).

    Planetary trains and several layshafts (4.48), one layshaft (4.50), stages in a row (4.51).

    >>> train = ToothSets("AI", np.array([[22, 118, 17, 97]]), np.array([[4, 7]]), np.full((1, 2), RACK), planets=3)
    >>> size(train, np.array([[0.002, 0.0035]])).round(6).tolist()
    [0.516]
    """
    # summed in teeth before modules come in, so that trains of equal size compare as equal
    found: Values = sets.scheme.size(sets.by_wheel, list(module.T), list(_stretch(sets, rack).T), sets.planets)
    return found


def envelope(sets: ToothSets, module: Values, rack: float = RACK) -> Values:
    """Diameter or length [m] (n,) of the room that all pitch circles take, fixed rings included."""
    r = dict(zip(sets.scheme.wheels, radii(sets, module).T, strict=True))
    a = centre_distances(sets, module, rack)
    if not sets.scheme.branched:
        axes = np.hstack((np.zeros((len(sets), 1)), np.cumsum(a, axis=1)))
        places = {wheel: axes[:, int(wheel.rstrip("'")) - 1] for wheel in sets.scheme.wheels}
        return _extent(places, r)
    if not sets.scheme.planetary and sets.planets == 1:
        places = {wheel: a[:, 0] if wheel in sets.scheme.planets else 0 * a[:, 0] for wheel in sets.scheme.wheels}
        return _extent(places, r)
    circles: list[Values] = [orbit + r[wheel] for wheel, orbit in orbits(sets, a).items()]
    circles += [r[wheel] for wheel in sets.scheme.wheels if wheel not in sets.scheme.planets]
    widest: Values = 2 * np.maximum.reduce(circles)
    return widest


def _extent(places: dict[str, Values], r: dict[str, Values]) -> Values:
    """Length from the first to the last edge of wheels in a row."""
    upper = np.maximum.reduce([places[wheel] + r[wheel] for wheel in places])
    lower = np.minimum.reduce([places[wheel] - r[wheel] for wheel in places])
    length: Values = upper - lower
    return length
