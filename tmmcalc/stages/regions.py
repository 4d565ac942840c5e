"""The feasibility stage at every point of a grid of parameters of a spec file."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.errors import TmmError, UsageError
from tmmcalc.feasibility.judge import Feasibility
from tmmcalc.feasibility.maps import Parameter, RegionMap, region_map
from tmmcalc.pipeline.variants import Overrides, solved
from tmmcalc.progress import tell

if TYPE_CHECKING:
    from tmmcalc.spec import Spec
    from tmmcalc.spec.variants import Axis

MOST = 2  # parameters of a map
POINTS = 10_000  # of a map


def map_feasibility(file: str | Path, over: Sequence[str], overrides: Sequence[str] = ()) -> RegionMap:
    """Where the constraints of a spec file hold over one or two ranges ``KEY=from:to:n``.

    Raises `UsageError` for ranges that cannot be read and quantities that a stage does not tell, `SpecError` or
    `NoSolutionError` if the scene has no solution at any point.
    """
    from tmmcalc.spec.loader import parse_spec, read_text
    from tmmcalc.spec.variants import grid

    path = Path(file)
    text = read_text(path)
    axes = _axes(text, path, over, overrides)

    def read(more: Sequence[str]) -> Spec:
        return parse_spec(text, str(path), [*overrides, *more], path.parent)

    points = [tuple(axis.assignment(value) for axis, value in zip(axes, values, strict=True)) for values in grid(axes)]
    parameters = [Parameter(axis.name, axis.values, tuple(map(axis.assignment, axis.values))) for axis in axes]
    return region_map(parameters, _told(solved(read, points, "feasibility"), len(points)))


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
    still = next((each for each in axes if len(each.values) < MOST), None)
    if still is not None:
        raise UsageError(f"{still.key} does not vary", where="--over", remedy="write two different ends")
    if len({each.key for each in axes}) < len(axes):
        raise UsageError(f"two ranges of {axes[0].key}", where="--over", remedy="vary another key, or one alone")
    if count(axes) > POINTS:
        size, rule = " x ".join(str(len(each.values)) for each in axes), f"a map has {POINTS} points at most"
        raise UsageError(f"{size} = {count(axes)} points are too many", where="--over", remedy=rule)
    return axes


def _told(found: Iterable[tuple[Overrides, Feasibility | TmmError]], count: int) -> Iterator[Feasibility | TmmError]:
    """What was found, with a word on how far it is."""
    for k, (overrides, result) in enumerate(found, 1):
        tell(k / count, ", ".join(overrides))
        yield result
