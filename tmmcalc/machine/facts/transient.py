"""The documents of the transient stage: of every motion how it ended, its events, moments, energy, and its course.

Angles and speeds are those of the crank, moments of the motor and of the shafts those on their own shafts. The rows of
the table are the steps of the method; largest values are those of the motion between them too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import Quantity, keyed
from tmmcalc.machine.facts.timed import TURNS, course, events_view, whole_table, within
from tmmcalc.machine.facts.timescales import scales_fact
from tmmcalc.machine.transient.columns import SHAFT
from tmmcalc.machine.transient.results import End, Event
from tmmcalc.machine.transient.timed import TURN, TimedMotion, TimedMotions
from tmmcalc.machine.transient.verdicts import rms
from tmmcalc.machine.verdicts import SLACK
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number

NOTHING = 1e-9  # of the largest moment or energy: less is none
ENDS: dict[End, str] = {
    "time": "its time is up",
    "speed": "it has reached the speed asked for",
    "angle": "it has turned by the angle asked for",
    "standstill": "it stands still for good",
    "stall": "the motor stalls",
    "steady": "it repeats itself from cycle to cycle",
    "runaway": "it runs away, faster and faster",
}

LARGEST_SPEED = Quantity("omega_largest[rad/s]", "largest speed of the crank, between the rows too")
LARGEST_SPEED_AT = Quantity("omega_largest_at_t[s]", "time of the largest speed of the crank")
SWING_LOW = Quantity("swing_low[rad/s]", "least speed in the last turn under the motor")
SWING_HIGH = Quantity("swing_high[rad/s]", "largest speed in the last turn under the motor")
SWING_DELTA = Quantity("swing_delta", "coefficient of speed fluctuation in the last turn under the motor")
MOTOR_RMS = Quantity("M_motor_rms[N*m]", "root mean square of the motor's moment over the time")
MOTOR_OVER_RATED = Quantity("M_motor_rms_over_rated", "rms moment of the motor over its rated moment")
LARGEST = Quantity("{moment}_largest[N*m]", "largest moment {moment} of the shaft, between the rows too")
LARGEST_AT = Quantity("{moment}_largest_at_t[s]", "time of the largest moment {moment} of the shaft")
MEAN = Quantity("{moment}_mean[N*m]", "mean moment {moment} of the shaft over the time")
RIGID = Quantity("{moment}_rigid[N*m]", "largest moment {moment} if all shafts were rigid")
FACTOR = Quantity("{moment}_dynamic_factor", "largest moment {moment} over that with rigid shafts")
WORK = Quantity("work_{cause}[J]", "work of {cause}")


def summary(result: TimedMotions, title: str) -> Document:
    """Facts, notes and events of every motion; of several motions each is a part."""
    parts = tuple(_motion_document(motion) for motion in result.motions)
    return replace(parts[0], title=title) if len(parts) == 1 else Document(title, parts=parts)


def document(
    result: TimedMotions,
    title: str,
    *,
    patterns: Sequence[str] = (),
    everything: bool = False,
    where: str = "",
) -> Document:
    """The summary, and of every motion a short table of its course.

    ``patterns`` choose columns by name, header or wildcard. ``everything`` (for csv, json, toml) gives all rows of all
    motions in one table instead, with the motion as its first column. ``where`` is the file that has them all.
    """
    if everything:
        return replace(summary(result, title), table=whole_table(result, patterns))
    parts = tuple(
        replace(_motion_document(motion), parts=(course(motion, patterns, where),)) for motion in result.motions
    )
    return replace(parts[0], title=title) if len(parts) == 1 else Document(title, parts=parts)


def _motion_document(motion: TimedMotion) -> Document:
    """Facts, verdicts and the table of events of one motion."""
    facts = (
        _method_fact(motion),
        scales_fact(motion.scales),
        _end_fact(motion),
        *_target_facts(motion),
        _speed_fact(motion),
        *_swing_facts(motion),
        *_motor_facts(motion),
        *(_shaft_fact(motion, k) for k in range(len(motion.masses) - 1)),
        *_energy_facts(motion),
        _error_fact(motion),
        *_event_facts(motion.events),
    )
    return Document(motion.name, facts, tuple(map(str, motion.verdicts)), events_view(motion.events))


def _error_fact(motion: TimedMotion) -> Fact:
    """The estimated errors of the speeds and of the largest moments."""
    text = f"{motion.error:.0e} of the speeds, {motion.extremes_error:.0e} of the largest moments (relative)"
    return Fact("error in time (est.)", text, {"error": {"speed": motion.error, "extremes": motion.extremes_error}})


def _method_fact(motion: TimedMotion) -> Fact:
    """The method that ran, why, and what it took."""
    count = motion.counters
    text = f"{motion.method}: {motion.reason}"
    text += f"\n{count['steps']} steps, {count['rejected']} rejected, {count['evaluations']} evaluations"
    return Fact("integrated by", text, keyed(motion, "method", "reason", "counters"))


def _end_fact(motion: TimedMotion) -> Fact:
    """What ended the motion, when, where, and how fast the crank still was."""
    lines = (
        f"at t = {number(motion.end_time)} s: {ENDS[motion.end]}",
        f"after {number(motion.turns, 5)} turns, at {_rpm(motion.end_speed)}",
        f"crank at {number(within(float(motion.theta[-1, -1])), 5)} deg",
    )
    values = keyed(motion, "end", "end_time", "end_angle", "end_speed", "turns")
    return Fact("ends", "\n".join(lines), values)


def _rpm(speed: float) -> str:
    return f"{number(speed, 6)} rad/s ({number(speed * 30 / math.pi, 5)} rpm)" if speed else "0 rad/s"


def _target_facts(motion: TimedMotion) -> list[Fact]:
    """How long the speeds that were asked for took."""
    found = sorted((event.speed, event) for event in motion.events if event.kind == "target")
    if not found:
        return []
    began = float(motion.theta[-1, 0])
    lines = [
        f"{_rpm(speed)} after {number(event.time)} s, {number((event.angle - began) / TURN, 4)} turns"
        for speed, event in found
    ]
    reached = [{**keyed(event, "speed", "time"), **TURNS.value((event.angle - began) / TURN)} for _, event in found]
    return [Fact("reaches", "\n".join(lines), {"reached": reached})]


def _speed_fact(motion: TimedMotion) -> Fact:
    """Speed of the crank at the beginning, and its largest one."""
    first = motion.begin_speed
    speeds = np.concatenate((motion.omega[-1], motion.turning[2]))
    times = np.concatenate((motion.t, motion.turning[0]))
    k = int(np.argmax(speeds))
    largest, at = float(speeds[k]), float(times[k])
    text = f"at first {_rpm(first)}"
    if at > motion.t[0]:
        text += f"\nlargest {_rpm(largest)} at t = {number(at, 5)} s"
    values = {**keyed(motion, "begin_speed"), **LARGEST_SPEED.value(largest), **LARGEST_SPEED_AT.value(at)}
    return Fact("speed of the crank", text, values)


def _swing_facts(motion: TimedMotion) -> list[Fact]:
    """Between which extremes the speed swings in the last turn under the motor, and their unevenness."""
    late = motion.turning[1] > motion.theta[-1, -1] - TURN
    speeds = motion.turning[2, late]
    if len(speeds) < 2 or not motion.motor_moment[-1]:
        return []
    low, high = float(speeds.min()), float(speeds.max())
    text = f"between {number(low)} and {number(high)} rad/s"
    values = SWING_LOW.value(low) | SWING_HIGH.value(high)
    if low > 0:
        delta = 2 * (high - low) / (high + low)
        text += f", delta = {number(delta, 4)}"
        values |= SWING_DELTA.value(delta)
    return [Fact("in the last turn", text, values)]


def mean_of(t: Values, values: Values) -> float:
    """Mean over the time by the trapezoid rule; of a motion that has not begun its value."""
    time = float(t[-1] - t[0])
    return float(((values[1:] + values[:-1]) / 2 * np.diff(t)).sum() / time) if time else float(values[0])


def _motor_facts(motion: TimedMotion) -> list[Fact]:
    """The motor's largest moment, and the root mean square that its heating goes with."""
    largest, at = motion.largest_motor, motion.largest_motor_at
    if not largest:
        return []
    mean, rated = rms(motion.t, motion.motor_moment), motion.rated_moment
    text = f"largest {number(largest)} N*m at t = {number(at, 5)} s"
    text += f"\nrms over the time {number(mean, 4)} N*m, whose square heats it"
    values = {**keyed(motion, "largest_motor", "largest_motor_at"), **MOTOR_RMS.value(mean)}
    if rated is not None and rated > 0:
        kept = "does not exceed" if mean <= rated * (1 + SLACK) else "exceeds"
        text += f"\n{number(mean / rated, 4)} times the rated {number(rated, 4)} N*m: {kept} it"
        values |= {**keyed(motion, "rated_moment"), **MOTOR_OVER_RATED.value(mean / rated)}
    return [Fact("moment of the motor", text, values)]


