"""Cams that the tests of [cam] share, and what is read from their tasks."""

from __future__ import annotations

import math

from tmmcalc.cams.tables.tasks.cam import to_cam
from tmmcalc.cams.task import CamTask
from tmmcalc.project import parse_spec

DEGREE = math.pi / 180
MOTION = 'rise = "60 deg"\nhigh_dwell = "30 deg"\nreturn_angle = "90 deg"\nlaw = "sine"\n'
FOLLOWER = {
    "RT": 'follower = "translating"\nstroke = "30 mm"\n',
    "RK": 'follower = "oscillating"\nstroke = "20 deg"\nrocker_length = "100 mm"\n',
    "PT": 'follower = "flat"\nstroke = "30 mm"\n',
}
LOADS = 'speed = "30 rad/s"\n[cam.loads]\nmass = "0.2 kg"\n'
ROCKING = 'speed = "30 rad/s"\n[cam.loads]\ninertia = "1e-4 kg*m^2"\n'


def cam(lines: str = "", kind: str = "RT", motion: str = MOTION) -> CamTask:
    return to_cam(parse_spec(f"[cam]\n{FOLLOWER[kind]}{motion}{lines}\n"))


def own(law: str) -> CamTask:
    """A cam with a law of one's own on rise and return."""
    return cam(motion=MOTION.replace('"sine"', f"{{ {law} }}"))


def law_names(task: CamTask) -> list[str]:
    return [phase.law.name for phase in task.program.phases if phase.law is not None]
