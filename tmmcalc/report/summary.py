"""The document of a whole run: the summary of every stage, no long table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tmmcalc.report.document import Document
from tmmcalc.report.kinematics import kinematics_summary
from tmmcalc.report.structure import structure_document

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

_SUMMARIES: dict[str, Callable[[Any, str], Document]] = {
    "structure": structure_document,
    "kinematics": kinematics_summary,
}


def run_document(run: RunResult, title: str) -> Document:
    """The summaries of the stages that ran, in their order; a fact that stages share is said once."""
    parts: list[Document] = []
    said: set[str] = set()
    for stage in run.outcomes:
        part = _SUMMARIES[stage](run.results[stage], stage)
        facts = tuple(fact for fact in part.facts if fact.label not in said)
        said |= {fact.label for fact in facts}
        parts.append(replace(part, facts=facts))
    return Document(title, parts=tuple(parts))
