"""Choice of the shifts of a pinion and a ring; signs of ISO 21771, lengths in normal modules.

given      x1 and x2 as they are          equal_shift  x1 = -x2: the reference centre distance
given_aw   a centre distance              balanced     the same, in the middle of what is admissible
zero       x1 = x2 = 0

On a line of constant x1 + x2 the admissible x1 form one or several intervals; the longest is taken, and a point in it
by one of SPLITS.
"""

from __future__ import annotations

from typing import get_args

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.records import record
from tmmcalc.gears.involute.internal.line import InternalLine, Span, climb, internal_line, intervals, scan
from tmmcalc.gears.involute.internal.margins import CONDITIONS
from tmmcalc.gears.involute.internal.pair import Tips
from tmmcalc.gears.involute.internal.ring import Ring, angle_of_distance
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.strategies import Split
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values

INTERNAL_STRATEGIES = ("given", "given_aw", "zero", "equal_shift", "balanced")
SPLITS: tuple[str, ...] = get_args(Split)
WHERE = "shifts of a ring"
STEEP = 100.0  # specific sliding that is told of
BESIDE = 1e-3  # how far beyond an end it is asked what ends it there
POINTS = 289  # that are looked at for equal sliding


@record
class InternalChoice:
    """Chosen shifts and where they stand."""

    x1: float
    x2: float
    inside: bool  # all conditions are met
    broken: tuple[str, ...]  # in words, those that are not
    note: str  # what the choice had to give up, or empty
    low: float | None  # admissible x1 for this x1 + x2, of the interval of the choice; None: there is none
    high: float | None


def choose_internal(
    pinion: Wheel,
    ring: Ring,
    strategy: str,
    *,
    x1: float | None = None,
    x2: float | None = None,
    distance: float | None = None,
    split: str = "equal_sliding",
    limits: QualityLimits | None = None,
    fillet: Shape = "ellipse",
    tips: Tips = "clear",
) -> InternalChoice:
    """The shifts by one of INTERNAL_STRATEGIES; those of pinion and ring are not read, ``distance`` is in modules.

    ``tips`` is the rule of `internal.pair` by which the tips of all shifts are found; ``limits.undercut`` tells whether
    an undercut pinion is tolerated. Shifts that are given are told where they stand; where they are chosen and nothing
    is admissible, `NoSolutionError` is raised with the least bad point.

    >>> found = choose_internal(Wheel(20), Ring(60), "equal_shift")
    >>> round(found.x1, 4), round(found.x2, 4)
    (0.5111, -0.5111)
    """
    if strategy not in INTERNAL_STRATEGIES:
        raise UsageError(
            f"there is no strategy {strategy!r} for a pinion in a ring",
            where=WHERE,
            remedy=f"strategies of an internal pair: {', '.join(INTERNAL_STRATEGIES)}",
        )
    if split not in SPLITS:
        raise UsageError(f"there is no split {split!r}", where=WHERE, remedy=f"splits: {', '.join(SPLITS)}")
    if strategy == "given":
        if x1 is None or x2 is None:
            raise UsageError("the strategy given needs both shifts", where=WHERE, remedy="give x1 and x2")
        return _judged(internal_line(pinion, ring, x1 + x2, limits, fillet, tips), x1, x2)
    if strategy == "zero":
        return _judged(internal_line(pinion, ring, 0.0, limits, fillet, tips), 0.0, 0.0)
    line = internal_line(pinion, ring, _sum(pinion, ring, strategy, distance), limits, fillet, tips)
    if strategy != "balanced" and (x1 is not None or x2 is not None):
        one = x1 if x1 is not None else line.total - float(x2 or 0.0)
        return _judged(line, one, line.total - one)
    return _split(line, "middle" if strategy == "balanced" else split)


def _sum(pinion: Wheel, ring: Ring, strategy: str, distance: float | None) -> float:
    """x1 + x2 that the strategy asks for."""
    if strategy != "given_aw":
        return 0.0
    if distance is None:
        raise UsageError("a centre distance is missing", where=WHERE, remedy="give the centre distance in modules")
    return angle_of_distance(pinion, ring, distance)[0]


