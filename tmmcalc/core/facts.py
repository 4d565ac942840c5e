"""What stages tell of their results by name: the numbers of their summaries."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from tmmcalc.core.stage import STAGES

Quantity = tuple[float, str]  # value and unit


def facts(stage: str, result: Any) -> Iterator[tuple[str, Quantity]]:
    """All numbers of a stage's summary by name, without their unit."""
    yield from ((name, found) for name, found, _ in labelled(stage, result))


def labelled(stage: str, result: Any) -> Iterator[tuple[str, Quantity, str]]:
    """The same, each with the label under which the summary tells it."""
    document = STAGES[stage].summary(result, stage)
    for part in (document, *document.parts):
        for fact in part.facts:
            yield from ((name, found, fact.label) for name, found in _numbers(fact.values))


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
