"""The stages that have a choice of methods, and the functions that study them.

Every function is called as ``studies(scene)`` and yields the studies of its stage; its module is imported only when the
stage is studied.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.records import record

if TYPE_CHECKING:
    from tmmcalc.accuracy.measure import Clock

SUBJECTS: dict[str, str] = {
    "train": "tmmcalc.accuracy.train:studies",
    "pair": "tmmcalc.accuracy.pair:studies",
    "blocking": "tmmcalc.accuracy.blocking:studies",
    "profile": "tmmcalc.accuracy.profile:studies",
    "kinematics": "tmmcalc.accuracy.kinematics:studies",
    "forces": "tmmcalc.accuracy.forces:studies",
    "reduction": "tmmcalc.accuracy.reduction:studies",
    "power": "tmmcalc.accuracy.power:studies",
    "flywheel": "tmmcalc.accuracy.flywheel:studies",
    "motion": "tmmcalc.accuracy.motion:studies",
    "transient": "tmmcalc.accuracy.transient:studies",
    "balance": "tmmcalc.accuracy.balance:studies",
    "cam_law": "tmmcalc.accuracy.cam_law:studies",
    "cam_synthesis": "tmmcalc.accuracy.cam_synthesis:studies",
    "cam_profile": "tmmcalc.accuracy.cam_profile:studies",
    "cam_pressure": "tmmcalc.accuracy.cam_pressure:studies",
    "cam_forces": "tmmcalc.accuracy.cam_forces:studies",
    "cam_elastic": "tmmcalc.accuracy.cam_elastic:studies",
    "cam_optimum": "tmmcalc.accuracy.cam_optimum:studies",
    "indexing": "tmmcalc.accuracy.indexing:studies",
    "vibrator": "tmmcalc.accuracy.vibrator:studies",
    "pendulum": "tmmcalc.accuracy.pendulum:studies",
    "contact": "tmmcalc.accuracy.contact:studies",
    "falling_ball": "tmmcalc.accuracy.falling_ball:studies",
}


@record
class Scene:
    """What a study starts from: what the stage reads of the spec, the results of its run, the clock."""

    inputs: Any  # as the stage's ``inputs`` gives them
    results: Mapping[str, Any]  # by stage, of it and all before it
    clock: Clock
