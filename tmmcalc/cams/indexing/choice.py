"""What is chosen where the task leaves it open: lambda and the roller; and what is said where nothing can be."""

from __future__ import annotations

from math import degrees, pi

from tmmcalc.cams.indexing.bounds import TOLERATED, bounds, least_ratio
from tmmcalc.cams.indexing.laws import step_law, symmetric_laws
from tmmcalc.cams.indexing.rollers import USUAL, RollerLimit, governing
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.core.errors import NoSolutionError

ABOVE = 1.1  # lambda/lambda_min that is chosen: near the least pressure angle, clear of the point of the groove
TIGHT = 1.01  # lambda/lambda_min that is chosen where the limits leave no room
NEAR = 1.02  # lambda/lambda_min below which the groove is told to be sharp
NO_ROLLER = 1e-6  # of the wheel: a roller that is none
EQUAL = 1e-9  # relative
ROLLERS = (6, 8, 10, 12, 14)  # z2 with the usual 3 to 7 pairs
WHERE = "indexing"


def choose_ratio(task: IndexingTask) -> tuple[float, str]:
    """lambda, given or chosen, and how.

    Raises `NoSolutionError` for one below lambda_min, and if none lies between the limits.
    """
    limits = bounds(task.law.peak, task.rollers, task.step, task.limit)
    least, most = limits.ratio_min, limits.ratio_max
    if task.ratio is not None:
        if task.ratio < least * (1 - EQUAL):
            raise NoSolutionError(
                f"lambda = {task.ratio:.6g} is below lambda_min = {least:.6g}: the groove crosses itself in a loop",
                where=WHERE,
                value=task.ratio,
                limit=least,
                remedy=f"a centre distance of at least {1e3 * least * task.wheel:.6g} mm, a larger step_angle, "
                "or a law with a smaller B",
            )
        return task.ratio, "given"
    if limits.excess > TOLERATED:
        assert most is not None
        raise NoSolutionError(
            f"no lambda: the groove needs lambda_min = {least:.6g}, a pressure angle of {degrees(task.limit):.6g} deg "
            f"allows lambda_max = {most:.6g}",
            where=WHERE,
            value=least,
            limit=most,
            remedy=_remedies(task, most),
        )
    if most is None or ABOVE * least <= (least + most) / 2:
        return ABOVE * least, f"chosen, {ABOVE:g} lambda_min"
    if (least + most) / 2 >= NEAR * least:
        return (least + most) / 2, "chosen, the middle of its limits"
    if most >= TIGHT * least:
        return most, "chosen, lambda_max"
    return TIGHT * least, f"chosen, {TIGHT:g} lambda_min: the limits leave no room"


def _remedies(task: IndexingTask, most: float) -> str:
    """What would leave a lambda: a larger step, another law, other numbers of rollers."""
    remedies = []
    step = 2 * pi * task.law.peak / (task.rollers * (most - 1))
    if step < pi:
        remedies.append(f"a step_angle of {degrees(step):.6g} deg or more")
    laws = {name: step_law(name).peak for name in symmetric_laws()}
    fitting = [name for name, peak in laws.items() if least_ratio(peak, task.rollers, task.step) <= most]
    if fitting:
        remedies.append(f"law = {fitting[0]!r}" + (f" ({len(fitting) - 1} more would do)" if len(fitting) > 1 else ""))
    fewer = most_rollers(task)
    if fewer is not None:
        remedies.append(f"rollers = {fewer} or fewer")
    return ", or ".join(remedies) or "a larger pressure_angle"


def most_rollers(task: IndexingTask) -> int | None:
    """Largest usual z2 that leaves a lambda for this law, step and limit, a miss of 1.5 % tolerated; None: none."""
    fit = [z2 for z2 in ROLLERS if bounds(task.law.peak, z2, task.step, task.limit).excess <= TOLERATED]
    return max(fit, default=None)


def choose_roller(task: IndexingTask, limits: tuple[RollerLimit, ...]) -> tuple[float, str]:
    """r_r, given or chosen, and how; raises `NoSolutionError` for one that is too large."""
    least = governing(limits)
    most = least.radius
    assert most is not None  # rollers of one row touch at some size
    if task.roller is None:
        if most <= 0:
            raise _no_roller("no roller", 0.0, least)
        if most < NO_ROLLER * task.wheel:
            return 0.0, "none works beside a point of the groove: the pitch curve alone"
        return USUAL[0] * most, f"chosen, {USUAL[0]:g} of what {least.name} allow"
    if task.roller >= most * (1 - EQUAL):
        raise _no_roller(f"a roller of {1e3 * task.roller:.6g} mm", task.roller, least)
    return task.roller, "given"


def _no_roller(what: str, value: float, limit: RollerLimit) -> NoSolutionError:
    most = limit.radius or 0.0
    why = {
        "rollers of one row": "neighbours of one row would touch",
        "tip of the lobe": "the working lobe would end before the groove can drive",
        "camshaft": "the groove would cut into the camshaft",
    }.get(limit.name, f"{limit.name} would be undercut at k = {limit.part or 0.0:.4g}")
    more = "a larger centre_distance" + (", or a thinner shaft" if limit.name == "camshaft" else "")
    remedy = f"a roller below {1e3 * most:.6g} mm, or {more}" if most > 0 else more
    return NoSolutionError(
        f"{what} does not work: {why}, the limit is {1e3 * most:.6g} mm",
        where=WHERE,
        value=value,
        limit=most,
        remedy=remedy,
    )
