"""What theory proposes before tooth numbers are known: the split of the ratio, the module ratio of equal strength."""

from __future__ import annotations

from tmmcalc.gears.proportion import equal_strength
from tmmcalc.gears.selection.results import Guide
from tmmcalc.gears.split import CRITERIA, best_split, equal_diameters
from tmmcalc.gears.trains import Request


def guides(requests: tuple[Request, ...]) -> tuple[Guide, ...]:
    """One guide for every layout that has a theory."""
    by_layout = {request.task.layout: request for request in requests}
    found = (_guide(request) for request in by_layout.values())
    return tuple(guide for guide in found if guide.splits or guide.proportion is not None)


def _guide(request: Request) -> Guide:
    task = request.task
    ratio = float(task.nominal)
    if task.scheme.stepped and ratio > 1:
        modules = equal_strength(ratio, internal=bool(task.scheme.rings)).modules
        return Guide(task.layout, ratio, proportion=float(modules[0]))
    if task.scheme.branched or task.scheme.planetary:
        return Guide(task.layout, ratio)
    stages, limit = task.scheme.stages, task.demands.stage_ratio
    most = None if limit is None else float(limit)
    if most is not None and ratio > most**stages:
        return Guide(task.layout, ratio, (equal_diameters(ratio, stages),))
    splits = (best_split(ratio, criterion, stages, most=most) for criterion in CRITERIA)
    return Guide(task.layout, ratio, (equal_diameters(ratio, stages), *splits))
