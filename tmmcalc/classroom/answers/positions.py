"""Which row of a table over positions is that of one of them: by its number, or by the angle of the input link.

An angle is that of the input link, or is counted from position 0. Where both ways find a row, and not the same, neither
counts.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from tmmcalc.classroom.answers.naming import Place
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record

NEAR = 0.05  # deg, within which the angle of a row is that of a position


@record
class Steps:
    """Where the positions of a mechanism are."""

    step: float = 0.0  # [deg] from each to the next, with the sense of the motion; 0: no equal parts, or not known
    start: float = math.nan  # [deg] of position 0; NaN: not known


UNKNOWN = Steps()


@record
class Rows:
    """The rows of a table."""

    labels: tuple[str, ...]  # numbers of positions as they stand; empty: none
    angles: tuple[float, ...]  # [deg]; NaN: none

    def of(self, place: Place, steps: Steps) -> tuple[int, ...]:
        """The rows that may be that of a place: none, one, or two that different ways of counting find.

        A whole turn later is the same position, and the first row counts.
        """
        if place.label:
            numbers = [label.strip().removesuffix(".").removesuffix(".0") for label in self.labels]
            if place.label in numbers:
                return (numbers.index(place.label),)
        open_ = [
            angle if not (place.label and label) else math.nan
            for label, angle in zip(self.labels, self.angles, strict=True)
        ]
        found = [_first(open_, sought) for sought in self._sought(place, steps)]
        return tuple(dict.fromkeys(k for k in found if k is not None))

    def at(self, angle: float) -> int | None:
        """The first row at an angle [deg]; None where there is none, and of NaN."""
        return _first(self.angles, angle)

    def told(self, place: Place, steps: Steps) -> Phrase:
        """What is sought for a place, in words."""
        angles = list(dict.fromkeys(f"{round(angle, 2) % 360.0:g} deg" for angle in self._sought(place, steps)))
        if not place.label:
            return Phrase("the angle {angle}", angle=angles[0])
        if any(self.labels):
            return Phrase("position {number}", number=place.label)
        if not angles:
            return Phrase("position {number}, whose angle is not known", number=place.label)
        if len(angles) == 1:
            return Phrase("position {number}, at {angle}", number=place.label, angle=angles[0])
        return Phrase("position {number}, at {angle} or {other}", number=place.label, angle=angles[0], other=angles[1])

    def _sought(self, place: Place, steps: Steps) -> tuple[float, ...]:
        """The angles [deg] at which a place may be.

        Where that of position 0 is not known, it is that of the first row of a whole turn, or of one that begins at 0.
        """
        if not place.label:
            return (place.angle,)
        if not steps.step or not place.label.isdigit():
            return ()
        travel = int(place.label) * abs(steps.step)
        counted = travel * self._sense()
        if not math.isnan(steps.start):
            return steps.start + math.copysign(travel, steps.step), counted
        first = next((angle for angle in self.angles if not math.isnan(angle)), math.nan)
        if _apart(first, 0.0) <= NEAR or self._is_turn(first, abs(steps.step)):
            return first + counted, counted
        return ()

    def _sense(self) -> int:
        """1 where angles grow from row to row, -1 where they fall."""
        grows = sum((after > before) - (after < before) for before, after in pairwise(self.angles))
        return -1 if grows < 0 else 1

    def _is_turn(self, first: float, step: float) -> bool:
        """Whether each position of a turn has a row, counted from the first."""
        away = [((angle - first) % 360.0) / step for angle in self.angles if not math.isnan(angle)]
        count = round(360.0 / step)
        return len({round(k) % count for k in away if abs(k - round(k)) * step <= NEAR}) == count


def _first(angles: Sequence[float], sought: float) -> int | None:
    return next((k for k, angle in enumerate(angles) if _apart(angle, sought) <= NEAR), None)


def _apart(angle: float, other: float) -> float:
    """How far two angles [deg] are apart, whole turns aside; NaN where one is."""
    return abs((angle - other + 180.0) % 360.0 - 180.0)
