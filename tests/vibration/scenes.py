"""The device and the rotors that the tests of vibration share."""

from __future__ import annotations

import json
from math import radians
from pathlib import Path
from typing import Any

from tmmcalc.machine.motors.model import Motor
from tmmcalc.vibration.pendulum.task import Disc, PendulumTask
from tmmcalc.vibration.pendulum.task import Rod as PendulumRod
from tmmcalc.vibration.vibrator.task import Damping, Exciter, Flats, Gripper, Ring, Rods, Unbalance, VibratorTask

CASES = {
    case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases" / "collection-2008.json").read_text())
}


def case(name: str) -> tuple[dict[str, Any], dict[str, Any]]:
    """Inputs and expected values of a worked case."""
    found = CASES[name]
    assert found["verified"]
    return found["inputs"], found["expected"]


def device(damping: float = 0.02, unbalance: Unbalance | None = None, **more: Any) -> VibratorTask:
    """The device of the worked case, damped and excited."""
    i, _ = case("c2008-vibro-01")
    given = Unbalance(2e-4, 0.07, 0.055, radians(20), 3e-4) if unbalance is None else unbalance
    return VibratorTask(
        ring=Ring(i["m1"], i["Jz1"]),
        gripper=Gripper(i["m2"], i["l"], i["Jxi"], i["Jeta"], i["Jzeta"]),
        exciter=Exciter(i["m3"], i["R0"], i["Rstar"], radians(i["beta_deg"]), i["Jx3"], i["Jz3"]),
        rods=Rods(i["R2"], diameter=i["d_c"], length=i["l_c"], young=i["E"]),
        flats=Flats(
            width=i["b"],
            thickness=i["h"],
            length=i["l1"],
            offset=i["l2"],
            young=i["E"],
            shear=i["G"],
            torsion=i["alpha_t"],
        ),
        plate=i["c2"],
        gravity=i["g"],
        damping=Damping(damping),
        unbalance=given,
        **more,
    )


def motor(power: float, speed: float = 157.0, idle: float = 188.5) -> Motor:
    """A shunt motor by its rated point and its no-load speed."""
    return Motor("motor", power, speed, idle, kind="shunt")


def centrifuge(**more: Any) -> PendulumTask:
    """A bowl on a steel shaft."""
    rod = PendulumRod(0.8, 0.888, (209.7, 209.7), (0.003, 0.003), 160.8)
    disc = Disc(4.0, (0.0121, 0.0121), 0.0242, 2e-4)
    return PendulumTask(rod, disc, **{"pivot": 15.0, "spin": 157.0, **more})
