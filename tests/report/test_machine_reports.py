"""The documents of power, flywheel and motion, against closed forms and the worked cases of the course."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from loaded import press
from machine.flywheel.scenes import parabola, upsetter, upsetter_cycle
from machine.motion import shaper

from tmmcalc.api import run
from tmmcalc.errors import UsageError
from tmmcalc.linkage.reduction.reduce import solve_reduction
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia, Driver, driver_of
from tmmcalc.machine.flywheel.task import Flywheel, solve_flywheel
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.motion import Motion, solve_motion
from tmmcalc.machine.motors.characteristics import Parabolic
from tmmcalc.machine.motors.model import Motor
from tmmcalc.machine.power import Power, WorkPart, chosen_motor, duty_of, solve_power
from tmmcalc.machine.verdicts import Verdict
from tmmcalc.report.document import Document
from tmmcalc.report.flywheel import flywheel_document, flywheel_summary
from tmmcalc.report.motion import motion_document, motion_summary
from tmmcalc.report.plaintext import lines
from tmmcalc.report.power import power_document, power_summary
from tmmcalc.report.summary import run_document
from tmmcalc.spec import load_spec

from .machines import TURN, positions, sine, spec_text, steps

CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[1] / "cases" / "dynamics.json").read_text())}
RPM = math.pi / 30


def values(document: Document) -> dict[str, Any]:
    return {key: value for fact in document.facts for key, value in fact.values.items()}


def text(document: Document, label: str) -> str:
    (fact,) = [fact for fact in document.facts if fact.label == label]
    return fact.text


def column(document: Document, header: str) -> list[Any]:
    assert document.table is not None
    return list(document.table.columns[list(document.table.headers).index(header)])
