"""The result of the choice of a gear train."""

from __future__ import annotations

from dataclasses import field
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.choice import Ranking, Reason
from tmmcalc.gears.criteria.comparison import Comparison
from tmmcalc.gears.criteria.errors import CriteriaError
from tmmcalc.gears.criteria.evaluate import Criteria
from tmmcalc.gears.criteria.series import Series
from tmmcalc.gears.model import Integers, ToothSets, Values
from tmmcalc.gears.split import Split


@record
class Weighed:
    """The sets of one variant that are strong enough and turn, with all criteria."""

    title: str
    sets: ToothSets
    module: Values = quantity("m_{stage}[m]", "normal module")  # (n, stages)
    width: Values = quantity("b_{stage}[m]", "face width")  # (n, stages)
    criteria: Criteria
    sized: int = quantity("sized", "sets whose strength was found")
    weak: int = quantity("weak", "of them not strong enough")
    locking: int = quantity("locking", "of them self-locking: no power passes")
    unseen: int  # sets of the variant whose strength was not found
    refused: dict[str, int] = field(default_factory=dict)  # that break a constraint of the user's, by its name
    error: CriteriaError | None = None  # None: no trains


@record
class Pool:
    """The criteria of all variants together, one row a train: what `choice` calls measured."""

    variant: Integers  # (n,) index of the variant
    row: Integers  # (n,) among the sets of the variant
    mass: Values
    inertia: Values
    size: Values
    envelope: Values
    efficiency: Values
    error: Values
    width_deviation: Values

    def __len__(self) -> int:
        """Number of trains."""
        return len(self.row)


MEASURES = ("mass", "inertia", "size", "envelope", "efficiency", "error", "width_deviation")


def pooled(variants: tuple[Weighed, ...]) -> Pool:
    """All rows of all variants, in their order."""
    counts = [len(each.sets) for each in variants]
    values = {name: np.concatenate([getattr(each.criteria, name) for each in variants]) for name in MEASURES}
    rows = np.concatenate([np.arange(count) for count in counts])
    return Pool(variant=np.repeat(np.arange(len(counts)), counts), row=rows, **values)


@record
class Winner:
    """The train that was chosen.

    >>> Winner(0, 0, "", "AIbar", 3, (18, 48, 114), (), (), Fraction(22, 3), 0.1, {}).name
    'AIbar 18/48/114'
    """

    place: int  # row among all trains
    variant: int
    title: str
    layout: str = quantity("layout", "key of the layout")
    planets: int = quantity("planets", "number of planets or layshafts")
    teeth: tuple[int, ...] = quantity("teeth", "numbers of teeth")
    modules: tuple[float, ...] = quantity("modules[m]", "normal modules of the stages")
    widths: tuple[float, ...] = quantity("widths[m]", "face widths of the stages")
    ratio: Fraction  # input over output speed, exact, with its sign
    inertia: float = quantity("J_output[kg*m^2]", "inertia reduced to the output shaft")
    values: dict[str, float]  # of all criteria
    beyond: float = 1.0  # speed of the output shaft over that of the crank

    @derived("winner", "layout and teeth")
    def name(self) -> str:
        """Layout and teeth."""
        return f"{self.layout} {'/'.join(map(str, self.teeth))}"

    @derived("J_crank[kg*m^2]", "inertia reduced to the crank")
    def on_crank(self) -> float:
        """The same by the square of the speeds' ratio."""
        return self.inertia * self.beyond**2

    @property
    def to_crank(self) -> float:
        """Speed of the train's input shaft over that of the crank."""
        return abs(float(self.ratio)) * self.beyond


@record
class Guide:
    """What theory proposes for a layout before tooth numbers are known."""

    layout: str
    ratio: float  # tooth ratio U
    splits: tuple[Split, ...] = ()  # of U between the stages of an unfolded reducer
    proportion: float | None = None  # mu* = m2/m1 of equal strength


@record
class SeriesChoice:
    """Two trains AIbar in series in place of one; the pairs of the Pareto front are held."""

    planets: int
    single: Fraction  # ratio i_1H asked of each
    counts: tuple[int, int]  # sets of each that are strong enough
    admitted: int = quantity("pairs_admitted", "pairs whose product of ratios is within the tolerance", default=0)
    tried: int = quantity("pairs_tried", "all pairs", default=0)
    best: dict[str, float] | None = quantity(  # None: no pair
        "pairs_best", "least (or largest) value of every objective", default=None
    )
    front: Series | None = None
    first: ToothSets | None = None  # of the pairs of the front, the first trains
    second: ToothSets | None = None
    # (n, 2) of both
    modules: Values | None = quantity("m_{train}[m]", "normal module", default=None)
    widths: Values | None = quantity("b_{train}[m]", "face width", default=None)
    failure: str = quantity("pairs_failure", "why there is no pair", default="")


@record
class Selection:
    """Everything that the choice rests on."""

    variants: tuple[Weighed, ...]
    objectives: tuple[str, ...]
    front: NDArray[np.intp]  # rows that no other one betters in all objectives
    minima: tuple[Reason, ...]  # the best by each objective
    ranking: Ranking
    choose: str  # a criterion, "weighted" or "row"
    reason: Reason
    winner: Winner
    by_planets: tuple[Comparison, ...]  # numbers of planets of the winner's layout, by each objective; or none
    by_layouts: tuple[Comparison, ...]  # layouts, by each objective; or none
    guides: tuple[Guide, ...]
    pairs: SeriesChoice | None = None  # trains in series, if they are asked for

    @property
    def pool(self) -> Pool:
        """All trains together."""
        return pooled(self.variants)
