"""Moment of inertia of a train reduced to one shaft: the kinetic energy of all wheels at unit speed of that shaft.

J = sum_w K_w [J_w (omega_w/omega)^2 + M_w (a_w omega_H/omega)^2]        (4.45), (4.49)
"""

from __future__ import annotations

from tmmcalc.gears.criteria.size import RACK, centre_distances, orbits
from tmmcalc.gears.criteria.speeds import speeds
from tmmcalc.gears.criteria.wheels import Build, wheels
from tmmcalc.gears.model import ToothSets, Values
from tmmcalc.gears.scheme import CARRIER


def reduced_inertia(
    sets: ToothSets,
    module: Values,
    width: Values,
    to: str | None = None,
    *,
    build: Build | None = None,
    rack: float = RACK,
) -> Values:
    """Inertia [kg*m^2] (n,) reduced to a shaft, by default the output; ``module`` and ``width`` [m] are (n, stages).

    Raises `NoSolutionError` if that shaft stands still.
    """
    made, turning, kind = wheels(sets, module, width, build), speeds(sets, to), module.dtype
    own = turning.ratios.of_kind(kind)[:, : len(sets.scheme.wheels)] ** 2
    total = made.total(made.inertias * own)
    carried = turning.of(CARRIER, kind) ** 2
    for wheel, orbit in orbits(sets, centre_distances(sets, module, rack)).items():
        total = total + sets.planets * made.masses[:, sets.scheme.index(wheel)] * orbit**2 * carried
    return total
