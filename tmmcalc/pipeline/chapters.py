"""What the note takes from a run: chapters, warnings, estimates of errors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tmmcalc.core.stage import STAGES, resolve
from tmmcalc.pipeline.picturing import NONE, order_of
from tmmcalc.report.language import tr_name
from tmmcalc.report.manuscript import Block, Chapter, Heading

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.report.document import Document


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
            found.append(_titled(Chapter(name, tr_name(title), tuple(blocks))))
    return found


def task_of(spec: Any, results: Mapping[str, Any], flags: Mapping[str, str | None] = NONE) -> list[Block]:
    """What is given, by all rooms, in the language in force."""
    from tmmcalc.rooms import ROOMS

    order = order_of(spec, results, flags)
    return [block for room in ROOMS if room.task for block in resolve(room.task)(order)]


def given_in(spec: Any, results: Mapping[str, Any]) -> list[Block]:
    """The task, and what is given that stands in the chapters, in the language in force."""
    order = order_of(spec, results, NONE)
    told = (resolve(f"{STAGES[name].note}:data")(order) for name in results if STAGES[name].tells_data)
    return [*task_of(spec, results), *(block for blocks in told for block in blocks)]


def sought_in(results: Mapping[str, Any], stages: Sequence[str]) -> list[str]:
    """What is to be found: what the stages that the note tells of are for, in the language in force."""
    return [tr_name(STAGES[name].title) for name in _as_told(stages) if name in results]


def _as_told(stages: Sequence[str]) -> list[str]:
    """Stages in the order of their chapters."""
    from tmmcalc.rooms import CHAPTERS

    order = [*CHAPTERS]
    return sorted(stages, key=lambda name: order.index(STAGES[name].chapter))


def _titled(chapter: Chapter) -> Chapter:
    """A chapter of one part alone has the title of that part, and its parts stand one level higher."""
    first, *rest = chapter.blocks
    parts = [block for block in chapter.blocks if isinstance(block, Heading) and block.level == 2]
    if parts != [first]:
        return chapter
    raised = (block._replace(level=2) if isinstance(block, Heading) else block for block in rest)
    return Chapter(chapter.name, parts[0].text, tuple(raised))


def stages_of(chapters: Sequence[str]) -> list[str]:
    """The stages that these chapters tell of, in the order of the pipeline."""
    return [name for name, stage in STAGES.items() if stage.chapter in chapters]


def warnings_of(run: RunResult, stages: Sequence[str]) -> list[str]:
    """What the program warns of in these stages, each once."""
    documents = [run.outcomes[name].stage.summary(run.results[name], "") for name in stages if name in run.outcomes]
    return list(dict.fromkeys(warning for document in documents for warning in _warnings(document)))


def _warnings(document: Document) -> Iterator[str]:
    yield from (note for note in document.notes if note.startswith("warning"))
    for part in document.parts:
        yield from _warnings(part)


def errors_of(run: RunResult, stages: Sequence[str]) -> dict[str, dict[str, float]]:
    """The relative errors that these stages estimate, by their titles."""
    found = {}
    for name in _as_told(stages):
        if name in run.outcomes:
            told = run.outcomes[name].record.error
            if numbers := {key: float(each) for key, each in told.items() if isinstance(each, float) and each}:
                found[STAGES[name].title] = numbers
    return found
