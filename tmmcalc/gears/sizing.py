"""The strength of a synthesis: modules and face widths of every tooth set of every variant.

The torque on wheel 1 is given, or follows from the largest reduced moment M_c of the machine that the train drives:
T1 = max|M_c| / u with u the speed of wheel 1 over that of the shaft that the moment is reduced to, the crank. The
output shaft of the train is the crank unless an open pair stands on it, or another ratio u is given: then a gear of the
ratio u/i stands between.
Losses are neglected.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.strength.errors import StrengthError, strength_error
from tmmcalc.gears.strength.results import Strength
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.task import StrengthTask, pinion_torque
from tmmcalc.gears.trains import Request, Trains

MOST = 20_000  # sets of a variant that are sized
GIVEN, MOMENT, REDUCTION = "given", "moment", "reduction"  # where the torque comes from


@record
class SizingTask:
    """What is asked of all variants."""

    strength: StrengthTask  # its torque is that of `torque`; without one it is 1 N*m
    torque: float | None  # T1 [N*m] as given
    moment: float | None  # max|M_c| [N*m] as given; None: that of the reduction
    ratio: float | None  # u of wheel 1 over the shaft of the moment; None: that of the train and of the pair on it
    beyond: float = 1.0  # ratio of the open pair between the train's output shaft and the crank


@record
class Torque:
    """The torque on wheel 1 and where it comes from."""

    value: float = quantity("T1[N*m]", "torque on wheel 1, of all branches")
    source: str = quantity("T1_source", "where the torque on wheel 1 comes from")  # GIVEN, MOMENT or REDUCTION
    moment: float | None = quantity("M_c_max[N*m]", "largest moment on the shaft that it is reduced to, max|M_c|")
    ratio: float | None = quantity("T1_ratio", "speed of wheel 1 over that of the shaft of the moment", symbol="u")


@record
class Sized:
    """The tooth sets of one variant with their modules and face widths."""

    title: str  # of the variant
    kind: str  # of the ratio, as it was asked for
    sets: ToothSets  # the first of the variant
    count: int = quantity("count", "all sets of the variant, those that are not sized too")
    torque: Torque
    beyond: float  # speed of the train's output shaft over that of the crank
    task: StrengthTask
    strength: Strength
    error: StrengthError | None = None  # None: no sets


@record
class Sizing:
    """All variants of a synthesis."""

    variants: tuple[Sized, ...]


def solve_sizing(task: SizingTask, train: Trains, reduction: Any = None) -> Sizing:
    """Size the sets of every variant, for the largest reduced moment of ``reduction`` where the task gives no torque.

    Raises `UsageError` if the torque is not known, and what the tables of strength do not have.
    """
    moment = None if reduction is None else largest_moment(reduction)
    sized = []
    for variant in train.variants:
        request, sets = variant.request, first_sets(variant.sets)
        own = float(wheel_ratio(request))
        torque = _torque(task, moment, own)
        strength = replace(task.strength, torque=torque.value)
        found = solve_strength(sets, strength)
        sized.append(
            Sized(
                title=request.title,
                kind=request.kind,
                sets=sets,
                count=variant.synthesis.count,
                torque=torque,
                beyond=task.beyond if task.ratio is None else task.ratio / own,
                task=strength,
                strength=found,
                error=strength_error(sets, strength, found),
            )
        )
    return Sizing(tuple(sized))


def largest_moment(reduction: Any) -> float:
    """max|M_c| over the cycle [N*m] of the result of the stage ``reduction``.

    Raises `UsageError` for a driven slider, on which forces act.
    """
    if not reduction.turns:
        raise UsageError(
            "the input is a driven slider: there is no moment on a crank",
            where="strength",
            remedy="give torque, or moment and moment_ratio",
        )
    least, largest = reduction.cycle.panels.extremes(reduction.parts.sum(axis=0))
    return float(max(abs(least[0]), abs(largest[0])))


def wheel_ratio(request: Request) -> Fraction:
    """Speed of wheel 1 over that of the output shaft, not negative; 1 where the carrier drives and 1 is the output."""
    layout, nominal = request.scheme, request.task.nominal
    if request.kind == "i_H1":
        return Fraction(1)
    return abs(1 + layout.sign * nominal if layout.sign else nominal)


def first_sets(sets: ToothSets, most: int = MOST) -> ToothSets:
    """The first of the sets."""
    return rows_of(sets, np.arange(min(most, len(sets))))


def rows_of(sets: ToothSets, rows: np.ndarray) -> ToothSets:
    """The sets of these rows."""
    return replace(sets, teeth=sets.teeth[rows], modules=sets.modules[rows], angles=sets.angles[rows])


def _torque(task: SizingTask, reduced: float | None, own: float) -> Torque:
    if task.torque is not None:
        return Torque(task.torque, GIVEN, None, None)
    moment, source = (reduced, REDUCTION) if task.moment is None else (task.moment, MOMENT)
    if not moment:
        raise UsageError(
            "the torque on wheel 1 is not known: nothing loads the crank",
            where="strength",
            remedy="give torque or moment, or a mechanism that is loaded",
        )
    ratio = own * task.beyond if task.ratio is None else task.ratio
    return Torque(pinion_torque(moment, ratio), source, abs(moment), abs(ratio))
