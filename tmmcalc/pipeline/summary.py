"""The document of a whole run: the summary of every stage, no long table."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.stage import resolve
from tmmcalc.report.document import Document
from tmmcalc.report.errors import with_errors

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

# by name, so that the summary of a stage that did not run is never imported
SUMMARIES = {
    "synthesis": "tmmcalc.linkage.facts.synthesis:synthesis_summary",
    "structure": "tmmcalc.linkage.facts.structure:structure_document",
    "kinematics": "tmmcalc.linkage.facts.kinematics:kinematics_summary",
    "forces": "tmmcalc.linkage.facts.forces:forces_summary",
    "reduction": "tmmcalc.machine.facts.reduction:reduction_summary",
    "power": "tmmcalc.machine.facts.power:power_summary",
    "flywheel": "tmmcalc.machine.facts.flywheel:flywheel_summary",
    "motion": "tmmcalc.machine.facts.motion:motion_summary",
    "transient": "tmmcalc.machine.facts.transient:transient_summary",
    "unsteady": "tmmcalc.linkage.facts.unsteady:unsteady_summary",
    "manipulator": "tmmcalc.manipulators.facts.manipulator:manipulator_summary",
    "balance": "tmmcalc.machine.facts.balance:balance_summary",
    "train": "tmmcalc.gears.facts.train:train_summary",
    "gearing": "tmmcalc.gears.facts.gearing:gearing_summary",
    "strength": "tmmcalc.gears.facts.strength:strength_summary",
    "criteria": "tmmcalc.gears.facts.criteria:criteria_summary",
    "pair": "tmmcalc.gears.facts.pair:pair_summary",
    "blocking": "tmmcalc.gears.facts.blocking:blocking_summary",
    "profile": "tmmcalc.gears.facts.profile:profile_summary",
    "cam_law": "tmmcalc.cams.facts.cam_law:law_summary",
    "cam_synthesis": "tmmcalc.cams.facts.cam_synthesis:synthesis_summary",
    "cam_profile": "tmmcalc.cams.facts.cam_profile:profile_summary",
    "cam_pressure": "tmmcalc.cams.facts.cam_pressure:pressure_summary",
    "cam_forces": "tmmcalc.cams.facts.cam_forces:forces_summary",
    "cam_strength": "tmmcalc.cams.facts.cam_strength:strength_summary",
    "cam_elastic": "tmmcalc.cams.facts.cam_elastic:elastic_summary",
    "cam_optimum": "tmmcalc.cams.facts.cam_optimum:optimum_summary",
    "vibrator": "tmmcalc.vibration.facts.vibrator:vibrator_summary",
    "pendulum": "tmmcalc.vibration.facts.pendulum:pendulum_summary",
    "indexing": "tmmcalc.cams.facts.indexing:indexing_summary",
    "contact": "tmmcalc.extras.facts.extras:contact_summary",
    "reliability": "tmmcalc.extras.facts.extras:reliability_summary",
    "tie_down": "tmmcalc.extras.facts.extras:tie_down_document",
    "falling_ball": "tmmcalc.extras.facts.extras:ball_summary",
    "bearing": "tmmcalc.extras.facts.extras:bearing_document",
    "feasibility": "tmmcalc.feasibility.facts.feasibility:feasibility_summary",
}


def run_document(run: RunResult, title: str) -> Document:
    """The summaries of the stages that ran, in their order; a fact that stages share is said once."""
    parts: list[Document] = []
    said: set[str] = set()
    for stage in run.outcomes:
        part: Document = resolve(SUMMARIES[stage])(run.results[stage], stage)
        facts = tuple(fact for fact in part.facts if fact.label not in said)
        said |= {fact.label for fact in facts}
        parts.append(with_errors(replace(part, facts=facts), run.record(stage).error))
    return Document(title, parts=tuple(parts))
