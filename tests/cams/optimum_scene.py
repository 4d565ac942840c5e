"""The mechanism of case s16, and a flat-faced follower as in s13b."""

from __future__ import annotations

import json
from math import radians
from pathlib import Path
from typing import Any

from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.law import Law
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.task import AngleLimits, Asked, CamTask, Guide, Loads, Optimum, Requirements, Spring

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases" / "cams.json").read_text())}


def turn(law: Law, stroke: float, rise: float, high: float) -> Program:
    """Equal rise and return."""
    angle, top = radians(rise), radians(high)
    return Program(
        (
            Phase("rise", angle, 0.0, stroke, law),
            Phase("high dwell", top, stroke, stroke),
            Phase("return", angle, stroke, 0.0, law),
            Phase("low dwell", radians(360) - 2 * angle - top, 0.0, 0.0),
        )
    )


def roller_task(
    friction: float = 0.1, *, spring: Spring | None = None, guide: float | None = None, **asked: Any
) -> CamTask:
    """Case s16."""
    return CamTask(
        turn(LAWS["cosine"], 0.02, 60, 30),
        Asked("translating"),
        AngleLimits(radians(30), None, convex=0.003, concave=0.075),
        loads=Loads(100.0, 0.2, spring=spring or Spring("given", stiffness=9500.0, preload=10.0), friction=friction),
        guide=Guide(top=guide, stem=0.0035, land=0.004),
        requirements=Requirements(
            width=0.007,
            contact=400e6,
            rolling_arm=5e-5,
            roller_friction=0.1,
            pin_friction=0.1,
            pin_pressure=5e6,
            span=0.1,
            bending=100e6,
            deflection=1e-5,
            guide_pressure=5e6,
        ),
        optimum=Optimum(**asked),
    )


def flat_task(**asked: Any) -> CamTask:
    """Cases s13 and s13b."""
    return CamTask(
        turn(LAWS["sine"], 0.012, 70, 20),
        Asked("flat"),
        AngleLimits(radians(90), None, convex=0.003),
        loads=Loads(120.0, 0.15, spring=Spring("given", stiffness=8000.0, preload=60.0), friction=0.1),
        guide=Guide(stem=0.004, land=0.005),
        requirements=Requirements(
            width=0.01, contact=400e6, span=0.09, bending=100e6, deflection=1e-5, guide_pressure=5e6
        ),
        optimum=Optimum(**asked),
    )
