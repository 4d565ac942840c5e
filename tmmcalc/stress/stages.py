"""What the results of single stages need to be compared: magnitudes between their rows, sizes in whole millimetres."""

from __future__ import annotations

import numpy as np

from tmmcalc.pipeline.outcome import RunResult

SHAFT = 6  # number of the constraint of a cam's optimum whose radius is rounded up to whole mm


def between(stage: str, run: RunResult) -> dict[str, float]:
    """Largest magnitudes of columns over the cycle, where they may tower above all rows.

    Of a crank-slider with next to no inertia of its own the acceleration has peaks 1e-5 rad beside the dead centres,
    and is 0 there: on the rows rounding is then the largest.
    """
    if stage != "motion":
        return {}
    return {"eps": float(np.max(np.abs(run.results["motion"].regime.acceleration)))}


def in_millimetres(stage: str, *runs: RunResult) -> str:
    """Why the result is that of these units alone; empty if another length scales it."""
    if stage != "cam_optimum" or not any(map(_by_the_shaft, runs)):
        return ""
    return "the shaft decides, which is in whole millimetres"


def _by_the_shaft(run: RunResult) -> bool:
    optimum = run.results["cam_optimum"]
    return SHAFT in (*optimum.least.active, optimum.chosen.worst.number)
