"""What a run shows about the drive, in sentences with numbers."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.machine.transient.equations import System
from tmmcalc.machine.transient.outcome import Curves
from tmmcalc.machine.transient.results import End, Event
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.verdicts import Verdict

UNBALANCED = 1e-5  # imbalance of energy that is worth a warning


def verdicts(
    scenario: Scenario,
    system: System,
    curves: Curves,
    events: list[Event],
    end: End,
    imbalance: float,
    notes: tuple[str, ...],
) -> tuple[Verdict, ...]:
    """Stall, speeds not reached, overload and pull-out of the motor, energy that does not balance; warnings first."""
    found = [_stall(scenario, system, curves)] if _stalled(scenario, system, curves, end) else []
    found += _missed(scenario, curves, events, end)
    for kind in ("overload", "pull-out"):
        first = next((event for event in events if event.kind == kind), None)
        if first:
            found.append(_slow(first, scenario, curves))
    if np.min(curves.omega[-1]) < 0 and np.any(curves.load_moment):
        text = "the crank turns backwards, where friction and quadratic resistances of the mechanism keep the sense"
        found.append(Verdict("warning", f"{text} that they have forwards: with such the motion after it is not right"))
    if imbalance > UNBALANCED:
        text = f"energy and work differ by {imbalance:.2g} of the energy turned over"
        found.append(Verdict("warning", f"{text}: take smaller steps, or step control"))
    found += [Verdict("note", note) for note in notes]
    return tuple(sorted(found, key=lambda verdict: verdict.severity == "note"))


def _missed(scenario: Scenario, curves: Curves, events: list[Event], end: End) -> list[Verdict]:
    """Speeds that were asked for and not reached."""
    if end == "speed":
        return []
    reached = [event.speed for event in events if event.kind == "target"]
    last = f"after {curves.t[-1]:.4g} s it has {curves.omega[-1, -1]:.6g} rad/s"
    asked = [*scenario.targets] if scenario.end_speed is None else [scenario.end_speed, *scenario.targets]
    return [
        Verdict(
            "warning" if speed == scenario.end_speed else "note", f"the crank does not reach {speed:.6g} rad/s: {last}"
        )
        for speed in asked
        if not any(math.isclose(speed, seen) for seen in reached)
    ]


def _stalled(scenario: Scenario, system: System, curves: Curves, end: End) -> bool:
    """Whether the motor is on and the crank at rest; on an elastic shaft it may have been so for a while."""
    driven = system.moment is not None and scenario.motor_on(float(curves.t[-1]))
    return end == "stall" or (end == "time" and driven and curves.omega[-1, -1] == 0)


def _stall(scenario: Scenario, system: System, curves: Curves) -> Verdict:
    """The moments at the standstill, on the crank's shaft."""
    static = system.moment(0.0) if system.moment else 0.0
    braked = scenario.brake_on(float(curves.t[-1])) and system.grip > 0
    asked = (system.grip if braked else 0.0) - curves.load_moment[-1]
    began = "the motor stalls" if curves.omega[-1].any() else "the motor cannot start"
    return Verdict(
        "warning",
        f"{began} at the crank angle {math.degrees(curves.theta[-1, -1]) % 360:.5g} deg: at standstill it gives "
        f"{static:.5g} N*m at the crank, {'load and brake ask' if braked else 'the load asks'} for {asked:.5g} N*m: "
        "a larger starting moment, a larger ratio, more inertia, or a start without load",
    )


def _slow(event: Event, scenario: Scenario, curves: Curves) -> Verdict:
    driven = [event.time <= t and scenario.motor_on(t) for t in curves.t.tolist()]
    speeds = curves.omega[0, driven]
    lowest = f"; its lowest speed afterwards is {float(np.min(speeds)):.6g} rad/s" if len(speeds) else ""
    return Verdict(
        "warning" if event.kind == "pull-out" else "note",
        f"{event.kind} at t = {event.time:.5g} s, crank angle {math.degrees(event.angle) % 360:.4g} deg: "
        f"{event.message}{lowest}",
    )
