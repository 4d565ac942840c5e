"""Which results the constraints of a scene ask about.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.stage import STAGES

if TYPE_CHECKING:
    from tmmcalc.feasibility.room import FeasibilityTables


def asked_about(spec: FeasibilityTables) -> tuple[str, ...]:
    """Stages of the constraints; the designs of a synthesis are judged also by the stages of their own specs.

    A name without a stage may be that of any.
    """
    asked = [constraint.stage for constraint in spec.constraints if constraint.stage]
    if asked:
        from tmmcalc.naming.language import ANY

        if ANY in asked:
            return tuple(STAGES)
    return ("synthesis", *asked)
