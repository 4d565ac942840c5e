"""The chapters of the note from the results of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tmmcalc.core.stage import STAGES, resolve
from tmmcalc.pipeline.picturing import NONE, order_of
from tmmcalc.report.language import tr_name
from tmmcalc.report.manuscript import Block, Chapter


def chapters_of(
    titles: Mapping[str, str], spec: Any, results: Mapping[str, Any], flags: Mapping[str, str | None] = NONE
) -> list[Chapter]:
    """The chapters with these names and titles that the results have something for, in the language in force."""
    order = order_of(spec, results, flags)
    found = []
    for name, title in titles.items():
        blocks: list[Block] = []
        for stage in stages_of([name]):
            if stage in results:
                blocks += resolve(f"{STAGES[stage].note}:blocks")(order)
        if blocks:
            found.append(Chapter(name, tr_name(title), tuple(blocks)))
    return found


def stages_of(chapters: Sequence[str]) -> list[str]:
    """The stages that these chapters tell of, in the order of the pipeline."""
    return [name for name, stage in STAGES.items() if stage.chapter in chapters]
