"""The document of a whole run: the summary of every stage, no long table."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.pipeline.stage import resolve
from tmmcalc.report.document import Document
from tmmcalc.report.errors import with_errors

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

# by name, so that the summary of a stage that did not run is never imported
SUMMARIES = {
    "synthesis": "tmmcalc.report.synthesis:synthesis_summary",
    "structure": "tmmcalc.report.structure:structure_document",
    "kinematics": "tmmcalc.report.kinematics:kinematics_summary",
    "forces": "tmmcalc.report.forces:forces_summary",
    "reduction": "tmmcalc.report.reduction:reduction_summary",
    "power": "tmmcalc.report.power:power_summary",
    "flywheel": "tmmcalc.report.flywheel:flywheel_summary",
    "motion": "tmmcalc.report.motion:motion_summary",
    "transient": "tmmcalc.report.transient:transient_summary",
    "unsteady": "tmmcalc.report.unsteady:unsteady_summary",
    "manipulator": "tmmcalc.report.manipulator:manipulator_summary",
    "balance": "tmmcalc.report.balance:balance_summary",
    "train": "tmmcalc.report.train:train_summary",
    "gearing": "tmmcalc.report.gearing:gearing_summary",
    "strength": "tmmcalc.report.strength:strength_summary",
    "criteria": "tmmcalc.report.criteria:criteria_summary",
    "pair": "tmmcalc.report.pair:pair_summary",
    "blocking": "tmmcalc.report.blocking:blocking_summary",
    "profile": "tmmcalc.report.profile:profile_summary",
    "cam_law": "tmmcalc.report.cams.law:law_summary",
    "cam_synthesis": "tmmcalc.report.cams.synthesis:synthesis_summary",
    "cam_profile": "tmmcalc.report.cams.profile:profile_summary",
    "cam_pressure": "tmmcalc.report.cams.pressure:pressure_summary",
    "cam_forces": "tmmcalc.report.cams.forces:forces_summary",
    "cam_strength": "tmmcalc.report.cams.strength:strength_summary",
    "cam_elastic": "tmmcalc.report.cams.elastic:elastic_summary",
    "cam_optimum": "tmmcalc.report.cams.optimum:optimum_summary",
    "vibrator": "tmmcalc.report.vibration.vibrator:vibrator_summary",
    "pendulum": "tmmcalc.report.vibration.pendulum:pendulum_summary",
    "indexing": "tmmcalc.report.cams.indexing:indexing_summary",
    "contact": "tmmcalc.report.extras:contact_summary",
    "reliability": "tmmcalc.report.extras:reliability_summary",
    "tie_down": "tmmcalc.report.extras:tie_down_document",
    "falling_ball": "tmmcalc.report.extras:ball_summary",
    "bearing": "tmmcalc.report.extras:bearing_document",
    "feasibility": "tmmcalc.report.feasibility:feasibility_summary",
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
