"""The trial of motors of a catalogue in the machine: the steady motion with each, and the starts that are asked for."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.machine.judged import Judged, decided, kept, taken
from tmmcalc.machine.motors.model import with_lag
from tmmcalc.machine.onemass import vanishing
from tmmcalc.machine.power import chosen_motor, duty_of
from tmmcalc.machine.settled import MotorFound
from tmmcalc.machine.stages.shaft import constant_inertia, driver, flywheel_inertia

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from tmmcalc.machine.driver import Driver
    from tmmcalc.machine.model import FlywheelTask, MotorChoice, TransientTask, TrialTask
    from tmmcalc.machine.motors.model import Motor
    from tmmcalc.machine.power import Power
    from tmmcalc.machine.reduction.results import Reduction
    from tmmcalc.machine.regime import Regime

BEYOND = 3.0  # times the power that was chosen: so far up a rule is followed that the choice does not ask for


class Moments(NamedTuple):
    """The moment of a motor in the steady motion, at its shaft [N*m]."""

    rms: float
    largest: float


class Trials:
    """Motors in the machine of ``power``, with its drive line; each is tried once."""

    def __init__(self, power: Power, reduction: Reduction, wish: MotorChoice, task: TrialTask) -> None:
        self.power, self.reduction, self.wish, self.task = power, reduction, wish, task
        self.done: dict[Motor, Judged] = {}
        self.overload = False  # whether a motor without overload ratio is refused: others of the catalogue have one
        self.wheels: dict[Motor, float] = {}  # inertia of the flywheel with each at the input shaft [kg*m^2]

    def moved(self, motor: Motor, ratio: float | None) -> Judged:
        """The motor by its steady motion."""
        if motor not in self.done:
            self.done[motor] = self._moved(motor, ratio or motor.speed / self.reduction.cycle.speed)
        return self.done[motor]

    def against(self, motor: Motor, ratio: float | None) -> str:
        """What speaks against a motor; empty: nothing. Starts cost most and are tried last."""
        found = self.moved(motor, ratio)
        return found.reason or self.started(motor, ratio).reason

    def started(self, motor: Motor, ratio: float | None) -> Judged:
        """The motor by the starts that are asked for, too."""
        found = self.moved(motor, ratio)
        if found.starts is None and found.heating is not None and self.task.starts:
            try:
                against = self._start(motor, found.ratio or 1.0)
            except (AccuracyError, NoSolutionError) as error:
                against = Phrase("a start with it is not found: {message}", message=error.message)
            found = self.done[motor] = replace(found, starts=not against, reason=found.reason or against)
        return found

    def _moved(self, motor: Motor, ratio: float) -> Judged:
        judged = Judged(motor, ratio, (self.power.motor_power or 0.0) / motor.power)
        try:
            moments = self._moments(motor, ratio)
        except (NoSolutionError, AccuracyError) as error:
            return replace(judged, reason=Phrase("with it there is no steady motion: {message}", message=error.message))
        except UsageError as error:  # a datum that the characteristic or the lag asks for
            return replace(judged, reason=error.message)
        rated, overload = motor.nominal_moment, motor.overload
        judged = replace(
            judged,
            heating=moments.rms / rated,
            peak=moments.largest / rated,
            largest=None if overload is None else moments.largest / (overload * rated),
        )
        return replace(judged, reason=self._refused(judged, moments))

    def _refused(self, judged: Judged, moments: Moments) -> str:
        """Which of the limits of the steady motion the motor does not keep; empty: none."""
        rated, reserve = judged.motor.nominal_moment, self.wish.reserve
        if kept(judged.heating, reserve) is False:
            text = "it overheats: the rms moment of {rms:.4g} N*m is {part:.3g} of the rated {rated:.4g} N*m"
            if reserve:
                text = (
                    "it overheats: the rms moment of {rms:.4g} N*m is {part:.3g} of the rated {rated:.4g} N*m with "
                    "{reserve:.3g}% in reserve"
                )
            return Phrase(text, rms=moments.rms, part=judged.heating, rated=rated, reserve=100 * reserve)
        if judged.largest is None and self.overload:
            return "its overload ratio is not known"
        if kept(judged.largest) is False:
            return Phrase(
                "overload: {largest:.4g} N*m are asked of it, its break-down moment is {most:.4g} N*m",
                largest=moments.largest,
                most=(judged.motor.overload or 0.0) * rated,
            )
        return ""

    def _moments(self, motor: Motor, ratio: float) -> Moments:
        """Raises `NoSolutionError` where the machine stalls with the motor."""
        cycle, moved = self.reduction.cycle, self._driver(motor, ratio)
        if self.task.motion.positional:  # its moment is taken as constant
            mean = self.power.mean_moment / (ratio * moved.efficiency)
            return Moments(mean, mean)
        regime = self.regime(motor, ratio)
        if regime is None:  # nothing carries the machine on: the motor follows the load
            moment = -cycle.moment / ratio
            moment = moment * np.where(moment > 0, 1 / moved.efficiency, moved.efficiency)
            heat = float(cycle.panels.total(moment * moment)) / cycle.period
            return Moments(heat**0.5, cycle.panels.extremes(moment)[1][0])
        from tmmcalc.machine.motorside import motor_side

        side = motor_side(regime, moved)
        return Moments(side.rms_moment, side.largest)

    def regime(self, motor: Motor, ratio: float) -> Regime | None:
        """The steady motion with a motor; None where no inertia bounds the speed.

        Raises `NoSolutionError` where the machine stalls.
        """
        from tmmcalc.machine.steady import driven

        upstream, moved = self._upstream(motor, ratio), self._driver(motor, ratio)
        self.wheels[motor] = self._wheel(upstream, moved)
        total = constant_inertia(upstream, self.task.motion, self.wheels[motor]).total
        if vanishing(self.reduction.cycle, total) is not None:
            return None
        return driven(self.reduction.cycle, total, moved.characteristic, time_constant=moved.time_constant)

    def _driver(self, motor: Motor, ratio: float) -> Driver:
        moved = driver(self._upstream(motor, ratio), self.wish, replace(self.task.motion, positional=False))
        assert moved is not None
        return moved

    def _upstream(self, motor: Motor, ratio: float) -> dict[str, Any]:
        """What later stages read of the machine with this motor."""
        lagging = with_lag(motor, self.wish.time_constant)
        duty = duty_of(self.power, lagging, ratio, (), True)
        return {"power": replace(self.power, duty=duty), "reduction": self.reduction}

    def _wheel(self, upstream: Mapping[str, Any], moved: Driver) -> float:
        """Inertia at the input shaft of the flywheel that is there, or that the asked unevenness needs [kg*m^2]."""
        wheel = self.task.wheel
        if wheel is None or wheel.inertia or wheel.delta is None or self.task.motion.positional:
            return flywheel_inertia(upstream, wheel)
        from tmmcalc.machine.flywheel.required import required_inertia

        at_hand = constant_inertia(upstream, self.task.motion).total
        lag = moved.time_constant
        return required_inertia(
            self.reduction.cycle, moved.characteristic, wheel.delta, at_hand, lag, probes=0, remarked=False
        ).addition

    def _start(self, motor: Motor, ratio: float) -> str:
        """Why a start that is asked for does not succeed; empty: all do."""
        from tmmcalc.machine.stages.transient import machine_of
        from tmmcalc.machine.transient.methods import Method
        from tmmcalc.machine.transient.simulate import simulate
        from tmmcalc.machine.transient.solve import beginning

        upstream, task = self._upstream(motor, ratio), self.task
        wheel = self._placed(task.wheel, self.wheels.get(motor, 0.0), ratio)
        given = (task.starts, task.shafts, self.wish, task.motion, wheel, None)
        machine = machine_of(given, upstream)
        for start, (drive, scenario) in zip(
            task.starts, beginning(machine, task.starts, self.reduction.cycle.speed), strict=True
        ):
            found = simulate(drive, scenario, self._method(start, Method(compared=False)))
            end, last = float(found.t[-1]), float(found.omega[0, -1])
            curve = drive.characteristic
            if found.end == "stall":
                return Phrase("{name}: it stalls at t = {end:.3g} s", name=start.scenario.name, end=end)
            late = curve is not None and curve.critical is not None and last < curve.critical
            if late and found.end in ("time", "steady") and scenario.motor_on(end):
                text = "{name}: at its end, t = {end:.3g} s, it has not come past its break-down speed"
                return Phrase(text, name=start.scenario.name, end=end)
        return ""

    def _method(self, start: TransientTask, usual: Any) -> Any:
        """The method of the scenario, its error guessed: a trial tells whether it starts, not how exactly."""
        return usual if start.method.name == "auto" else replace(start.method, compared=False)

    def _placed(self, wheel: FlywheelTask | None, inertia: float, ratio: float) -> FlywheelTask | None:
        """The flywheel as one that is there."""
        if wheel is None or wheel.inertia:
            return wheel
        turned = (ratio if wheel.shaft == "motor" else wheel.ratio) or 1.0
        return replace(wheel, inertia=inertia / turned**2)


def judge_motor(power: Power, reduction: Reduction, wish: MotorChoice, task: TrialTask, motor: Motor) -> Judged:
    """One motor in the machine; what speaks against it is its reason."""
    trials = Trials(power, reduction, wish, task)
    trials.against(motor, power.line.ratio)
    return trials.done[motor]


class ChosenMotor:
    """The least motor that does what is asked of it; raises `NoSolutionError` if none does."""

    def __init__(self, power: Power, reduction: Reduction, wish: MotorChoice, task: TrialTask) -> None:
        from tmmcalc.machine.motors.catalogue import load_catalogue

        self._trials, self._catalogue = Trials(power, reduction, wish, task), wish.catalogue or load_catalogue()
        self._trials.overload = any(motor.overload is not None for motor in self._catalogue)
        self._choice = chosen_motor(
            power,
            self._catalogue,
            reduction.cycle.speed,
            power.line.ratio,
            wish.synchronous,
            wish.reserve,
            self._trials.against,
        )
        self.motor = self._choice.motor

    def told(self) -> MotorFound:
        """The motor with what came of the others, and what each rule of choice would take."""
        trials, choice, reserve = self._trials, self._choice, self._trials.wish.reserve
        ratio, required = trials.power.line.ratio, trials.power.motor_power or 0.0
        for motor in choice.fit:
            if motor.power > BEYOND * self.motor.power or decided(trials.done.values(), reserve):
                break
            trials.moved(motor, ratio)
        for motor in choice.fit if trials.task.starts else ():
            if trials.started(motor, ratio).starts:
                break
        against = {each.motor: each.reason for each in choice.refused}
        smaller = sorted(
            (motor for motor in self._catalogue if motor.power <= self.motor.power),
            key=lambda motor: (motor.power, motor not in against),
        )
        judged = tuple(
            replace(trials.done.get(motor, Judged(motor, None, required / motor.power)), reason=against.get(motor, ""))
            for motor in smaller
        )
        return MotorFound(self.motor, choice.reasons, judged, taken(tuple(trials.done.values()), reserve))