def _shaft_fact(motion: TimedMotion, k: int) -> Fact:
    """The largest moment of a shaft, and how many times that of the same motion with rigid shafts it is."""
    name, moment = SHAFT.of(before=k + 1, after=k + 2).name, motion.shaft_moment[k]
    largest, at = motion.largest_moment[:, k].tolist()
    mean = mean_of(motion.t, moment)
    text = f"{motion.masses[k]} to {motion.masses[k + 1]}"
    if k in motion.rigid:
        text += ", taken as rigid"
    text += f"\nlargest {number(largest)} N*m at t = {number(at, 5)} s"
    text += f"\nmean over the time {number(mean, 4, abs(largest))} N*m"
    found = zip((LARGEST, LARGEST_AT, MEAN), (largest, at, mean), strict=True)
    values = {told.of(moment=name).key: value for told, value in found}
    rigid = motion.rigid_moment[k] if motion.rigid_moment else 0.0
    if rigid > NOTHING * abs(largest):
        factor = abs(largest) / rigid
        text += f"\nif all shafts were rigid {number(rigid)} N*m: dynamic factor {number(factor, 4)}"
        values |= {**RIGID.of(moment=name).value(rigid), **FACTOR.of(moment=name).value(factor)}
    return Fact(Phrase("shaft {name}", name=name), text, values)


