"""Whether a motion has become steady: its state after a whole cycle is what it was a cycle before."""

from __future__ import annotations

from tmmcalc.core.numerics.steps import State
from tmmcalc.machine.transient.equations import Regime, System
from tmmcalc.machine.transient.events import Hit, Watch, level
from tmmcalc.machine.transient.initial import Sizes, allowed

SAME = 1e-6  # of the sizes of the drive: a state that differs by less from that of a cycle before has come back


class Periodicity:
    """Compares the states at the same angle of every cycle, as long as nothing is switched."""

    def __init__(self, system: System, size: Sizes, period: float) -> None:
        self._period, self._state = period, slice(1, system.layout.works)
        self._near = allowed(system, size, SAME)[self._state]
        self._in_force: Regime | None = None
        self._before: State | None = None
        self._mark = 0.0
        self.steady = False

    def watches(self, regime: Regime, y: State) -> list[Watch]:
        """The angle at which the next cycle is complete; where something else is in force cycles count anew."""
        now = regime._replace(stretch=0, base=0.0)
        if now != self._in_force:
            self._in_force, self._before, self.steady = now, None, False
            self._mark = y[0] + self._period
        return [] if self.steady else [self._watch()]

    def _watch(self) -> Watch:
        return level("cycle", 0, self._mark, 1.0, halts=False)

    def passed(self, hit: Hit) -> list[Watch]:
        """Compare the state at the end of a cycle; what to watch next."""
        now = hit.y[self._state]
        if self._before is not None:
            moved = zip(now, self._before, self._near, strict=True)
            self.steady = all(abs(a - b) <= near for a, b, near in moved)
        self._before = now
        self._mark += self._period
        return [] if self.steady else [self._watch()]
