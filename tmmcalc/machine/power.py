"""Work per cycle, efficiency and power, and the motor that they ask for (textbook 3.35-3.37).

Work of the loads is told apart by its sign over the cycle: what drives, what resists, what friction and dampers
take. If the loads leave work over (A_d + A_c + A_F > 0), the machine that is driven takes it; if they lack some, a
drive gives it. The efficiency is useful work over work put in: useful is the work against resisting loads and what is
left over, put in is the work of driving loads and what is lacking. So it is A_c/(A_c + A_F) where work is lacking
(3.36) and (A_d + A_F)/A_d where some is left (3.37), whatever drives and resists besides. An engine is a machine into
which its loads put more work than a drive. Weights and springs give back over a cycle what they take.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Note
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driveline import DriveLine, Round
from tmmcalc.machine.judged import Judged, Taken
from tmmcalc.machine.motors.model import CharacteristicKind, Motor
from tmmcalc.machine.motors.plausibility import Curve, contradictions, curve_of

if TYPE_CHECKING:
    from tmmcalc.machine.motors.choice import Choice, Trial

LOSSES = ("friction", "damper")
STORES = ("weight", "spring")
READ = 4 * EPS  # rounding of a value that is read between the points of a panel
NOTHING = 1e-12  # work below this part of the turnover is none


@record
class WorkPart:
    """Work of one cause over a cycle."""

    name: str
    kind: str  # "load", "weight", "spring", "damper", "friction", "balance"
    work: float = quantity("work_{cause}[J]", "work of {cause} over a cycle")
    turnover: float = 0.0  # work of its magnitude, which tells work from rounding [J]; 0: not known
    error: float = 0.0  # estimated, of the work [J]


@record
class MotorDuty:
    """The motor against its duty: what is asked of it at its shaft, and how it was found."""

    motor: Motor
    ratio: float = quantity("u", "speed of the motor over the speed of the input shaft")
    chosen: bool = quantity("motor_chosen", "the motor is from a catalogue, and not given")
    reasons: tuple[str, ...] = quantity("motor_reasons", "why the motor was chosen")
    rotor: float = quantity(  # 0 if the inertia of the rotor is not known
        "J_rotor[kg*m^2]", "inertia J_R u^2 of the rotor at the input"
    )
    mean_load: float = quantity("mean_load", "mean resisting moment at the motor's shaft over its rated moment")
    peak_load: float = quantity("peak_load", "largest resisting moment at the motor's shaft over its rated moment")
    curve: Curve | None = None  # ends of a direct-current motor's characteristic; None: another motor
    contradictions: tuple[Note, ...] = ()  # among the data of the motor
    ratio_of: str = quantity("u_of", "gear train whose ratio u is; empty: given, or of the speeds", default="")
    off_speed: Note | None = None  # what is wrong with its speed against that of the spec
    judged: tuple[Judged, ...] = ()  # of a motor that was chosen: itself and all smaller ones, by their power
    taken: tuple[Taken, ...] = ()  # of a motor that was chosen: what each rule of choice would take
    rounds: tuple[Round, ...] = ()  # in which motor, ratio and train settled
    in_turn: tuple[str, ...] = ()  # motors that came in turn, so that they did not; the strongest is taken


@record
class PowerError:
    """Estimated relative errors."""

    work: float  # of works, mean power and mean moment: against the sum of the turnovers of all causes
    efficiency: float  # of the efficiency, and so of useful work and work put in
    peak: float  # of moments and powers at single places: against the largest moment of a cause or of all


@record
class Power:
    """Result of the power stage; moments and work are those of the input shaft."""

    machine: Literal["working", "engine", "idle"] = quantity("machine", "kind of the machine")
    parts: tuple[WorkPart, ...]
    driving: float = quantity("A_d[J]", "work of the loads that drive, over a cycle")
    resisting: float = quantity("A_c[J]", "work of the loads that resist, over a cycle; negative")
    losses: float = quantity("A_F[J]", "work of friction and dampers over a cycle; negative")
    stored: float = quantity("work_stored[J]", "work of weights and springs over a cycle, 0 but for rounding")
    efficiency: float | None = quantity(  # None where nothing useful is done
        "eta", "efficiency: useful work over work put in", source="(3.36), (3.37)"
    )
    cycle_time: float = quantity("cycle_time[s]", "time of a cycle at the mean speed", symbol="T")
    mean_power: float = quantity("P_mean[W]", "mean power of all loads, which a drive has to give or can take")
    peak_power: tuple[float, float]  # least and largest instant power of all loads [W]
    mean_moment: float = quantity(
        "M_d_mean[N*m]", "moment that makes the work of the cycle zero: of the drive, or < 0 of what is driven"
    )
    peak_moment: float = quantity("M_peak[N*m]", "largest resisting reduced moment")
    peak_at: float  # theta there [rad]
    start_moment: float  # resisting reduced moment in position 0, 0 if none resists there [N*m]
    line: DriveLine  # between the motor and the input shaft
    motor_power: float | None = quantity(  # None where the loads leave power over
        "P_required[W]", "power required of the motor, P_mean/eta_gears"
    )
    duty: MotorDuty | None  # None without a motor
    error: PowerError
    counters: dict[str, int]
    speed: float  # of the input, at which all of this holds [rad/s]
    sense: float = 1.0  # of the input's motion: -1 clockwise; places are sense theta
    balancing: float = quantity(
        "M_balancing[N*m]", "moment that closes the work of a diagram beside the loads", default=0.0
    )

    @derived("P_load_min[W]", "least instant power of all loads")
    def least_power(self) -> float:
        """Negative where they resist."""
        return self.peak_power[0]

    @derived("P_load_max[W]", "largest instant power of all loads")
    def largest_power(self) -> float:
        """Positive where they drive."""
        return self.peak_power[1]

    @derived("P_balancing[W]", "power of the moment that closes the work of a diagram")
    def balancing_power(self) -> float:
        """At the mean speed."""
        return self.balancing * self.speed

    @property
    def transmission(self) -> float:
        """Efficiency of the gears to the motor."""
        return self.line.efficiency

    @derived("M_N_input[N*m]", "rated moment of the motor at the input shaft")
    def rated_moment(self) -> float | None:
        """M_N u eta_gears; None without a motor."""
        duty = self.duty
        return None if duty is None else duty.motor.nominal_moment * duty.ratio * self.transmission


def moment_at(cycle: Cycle, speed: float) -> Values:
    """Reduced moment (K, N) [N*m] at a constant speed [rad/s]."""
    return cycle.moment + cycle.viscous * speed + cycle.quadratic * speed**2


def solve_power(
    cycle: Cycle,
    parts: tuple[WorkPart, ...],
    line: DriveLine | None = None,
    sense: float = 1.0,
    rounding: float = 0.0,
) -> Power:
    """Work, efficiency and power of a cycle at its mean speed.

    ``line`` is between the motor and the input shaft, None: nothing; ``sense`` is -1 where the input turns clockwise.
    ``rounding`` is that of moments, against the largest of one cause.
    """
    line = line or DriveLine()
    scale = max((max(part.turnover, abs(part.work)) for part in parts), default=0.0)
    loads = [part.work for part in parts if part.kind == "load" and abs(part.work) > NOTHING * scale]
    driving, resisting = sum((w for w in loads if w > 0), 0.0), sum((w for w in loads if w < 0), 0.0)
    losses = sum((part.work for part in parts if part.kind in LOSSES), 0.0)
    moment = moment_at(cycle, cycle.speed) - cycle.balancing
    (least, least_at), (largest, largest_at) = cycle.panels.extremes(moment)
    time = cycle.period / cycle.speed
    left = driving + resisting + losses
    total = left if abs(left) > NOTHING * scale else 0.0
    mean_power = abs(total) / time
    efficiency = _efficiency(driving, resisting, total)
    of_peak = _of_peak(cycle, moment, (least_at, largest_at, 0.0), rounding)
    return Power(
        machine=_kind(driving, total) if loads else "idle",
        parts=parts,
        driving=driving,
        resisting=resisting,
        losses=losses,
        stored=sum((part.work for part in parts if part.kind in STORES), 0.0),
        efficiency=efficiency,
        cycle_time=time,
        mean_power=mean_power,
        peak_power=(least * cycle.speed, largest * cycle.speed),
        mean_moment=-total / cycle.period,
        peak_moment=max(-least, 0.0),
        peak_at=least_at,
        start_moment=max(-float(cycle.panels.at(moment, np.zeros(1))[0]), 0.0),
        line=line,
        motor_power=mean_power / line.efficiency if total <= 0 and not cycle.balancing else None,
        duty=None,
        error=PowerError(
            _of_work(parts), _of_ratio(parts, driving, resisting, total, left) if efficiency else 0.0, of_peak
        ),
        counters={"panels": len(cycle.panels.edges) - 1},
        speed=cycle.speed,
        sense=sense,
        balancing=cycle.balancing,
    )


def _kind(driving: float, total: float) -> Literal["working", "engine"]:
    """Whether the driving loads put more work into the machine than a drive that gives what is lacking."""
    return "engine" if driving > max(-total, 0.0) else "working"


def _efficiency(driving: float, resisting: float, total: float) -> float | None:
    """Useful work over work put in: (3.37) where work is left over, (3.36) where it is lacking."""
    useful = -resisting + max(total, 0.0)
    return useful / (driving + max(-total, 0.0)) if useful > 0 else None


def _of_work(parts: Sequence[WorkPart]) -> float:
    """Relative error of all works against the sum of their turnovers."""
    return math.fsum(part.error for part in parts) / (math.fsum(max(p.turnover, abs(p.work)) for p in parts) or 1.0)


def _of_ratio(parts: Sequence[WorkPart], driving: float, resisting: float, total: float, left: float) -> float:
    """Relative error of the efficiency A_c/(A_c + A_F), or (A_d + A_F)/A_d: as far as the losses take it from 1.

    Where the work that is ``left`` counts as none the loads may differ by it, and by their errors.
    """
    off, lost = (math.fsum(p.error for p in parts if p.kind in kinds) for kinds in (("load",), LOSSES))
    losses = math.fsum(part.work for part in parts if part.kind in LOSSES)
    if not total:
        return 2 * EPS + (abs(left) + off + lost) / driving
    own = driving if total > 0 else -resisting
    return 2 * EPS + (off * abs(losses) / own + lost) / (own + losses if total > 0 else own - losses)


def _of_peak(cycle: Cycle, moment: Values, at: tuple[float, ...], rounding: float) -> float:
    """Relative error of a moment (K, N) at some places of the cycle."""
    k = np.clip(np.searchsorted(cycle.panels.edges, at, side="right") - 1, 0, cycle.panels.count - 1)
    beside = np.clip((k - 1, k), 0, cycle.panels.count - 1)  # a place on an edge is the end of either panel
    return READ + rounding + float(np.max(cycle.panels.left_out(moment)[beside]) / (np.max(np.abs(moment)) or 1.0))


def duty_of(
    power: Power,
    motor: Motor,
    ratio: float,
    reasons: tuple[str, ...],
    chosen: bool,
    kind: CharacteristicKind | None = None,
) -> MotorDuty:
    """How a motor stands to the load of the machine; without the ``kind`` its characteristic is not looked at."""
    rated = motor.nominal_moment * ratio * power.transmission
    return MotorDuty(
        motor,
        ratio,
        chosen,
        reasons,
        (motor.inertia or 0.0) * ratio**2,
        max(power.mean_moment - power.balancing, 0.0) / rated,
        power.peak_moment / rated,
        None if kind is None else curve_of(motor, kind),
        () if kind is None else contradictions(motor, kind),
    )


def chosen_motor(
    power: Power,
    catalogue: tuple[Motor, ...],
    input_speed: float,
    ratio: float | None,
    synchronous: float | None,
    reserve: float = 0.0,
    trial: Trial | None = None,
) -> Choice:
    """The least motor of a catalogue that covers the required power, starts in position 0 and stands the ``trial``.

    Peaks of the load on the way are shared with the kinetic energy of the machine: what is left of them for the motor
    the trial tells, which finds the motion. Raises `NoSolutionError` if no motor does.
    """
    from tmmcalc.machine.motors.choice import choose

    if not power.motor_power:
        raise NoSolutionError(
            "nothing resists over the cycle, so no motor can be chosen by its power",
            where="power",
            remedy="give the motor by its name or its data, or add the loads that it has to overcome; where the torque "
            "diagram is balanced, nothing is left to drive",
        )
    start = power.start_moment / power.transmission
    # a catalogue that knows no starting moments cannot be asked for them
    asked = start > NOTHING * power.peak_moment and any(motor.start is not None for motor in catalogue)
    return choose(
        power.motor_power,
        catalogue,
        synchronous=synchronous,
        input_speed=input_speed,
        ratio=ratio,
        start_moment=start if asked else None,
        reserve=reserve,
        trial=trial,
    )
