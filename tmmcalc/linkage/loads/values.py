"""Values of technological loads along the motion, with the places where they are not smooth."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.loading import Load
from tmmcalc.linkage.loads.sources import Place
from tmmcalc.linkage.loads.travel import Travel
from tmmcalc.linkage.loads.windows import Inside
from tmmcalc.linkage.results import Grade, Kinematics
from tmmcalc.linkage.survey import Survey


class Knot(NamedTuple):
    """A function of the configuration at whose zeros a load is not smooth, and its scale."""

    rate: Callable[[Configuration], Real]
    scale: float


class Value(NamedTuple):
    """A load's value (n,) [N or N*m] at a place, and where it is not smooth: angles theta, zeros of knots."""

    at: Callable[[Place], Real]
    angles: list[float]
    knots: list[Knot]
    grades: tuple[Grade, ...] = ()


class Acting(NamedTuple):
    """A load where it acts: the mechanism, its motion with a survey of it, the load, its window."""

    chain: Chain
    kinematics: Kinematics
    travel: Travel
    dense: Survey
    load: Load
    window: Inside

    @property
    def where(self) -> str:
        """The load, as errors name it."""
        return Phrase("load {name}", name=self.load.name)
