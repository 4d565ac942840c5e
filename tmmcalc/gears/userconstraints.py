"""Tooth sets and trains that keep the user's own constraints on the columns of their tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.feasibility.judge import FeasibilityTask
from tmmcalc.feasibility.rows import Kept, keep
from tmmcalc.gears.columns import set_columns
from tmmcalc.gears.selection.columns import columns_of
from tmmcalc.gears.selection.results import Weighed
from tmmcalc.gears.sizing import rows_of
from tmmcalc.gears.trains import Trains, Variant


def kept_sets(trains: Trains, task: FeasibilityTask) -> Trains:
    """The sets that are held and keep the constraints on stage ``train``; raises `NoSolutionError` if none does."""
    judged = [(each, keep(task, "train", set_columns(each))) for each in trains.variants if len(each.sets)]
    if not any(kept.rows.any() for _, kept in judged):
        raise _none([(each.request.title, kept) for each, kept in judged], "train", "tooth set")
    found = {id(each): _variant(each, kept) for each, kept in judged}
    return Trains(tuple(found.get(id(each), each) for each in trains.variants))


def _variant(each: Variant, kept: Kept) -> Variant:
    rows = np.flatnonzero(kept.rows)
    lost = len(kept.rows) - len(rows)
    removed = {**each.synthesis.removed, **_named(kept.removed, lost)}
    synthesis = replace(
        each.synthesis, sets=rows_of(each.sets, rows), count=each.synthesis.count - lost, removed=removed
    )
    textbook = None if each.textbook is None else each.textbook[rows]
    return replace(each, synthesis=synthesis, textbook=textbook)


def _named(removed: Mapping[str, int], lost: int) -> dict[str, int]:
    """Counts that add up to what is lost: a set that breaks several constraints is counted under the first."""
    found = {}
    for name, count in removed.items():
        found[f"constraint {name}"] = min(count, lost)
        lost -= found[f"constraint {name}"]
    return {name: count for name, count in found.items() if count}


def kept_trains(weighed: Sequence[Weighed], task: FeasibilityTask) -> tuple[Weighed, ...]:
    """The trains that keep the constraints on stage ``criteria``; raises `NoSolutionError` if none does."""
    judged = [keep(task, "criteria", columns_of(each)) for each in weighed]
    if not any(kept.rows.any() for kept in judged):
        raise _none([(each.title, kept) for each, kept in zip(weighed, judged, strict=True)], "criteria", "train")
    return tuple(_weighed(each, kept) for each, kept in zip(weighed, judged, strict=True))


def _weighed(each: Weighed, kept: Kept) -> Weighed:
    rows: NDArray[np.intp] = np.flatnonzero(kept.rows)
    criteria = replace(each.criteria, **{f.name: getattr(each.criteria, f.name)[rows] for f in fields(each.criteria)})
    return replace(
        each,
        sets=rows_of(each.sets, rows),
        module=each.module[rows],
        width=each.width[rows],
        criteria=criteria,
        refused=kept.removed,
    )


def _none(judged: Sequence[tuple[str, Kept]], stage: str, what: str) -> NoSolutionError:
    """What each constraint removed, and what values there were."""
    lines = [
        f"{title}: of {len(kept.rows)} " + ", ".join(f"{name} removed {n}" for name, n in kept.removed.items() if n)
        for title, kept in judged
        if len(kept.rows)
    ]
    told = [f"{title}: {'; '.join(kept.told)}" for title, kept in judged if len(kept.rows)]
    return NoSolutionError(
        f"no {what} keeps the constraints\n  " + "\n  ".join(lines),
        where=stage,
        remedy="loosen a limit of [[constraints]]; before them\n     " + "\n     ".join(told),
    )
