"""What a run shows about the drive, in sentences with numbers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.verdicts import SLACK, Verdict

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic
    from tmmcalc.machine.transient.equations import System
    from tmmcalc.machine.transient.model import Drive
    from tmmcalc.machine.transient.outcome import Curves
    from tmmcalc.machine.transient.profile import Profile
    from tmmcalc.machine.transient.results import End, Event
    from tmmcalc.machine.transient.scenario import Scenario

UNBALANCED = 1e-5  # imbalance of energy that is worth a warning
EARLY = 0.5  # of the duration: a motion that has become steady before is told how to end sooner


def verdicts(
    scenario: Scenario,
    system: System,
    curves: Curves,
    events: list[Event],
    end: End,
    imbalance: float,
    notes: tuple[str, ...],
    drive: Drive,
    shape: Profile,
) -> tuple[Verdict, ...]:
    """Stall, turning back, speeds not reached, overload, pull-out, range and heating of the motor, quiet loads, energy.

    Warnings come first.
    """
    found = [_stall(scenario, system, curves)] if _stalled(scenario, system, curves, end) else []
    found += _ran_away(scenario, curves, drive, end)
    found += _missed(scenario, curves, events, end)
    for kind in ("overload", "pull-out"):
        first = next((event for event in events if event.kind == kind), None)
        if first:
            found.append(_slow(first, scenario, curves))
    found += _turned_back(scenario, system, events, drive)
    found += _pulls_back(scenario, system, curves, end)
    found += _crawls(scenario, curves, drive, end)
    found += _extrapolated(scenario, curves, drive, rated_moment(drive.characteristic))
    found += _without_quiet(scenario, shape, events)
    found += _heating(curves, drive)
    found += _length(scenario, curves, events, end)
    if imbalance > UNBALANCED:
        text = (
            "energy and work differ by {imbalance:.2g} of the energy turned over: take smaller steps, or step control"
        )
        said = Phrase(text, imbalance=imbalance)
        found.append(Verdict("warning", said, imbalance, UNBALANCED, name="imbalance"))
    factors = sorted({float(u) for u in curves.load_factor} - {0.0, 1.0})
    if drive.back is not None and drive.idle is not drive.cycle and factors:
        text = (
            "friction at the load factor {factors} is taken on the straight line through the friction without load and "
            "with it, which is an approximation"
        )
        found.append(Verdict("note", Phrase(text, factors=[f"{u:g}" for u in factors])))
    found += [Verdict("note", note) for note in notes]
    return tuple(sorted(found, key=lambda verdict: verdict.severity == "note"))


def rated_moment(motor: Characteristic | None) -> float | None:
    """Moment of a motor at its rated speed [N*m], if that is known."""
    return None if motor is None or motor.nominal is None else float(motor.moment(motor.nominal))


def rms(t: Values, moment: Values) -> float:
    """Root mean square over the time by the trapezoid rule; of a motion that has not begun its size."""
    time = float(t[-1] - t[0])
    square = moment**2
    return math.sqrt(float(((square[1:] + square[:-1]) / 2 * np.diff(t)).sum() / time) if time else float(square[0]))


def _ran_away(scenario: Scenario, curves: Curves, drive: Drive, end: End) -> list[Verdict]:
    """What drives a crank that passes every speed of the drive."""
    if end != "runaway":
        return []
    t, speed = float(curves.t[-1]), float(curves.omega[-1, -1])
    powered = drive.characteristic is not None and scenario.motor_on(t)
    if powered:
        text = (
            "the machine runs away: motor and loads drive it faster and faster, after {t:.5g} s it has {speed:.6g} "
            "rad/s; is the sign of a load wrong? If not, add what resists, or give the duration that is of interest"
        )
    else:
        text = (
            "the machine runs away: without a motor its loads drive it faster and faster, after {t:.5g} s it has "
            "{speed:.6g} rad/s; is the sign of a load wrong? If not, add what resists, or give the duration that is of "
            "interest"
        )
    return [Verdict("warning", Phrase(text, t=t, speed=speed))]


def _turned_back(scenario: Scenario, system: System, events: list[Event], drive: Drive) -> list[Verdict]:
    """The crank driven backwards: against a motor that is on, or with friction turned round."""
    first = next((event for event in events if event.kind == "reversal"), None)
    if first is None:
        return []
    at = Phrase(
        "the crank turns back at t = {time:.5g} s, crank angle {angle:.5g} deg",
        time=first.time,
        angle=math.degrees(first.angle) % 360,
    )
    found = []
    if system.moment is not None and scenario.motor_on(first.time):
        static = system.moment(0.0)
        if static > 0:
            text = (
                "{at}: the load drives it against the {static:.5g} N*m of the motor at standstill: a stronger motor, a "
                "larger ratio, or a brake"
            )
            found.append(Verdict("warning", Phrase(text, at=at, static=static)))
    if not found:
        if drive.back is not None:
            at = Phrase("{at}; friction of the pairs is that of the crank turning back", at=at)
        found.append(Verdict("note", at))
    return found


def _pulls_back(scenario: Scenario, system: System, curves: Curves, end: End) -> list[Verdict]:
    """A braking motor that would turn the crank back from the rest to which it has brought it."""
    static = system.moment(0.0) if system.moment and scenario.motor_on(float(curves.t[-1])) else 0.0
    if end != "standstill" or static >= 0:
        return []
    text = (
        "at rest the motor still pulls back with {static:.5g} N*m at the crank: it is to be switched off there; "
        'standstill = "pass" shows the crank turn back'
    )
    return [Verdict("note", Phrase(text, static=-static))]


def _crawls(scenario: Scenario, curves: Curves, drive: Drive, end: End) -> list[Verdict]:
    """A motor that is left on below the speed of its largest moment."""
    motor, last = drive.characteristic, float(curves.omega[0, -1])
    if motor is None or motor.critical is None or end not in ("time", "steady"):
        return []
    late = curves.t >= (curves.t[0] + curves.t[-1]) / 2
    fastest = float(curves.omega[0, late].max())
    if not scenario.motor_on(float(curves.t[-1])) or last <= 0 or fastest >= motor.critical:
        return []
    text = Phrase(
        "the motor, at {last:.6g} rad/s, has not come past its break-down speed {critical:.6g} rad/s: the start takes "
        "longer than this, or the load is too large for it",
        last=last,
        critical=motor.critical,
    )
    return [Verdict("warning", text, last, motor.critical, "rad/s", "omega")]


def _heating(curves: Curves, drive: Drive) -> list[Verdict]:
    """The root mean square of the motor's moment against the rated one."""
    rated, time = rated_moment(drive.characteristic), float(curves.t[-1] - curves.t[0])
    mean = rms(curves.t, curves.motor_moment)
    if rated is None or rated <= 0 or mean <= rated * (1 + SLACK) or not time:
        return []
    pause = time * ((mean / rated) ** 2 - 1)
    text = Phrase(
        "heating: the root mean square of the motor's moment {mean:.5g} N*m over {time:.4g} s exceeds the rated "
        "{rated:.5g} N*m: repeated, this motion needs pauses of {pause:.3g} s without current, or a stronger motor",
        mean=mean,
        time=time,
        rated=rated,
        pause=pause,
    )
    return [Verdict("warning", text, mean, rated, "N*m", "M_motor_rms")]


