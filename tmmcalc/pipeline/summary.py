"""The document of a whole run: the summary of every stage, no long table."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.report.document import Document
from tmmcalc.report.errors import with_errors

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult


def run_document(run: RunResult, title: str) -> Document:
    """The summaries of the stages that ran, in their order; a fact that stages share is said once."""
    parts: list[Document] = []
    said: set[str] = set()
    for stage, outcome in run.outcomes.items():
        part = outcome.stage.summary(run.results[stage], stage)
        facts = tuple(fact for fact in part.facts if fact.label not in said)
        said |= {fact.label for fact in facts}
        parts.append(with_errors(replace(part, facts=facts), run.record(stage).error))
    return Document(title, parts=tuple(parts))
