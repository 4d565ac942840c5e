"""Why a pair of a project is refused, said in its own units, and several pairs at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.quality.verdicts import Check
from tmmcalc.gears.meshing.task import PairTask


def millimetres(length: float) -> str:
    """A length [m] as text.

    >>> millimetres(0.085)
    '85 mm'
    """
    return f"{1000 * length:.6g} mm"


def place(task: PairTask) -> str:
    """The pair as errors name it."""
    fixed = task.strategy == "given_aw" and task.distance is not None
    what = task.title if task.name.startswith("pair ") else f"pair {task.title}"
    return what + (f", centre distance {millimetres(task.distance or 0.0)}" if fixed else "")


@contextmanager
def named(task: PairTask) -> Iterator[None]:
    """Let errors of the involute room name the pair."""
    try:
        yield
    except NoSolutionError as error:
        where = place(task)
        if error.where == where:
            raise
        raise NoSolutionError(
            error.message, where=where, value=error.value, limit=error.limit, remedy=error.remedy
        ) from None


def refuse(task: PairTask, checks: Sequence[Check], remedy: Callable[[], str]) -> None:
    """Raise `NoSolutionError` with every check that failed, if the task refuses such pairs."""
    broken = [check for check in checks if check.verdict == "fail"]
    if not (broken and task.refuse):
        return
    least = min(broken, key=lambda check: check.margin)
    raise NoSolutionError(
        "; ".join(map(_told, broken)),
        where=place(task),
        value=least.value,
        limit=least.limit,
        remedy=remedy(),
    )


def _told(check: Check) -> str:
    return check.text if "margin" in check.text else f"{check.text} (margin {check.margin:.4g})"


def remedy_by(task: PairTask, require: Callable[[], None], tips: Sequence[float]) -> str:
    """The remedy that ``require`` names for the pair with tips by the rule, which are ``tips`` [modules].

    If that pair is sound, the tips that were asked for are the fault.
    """
    try:
        require()
    except NoSolutionError as error:
        asked = any(tip is not None for tip in task.tips)
        return f"{error.remedy} (with tips by the rule)" if asked else error.remedy
    usual = " and ".join(millimetres(2 * tip * task.module) for tip in tips)
    return f"the tip diameters by the rule: {usual}"


def require_distance(task: PairTask, least: float, bases: str, nearest: Callable[[], str]) -> float:
    """The centre distance in modules; ``least`` is in modules too, ``nearest`` tells the nearest admissible one.

    Raises `UsageError` if none is given, `NoSolutionError` if it does not exceed the least one.
    """
    if task.distance is None:
        raise UsageError("a centre distance is missing", where=place(task), remedy="give centre_distance")
    given = task.distance / task.module
    if given > least:
        return given
    said, limit = millimetres(task.distance), millimetres(least * task.module)
    raise NoSolutionError(
        f"the centre distance {said} does not exceed the {bases} of the base radii, {limit} "
        f"(margin {millimetres(task.distance - least * task.module)})",
        where=place(task),
        value=task.distance,
        limit=least * task.module,
        remedy=f"{nearest()}, or other numbers of teeth or another helix angle",
    )


def error_of_all(errors: Sequence[NoSolutionError], total: int) -> NoSolutionError:
    """One error for all pairs that cannot be made."""
    if len(errors) == 1:
        return errors[0]
    told = "\n".join(f"  {line}" for error in errors for line in str(error).split("\n"))
    worst = errors[0]
    return NoSolutionError(
        f"{len(errors)} of {total} cannot be made\n{told}", where="pairs", value=worst.value, limit=worst.limit
    )
