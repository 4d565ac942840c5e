"""Laws of one's own, brought to the scale of a phase: as ``[cam]`` writes them, as the cams take them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.own import of_accelerations, of_coefficients, of_points
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.cams.laws.law import Law, Values
    from tmmcalc.cams.tables.cam_law import LawTable

CLOSEST = 1e-6  # of the phase, of two points of a smooth curve: between nearer ones it would swing out
KINDS = ("points", "acceleration", "polynomial")


def to_law(law: str | LawTable) -> Law:
    """The law by its name or its table; raises `UsageError` if it cannot move a follower."""
    if isinstance(law, str):
        return LAWS[law]
    kind = next(kind for kind in KINDS if getattr(law, kind) is not None)
    return own_law(kind, getattr(law, kind), law.file or kind)


def own_law(kind: str, values: list[Any], name: str) -> Law:
    """The law of points [k, s] or [k, a] to any scale, or of coefficients.

    Raises `UsageError` if it cannot move a follower.

    >>> float(own_law("polynomial", [0, 0, 3, -2], "cubic").at(np.array([0.5]))[0, 0])
    0.5
    """
    with np.errstate(all="ignore"):
        law = _own_law(kind, values, name)
    if not np.all(np.isfinite(law.coefficients)):
        raise _fault(name, "its numbers are of too different size", "numbers of ordinary size")
    return law


def _own_law(kind: str, values: list[Any], name: str) -> Law:
    if kind == "polynomial":
        return of_coefficients(values, name)
    k, value = _columns(values)
    if kind == "acceleration":
        return of_accelerations(k, value, name)
    close = np.diff(k) < CLOSEST
    if np.any(close & (np.diff(k) > 0)):
        what = (
            f"point number {int(np.argmax(close)) + 2} stands closer than {CLOSEST:g} of the phase to the one before it"
        )
        raise _fault(name, what, "fewer points")
    try:
        return of_points(k, value, name)
    except ValueError:
        raise _fault(name, "its numbers are of too different size", "numbers of ordinary size") from None


def _columns(points: list[list[float]]) -> tuple[Values, Values]:
    """k, from 0 to 1 whatever its scale, and the values."""
    k, value = np.array(points, float).T
    return (k / k[-1] if k[-1] > 0 else k), value


def _fault(name: str, what: str, remedy: str) -> UsageError:
    return UsageError(f"the law {name!r} cannot move a follower: {what}", where="law", remedy=remedy)
