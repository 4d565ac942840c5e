"""One train replaced by two with single planets (AIbar) in series (textbook 4.4.5.3, 4.6.3).

Both have the ratio sqrt(i_1H) within the tolerance of the whole; of all pairs those are admitted whose product keeps
the tolerance exactly. The torque on the second train is T1 i of the first, losses neglected.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import sqrt

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.choice import front
from tmmcalc.gears.criteria.evaluate import Assumptions, Criteria, evaluate
from tmmcalc.gears.criteria.objectives import OBJECTIVES
from tmmcalc.gears.criteria.series import Series, series
from tmmcalc.gears.exact import around
from tmmcalc.gears.model import Interval, ToothSets, TrainTask, Values
from tmmcalc.gears.search.search import synthesise
from tmmcalc.gears.selection.results import MEASURES, SeriesChoice
from tmmcalc.gears.selection.task import SelectionTask
from tmmcalc.gears.sizing import Sized, first_sets, rows_of
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.task import StrengthTask
from tmmcalc.gears.trains import Request

SERIES = "AIbar + AIbar"
LAYOUT = "AIbar"
USUAL_PLANETS = 3
LEAST = 2  # of i_1H = 1 + Z3/Z1: the ring is larger than the sun
MOST = 3_000  # sets of each train: all pairs are tried
DENOMINATOR = 1_000_000  # of the square root of the ratio
_ARRAYS = ("first", "second", "ratio", *MEASURES)  # of a series


@record
class _Train:
    """The sets of one of the two that are strong enough."""

    sets: ToothSets
    module: Values
    width: Values
    criteria: Criteria


def paired(request: Request, sized: Sized, task: SelectionTask) -> tuple[SeriesChoice, Series | None]:
    """The pairs in place of a variant, and their criteria; None: there is no pair."""
    whole = _whole(request)
    each = Fraction(sqrt(max(float(whole.nominal), 0.0))).limit_denominator(DENOMINATOR)
    planets = request.task.planets if request.scheme.planetary else USUAL_PLANETS
    if each <= LEAST:
        failure = f"the ratio {float(whole.nominal):.5g} is none of two trains {LAYOUT}: each has i_1H above {LEAST}"
        return SeriesChoice(planets, each, (0, 0), failure=failure), None
    trains = tuple(_train(request, sized, whole, each, planets, factor, task) for factor in (1.0, float(each)))
    counts = len(trains[0].sets), len(trains[1].sets)
    found = SeriesChoice(planets, each, counts)
    if not all(counts):
        failure = f"{LAYOUT} with {planets} planets has no train of i_1H = {float(each):.5g} that is strong enough"
        return replace(found, failure=failure), None
    sets, criteria = (trains[0].sets, trains[1].sets), (trains[0].criteria, trains[1].criteria)
    try:
        pairs = series(sets, criteria, whole.nominal, whole.admitted)
    except NoSolutionError as fault:
        return replace(found, failure=fault.message), None
    return _held(found, trains, pairs, task), pairs


@record
class _Whole:
    """Ratio of the input over the output speed that both together have."""

    nominal: Fraction
    admitted: Interval


def _whole(request: Request) -> _Whole:
    """The ratio of speeds: of planetary trains i_1H, whatever the kind that was given."""
    task, sign = request.task, request.scheme.sign
    if not sign:
        return _Whole(task.nominal, task.ratio)
    low, high = sorted((1 + sign * task.ratio.low, 1 + sign * task.ratio.high))
    return _Whole(1 + sign * task.nominal, Interval(low, high))


def _train(
    request: Request, sized: Sized, whole: _Whole, each: Fraction, planets: int, factor: float, task: SelectionTask
) -> _Train:
    """The strong sets of a train that bears ``factor`` times the torque of the whole."""
    sets = first_sets(synthesise(_single(request.task, whole, each, planets), MOST).sets, MOST)
    strength = solve_strength(sets, _loaded(sized.task, factor))
    strong = np.flatnonzero(strength.accepted)
    sets, module, width = rows_of(sets, strong), strength.module[strong], strength.width[strong]
    basis = Assumptions(meshes=task.meshes, rack=request.task.pressure_angle)
    return _Train(sets, module, width, evaluate(sets, module, width, each - 1, basis))


def _single(task: TrainTask, whole: _Whole, each: Fraction, planets: int) -> TrainTask:
    """The synthesis of one of the two, within the relative tolerance of the whole."""
    tolerance = max(whole.admitted.high - whole.nominal, whole.nominal - whole.admitted.low) / abs(whole.nominal)
    admitted = around(each, tolerance, relative=True)
    ratio = Interval(max(admitted.low - 1, Fraction(1, DENOMINATOR)), admitted.high - 1)
    demands = replace(task.demands, largest_angle=None, stage_ratio=None, diameter_band=None, envelope=None)
    return replace(
        task,
        layout=LAYOUT,
        nominal=each - 1,
        ratio=ratio,
        proportions=((1,),),
        planets=planets,
        demands=demands,
        teeth=None,  # given ones are those of the whole train
    )


def _loaded(task: StrengthTask, factor: float) -> StrengthTask:
    """The strength of a train of one stage: as that of the first one, its modules free."""
    return replace(task, torque=task.torque * factor, stages=task.stages[:1], modules=(), widths=())


def _held(found: SeriesChoice, trains: tuple[_Train, ...], pairs: Series, task: SelectionTask) -> SeriesChoice:
    """The pairs of the front with their teeth, and the best values of all."""
    kept = front(pairs, task.objectives)
    held = replace(pairs, **{name: getattr(pairs, name)[kept] for name in _ARRAYS})
    best = {
        key: float(getattr(pairs, key).max() if OBJECTIVES[key].largest else getattr(pairs, key).min())
        for key in task.compared
    }
    one, two = trains
    return replace(
        found,
        admitted=len(pairs),
        tried=pairs.tried,
        best=best,
        front=held,
        first=rows_of(one.sets, held.first),
        second=rows_of(two.sets, held.second),
        modules=np.hstack((one.module[held.first], two.module[held.second])),
        widths=np.hstack((one.width[held.first], two.width[held.second])),
    )
