"""The profiles of both directions of the crank: friction and quadratic resistances turn round with the motion.

The technological loads, weights and springs depend on the angle alone and stay as they are. What rubs presses on
other places when it is turned back, so the friction backwards is not the mirror image of that forwards: a drive
carries both cycles, and the one backwards is reduced when the crank is first asked whether it turns back.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np

from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.transient.model import Drive
from tmmcalc.machine.transient.profile import Profile, profile


class Ways:
    """The profile forwards and, made when it is first needed, that backwards."""

    def __init__(self, drive: Drive) -> None:
        self._drive = drive
        self.forward = profile(drive.cycle, drive.idle)
        own = [cycle for cycle in (drive.cycle, drive.idle) if cycle is not None]
        self.sided = drive.back is not None or any(bool(np.any(cycle.quadratic)) for cycle in own)

    @cached_property
    def back(self) -> Profile:
        """The profile of the crank turning back."""
        drive = self._drive
        cycle, idle = drive.back() if drive.back is not None else (drive.cycle, drive.idle)
        return profile(_turned(cycle), _turned(idle))

    def of(self, way: float) -> Profile:
        """The profile in a direction: 1 forwards, -1 backwards."""
        return self.forward if way > 0 or not self.sided else self.back


def _turned(cycle: Cycle | None) -> Cycle | None:
    """A cycle whose quadratic part, given for a positive speed, resists a negative one."""
    return None if cycle is None else replace(cycle, quadratic=-cycle.quadratic)
