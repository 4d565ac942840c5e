"""What a synthesis of tooth numbers is asked, and what it answers."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.scheme import Layout, layout_of

Integers = NDArray[np.int64]
Values = NDArray[np.floating[Any]]


@record
class Interval:
    """Admitted values, both ends included."""

    low: Fraction
    high: Fraction


@record
class Limits:
    """Numbers of teeth that are admitted, both ends included."""

    least: int = 17  # external wheels
    largest: int = 150
    largest_pinion: int = 25  # pinions of unfolded trains
    least_ring: int = 40
    largest_ring: int = 350
    largest_sum: int | None = None  # of the wheels 1 and 2


@record
class Demands:
    """What the other constraints demand; None: the constraint does not bind."""

    largest_angle: float | None = None  # [rad] operating pressure angle; None: meshes of the reference centre distance
    assembly: bool = True
    gap: Fraction | None = Fraction(1)  # [module] between the tips of neighbouring planets
    ring_difference: int | None = 7  # teeth of a ring over those of its pinion
    undercut: int | None = None  # least teeth of an external wheel that the rack does not undercut
    stage_ratio: Fraction | None = None  # largest of one stage
    diameter_band: Fraction | None = None  # relative difference of the diameters of the wheels of neighbouring stages
    equal_pinions: bool = False
    coprime: bool = False
    centre_distance: tuple[float | None, float | None] | None = None  # [m] from, to
    envelope: float | None = None  # [m] largest diameter or length of the train


@record
class TrainTask:
    """What a synthesis of tooth numbers is asked."""

    layout: str  # key
    nominal: Fraction  # tooth ratio; of AII the ratio i_14 with its sign
    ratio: Interval  # admitted tooth ratios, of one sign
    proportions: tuple[tuple[int, ...], ...]  # the modules of the stages to one another, each in lowest terms
    planets: int = 1  # K, planets or layshafts
    limits: Limits = Limits()
    demands: Demands = Demands()
    pressure_angle: float = math.radians(20)  # [rad]
    addendum: Fraction = Fraction(1)  # [module]
    module: float | None = None  # [m] of stage 1
    teeth: tuple[int, ...] | None = None  # given ones, in the order of the wheels; None: all are sought

    @property
    def scheme(self) -> Layout:
        """The layout itself."""
        return layout_of(self.layout)


@record
class ToothSets:
    """Tooth numbers of n trains of one layout."""

    layout: str  # key
    teeth: Integers = quantity("z_{wheel}", "number of teeth")  # (n, wheels), in the order of the layout's wheels
    modules: Integers = quantity(  # (n, stages), m1 : m2 = mu1 : mu2
        "mu_{stage}", "the modules of the stages to one another in lowest terms"
    )
    angles: Values  # [rad] (n, meshes), operating pressure angles
    planets: int = 1  # K, planets or layshafts

    @property
    def scheme(self) -> Layout:
        """The layout itself."""
        return layout_of(self.layout)

    def of(self, wheel: str) -> Integers:
        """Tooth numbers (n,) of a wheel."""
        column: Integers = self.teeth[:, self.scheme.index(wheel)]
        return column

    @property
    def by_wheel(self) -> dict[str, Integers]:
        """Tooth numbers (n,) of all wheels."""
        return dict(zip(self.scheme.wheels, self.teeth.T, strict=True))

    def __len__(self) -> int:
        """Number of trains."""
        return len(self.teeth)
