"""Unfolded trains, two or three stages side by side: U = Z2 Z3/(Z1 Z2') or Z2 Z3 Z4/(Z1 Z2' Z3')."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tmmcalc.gears.scheme import PINION, WHEEL, Layout, Lengths, Teeth, mesh

if TYPE_CHECKING:
    from tmmcalc.gears.model import TrainTask
    from tmmcalc.gears.search.blocks import Block, Tally


def candidates(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """Every set within tooth limits, ratio, ratios of stages and diameters; no axis ties the stages."""
    from tmmcalc.gears.search.unfolded import unfolded_trains

    return unfolded_trains(task, proportion, tally)


def length(teeth: Teeth, m: Lengths, stretch: Lengths, planets: int) -> Any:
    """D, the length of stages in a row: all centre distances, the radii of the first and the last wheel (4.51)."""
    numbers = list(teeth.values())
    meshes = list(zip(numbers[::2], numbers[1::2], strict=True))
    total = 0 * m[0]
    for k, (one, other) in enumerate(meshes):
        ends = (one if k == 0 else 0) + (other if k == len(meshes) - 1 else 0)
        total = total + m[k] * ((one + other) * stretch[k] + ends) / 2
    return total


TWO = Layout(
    "unfolded2",
    "two stages in unfolded layout",
    "unfolded",
    ("1", "2", "2'", "3"),
    (mesh("1", "2", 0), mesh("2'", "3", 1)),
    candidates,
    {"1": PINION, "2": WHEEL, "2'": PINION, "3": WHEEL},
    planetary=False,
    size=length,
    size_letters="a_12 + a_2'3 + (m_1*Z1 + m_2*Z3)/2",
    arrangements=(3, 5),
    usual_ratio=20,
)
THREE = Layout(
    "unfolded3",
    "three stages in unfolded layout",
    "unfolded",
    ("1", "2", "2'", "3", "3'", "4"),
    (mesh("1", "2", 0), mesh("2'", "3", 1), mesh("3'", "4", 2)),
    candidates,
    {"1": PINION, "2": WHEEL, "2'": PINION, "3": WHEEL, "3'": PINION, "4": WHEEL},
    planetary=False,
    size=length,
    size_letters="a_12 + a_2'3 + a_3'4 + (m_1*Z1 + m_3*Z4)/2",
    arrangements=(3, 3, 5),
    usual_ratio=45,
)
