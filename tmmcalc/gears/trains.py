"""What is asked of a gear train by one layout and number of planets, and the tooth sets that there are."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Literal

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record
from tmmcalc.gears.model import Interval, ToothSets, TrainTask
from tmmcalc.gears.radial import RadialShape
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.search.relaxation import Relaxation
from tmmcalc.gears.search.search import KEPT, Synthesis

if TYPE_CHECKING:
    from tmmcalc.feasibility.judge import FeasibilityTask


@record
class Request:
    """What is asked of one layout with one number of planets."""

    task: TrainTask
    kind: str  # of the ratio: u, i_1H, i_H1, i_14
    nominal: Fraction  # ratio of that kind
    admitted: Interval  # ratios of that kind
    relative: bool = True  # whether the tolerance was put as a part of the ratio
    tolerance: Fraction = Fraction(0)  # as it was put
    origin: str = ""  # of the ratio, where speeds of the machine give it; empty: the spec
    method: Literal["complete", "textbook"] = "complete"
    keep: int = KEPT  # most sets that are held
    remarks: tuple[str, ...] = ()  # what is unusual about the task
    radial: RadialShape | None = None  # of 2A-AA, if it is given

    @property
    def scheme(self) -> Layout:
        """The layout itself."""
        return self.task.scheme

    @property
    def title(self) -> str:
        """The layout in a sentence, with the number of planets."""
        if not self.scheme.branched:
            return self.task.layout
        one, more = "{layout} with {count} layshaft", "{layout} with {count} layshafts"
        if self.scheme.planetary:
            one, more = "{layout} with {count} planet", "{layout} with {count} planets"
        text = more if self.task.planets > 1 else one
        return Phrase(text, layout=self.task.layout, count=self.task.planets)


@record
class Asked:
    """What is asked of every layout, and the user's constraints on tooth sets, if there are any."""

    requests: tuple[Request, ...]
    kept: FeasibilityTask | None = None
    by_drive: bool = False  # whether the ratio is that of the drive, and not of the requests


@record
class Variant:
    """The tooth sets of one layout with one number of planets."""

    request: Request
    synthesis: Synthesis
    textbook: np.ndarray | None  # whether the textbook's program finds each set (n,); None: it has none for this task
    relaxations: tuple[Relaxation, ...] = ()  # changes that would give sets, if there are none
    error: float = 0.0  # of the operating angles, relative to the largest; 0: all are exactly that of the rack

    @property
    def sets(self) -> ToothSets:
        """The sets that are held."""
        return self.synthesis.sets


@record
class Trains:
    """The variants in the order in which they were asked for."""

    variants: tuple[Variant, ...]
