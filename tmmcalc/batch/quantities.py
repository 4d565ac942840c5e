"""What a stage tells of a variant: the quantities that names and patterns of `tmmcalc.naming.language` ask for."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.naming.language import Name, near, parse, rank
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import Extent, offered
from tmmcalc.naming.told import told as named


def told(
    results: Mapping[str, Any],
    patterns: Sequence[str],
    scene: Scene | None = None,
    stages: Sequence[str] | None = None,
) -> Iterator[tuple[str, float]]:
    """Quantities of stages (None: all) with their values, all facts without patterns; what is not finite is left out.

    Places between rows and what is by choice need the ``scene``.
    """
    for each in named(results, [parse(pattern) for pattern in patterns], scene, stages):
        if math.isfinite(each.value):
            yield each.key, each.value


def between_rows(patterns: Sequence[str]) -> bool:
    """Whether a pattern asks for places between rows."""
    return any(place is not None and place.column for place in (parse(pattern).place for pattern in patterns))


def by_choice(patterns: Sequence[str], results: Mapping[str, Any], spec: Any) -> bool:
    """Whether a pattern that these results do not tell names columns or facts by choice."""
    met = [parse(name) for name, _ in told(results, patterns)]
    missed = [name for name in map(parse, patterns) if not any(name.fits(each) for each in met)]
    return bool(missed) and any(True for _ in named(results, missed, Scene(spec, results)))


def unmatched(names: Iterable[str], patterns: Sequence[str]) -> str | None:
    """The first pattern that names none of these quantities."""
    met = list(dict.fromkeys(names))
    return next((pattern for pattern in patterns if all(rank(name, [pattern]) is None for name in met)), None)


def others(pattern: str) -> tuple[str, ...]:
    """Patterns of all that could stand in place of one: the same of every column, or every fact and such a column."""
    name = parse(pattern)
    stage = name.stage or "*"
    if name.fact:
        return "*", f"{stage}.max({name.what})"
    return (name._replace(stage=stage, what="*", unit=None).text,)


def offered_like(pattern: str, results: Mapping[str, Any], spec: Any) -> Iterator[str]:
    """Names of what is by choice that could stand in place of a pattern; nothing is computed."""
    name, scene = parse(pattern), Scene(spec, results)
    for stage in results:
        for each in offered(stage, scene) if name.may_be_of(stage) else ():
            unit = f"[{each.unit}]" if each.unit else ""
            if isinstance(each, Extent):
                asked = Name("", "max", each.quantity) if name.fact else name._replace(what=each.quantity)
                yield f"{asked._replace(stage=stage).text}{unit}"
            elif name.fact:
                yield f"{stage}.{each.quantity}{unit}"


def unknown(pattern: str, names: Sequence[str], where: str = "--columns") -> UsageError:
    """The error of a pattern that names nothing, with the nearest of what there is."""
    bare = pattern.rpartition("[")[0]
    same = [name for name in names if bare and rank(name, [bare]) is not None]
    remedy = f"it is {', '.join(same)}" if same else near(pattern, names, "quantities")
    return UsageError(f"no quantity is called {pattern!r}", where=where, remedy=remedy)
