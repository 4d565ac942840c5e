"""The stages that have a choice of methods, and the functions that study them.

Every function is called as ``studies(scene)`` and yields the studies of its stage; its module is imported only when the
stage is studied.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.core.studies.measure import Clock

SUBJECTS: dict[str, str] = {
    "train": "tmmcalc.gears.accuracy.train:studies",
    "pair": "tmmcalc.gears.accuracy.pair:studies",
    "blocking": "tmmcalc.gears.accuracy.blocking:studies",
    "profile": "tmmcalc.gears.accuracy.profile:studies",
    "kinematics": "tmmcalc.linkage.accuracy.kinematics:studies",
    "forces": "tmmcalc.linkage.accuracy.forces:studies",
    "reduction": "tmmcalc.machine.accuracy.reduction:studies",
    "power": "tmmcalc.machine.accuracy.power:studies",
    "flywheel": "tmmcalc.machine.accuracy.flywheel:studies",
    "motion": "tmmcalc.machine.accuracy.motion:studies",
    "transient": "tmmcalc.machine.accuracy.transient:studies",
    "balance": "tmmcalc.machine.accuracy.balance:studies",
    "cam_law": "tmmcalc.cams.accuracy.cam_law:studies",
    "cam_synthesis": "tmmcalc.cams.accuracy.cam_synthesis:studies",
    "cam_profile": "tmmcalc.cams.accuracy.cam_profile:studies",
    "cam_pressure": "tmmcalc.cams.accuracy.cam_pressure:studies",
    "cam_forces": "tmmcalc.cams.accuracy.cam_forces:studies",
    "cam_elastic": "tmmcalc.cams.accuracy.cam_elastic:studies",
    "cam_optimum": "tmmcalc.cams.accuracy.cam_optimum:studies",
    "indexing": "tmmcalc.cams.accuracy.indexing:studies",
    "vibrator": "tmmcalc.vibration.accuracy.vibrator:studies",
    "pendulum": "tmmcalc.vibration.accuracy.pendulum:studies",
    "contact": "tmmcalc.extras.accuracy.contact:studies",
    "falling_ball": "tmmcalc.extras.accuracy.falling_ball:studies",
}


@record
class Scene:
    """What a study starts from: what the stage reads of the spec, the results of its run, the clock."""

    inputs: Any  # as the stage's ``inputs`` gives them
    results: Mapping[str, Any]  # by stage, of it and all before it
    clock: Clock
