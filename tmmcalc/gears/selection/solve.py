"""From sized tooth sets to the best train: criteria, Pareto front, ranking, comparisons, winner (textbook 4.6).

Trains that are not strong enough are left out, and those that lock themselves: no power passes through them.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from fractions import Fraction

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.criteria.choice import Ranking, Reason, front, least, minima, ranked
from tmmcalc.gears.criteria.comparison import Comparison, compare
from tmmcalc.gears.criteria.efficiency import efficiency
from tmmcalc.gears.criteria.errors import criteria_error
from tmmcalc.gears.criteria.evaluate import Assumptions, evaluate
from tmmcalc.gears.criteria.objectives import Measured
from tmmcalc.gears.criteria.speeds import speeds
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.proportion import equal_strength
from tmmcalc.gears.scheme import CARRIER
from tmmcalc.gears.selection.results import MEASURES, Guide, Pool, Selection, SeriesChoice, Weighed, Winner, pooled
from tmmcalc.gears.selection.series import SERIES, paired
from tmmcalc.gears.selection.task import ROW, WEIGHTED, SelectionTask
from tmmcalc.gears.sizing import Sized, Sizing, rows_of
from tmmcalc.gears.split import CRITERIA, best_split, equal_diameters
from tmmcalc.gears.strength.explain import reason as why
from tmmcalc.gears.trains import Request, Trains


def solve_selection(task: SelectionTask, train: Trains, strength: Sizing) -> Selection:
    """Choose among all sized sets of all variants.

    Raises `NoSolutionError` if none is strong enough, `UsageError` for a row that there is not.
    """
    requests = tuple(variant.request for variant in train.variants)
    weighed = tuple(_weighed(*pair, task) for pair in zip(requests, strength.variants, strict=True))
    everything = pooled(weighed)
    if not len(everything):
        raise _none_left(strength, weighed)
    if task.kept is not None:
        from tmmcalc.gears.userconstraints import kept_trains

        weighed = kept_trains(weighed, task.kept)
        everything = pooled(weighed)
    ranking = ranked(everything, dict(task.weights) or dict.fromkeys(task.objectives, 1.0))
    choose, reason = _choice(everything, ranking, task)
    winner = _winner(requests, strength, weighed, everything, reason.winner)
    pairs, measured = (
        paired(requests[winner.variant], strength.variants[winner.variant], task) if task.series else (None, None)
    )
    return Selection(
        variants=weighed,
        objectives=task.objectives,
        front=front(everything, task.objectives),
        minima=minima(everything, task.objectives),
        ranking=ranking,
        choose=choose,
        reason=reason,
        winner=winner,
        by_planets=_by_planets(weighed, winner.layout, task),
        by_layouts=_by_layouts(weighed, pairs, measured, task),
        guides=guides(requests),
        pairs=pairs,
    )


def assumptions_of(request: Request, task: SelectionTask) -> Assumptions:
    """Criteria of a variant: where the carrier drives, wheel 1 is the output shaft."""
    backward = request.kind == "i_H1"
    return Assumptions(
        meshes=task.meshes,
        driver=CARRIER if backward else "1",
        reduced_to="1" if backward else None,
        rack=request.task.pressure_angle,
    )


def _weighed(request: Request, sized: Sized, task: SelectionTask) -> Weighed:
    strong = np.flatnonzero(sized.strength.accepted)
    basis = assumptions_of(request, task)
    locks = efficiency(rows_of(sized.sets, strong), basis.meshes, basis.driver) <= 0
    rows = strong[~locks]
    sets, module, width = rows_of(sized.sets, rows), sized.strength.module[rows], sized.strength.width[rows]
    criteria = evaluate(sets, module, width, basis=basis)
    error = criteria_error(sets, module, width, basis, criteria)
    criteria = replace(criteria, error=abs(ratios(request, sets)[1]))  # of the ratio as it was asked for
    locking, weak = int(np.count_nonzero(locks)), len(sized.sets) - len(strong)
    unseen = sized.count - len(sized.sets)
    counts = len(sized.sets), weak, locking, unseen
    return Weighed(sized.title, sets, module, width, criteria, *counts, error=error)


def _choice(everything: Pool, ranking: Ranking, task: SelectionTask) -> tuple[str, Reason]:
    if isinstance(task.choose, int):
        if not 1 <= task.choose <= len(everything):
            raise UsageError(
                f"there is no row {task.choose}: {len(everything)} trains are strong enough",
                where="criteria",
                value=task.choose,
                limit=len(everything),
                remedy=f"choose a row of criteria.csv, 1 to {len(everything)}, a criterion, or weighted",
            )
        return ROW, Reason(ROW, task.choose - 1, float(task.choose), None, None, 0)
    return task.choose, ranking.reason if task.choose == WEIGHTED else least(everything, task.choose)


def _winner(
    requests: tuple[Request, ...], sizing: Sizing, weighed: tuple[Weighed, ...], everything: Pool, place: int
) -> Winner:
    at, row = int(everything.variant[place]), int(everything.row[place])
    of = weighed[at]
    one = rows_of(of.sets, np.array([row]))
    return Winner(
        place=place,
        variant=at,
        title=of.title,
        layout=one.layout,
        planets=one.planets,
        teeth=tuple(one.teeth[0].tolist()),
        modules=tuple(of.module[row].tolist()),
        widths=tuple(of.width[row].tolist()),
        ratio=speed_ratio(one, requests[at].kind),
        inertia=float(of.criteria.inertia[row]),
        values={name: float(getattr(of.criteria, name)[row]) for name in MEASURES},
        beyond=sizing.variants[at].beyond,
    )


def speed_ratio(one: ToothSets, kind: str) -> Fraction:
    """Input over output speed of the first train, exact."""
    exact = speeds(one, "1").exact(CARRIER) if kind == "i_H1" else speeds(one).exact("1")
    return Fraction(int(exact.numerators[0]), int(exact.denominators[0]))


def _by_planets(weighed: tuple[Weighed, ...], layout: str, task: SelectionTask) -> tuple[Comparison, ...]:
    """Numbers of planets of one layout, if there are several."""
    options: dict[int, Measured] = {each.sets.planets: each.criteria for each in weighed if each.sets.layout == layout}
    return tuple(compare(options, key) for key in task.compared) if len(options) > 1 else ()


def _by_layouts(
    weighed: tuple[Weighed, ...], pairs: SeriesChoice | None, measured: Measured | None, task: SelectionTask
) -> tuple[Comparison, ...]:
    """Layouts, each with all its numbers of planets, and trains in series."""
    layouts = dict.fromkeys(each.sets.layout for each in weighed)
    options: dict[str, Measured] = {
        layout: pooled(tuple(each for each in weighed if each.sets.layout == layout)) for layout in layouts
    }
    if pairs is not None and measured is not None:
        options[SERIES] = measured
    return tuple(compare(options, key) for key in task.compared) if len(options) > 1 else ()


def _none_left(sizing: Sizing, weighed: tuple[Weighed, ...]) -> NoSolutionError:
    """Why no set of any variant is left."""
    lines = []
    for sized, each in zip(sizing.variants, weighed, strict=True):
        if not len(sized.sets):
            lines.append(f"{sized.title}: no tooth sets")
            continue
        if each.locking:
            lines.append(f"{sized.title}: {each.locking} of {each.sized} sets are self-locking")
        if each.weak:
            outcomes = Counter(sized.strength.outcome[~sized.strength.accepted].tolist())
            usual = outcomes.most_common(1)[0][0]
            at = int(np.flatnonzero(sized.strength.outcome == usual)[0])
            teeth = "/".join(map(str, sized.sets.teeth[at].tolist()))
            what = f"{each.weak} of {each.sized} sets are not strong enough, such as {teeth}"
            lines.append(f"{sized.title}: {what}: {why(sized.strength, at)}")
    remedy = 'harder steel, more planets, other module_ratios, on_overload = "scale", or a wider synthesis'
    return NoSolutionError("no train is strong enough: " + "\n  ".join(lines), where="criteria", remedy=remedy)


def guides(requests: tuple[Request, ...]) -> tuple[Guide, ...]:
    """One guide for every layout that has a theory."""
    by_layout = {request.task.layout: request for request in requests}
    found = (_guide(request) for request in by_layout.values())
    return tuple(guide for guide in found if guide.splits or guide.proportion is not None)


def _guide(request: Request) -> Guide:
    task = request.task
    ratio = float(task.nominal)
    if task.scheme.stepped and ratio > 1:
        modules = equal_strength(ratio, internal=bool(task.scheme.rings)).modules
        return Guide(task.layout, ratio, proportion=float(modules[0]))
    if task.scheme.branched or task.scheme.planetary:
        return Guide(task.layout, ratio)
    stages, limit = task.scheme.stages, task.demands.stage_ratio
    most = None if limit is None else float(limit)
    if most is not None and ratio > most**stages:
        return Guide(task.layout, ratio, (equal_diameters(ratio, stages),))
    splits = (best_split(ratio, criterion, stages, most=most) for criterion in CRITERIA)
    return Guide(task.layout, ratio, (equal_diameters(ratio, stages), *splits))
