"""Ladders of a synthesis: toward equal times of both strokes, and precision points that come together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from tmmcalc.stress.quantities import pure, rewritten
from tmmcalc.stress.scene import DISTANCES, NUDGED_TWIN, OWN_TWIN, Climb, Scene, Step, always, changed, lacking

NARROWER = (1.0, 0.1, 1e-2, 1e-3)  # of the range of a function
TURNS = ("input_range", "output_range")  # that the range is scaled to


def time_ratio(scene: Scene) -> Climb:
    """K goes to 1, where a quick return has none: lengths grow beyond bounds, or cranks shrink to nothing."""
    asked = scene.document.get("synthesis", {})
    kind = next((name for name, table in asked.items() if isinstance(table, dict) and "time_ratio" in table), None)
    if kind is None or not scene.has("synthesis"):
        raise lacking("no linkage is sought by its time ratio")
    beyond = pure(asked[kind]["time_ratio"]) - 1.0
    if not beyond > 0:
        raise lacking("the time ratio is 1 already")

    def steps() -> Iterator[Step]:
        for left in DISTANCES:
            told = changed(scene.document, "synthesis", kind, "time_ratio", to=1.0 + beyond * left)
            condition = 1 / (beyond * left) if left else 2.0**53
            yield Step(f"K = 1 + {beyond * left:.6g}", left, told, always(condition))

    return Climb("time ratio K to 1", "1/(K - 1)", NUDGED_TWIN, steps())


def narrow_range(scene: Scene) -> Climb:
    """The range of a function and the angles for it shrink: precision points lie so near that they say the same."""
    function: dict[str, Any] = scene.document.get("synthesis", {}).get("function", {})
    if "range" not in function or not scene.has("synthesis"):
        raise lacking("no linkage is sought for a function over a range")

    def steps() -> Iterator[Step]:
        for part in NARROWER:
            told = changed(scene.document, "synthesis", "function", to=narrowed(function, part))
            yield Step(f"range x {part:g}", part, told, always(1 / part))

    return Climb("range of the function to a point", "1/part of the range", OWN_TWIN, steps())


def narrowed(function: Mapping[str, Any], part: float) -> dict[str, Any]:
    """The function over a part of its range, with as small turns, or as short a travel."""
    low, high = map(pure, function["range"])
    narrow = {key: rewritten(function[key], lambda size: size * part) for key in TURNS if key in function}
    return {**function, **narrow, "range": [low, low + (high - low) * part]}
