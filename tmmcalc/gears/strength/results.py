"""The result of a strength calculation: modules, widths and stresses of n trains."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.notes import Note
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.model import Integers, Values
from tmmcalc.gears.strength.demand import LEAST_TEETH
from tmmcalc.gears.strength.endurance import Coefficient
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
    contact_module: Values = quantity("m_H_{stage}[m]", "module that contact asks for at psi_bd")
    bending_module: Values = quantity("m_F_{stage}[m]", "module that bending asks for at psi_bd")
    # of a train without a standard (or given) module the smallest that is enough
    module: Values = quantity("modules[m]", "normal module", header="m_{stage}[m]")
    # of given modules that of their width
    psi: Values = quantity("psi_{stage}", "b/d_1 that uses the governing limit fully", symbol="psi^*")
    width: Values = quantity("widths[m]", "face width", header="b_{stage}[m]")
    contact_spread: Values = quantity("K_Hbeta_{stage}", "load distribution of the contact stress")
    bending_spread: Values = quantity("K_Fbeta_{stage}", "load distribution of the bending stress")
    contact_stress: Values = quantity(
        "contact_stress[Pa]", "contact stress at this module and width", header="sigma_H_{stage}[Pa]"
    )
    bending_stress: Values = quantity(
        "bending_stress[Pa]", "bending stress at this module and width", header="sigma_F_{stage}[Pa]"
    )
    permissible_contact: Values = quantity(
        "permissible_contact[Pa]", "permissible contact stress", header="sigma_HP_{stage}[Pa]"
    )
    permissible_bending: Values = quantity(
        "permissible_bending[Pa]", "permissible bending stress", header="sigma_FP_{stage}[Pa]"
    )
    outcome: Integers  # (n,) an `Outcome` each
    psi_unusual: Flags  # psi outside D.4.2
    width_unusual: Flags  # b/m outside 6 to 40
    least_teeth: Integers  # (n,) of the external wheels
    coefficients: tuple[Coefficient, ...]  # of wheels and stages
    warnings: tuple[Note, ...]  # of materials and given modules, for all trains

    @property
    def few_teeth(self) -> Flags:
        """Trains (n,) of which an external wheel has fewer teeth than the fit of Y_F holds for."""
        return self.least_teeth < LEAST_TEETH

    @property
    def accepted(self) -> Flags:
        """Trains (n,) that are strong enough."""
        return self.outcome == Outcome.ACCEPTED

    @property
    def required(self) -> Values:
        """Module (n, stages) that the governing limit asks for [m]."""
        return np.maximum(self.contact_module, self.bending_module)

    @derived("governs_{stage}", "whether contact or bending decides the module")
    def contact_governs(self) -> Flags:
        """Stages (n, stages) whose module contact decides; else bending does."""
        return self.contact_module >= self.bending_module

    @derived("contact_margin", "unused part of the permissible contact stress", header="margin_H_{stage}")
    def contact_margin(self) -> Values:
        """Negative (n, stages): overloaded."""
        return 1 - self.contact_stress / self.permissible_contact

    @derived("bending_margin", "unused part of the permissible bending stress", header="margin_F_{stage}")
    def bending_margin(self) -> Values:
        """Negative (n, stages): overloaded."""
        return 1 - self.bending_stress / self.permissible_bending

    def __len__(self) -> int:
        """Number of trains."""
        return len(self.outcome)
