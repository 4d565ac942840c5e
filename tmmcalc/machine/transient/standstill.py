"""Masses at rest: which ones are held there, by a constant braking moment or by loads that only resist.

A brake holds its mass while the other moments on it stay below the braking moment; with ``standstill`` "stop" the
crank is held against moments that would drive it backwards, whatever their size. With "pass" friction holds it while
the moments drive it neither forwards against the friction forwards nor backwards against that backwards.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.steps import State
from tmmcalc.machine.transient.equations import Regime, System, surplus
from tmmcalc.machine.transient.events import Watch, level
from tmmcalc.machine.transient.pointwise import Stretch
from tmmcalc.machine.transient.profile import Profiles
from tmmcalc.machine.transient.scenario import Scenario

SLACK = 1e-12  # of the largest moment: by so much a moment must exceed what holds a mass at rest


class Holder:
    """Decides what is held, and remembers which mass has just been released and in which direction."""

    def __init__(self, system: System, scenario: Scenario, moment: float, ways: Profiles) -> None:
        self._system, self._scenario, self._slack, self._ways = system, scenario, SLACK * moment, ways
        self._passes = scenario.standstill == "pass"
        self._first, self._last = system.layout.speed, len(system.chain.inertia) - 1
        self._released: dict[int, float] = {}
        self._sides: tuple[Regime, Regime] | None = None  # of a crank at rest that may turn back

    def _bounds(self, regime: Regime) -> dict[int, tuple[float, float]]:
        """How large a moment backwards and forwards each group withstands at rest [N*m]."""
        bounds = {}
        if regime.braked and self._system.grip > 0:
            bounds[self._system.brake] = (self._system.grip, self._system.grip)
        if self._scenario.standstill == "stop":
            bounds[self._last] = (math.inf, bounds.get(self._last, (0.0, 0.0))[1])
        elif self._ways.sided:
            bounds.setdefault(self._last, (0.0, 0.0))
        return bounds

    def resolve(self, regime: Regime, stretch: Callable[[Regime], Stretch], y: State) -> Regime:
        """The regime with what is held at rest, the direction of the brake, and the stretch a crank at rest enters."""
        self._sides = None
        if y[self._first + self._last] == 0 and self._passes:
            self._sides = self._both(regime, y)
            regime = self._entered(stretch, y, *self._sides)
        held, slip = set(), 0.0
        for group, bounds in self._bounds(regime).items():
            speed = y[self._first + group]
            way = math.copysign(1.0, speed) if speed else self._direction(regime, stretch, y, group, bounds)
            if way == 0:
                held.add(group)
            elif self._sides and group == self._last and self._ways.sided:
                regime = self._sides[0] if way > 0 else self._sides[1]
            if group == self._system.brake:
                slip = way
        self._released.clear()
        return regime._replace(held=frozenset(held), slip=slip)

    def _both(self, regime: Regime, y: State) -> tuple[Regime, Regime]:
        """The regimes that a crank at rest enters forwards and backwards."""
        forward, back = (
            regime._replace(stretch=k, base=base, way=way)
            for way in (1.0, -1.0)
            for k, base in (self._ways.of(way).place(y[0], way > 0),)
        )
        return forward, back

    def _nets(
        self, regime: Regime, stretch: Callable[[Regime], Stretch], group: int
    ) -> tuple[Callable[[State], float], Callable[[State], float]]:
        """The moments that would move a group at rest forwards and backwards; friction tells them apart."""
        sides = self._sides if self._sides and group == self._last else (regime, regime)
        forward, back = (surplus(self._system, side, stretch(side), group) for side in sides)
        return forward, back

    def _direction(
        self,
        regime: Regime,
        stretch: Callable[[Regime], Stretch],
        y: State,
        group: int,
        bounds: tuple[float, float],
    ) -> float:
        """Direction in which a group at rest starts to move; 0 if it is held."""
        if group in self._released:
            return self._released[group]
        forward, back = self._nets(regime, stretch, group)
        if forward(y) > bounds[1] + self._slack:
            return 1.0
        return -float(back(y) < -bounds[0] - self._slack)

    def _entered(self, stretch: Callable[[Regime], Stretch], y: State, ahead: Regime, behind: Regime) -> Regime:
        """A crank at rest on the edge of two stretches enters the one into which the moments drive it."""
        forward, back = (surplus(self._system, way, stretch(way), self._last)(y) for way in (ahead, behind))
        if forward < 0 < back and not self._ways.sided:
            raise NoSolutionError(
                f"the crank is at rest at {math.degrees(y[0]):.6g} deg on a jump of the load that drives it there from "
                f"both sides, with {back:.5g} and {forward:.5g} N*m: no motion begins",
                where=f"transient motion, scenario {self._scenario.name}",
                value=y[0],
                remedy="start at another angle",
            )
        return ahead if forward >= 0 else behind

    def watches(self, regime: Regime, stretch: Callable[[Regime], Stretch]) -> list[Watch]:
        """Coming to rest and being released."""
        found = []
        for group, bounds in self._bounds(regime).items():
            at = self._first + group
            if group in regime.held:
                found += self._releases(regime, stretch, group, bounds)
            elif group == self._last and not self._passes:
                found.append(level("rest", at, 0.0, -1.0))
            else:
                found.append(level("rest", at, 0.0, -(regime.way if group == self._last else regime.slip)))
        if self._passes and self._last not in self._bounds(regime):
            at = self._first + self._last
            found += [level("reversal", at, 0.0, way, halts=False) for way in (1.0, -1.0)]
        return found

    def _releases(
        self, regime: Regime, stretch: Callable[[Regime], Stretch], group: int, bounds: tuple[float, float]
    ) -> list[Watch]:
        forward, backward = self._nets(regime, stretch, group)
        (back, forth), slack = bounds, self._slack
        up = Watch("release", lambda y: forward(y) - forth - slack, group=group)
        down = Watch("release", lambda y: -back - backward(y) - slack, group=group, direction=-1.0)
        return [up] if back == math.inf else [up, down]

    def release(self, watch: Watch) -> None:
        """Remember that a group has been released, to be moved in the direction of the watch."""
        self._released[watch.group] = watch.direction

    def forever(self, regime: Regime, stretch: Callable[[Regime], Stretch], y: State) -> bool:
        """Whether the present regime keeps the crank at rest for good.

        One mass: if also the full static moment of the motor cannot release it. Several: if the motor is off and
        the load only resists; their shafts may still swing.
        """
        if self._last not in regime.held:
            return False
        if self._last > 0:
            return not regime.motor and not self._passes
        if not regime.motor or self._system.moment is None:
            return True
        forward, backward = self._nets(regime, stretch, 0)
        rise = self._system.moment(0.0) - y[2] if self._system.layout.lag else 0.0
        back, forth = self._bounds(regime)[0]
        return -back <= backward(y) + rise + self._slack and forward(y) + rise - self._slack <= forth