def _length(scenario: Scenario, curves: Curves, events: list[Event], end: End) -> list[Verdict]:
    """A duration that is much too long, or none that ended the motion."""
    steady = next((event for event in reversed(events) if event.kind == "steady"), None)
    if end == "time" and scenario.until_steady:
        text = (
            "after {t:g} s the motion does not repeat itself yet, and is ended: give the duration that is of interest"
        )
        return [Verdict("warning", Phrase(text, t=curves.t[-1]))]
    if end == "time" and steady and steady.time < EARLY * scenario.duration:
        text = "the motion repeats itself from t = {time:.4g} s on: without a duration the run ends there"
        return [Verdict("note", Phrase(text, time=steady.time))]
    return []


def _missed(scenario: Scenario, curves: Curves, events: list[Event], end: End) -> list[Verdict]:
    """Speeds that were asked for and not reached."""
    if end == "speed":
        return []
    reached = [event.speed for event in events if event.kind == "target"]
    text = "the crank does not reach {speed:.6g} rad/s: after {t:.4g} s it has {omega:.6g} rad/s"
    asked = [*scenario.targets] if scenario.end_speed is None else [scenario.end_speed, *scenario.targets]
    return [
        Verdict(
            "warning" if speed == scenario.end_speed else "note",
            Phrase(text, speed=speed, t=curves.t[-1], omega=curves.omega[-1, -1]),
            *(float(curves.omega[-1, -1]), speed, "rad/s", "omega"),
        )
        for speed in asked
        if not any(math.isclose(speed, seen) for seen in reached)
    ]


def _stalled(scenario: Scenario, system: System, curves: Curves, end: End) -> bool:
    """Whether the motor is on and the crank at rest; on an elastic shaft it may have been so for a while."""
    driven = system.moment is not None and scenario.motor_on(float(curves.t[-1]))
    return end == "stall" or (end == "time" and driven and curves.omega[-1, -1] == 0 and not _starts(system, curves))


def _starts(system: System, curves: Curves) -> bool:
    """Whether the motor's moment at standstill would move the crank, so that a shaft or its lag only takes time."""
    return system.moment is not None and system.moment(0.0) + float(curves.load_moment[-1]) > 0


