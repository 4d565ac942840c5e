"""The open pair on the crank, a wheel or a ring there: U = Z_b/Z_a. Its teeth are given, so no [train] asks for it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.scheme import PINION, RING, WHEEL, Layout, mesh

if TYPE_CHECKING:
    from tmmcalc.gears.model import TrainTask
    from tmmcalc.gears.search.blocks import Block, Tally

PINION_NAME, GEAR_NAME = "a", "b"  # no wheel of a train is called so
OVERHUNG = 1  # row of Table D.4.1: the pinion stands on the end of the reducer's output shaft


def candidates(task: TrainTask, proportion: tuple[int, ...], tally: Tally) -> Iterator[Block]:
    """Raise `UsageError`: the numbers of teeth of an open pair are given."""
    raise UsageError("no teeth are sought for an open pair", where="open_pair", remedy="give teeth in [open_pair]")


OPEN = Layout(
    "open pair",
    "a pair of wheels on the crank",
    "open pair",
    (PINION_NAME, GEAR_NAME),
    (mesh(PINION_NAME, GEAR_NAME, 0),),
    candidates,
    {PINION_NAME: PINION, GEAR_NAME: WHEEL},
    planetary=False,
    arrangements=(OVERHUNG,),
)
OPEN_RING = Layout(
    "open ring",
    "a pinion in a ring on the crank",
    "open pair",
    (PINION_NAME, GEAR_NAME),
    (mesh(PINION_NAME, GEAR_NAME, 0, "I"),),
    candidates,
    {PINION_NAME: PINION, GEAR_NAME: RING},
    rings=(GEAR_NAME,),
    planetary=False,
    arrangements=(OVERHUNG,),
)
