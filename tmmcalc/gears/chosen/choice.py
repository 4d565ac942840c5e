"""One tooth set out of a search: that which criteria chose, or one by its number; or a layout that is written out."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import gcd

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.gearingtask import GearingTask
from tmmcalc.gears.model import Interval, ToothSets, TrainTask
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.trains import Request, Trains, Variant
from tmmcalc.report.rows import check_choice


@record
class Chosen:
    """One tooth set."""

    title: str
    sets: ToothSets  # it alone
    task: TrainTask  # what it obeys
    request: Request | None = None  # None: it is written out, no ratio is asked of it
    modules: tuple[float, ...] = ()  # of the stages [m]; none: they are not known

    @property
    def teeth(self) -> dict[str, int]:
        """Tooth numbers by wheel."""
        return {wheel: int(z[0]) for wheel, z in self.sets.by_wheel.items()}


def chosen_sets(trains: Trains, selection: Selection | None = None, number: int = 1) -> tuple[Chosen, ...]:
    """The train that criteria chose; without them set ``number`` of every variant that has one.

    Raises `UsageError` if none has.
    """
    if selection is not None:
        winner = selection.winner
        variant, pool = trains.variants[winner.variant], selection.pool
        row = int(pool.row[winner.place])
        sets = _only(selection.variants[winner.variant].sets, row)
        title = f"{winner.title}: {_named(sets)}, row {winner.place + 1} of {len(pool)}"
        return (Chosen(title, sets, variant.request.task, variant.request, winner.modules),)
    found = tuple(numbered_set(variant, number) for variant in trains.variants if 1 <= number <= len(variant.sets))
    if not found:
        most = max(len(variant.sets) for variant in trains.variants)
        check_choice(number, most, "tooth set")
    return found


def written_set(task: GearingTask) -> Chosen | None:
    """The layout of a train that is written out, with the conditions of a synthesis; None: it has no layout."""
    if task.layout is None:
        return None
    sets = ToothSets(task.layout, np.array([task.teeth]), np.ones((1, 1), np.int64), np.zeros((1, 0)), task.planets)
    scheme = sets.scheme
    usual = TrainTask(task.layout, Fraction(1), Interval(Fraction(1), Fraction(1)), ((1,),), task.planets)
    proportion = _common_axis(sets) if scheme.branched else (1,) * scheme.stages
    angles = np.full((1, len(scheme.meshes)), usual.pressure_angle)
    sets = replace(sets, modules=np.array([proportion]), angles=angles)
    return Chosen(
        f"{task.layout}: {_named(sets)}", sets, replace(usual, proportions=(proportion,), teeth=tuple(task.teeth))
    )


def numbered_set(variant: Variant, number: int) -> Chosen:
    """Set ``number`` of a variant, from 1."""
    task, sets = variant.request.task, _only(variant.sets, number - 1)
    title = f"{variant.request.title}: {_named(sets)}, set {number} of {len(variant.sets)}"
    mu = sets.modules[0].tolist()
    modules = () if task.module is None else tuple(task.module * part / (mu[0] or 1) for part in mu)
    return Chosen(title, sets, task, variant.request, modules if all(modules) else ())


def _only(sets: ToothSets, row: int) -> ToothSets:
    rows = slice(row, row + 1)
    return replace(sets, teeth=sets.teeth[rows], modules=sets.modules[rows], angles=sets.angles[rows])


def _named(sets: ToothSets) -> str:
    return "/".join(map(str, sets.teeth[0].tolist()))


def _common_axis(sets: ToothSets) -> tuple[int, ...]:
    """The modules of the stages to one another with which the first mesh of each has the distance of stage 1."""
    scheme, z = sets.scheme, {wheel: int(numbers[0]) for wheel, numbers in sets.by_wheel.items()}
    first: dict[int, int] = {}
    for mesh in scheme.meshes:
        total = abs(z[mesh.first] - z[mesh.second]) if mesh.internal else z[mesh.first] + z[mesh.second]
        first.setdefault(mesh.stage, total)
    if len(first) == 1 or not all(first.values()):
        return (1,) * scheme.stages
    common = gcd(first[0], first[1])
    return first[1] // common, first[0] // common