def _stall(scenario: Scenario, system: System, curves: Curves) -> Verdict:
    """The moments at the standstill, on the crank's shaft."""
    static = system.moment(0.0) if system.moment else 0.0
    braked = scenario.brake_on(float(curves.t[-1])) and system.grip > 0
    asked = (system.grip if braked else 0.0) - curves.load_moment[-1]
    began = "the motor stalls" if curves.omega[-1].any() else "the motor cannot start"
    text = (
        "{began} at the crank angle {theta:.5g} deg: at standstill it gives {static:.5g} N*m at the crank, the load "
        "asks for {asked:.5g} N*m: a larger starting moment, a larger ratio, more inertia, or a start without load"
    )
    if braked:
        text = (
            "{began} at the crank angle {theta:.5g} deg: at standstill it gives {static:.5g} N*m at the crank, "
            "load and "
            "brake ask for {asked:.5g} N*m: a larger starting moment, a larger ratio, more inertia, or a start without "
            "load"
        )
    return Verdict(
        "warning",
        Phrase(text, began=began, theta=math.degrees(curves.theta[-1, -1]) % 360, static=static, asked=asked),
    )


def _slow(event: Event, scenario: Scenario, curves: Curves) -> Verdict:
    driven = [event.time <= t and scenario.motor_on(t) for t in curves.t.tolist()]
    speeds = curves.omega[0, driven]
    text = Phrase(
        "{kind} at t = {time:.5g} s, crank angle {angle:.4g} deg: {message}",
        kind=event.kind,
        time=event.time,
        angle=math.degrees(event.angle) % 360,
        message=event.message,
    )
    if len(speeds):
        lowest = float(np.min(speeds))
        text = Phrase("{text}; its lowest speed afterwards is {lowest:.6g} rad/s", text=text, lowest=lowest)
    return Verdict("warning" if event.kind == "pull-out" else "note", text)


def _extrapolated(scenario: Scenario, curves: Curves, drive: Drive, rated: float | None) -> list[Verdict]:
    """A motor taken below the lowest speed that its formula holds at: by how far, how long, and what it gives there."""
    motor = drive.characteristic
    if motor is None or motor.least is None:
        return []
    on = np.zeros(len(curves.t), dtype=bool)
    for begin, end in scenario.motor:
        on |= (begin <= curves.t) & (curves.t <= end)
    slow = on & (curves.omega[0] < motor.least - SLACK * abs(motor.least))
    if not slow.any():
        return []
    lowest, largest = float(curves.omega[0, slow].min()), float(curves.motor_moment[slow].max())
    time = float(np.diff(curves.t)[slow[:-1]].sum())
    whole = 'with overload an induction motor takes its whole curve (Kloss); of a shunt motor characteristic = "shunt"'
    remedy = "give points for these speeds" if motor.name == "table" else whole
    if rated:
        text = (
            "the {characteristic} holds from {least:.6g} rad/s up, the speed is as low as {lowest:.6g} rad/s; "
            "below, for {time:.4g} s, it is extrapolated to {largest:.5g} N*m, {times:.3g} times the rated: these "
            "times "
            "and moments are no prediction; {remedy}"
        )
    else:
        text = (
            "the {characteristic} holds from {least:.6g} rad/s up, the speed is as low as {lowest:.6g} rad/s; "
            "below, for {time:.4g} s, it is extrapolated to {largest:.5g} N*m: these times and moments are no "
            "prediction; {remedy}"
        )
    said = Phrase(
        text,
        characteristic=f"{motor.name} characteristic",
        least=motor.least,
        lowest=lowest,
        time=time,
        largest=largest,
        times=largest / rated if rated else 0.0,
        remedy=remedy,
    )
    return [Verdict("warning", said, lowest, motor.least, "rad/s", "omega")]


def _without_quiet(scenario: Scenario, shape: Profile, events: list[Event]) -> list[Verdict]:
    """Load steps that were to wait for a part of the cycle without load, where there is none."""
    steps = scenario.load[1:]
    if any(shape.unloaded) or not any(step.quiet for step in steps):
        return []
    taken = [event for event in events if event.kind == "load"]
    found = []
    for k, step in enumerate(steps):
        if step.quiet:
            at = "as soon as it is due"
            if k < len(taken):
                at = Phrase("at {angle:.5g} deg", angle=math.degrees(taken[k].angle) % 360)
            text = (
                "the load factor {factor:g} does not wait (quiet): no part of the cycle is without load; it is applied "
                "{at}: give the load a window, or leave quiet out"
            )
            found.append(Verdict("warning", Phrase(text, factor=step.factor, at=at)))
    return found
