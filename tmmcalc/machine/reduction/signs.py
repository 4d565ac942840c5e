"""Loads that do not do what they are called: a resistance that drives, over the whole cycle or on a part of it.

The likely causes are a wrong sign, and a load without the window of its stroke: on the way back it drives as much as it
resisted on the way there. Gas pressure drives on some strokes by its nature and is judged by its work alone.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.linkage.loading import Load
from tmmcalc.linkage.loads.travel import Travel
from tmmcalc.linkage.results import Grade

NOTHING = 1e-9  # part of what a load moves to and fro below which its work has no sign
TOLD = 1e-3  # part of the resisting work from which driving on a part of the cycle is told
GRAVE = 0.05  # and from which it is likely a fault
SHOWN = 3  # ranges of angles that are named one by one

Range = tuple[float, float, float]  # theta from and to, and the work done there


def wrong_signs(
    travel: Travel, names: Sequence[tuple[str, str, int]], loads: Sequence[Load], dense: Panels, parts: Values
) -> tuple[Grade, ...]:
    """What is to be said of the signs of all loads, whose moments ``parts`` (S, K, N) drive where they are positive."""
    known, grades = {load.name: load for load in loads}, []
    for (name, kind, _), part in zip(names, parts, strict=True):
        if kind == "load":
            found = _of_work(known[name], dense, part) or _of_part(travel, known[name], dense, part)
            grades += [found] if found else []
    return tuple(grades)


def _of_work(load: Load, dense: Panels, part: Values) -> Grade | None:
    """The sign of the work over the whole cycle; a neutral load may do any."""
    if load.role == "neutral":
        return None
    work = float(dense.total(part))
    against = -work if load.role == "drive" else work
    if against <= NOTHING * float(dense.total(np.abs(part))):
        return None
    text = (
        "is called a {role} but drives: {work:+.6g} J a cycle; turn its direction or its sign, or its role"
        if work > 0
        else "is called a {role} but resists: {work:+.6g} J a cycle; turn its direction or its sign, or its role"
    )
    return Grade("warning", Phrase("load {name}", name=load.name), Phrase(text, role=load.role, work=work))


def _of_part(travel: Travel, load: Load, dense: Panels, part: Values) -> Grade | None:
    """The part of the cycle on which a resistance drives."""
    if load.role != "resistance" or not load.law.judged or float(np.max(part)) <= 0:
        return None
    ranges = driving(dense, part, whole=travel.whole)
    gained, work = sum(done for _, _, done in ranges), float(dense.total(part))
    share = gained / (gained - work) if gained else 0.0
    if share < TOLD:
        return None
    net = Phrase("does {work:+.6g} J in all", work=work) if work < -NOTHING * gained else "does no work in all"
    text = Phrase(
        "is called a resistance but drives {named}: {gained:+.6g} J, {share:.3g} % of what it takes elsewhere, so that "
        "it {net}",
        named=_named(travel, ranges),
        gained=gained,
        share=100 * share,
        net=net,
    )
    remedy = (
        'is the window of its stroke missing (stroke = "working"), or is a sign wrong? If it is meant so, write '
        'role = "drive", or "neutral" for what is lifted and let down'
    )
    return Grade(
        "warning" if share > GRAVE else "note",
        Phrase("load {name}", name=load.name),
        Phrase("{text}; {remedy}", text=text, remedy=remedy),
    )


def _named(travel: Travel, ranges: Sequence[Range]) -> str:
    """Ranges of angles in words."""
    if len(ranges) > SHOWN:
        return Phrase("on {ranges} parts of the cycle", ranges=len(ranges))
    named = (travel.named(np.array([low, high])) for low, high, _ in ranges)
    return listed([Phrase("from {low} to {high}", low=low, high=high) for low, high in named], " and ")


def driving(dense: Panels, part: Values, *, whole: bool) -> list[Range]:
    """Where a moment (K, N) drives, and its work there; of a ``whole`` turn a range may go over its end.

    >>> from tmmcalc.core.numerics.panels import panels
    >>> on = panels(0.0, 2 * np.pi)
    >>> [[round(float(v), 9) for v in found] for found in driving(on, np.cos(on.x), whole=True)]
    [[4.71238898, 1.570796327, 2.0]]
    """
    cuts = np.sort(np.concatenate((dense.edges, *_changes(dense, part[None]))))
    works = np.diff(dense.primitive_at(part, cuts))
    found: list[Range] = []
    for k in np.flatnonzero(works > NOTHING * float(dense.total(np.abs(part)))):
        low, high, work = float(cuts[k]), float(cuts[k + 1]), float(works[k])
        if found and found[-1][1] == low:
            low, work = found[-1][0], work + found.pop()[2]
        found.append((low, high, work))
    if whole and len(found) > 1 and found[0][0] == dense.edges[0] and found[-1][1] == dense.edges[-1]:
        (low, _, late), (_, high, early) = found.pop(), found.pop(0)
        found.append((low, high, late + early))
    return found


def turnovers(dense: Panels, parts: Values) -> list[float]:
    """Work of the magnitude of each moment (S, K, N)."""
    found = []
    for part, inner in zip(parts, _changes(dense, parts), strict=True):
        cuts = np.sort(np.concatenate((dense.edges, inner)))
        found.append(float(np.sum(np.abs(np.diff(dense.primitive_at(part, cuts))))))
    return found


def _changes(dense: Panels, parts: Values) -> list[Values]:
    """Places within the panels where each function (S, K, N) changes its sign."""
    low, high = dense.ends(parts)
    values = np.concatenate((low[..., None], parts, high[..., None]), axis=-1) + 0.0  # no -0.0, which would be a change
    inner = np.nextafter(dense.edges[1:], dense.edges[:-1])  # what is read on the edge itself is the panel after it
    at = np.concatenate((dense.edges[:-1, None], dense.x, inner[:, None]), axis=1)
    part, k, i = np.nonzero(np.signbit(values[..., 1:]) != np.signbit(values[..., :-1]))
    low, high, below, above = at[k, i], at[k, i + 1], values[part, k, i], values[part, k, i + 1]
    first = low + (high - low) * (below / np.where(below == above, 1.0, below - above))

    def own(x: Values, which: NDArray[np.intp]) -> Values:
        return np.asarray(dense.at(parts, x)[part[which], np.arange(len(x))])

    places = bracketed(own, low, high, known=(below, above, first))
    return [places[part == number] for number in range(len(parts))]
