"""The result of a strength calculation: modules, widths and stresses of n trains."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.model import Integers, Values
from tmmcalc.gears.strength.coefficient import Coefficient
from tmmcalc.gears.strength.series import Flags, Outcome


@record
class Strength:
    """Modules, face widths and stresses; arrays of the shape (n, stages) if nothing else is said.

    Where meshes share a stage, each number is that of the mesh, and each bending one that of the wheel, which is
    nearest to its limit.
    """

    layout: str  # key
    torque: float  # T1 on wheel 1, of all branches [N*m]
    checked: bool  # modules were given
    contact_module: Values  # module that contact asks for at psi_bd [m]
    bending_module: Values  # module that bending asks for at psi_bd [m]
    module: Values  # standard (or given) module; of a train without one the smallest that is enough [m]
    psi: Values  # psi* = b/d_1 that uses the governing limit fully; of given modules that of their width [-]
    width: Values  # face width b [m]
    contact_spread: Values  # K_Hbeta of the stresses [-]
    bending_spread: Values  # K_Fbeta of the stresses [-]
    contact_stress: Values  # contact stress at this module and width [Pa]
    bending_stress: Values  # bending stress [Pa]
    permissible_contact: Values  # permissible contact stress [Pa]
    permissible_bending: Values  # permissible bending stress [Pa]
    outcome: Integers  # (n,) an `Outcome` each
    psi_unusual: Flags  # psi outside D.4.2
    width_unusual: Flags  # b/m outside 6 to 40
    few_teeth: Flags  # (n,) an external wheel has fewer teeth than the fit of Y_F holds for
    coefficients: tuple[Coefficient, ...]  # of wheels and stages
    warnings: tuple[str, ...]  # of materials and given modules, for all trains

    @property
    def accepted(self) -> Flags:
        """Trains (n,) that are strong enough."""
        return self.outcome == Outcome.ACCEPTED

    @property
    def required(self) -> Values:
        """Module (n, stages) that the governing limit asks for [m]."""
        return np.maximum(self.contact_module, self.bending_module)

    @property
    def contact_governs(self) -> Flags:
        """Stages (n, stages) whose module contact decides; else bending does."""
        return self.contact_module >= self.bending_module

    @property
    def contact_margin(self) -> Values:
        """Unused part (n, stages) of the permissible contact stress; negative: overloaded [-]."""
        return 1 - self.contact_stress / self.permissible_contact

    @property
    def bending_margin(self) -> Values:
        """Unused part (n, stages) of the permissible bending stress; negative: overloaded [-]."""
        return 1 - self.bending_stress / self.permissible_bending

    def __len__(self) -> int:
        """Number of trains."""
        return len(self.outcome)
