"""The course of a run: pieces of smooth motion between switchings, breaks of the load and events.

A run keeps a state and what is in force; each piece is integrated until a time, an angle or a speed changes
that, lands on it exactly, and hands over to the next.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.steps import Derivative, State
from tmmcalc.machine.transient.equations import Regime, System, derivative
from tmmcalc.machine.transient.events import Hit, Watch, extreme, hits, level
from tmmcalc.machine.transient.initial import Sizes
from tmmcalc.machine.transient.jacobian import jacobian
from tmmcalc.machine.transient.levels import PASSED, Limits, ends, noted_speeds, runaway_speeds, stretch_ends
from tmmcalc.machine.transient.periodicity import Periodicity
from tmmcalc.machine.transient.pointwise import Stretch, stretches
from tmmcalc.machine.transient.profile import Profiles
from tmmcalc.machine.transient.results import End, Event
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.standstill import Holder
from tmmcalc.machine.transient.steppers import Stepper

CHATTER = 100  # pieces without progress in time


class Row(NamedTuple):
    """One row of the result."""

    t: float
    y: State
    regime: Regime
    error: State | None


class Run:
    """A run in progress."""

    def __init__(
        self,
        system: System,
        ways: Profiles,
        scenario: Scenario,
        stepper: Stepper,
        limits: Limits,
        size: Sizes,
        budget: int,
    ) -> None:
        self.system, self.ways, self.scenario = system, ways, scenario
        self.stepper, self.limits, self.budget = stepper, limits, budget
        self.rows: list[Row] = []
        self.events: list[Event] = []
        self.turning: list[tuple[float, float, float]] = []
        self.pieces = self.steps = 0
        self.holder = Holder(system, scenario, size.moment, ways)
        self._crank, self._times = system.layout.crank, scenario.times()
        self._stretches = cache(lambda factor, way: stretches(ways.of(way), factor))
        self._loads = list(scenario.load[1:])
        self._armed = self._rests = False
        self._factor = scenario.load[0].factor
        self._passed: set[tuple[str, float]] = set()
        self._repeats = Periodicity(system, size, ways.forward.period)

    def go(self, y: State, instants: Sequence[float]) -> End:
        """Run from the state ``y`` at t = 0; rows and events are left in their lists."""
        self.t, self.y = 0.0, list(y)
        self._way = math.copysign(1.0, y[self._crank])
        self._place = self.ways.of(self._way).place(y[0], self._way > 0)
        self._moved = self._way if y[self._crank] else 0.0
        self._instants = sorted(time for time in instants if time > 0)
        self._slope = 0.0
        idle = 0
        while True:
            began = self.t
            regime = self._regime()
            over = self._over(regime) or self._piece(regime)
            if over:
                return over
            idle = idle + 1 if self.t == began else 0
            if idle > CHATTER:
                raise AccuracyError(
                    f"the motion chatters about rest at t = {self.t:.9g} s, crank angle {self.y[0]:.6g} rad",
                    where=f"transient motion, scenario {self.scenario.name}",
                    value=self.t,
                    remedy="look at the moments there: a brake or a jump of the load that changes with the direction",
                )

    @property
    def counters(self) -> dict[str, int]:
        """What the run cost."""
        stepper = self.stepper
        costs = {"rejected": stepper.rejected, "evaluations": stepper.evaluations}
        return {"steps": self.steps, **costs, "pieces": self.pieces}

    def stretch(self, regime: Regime) -> Stretch:
        """The stretch of a regime."""
        return self._stretches(regime.factor, regime.way)[regime.stretch]

    def note(self, kind: str, message: str, t: float, y: State) -> None:
        """Leave an event."""
        self.events.append(Event(kind, t, y[0], y[self._crank], message))

    def _regime(self) -> Regime:
        """What is in force from now on."""
        self._switch_load()
        scenario, before = self.scenario, self.rows[-1].regime if self.rows else None
        motor = self.system.moment is not None and scenario.motor_on(self.t)
        if self.system.layout.lag and not motor:
            self.y[self.system.layout.works - 1] = 0.0
        regime = Regime(motor, scenario.brake_on(self.t), 0.0, frozenset(), self._factor, *self._place, self._way)
        regime = self.holder.resolve(regime, self.stretch, self.y)
        self._place, self._way = (regime.stretch, regime.base), regime.way
        self._note_turn(regime)
        if regime.motor and not (before and before.motor):
            self._check_pole()
        if before and before.motor != regime.motor:
            self.note(*(_ON if regime.motor else _OFF), self.t, self.y)
        if before and before.braked != regime.braked:
            self.note(*(_BRAKED if regime.braked else _FREED), self.t, self.y)
        return regime

    def _check_pole(self) -> None:
        """Raise `NoSolutionError` for a motor that is switched on where nothing limits its current."""
        speed, pole = self.y[self.system.layout.speed], self.limits.pole
        if pole is None or speed / pole < 1:
            return
        raise NoSolutionError(
            f"the motor is switched on at t = {self.t:.6g} s, where it has {speed:.6g} rad/s at the crank: its flux is "
            f"in proportion to the current, which from {pole:.6g} rad/s on has no limit",
            where=f"transient motion, scenario {self.scenario.name}",
            value=speed,
            limit=pole,
            remedy=f"more than {speed / pole:.5g} times the resistance of its circuit, another time, or the saturation "
            "of the motor",
        )

    def _note_turn(self, regime: Regime) -> None:
        """Note that the crank, at rest, turns back or stays there."""
        last = self.system.layout.groups - 1
        moves = last not in regime.held
        if self._rests and not (self.ways.sided and moves):
            self.note("standstill", "the crank comes to rest", self.t, self.y)
        self._rests = False
        if self.ways.sided and moves:
            if self._moved * regime.way < 0:
                self.note("reversal", PASSED["reversal"], self.t, self.y)
            self._moved = regime.way

    def _switch_load(self) -> None:
        """Apply the load steps whose conditions are met."""
        while self._loads:
            step = self._loads[0]
            late = step.time is None or self.t >= step.time
            fast = step.speed is None or self.y[self._crank] >= step.speed
            self._armed = self._armed or (late and fast)
            unloaded = self.ways.of(self._way).unloaded
            quiet = not step.quiet or unloaded[self._place[0]] or not any(unloaded)
            if not (self._armed and quiet):
                return
            self._armed, self._factor = False, step.factor
            self._loads.pop(0)
            self.note("load", Phrase("load factor {factor:g}", factor=step.factor), self.t, self.y)

    def _over(self, regime: Regime) -> End | None:
        """What ended the run: its time, or that nothing will ever move again."""
        if self.t >= self.scenario.duration:
            return "time"
        if self._changes() or not self.holder.forever(regime, self.stretch, self.y):
            return None
        self._row(regime, None)
        stalls = regime.motor and self._turns_at_rest()
        end: End = "stall" if stalls else "standstill"
        if not (self.events and self.events[-1].kind == end):
            reason = "the motor cannot move the crank" if stalls else "nothing moves the crank"
            self.note(end, reason, self.t, self.y)
        return end

    def _turns_at_rest(self) -> bool:
        """Whether the motor would move the crank from rest: one that only brakes stands still and does not stall."""
        moment = self.system.moment(0.0) if self.system.moment else 0.0
        return moment > 0 or (moment < 0 and self.scenario.standstill == "pass")

    def _changes(self) -> bool:
        """Whether something is to be switched at a later time."""
        return any(self.t < time < self.scenario.duration for time in self._times)

    def _piece(self, regime: Regime) -> End | None:
        """Integrate one regime to its end; what ended the run, if it did."""
        stretch, stepper = self.stretch(regime), self.stepper
        until = next(time for time in self._times if time > self.t)
        f = derivative(self.system, regime, stretch)
        stepper.begin(f, jacobian(self.system, self.ways.of(regime.way), regime, f), self.t, self.y, until)
        self.pieces += 1
        self._row(regime, None)
        if self._slope * stepper.rate[self._crank] < 0:
            self.turning.append((self.t, self.y[0], self.y[self._crank]))
        watches = self._watches(regime, stretch)
        while True:
            stepper.step()
            self.steps += 1
            halts = []
            for hit in hits(watches, stepper):
                if hit.watch.halts:
                    halts.append(hit)
                else:
                    self._pass(hit, watches)
            self._land(halts)
            self._turn(f)
            self._rows_between(regime)
            self._row(regime, stepper.error)
            self._check_budget()
            if halts:
                self._slope = f(self.t, self.y)[self._crank]
                return next((end for end in map(self._act, halts) if end), None)
            if stepper.t >= until:
                self._slope = stepper.rate[self._crank]
                return "time" if until >= self.scenario.duration else None
            if self._repeats.steady and self.scenario.until_steady and not self._changes():
                return "steady"

    def _land(self, halts: list[Hit]) -> None:
        """To the end of the step, or to the first event that halts, exactly on the levels reached."""
        last = halts[0] if halts else self.stepper
        self.t, self.y = last.t, list(last.y)
        for hit in halts:
            if hit.watch.component >= 0:
                self.y[hit.watch.component] = hit.watch.level

    def _turn(self, f: Derivative) -> None:
        """Keep a local extreme of the crank's speed that the last step passed."""
        found = extreme(self.stepper, f, self._crank)
        if found and found[0].t <= self.t:
            self.turning.append((found[0].t, found[1][0], found[0].value))

    def _watches(self, regime: Regime, stretch: Stretch) -> list[Watch]:
        """What can happen in a regime."""
        layout = self.system.layout
        watches = self.holder.watches(regime, self.stretch) + stretch_ends(regime, stretch)
        if self._loads and self._loads[0].speed is not None and not self._armed:
            watches.append(level("load", self._crank, self._loads[0].speed, 1.0))
        watches += (
            ends(self.scenario, layout) + runaway_speeds(layout, self.limits) + self._repeats.watches(regime, self.y)
        )
        notes = noted_speeds(self.scenario, layout, self.limits, regime.motor)
        return watches + [watch for watch in notes if (watch.kind, watch.level) not in self._passed]

    def _pass(self, hit: Hit, watches: list[Watch]) -> None:
        """Note what changes nothing; speeds are noted the first time."""
        watch = hit.watch
        if watch.kind == "cycle":
            watches.remove(watch)
            watches += self._repeats.passed(hit)
            if self._repeats.steady:
                self.note("steady", PASSED["cycle"], hit.t, hit.y)
            return
        self.note(watch.kind, Phrase(PASSED[watch.kind], level=watch.level), hit.t, hit.y)
        if watch.kind != "reversal":
            self._passed.add((watch.kind, watch.level))
            watches.remove(watch)

    def _act(self, hit: Hit) -> End | None:
        """What a halting event changes."""
        kind, (index, base) = hit.watch.kind, self._place
        if kind in ("above", "below"):
            self._place = self.ways.of(self._way).turned(index + (1 if kind == "above" else -1), base)
        elif kind == "speed":
            self.note("target", Phrase(PASSED["target"], level=hit.watch.level), self.t, self.y)
            return "speed"
        elif kind == "angle":
            self.note(
                "angle",
                Phrase("the crank has turned by {end_angle:g} rad", end_angle=self.scenario.end_angle),
                self.t,
                self.y,
            )
            return "angle"
        elif kind == "runaway":
            self.note("runaway", Phrase(PASSED["runaway"], level=hit.watch.level), self.t, self.y)
            return "runaway"
        elif kind == "rest" and hit.watch.component == self._crank:
            self._rests = True
        elif kind == "release":
            self.holder.release(hit.watch)
        return None

    def _row(self, regime: Regime, error: State | None) -> None:
        """A row for the present state; at the beginning of a piece it replaces the last row of the piece before."""
        if self.rows and self.rows[-1].t == self.t:
            error = self.rows.pop().error if error is None else error
        self.rows.append(Row(self.t, self.y, regime, error))

    def _rows_between(self, regime: Regime) -> None:
        """Rows for the instants that the last step passed."""
        while self._instants and self._instants[0] <= self.t:
            time = self._instants.pop(0)
            if self.stepper.t0 < time < self.t:
                self.rows.append(Row(time, self.stepper.to(time), regime, None))

    def _check_budget(self) -> None:
        if self.stepper.evaluations <= self.budget:
            return
        free = self.scenario.until_steady
        speed = f"where the crank has {self.y[self._crank]:.6g} rad/s"
        text = (
            f"{speed} and the motion does not repeat itself yet"
            if free
            else f"of {self.scenario.duration:g} s, {speed}"
        )
        duration = "give the duration that is of interest" if free else "a shorter duration"
        raise AccuracyError(
            f"{self.budget} evaluations took the motion only to t = {self.t:.6g} s{',' if free else ''} {text}",
            where=f"transient motion, scenario {self.scenario.name}",
            value=self.t,
            limit=self.scenario.duration,
            remedy=f"{duration}; the method auto; a larger tolerance; a rigid shaft in place of a stiff one",
        )


_ON, _OFF = ("motor on", "the motor is switched on"), ("motor off", "the motor is switched off")
_BRAKED, _FREED = ("brake on", "the brake is put on"), ("brake off", "the brake is taken off")
