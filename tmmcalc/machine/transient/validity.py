"""Where a run went beyond what its data hold for: the range of the motor's formula, a quiet part that is not there."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.machine.verdicts import SLACK, Verdict

if TYPE_CHECKING:
    from tmmcalc.machine.transient.model import Drive
    from tmmcalc.machine.transient.outcome import Curves
    from tmmcalc.machine.transient.profile import Profile
    from tmmcalc.machine.transient.results import Event
    from tmmcalc.machine.transient.scenario import Scenario


def extrapolated(scenario: Scenario, curves: Curves, drive: Drive, rated: float | None) -> list[Verdict]:
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
    times = f", {largest / rated:.3g} times the rated" if rated else ""
    whole = 'with overload an induction motor takes its whole curve (Kloss); of a shunt motor characteristic = "shunt"'
    remedy = "give points for these speeds" if motor.name == "table" else whole
    text = f"the {motor.name} characteristic holds from {motor.least:.6g} rad/s up, the speed is as low as {lowest:.6g}"
    more = f"below, for {time:.4g} s, it is extrapolated to {largest:.5g} N*m{times}: these times and moments are no"
    return [Verdict("warning", f"{text} rad/s; {more} prediction; {remedy}")]


def restless(scenario: Scenario, shape: Profile, events: list[Event]) -> list[Verdict]:
    """Load steps that were to wait for a part of the cycle without load, where there is none."""
    steps = scenario.load[1:]
    if any(shape.unloaded) or not any(step.quiet for step in steps):
        return []
    taken = [event for event in events if event.kind == "load"]
    found = []
    for k, step in enumerate(steps):
        if step.quiet:
            at = f"at {math.degrees(taken[k].angle) % 360:.5g} deg" if k < len(taken) else "as soon as it is due"
            text = f"the load factor {step.factor:g} does not wait (quiet): no part of the cycle is without load; it is"
            remedy = "give the load a window, or leave quiet out"
            found.append(Verdict("warning", f"{text} applied {at}: {remedy}"))
    return found
