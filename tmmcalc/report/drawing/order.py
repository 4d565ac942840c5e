"""The order of a picture: what it is drawn from, and the flags of ``tmmcalc plot`` as they were given."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.report.rows import CHOOSE

TURNS = 100  # that an angle of a drawing may have
POSITIONS, POLYGONS, PHASE = "--positions", "--polygons", "--phase"


class Order(NamedTuple):
    """What is to be drawn: the spec, the results of its stages, the flags as they were given."""

    spec: Any
    results: Mapping[str, Any]
    flags: Mapping[str, str | None]
    solved: Callable[[str], Any]  # the result of another stage of the scene
    read: Callable[[str], Any]  # the spec of a text

    def rows(self, flag: str, labels: Sequence[str]) -> list[int] | None:
        """Indices of the positions that a flag names."""
        from tmmcalc.report.rows import rows_of

        return rows_of(self.flags[flag], labels, flag)

    def angle(self, flag: str) -> float:
        """The angle [rad] that a flag gives, 0 without it."""
        from tmmcalc.spec.units import UnitError, parse

        said = self.flags.get(flag)
        try:
            angle = 0.0 if said is None else parse(said, "angle")
        except UnitError as fault:
            raise UsageError(fault.message, where=flag, remedy=fault.remedy) from None
        return within_turns(angle, flag)

    @property
    def choice(self) -> int | None:
        """The number that --choose gives."""
        said = self.flags.get(CHOOSE)
        return None if said is None else int(said)


def within_turns(angle: float, flag: str) -> float:
    """The angle [rad] itself; raises `UsageError` if it is more than TURNS turns."""
    if abs(angle) <= TURNS * 2 * math.pi:
        return angle
    raise UsageError(
        f"{math.degrees(angle):.6g} deg is more than {TURNS} turns",
        where=flag,
        value=angle,
        limit=TURNS * 2 * math.pi,
        remedy=f"write e.g. {flag} '5 deg'",
    )
