"""The order of a picture: what it is drawn from, and the flags of ``tmmcalc plot`` as they were given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.cli.work import within_turns
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.project import Spec

POSITIONS, POLYGONS, CHOOSE, PHASE = "--positions", "--polygons", "--choose", "--phase"


class Order(NamedTuple):
    """What is to be drawn: the spec, the results of its stages, the picture's file, the flags as they were given."""

    spec: Spec
    results: Mapping[str, Any]
    file: Path
    flags: Mapping[str, str | None]

    def rows(self, flag: str, labels: Sequence[str]) -> list[int] | None:
        """Indices of the positions that a flag names."""
        from tmmcalc.cli.positions import rows_of

        return rows_of(self.flags[flag], labels, flag)

    def row(self, flag: str, labels: Sequence[str]) -> int | None:
        """The index of the one position that a flag names."""
        rows = self.rows(flag, labels)
        if rows is not None and len(rows) > 1:
            said = f"{self.flags[flag]!r} names {len(rows)} positions"
            raise UsageError(said, where=flag, remedy="name one of them")
        return rows[0] if rows else None

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
