"""Whether the sizes of a mechanism belong together: a number without its unit stands out among lengths with theirs."""

from __future__ import annotations

from itertools import combinations

from tmmcalc.core.notes import Phrase
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.results import Grade

APART = 1000.0  # of two links of one mechanism: millimetres taken for metres


def size_grades(mechanism: Mechanism) -> tuple[Grade, ...]:
    """A warning where the largest link is more than a thousand times the smallest one: a unit is likely missing.

    The size of a link is the largest distance of two points on it [m]; one with a single point has none.
    """
    sizes = {link.id: _size(list(link.points.values())) for link in (mechanism.frame, *mechanism.links)}
    known = {number: size for number, size in sizes.items() if size > 0}
    if not known:
        return ()
    largest, smallest = max(known, key=known.__getitem__), min(known, key=known.__getitem__)
    if known[largest] <= APART * known[smallest]:
        return ()
    text = Phrase(
        "{large} measures {size:.4g} m, {small} {least:.4g} m, {times:.0f} times less (limit {limit:g}): a "
        'bare number is in metres, is a unit missing? Write e.g. "320 mm"',
        large=_called(largest),
        size=known[largest],
        small=_called(smallest),
        least=known[smallest],
        times=known[largest] / known[smallest],
        limit=APART,
    )
    return (Grade("warning", "mechanism", text),)


def _size(points: list[complex]) -> float:
    return max((abs(a - b) for a, b in combinations(points, 2)), default=0.0)


def _called(number: int) -> str:
    return "the frame" if number == FRAME else Phrase("link {number}", number=number)
