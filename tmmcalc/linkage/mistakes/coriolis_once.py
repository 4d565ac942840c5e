"""The Coriolis acceleration is taken once and not twice (textbook 2.8.2)."""

from __future__ import annotations

from tmmcalc.core.mistake import SOMETIMES, Mistake
from tmmcalc.linkage.coriolis import moving_guide, with_coriolis

MISTAKE = Mistake(
    "the Coriolis acceleration has 1 in place of 2",
    "Look at the Coriolis acceleration: how is its size made of angular velocity and relative velocity?",
    SOMETIMES,
    stages={"kinematics": with_coriolis(0.5)},
    applies=moving_guide,
)
