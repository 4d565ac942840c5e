"""What the search for the true flywheel found: the inertias tried, and the least one that does."""

from __future__ import annotations

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.machine.regime import Regime


@record
class Trial:
    """One run of the model."""

    inertia: float = quantity("J[kg*m^2]", "constant inertia")
    delta: float | None = quantity("delta", "coefficient of speed fluctuation")  # None: the machine stalls


@record
class RequiredInertia:
    """The least constant inertia for the asked fluctuation, and the motion with it."""

    inertia: float  # total constant inertia, reduced to the input shaft [kg*m^2]
    addition: float  # the flywheel: what of it is not at hand yet [kg*m^2]
    needed: bool  # False: the inertia at hand suffices
    delta: float  # coefficient of speed fluctuation reached [-]
    regime: Regime  # the steady motion with it
    trials: tuple[Trial, ...]  # all inertias tried, ascending
    monotone: bool = quantity("monotone", "among the trials delta falls as the inertia grows")
    remarks: tuple[str, ...]
    error: float = 0.0  # estimated relative error of the inertia

    @property
    def evaluations(self) -> int:
        """Number of inertias tried."""
        return len(self.trials)