def _energy_facts(motion: TimedMotion) -> list[Fact]:
    """Where the energy comes from and goes to, and what of it the balance lacks."""
    causes = {
        "motor": motion.motor_work,
        "load": motion.load_work,
        "brake": motion.brake_work,
        "shafts": motion.shaft_loss,
    }
    works = {name: float(work[-1]) for name, work in causes.items()}
    begin, end = motion.begin_energy, motion.end_energy
    peak = max(begin, end, *map(abs, works.values()))
    parts = [f"{name} {number(work, 5)} J" for name, work in works.items() if abs(work) > NOTHING * peak]
    lines = (
        f"energy from {number(begin, 5, peak)} J to {number(end, 5, peak)} J",
        f"work: {', '.join(parts) or 'none'}",
        f"the balance is open by {motion.imbalance:.0e} of the largest" if motion.imbalance else "the balance is exact",
    )
    values = {
        **keyed(motion, "begin_energy", "end_energy"),
        **{WORK.of(cause=name).key: work for name, work in works.items()},
        "residual": {"energy": motion.imbalance},
    }
    return [Fact("energy and work", "\n".join(lines), values)]


def _event_facts(events: Sequence[Event]) -> list[Fact]:
    """All events for programs, how many there are for people."""
    found = [keyed(event, "kind", "time", "angle[deg]", "speed", "message") for event in events]
    if not found:
        return [Fact("events", "none")]
    text = "in the table, with the crank's turns and its angle"
    return [Fact("events", text, {"events": found})]
