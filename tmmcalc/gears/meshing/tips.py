"""The tip circle of a wheel in several meshes: as it is given in one of them, else the smallest that any asks for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.meshing.refusal import millimetres
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.task import PairTask

WHERE = "pairs of the train"
EQUAL = 1e-12  # relative difference of radii that counts as none
TOLD = 1e-9  # that is told of


def with_tips(tasks: Sequence[PairTask], probes: Sequence[MeshPair]) -> tuple[list[PairTask], list[str]]:
    """The tasks with the shifts of the probes and one tip for every shared wheel; they refuse as was asked."""
    wheels = [wheel for task in tasks for wheel in task.wheels]
    shared = [wheel for wheel in dict.fromkeys(wheels) if wheels.count(wheel) > 1]
    last = [replace(probe.task, refuse=task.refuse) for task, probe in zip(tasks, probes, strict=True)]
    remarks = []
    for wheel in shared:
        places = [(k, task.wheels.index(wheel)) for k, task in enumerate(tasks) if wheel in task.wheels]
        tip, said = _tip(wheel, [(tasks[k].name, tasks[k].tips[i], probes[k].sizes[i].tip) for k, i in places])
        remarks += said
        for k, i in places:
            if abs(probes[k].sizes[i].tip - tip) > EQUAL * tip:
                one, two = last[k].tips
                last[k] = replace(last[k], tips=(tip, two) if i == 0 else (one, tip))
    return last, remarks


def _tip(wheel: str, each: Sequence[tuple[str, float | None, float]]) -> tuple[float, list[str]]:
    """The radius of the tip circle: the one that is given, else the smallest of all meshes."""
    given = [radius for _, radius, _ in each if radius is not None]
    if any(abs(radius - given[0]) > EQUAL * given[0] for radius in given):
        raise UsageError(
            f"wheel {wheel} is given several tip diameters: {', '.join(millimetres(2 * r) for r in given)}",
            where=WHERE,
            remedy="give it in one of its meshes",
        )
    name, _, least = min(each, key=lambda one: one[2])
    tip = given[0] if given else least
    other = max(radius for *_, radius in each)
    if given or other - tip <= TOLD * tip:
        return tip, []
    return tip, [
        f"wheel {wheel} has the smaller of its tips, d_a = {millimetres(2 * tip)} as mesh {name} asks, not "
        f"{millimetres(2 * other)}"
    ]
