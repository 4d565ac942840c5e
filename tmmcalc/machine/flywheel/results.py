"""The records of the flywheel stage: what the methods ask for, what the search found, the wheel."""

from __future__ import annotations

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.flywheel.methods import FlywheelMethod
from tmmcalc.machine.flywheel.placement import Wheel
from tmmcalc.machine.flywheel.rim import Rim
from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.verdicts import Verdict


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


@record
class Row:
    """One method in the comparison; the last two are None without a motor."""

    positional: FlywheelMethod  # what it asks for under forces of position
    delta: float | None  # coefficient reached under the motor's characteristic [-]; None: it stalls, or was not tried
    error: float | None  # relative error of the total constant inertia against the true one [-]


@record
class Comparison:
    """The methods for forces of position beside the true flywheel."""

    rows: tuple[Row, ...]
    required: RequiredInertia | None  # None without a motor


@record
class Flywheel:
    """Result of the flywheel stage; inertias are reduced to the input shaft [kg*m^2] unless said otherwise."""

    delta: float = quantity("delta_allowed", "coefficient of speed fluctuation that is allowed")
    at_hand: ConstantInertia  # rotor, gears, further; the flywheel left out
    rows: tuple[Row, ...]  # the methods for forces of position, the exact one first
    required: RequiredInertia | None  # under the motor, or the loads alone; None: a constant moment drives
    inertia: float = quantity("J_F[kg*m^2]", "total constant inertia needed")
    addition: float = quantity("J_add[kg*m^2]", "flywheel needed at the input shaft")
    existing: float = quantity("J_existing[kg*m^2]", "flywheel that is there, at the input shaft")
    sufficient: bool | None = quantity("existing_suffices", "the flywheel that is there does")  # None: there is none
    wheels: tuple[Wheel, ...]  # the needed flywheel on its shaft, then on the others for comparison
    nodal: FlywheelMethod | None  # the textbook's method on the table of positions; None if its steps differ
    picture: EnergyMass  # Wittenbauer's energy-mass curve with the tangents
    history: tuple[Trial, ...]  # J_c := J_c delta/[delta] on the true model (3.60); empty without a motor, or not tried
    verdicts: tuple[Verdict, ...]
    sense: float = 1.0  # of the input's motion: -1 clockwise; places are sense theta
    undriven: bool = False  # without a motor: the loads alone set the speed
    error: float = 0.0  # estimated relative error of the total constant inertia
    uneven: float = 0.0  # and of the unevenness with it, or with what is at hand where that is more

    @property
    def under(self) -> str:
        """What the machine really runs under, in words."""
        if self.undriven:
            return "its loads"
        return "forces of position" if self.required is None else "the motor"

    @derived("J_at_hand[kg*m^2]", "constant inertia at hand without a flywheel")
    def without(self) -> float:
        """Of rotor, gears and what is further there."""
        return self.at_hand.total

    @derived("J_own[kg*m^2]", "inertia of the needed flywheel on its own shaft")
    def own(self) -> float:
        """J_add over the square of the ratio."""
        return self.wheels[0].inertia

    @derived("ratio_flywheel", "speed of the flywheel's shaft over that of the input shaft")
    def ratio(self) -> float:
        """Negative where it turns against the input shaft."""
        return self.wheels[0].ratio

    @derived("omega_flywheel_max[rad/s]", "largest speed of the flywheel")
    def fastest(self) -> float:
        """On its own shaft."""
        return self.wheels[0].speed

    @derived("delta_reached", "coefficient of speed fluctuation reached")
    def reached(self) -> float | None:
        """Under what the machine runs under.

        None where it stalls, and where forces of position ask for a flywheel: then it is the allowed one.
        """
        if self.required is not None:
            return self.required.delta
        return self.rows[0].positional.delta if self.addition <= 0 else None

    @property
    def rim(self) -> Rim | None:
        """Its rim; None if no flywheel is needed, or none can be made."""
        return self.wheels[0].rim
