"""The criteria by which gear trains are compared."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.gears.model import Values


class Measured(Protocol):
    """Anything that has the criteria of n variants."""

    @property
    def mass(self) -> Values:
        """Mass [kg] (n,)."""

    @property
    def inertia(self) -> Values:
        """Reduced moment of inertia [kg*m^2] (n,)."""

    @property
    def size(self) -> Values:
        """Size D [m] (n,)."""

    @property
    def envelope(self) -> Values:
        """Envelope [m] (n,)."""

    @property
    def efficiency(self) -> Values:
        """Efficiency (n,)."""

    @property
    def error(self) -> Values:
        """Relative deviation of the ratio (n,)."""

    @property
    def width_deviation(self) -> Values:
        """Relative deviation of b/m from the usual range (n,)."""


@record
class Objective:
    """A criterion of choice."""

    key: str
    unit: str
    largest: bool = False  # whether more is better


OBJECTIVES = {
    objective.key: objective
    for objective in (
        Objective("mass", "kg"),
        Objective("inertia", "kg*m^2"),
        Objective("size", "m"),
        Objective("envelope", "m"),
        Objective("efficiency", "-", largest=True),
        Objective("error", "-"),
        Objective("width_deviation", "-"),
    )
}
