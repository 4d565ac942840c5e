"""Laws of one index step: those of the catalogue that are symmetric, and accelerations with constant ends.

    s(k) + s(1 - k) = 1,   b = s',   c = s'',   B = b(1/2), for the usual laws the largest b

Both flanks of a lobe are then mirror images of each other, and the groove is symmetric.
"""

from __future__ import annotations

import re

import numpy as np

from tmmcalc.cams.laws.catalogue import LAWS, law_of
from tmmcalc.cams.laws.law import Acceleration, Law, of_acceleration
from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import panels
from tmmcalc.core.records import record

WIDEST = 1 / 8  # of a panel
SYMMETRIC = 1e-9  # by so much s(k) + s(1 - k) may differ from 1
CODE = re.compile(r"00(\d\d)")
SAME = {"0000": "linear", "0050": "const"}  # codes of laws of the catalogue
HALF = np.array([0.5])


@record
class StepLaw:
    """The law of one step; ``law`` None: only its B is known."""

    name: str
    peak: float  # B = b(1/2)
    law: Law | None = None


def constant_ends(part: float, name: str = "") -> Law:
    """Acceleration constant over ``part`` (0 to 0.5) of the time at each end, a straight line between: law 00ee.

    >>> round(float(constant_ends(0.1).at(np.array([0.5]))[1, 0]), 6)
    1.525424
    """
    if not 0 <= part <= 0.5:
        remedy = "a part from 0 to 0.5"
        raise UsageError(f"constant ends of {part:g} of the step", where="law", value=part, limit=0.5, remedy=remedy)
    name = name or f"constant ends of {100 * part:g} %"
    if part == 0.5:
        return of_acceleration(name, Acceleration(0.0, (1.0,)), Acceleration(0.5, (-1.0,)))
    fall = Acceleration(part, (1.0, -2 / (1 - 2 * part)))
    if part == 0:
        return of_acceleration(name, fall)
    return of_acceleration(name, Acceleration(0.0, (1.0,)), fall, Acceleration(1 - part, (-1.0,)))


def step_law(name: str) -> StepLaw:
    """The law of this name in the catalogue, or of a code 00ee: ee percent of constant acceleration at each end.

    Raises `UsageError` for an unknown law, and for one that is not symmetric.

    >>> step_law("shun").peak, step_law("0050").peak
    (1.875, 2.0)
    """
    code = CODE.fullmatch(name)
    if code is None or name in SAME:
        return stepping(law_of(SAME.get(name, name)))
    return stepping(constant_ends(int(code[1]) / 100, name))


def stepping(law: Law) -> StepLaw:
    """The law as that of a step; raises `UsageError` if it is not symmetric about its middle, or turns back."""
    if not is_symmetric(law):
        raise UsageError(
            f"the law {law.name!r} is not symmetric about the middle of the step: the flanks of a lobe would differ",
            where="law",
            remedy=f"a law with s(k) + s(1 - k) = 1: {', '.join(symmetric_laws())}, or 00ee",
        )
    on = panels(0.0, 1.0, law.breaks, WIDEST)
    (least, at), (most, _) = on.extremes(law.at(on.x.ravel())[1].reshape(on.x.shape))
    if least < -SYMMETRIC * most:
        raise UsageError(
            f"with the law {law.name!r} the wheel turns back, s' = {least:.4g} at k = {at:.4g}",
            where="law",
            value=least,
            limit=0.0,
            remedy="a law whose displacement grows all the way",
        )
    return StepLaw(law.name, float(law.at(HALF)[1, 0]), law)


def is_symmetric(law: Law) -> bool:
    """Whether the second half is the first turned about the middle."""
    k = np.concatenate((np.linspace(0.0, 1.0, 65), law.breaks, 1 - law.breaks))
    return bool(np.max(np.abs(law.at(k)[0] + law.at(1 - k)[0] - 1)) <= SYMMETRIC)


def symmetric_laws() -> tuple[str, ...]:
    """Names of the laws of the catalogue that a step can have."""
    return tuple(name for name, law in LAWS.items() if is_symmetric(law))
