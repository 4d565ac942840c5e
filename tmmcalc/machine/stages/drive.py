"""Stage ``drive``: the ratio that the speeds of motor and crank give a train, and the motor if it is to be chosen."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.machine.settled import Settled

if TYPE_CHECKING:
    from tmmcalc.gears.selection.results import Winner
    from tmmcalc.gears.selection.task import SelectionTask
    from tmmcalc.gears.sizing import SizingTask
    from tmmcalc.gears.trains import Asked
    from tmmcalc.machine.driveline import DriveLine
    from tmmcalc.machine.model import Gears, MotorChoice, TrialTask
    from tmmcalc.machine.reduction.results import Reduction
    from tmmcalc.machine.room import MachineTables
    from tmmcalc.machine.stages.trial import ChosenMotor

kind = Settled

GIVEN = "the ratio of the drive as it is given"


@record
class Sought:
    """The train that is chosen for each motor: what is asked of it, of its strength, and by what it is chosen."""

    train: Asked
    sizing: SizingTask
    selection: SelectionTask


Given = tuple["MotorChoice | None", "Gears", float, "TrialTask | None", Sought | None]


def inputs(spec: MachineTables) -> Given:
    """The motor or the wish for one, the gears, the mean speed; of a motor to choose what it is tried by, its train."""
    from tmmcalc.machine.tables.tasks.machine import to_gears, to_motor, to_trial

    gears, trial = to_gears(spec), to_trial(spec)
    chosen = trial is not None and gears.ratio is None
    return to_motor(spec), gears, _speed(spec), trial if chosen else None, sought(spec) if chosen else None


def _speed(spec: MachineTables) -> float:
    """Mean speed of the crank [rad/s]."""
    if spec.torque is not None:
        return abs(spec.torque.speed)
    assert spec.mechanism is not None
    return abs(spec.mechanism.input.speed)


def sought(spec: MachineTables) -> Sought | None:
    """None: without a strength no train is chosen."""
    if spec.strength is None:
        return None
    from tmmcalc.gears.stages.train import inputs as asked
    from tmmcalc.gears.tables.tasks.sizing import to_selection, to_sizing

    return Sought(asked(spec), to_sizing(spec), to_selection(spec))


def solve(
    wish: MotorChoice | None,
    gears: Gears,
    speed: float,
    trial: TrialTask | None,
    asked: Sought | None,
    *,
    reduction: Reduction | None = None,
) -> Settled:
    """The ratio that is given for the drive, or that of the speeds of motor and crank.

    Raises `UsageError` for a motor that is to be chosen where nothing loads the crank.
    """
    from tmmcalc.machine.settled import of_reducer, origin, settled

    if gears.ratio is not None:
        return Settled(*of_reducer(gears.ratio, GIVEN, gears))
    assert wish is not None
    if wish.motor is not None:
        return Settled(*of_reducer(wish.motor.speed / speed, origin(wish.motor, speed), gears))
    assert trial is not None
    if reduction is None:
        raise UsageError(
            "nothing loads the crank: no motor can be chosen, and without it the train has no ratio",
            where="drive",
            remedy="give ratio in [train], the motor by its name, or the loads",
        )

    def choose(line: DriveLine) -> ChosenMotor:
        from tmmcalc.machine.stages.power import power_of
        from tmmcalc.machine.stages.trial import ChosenMotor

        return ChosenMotor(power_of(reduction, line), reduction, wish, trial)

    def seek(ratio: float, whose: str) -> Winner | None:
        return None if asked is None else best(asked, reduction, Settled(ratio, whose))

    return settled(gears, speed, choose, seek)


def best(sought: Sought, reduction: Reduction, drive: Settled | None = None) -> Winner:
    """The train that the gear stages choose, with the ratio of the ``drive`` where it is not given."""
    from tmmcalc.gears.selection.solve import solve_selection
    from tmmcalc.gears.sizing import solve_sizing
    from tmmcalc.gears.train import solve_train

    trains = solve_train(sought.train, drive)
    return solve_selection(sought.selection, trains, solve_sizing(sought.sizing, trains, reduction)).winner


def errors(result: Settled) -> dict[str, Any]:
    """None: the ratio is one of given speeds."""
    return {}
