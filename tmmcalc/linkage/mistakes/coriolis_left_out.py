"""The Coriolis acceleration is left out (textbook 2.8.2)."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Mistake
from tmmcalc.linkage.coriolis import moving_guide, with_coriolis

MISTAKE = Mistake(
    "the Coriolis acceleration is left out",
    "Look at the slider on the link that turns: are all terms of its acceleration there?",
    OFTEN,
    stages={"kinematics": with_coriolis(0.0)},
    applies=moving_guide,
)
