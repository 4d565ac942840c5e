"""All criteria of many trains in one pass."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.efficiency import MeshEfficiency, efficiency
from tmmcalc.gears.criteria.inertia import reduced_inertia
from tmmcalc.gears.criteria.size import RACK, centre_distances, envelope, size
from tmmcalc.gears.criteria.speeds import Ratios, speeds
from tmmcalc.gears.criteria.wheels import Build, wheels
from tmmcalc.gears.model import Integers, ToothSets, Values
from tmmcalc.gears.scheme import CARRIER
from tmmcalc.gears.search.measures import tooth_ratio


@record
class Assumptions:
    """What the criteria rest on."""

    build: Build = Build()
    meshes: MeshEfficiency = MeshEfficiency()
    driver: str = "1"  # wheel 1, or the output shaft
    reduced_to: str | None = None  # shaft of the reduced inertia; None: the output
    rack: float = RACK  # [rad] pressure angle of the basic rack
    slenderness: tuple[float, float] = (6.0, 40.0)  # width over module that is usual


@record
class Criteria:
    """Criteria of n trains of one layout."""

    # (n,) if nothing else is said
    mass: Values = quantity("mass[kg]", "mass of the moving wheels", symbol="M")
    inertia: Values = quantity("inertia[kg*m^2]", "reduced inertia", symbol="J")
    size: Values = quantity("size[m]", "diameter around the pitch circles", symbol="D")
    envelope: Values = quantity("envelope[m]", "diameter around rings and all wheels")
    centre_distances: Values  # [m] (n, meshes)
    ratio: Values  # i_1H, of fixed axes i_1n (n,), with its sign
    planet_ratio: Values  # i_2H, of fixed axes i_2n (n,)
    efficiency: Values = quantity("efficiency", "efficiency, zero or below: self-locking", symbol="eta")
    error: Values = quantity("error", "relative deviation of the ratio, not negative")
    slenderness: Values  # b/m (n, stages)
    width_deviation: Values  # (n,) how far the worst b/m lies outside the usual range, relative to its limit

    @property
    def locking(self) -> np.ndarray:
        """Whether the train locks itself, (n,)."""
        return self.efficiency <= 0

    def __len__(self) -> int:
        """Number of trains."""
        return len(self.mass)


def evaluate(
    sets: ToothSets, module: Values, width: Values, nominal: Fraction | None = None, basis: Assumptions | None = None
) -> Criteria:
    """All criteria of n trains for modules and widths [m] (n, stages) (textbook 4.43 to 4.51, table 4.6).

    ``nominal`` is the tooth ratio asked for; without it the error is zero. Raises `UsageError` for arrays that do not
    fit the tooth sets or are not positive.
    """
    basis = Assumptions() if basis is None else basis
    _check(sets, module, "module")
    _check(sets, width, "width")
    turning = speeds(sets)
    slender = width / module
    low, high = basis.slenderness
    outside = np.maximum(np.maximum(low / slender, slender / high).max(axis=1) - 1, 0.0)
    return Criteria(
        mass=wheels(sets, module, width, basis.build).mass,
        inertia=reduced_inertia(sets, module, width, basis.reduced_to, build=basis.build, rack=basis.rack),
        size=size(sets, module, basis.rack),
        envelope=envelope(sets, module, basis.rack),
        centre_distances=centre_distances(sets, module, basis.rack),
        ratio=turning.of("1"),
        planet_ratio=turning.of("2"),
        efficiency=efficiency(sets, basis.meshes, basis.driver, module.dtype),
        error=np.zeros(len(sets)) if nominal is None else ratio_error(sets, nominal, basis.driver),
        slenderness=slender,
        width_deviation=outside,
    )


def ratio_error(sets: ToothSets, nominal: Fraction, driver: str = "1") -> Values:
    """Relative deviation (n,) of the tooth ratio U from the nominal one, its numerator exact.

    With the carrier driving it is that of i_H1 = 1/(1 - U): near U = 1 a small error of U is a large one of the train.

    >>> train = ToothSets("AIbar", np.array([[20, 52, 124]]), np.ones((1, 1), int), np.full((1, 2), 0.349), planets=3)
    >>> ratio_error(train, Fraction("6.2")).tolist()
    [0.0]
    """
    if driver == CARRIER and sets.scheme.output == CARRIER:
        actual, wanted = speeds(sets, "1").exact(CARRIER), 1 / (1 + sets.scheme.sign * nominal)
    else:
        actual, wanted = Ratios(*tooth_ratio(sets)), nominal
    return deviation(actual, wanted)


def deviation(actual: Ratios, wanted: Fraction) -> Values:
    """|actual/wanted - 1| (n,), rounded once."""
    top, bottom = _wide(actual.numerators, wanted), _wide(actual.denominators, wanted)
    gap = abs(top * wanted.denominator - bottom * wanted.numerator)
    relative: Values = gap.astype(float) / abs(bottom.astype(float) * wanted.numerator)
    return relative


def _wide(numbers: Integers, wanted: Fraction) -> np.ndarray:
    """The numbers in 64 bits, or without limit where a product would not fit."""
    factor = max(abs(wanted.numerator), wanted.denominator)
    return numbers.astype(object) if int(abs(numbers).max(initial=0)) * factor >= 1 << 61 else numbers


def _check(sets: ToothSets, values: Values, name: str) -> None:
    shape = (len(sets), sets.scheme.stages)
    if values.shape != shape or not np.all(np.isfinite(values) & (values > 0)):
        raise UsageError(
            f"{name} has the shape {values.shape} or values that are not positive",
            where=f"criteria of train {sets.layout}",
            remedy=f"positive lengths in metres, shape {shape}",
        )
