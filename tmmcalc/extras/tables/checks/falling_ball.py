"""``[falling_ball]``: something moves the ball while it is there."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amount

_LATEST = 80.0  # lambda t of a ball


def check_ball(outline: Outline) -> Iterator[Finding]:
    """Gravity moves a ball whose separated mass has no speed of its own; times are within reach."""
    table = subtable(outline.document, "falling_ball")
    if table.get("relative_speed") == "own" and amount(table.get("gravity", 9.81), "acceleration") == 0:
        yield Finding(("falling_ball", "gravity"), 'without gravity "own" has no solution here', "write a gravity")
    decay = amount(table.get("decay"))
    listed = table.get("times")
    places: dict[Path, object] = {("duration",): table.get("duration")}
    if isinstance(listed, list):
        places |= {("times", k): value for k, value in enumerate(listed)}
    for place, value in places.items():
        time = amount(value, "time")
        if time is not None and decay is not None and time * decay > _LATEST:
            rule = f"at lambda t = {time * decay:.4g} nothing of the ball is left"
            yield Finding(("falling_ball", *place), rule, f"write a time up to {_LATEST / decay:.4g} s")


CHECKS = (check_ball,)
