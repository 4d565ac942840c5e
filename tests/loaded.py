"""The ready mechanisms with masses, friction and loads of the tests' own, and the press of the textbook."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.loading import Body, Load, Loading, Pair, Spring, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.project import load_spec

CONFIGS = Path(__file__).parents[1] / "configs"
DEG = np.pi / 180

PRESS_BODIES = (Body(2, 12, 0.055, 0.055 + 0j), Body(3, 24, 0, 0j))
PRESS_LAW = Polynomial((0.0, 0.0, -0.133 / DEG**2))  # -0.133 (phi - 210 deg)^2 N
PRESS_LOAD = Load("Q3", 3, "force", PRESS_LAW, window=Window(angles=(210 * DEG, 360 * DEG)))
PRESS_PAIRS = (Pair("A", 0.1, 0.025), Pair("B", 0.1, 0.015), Pair("B0", 0.1))


def ready(name: str) -> Mechanism:
    return to_linkage(load_spec(CONFIGS / f"{name}.toml").linkage)


def press(friction: bool = True) -> tuple[Mechanism, Loading, Kinematics]:
    """The press of the worked cases dyn-press-..."""
    mechanism = ready("press")
    pairs = PRESS_PAIRS if friction else ()
    return mechanism, Loading(PRESS_BODIES, -9.81j, (PRESS_LOAD,), pairs=pairs), solve_kinematics(mechanism)


def anything(mechanism: Mechanism) -> Loading:
    """Masses off the joints, a force, a moment between links, a spring with damping, friction in every pair."""
    bodies = tuple(Body(link.id, 2.0 + link.id, 0.05 * link.id, 0.03 - 0.02j) for link in mechanism.links)
    last, first = mechanism.links[-1].id, mechanism.links[1].id
    loads = (
        Load("Q", last, "force", Constant(300.0), 0.01 + 0.02j, np.exp(0.7j)),
        Load("T", first, "moment", Constant(20.0), against=FRAME),
    )
    springs = (Spring("k", "linear", (last, FRAME), (0.02j, 3 - 2j), 50.0, 0.1, 4.0),)
    pairs = tuple(
        Pair(j.name, 0.03, 0.01) if j.kind == "revolute" else Pair(j.name, 0.03, length=0.1) for j in mechanism.joints
    )
    return Loading(bodies, -9.81j, loads, springs, pairs)


def statics(mechanism: Mechanism, loading: Loading) -> Statics:
    return compile_statics(compile_scene(mechanism, loading, solve_kinematics(mechanism)))
