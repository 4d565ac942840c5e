"""Where a scene stops to move as one size of it is changed, found from the side that moves.

The square of the regularity falls to zero about evenly with the size, so two sizes tell where: nine tenths of the way
are gone at each step. Where that leads beyond a size that is known not to move, the way is halved.
"""

from __future__ import annotations

from collections.abc import Callable

Regular = Callable[[float], float | None]  # regularity of the scene with a factor on its size, None if it cannot move

NEAR = 1e-11  # part of the size within which the zero of the line through the last two is the limit
TIGHT = 2.0**-44
MOST = 80  # steps
GONE = 0.9


def limit_of(regular: Regular, good: float, bad: float) -> float:
    """The factor between ``good``, which moves, and ``bad``, which does not, at which the motion ends.

    >>> round(limit_of(lambda f: (2.0 - f) ** 0.5 if f < 2.0 else None, 1.0, 3.0), 12)
    2.0
    """
    at, size = good, _square(regular, good)
    before: tuple[float, float] | None = None
    for _ in range(MOST):
        zero = _zero((at, size), before)
        if zero is None or not min(at, bad) < zero < max(at, bad):
            zero = None
        elif abs(zero - at) <= NEAR * abs(at):
            return zero
        if abs(bad - at) <= TIGHT * abs(at):
            break
        aim = (at + bad) / 2 if zero is None else at + GONE * (zero - at)
        found = regular(aim)
        if found is None:
            bad = aim
        else:
            before, at, size = (at, size), aim, found**2
    return bad


def _square(regular: Regular, factor: float) -> float:
    found = regular(factor)
    return 1.0 if found is None else found**2


def _zero(here: tuple[float, float], before: tuple[float, float] | None) -> float | None:
    """Where the line through two sizes and their squared regularities is zero, None if it rises."""
    if before is None or not 0 < here[1] < before[1]:
        return None
    return here[0] + here[1] * (here[0] - before[0]) / (before[1] - here[1])
