"""What the stages of machines found as keys of their tables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.rewrite import Change, Found

if TYPE_CHECKING:
    from tmmcalc.machine.flywheel.results import Flywheel
    from tmmcalc.machine.room import MachineTables


def of_flywheel(spec: MachineTables, result: Flywheel, choose: int | None = None) -> Found:
    """The needed flywheel on the shaft that the spec names, in the place of the unevenness that it keeps.

    Raises `UsageError` if none is needed.
    """
    if not result.own > 0:
        rule = "no flywheel is needed: the machine keeps delta without one"
        raise UsageError(rule, where="--spec", value=result.own, remedy="leave --spec out, or ask for a smaller delta")
    inertia = Change(("flywheel", "inertia"), result.own, "kg*m^2")
    shaft = (
        "input shaft" if result.ratio == 1 else f"shaft that turns {abs(result.ratio):.6g} times as fast as the input"
    )
    return Found((inertia, Change(("flywheel", "delta"))), of=f"flywheel on the {shaft}", ends=("flywheel",))
