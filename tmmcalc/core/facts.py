"""What stages tell of their results by name: the numbers of their summaries."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tmmcalc.core.stage import STAGES

SEPARATORS = frozenset(".@[]()*?,;")  # a part with one of these in its name goes by its number
Quantity = tuple[float, str]  # value and unit


def facts(stage: str, result: Any) -> Iterator[tuple[str, Quantity]]:
    """All numbers of a stage's summary by name, without their unit."""
    yield from ((name, found) for name, found, _ in labelled(stage, result))


def labelled(stage: str, result: Any) -> Iterator[tuple[str, Quantity, str]]:
    """The same, each with the label under which the summary tells it.

    Where parts of a summary tell the same, as several motions do, a name begins with that of its part:
    ``start-up.end_time``.
    """
    document = STAGES[stage].summary(result, stage)
    for name, part in (("", document), *zip(beginnings(document.parts), document.parts, strict=True)):
        for fact in part.facts:
            yield from ((told, found, fact.label) for told, found in _numbers(fact.values, name))


def beginnings(parts: Sequence[Any]) -> list[str]:
    """What names of the facts of every part begin with: nothing, where no two parts tell the same."""
    keys = [key for part in parts for key in {key for fact in part.facts for key in fact.values}]
    if len(set(keys)) == len(keys):
        return [""] * len(parts)
    names = [part.name or part.title for part in parts]
    alike = {name for name in names if names.count(name) > 1}
    unfit = (name in alike or not SEPARATORS.isdisjoint(name) for name in names)
    return [f"{number if no else name}." for number, (name, no) in enumerate(zip(names, unfit, strict=True), 1)]


def _numbers(values: Mapping[str, Any], path: str = "") -> Iterator[tuple[str, Quantity]]:
    for key, value in values.items():
        name, unit = named(key)
        if isinstance(value, Mapping):
            yield from _numbers(value, f"{path}{key}.")
        elif isinstance(value, int | float):
            yield f"{path}{name}", (float(value), unit)


def named(header: str) -> tuple[str, str]:
    """Name and unit of a header.

    >>> named("vS_D[m/s]"), named("efficiency")
    (('vS_D', 'm/s'), ('efficiency', ''))
    """
    name, _, unit = header.partition("[")
    return name, unit.removesuffix("]")
