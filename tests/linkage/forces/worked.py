"""The worked cases of the force analysis and the mechanisms that they speak of."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import numpy as np

from linkage.scenes import CONFIGS, crank_slider, full_turn, with_input
from tmmcalc import solve_kinematics
from tmmcalc.linkage.loading import Body, Load, Loading, Pair, Window
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics

FILES = ("dynamics", "force-groups-and-linkage-synthesis")
FOLDER = CONFIGS.parent / "tests" / "cases"
CASES: dict[str, Any] = {
    case["id"]: case for file in FILES for case in json.loads((FOLDER / f"{file}.json").read_text()) if case["verified"]
}
DEGREE = np.pi / 180


@cache
def press(positions: int = 12, speed: float = 5.0) -> tuple[Mechanism, Kinematics]:
    """The press of the textbook's appendix 3, from its outer dead centre on."""
    mechanism = with_input(full_turn(crank_slider(0.0375, 0.168), 0.0, positions), speed=speed)
    return mechanism, solve_kinematics(mechanism)


def press_loading(friction: float = 0.1) -> Loading:
    """Weights, masses and the pressing force -0.133 (phi - 210 deg)^2 on the last 150 degrees."""
    force = Polynomial((0.0, 0.0, -0.133 / DEGREE**2))
    return Loading(
        bodies=(Body(2, 12.0, 0.055, 0.055 + 0j), Body(3, 24.0, 0.0, 0j)),
        gravity=-9.81j,
        loads=(Load("Q", 3, "force", force, window=Window(angles=(210 * DEGREE, 360 * DEGREE))),),
        pairs=(Pair("A", friction, 0.025), Pair("B", friction, 0.015), Pair("B0", friction)) if friction else (),
    )
