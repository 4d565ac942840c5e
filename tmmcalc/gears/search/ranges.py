"""The numbers of teeth that a task admits, as ranges."""

from __future__ import annotations

from tmmcalc.gears.model import TrainTask


def external(task: TrainTask) -> range:
    """Numbers of teeth of external wheels."""
    return range(task.limits.least, task.limits.largest + 1)


def ring(task: TrainTask) -> range:
    """Numbers of teeth of internal wheels."""
    return range(task.limits.least_ring, task.limits.largest_ring + 1)


def pinion(task: TrainTask) -> range:
    """Numbers of teeth of the pinions of unfolded trains."""
    return range(task.limits.least, min(task.limits.largest_pinion, task.limits.largest) + 1)
