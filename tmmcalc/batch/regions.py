"""The feasibility stage at every point of a grid of parameters of a spec file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.batch.task import Task
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.progress import tell
from tmmcalc.feasibility.judge import Feasibility
from tmmcalc.feasibility.maps import Parameter, RegionMap, region_map

if TYPE_CHECKING:
    from tmmcalc.spec.variants import Axis

MOST = 2  # parameters of a map
ENDS = 2  # different values of each
POINTS = 10_000  # of a map


def map_feasibility(file: str | Path, over: Sequence[str], overrides: Sequence[str] = ()) -> RegionMap:
    """Where the constraints of a spec file hold over one or two ranges ``KEY=from:to:n``.

    Raises `UsageError` for ranges that cannot be read and quantities that a stage does not tell, `SpecError` or
    `NoSolutionError` if the scene has no solution at any point.
    """
    from tmmcalc.project.loader import read_text

    path = Path(file)
    text = read_text(path)
    axes = _axes(text, path, over, overrides)
    folder = str(path.parent.absolute())  # whoever goes elsewhere meanwhile
    task = Task(text, str(path), folder, tuple(overrides), tuple(axes), targets=("feasibility",))
    parameters = [Parameter(axis.name, axis.values, tuple(map(axis.assignment, axis.values))) for axis in axes]
    return region_map(parameters, _judged(task))


def _axes(text: str, path: Path, over: Sequence[str], overrides: Sequence[str]) -> list[Axis]:
    """The ranges, their values ascending and each once."""
    from tmmcalc.spec.override import apply
    from tmmcalc.spec.syntax import read_toml
    from tmmcalc.spec.variants import axis, count

    if not 1 <= len(over) <= MOST:
        raise UsageError(f"{len(over)} ranges: a map has one or two", where="--over", remedy="write one or two")
    data, _ = apply(read_toml(text, str(path)), overrides)
    axes = [axis(each, data) for each in over]
    axes = [replace(each, values=tuple(sorted(set(each.values)))) for each in axes]
    still = next((each for each in axes if len(each.values) < ENDS), None)
    if still is not None:
        raise UsageError(f"{still.key} does not vary", where="--over", remedy="write two different ends")
    if len({each.key for each in axes}) < len(axes):
        raise UsageError(f"two ranges of {axes[0].key}", where="--over", remedy="vary another key, or one alone")
    if count(axes) > POINTS:
        size, rule = " x ".join(str(len(each.values)) for each in axes), f"a map has {POINTS} points at most"
        raise UsageError(f"{size} = {count(axes)} points are too many", where="--over", remedy=rule)
    return axes


def _judged(task: Task) -> Iterator[Feasibility | TmmError]:
    """What is found at every point, with a word on how far it is."""
    from tmmcalc.batch.outcomes import outcomes

    for point, result in enumerate(outcomes(task)):
        tell((point + 1) / task.count, ", ".join(task.assignments(point)))
        yield result