def _judged(line: InternalLine, x1: float, x2: float) -> InternalChoice:
    broken = line.at(x1).broken()
    spans = intervals(line)
    span = next((span for span in spans if span[0] <= x1 <= span[1]), max(spans, key=_length, default=None))
    low, high = span if span is not None else (None, None)
    return InternalChoice(x1, x2, not broken, broken, "", low, high)


def _length(span: Span) -> float:
    return span[1] - span[0]


def _split(line: InternalLine, split: str) -> InternalChoice:
    """A point of the longest interval."""
    spans = intervals(line)
    if not spans:
        raise _none(line)
    low, high = max(spans, key=_length)
    note = ""
    if split == "equal_sliding":
        x1, note = _equal_sliding(line, low, high)
    elif split == "max_contact_ratio":
        x1 = min(max(climb(lambda x: line.at(x, line.form).ratio, low, high), low), high)
    else:
        x1 = (low + high) / 2
        if split == "equal_strength":
            note = "a ring has no tooth form factor: the middle of the admissible shifts is taken"
    if float(line.at(x1).unequal[0]) < -STEEP:
        steep = "the contact begins near the base circle of the pinion, where its specific sliding grows without bound"
        note = listed([text for text in (note, steep) if text], "; ")
    return InternalChoice(x1, line.total - x1, True, (), note, low, high)


def _equal_sliding(line: InternalLine, low: float, high: float) -> tuple[float, str]:
    """x1 with theta1 at A2 = theta2 at A1, or the end of the interval that comes nearest to it."""

    def unequal(x1: Values, _: Indices) -> Values:
        return line.at(x1).unequal

    x1 = np.linspace(low, high, POINTS)
    values = line.at(x1, line.form).unequal
    rising = np.flatnonzero((values[:-1] <= 0) & (values[1:] >= 0))
    if rising.size:
        k = rising[-1:]  # the one of the largest shift: the pinion is least undercut
        return float(bracketed(unequal, x1[k], x1[k + 1])[0]), ""
    first, last = abs(values[[0, -1]])
    end, outside = (low, low - BESIDE) if not first > last else (high, high + BESIDE)
    limit = _first_broken(line, outside)
    note = Phrase("equal sliding is out of reach at this sum of shifts; x1 = {end:.4f} is nearest to it", end=end)
    return end, Phrase("{note}; beyond it {limit}", note=note, limit=limit) if limit else note


def _first_broken(line: InternalLine, x1: float) -> str:
    """What is wrong at x1 in the first place, in words."""
    row = line.at(x1).rows[:, 0]
    return tuple(CONDITIONS.values())[int(np.argmin(row))] if row.min() < 0 else ""


def _none(line: InternalLine) -> NoSolutionError:
    """Nothing on the line is admissible: the least bad point, and what excludes what."""
    x1, least = scan(line)
    k = int(np.argmax(least))
    if not np.isfinite(least[k]):
        text = "the tips of no shifts lie above the base circles"
        return NoSolutionError(text, where=WHERE, value=line.total, limit=0.0, remedy=_remedy(line))
    best = climb(line.least, float(x1[max(k - 1, 0)]), float(x1[min(k + 1, x1.size - 1)]))
    margin = float(line.least(np.array([best]))[0])
    sides = dict.fromkeys(filter(None, (_first_broken(line, best + step) for step in (-BESIDE, BESIDE))))
    return NoSolutionError(
        Phrase(
            "no shifts of z = {pinion}/{ring} (ring) with x1 + x2 = {total:.4f} are admissible; the least bad are "
            "x1 = {x1:.4f}, x2 = {x2:.4f} (margin {margin:.4g}): there {sides}",
            pinion=line.pinion.teeth,
            ring=line.ring.teeth,
            total=line.total,
            x1=best,
            x2=line.total - best,
            margin=margin,
            sides=listed([*sides], " and on the other side "),
        ),
        where=WHERE,
        value=margin,
        limit=0.0,
        remedy=_remedy(line),
    )


def _remedy(line: InternalLine) -> str:
    found = ["another centre distance", "a greater difference of the teeth", "shorter teeth (stub rack)"]
    if not line.limits.undercut:
        found.append("tolerated undercut")
    return ", ".join(found)
