"""Facts on the time scales of a motion: how stiff it is, and what explicit steps that only stay bounded would take."""

from __future__ import annotations

from tmmcalc.core.quantity import keyed
from tmmcalc.machine.timescales import TimeScales
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import number


def scales_fact(scales: TimeScales | None, label: str = "time scales") -> Fact:
    """Fastest and slowest time constant, their ratio, the longest step that stability allows, how many it takes."""
    if scales is None:
        return Fact(label, "nothing changes within the duration: not stiff", {"time_scales": None})
    lines = (
        f"fastest time constant {seconds(scales.fastest)}, slowest {seconds(scales.slowest)}: "
        f"ratio {number(scales.ratio, 3)}",
        f"explicit steps stay bounded up to {seconds(scales.stable_step)}: {number(scales.steps, 3)} for the sake of "
        f"stability alone in {seconds(scales.duration)}",
    )
    values = keyed(scales, "fastest", "slowest", "ratio", "duration", "stable_step", "steps")
    return Fact(label, "\n".join(lines), {"time_scales": values})


def seconds(value: float) -> str:
    """A time with its unit, short ones in powers of ten."""
    return f"{number(value, 3)} s" if value >= 1e-3 else f"{value:.3g} s"
