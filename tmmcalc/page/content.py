"""All that a page holds, as plain values for JSON: what is said by itself, and of every variant what it found."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.stage import STAGES, arguments, of_scene
from tmmcalc.page.motion import views_packed
from tmmcalc.page.packing import ERROR, Block, Content
from tmmcalc.page.results import failure_told, given_told, stages_told
from tmmcalc.page.said import Said, words
from tmmcalc.page.trials import trials_packed
from tmmcalc.report.formula.symbols import GREEK
from tmmcalc.report.language import LANGUAGES

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

PLANNED = 3  # variants at most, that have plans of vectors: a page of more would be too large


class Variant(NamedTuple):
    """A run, what tells it from the others on the page, and the text of its spec."""

    name: Said
    run: RunResult
    source: str


def content(variants: Sequence[Variant], title: str, key: str, language: str, positions: int) -> Content:
    """All that a page holds; ``key`` is what the variants differ in. Of many plans of vectors are left out."""
    block = Block()
    scenes = [_scene(each, block, positions, planned=len(variants) <= PLANNED) for each in variants]
    found = {
        "title": title,
        "key": key,
        "languages": dict(LANGUAGES),
        "language": language,
        "words": words(),
        "letters": GREEK,
        "error": ERROR,
        "scenes": scenes,
    }
    return {**found, "block": block.text()}


def _scene(variant: Variant, block: Block, positions: int, *, planned: bool) -> Content:
    run, given = variant.run, {*_strings(tomllib.loads(variant.source))}
    dense = _dense(run, positions)
    views = [*views_packed(run, dense, block, planned=planned)]
    inputs = {(view["room"], view["column"]) for view in views if view["column"]}
    return {
        "name": variant.name,
        "stages": [
            *(each for stage in run.outcomes for each in stages_told(stage, run, given, dense, inputs, block)),
            *(failure_told(stage, error) for stage, error in run.failures.items()),
        ],
        "given": given_told(run),
        "source": variant.source,
        "views": views,
        "trials": [*trials_packed(run, block)],
    }


def _strings(value: Any) -> Iterator[str]:
    """The texts that stand in a spec, at whatever depth."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict | list):
        for each in value.values() if isinstance(value, dict) else value:
            yield from _strings(each)


def _dense(run: RunResult, positions: int) -> Content:
    """Results over many equal steps, of the stages whose rows are places that can be asked for."""
    results: dict[str, Any] = dict(run.results)
    found: dict[str, Any] = {}
    for name, own in of_scene({name: STAGES[name] for name in run.outcomes}, run.spec).items():
        make = own.part("dense")
        if make is None or own.unwanted(run.spec) is not None:
            continue
        try:
            spec = make(run.spec, positions)
        except UsageError:
            continue  # there is no mechanism: a diagram stands in its place
        results[name] = found[name] = own.solved(*arguments(own.inputs(spec)), **own.given(results), **own.settings)
    return found
