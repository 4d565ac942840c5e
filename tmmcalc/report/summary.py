"""The document of a whole run: the facts of every stage, no long table."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tmmcalc.report.document import Document
from tmmcalc.report.linkage import kinematics_document, structure_document

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

_DOCUMENTS: dict[str, Callable[[Any, str], Document]] = {
    "structure": structure_document,
    "kinematics": kinematics_document,
}


def run_document(run: RunResult, title: str) -> Document:
    """Facts and notes of the stages that ran, in their order; a fact that stages share is said once."""
    parts = [_DOCUMENTS[stage](run.results[stage], stage) for stage in run.outcomes]
    facts = {fact.label: fact for part in parts for fact in part.facts}
    return Document(title, tuple(facts.values()), tuple(note for part in parts for note in part.notes))
