"""Which results the constraints of a scene ask about.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.feasibility.room import FeasibilityTables


def asked_about(spec: FeasibilityTables) -> tuple[str, ...]:
    """Stages of the constraints; the designs of a synthesis are judged also by the stages of their own specs."""
    return ("synthesis", *(constraint.stage for constraint in spec.constraints))
