"""``[tie_down]``: ties that hold a load on a vehicle."""

import math
from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Within
from tmmcalc.spec.quantities import Friction, Number, Quantity
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}
_ANGLE = ("angle", "deg", math.pi / 180)

Weight = Annotated[float, Quantity("force", **_POSITIVE)]
OwnWeight = Annotated[float, Quantity("force", at_least_zero=True)]
Factor = Annotated[float, Number("a part of the weight", "0.8", at_least=0, at_most=100)]
Elevation = Annotated[float, Within(*_ANGLE, 0, 89)]
Base = Annotated[float, Quantity("length", **_POSITIVE)]
Arm = Annotated[float, Quantity("length", at_least_zero=True)]
Moment = Annotated[float, Quantity("moment", **_POSITIVE)]
Section = Annotated[float, Quantity("area", **_POSITIVE)]
Stress = Annotated[float, Quantity("pressure", **_POSITIVE)]
Sharp = Annotated[float, Within(*_ANGLE, 0, 44)]


class ThreadTable(Table):
    """The thread that tightens a tie."""

    moment: Moment = Field(description="M: moment by which it is tightened.")
    diameter: Base = Field(description="d2: mean diameter of the thread.")
    lead_angle: Sharp = Field(description="lambda: lead angle.")
    friction_angle: Sharp = Field(description="rho': reduced angle of friction.")


class SupportTable(Table):
    """The sliding support of the load."""

    weight: OwnWeight = Field(default=0.0, description="G_o: its own weight.")
    friction: Friction = Field(description="mu_s: coefficient of friction of the support.")
    base: Base = Field(description="L: from the cradle to the support.")
    cradle_arm: Arm = Field(description="a: the cradle carries G2 a/L of the load.")
    arm: Arm = Field(description="b: the support carries G2 b/L of the load.")
    diameter: Arm = Field(default=0.0, description="D: the inertia force acts D/2 above the supports.")


class TieDownTable(Table):
    """The load, its ties, what they are tightened by."""

    weight: Weight = Field(description="G2: weight of the load.")
    factor: Factor = Field(description="k: the inertia force along the way over the weight.")
    elevation: Elevation = Field(description="alpha: angle of the ties above the floor.")
    plan_angle: Elevation = Field(default=0.0, description="beta: angle of the ties in plan from the way.")
    friction: Friction = Field(description="mu: coefficient of friction of the load on its cradle.")
    preload: OwnWeight | None = Field(
        default=None,
        description="P0: preload to which each of the four ties is tightened (default: 0); or `[tie_down.thread]`.",
    )
    section: Section | None = Field(default=None, description="Section of a tie, which gives its stress.")
    strength: Stress | None = Field(
        default=None, description="Yield stress of a tie, with `section`: its safety, and from which k on it yields."
    )
    thread: ThreadTable | None = Field(default=None, description="The thread that gives the preload.")
    support: SupportTable | None = Field(default=None, description="A sliding support that carries a part of the load.")
